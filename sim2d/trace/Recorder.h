#pragma once

#include <string>
#include <vector>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// One step of a run as it is recorded.
struct RecordedStep {
  std::int64_t step = 0;
  const Frame* frame = nullptr;  // null: this step is not recorded
  std::vector<Event> events;     // in the order of the file
  std::string treeRows;          // of trees.csv
};

/// Takes the steps of a run one by one, so that nobody keeps them.
class RecordSink {
 public:
  RecordSink() = default;
  RecordSink(const RecordSink&) = delete;
  RecordSink& operator=(const RecordSink&) = delete;
  RecordSink(RecordSink&&) = delete;
  RecordSink& operator=(RecordSink&&) = delete;
  virtual ~RecordSink() = default;
  virtual void take(const RecordedStep& step) = 0;
};

/// Collects frames: every `recordEvery`-th state, all events, all tree changes. Events and tree
/// changes leave the frames: the ones are kept in Trace::events, the others in the text of
/// trees.csv. With a sink all goes there and nothing is kept. Steps must arrive in rising order,
/// each once. One thread at a time.
class Recorder {
 public:
  explicit Recorder(int recordEvery = 1, RecordSink* sink = nullptr);  // steps, >= 1
  void append(const Frame& frame);
  /// Header as of the end of the run (people from sources included). The frames are gone after;
  /// the next append starts a new record.
  Trace finish(TraceHeader header);
  const std::string& treesCsv() const { return treesCsv_; }  // kept until the next record starts

 private:
  void keep(RecordedStep step);

  int recordEvery_;
  RecordSink* sink_;
  Trace trace_;
  std::string treesCsv_;
  bool finished_ = false;
};

}  // namespace sim2d
