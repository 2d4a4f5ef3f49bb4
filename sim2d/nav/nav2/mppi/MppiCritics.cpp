#include "sim2d/nav/nav2/mppi/MppiCritics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/costmap/InflationLayer.h"

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
    const auto found = std::find_if(known().begin(), known().end(),
                                    [&](const Named& critic) { return name == critic.name; });
    if (found != known().end()) {  // readMppi has reported unknown critics
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

}  // namespace sim2d::nav2
