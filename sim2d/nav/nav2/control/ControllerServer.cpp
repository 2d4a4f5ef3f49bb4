#include "sim2d/nav/nav2/control/ControllerServer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {
namespace {

/// The plugin of that name; without a name the only one. Null: none.
template <class T>
T* findPlugin(const ControllerServer::Named<T>& all, const std::string& name) {
  if (name.empty() && all.size() == 1) {
    return all.begin()->second.get();
  }
  const auto found = all.find(name);
  return found == all.end() ? nullptr : found->second.get();
}

}  // namespace

ControllerServer::ControllerServer(Setup setup)
    : parameters_(std::move(setup.parameters)),
      distro_(setup.distro),
      controllers_(std::move(setup.controllers)),
      goalCheckers_(std::move(setup.goalCheckers)),
      progressCheckers_(std::move(setup.progressCheckers)),
      pathHandlers_(std::move(setup.pathHandlers)) {}

void ControllerServer::follow(FollowPathGoal goal) {
  pending_ = std::move(goal);
  isCancelRequested_ = isCancelRequested_ && isRunning();
}

void ControllerServer::setSpeedLimit(double limit, bool isPercentage) {
  for (const auto& each : controllers_) {
    each.second->setSpeedLimit(limit, isPercentage);
  }
}

FollowFeedback ControllerServer::update(const ControlCycle& cycle) {
  FollowFeedback feedback;
  if (status_ != FollowStatus::Running) {
    if (!pending_) {
      return feedback;
    }
    status_ = FollowStatus::Running;
    waitsSince_.reset();
    const FollowPathGoal goal = *std::exchange(pending_, std::nullopt);
    if (!acceptGoal(goal, true, cycle.time, feedback)) {
      return feedback;
    }
  }
  feedback.status = FollowStatus::Running;
  if (isCancelRequested_ && (distro_ == Distro::Humble || controller_->cancel())) {
    pending_.reset();
    end(FollowStatus::Canceled, feedback);
    return feedback;
  }
  if (waitsForCostmap(cycle, feedback)) {
    return feedback;
  }
  if (pending_) {
    const FollowPathGoal goal = *std::exchange(pending_, std::nullopt);
    if (!acceptGoal(goal, false, cycle.time, feedback)) {
      return feedback;
    }
  }
  advance(cycle, feedback);
  return feedback;
}

/// Takes over a goal's path and plugins. Returns false on failure.
bool ControllerServer::acceptGoal(const FollowPathGoal& goal, bool isFirst, double time,
                                  FollowFeedback& feedback) {
  Controller* controller = findPlugin(controllers_, goal.controller);
  GoalChecker* goalChecker = findPlugin(goalCheckers_, goal.goalChecker);
  ProgressChecker* progressChecker = findPlugin(progressCheckers_, goal.progressChecker);
  PathHandler* handler = findPlugin(pathHandlers_, goal.pathHandler);
  if (controller == nullptr) {
    fail(ControllerError::InvalidController, "Failed to find controller name: " + goal.controller,
         feedback);
  } else if (goalChecker == nullptr) {
    fail(ControllerError::Unknown, "Failed to find goal checker name: " + goal.goalChecker,
         feedback);
  } else if (progressChecker == nullptr) {
    fail(ControllerError::Unknown, "Failed to find progress checker name: " + goal.progressChecker,
         feedback);
  } else if (distro_ >= Distro::Lyrical && handler == nullptr) {
    fail(ControllerError::Unknown, "Failed to find path handler name: " + goal.pathHandler,
         feedback);
  } else if (goal.path.empty()) {
    fail(ControllerError::InvalidPath, "Path is empty.", feedback);
  } else {
    const bool isOtherChecker = progressChecker != progressChecker_;
    controller_ = controller;
    goalChecker_ = goalChecker;
    progressChecker_ = progressChecker;
    pathHandler_ = handler;
    controller_->setPlan(goal.path);
    if (pathHandler_ != nullptr) {
      pathHandler_->setPlan(goal.path);
    }
    goal_ = goal.path.back();
    goalChecker_->reset();
    if (isFirst || isOtherChecker) {
      progressChecker_->reset();
    }
    lastValid_ = isFirst ? time : lastValid_;
    return true;
  }
  return false;
}

/// After a clear, no command is computed until the next update. Returns true if the cycle ends.
bool ControllerServer::waitsForCostmap(const ControlCycle& cycle, FollowFeedback& feedback) {
  if (cycle.isCostmapCurrent) {
    waitsSince_.reset();
    return false;
  }
  waitsSince_ = waitsSince_.value_or(cycle.time);
  if (distro_ != Distro::Humble && cycle.time - *waitsSince_ > parameters_.costmapUpdateTimeout) {
    fail(ControllerError::ControllerTimedOut, "Costmap timed out waiting for update", feedback);
  }
  return true;
}

void ControllerServer::advance(const ControlCycle& cycle, FollowFeedback& feedback) {
  const BodyTwist speed = thresholded(cycle.speed);
  LocalPlan local;
  const Path* cut = nullptr;
  double length = 0.0;
  if (distro_ >= Distro::Lyrical) {
    local = pathHandler_->localPlan(cycle.robot, cycle.costmap, cycle.planFrame);
    if (local.problem != nullptr) {
      fail(ControllerError::InvalidPath, local.problem, feedback);
      return;
    }
    cut = &local.poses;
    length = pathLength(local.poses);
  }
  if (distro_ != Distro::Humble && isGoalReached(cycle, speed, length, cut)) {
    end(FollowStatus::Succeeded, feedback);
    return;
  }
  if (!progressChecker_->check(cycle.robot, cycle.time)) {
    fail(ControllerError::FailedToMakeProgress, "Failed to make progress", feedback);
    return;
  }
  command(cycle, speed, cut, feedback);
  if (distro_ == Distro::Humble && status_ == FollowStatus::Running &&
      isGoalReached(cycle, speed, length, cut)) {
    end(FollowStatus::Succeeded, feedback);
  }
}

bool ControllerServer::isGoalReached(const ControlCycle& cycle, const BodyTwist& speed,
                                     double length, const Path* local) {
  return goalChecker_->isGoalReached(
      {cycle.robot, toParent(cycle.planFrame, goal_), speed, length, local});
}

void ControllerServer::command(const ControlCycle& cycle, const BodyTwist& speed, const Path* local,
                               FollowFeedback& feedback) {
  const ControlInput input{cycle.robot,   speed,      cycle.costmap, cycle.shape,
                           *goalChecker_, cycle.time, local,         cycle.planFrame};
  ControlResult control = controller_->computeVelocityCommands(input);
  if (control) {
    lastValid_ = cycle.time;
    feedback.command = control.twist;
    return;
  }
  handleFailure(std::move(control), cycle.time, feedback);
}

/// Patience: sends zero until valid commands have been missing for too long. Since Jazzy, failures
/// other than NoValidControl end the goal immediately; Humble does not distinguish failures.
void ControllerServer::handleFailure(ControlResult control, double time, FollowFeedback& feedback) {
  const double tolerance = parameters_.failureTolerance;
  const bool isBearable =
      distro_ == Distro::Humble || control.code == ControllerError::NoValidControl;
  const bool isForEver = tolerance == -1.0;
  if (!isBearable || !(tolerance > 0.0 || isForEver)) {
    fail(control.code, std::move(control.words), feedback);
  } else if (!isForEver && time - lastValid_ > tolerance) {
    fail(ControllerError::PatienceExceeded, "Controller patience exceeded", feedback);
  } else {
    feedback.command = BodyTwist();
    feedback.words = std::move(control.words);
    feedback.isFailureTolerated = true;
  }
}

void ControllerServer::fail(ControllerError code, std::string words, FollowFeedback& feedback) {
  end(FollowStatus::Failed, feedback);
  feedback.code = code;
  feedback.words = std::move(words);
}

void ControllerServer::end(FollowStatus status, FollowFeedback& feedback) {
  status_ = FollowStatus::Idle;
  isCancelRequested_ = false;
  feedback.status = status;
  if (parameters_.publishesZeroVelocity) {
    feedback.command = BodyTwist();
  }
  if (distro_ != Distro::Humble) {
    for (const auto& each : controllers_) {
      each.second->reset();
    }
  }
}

BodyTwist ControllerServer::thresholded(const BodyTwist& speed) const {
  const auto above = [](double v, double threshold) { return std::abs(v) > threshold ? v : 0.0; };
  return {above(speed.linear, parameters_.minXVelocity),
          above(speed.angular, parameters_.minThetaVelocity),
          above(speed.lateral, parameters_.minYVelocity)};
}

namespace {

constexpr char kFeasibleHandler[] = "nav2_controller::FeasiblePathHandler";

/// A kind of plugin that the server loads.
struct PluginSlot {
  std::vector<std::string> names;  // instance names
  std::string defaultName;         // the default of the list
  std::string defaultPlugin;       // default class of that instance
};

struct ServerSlots {
  PluginSlot controllers, goalCheckers, progressCheckers, pathHandlers;
};

ServerSlots slotsOf(const ControllerServerParameters& p, Distro distro) {
  ServerSlots slots;
  slots.controllers = {p.controllers, "FollowPath", "dwb_core::DWBLocalPlanner"};
  slots.goalCheckers = {p.goalCheckers, "goal_checker", "nav2_controller::SimpleGoalChecker"};
  slots.progressCheckers = {p.progressCheckers, "progress_checker",
                            "nav2_controller::SimpleProgressChecker"};
  if (distro == Distro::Humble) {
    slots.progressCheckers.names = {p.progressChecker};
  }
  if (distro >= Distro::Lyrical) {
    slots.pathHandlers = {p.pathHandlers, "PathHandler", kFeasibleHandler};
  }
  return slots;
}

/// The values given below a name.
Nav2ParameterBlock subBlock(const Nav2ParameterBlock& node, const std::string& name) {
  Nav2ParameterBlock block;
  const std::string prefix = name + ".";
  for (auto at = node.lower_bound(prefix); at != node.end() && base::startsWith(at->first, prefix);
       ++at) {
    block.emplace(at->first.substr(prefix.size()), at->second);
  }
  return block;
}

/// The class of an instance; empty: not given.
std::string pluginOf(const PluginSlot& slot, const std::string& name,
                     const Nav2ParameterBlock& block) {
  const auto given = block.find("plugin");
  if (given != block.end()) {
    const auto* text = std::get_if<std::string>(&given->second);
    return text != nullptr ? *text : "";
  }
  const bool isDefault = slot.names.size() == 1 && name == slot.defaultName;
  return isDefault ? slot.defaultPlugin : "";
}

/// Creates all instances of a slot by `make(plugin, name, block)`.
template <class T, class Make>
void makeSlot(const PluginSlot& slot, const Nav2ParameterBlock& node, base::Diagnostics& problems,
              ControllerServer::Named<T>& made, Make make) {
  for (const std::string& name : slot.names) {
    const Nav2ParameterBlock block = subBlock(node, name);
    const std::string plugin = pluginOf(slot, name, block);
    if (plugin.empty()) {
      problems.push_back(base::error("nav2.missing-key", {name + ".plugin"}));
      continue;
    }
    base::Result<std::unique_ptr<T>> one = make(plugin, name, block);
    for (const base::Diagnostic& problem : one.diagnostics()) {
      problems.push_back(base::withContext(name, problem));
    }
    if (one) {
      made[name] = *std::move(one);
    }
  }
}

base::Result<std::unique_ptr<PathHandler>> makePathHandler(const std::string& plugin,
                                                           const Nav2ParameterBlock& block) {
  if (normalizedPluginClass(plugin) != kFeasibleHandler) {
    return unknownPlugin(plugin, {kFeasibleHandler});
  }
  base::Diagnostics problems;
  PathPruning pruning =
      applyBlock(PathPruning(), feasiblePathHandlerKeys(), block, Distro::Main, problems);
  pruning.keepsLastTwo = true;
  if (base::hasErrors(problems)) {
    return problems;
  }
  return std::make_unique<PathHandler>(pruning);
}

/// Keys of the plugins of a slot; `keysOf(plugin, block)` returns those of one plugin.
template <class KeysOf>
void addSlotKeys(const PluginSlot& slot, const Nav2ParameterBlock& given, Nav2KeyTable& keys,
                 KeysOf keysOf) {
  for (const std::string& name : slot.names) {
    const Nav2ParameterBlock block = subBlock(given, name);
    const std::string plugin = pluginOf(slot, name, block);
    keys.rows.push_back({name + ".plugin", Nav2Value(plugin), "", "class of the plugin"});
    Nav2KeyTable inner = keysOf(plugin, block);
    for (Nav2KeyTable::Row& row : inner.rows) {
      row.name = name + "." + row.name;
      keys.rows.push_back(std::move(row));
    }
    for (Nav2KeyTable::Ignored& ignored : inner.ignored) {
      ignored.name = name + "." + ignored.name;
      keys.ignored.push_back(std::move(ignored));
    }
  }
}

/// Removes the problems that result from an invalid frequency.
base::Diagnostics withoutFrequencyProblems(base::Diagnostics problems) {
  problems.erase(std::remove_if(problems.begin(), problems.end(),
                                [](const base::Diagnostic& problem) {
                                  return problem.code == "nav2.mppi-period" ||
                                         problem.code == "nav2.mppi-no-shift";
                                }),
                 problems.end());
  return problems;
}

void makePlugins(const ServerSlots& slots, const Nav2ParameterBlock& node,
                 const ControllerSetup& common, ControllerServer::Setup& made,
                 base::Diagnostics& problems) {
  makeSlot(
      slots.controllers, node, problems, made.controllers,
      [&](const std::string& plugin, const std::string& name, const Nav2ParameterBlock& block) {
        ControllerSetup setup = common;
        setup.name = name;
        setup.block = block;
        return makeController(plugin, setup);
      });
  makeSlot(slots.goalCheckers, node, problems, made.goalCheckers,
           [&](const std::string& plugin, const std::string&, const Nav2ParameterBlock& block) {
             return makeGoalChecker(plugin, common.distro, block);
           });
  makeSlot(slots.progressCheckers, node, problems, made.progressCheckers,
           [&](const std::string& plugin, const std::string&, const Nav2ParameterBlock& block) {
             return makeProgressChecker(plugin, common.distro, block);
           });
  makeSlot(slots.pathHandlers, node, problems, made.pathHandlers,
           [](const std::string& plugin, const std::string&, const Nav2ParameterBlock& block) {
             return makePathHandler(plugin, block);
           });
}

}  // namespace

const std::vector<Nav2Key<ControllerServerParameters>>& controllerServerKeys() {
  using P = ControllerServerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"controller_frequency", &P::frequency, "Hz", "commands per second"},
      {"min_x_velocity_threshold", &P::minXVelocity, "m/s", "lower forward speeds count as 0"},
      {"min_y_velocity_threshold", &P::minYVelocity, "m/s", "lower lateral speeds count as 0"},
      {"min_theta_velocity_threshold", &P::minThetaVelocity, "rad/s",
       "lower turn rates count as 0"},
      {"failure_tolerance", &P::failureTolerance, "s",
       "maximum time without a valid command, during which the robot stands still; 0: none, -1: "
       "unlimited"},
      {"costmap_update_timeout", &P::costmapUpdateTimeout, "s",
       "maximum wait for the costmap after it was cleared", kSinceJazzy},
      {"publish_zero_velocity", &P::publishesZeroVelocity, "",
       "sends zero velocity at the end of a goal"},
      {"progress_checker_plugin", &P::progressChecker, "", "name of the progress checker", kHumble},
      {"progress_checker_plugins", &P::progressCheckers, "", "names of the progress checkers",
       kSinceJazzy},
      {"goal_checker_plugins", &P::goalCheckers, "", "names of the goal checkers"},
      {"controller_plugins", &P::controllers, "", "names of the controllers"},
      {"path_handler_plugins", &P::pathHandlers, "", "names of the path handlers", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredControllerServerKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"speed_limit_topic", "speed filters set the limits directly"},
      {"odom_topic", "ROS topics are not used"},
      {"odom_duration", "the measured speed is that of the time step", kSinceLyrical},
      {"search_window", "only used for the feedback of the action", kSinceLyrical},
  };
  return kKeys;
}

Nav2KeyTable controllerServerNodeKeys(const Nav2ParameterBlock& given, Distro distro) {
  Nav2KeyTable keys = keyTableOf(controllerServerKeys(), ControllerServerParameters(),
                                 ignoredControllerServerKeys());
  base::Diagnostics ignored;  // reported by makeControllerServer
  const ServerSlots slots = slotsOf(
      applyBlock(ControllerServerParameters(), controllerServerKeys(), given, distro, ignored),
      distro);
  addSlotKeys(slots.controllers, given, keys, [&](const std::string& plugin, const auto& block) {
    const ControllerType* type = findController(plugin);
    return type == nullptr ? Nav2KeyTable() : type->keys(block, distro);
  });
  addSlotKeys(slots.goalCheckers, given, keys,
              [](const std::string& plugin, const auto&) { return goalCheckerKeysOf(plugin); });
  addSlotKeys(slots.progressCheckers, given, keys, [](const std::string&, const auto&) {
    return keyTableOf(progressCheckerKeys(), ProgressCheckerParameters());
  });
  addSlotKeys(slots.pathHandlers, given, keys, [](const std::string&, const auto&) {
    return keyTableOf(feasiblePathHandlerKeys(), PathPruning());
  });
  return keys;
}

base::Result<std::unique_ptr<ControllerServer>> makeControllerServer(const Nav2ParameterBlock& node,
                                                                     Distro distro,
                                                                     std::uint64_t seed,
                                                                     int robotId) {
  base::Diagnostics problems;
  ControllerServer::Setup made;
  made.distro = distro;
  made.parameters =
      applyBlock(ControllerServerParameters(), controllerServerKeys(), node, distro, problems);
  constexpr double kMaxFrequency = 1000.0;  // [Hz]
  const bool isRate = ParameterChecks(problems).within(
      "controller_frequency", made.parameters.frequency, {0.0, kMaxFrequency, true},
      "above 0, up to " + base::formatDouble(kMaxFrequency));
  if (!isRate) {
    made.parameters.frequency = 20.0;
  }
  ControllerSetup common;
  common.distro = distro;
  common.frequency = made.parameters.frequency;
  common.seed = seed;
  common.robotId = robotId;
  makePlugins(slotsOf(made.parameters, distro), node, common, made, problems);
  if (base::hasErrors(problems)) {
    return isRate ? problems : withoutFrequencyProblems(std::move(problems));
  }
  return {std::make_unique<ControllerServer>(std::move(made)), std::move(problems)};
}

}  // namespace sim2d::nav2
