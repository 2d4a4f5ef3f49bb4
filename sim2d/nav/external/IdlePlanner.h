#pragma once

#include "sim2d/nav/Planner.h"

namespace sim2d {

/// Stands still; replaces a planner that must not be started.
class IdlePlanner : public Planner {
 public:
  base::Result<BodyTwist> command(const Observation&) override { return BodyTwist{}; }
};

}  // namespace sim2d
