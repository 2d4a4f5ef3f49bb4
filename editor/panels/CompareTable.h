#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QStackedLayout>
#include <QTableWidget>

#include "app/run/Comparison.h"
#include "editor/document/LatestTask.h"
#include "editor/panels/ComparePlot.h"
#include "editor/panels/PanelRegistry.h"

namespace editor {

/// Metrics of several runs side by side, with what the others differ by from the first, and the one
/// that is selected over time. Measured beside the window.
class CompareTable : public QWidget {
  Q_OBJECT
 public:
  struct Run {
    RecordingPtr recording;
    QString letter;
    int style = -1;  // -1: the run that is shown, which is the first
  };
  explicit CompareTable(PanelContext& context);
  ~CompareTable() override;
  Q_DISABLE_COPY_MOVE(CompareTable)

  void compare(std::vector<Run> runs);
  bool isBusy() const { return task_.isBusy(); }
  QTableWidget& table() const { return *table_; }
  ComparePlot& plot() const { return *plot_; }
  /// When each of the others leaves the first, in words; empty: nothing is compared.
  QString partings() const { return partings_; }

 Q_SIGNALS:
  void measuredAll();

 private:
  struct Measured {
    std::vector<Run> runs;
    std::vector<std::size_t> sizes;  // of the recordings
    std::vector<app::RunMeasures> measures;
    std::vector<std::optional<double>> partings;  // [s], of the others
  };
  base::Result<app::MetricsSetup> setup() const;
  void deliver(Measured measured);
  bool isOfAnother(const Run& run) const;
  void fill();
  void showSelected();

  PanelContext& context_;
  QStackedLayout* stack_;
  QTableWidget* table_;
  ComparePlot* plot_;
  QString partings_;
  Measured shown_;
  std::vector<app::ComparedMetric> rows_;
  std::string chosen_;  // key of the metric
  std::shared_ptr<base::StopFlag> stop_ = std::make_shared<base::StopFlag>();
  LatestTask<Measured> task_;
};

}  // namespace editor
