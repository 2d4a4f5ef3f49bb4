#pragma once

#include <QLabel>
#include <QSplitter>
#include <QStackedLayout>
#include <QTableView>

#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"

namespace editor {

class MetricPlot;
class MetricsModel;
class SparklineDelegate;

/// The live table of metrics with the course of each since the start, and a plot of the one that is
/// selected.
class MetricsDock : public QWidget {
  Q_OBJECT
 public:
  MetricsDock(MetricsFeed& feed, SimulationRunner& runner, const Theme& theme,
              QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  QTableView& table() const { return *table_; }
  /// The text shown for a metric; empty when it is not in the table.
  QString shownValue(const QString& key) const;
  void selectMetric(const QString& key);

 private:
  void takeSnapshot();
  void showSelected();
  void fitRows();
  std::string selectedKey() const;

  MetricsFeed& feed_;
  SimulationRunner& runner_;
  MetricsModel* model_;
  SparklineDelegate* sparkline_;
  QStackedLayout* stack_;
  QTableView* table_;
  MetricPlot* plot_;
  int fittedRows_ = 0;
  std::string chosen_;       // key of the metric that the user wants to see
  bool isChoosing_ = false;  // this, not the user
};

}  // namespace editor
