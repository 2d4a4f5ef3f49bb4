#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSplitter>
#include <QStackedLayout>
#include <QTableWidget>
#include <QToolButton>

#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotMarker;

namespace editor {

class MetricsChoice;
class SparklineDelegate;

/// One metric over time, with a line at the moment that is shown.
class MetricPlot : public QWidget {
  Q_OBJECT
 public:
  explicit MetricPlot(const Theme& theme);
  void setTheme(const Theme& theme);
  void show(const metrics::MetricResult* result, const MetricCurve* curve);
  void setCursor(double time);  // [s]

 private:
  void layOut();
  void reserveEnd();
  QLabel* title_;
  QLabel* unit_;
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // these belong to the plot
  QwtPlotCurve* curve_;
  QwtPlotMarker* cursor_;
};

/// The live table of metrics with the course of each since the start, and a plot of the one that is
/// selected.
class MetricsDock : public QWidget {
  Q_OBJECT
 public:
  MetricsDock(MetricsFeed& feed, SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  QTableView& table() const { return *table_; }
  QComboBox& robot() const { return *robot_; }  // hidden unless the run has several
  /// What is measured, beside the table when it is asked for.
  void setChoice(MetricsChoice& choice);
  QToolButton& choose() const { return *choose_; }  // shows and hides it

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeTable();
  QWidget* makeTop();
  QWidget* makeChooser();
  void giveRoom();
  void fillChooser();
  void takeSnapshot();
  void fillRows();
  void showSelected();
  void fitRows();
  int rowOf(const std::string& key) const;  // -1 = none
  int firstWithCurve() const;
  std::string selectedKey() const;

  MetricsFeed& feed_;
  QColor pale_;
  SparklineDelegate* sparkline_;
  QSplitter* parts_;  // the choice, what is measured
  QWidget* choice_ = nullptr;
  QToolButton* choose_;
  QStackedLayout* stack_;
  QTableWidget* table_;
  QComboBox* robot_;
  QWidget* chooser_;  // with its label
  MetricPlot* plot_;
  int fittedRows_ = 0;
  std::string chosen_;       // key of the metric that the user wants to see
  bool isChoosing_ = false;  // this, not the user
};

}  // namespace editor
