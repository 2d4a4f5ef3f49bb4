#pragma once

#include <cstdint>

#include "bt/human/HumanContext.h"

/// Pieces that the nodes share.
namespace bt {

using base::NodeStatus;

/// A stateful action ends with SUCCESS after `duration` [s]; 0 and less mean never.
inline NodeStatus byDuration(const LeafContext& leaf, std::int64_t startStep, double duration) {
  return duration > 0.0 && leaf.hasElapsed(startStep, duration) ? NodeStatus::Success
                                                                : NodeStatus::Running;
}

/// A stateful condition that did not hold in this step: it waits for `duration` [s], then fails.
inline NodeStatus untilDuration(const LeafContext& leaf, std::int64_t startStep, double duration) {
  return leaf.hasElapsed(startStep, duration) ? NodeStatus::Failure : NodeStatus::Running;
}

}  // namespace bt
