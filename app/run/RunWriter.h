#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "metrics/RunningEvaluation.h"
#include "sim2d/base/GrowingFile.h"
#include "sim2d/trace/Recorder.h"
#include "sim2d/world/World.h"

namespace app {

/// Takes a run while it goes on: trajectory, events and tree changes go into the files of its
/// folder, the metrics are fed. Of past steps nothing stays in memory but their times.
class RunWriter : public sim2d::RecordSink {
 public:
  /// An empty folder: no files. The world must outlive the writer.
  RunWriter(const std::string& folder, const sim2d::World& world,
            const metrics::Selection& selection, const metrics::MetricParameters& parameters);
  void take(const sim2d::RecordedStep& step) override;
  /// From now on the record is kept as well, to be compared with another.
  void keepTrace() { keepsTrace_ = true; }
  const sim2d::Trace& trace() const { return trace_; }  // without header

  /// Once, at the end. Its results have no series: those are for writeSteps().
  base::Result<metrics::Evaluation> evaluation();
  /// steps.csv of the evaluation.
  base::Diagnostics writeSteps(const std::string& path, const std::vector<double>& times);
  /// A file could not be written: there is no use in going on.
  bool hasFailed() const;
  /// All rows are on the disk, in files that are not in their places yet.
  base::Diagnostics complete();
  /// Puts the files in their places; nothing of them is there before.
  base::Diagnostics finish();

 private:
  struct Files {
    explicit Files(const std::string& folder);
    base::GrowingFile trajectory, events, trees;
  };
  void meet(const sim2d::Frame& frame);
  void write(const sim2d::RecordedStep& step);
  struct Column {
    std::string key;
    metrics::Kind kind = metrics::Kind::Number;
    metrics::StoredNumbers values;
  };

  const sim2d::World& world_;
  double dt_;
  std::unique_ptr<Files> files_;
  metrics::FrameEvaluation evaluation_;
  std::set<int> known_;  // people that the metrics have been told of
  metrics::NumberStore store_;
  std::vector<Column> columns_;  // in the store
  bool keepsTrace_ = false;
  sim2d::Trace trace_;
};

}  // namespace app
