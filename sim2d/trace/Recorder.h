#pragma once

#include <string>
#include <vector>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// Collects frames: every `recordEvery`-th state, all events, all tree changes.
class Recorder {
 public:
  explicit Recorder(int recordEvery = 1) : recordEvery_(recordEvery) {}
  void append(const Frame& frame);
  /// Header as of the end of the run (people from sources included). The recorder is empty after.
  Trace finish(TraceHeader header);
  const std::string& treesCsv() const { return treesCsv_; }

 private:
  int recordEvery_;
  Trace trace_;
  std::string treesCsv_;
};

}  // namespace sim2d
