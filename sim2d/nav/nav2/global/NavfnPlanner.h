#pragma once

#include <optional>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/NavfnWave.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

namespace sim2d::nav2 {

/// nav2_navfn_planner::NavfnPlanner. Its cells are rounded, not floored: paths lie half a cell to
/// the lower left of what other planners give, as in Nav2. Headings within the path are 0.
class NavfnPlanner : public GlobalPlanner {
 public:
  NavfnPlanner(const NavfnParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  PlanResult pathTo(const PlanRequest& request, const Pose2& end);
  std::optional<Pose2> nearestReached(const Costmap& costmap, const Pose2& goal) const;
  float potentialAt(const Costmap& costmap, const Vec2& place) const;
  void approach(Path& path, const Pose2& goal) const;

  NavfnParameters parameters_;
  Distro distro_;
  NavfnWave wave_;
};

}  // namespace sim2d::nav2
