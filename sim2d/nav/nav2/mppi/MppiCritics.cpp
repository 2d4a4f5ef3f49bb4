#include "sim2d/nav/nav2/mppi/MppiCritics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {

bool isPathPointValid(const Costmap& costmap, const Vec2& place, bool tracksUnknown) {
  const auto cell = costmap.worldToCell(place);
  if (!cell) {
    return false;
  }
  const std::uint8_t cost = costmap.at(*cell);
  return cost == kNoInformation ? tracksUnknown : cost < kInscribed;
}

double circumscribedCost(const RobotFootprint& shape) {
  if (shape.inflationRadius <= 0.0) {
    return -1.0;
  }
  const InflationCostFunction costFunction{shape.inflationRadius, shape.costScaling,
                                           shape.inscribedRadius};
  return costFunction.cost(shape.circumscribedRadius);
}

double posePointAngle(const Pose2& pose, const Vec2& place, bool isForward) {
  const double angle =
      std::abs(base::angleDiff(base::headingOf(place - pose.position), pose.heading));
  return isForward ? angle : std::min(angle, base::kPi - angle);
}

double posePointAngle(const Pose2& pose, const Vec2& place, double yaw) {
  double heading = base::headingOf(place - pose.position);
  if (std::abs(base::angleDiff(heading, yaw)) > base::kPi / 2.0) {
    heading += base::kPi;
  }
  return std::abs(base::angleDiff(heading, pose.heading));
}

const std::vector<MppiCritics::Named>& MppiCritics::known() {
  static const std::vector<Named> kKnown = {
      {"ConstraintCritic", &MppiCritics::evaluateConstraint},
      {"CostCritic", &MppiCritics::evaluateCost},
      {"ObstaclesCritic", &MppiCritics::evaluateObstacles},
      {"GoalCritic", &MppiCritics::evaluateGoal},
      {"GoalAngleCritic", &MppiCritics::evaluateGoalAngle},
      {"PathAlignCritic", &MppiCritics::evaluatePathAlign},
      {"PathFollowCritic", &MppiCritics::evaluatePathFollow},
      {"PathAngleCritic", &MppiCritics::evaluatePathAngle},
      {"PreferForwardCritic", &MppiCritics::evaluatePreferForward},
      {"TwirlingCritic", &MppiCritics::evaluateTwirling},
      {"VelocityDeadbandCritic", &MppiCritics::evaluateDeadband},
  };
  return kKnown;
}

MppiCritics::MppiCritics(const MppiConfiguration& mppi, const TrajectoryKernel& kernel)
    : distro_(mppi.distro),
      motion_(mppi.motion),
      limits_(mppiLimitsOf(mppi.settings)),
      dt_(static_cast<float>(mppi.settings.modelDt)),
      settings_(mppi.critics),
      kernel_(kernel) {
  for (const std::string& name : mppi.settings.critics) {
    const Named* const found = base::findBy(known(), &Named::name, name);
    if (found != nullptr) {  // readMppi has reported unknown critics
      names_.push_back(name);
      evaluators_.push_back(found->evaluate);
    }
  }
  scores_.resize(names_.size());
  wasEvaluated_.resize(names_.size());
}

void MppiCritics::begin(const MppiScene& scene) {
  furthest_.reset();
  valid_.clear();
  hasFailed_ = false;
  fillPath(scene.path);
  copyCosts(scene);
}

void MppiCritics::fillPath(const Path& path) {
  pathX_.clear();
  pathY_.clear();
  pathYaw_.clear();
  pathWay_.clear();
  float way = 0.0F;
  for (const Pose2& pose : path) {
    const auto x = static_cast<float>(pose.position.x());
    const auto y = static_cast<float>(pose.position.y());
    if (!pathX_.empty()) {
      const float dx = x - pathX_.back();
      const float dy = y - pathY_.back();
      way += std::sqrt(dx * dx + dy * dy);
    }
    pathX_.push_back(x);
    pathY_.push_back(y);
    pathYaw_.push_back(static_cast<float>(pose.heading));
    pathWay_.push_back(way);
  }
  pathLength_ = pathLength(path);
}

void MppiCritics::copyCosts(const MppiScene& scene) {
  const std::vector<std::uint8_t>& costs = scene.costmap.costs();
  cells_.resize(std::max<std::size_t>(costs.size(), 1));
  std::transform(costs.begin(), costs.end(), cells_.begin(),
                 [](std::uint8_t cost) { return static_cast<float>(cost); });
}

void MppiCritics::score(const MppiScene& scene, TrajectoryBuffer& columns,
                        std::vector<float>& costs) {
  const std::size_t samples = columns.length.size();
  hits_.assign(samples, 0.0F);
  for (std::size_t i = 0; i < evaluators_.size(); ++i) {
    scores_[i].assign(samples, 0.0F);
    wasEvaluated_[i] = false;
  }
  for (std::size_t i = 0; i < evaluators_.size() && !hasFailed_; ++i) {
    CriticCall call{scene, columns, columns.view(), costs, i};
    wasEvaluated_[i] = (this->*evaluators_[i])(call);
  }
}

bool MppiCritics::isNear(const MppiScene& scene, double threshold) const {
  if (distro_ >= Distro::Lyrical) {
    return pathLength_ < threshold;
  }
  const Pose2& end = distro_ == Distro::Humble ? scene.path.back() : scene.goal;
  return (end.position - scene.robot.position).squaredNorm() < threshold * threshold;
}

int MppiCritics::furthestReached(CriticCall& call) {
  if (!furthest_) {
    // Avoids dependence on rounding where driven length and path length are equal.
    constexpr float kSlack = 1e-3F;  // [m]
    const float slack =
        distro_ >= Distro::Lyrical ? kSlack : std::numeric_limits<float>::infinity();
    PathPoints path;
    path.x = pathX_.data();
    path.y = pathY_.data();
    path.way = pathWay_.data();
    path.count = static_cast<int>(pathX_.size());
    nearest_.resize(call.columns.length.size());
    kernel_.nearest(path, slack, call.batch, nearest_.data());
    furthest_ = static_cast<int>(
        *std::max_element(nearest_.begin(), nearest_.begin() + call.columns.count()));
  }
  return *furthest_;
}

bool MppiCritics::isValid(const CriticCall& call, int point) {
  if (valid_.empty() && call.scene.path.size() > 1) {
    for (std::size_t i = 0; i + 1 < call.scene.path.size(); ++i) {
      const bool isFree = isPathPointValid(call.scene.costmap, call.scene.path[i].position,
                                           call.scene.shape.tracksUnknown);
      valid_.push_back(isFree ? 1.0F : 0.0F);
    }
  }
  return valid_[static_cast<std::size_t>(point)] > 0.0F;
}

ScoreSink MppiCritics::sinkOf(const CriticCall& call, const CommonCriticSettings& settings) {
  ScoreSink sink;
  sink.weight = static_cast<float>(settings.weight);
  sink.power = settings.power;
  sink.costs = call.costs.data();
  sink.scores = scores_[call.critic].data();
  return sink;
}

bool MppiCritics::evaluateConstraint(CriticCall& call) {
  using Model = ConstraintProblem::Model;
  const CommonCriticSettings& settings = settings_.constraint;
  if (!settings.isEnabled) {
    return false;
  }
  ConstraintProblem problem;
  problem.low = limits_.low[0];
  problem.high = limits_.high[0];
  problem.lateral = limits_.high[2];
  problem.turningRadius = limits_.turningRadius;
  problem.dt = dt_;
  if (motion_ == MppiMotion::Ackermann) {
    problem.model = Model::Ackermann;
  } else if (motion_ == MppiMotion::Omni && distro_ >= Distro::Lyrical) {
    problem.model = Model::LinearAndLateral;
  } else if (motion_ == MppiMotion::Omni) {
    problem.model = Model::Planar;
  }
  if (distro_ < Distro::Lyrical) {  // vy_max applies to every motion model, even without vy
    const float back = std::sqrt(problem.low * problem.low + problem.lateral * problem.lateral);
    problem.low = problem.low > 0.0F ? back : -back;
    problem.high = std::sqrt(problem.high * problem.high + problem.lateral * problem.lateral);
  }
  kernel_.constraint(problem, call.batch, sinkOf(call, settings));
  return true;
}

bool MppiCritics::evaluateGoal(CriticCall& call) {
  const GoalSettings& settings = settings_.goal;
  if (!settings.isEnabled || !isNear(call.scene, settings.threshold)) {
    return false;
  }
  kernel_.goal(pathX_.back(), pathY_.back(), call.batch, sinkOf(call, settings));
  return true;
}

bool MppiCritics::evaluateGoalAngle(CriticCall& call) {
  const GoalAngleSettings& settings = settings_.goalAngle;
  if (!settings.isEnabled || !isNear(call.scene, settings.threshold)) {
    return false;
  }
  const float yaw = distro_ == Distro::Humble ? pathYaw_.back() : toFloat(call.scene.goal.heading);
  kernel_.goalAngle(yaw, settings.isSymmetric, call.batch, sinkOf(call, settings));
  return true;
}

/// The index from which blocked path points are counted: Humble begins at the point nearest to the
/// start of the trajectories.
int MppiCritics::firstCheckedPoint(const CriticCall& call) const {
  if (distro_ != Distro::Humble) {
    return 0;
  }
  int first = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < pathX_.size(); ++i) {
    const float dx = pathX_[i] - call.columns.x.front();
    const float dy = pathY_[i] - call.columns.y.front();
    const float distance2 = dx * dx + dy * dy;
    if (distance2 < least) {
      least = distance2;
      first = static_cast<int>(i);
    }
  }
  return first;
}

bool MppiCritics::isTooOccupied(CriticCall& call, int reached) {
  const int first = firstCheckedPoint(call);
  const auto range = static_cast<float>(reached - first);
  float blocked = 0.0F;
  for (int i = first; i < reached; ++i) {
    blocked += isValid(call, i) ? 0.0F : 1.0F;
    if (blocked > 2.0F && blocked / range > toFloat(settings_.pathAlign.maxPathOccupancyRatio)) {
      return true;
    }
  }
  return false;
}

bool MppiCritics::evaluatePathAlign(CriticCall& call) {
  const PathAlignSettings& settings = settings_.pathAlign;
  if (!settings.isEnabled || isNear(call.scene, settings.threshold)) {
    return false;
  }
  const int reached = furthestReached(call);
  if (reached < std::max(settings.offsetFromFurthest, 1) || isTooOccupied(call, reached)) {
    return false;
  }
  isValid(call, 0);  // fills valid_, also when Humble has counted no points
  alignWay_.assign(pathWay_.begin(), pathWay_.begin() + reached);
  alignWay_.push_back(std::numeric_limits<float>::infinity());
  AlignProblem problem;
  problem.path.x = pathX_.data();
  problem.path.y = pathY_.data();
  problem.path.yaw = pathYaw_.data();
  problem.path.way = alignWay_.data();
  problem.path.valid = valid_.data();
  problem.path.count = reached;
  problem.pointStep = settings.pointStep;
  problem.usesOrientations = settings.usesOrientations;
  kernel_.align(problem, call.batch, sinkOf(call, settings));
  return true;
}

bool MppiCritics::evaluatePathFollow(CriticCall& call) {
  const PathFollowSettings& settings = settings_.pathFollow;
  if (!settings.isEnabled || pathX_.size() < 2 || isNear(call.scene, settings.threshold)) {
    return false;
  }
  const int last = static_cast<int>(pathX_.size()) - 1;
  int point = std::min(furthestReached(call) + settings.offsetFromFurthest, last);
  while (point < last - 1 && !isValid(call, point)) {
    ++point;
  }
  const auto at = static_cast<std::size_t>(point);
  kernel_.follow(pathX_[at], pathY_[at], call.batch, sinkOf(call, settings));
  return true;
}

bool MppiCritics::evaluatePathAngle(CriticCall& call) {
  using Mode = AngleProblem::Mode;
  const PathAngleSettings& settings = settings_.pathAngle;
  if (!settings.isEnabled || isNear(call.scene, settings.threshold)) {
    return false;
  }
  const bool isHumble = distro_ == Distro::Humble;
  auto mode = static_cast<Mode>(isHumble ? (settings.isForwardPreferred ? 0 : 1) : settings.mode);
  if (mode == Mode::EitherEnd && std::abs(limits_.low[0]) < 1e-6F) {
    mode = Mode::Forward;  // the robot cannot reverse
  }
  const int last = static_cast<int>(pathX_.size()) - 1;
  const auto at =
      static_cast<std::size_t>(std::min(furthestReached(call) + settings.offsetFromFurthest, last));
  const Pose2& point = call.scene.path[at];
  const double angle =
      mode == Mode::AlongPath
          ? posePointAngle(call.scene.robot, point.position, point.heading)
          : posePointAngle(call.scene.robot, point.position, mode == Mode::Forward);
  if (angle < settings.maxAngleToFurthest) {
    return false;
  }
  AngleProblem problem;
  problem.mode = mode;
  problem.isMean = isHumble;
  problem.x = pathX_[at];
  problem.y = pathY_[at];
  problem.yaw = pathYaw_[at];
  kernel_.angle(problem, call.batch, sinkOf(call, settings));
  return true;
}

bool MppiCritics::evaluatePreferForward(CriticCall& call) {
  const PreferForwardSettings& settings = settings_.preferForward;
  if (!settings.isEnabled || isNear(call.scene, settings.threshold)) {
    return false;
  }
  kernel_.forward(dt_, call.batch, sinkOf(call, settings));
  return true;
}

bool MppiCritics::evaluateTwirling(CriticCall& call) {
  const CommonCriticSettings& settings = settings_.twirling;
  const Pose2& end = distro_ == Distro::Humble ? call.scene.path.back() : call.scene.goal;
  const double tolerance = call.scene.xyGoalTolerance;
  const double distance2 = (end.position - call.scene.robot.position).squaredNorm();
  if (!settings.isEnabled || distance2 < tolerance * tolerance) {
    return false;
  }
  kernel_.twirling(call.batch, sinkOf(call, settings));
  return true;
}

bool MppiCritics::evaluateDeadband(CriticCall& call) {
  const DeadbandSettings& settings = settings_.deadband;
  if (!settings.isEnabled) {
    return false;
  }
  DeadbandProblem problem;
  constexpr std::size_t kOrder[kTrajectoryAxes] = {0, 2, 1};  // the order of the key is vx, vy, wz
  for (std::size_t axis = 0; axis < kTrajectoryAxes; ++axis) {
    problem.deadband[axis] = std::abs(toFloat(settings.velocities[kOrder[axis]]));
  }
  problem.isHolonomic = motion_ == MppiMotion::Omni;
  problem.dt = dt_;
  kernel_.deadband(problem, call.batch, sinkOf(call, settings));
  return true;
}

namespace {

constexpr int kCostValues = 256;

float edgeCostAt(const void* scene, float x, float y, float yaw) {
  const auto& seen = *static_cast<const MppiScene*>(scene);
  const Pose2 pose{Vec2(static_cast<double>(x), static_cast<double>(y)), static_cast<double>(yaw)};
  return static_cast<float>(footprintCost(seen.costmap, seen.shape.vertices, pose));
}

/// Obstacle distances by cost: `edge` is r_in - ln(c / 253) / scaling; `centre` is the same less
/// r_in, for the centre of a circular robot.
void fillObstacleDistances(double scaling, double inscribed, std::vector<float>& centre,
                           std::vector<float>& edge) {
  centre.assign(kCostValues, 0.0F);
  edge.assign(kCostValues, 0.0F);
  if (scaling == 0.0) {
    return;
  }
  for (int cost = 1; cost < kCostValues; ++cost) {
    const auto at = static_cast<std::size_t>(cost);
    const double beyond = -base::log(cost / 253.0) / scaling;
    centre[at] = toFloat(beyond);
    edge[at] = toFloat(inscribed + beyond);
  }
}

}  // namespace

CollisionProblem MppiCritics::collisionOf(const CriticCall& call, bool considersFootprint) {
  const Costmap& costmap = call.scene.costmap;
  CollisionProblem problem;
  problem.cells.costs = cells_.data();
  problem.cells.columns = costmap.width();
  problem.cells.rows = costmap.height();
  problem.cells.x = toFloat(costmap.origin().x());
  problem.cells.y = toFloat(costmap.origin().y());
  problem.cells.resolution = toFloat(costmap.resolution());
  problem.tracksUnknown = call.scene.shape.tracksUnknown;
  problem.considersFootprint = considersFootprint;
  problem.possible = toFloat(circumscribedCost(call.scene.shape));
  problem.footprintCost = {edgeCostAt, &call.scene};
  problem.hits = hits_.data();
  return problem;
}

/// If every trajectory collides, there is no valid choice.
void MppiCritics::updateFailureFlag(const CriticCall& call) {
  hasFailed_ = std::all_of(hits_.begin(), hits_.begin() + call.columns.count(),
                           [](float hit) { return hit > 0.0F; });
}

bool MppiCritics::evaluateCost(CriticCall& call) {
  const CostSettings& settings = settings_.cost;
  if (!settings.isEnabled) {
    return false;
  }
  CostProblem problem;
  problem.collision = collisionOf(call, settings.considersFootprint);
  problem.collisionCost = toFloat(settings.collisionCost);
  problem.criticalCost = toFloat(settings.criticalCost);
  problem.nearCollisionCost = toFloat(settings.nearCollisionCost);
  problem.isNearGoal = isNear(call.scene, settings.nearGoalDistance);
  problem.pointStep = settings.pointStep;
  // Jazzy omits the last pose if the number of steps is not a multiple of the stride.
  problem.points = distro_ == Distro::Jazzy ? std::max(1, call.batch.steps / settings.pointStep)
                                            : (call.batch.steps - 1) / settings.pointStep + 1;
  ScoreSink sink = sinkOf(call, settings);
  sink.weight = toFloat(settings.weight / 254.0);
  kernel_.cost(problem, call.batch, sink);
  updateFailureFlag(call);
  return true;
}

bool MppiCritics::evaluateObstacles(CriticCall& call) {
  const ObstaclesSettings& settings = settings_.obstacles;
  if (!settings.isEnabled) {
    return false;
  }
  const RobotFootprint& shape = call.scene.shape;
  const bool isHumble = distro_ == Distro::Humble;
  const double scaling = isHumble ? settings.costScaling : shape.costScaling;
  const double radius = isHumble ? settings.inflationRadius : shape.inflationRadius;
  fillObstacleDistances(scaling, shape.inscribedRadius, centreDistances_, edgeDistances_);
  margins_.resize(hits_.size());
  repulsions_.resize(hits_.size());
  ObstaclesProblem problem;
  problem.collision = collisionOf(call, settings.considersFootprint);
  problem.collisionCost = toFloat(settings.collisionCost);
  problem.margin = toFloat(settings.marginDistance);
  problem.inflationRadius = toFloat(radius);
  problem.hasInflation = radius != 0.0 && scaling != 0.0;
  problem.isNearGoal = isNear(call.scene, settings.nearGoalDistance);
  problem.repelsOutsideOnly = isHumble;
  problem.centreDistances = centreDistances_.data();
  problem.edgeDistances = edgeDistances_.data();
  problem.margins = margins_.data();
  problem.repulsions = repulsions_.data();
  kernel_.obstacles(problem, call.batch);
  addObstacles(call);
  updateFailureFlag(call);
  return true;
}

void MppiCritics::addObstacles(const CriticCall& call) {
  const ObstaclesSettings& settings = settings_.obstacles;
  const auto critical = toFloat(settings.criticalWeight);
  const auto repelling = toFloat(settings.repulsionWeight);
  const auto steps = static_cast<float>(call.batch.steps);
  const float least =
      distro_ == Distro::Humble
          ? 0.0F
          : *std::min_element(repulsions_.begin(), repulsions_.begin() + call.columns.count());
  for (std::size_t i = 0; i < margins_.size(); ++i) {
    const float weighted = critical * margins_[i] + repelling * ((repulsions_[i] - least) / steps);
    float score = weighted;
    for (int power = 1; power < settings.power; ++power) {
      score *= weighted;
    }
    scores_[call.critic][i] = score;
    call.costs[i] += score;
  }
}

}  // namespace sim2d::nav2
