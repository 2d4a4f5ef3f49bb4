#include "sim2d/nav/nav2/control/dwb/DwbController.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"

namespace sim2d::nav2 {
namespace {

PathPruning dwbPruning(const DwbParameters& parameters) {
  PathPruning pruning;
  pruning.rule = PathPruning::Rule::Dwb;
  pruning.prunesPlan = parameters.prunesPlan;
  pruning.pruneDistance = parameters.pruneDistance;
  pruning.forwardPruneDistance = parameters.forwardPruneDistance;
  pruning.shortensPlan = parameters.shortensPlan;
  return pruning;
}

}  // namespace

DwbController::DwbController(Setup setup)
    : parameters_(std::move(setup.parameters)),
      fullParameters_(parameters_),
      critics_(std::move(setup.critics)),
      generator_(setup.generator, setup.frequency),
      handler_(dwbPruning(parameters_)),
      scales_(critics_.size()),
      rawScores_(critics_.size()) {}

void DwbController::setPlan(const Path& plan) {
  for (const NamedCritic& each : critics_) {
    each.critic->reset();
  }
  handler_.setPlan(plan);
  goal_ = plan.empty() ? Pose2() : plan.back();
}

void DwbController::setSpeedLimit(double limit, bool isPercentage) {
  const DwbParameters& full = fullParameters_;
  double ratio = 1.0;
  if (limit != 0.0) {
    if (!isPercentage && limit >= full.maxSpeedXy) {
      return;
    }
    ratio = isPercentage ? limit / 100.0 : limit / full.maxSpeedXy;
  }
  parameters_.maxSpeedXy = limit != 0.0 && !isPercentage ? limit : full.maxSpeedXy * ratio;
  parameters_.maxVelX = full.maxVelX * ratio;
  parameters_.maxVelY = full.maxVelY * ratio;
  parameters_.maxVelTheta = full.maxVelTheta * ratio;
}

ControlResult DwbController::computeVelocityCommands(const ControlInput& input) {
  LocalPlan local = handler_.localPlan(input);
  view_ = {};
  if (local.problem != nullptr) {
    return {ControllerError::InvalidPath, local.problem};
  }
  prepare(input, local.poses, input.fromPlan(goal_));
  view_.localPlan = std::move(local.poses);
  selectBest();
  const bool isLegal = best_.total >= 0.0F;
  const BodyTwist command = isLegal ? best_.trajectory.velocity : BodyTwist();
  for (const NamedCritic& each : critics_) {
    each.critic->debrief(command);
  }
  if (!isLegal) {
    return {ControllerError::NoValidControl,
            "Could not find a legal trajectory: No valid trajectories out of " +
                std::to_string(generator_.commands().size()) + "!"};
  }
  view_.predicted = best_.trajectory.poses;
  return command;
}

void DwbController::prepare(const ControlInput& input, const Path& plan, const Pose2& goal) {
  const Costmap& map = input.costmap;
  const std::vector<Cell> seeds = pathSeeds(plan, map);
  pathGrid_.clear(map.width(), map.height());
  goalGrid_.clear(map.width(), map.height());
  for (const Cell cell : seeds) {
    pathGrid_.seed(cell);
  }
  if (!seeds.empty()) {
    goalGrid_.seed(seeds.back());
  }
  const DwbScene scene{input, plan, goal, pathGrid_, goalGrid_};
  for (std::size_t i = 0; i < critics_.size(); ++i) {
    critics_[i].critic->prepare(scene);
    scales_[i] = static_cast<float>(critics_[i].critic->scale(map.resolution()));
  }
  generator_.start(parameters_, input.robot, input.speed, map);
}

void DwbController::selectBest() {
  best_.total = -1.0F;
  std::size_t chosen = 0;
  const bool prunes = !isWatched() && std::all_of(scales_.begin(), scales_.end(),
                                                  [](float scale) { return scale >= 0.0F; });
  for (const BodyTwist& command : generator_.commands()) {
    generator_.generate(command, candidate_);
    if (prunes && best_.total >= 0.0F && !canWin(candidate_)) {
      continue;
    }
    generator_.locate(candidate_);
    float total = 0.0F;
    if (evaluate(candidate_, best_.total, total) && (best_.total < 0.0F || total < best_.total)) {
      best_.total = total;
      std::swap(best_.trajectory, candidate_);
      chosen = view_.trajectories.size() - 1;
    }
  }
  if (isWatched() && best_.total >= 0.0F) {
    view_.trajectories[chosen].isChosen = true;
  }
}

/// Returns false where lower bounds of all scores, summed like the scores, exclude a total below
/// the best. Scales must not be negative.
bool DwbController::canWin(const DwbTrajectory& trajectory) const {
  float least = 0.0F;
  for (std::size_t i = 0; i < critics_.size(); ++i) {
    if (scales_[i] != 0.0F) {
      least = static_cast<float>(static_cast<double>(least) +
                                 critics_[i].critic->leastScore(trajectory) *
                                     static_cast<double>(scales_[i]));
    }
  }
  return !(least >= best_.total);
}

/// Returns false for an invalid trajectory. Sums in single precision like Nav2's messages, so that
/// the first of nearly equal totals wins as there.
bool DwbController::evaluate(const DwbTrajectory& trajectory, float best, float& total) {
  std::size_t evaluated = 0;
  for (; evaluated < critics_.size(); ++evaluated) {
    rawScores_[evaluated] = 0.0F;
    if (scales_[evaluated] == 0.0F) {
      continue;
    }
    const DwbScore score = critics_[evaluated].critic->score(trajectory);
    if (score.rejection != nullptr) {
      recordTrajectory(trajectory, -1.0F, evaluated, score.rejection);
      return false;
    }
    rawScores_[evaluated] = static_cast<float>(score.raw);
    total = static_cast<float>(static_cast<double>(total) +
                               score.raw * static_cast<double>(scales_[evaluated]));
    if (parameters_.shortCircuits && best > 0.0F && total > best) {
      ++evaluated;
      break;  // later scores are not negative: it stays worse
    }
  }
  recordTrajectory(trajectory, total, evaluated, nullptr);
  return true;
}

void DwbController::recordTrajectory(const DwbTrajectory& trajectory, float total,
                                     std::size_t evaluated, const char* rejection) {
  if (!isWatched()) {
    return;
  }
  EvaluatedTrajectory weighed;
  weighed.poses = trajectory.poses;
  weighed.twist = trajectory.velocity;
  weighed.total = static_cast<double>(total);
  for (std::size_t i = 0; i < evaluated; ++i) {
    weighed.scores.push_back(
        {critics_[i].name, static_cast<double>(rawScores_[i]), static_cast<double>(scales_[i])});
  }
  if (rejection != nullptr) {
    weighed.rejection = critics_[evaluated].name + ": " + rejection;
  }
  view_.trajectories.push_back(std::move(weighed));
}

}  // namespace sim2d::nav2
