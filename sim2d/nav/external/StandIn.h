#pragma once

#include "sim2d/nav/Planner.h"

namespace sim2d {

/// Stands, in place of a planner that is not to be started.
class StandIn : public Planner {
 public:
  base::Result<BodyTwist> command(const Observation&) override { return BodyTwist{}; }
};

}  // namespace sim2d
