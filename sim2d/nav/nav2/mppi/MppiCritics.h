#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/mppi/MppiSequence.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"
#include "sim2d/nav/nav2/mppi/TrajectoryColumns.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

/// The critics of Nav2's MPPI (nav2_mppi_controller, critics/*.cpp): which are asked when, and what
/// the kernel is told.
namespace sim2d::nav2 {

/// All that a cycle looks at. World frame.
struct MppiScene {
  const Pose2& robot;
  const BodyTwist& speed;  // measured
  const Path& path;        // the local one, never empty
  const Pose2& goal;
  const Costmap& costmap;
  const ControlledShape& shape;
  double xyGoalTolerance = 0.25;  // [m]
};

/// Whether a pose is on a cell of 253 or 254 or off the map (255 when that is no free space).
bool isPathPointValid(const Costmap& costmap, const Vec2& place, bool tracksUnknown);
/// Cost where the centre of a robot that just touches an obstacle may be, below which no edge
/// touches anything; -1 without inflation.
double circumscribedCost(const ControlledShape& shape);
/// |angle| between the heading of a pose and the direction to a place: ahead alone, by either end,
/// or of a path that looks along `yaw` there (PathAngleCritic's modes) [rad].
double posePointAngle(const Pose2& pose, const Vec2& place, bool isForward);
double posePointAngle(const Pose2& pose, const Vec2& place, double yaw);

/// Prices the trajectories of a batch by the critics, in their order.
class MppiCritics {
 public:
  MppiCritics(const MppiConfiguration& mppi, const TrajectoryKernel& kernel);

  /// A new cycle: how far the path is reached and where it is free is found again, once.
  void begin(const MppiScene& scene);
  /// Adds to `costs`, one per sample of the batch with those that fill it up. Nobody is asked once
  /// all trajectories collide.
  void score(const MppiScene& scene, TrajectoryColumns& columns, std::vector<float>& costs);
  bool hasFailed() const { return hasFailed_; }

  /// Of the last call, for display: by critic, sample.
  const std::vector<std::string>& names() const { return names_; }
  bool wasAsked(std::size_t critic) const { return wasAsked_[critic]; }
  const std::vector<float>& scores(std::size_t critic) const { return scores_[critic]; }
  const std::vector<float>& hits() const { return hits_; }  // 1: collides
  /// Index of the path point reached furthest in this cycle; none: no critic wanted to know.
  const std::optional<int>& furthest() const { return furthest_; }

 private:
  struct Round;
  using Ask = bool (MppiCritics::*)(Round&);
  struct Named {
    const char* name;
    Ask ask;
  };
  static const std::vector<Named>& known();

  void fillPath(const Path& path);
  void fillCells(const MppiScene& scene);
  bool isNear(const MppiScene& scene, double threshold) const;
  int reachedBy(Round& round);
  bool isValid(const Round& round, int point);
  CollisionProblem collisionOf(const Round& round, bool considersFootprint);
  void takeFailure(const Round& round);
  void addObstacles(const Round& round);
  bool isTooOccupied(Round& round, int reached);
  int firstCounted(const Round& round) const;
  ScoreSink sinkOf(const Round& round, const CriticSettings& settings);

  // Each returns whether it applied.
  bool askConstraint(Round& round);
  bool askCost(Round& round);
  bool askObstacles(Round& round);
  bool askGoal(Round& round);
  bool askGoalAngle(Round& round);
  bool askPathAlign(Round& round);
  bool askPathFollow(Round& round);
  bool askPathAngle(Round& round);
  bool askPreferForward(Round& round);
  bool askTwirling(Round& round);
  bool askDeadband(Round& round);

  const Distro distro_;
  const MppiMotion motion_;
  const MppiLimits limits_;
  const float dt_;
  const MppiCriticSettings settings_;
  const TrajectoryKernel kernel_;
  std::vector<std::string> names_;
  std::vector<Ask> asks_;

  std::vector<float> pathX_, pathY_, pathYaw_, pathWay_;
  double pathLength_ = 0.0;  // [m]
  std::vector<float> cells_;
  std::optional<int> furthest_;
  std::vector<float> valid_;  // by path point but the last; empty: not asked yet
  bool hasFailed_ = false;

  std::vector<std::vector<float>> scores_;
  std::vector<bool> wasAsked_;
  std::vector<float> hits_, margins_, repulsions_, nearest_;
  std::vector<float> centreDistances_, edgeDistances_;  // by cost [m]
  std::vector<float> alignWay_;
};

}  // namespace sim2d::nav2
