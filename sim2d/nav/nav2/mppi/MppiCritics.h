#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/mppi/MppiSequence.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

/// The critics of Nav2's MPPI (nav2_mppi_controller, critics/*.cpp): conditions of evaluation and
/// inputs of the kernel.
namespace sim2d::nav2 {

/// Inputs of a cycle. World frame.
struct MppiScene {
  const Pose2& robot;
  const BodyTwist& speed;  // measured
  const Path& path;        // local path, not empty
  const Pose2& goal;
  const Costmap& costmap;
  const RobotFootprint& shape;
  double xyGoalTolerance = 0.25;  // [m]
};

/// Whether a position is free: on the map and not on a cell of 253, 254, or 255 unless unknown
/// space counts as free.
bool isPathPointValid(const Costmap& costmap, const Vec2& place, bool tracksUnknown);
/// Inflation cost at the circumscribed radius: if the centre's cost is lower, no edge touches an
/// obstacle. -1 without inflation.
double circumscribedCost(const RobotFootprint& shape);
/// |angle| [rad] between a pose's heading and the direction to a position: forward only or in
/// either direction; the second overload reverses the direction where the path with heading `yaw`
/// is driven in reverse (modes of PathAngleCritic).
double posePointAngle(const Pose2& pose, const Vec2& place, bool isForward);
double posePointAngle(const Pose2& pose, const Vec2& place, double yaw);

/// Scores the trajectories of a batch by the critics, in their order.
class MppiCritics {
 public:
  MppiCritics(const MppiConfiguration& mppi, const TrajectoryKernel& kernel);

  /// Starts a cycle: resets the cached path progress and path validity.
  void begin(const MppiScene& scene);
  /// Adds the scores to `costs`, one per sample of the batch including padding. Skips the remaining
  /// critics once all trajectories collide.
  void score(const MppiScene& scene, TrajectoryBuffer& columns, std::vector<float>& costs);
  bool hasFailed() const { return hasFailed_; }

  /// Results of the last call, for display: by critic, sample.
  const std::vector<std::string>& names() const { return names_; }
  bool wasEvaluated(std::size_t critic) const { return wasEvaluated_[critic]; }
  const std::vector<float>& scores(std::size_t critic) const { return scores_[critic]; }
  const std::vector<float>& hits() const { return hits_; }  // 1: collides
  /// Index of the farthest reached path point in this cycle; none: not computed.
  const std::optional<int>& furthest() const { return furthest_; }

 private:
  struct CriticCall;
  using Evaluate = bool (MppiCritics::*)(CriticCall&);
  struct Named {
    const char* name;
    Evaluate evaluate;
  };
  static const std::vector<Named>& known();

  void fillPath(const Path& path);
  void copyCosts(const MppiScene& scene);
  bool isNear(const MppiScene& scene, double threshold) const;
  int furthestReached(CriticCall& call);
  bool isValid(const CriticCall& call, int point);
  CollisionProblem collisionOf(const CriticCall& call, bool considersFootprint);
  void updateFailureFlag(const CriticCall& call);
  void addObstacles(const CriticCall& call);
  bool isTooOccupied(CriticCall& call, int reached);
  int firstCheckedPoint(const CriticCall& call) const;
  ScoreSink sinkOf(const CriticCall& call, const CommonCriticSettings& settings);

  // Each returns whether the critic was applied.
  bool evaluateConstraint(CriticCall& call);
  bool evaluateCost(CriticCall& call);
  bool evaluateObstacles(CriticCall& call);
  bool evaluateGoal(CriticCall& call);
  bool evaluateGoalAngle(CriticCall& call);
  bool evaluatePathAlign(CriticCall& call);
  bool evaluatePathFollow(CriticCall& call);
  bool evaluatePathAngle(CriticCall& call);
  bool evaluatePreferForward(CriticCall& call);
  bool evaluateTwirling(CriticCall& call);
  bool evaluateDeadband(CriticCall& call);

  const Distro distro_;
  const MppiMotion motion_;
  const MppiLimits limits_;
  const float dt_;
  const MppiCriticSettings settings_;
  const TrajectoryKernel kernel_;
  std::vector<std::string> names_;
  std::vector<Evaluate> evaluators_;

  std::vector<float> pathX_, pathY_, pathYaw_, pathWay_;
  double pathLength_ = 0.0;  // [m]
  std::vector<float> cells_;
  std::optional<int> furthest_;
  std::vector<float> valid_;  // by path point except the last; empty: not computed yet
  bool hasFailed_ = false;

  std::vector<std::vector<float>> scores_;
  std::vector<bool> wasEvaluated_;
  std::vector<float> hits_, margins_, repulsions_, nearest_;
  std::vector<float> centreDistances_, edgeDistances_;  // by cost [m]
  std::vector<float> alignWay_;
};

/// The evaluation of one batch by one critic.
struct MppiCritics::CriticCall {
  const MppiScene& scene;
  const TrajectoryBuffer& columns;
  TrajectoryBatch batch;
  std::vector<float>& costs;
  std::size_t critic;  // index
};

}  // namespace sim2d::nav2
