#include <algorithm>
#include <cmath>
#include <utility>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/FrameTransform.h"
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
  const auto fail = [&](PlanError error) {
    finish(action, codeOf(action, error), 0, planErrorWords(error));
  };
  if (!global_->isCurrent() || global_->updates() == 0) {
    fail(PlanError::Timeout);
    return;
  }
  if (!isLocalized()) {
    fail(PlanError::TfError);
    return;
  }
  GlobalPlanner* const planner = namedOne(planners_, asked.request.server);
  const Path& goals = paths().get(asked.request.path);
  if (planner == nullptr || goals.empty()) {
    fail(planner == nullptr ? PlanError::InvalidPlanner : PlanError::NoValidPath);
    return;
  }
  const Path& starts = paths().get(asked.request.start.value_or(0));
  const base::Pose2 start = starts.empty() ? observation_->pose : starts.front();
  ThroughPosesResult plan = planPath(*planner, action, asked.request, start);
  if (plan.error == PlanError::None && plan.path.empty()) {
    plan.error = PlanError::NoValidPath;
  }
  if (plan.error != PlanError::None) {
    fail(plan.error);
    return;
  }
  hasReplanned_ = hasReplanned_ || hasPlanned_;
  counts_.replans += hasPlanned_ ? 1 : 0;
  hasPlanned_ = true;
  informCostmaps(plan.path);
  finish(action, 0, paths().add(std::move(plan.path)));
  result(action).lastReached = plan.reached;
}

/// Layers may depend on the plan, each in the frame of its costmap.
void Nav2Servers::informCostmaps(const Path& plan) {
  global_->setPlan(plan);
  Path local = plan;
  for (base::Pose2& pose : local) {
    pose = sim2d::toFrame(localFrame(), pose);
  }
  local_->setPlan(local);
}

/// To one goal, through the poses on the way to it if there are some, or through all goals.
ThroughPosesResult Nav2Servers::planPath(GlobalPlanner& planner, RobotAction action,
                                         const RobotRequest& request, const base::Pose2& start) {
  Path goals = paths().get(request.path);
  if (action == RobotAction::ComputePath) {
    Path via = paths().get(request.viaPoints);
    if (via.empty()) {
      PlanResult plan = planner.plan(planRequest(start, goals.back()));
      return {plan.error, std::move(plan.path), 0, true};
    }
    via.push_back(goals.back());
    return planThroughPoses(planner, planRequest(start, via.back()), via, false);
  }
  return planThroughPoses(planner, planRequest(start, goals.back()), goals,
                          setup_.parameters.plannerServer.allowPartialPlanning);
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
    finish(RobotAction::SmoothPath, static_cast<int>(SmoothError::InvalidSmoother), 0,
           smoothErrorWords(SmoothError::InvalidSmoother));
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
         isFine ? paths().add(std::move(smoothed.path)) : 0, smoothErrorWords(smoothed.error));
  result(RobotAction::SmoothPath).wasCompleted = smoothed.wasCompleted;
}

}  // namespace bt
