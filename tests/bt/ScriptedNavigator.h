#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/Program.h"
#include "bt/engine/TreeState.h"
#include "bt/robot/NavigatorHost.h"
#include "bt/robot/RobotNodes.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

/// A navigator whose servers do as a script says: each request takes `steps` ticks and ends as
/// told.
namespace navigator {

using base::NodeStatus;
using bt::RobotAction;
using sim2d::nav2::Distro;
using sim2d::nav2::Path;
using State = bt::RobotOutcome::State;
using Steps = std::vector<long long>;

inline constexpr NodeStatus kSuccess = NodeStatus::Success;
inline constexpr NodeStatus kFailure = NodeStatus::Failure;
inline constexpr NodeStatus kRunning = NodeStatus::Running;

/// The actions as the log has them, in their order.
inline constexpr std::array<const char*, bt::kRobotActions> kActionNames = {
    "plan",    "through",       "follow", "smooth", "spin",   "backup", "heading", "wait",
    "to-pose", "through-poses", "route",  "track",  "teleop", "dock",   "undock",  "object"};

struct Answer {
  State state = State::Succeeded;
  int errorCode = 0;
  int steps = 1;  // ticks after the one of the request; 0: never ends
};

class Scripted : public bt::NavigatorHost {
 public:
  explicit Scripted(Distro distro = Distro::Humble) : distro_(distro) {
    goal = paths().add({{{10.0, 0.0}, 0.0}});
  }

  std::map<RobotAction, std::vector<Answer>> script;  // the last one repeats
  std::vector<std::string> log;                       // requests, "plan@1": in step 1
  base::Pose2 place;
  double driven = 0.0;  // speed [m/s]
  bool pathIsValid = true;
  bt::PathId goal = 0;
  int recoveries = 0;
  long long step = 0;
  double nextLength = 10.0;                             // [m] of the paths that are planned
  double braking = 0.0;                                 // acceleration [m/s²]
  Path collisions;                                      // of a path that is not valid
  std::map<double, std::optional<std::uint8_t>> costs;  // by x of the pose; absent: 0
  sim2d::nav2::TrackingFeedback tracked;
  bt::NavigatorTopics topics;
  mutable bt::PathCheck lastCheck;
  int lastReached = -1;        // of a path through poses
  bt::RouteProgress progress;  // of a route
  bt::RobotRequest last;       // of the last request
  bool hasPose = true, hasLocalizer = true;
  sim2d::nav2::FrameNames frames;
  std::optional<sim2d::BatteryState> charge;

  Distro distro() const override { return distro_; }
  base::Pose2 pose() const override { return place; }
  double speed() const override { return driven; }
  std::optional<sim2d::BatteryState> battery() const override { return charge; }
  double goalReachedTolerance() const override { return 0.25; }
  double time() const override { return 0.05 * static_cast<double>(step); }
  sim2d::BodyTwist motion() const override { return {driven, 0.0, 0.0}; }
  double acceleration() const override { return braking; }
  bt::PathCheckResult checkPath(const bt::PathCheck& check) const override {
    lastCheck = check;
    const bool isValid = pathIsValid && !paths().get(check.path).empty();
    return {isValid, isValid ? Path() : collisions};
  }
  std::optional<std::uint8_t> costAt(bool /*local*/, const base::Pose2& pose,
                                     bool /*footprint*/) const override {
    const auto found = costs.find(pose.position.x());
    return found == costs.end() ? std::optional<std::uint8_t>(0) : found->second;
  }
  sim2d::nav2::TrackingFeedback tracking() const override { return tracked; }
  void enableCollisionMonitor(bool isOn) override {
    log.push_back(isOn ? "monitor-on" : "monitor-off");
  }
  bt::TopicMessage lastMessage(const std::string& topic) const override {
    return topics.lastOf(topic, time());
  }
  void begin(RobotAction action, const bt::RobotRequest& request) override {
    log.push_back(kActionNames.at(static_cast<std::size_t>(action)));
    steps_[action] = step;
    last = request;
    std::vector<Answer>& answers = script[action];
    if (answers.empty()) {
      answers.push_back({});
    }
    running_[action] = answers.front();
    if (answers.size() > 1) {
      answers.erase(answers.begin());
    }
    const bool plans = action == RobotAction::ComputePath ||
                       action == RobotAction::ComputePathThroughPoses ||
                       action == RobotAction::SmoothPath || action == RobotAction::ComputeRoute;
    if (plans && running_[action].state == State::Succeeded) {
      planned_[action] = paths().add({{{10.0 - nextLength, 0.0}, 0.0}, {{10.0, 0.0}, 0.0}});
    }
  }
  bt::RobotOutcome outcome(RobotAction action) const override {
    const Answer& answer = running_.at(action);
    bt::RobotOutcome result;
    result.progress = progress;
    const bool isOver = answer.steps > 0 && step - steps_.at(action) >= answer.steps;
    if (isOver || answer.state == State::Cancelled) {
      result.state = answer.state;
      result.errorCode = answer.errorCode;
      result.errorText = answer.errorCode == 0 ? "" : "as the script has it";
      result.lastReached = lastReached;
      const auto path = planned_.find(action);
      result.path = path == planned_.end() ? 0 : path->second;
    }
    return result;
  }
  void cancel(RobotAction action) override {
    log.push_back("cancel");
    running_[action].state = State::Cancelled;
  }
  bool clear(const bt::ClearRequest& request) override {
    log.push_back(request.isLocal ? "clear-local" : "clear-global");
    return true;
  }
  void countRecovery() override { ++recoveries; }
  bool isLocalized() const override { return hasPose; }
  bool canTransform(const std::string& parent, const std::string& child) const override {
    return frames.canTransform(parent, child, hasPose);
  }
  bool relocalize() override {
    log.push_back("relocalize");
    return hasLocalizer;
  }

  std::string text() const {
    std::string all;
    for (const std::string& word : log) {
      all += (all.empty() ? "" : " ") + word;
    }
    return all;
  }

 private:
  Distro distro_;
  std::map<RobotAction, Answer> running_;
  std::map<RobotAction, long long> steps_;
  std::map<RobotAction, bt::PathId> planned_;
};

inline bt::TreeTable tableOf(const std::string& nodes) {
  const std::string xml =
      "<root BTCPP_format=\"4\" main_tree_to_execute=\"T\"><BehaviorTree ID=\"T\">" + nodes +
      "</BehaviorTree></root>";
  const auto file = bt::readTreeText(xml);
  return file ? *bt::resolveIncludes(*file) : bt::TreeTable();
}

/// A tree with its navigator, ticked at 20 Hz.
template <class Host>
class PlayedBy {
 public:
  PlayedBy(const bt::TreeTable& table, Distro distro = Distro::Humble) : host(distro) {
    bt::CompileOptions options;
    options.hostEntries = {{"goal", bt::PortType::Any}, {"goals", bt::PortType::Any}};
    auto compiled = bt::compile(table, bt::robotNodes(), options);
    problems = compiled.diagnostics();
    if (compiled) {
      program = *compiled;
      state = std::make_unique<bt::TreeState>(program);
      setGoal(host.goal);
    }
  }

  explicit PlayedBy(const std::string& nodes, Distro distro = Distro::Humble)
      : PlayedBy(tableOf(nodes), distro) {}

  Host host;
  base::Diagnostics problems;
  std::shared_ptr<const bt::Program> program;
  std::unique_ptr<bt::TreeState> state;
  long long step = 0;

  void setGoal(bt::PathId goal) {
    host.goal = goal;
    state->set(program->hostSlot(0), static_cast<int>(goal));
    state->set(program->hostSlot(1), static_cast<int>(goal));
  }
  NodeStatus tick() {
    host.step = ++step;
    return state->tickOnce({step, 0.05, &host});
  }
  /// Until the root is done, at most so often.
  NodeStatus play(int most) {
    NodeStatus status = NodeStatus::Running;
    for (int i = 0; i < most && status == NodeStatus::Running; ++i) {
      status = tick();
    }
    return status;
  }
  /// The steps of `ticks` ticks in which `word` was asked for.
  Steps stepsOf(const std::string& word, int ticks) {
    Steps steps;
    for (int i = 0; i < ticks; ++i) {
      const std::size_t before = host.log.size();
      tick();
      for (std::size_t k = before; k < host.log.size(); ++k) {
        if (host.log[k] == word) {
          steps.push_back(step);
        }
      }
    }
    return steps;
  }
};
using Played = PlayedBy<Scripted>;

}  // namespace navigator
