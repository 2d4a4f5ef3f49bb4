#include <utility>

#include "bt/robot/Nav2Servers.h"

namespace bt {
namespace {

using base::NodeStatus;
using State = RobotOutcome::State;

}  // namespace

std::shared_ptr<const Program> NavigatorTrees::find(RobotAction action,
                                                    const std::string& name) const {
  if (name.empty()) {
    return action == RobotAction::NavigateToPose ? toPose : throughPoses;
  }
  const auto found = byName.find(name);
  return found == byName.end() ? nullptr : found->second;
}

std::int64_t addPendingWaypoints(NavigatorHost& host, const sim2d::nav2::Path& goals) {
  Waypoints pending;
  pending.reserve(goals.size());
  for (const base::Pose2& goal : goals) {
    pending.push_back({goal, Waypoint::Status::Pending});
  }
  return host.waypoints().add(std::move(pending));
}

NestedNavigation::NestedNavigation(RobotAction action, std::shared_ptr<const Program> program,
                                   PathId goals, std::int64_t waypoints)
    : action_(action), goals_(goals), tree_(std::move(program)) {
  tree_.set(tree_.program().hostSlot(0), static_cast<int>(goals));
  tree_.set(tree_.program().hostSlot(1), static_cast<int>(goals));
  tree_.set(tree_.program().hostSlot(2), 0);
  tree_.set(tree_.program().hostSlot(3), static_cast<int>(waypoints));
}

NodeStatus NestedNavigation::tick(NavigatorHost& host, double dt) {
  const NodeStatus status = tree_.tickOnce({++step_, dt, &host});
  return tree_.fault() != nullptr ? NodeStatus::Failure : status;
}

void NestedNavigation::halt(NavigatorHost& host, double dt) {
  tree_.halt({step_, dt, &host});
}

std::string NestedNavigation::fault() const {
  const TreeFault* const fault = tree_.fault();
  return fault != nullptr ? fault->path + ": " + fault->message : std::string();
}

// Execution by the servers

void Nav2Servers::beginNavigation(RobotAction action, const RobotRequest& request) {
  const auto refuse = [&](RobotOutcome& outcome, NavigationError error, std::string why) {
    outcome = {};
    outcome.state = State::Failed;
    outcome.errorCode = navigationCode(action, error);
    outcome.errorText = std::move(why);
    noteFailure(action, outcome.errorCode);
  };
  if (isNavigating_) {
    refuse(result(action), NavigationError::Unknown,
           "a nested navigation cannot start another navigation");
    return;
  }
  endNavigation();
  const auto program = setup_.trees.find(action, request.tree);
  const sim2d::nav2::Path& goals = paths().get(request.path);
  if (program == nullptr) {
    refuse(navigated_, NavigationError::FailedToLoadTree, "no such tree: " + request.tree);
  } else if (goals.empty()) {
    refuse(navigated_, NavigationError::Unknown, "there is no goal");
  } else {
    navigated_ = {};
    navigation_.emplace(action, program, request.path, addPendingWaypoints(*this, goals));
    navigation_->recordResults(nestedResults_);
  }
}

void Nav2Servers::navigate() {
  if (!navigation_) {
    return;
  }
  isNavigating_ = true;
  const NodeStatus status = navigation_->tick(*this, observation_->dt);
  isNavigating_ = false;
  if (status == NodeStatus::Success) {
    navigated_.state = State::Succeeded;
  } else if (status == NodeStatus::Failure) {
    navigated_.state = State::Failed;
    navigated_.errorCode = navigationCode(navigation_->action(), NavigationError::Unknown);
    navigated_.errorText = navigation_->fault();
    noteFailure(navigation_->action(), navigated_.errorCode);
  }
  if (status == NodeStatus::Success || status == NodeStatus::Failure) {
    endNavigation();
  }
}

void Nav2Servers::endNavigation() {
  if (navigation_) {
    isNavigating_ = true;
    navigation_->halt(*this, observation_->dt);
    isNavigating_ = false;
    navigation_.reset();
  }
}

}  // namespace bt
