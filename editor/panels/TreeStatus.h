#pragma once

#include <vector>

#include "editor/run/SimulationRunner.h"

namespace editor {

/// What each node of a person's tree returned last, at the moment of a run that is shown.
class TreeStatus {
 public:
  explicit TreeStatus(const SimulationRunner& runner) : runner_(runner) {}

  /// By node of the program, in the order of the tree; empty when nothing is known of the person.
  const std::vector<base::NodeStatus>& at(int person, const FramePtr& frame);

 private:
  const SimulationRunner& runner_;
  int person_ = 0;
  FramePtr first_;  // tells one run from the next
  std::size_t read_ = 0;
  std::vector<base::NodeStatus> statuses_;
};

}  // namespace editor
