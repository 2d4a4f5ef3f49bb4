#include "sim2d/nav/nav2/control/GoalChecker.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"

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
  unsigned distros;
};
constexpr GoalCheckerType kGoalCheckers[] = {
    {"nav2_controller::SimpleGoalChecker", StockGoalChecker::Kind::Simple, kEveryDistro},
    {"nav2_controller::StoppedGoalChecker", StockGoalChecker::Kind::Stopped, kEveryDistro},
    {"nav2_controller::PositionGoalChecker", StockGoalChecker::Kind::Position, kEveryDistro},
};

}  // namespace

const std::vector<GoalCheckerKey>& goalCheckerKeys() {
  using P = GoalCheckerParameters;
  static const std::vector<GoalCheckerKey> kKeys = {
      {"xy_goal_tolerance", &P::xyTolerance, "m", "how far from the goal is there"},
      {"yaw_goal_tolerance", &P::yawTolerance, "rad", "how far from its heading is right"},
      {"stateful", &P::isStateful, "", "the place counts as reached until a new path"},
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "backwards is as good"},
      {"path_length_tolerance", &P::pathLengthTolerance, "m",
       "nothing is reached while more of the local path is left", kSinceLyrical},
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

std::vector<std::string> goalCheckerPlugins(Distro distro) {
  std::vector<std::string> names;
  for (const GoalCheckerType& type : kGoalCheckers) {
    if (isIn(type.distros, distro)) {
      names.emplace_back(type.plugin);
    }
  }
  return names;
}

base::Result<std::unique_ptr<GoalChecker>> makeGoalChecker(const std::string& plugin, Distro distro,
                                                           const Nav2Block& block) {
  for (const GoalCheckerType& type : kGoalCheckers) {
    if (pluginName(plugin) != type.plugin || !isIn(type.distros, distro)) {
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
