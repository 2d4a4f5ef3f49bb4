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
#include "editor/document/LatestTask.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/run/SimulationRunner.h"
#include "metrics/RunningEvaluation.h"

namespace editor {

/// A metric over the run: its own value per sample where it has one, else its value so far.
struct MetricCurve {
  std::vector<double> times;  // [s]
  std::vector<double> values;
};

/// What is known at one moment of the run.
struct MetricSnapshot {
  std::size_t frames = 0;
  std::vector<metrics::MetricResult> results;
  std::map<std::string, MetricCurve> curves;
  bool isCut = false;  // states were dropped before they were measured: no values
};

/// Metrics of the run while it goes on, computed beside the GUI thread from every recorded frame.
class MetricsFeed : public QObject {
  Q_OBJECT
 public:
  MetricsFeed(const ScenarioDocument& document, SimulationRunner& runner);
  ~MetricsFeed() override;
  Q_DISABLE_COPY_MOVE(MetricsFeed)

  const MetricSnapshot& snapshot() const { return snapshot_; }
  /// Values up to the state that is shown, which is not the newest one when looking back; without
  /// values until they are worked out.
  const std::vector<metrics::MetricResult>& shown() const;
  /// Which metrics, instead of those of the scenario's settings; counts from the next frame on.
  void setSelection(std::optional<metrics::Selection> selection);
  metrics::Selection selection() const;
  /// Of which robot: its id, of the run's robots; the first one is -1.
  void setRobot(int id);
  int robot() const;
  std::vector<std::pair<int, std::string>> robots() const;  // ids and names; none without a run
  /// All frames of the run so far are in the snapshot, and shown() is of what is shown.
  bool isCurrent() const;

 Q_SIGNALS:
  void updated();
  void cleared();
  void failed(const base::Diagnostics& problems);

 private:
  struct Work;
  struct Past {
    std::size_t index = 0;  // of the state
    std::vector<metrics::MetricResult> results;
  };
  void follow();
  void begin();
  void pump();
  base::Result<app::MetricsSetup> setup() const;
  void deliver(MetricSnapshot snapshot);
  std::optional<std::size_t> pastIndex() const;
  void lookBack();
  void stopPast();
  void dropOtherPast(std::size_t index);
  void deliverPast(Past past);

  const ScenarioDocument& document_;
  SimulationRunner& runner_;
  std::optional<metrics::Selection> selection_;
  int robot_ = -1;                                   // that was chosen; the run may not have it
  std::function<std::shared_ptr<Work>()> makeWork_;  // of this run, in any thread
  std::shared_ptr<Work> work_;
  RecordingPtr recording_;
  MetricSnapshot snapshot_;
  LatestTask<MetricSnapshot> task_;
  std::shared_ptr<Work> pastWork_;
  std::optional<Past> past_;
  std::size_t pastWanted_ = 0;                                                     // index
  std::shared_ptr<base::StopFlag> pastStop_ = std::make_shared<base::StopFlag>();  // what is begun
  LatestTask<Past> pastTask_;
};

/// "0.64", "–" when undefined, "∞"; as many decimals as the unit deserves.
QString metricText(const metrics::MetricResult& result);

}  // namespace editor
