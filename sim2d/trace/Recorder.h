#pragma once

#include <string>
#include <vector>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// Collects frames: every `recordEvery`-th state, all events, all tree changes. Events and tree
/// changes leave the frames: the ones are kept in Trace::events, the others in the text of
/// trees.csv. Steps must arrive in rising order, each once. One thread at a time.
class Recorder {
 public:
  explicit Recorder(int recordEvery = 1);  // steps, >= 1
  void append(const Frame& frame);
  /// Header as of the end of the run (people from sources included). The frames are gone after;
  /// the next append starts a new record.
  Trace finish(TraceHeader header);
  const std::string& treesCsv() const { return treesCsv_; }  // kept until the next record starts

 private:
  int recordEvery_;
  Trace trace_;
  std::string treesCsv_;
  bool finished_ = false;
};

}  // namespace sim2d
