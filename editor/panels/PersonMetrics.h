#pragma once

#include <map>
#include <memory>
#include <vector>

#include <QObject>

#include "editor/document/LatestTask.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// The metrics of single people at the shown step of the run: those of the feed that depend on
/// people, computed as if the person were the only one. Computed outside the GUI thread.
class PersonMetrics : public QObject {
  Q_OBJECT
 public:
  PersonMetrics(const MetricsFeed& feed, SimulationRunner& runner);
  ~PersonMetrics() override;
  Q_DISABLE_COPY_MOVE(PersonMetrics)

  /// The people by their ids in the run; empty: nothing is computed.
  void setPeople(std::vector<int> ids);
  /// Null: not computed (yet), or the metric does not depend on people.
  const metrics::MetricResult* find(int person, const std::string& key) const;
  /// The values belong to the shown step.
  bool isCurrent() const;

 Q_SIGNALS:
  void updated();

 private:
  struct Work;
  struct Values {
    std::size_t index = 0;  // Of the state in the recording.
    std::map<int, std::vector<metrics::MetricResult>> results;
  };
  void restart();
  void follow();
  std::shared_ptr<Work> makeWork() const;
  std::optional<std::size_t> shownIndex() const;

  const MetricsFeed& feed_;
  SimulationRunner& runner_;
  std::vector<int> people_;
  RecordingPtr recording_;
  std::shared_ptr<Work> work_;  // Used by the task only.
  std::optional<Values> values_;
  std::shared_ptr<base::StopFlag> stop_ = std::make_shared<base::StopFlag>();
  LatestTask<Values> task_;
};

}  // namespace editor
