#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtWidgets>

#include "app/run/RunComparison.h"
#include "editor/document/LatestTask.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/runs/RunPlots.h"

namespace editor {

/// Metrics of several runs side by side with the differences from the first run, and the selected
/// metric over time. Measured outside the GUI thread.
class CompareTable : public QWidget {
  Q_OBJECT
 public:
  struct Run {
    RecordingPtr recording;
    QString letter;
    int style = -1;  // -1: the shown run, which is the first.
  };
  explicit CompareTable(PanelContext& context);
  ~CompareTable() override;
  Q_DISABLE_COPY_MOVE(CompareTable)

  void compare(std::vector<Run> runs);
  bool isBusy() const { return task_.isBusy(); }
  QTableWidget& table() const { return *table_; }
  MetricPlot& plot() const { return *plot_; }
  /// The times at which the other runs diverge from the first, as text; empty: no comparison.
  QString divergences() const { return divergences_; }

 Q_SIGNALS:
  void measuredAll();

 private:
  struct Measured {
    std::vector<Run> runs;
    std::vector<std::size_t> sizes;  // Sizes of the recordings.
    std::vector<app::RecordingMetrics> measures;
    std::vector<std::optional<double>> divergences;  // Divergence times of the other runs [s].
  };
  base::Result<app::MetricsSetup> setup() const;
  void deliver(Measured measured);
  bool hasOtherScenario(const Run& run) const;
  void fill();
  void showSelected();

  PanelContext& context_;
  QStackedLayout* stack_;
  QTableWidget* table_;
  MetricPlot* plot_;
  QString divergences_;
  Measured shown_;
  std::vector<app::ComparedMetric> rows_;
  std::string chosen_;  // Key of the metric.
  std::shared_ptr<base::StopFlag> stop_ = std::make_shared<base::StopFlag>();
  LatestTask<Measured> task_;
};

}  // namespace editor
