#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/FootprintCost.h"
#include "sim2d/nav/nav2/mppi/MppiCriticRound.h"
#include "sim2d/nav/nav2/mppi/MppiCritics.h"

namespace sim2d::nav2 {
namespace {

constexpr int kCostValues = 256;

float costFloat(double value) {
  return static_cast<float>(value);
}

float edgeCostAt(const void* scene, float x, float y, float yaw) {
  const auto& seen = *static_cast<const MppiScene*>(scene);
  const Pose2 pose{Vec2(static_cast<double>(x), static_cast<double>(y)), static_cast<double>(yaw)};
  return static_cast<float>(footprintCost(seen.costmap, seen.shape.vertices, pose));
}

/// Distances that costs tell: r_in - ln(c / 253) / scaling of the centre, less the radius of a
/// robot whose centre is asked.
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
    centre[at] = costFloat(beyond);
    edge[at] = costFloat(inscribed + beyond);
  }
}

}  // namespace

CollisionProblem MppiCritics::collisionOf(const Round& round, bool considersFootprint) {
  const Costmap& costmap = round.scene.costmap;
  CollisionProblem problem;
  problem.cells.costs = cells_.data();
  problem.cells.columns = costmap.width();
  problem.cells.rows = costmap.height();
  problem.cells.x = costFloat(costmap.origin().x());
  problem.cells.y = costFloat(costmap.origin().y());
  problem.cells.resolution = costFloat(costmap.resolution());
  problem.tracksUnknown = round.scene.shape.tracksUnknown;
  problem.considersFootprint = considersFootprint;
  problem.possible = costFloat(circumscribedCost(round.scene.shape));
  problem.probe = {edgeCostAt, &round.scene};
  problem.hits = hits_.data();
  return problem;
}

/// Every trajectory collides: there is nothing to choose from.
void MppiCritics::takeFailure(const Round& round) {
  hasFailed_ = std::all_of(hits_.begin(), hits_.begin() + round.columns.count(),
                           [](float hit) { return hit > 0.0F; });
}

bool MppiCritics::askCost(Round& round) {
  const CostSettings& settings = settings_.cost;
  if (!settings.isEnabled) {
    return false;
  }
  CostProblem problem;
  problem.collision = collisionOf(round, settings.considersFootprint);
  problem.collisionCost = costFloat(settings.collisionCost);
  problem.criticalCost = costFloat(settings.criticalCost);
  problem.nearCollisionCost = costFloat(settings.nearCollisionCost);
  problem.isNearGoal = isNear(round.scene, settings.nearGoalDistance);
  problem.pointStep = settings.pointStep;
  // Jazzy leaves the last pose out if the steps are no multiple of the stride.
  problem.points = distro_ == Distro::Jazzy ? std::max(1, round.batch.steps / settings.pointStep)
                                            : (round.batch.steps - 1) / settings.pointStep + 1;
  ScoreSink sink = sinkOf(round, settings);
  sink.weight = costFloat(settings.weight / 254.0);
  kernel_.cost(problem, round.batch, sink);
  takeFailure(round);
  return true;
}

bool MppiCritics::askObstacles(Round& round) {
  const ObstaclesSettings& settings = settings_.obstacles;
  if (!settings.isEnabled) {
    return false;
  }
  const ControlledShape& shape = round.scene.shape;
  const bool isHumble = distro_ == Distro::Humble;
  const double scaling = isHumble ? settings.costScaling : shape.costScaling;
  const double radius = isHumble ? settings.inflationRadius : shape.inflationRadius;
  fillObstacleDistances(scaling, shape.inscribedRadius, centreDistances_, edgeDistances_);
  margins_.resize(hits_.size());
  repulsions_.resize(hits_.size());
  ObstaclesProblem problem;
  problem.collision = collisionOf(round, settings.considersFootprint);
  problem.collisionCost = costFloat(settings.collisionCost);
  problem.margin = costFloat(settings.marginDistance);
  problem.inflationRadius = costFloat(radius);
  problem.hasInflation = radius != 0.0 && scaling != 0.0;
  problem.isNearGoal = isNear(round.scene, settings.nearGoalDistance);
  problem.repelsOutsideOnly = isHumble;
  problem.centreDistances = centreDistances_.data();
  problem.edgeDistances = edgeDistances_.data();
  problem.margins = margins_.data();
  problem.repulsions = repulsions_.data();
  kernel_.obstacles(problem, round.batch);
  addObstacles(round);
  takeFailure(round);
  return true;
}

void MppiCritics::addObstacles(const Round& round) {
  const ObstaclesSettings& settings = settings_.obstacles;
  const auto critical = costFloat(settings.criticalWeight);
  const auto repelling = costFloat(settings.repulsionWeight);
  const auto steps = static_cast<float>(round.batch.steps);
  const float least =
      distro_ == Distro::Humble
          ? 0.0F
          : *std::min_element(repulsions_.begin(), repulsions_.begin() + round.columns.count());
  for (std::size_t i = 0; i < margins_.size(); ++i) {
    const float weighted = critical * margins_[i] + repelling * ((repulsions_[i] - least) / steps);
    float score = weighted;
    for (int power = 1; power < settings.power; ++power) {
      score *= weighted;
    }
    scores_[round.critic][i] = score;
    round.costs[i] += score;
  }
}

}  // namespace sim2d::nav2
