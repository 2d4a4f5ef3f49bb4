#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QObject>

#include "app/run/MetricsSetup.h"
#include "app/run/RunComparison.h"
#include "editor/document/LatestTask.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// The metrics at one time of the run.
struct MetricSnapshot {
  std::size_t frames = 0;
  std::vector<metrics::MetricResult> results;
  /// Metrics over the run, by key: the value per sample if there is one, else the cumulative value.
  std::map<std::string, app::MetricTimeSeries> curves;
  bool isCut = false;  // States were dropped before being measured, so there are no values.
};

/// Computes the metrics of the current run from every recorded frame outside the GUI thread.
class MetricsFeed : public QObject {
  Q_OBJECT
 public:
  MetricsFeed(const ScenarioDocument& document, SimulationRunner& runner);
  ~MetricsFeed() override;
  Q_DISABLE_COPY_MOVE(MetricsFeed)

  const MetricSnapshot& snapshot() const { return snapshot_; }
  /// Values up to the shown state, which is not the newest one when looking back; empty values
  /// until they are computed.
  const std::vector<metrics::MetricResult>& shown() const;
  /// Overrides the metrics of the scenario settings, from the next frame on.
  void setSelection(std::optional<metrics::Selection> selection);
  metrics::Selection selection() const;
  /// The metrics and parameters of the scenario, or of the recorded run.
  base::Result<app::MetricsSetup> setup() const;
  /// Selects the robot by its id in the run; the first one is -1.
  void setRobot(int id);
  int robot() const;
  std::vector<std::pair<int, std::string>> robots() const;  // Ids and names; empty without a run.
  /// The snapshot includes all frames of the run so far, and shown() belongs to the shown state.
  bool isCurrent() const;

 Q_SIGNALS:
  void updated();
  void cleared();
  void failed(const base::Diagnostics& problems);

 private:
  struct Work;
  struct Past {
    std::size_t index = 0;  // Index of the state.
    std::vector<metrics::MetricResult> results;
  };
  void follow();
  void begin();
  void restart();
  void startNextBatch();
  void deliver(MetricSnapshot snapshot);
  std::optional<std::size_t> pastIndex() const;
  void lookBack();
  void stopPast();
  void dropOtherPast(std::size_t index);
  void deliverPast(Past past);

  const ScenarioDocument& document_;
  SimulationRunner& runner_;
  std::optional<metrics::Selection> selection_;
  int robot_ = -1;  // The chosen robot; the run may not have it.
  using CurveGap = std::function<double(double time)>;
  std::function<std::shared_ptr<Work>(const CurveGap&)> makeWork_;  // Of this run, in any thread.
  std::shared_ptr<Work> work_;
  RecordingPtr recording_;
  MetricSnapshot snapshot_;
  LatestTask<MetricSnapshot> task_;
  std::shared_ptr<Work> pastWork_;
  std::optional<Past> past_;
  std::size_t pastWanted_ = 0;                                                     // Index.
  std::shared_ptr<base::StopFlag> pastStop_ = std::make_shared<base::StopFlag>();  // Of the task.
  LatestTask<Past> pastTask_;
};

/// "0.64", "–" if undefined, "∞"; the number of decimals depends on the unit.
QString metricText(const metrics::MetricResult& result);

}  // namespace editor
