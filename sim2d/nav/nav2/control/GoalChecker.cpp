#include "sim2d/nav/nav2/control/GoalChecker.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/PathGoalCheckers.h"

namespace sim2d::nav2 {
namespace {

using GoalCheckerKey = Nav2Key<GoalCheckerParameters>;

/// All three in one: what they test differs in a sentence.
class StockGoalChecker final : public GoalChecker {
 public:
  enum class Kind { Simple, Stopped, Position };
  StockGoalChecker(Kind kind, Distro distro, const GoalCheckerParameters& parameters)
      : kind_(kind), distro_(distro), parameters_(parameters) {}

  void reset() override { isXyLatched_ = false; }
  bool isGoalReached(const GoalQuery& query) override {
    if (!isXyReached(query)) {
      return false;
    }
    if (kind_ == Kind::Position) {
      return true;
    }
    return isYawReached(query) && (kind_ == Kind::Simple || isStopped(query.speed));
  }
  bool isXyReached(const GoalQuery& query) override {
    if (distro_ >= Distro::Lyrical && query.pathLength > parameters_.pathLengthTolerance) {
      return false;  // it only passes by
    }
    if (isXyLatched_) {
      return true;
    }
    const double tolerance = parameters_.xyTolerance;
    if ((query.robot.position - query.goal.position).squaredNorm() > tolerance * tolerance) {
      return false;
    }
    isXyLatched_ = parameters_.isStateful;
    return true;
  }
  double xyTolerance() const override { return parameters_.xyTolerance; }
  double yawTolerance() const override { return parameters_.yawTolerance; }

 private:
  bool isYawReached(const GoalQuery& query) const {
    const double turn = std::abs(base::angleDiff(query.goal.heading, query.robot.heading));
    const double tolerance = parameters_.yawTolerance;
    return turn <= tolerance || (parameters_.isSymmetric && base::kPi - turn <= tolerance);
  }
  bool isStopped(const BodyTwist& speed) const {
    return std::abs(speed.angular) <= parameters_.rotStoppedVelocity &&
           Vec2(speed.linear, speed.lateral).norm() <= parameters_.transStoppedVelocity;
  }

  Kind kind_;
  Distro distro_;
  GoalCheckerParameters parameters_;
  bool isXyLatched_ = false;
};

struct GoalCheckerType {
  const char* plugin;
  StockGoalChecker::Kind kind;
};
constexpr GoalCheckerType kGoalCheckers[] = {
    {"nav2_controller::SimpleGoalChecker", StockGoalChecker::Kind::Simple},
    {"nav2_controller::StoppedGoalChecker", StockGoalChecker::Kind::Stopped},
    {"nav2_controller::PositionGoalChecker", StockGoalChecker::Kind::Position},
    {"dwb_plugins::SimpleGoalChecker", StockGoalChecker::Kind::Simple},
    {"dwb_plugins::StoppedGoalChecker", StockGoalChecker::Kind::Stopped},
};

constexpr char kAxis[] = "nav2_controller::AxisGoalChecker";
constexpr char kAdaptive[] = "nav2_controller::AdaptiveToleranceGoalChecker";

/// A checker of the values of a block, or what is wrong with them.
template <class Parameters, class Make>
base::Result<std::unique_ptr<GoalChecker>> madeOf(const std::vector<Nav2Key<Parameters>>& table,
                                                  const Nav2Block& block, Distro distro,
                                                  Make make) {
  base::Diagnostics problems;
  const auto parameters = filled(Parameters(), table, block, distro, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {make(parameters), std::move(problems)};
}

}  // namespace

const std::vector<GoalCheckerKey>& goalCheckerKeys() {
  using P = GoalCheckerParameters;
  static const std::vector<GoalCheckerKey> kKeys = {
      {"xy_goal_tolerance", &P::xyTolerance, "m", "how far from the goal is there"},
      {"yaw_goal_tolerance", &P::yawTolerance, "rad", "how far from its heading is right"},
      {"stateful", &P::isStateful, "", "the place counts as reached until a new path"},
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "facing backwards is accepted too"},
      {"path_length_tolerance", &P::pathLengthTolerance, "m",
       "the goal is not reached while more of the local path is left", kSinceLyrical},
      {"rot_stopped_velocity", &P::rotStoppedVelocity, "rad/s",
       "slower counts as standing (StoppedGoalChecker)"},
      {"trans_stopped_velocity", &P::transStoppedVelocity, "m/s",
       "slower counts as standing (StoppedGoalChecker)"},
  };
  return kKeys;
}

const std::vector<IdleKey>& goalCheckerIdleKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"xy_goal_tolerance_buffer", "not re-implemented: it counts as 0", kSinceLyrical},
  };
  return kKeys;
}

Nav2Keys goalCheckerKeysOf(const std::string& plugin) {
  static const std::vector<std::pair<std::string, std::vector<std::string>>> kUnread = {
      {"SimpleGoalChecker", {"rot_stopped_velocity", "trans_stopped_velocity"}},
      {"StoppedGoalChecker", {}},
      {"PositionGoalChecker",
       {"yaw_goal_tolerance", "symmetric_yaw_tolerance", "rot_stopped_velocity",
        "trans_stopped_velocity"}}};
  Nav2Keys keys;
  addRows(keys, goalCheckerKeys(), GoalCheckerParameters());
  addIdle(keys, goalCheckerIdleKeys());
  const std::string name = pluginName(plugin);
  if (name == kAxis || name == kAdaptive) {
    Nav2Keys own;
    if (name == kAxis) {
      addRows(own, axisGoalKeys(), AxisGoalParameters());
    } else {
      addRows(own, adaptiveGoalKeys(), AdaptiveGoalParameters());
      addIdle(own, goalCheckerIdleKeys());
    }
    return own;
  }
  for (const auto& [type, unread] : kUnread) {
    const std::string end = "::" + type;
    if (name.size() < end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0) {
      continue;
    }
    keys.rows.erase(std::remove_if(keys.rows.begin(), keys.rows.end(),
                                   [&unread = unread](const Nav2Keys::Row& row) {
                                     return std::find(unread.begin(), unread.end(), row.name) !=
                                            unread.end();
                                   }),
                    keys.rows.end());
  }
  return keys;
}

std::vector<std::string> goalCheckerPlugins(Distro /*distro*/) {
  std::vector<std::string> names;
  for (const GoalCheckerType& type : kGoalCheckers) {
    names.emplace_back(type.plugin);
  }
  names.insert(names.end(), {kAxis, kAdaptive});
  return names;
}

base::Result<std::unique_ptr<GoalChecker>> makeGoalChecker(const std::string& plugin, Distro distro,
                                                           const Nav2Block& block) {
  if (pluginName(plugin) == kAxis) {
    return madeOf(axisGoalKeys(), block, distro, [distro](const AxisGoalParameters& parameters) {
      return makeAxisGoalChecker(parameters, distro);
    });
  }
  if (pluginName(plugin) == kAdaptive) {
    return madeOf(adaptiveGoalKeys(), block, distro, [](const AdaptiveGoalParameters& parameters) {
      return makeAdaptiveGoalChecker(parameters);
    });
  }
  for (const GoalCheckerType& type : kGoalCheckers) {
    if (pluginName(plugin) != type.plugin) {
      continue;
    }
    base::Diagnostics problems;
    const auto parameters =
        filled(GoalCheckerParameters(), goalCheckerKeys(), block, distro, problems);
    if (base::hasErrors(problems)) {
      return problems;
    }
    return {std::make_unique<StockGoalChecker>(type.kind, distro, parameters), std::move(problems)};
  }
  return unknownPlugin(plugin, goalCheckerPlugins(distro));
}

}  // namespace sim2d::nav2
