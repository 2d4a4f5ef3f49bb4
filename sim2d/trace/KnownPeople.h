#pragma once

#include <cstddef>
#include <set>

#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

/// Detects people whom a source spawns during a run: the header of the run has changed then.
class KnownPeople {
 public:
  explicit KnownPeople(const TraceHeader& header) {
    for (const TraceHuman& human : header.humans) {
      ids_.insert(human.id);
    }
  }

  /// Whether neither the header nor an earlier frame contained a person of this frame.
  bool addNew(const Frame& frame) {
    const std::size_t before = ids_.size();
    ids_.insert(frame.humans.id.begin(), frame.humans.id.end());
    return ids_.size() > before;
  }

 private:
  std::set<int> ids_;
};

}  // namespace sim2d
