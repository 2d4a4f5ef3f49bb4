#pragma once

#include <QtWidgets>

#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/runs/RunPlots.h"

namespace editor {

class MetricsChoice;
class SparklineDelegate;

/// The live table of metrics with a sparkline for each, and a plot of the selected metric.
class MetricsDock : public QWidget {
  Q_OBJECT
 public:
  MetricsDock(MetricsFeed& feed, SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  QTableView& table() const { return *table_; }
  QComboBox& robot() const { return *robot_; }  // Hidden unless the run has several robots.
  /// Sets the metric selection, shown beside the table on request.
  void setChoice(MetricsChoice& choice);
  QToolButton& choose() const { return *choose_; }  // Toggles its visibility.

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeTable();
  QWidget* makeTop();
  QWidget* makeChooser();
  void adaptToWidth();
  void fillChooser();
  void showSnapshot();
  void fillRows();
  void showSelected();
  void fitRows();
  int rowOf(const std::string& key) const;  // -1 = none.
  int firstWithCurve() const;
  std::string selectedKey() const;

  MetricsFeed& feed_;
  QColor pale_;
  SparklineDelegate* sparkline_;
  QSplitter* parts_;  // Metric selection and metrics.
  QWidget* choice_ = nullptr;
  QToolButton* choose_;
  QStackedLayout* stack_;
  QTableWidget* table_;
  QComboBox* robot_;
  QWidget* chooser_;  // Includes its label.
  MetricPlot* plot_;
  int fittedRows_ = 0;
  std::string chosen_;        // Key of the metric chosen by the user.
  bool isSelecting_ = false;  // A selection by the program, not by the user.
};

}  // namespace editor
