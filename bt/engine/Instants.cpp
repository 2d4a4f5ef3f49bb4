#include "bt/engine/Ticker.h"

/// Nodes that are done within the tick, whatever happens: functions of the library that are one
/// call, and what combines nothing but such nodes, all without conditions. They are never RUNNING
/// and never SKIPPED, so nothing about them is kept from tick to tick and nothing needs halting.
/// Most of what a tick does is this: a tree asks all its questions in every step.
namespace bt {

/// Sequences (`stop` = FAILURE) and fallbacks (SUCCESS), reactive or not.
template <base::NodeStatus stop>
base::NodeStatus Ticker::instants(Ticker& ticker, int node) {
  Status* const returned = ticker.returned_;
  const Program::Node* here = ticker.nodes_ + node + 1;
  const Program::Node* const end = ticker.nodes_ + ticker.nodes_[node].end;
  while (here < end) {
    Status status;
    if (here->tick) {
      ticker.leaf_.moveTo(*here);
      status = here->tick(ticker.leaf_);
      if (status == kPasses<stop> && !ticker.isFaulty_) {
        returned[here->index] = status;
        ++here;
        continue;
      }
      if (status != stop || ticker.isFaulty_) {
        return ticker.unexpected(here->index, status);
      }
    } else {
      status = here->run(ticker, here->index);
    }
    if (status == kFault) {
      return status;
    }
    returned[here->index] = status;
    if (status == stop) {
      return status;
    }
    here = ticker.nodes_ + here->end;
  }
  return kPasses<stop>;
}

base::NodeStatus Ticker::instantInverter(Ticker& ticker, int node) {
  const Status status = ticker.tickInstant(ticker.nodes_[node + 1], node + 1);
  return status == kFault ? kFault : status == Status::Success ? Status::Failure : Status::Success;
}

template <base::NodeStatus result>
base::NodeStatus Ticker::instantForce(Ticker& ticker, int node) {
  return ticker.tickInstant(ticker.nodes_[node + 1], node + 1) == kFault ? kFault : result;
}

}  // namespace bt
