#include "sim2d/nav/nav2/control/dwb/DwbController.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"

namespace sim2d::nav2 {
namespace {

PathHandling dwbHandling(const DwbParameters& parameters) {
  PathHandling handling;
  handling.rule = PathHandling::Rule::Dwb;
  handling.prunesPlan = parameters.prunesPlan;
  handling.pruneDistance = parameters.pruneDistance;
  handling.forwardPruneDistance = parameters.forwardPruneDistance;
  handling.shortensPlan = parameters.shortensPlan;
  return handling;
}

}  // namespace

DwbController::DwbController(Setup setup)
    : parameters_(std::move(setup.parameters)),
      fullParameters_(parameters_),
      critics_(std::move(setup.critics)),
      generator_(setup.generator, setup.frequency),
      handler_(dwbHandling(parameters_)),
      scales_(critics_.size()),
      raws_(critics_.size()) {}

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

Control DwbController::computeVelocityCommands(const ControlInput& input) {
  LocalPlan local = handler_.localPlan(input);
  view_ = {};
  if (local.problem != nullptr) {
    return {ControlCode::InvalidPath, local.problem};
  }
  prepare(input, local.poses, input.fromPlan(goal_));
  view_.localPlan = std::move(local.poses);
  choose();
  const bool isLegal = best_.total >= 0.0F;
  const BodyTwist command = isLegal ? best_.trajectory.velocity : BodyTwist();
  for (const NamedCritic& each : critics_) {
    each.critic->debrief(command);
  }
  if (!isLegal) {
    return {ControlCode::NoValidControl,
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

void DwbController::choose() {
  best_.total = -1.0F;
  std::size_t chosen = 0;
  for (const BodyTwist& command : generator_.commands()) {
    generator_.generate(command, tried_);
    float total = 0.0F;
    if (weigh(tried_, best_.total, total) && (best_.total < 0.0F || total < best_.total)) {
      best_.total = total;
      std::swap(best_.trajectory, tried_);
      chosen = view_.trajectories.size() - 1;
    }
  }
  if (isWatched() && best_.total >= 0.0F) {
    view_.trajectories[chosen].isChosen = true;
  }
}

/// False: illegal. Sums in single precision, as Nav2's messages have it: of totals that differ less
/// the first wins there too.
bool DwbController::weigh(const DwbTrajectory& trajectory, float best, float& total) {
  std::size_t asked = 0;
  for (; asked < critics_.size(); ++asked) {
    raws_[asked] = 0.0F;
    if (scales_[asked] == 0.0F) {
      continue;
    }
    const DwbPrice price = critics_[asked].critic->price(trajectory);
    if (price.refusal != nullptr) {
      show(trajectory, -1.0F, asked, price.refusal);
      return false;
    }
    raws_[asked] = static_cast<float>(price.raw);
    total = static_cast<float>(static_cast<double>(total) +
                               price.raw * static_cast<double>(scales_[asked]));
    if (parameters_.shortCircuits && best > 0.0F && total > best) {
      ++asked;
      break;  // what is added is positive: it stays dearer
    }
  }
  show(trajectory, total, asked, nullptr);
  return true;
}

void DwbController::show(const DwbTrajectory& trajectory, float total, std::size_t asked,
                         const char* refusal) {
  if (!isWatched()) {
    return;
  }
  WeighedTrajectory weighed;
  weighed.poses = trajectory.poses;
  weighed.twist = trajectory.velocity;
  weighed.total = static_cast<double>(total);
  for (std::size_t i = 0; i < asked; ++i) {
    weighed.scores.push_back(
        {critics_[i].name, static_cast<double>(raws_[i]), static_cast<double>(scales_[i])});
  }
  if (refusal != nullptr) {
    weighed.refusal = critics_[asked].name + ": " + refusal;
  }
  view_.trajectories.push_back(std::move(weighed));
}

}  // namespace sim2d::nav2
