#include <algorithm>
#include <cmath>
#include <utility>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/costmap/FootprintCost.h"
#include "sim2d/nav/nav2/global/PlannerServer.h"

// What the planner and the smoother server do when they are asked.
namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

/// What the action reports for an error of its planner.
int codeOf(RobotAction action, PlanError error) {
  const int code = static_cast<int>(error);
  return action == RobotAction::ComputePathThroughPoses ? throughPosesCode(code) : code;
}

/// The only one may be left without a name. Null: there is none.
template <class T>
T* namedOne(const std::map<std::string, std::unique_ptr<T>>& all, const std::string& name) {
  if (name.empty() && all.size() == 1) {
    return all.begin()->second.get();
  }
  const auto found = all.find(name);
  return found == all.end() ? nullptr : found->second.get();
}

}  // namespace

/// After a clear, until the next update: Humble waits for ever, the others give up.
bool Nav2Servers::waitsForCostmap(Asked& asked) {
  if (global_->isCurrent() && global_->updates() > 0) {
    return false;
  }
  asked.waitsSince = asked.waitsSince < 0.0 ? time_ : asked.waitsSince;
  const double longest = setup_.parameters.plannerServer.costmapUpdateTimeout;
  return distro() == Distro::Humble || time_ - asked.waitsSince <= longest;
}

PlanRequest Nav2Servers::planRequest(const base::Pose2& from, const base::Pose2& to) const {
  PlanRequest request(global_->costmap(), from, to);
  const CostmapFootprint& footprint = global_->footprint();
  if (!footprint.isRadius) {
    request.footprint = footprint.corners;
  }
  if (const auto law = global_->inflation()) {
    request.circumscribedCost = law->cost(footprint.circumscribed);
  }
  return request;
}

void Nav2Servers::planIfAsked(RobotAction action) {
  Asked& request = asked(action);
  const auto latency = static_cast<std::int64_t>(setup_.latencies.planner);
  if (request.isWaiting && step_ - request.step >= latency && !waitsForCostmap(request)) {
    planNow(action, request);
  }
}

void Nav2Servers::planNow(RobotAction action, Asked& asked) {
  if (!global_->isCurrent()) {
    finish(action, codeOf(action, PlanError::Timeout));
    return;
  }
  if (!isLocalized()) {
    finish(action, static_cast<int>(PlanError::TfError));
    ++counts_.planFailures;
    return;
  }
  GlobalPlanner* const planner = namedOne(planners_, asked.request.server);
  const Path& goals = paths().get(asked.request.path);
  const Path& starts = paths().get(asked.request.start.value_or(0));
  const base::Pose2 start = starts.empty() ? observation_->pose : starts.front();
  PlanError error = PlanError::InvalidPlanner;
  Path path;
  if (planner != nullptr && goals.empty()) {
    error = PlanError::NoValidPath;
  } else if (planner != nullptr && action == RobotAction::ComputePath) {
    PlanResult plan = planner->plan(planRequest(start, goals.back()));
    error = plan.error;
    path = std::move(plan.path);
  } else if (planner != nullptr) {
    ThroughPosesResult plan =
        planThroughPoses(*planner, planRequest(start, goals.back()), goals,
                         setup_.parameters.plannerServer.allowPartialPlanning);
    error = plan.error;
    path = std::move(plan.path);
  }
  if (error == PlanError::None && path.empty()) {
    error = PlanError::NoValidPath;
  }
  if (error != PlanError::None) {
    finish(action, codeOf(action, error));
    return;
  }
  hasReplanned_ = hasReplanned_ || hasPlanned_;
  counts_.replans += hasPlanned_ ? 1 : 0;
  hasPlanned_ = true;
  local_->setPlan(path);
  global_->setPlan(path);
  finish(action, 0, paths().add(std::move(path)));
}

void Nav2Servers::smoothIfAsked() {
  Asked& request = asked(RobotAction::SmoothPath);
  if (request.isWaiting) {
    smoothNow(request.request);
  }
}

/// Smoothers look at the published global costmap.
void Nav2Servers::smoothNow(const RobotRequest& request) {
  const PathSmoother* const smoother = namedOne(smoothers_, request.server);
  if (smoother == nullptr) {
    finish(RobotAction::SmoothPath, static_cast<int>(SmoothError::InvalidSmoother));
    return;
  }
  const Path& path = paths().get(request.path);
  SmoothResult smoothed = path.empty()
                              ? SmoothResult{SmoothError::InvalidPath, {}, false}
                              : smoother->smooth(path, global_->published(), request.timeAllowance);
  if (smoothed.error == SmoothError::None && request.checksCollisions) {
    const bool isHit =
        std::any_of(smoothed.path.begin(), smoothed.path.end(), [&](const base::Pose2& place) {
          return isInCollision(global_->published(), global_->footprint(), place, true);
        });
    smoothed.error = isHit ? SmoothError::SmoothedPathInCollision : smoothed.error;
  }
  const bool isFine = smoothed.error == SmoothError::None;
  finish(RobotAction::SmoothPath, static_cast<int>(smoothed.error),
         isFine ? paths().add(std::move(smoothed.path)) : 0);
  result(RobotAction::SmoothPath).wasCompleted = smoothed.wasCompleted;
}

}  // namespace bt
