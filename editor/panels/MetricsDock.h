#pragma once

#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/MetricsTable.h"
#include "editor/panels/PersonMetrics.h"
#include "editor/panels/runs/RunPlots.h"

namespace editor {

/// The metrics of the run: one table with a search, and a plot of the current metric. The selected
/// people have columns of their own.
class MetricsDock : public QWidget {
  Q_OBJECT
 public:
  /// Maximum number of selected people with a column.
  static constexpr std::size_t kMostPeople = 4;

  MetricsDock(ScenarioDocument& document, MetricsFeed& feed, SimulationRunner& runner,
              const Theme& theme);
  void setTheme(const Theme& theme);
  MetricsTable& table() const { return *table_; }
  MetricPlot& plot() const { return *plot_; }
  PersonMetrics& people() { return people_; }
  QComboBox& robot() const { return *robot_; }  // Hidden unless the run has several robots.
  /// The key of the plotted metric; empty: none.
  std::string shownKey() const { return shown_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeChooser();
  void adaptToWidth();
  void fillChooser();
  void showSnapshot();
  void showSelectedPeople();
  void followFilter();
  void showPlot();
  QString reasonWithoutValue(const metrics::MetricResult& result) const;
  std::string keyToShow() const;
  std::string firstWithCurve() const;

  ScenarioDocument& document_;
  MetricsFeed& feed_;
  SimulationRunner& runner_;
  PersonMetrics people_;
  MetricsTable* table_;
  QComboBox* robot_ = new QComboBox(this);
  QStackedWidget* beside_ = new QStackedWidget(this);  // The plot, or why there is none.
  QLabel* noValue_ = emptyState({}, this);             // Why the current metric has no value.
  MetricPlot* plot_;
  bool hasChosen_ = false;
  std::string chosen_;  // Key of the metric chosen by the user; empty: the row of a group.
  std::string shown_;
};

}  // namespace editor
