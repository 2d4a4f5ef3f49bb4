#pragma once

#include <map>
#include <memory>
#include <string>
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
};

/// Metrics of the run while it goes on, computed beside the GUI thread from every recorded frame.
class MetricsFeed : public QObject {
  Q_OBJECT
 public:
  MetricsFeed(const ScenarioDocument& document, SimulationRunner& runner);
  ~MetricsFeed() override;
  Q_DISABLE_COPY_MOVE(MetricsFeed)

  const MetricSnapshot& snapshot() const { return snapshot_; }
  /// Which metrics, instead of those of the scenario's settings; counts from the next frame on.
  void setSelection(std::optional<metrics::Selection> selection);
  metrics::Selection selection() const;
  /// All frames of the run so far are in the snapshot.
  bool isCurrent() const;

 Q_SIGNALS:
  void updated();
  void cleared();
  void failed(const base::Diagnostics& problems);

 private:
  struct Work;
  void follow();
  void begin();
  void pump();
  base::Result<app::MetricsSetup> setup() const;
  void deliver(MetricSnapshot snapshot);

  const ScenarioDocument& document_;
  SimulationRunner& runner_;
  std::optional<metrics::Selection> selection_;
  std::shared_ptr<Work> work_;
  RecordingPtr recording_;
  MetricSnapshot snapshot_;
  LatestTask<MetricSnapshot> task_;
};

/// "0.64", "–" when undefined, "∞"; as many decimals as the unit deserves.
QString metricText(const metrics::MetricResult& result);

}  // namespace editor
