#pragma once

#include "sim2d/nav/nav2/global/PathSmoother.h"

namespace sim2d::nav2 {

/// nav2_smoother::SimpleSmoother: sweeps (SmoothingSweeps.h) over each stretch that is driven in
/// one direction, if it is long enough. Out of time: Humble keeps what it has, later it is Timeout.
class SimpleSmoother : public PathSmoother {
 public:
  SimpleSmoother(const SimpleSmootherParameters& parameters, Distro distro);

  SmoothResult smooth(const Path& path, const Costmap& costmap, double maxDuration) const override;

 private:
  SimpleSmootherParameters parameters_;
  Distro distro_;
};

}  // namespace sim2d::nav2
