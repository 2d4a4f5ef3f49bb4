#include "sim2d/nav/nav2/control/GoalCheckers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"

namespace sim2d::nav2 {
namespace {

template <class Parameters>
bool isYawReached(const Parameters& parameters, const GoalQuery& query) {
  const double turn = std::abs(base::angleDiff(query.goal.heading, query.robot.heading));
  const double tolerance = parameters.yawTolerance;
  return turn <= tolerance || (parameters.isSymmetric && base::kPi - turn <= tolerance);
}

template <class Parameters>
bool isStopped(const Parameters& parameters, const BodyTwist& speed) {
  return std::abs(speed.angular) <= parameters.rotStoppedVelocity &&
         Vec2(speed.linear, speed.lateral).norm() <= parameters.transStoppedVelocity;
}

/// The three standard checkers, which differ only in one condition.
class StandardGoalChecker final : public GoalChecker {
 public:
  enum class Kind { Simple, Stopped, Position };
  StandardGoalChecker(Kind kind, Distro distro, const GoalCheckerParameters& parameters)
      : kind_(kind), distro_(distro), parameters_(parameters) {}

  void reset() override { isXyLatched_ = false; }
  bool isGoalReached(const GoalQuery& query) override {
    if (!isXyReached(query)) {
      return false;
    }
    if (kind_ == Kind::Position) {
      return true;
    }
    return isYawReached(parameters_, query) &&
           (kind_ == Kind::Simple || isStopped(parameters_, query.speed));
  }
  bool isXyReached(const GoalQuery& query) override {
    if (distro_ >= Distro::Lyrical && query.pathLength > parameters_.pathLengthTolerance) {
      return false;  // the path only passes near the goal
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
  Kind kind_;
  Distro distro_;
  GoalCheckerParameters parameters_;
  bool isXyLatched_ = false;
};

/// Unit direction of the path's end; the goal's heading without a path.
Vec2 endDirection(const GoalQuery& query, double distance, Distro distro) {
  const Path* const path = query.localPath;
  if (path != nullptr && path->size() >= 2) {
    std::size_t before = path->size() - 2;
    const auto length = [&](std::size_t i) {
      return (query.goal.position - (*path)[i].position).norm();
    };
    while (distro == Distro::Main && before > 0 && length(before) < distance) {
      --before;
    }
    if (length(before) > 0.0) {
      return (query.goal.position - (*path)[before].position) / length(before);
    }
  }
  return base::directionOf(query.goal.heading);
}

class AxisGoalChecker final : public GoalChecker {
 public:
  AxisGoalChecker(const AxisGoalParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro) {}

  void reset() override {}
  bool isGoalReached(const GoalQuery& query) override { return isXyReached(query); }
  bool isXyReached(const GoalQuery& query) override {
    if (query.pathLength > parameters_.pathLengthTolerance) {
      return false;
    }
    const Vec2 direction = endDirection(query, parameters_.directionDistance, distro_);
    const Vec2 offset = query.robot.position - query.goal.position;
    const double along = direction.dot(offset);  // positive beyond the goal
    const double across = direction.x() * offset.y() - direction.y() * offset.x();
    const double ahead = parameters_.isOvershootValid ? -along : std::abs(along);
    return ahead < parameters_.alongTolerance && std::abs(across) < parameters_.acrossTolerance;
  }
  double xyTolerance() const override { return parameters_.alongTolerance; }
  double yawTolerance() const override { return base::kPi; }

 private:
  AxisGoalParameters parameters_;
  Distro distro_;
};

class AdaptiveGoalChecker final : public GoalChecker {
 public:
  explicit AdaptiveGoalChecker(const AdaptiveGoalParameters& parameters)
      : parameters_(parameters) {}

  void reset() override {
    isLatched_ = false;
    stagnant_ = 0;
  }
  bool isGoalReached(const GoalQuery& query) override {
    if (!isLatched_) {
      countStagnation(query);
    }
    if (!isXyReached(query)) {
      return false;
    }
    isLatched_ = isLatched_ || parameters_.isStateful;
    return isYawReached(parameters_, query);
  }
  bool isXyReached(const GoalQuery& query) override {
    if (query.pathLength > parameters_.pathLengthTolerance) {
      return false;
    }
    return isLatched_ || distanceOf(query) <= parameters_.fineTolerance ||
           (distanceOf(query) <= parameters_.coarseTolerance &&
            stagnant_ >= parameters_.stagnationCycles);
  }
  double xyTolerance() const override { return parameters_.coarseTolerance; }
  double yawTolerance() const override { return parameters_.yawTolerance; }

 private:
  static double distanceOf(const GoalQuery& query) {
    return (query.robot.position - query.goal.position).norm();
  }
  /// Counts consecutive checks in which the robot is stopped within the coarse tolerance.
  void countStagnation(const GoalQuery& query) {
    const bool isNear = distanceOf(query) <= parameters_.coarseTolerance;
    stagnant_ = isNear && isStopped(parameters_, query.speed) ? stagnant_ + 1 : 0;
  }

  AdaptiveGoalParameters parameters_;
  bool isLatched_ = false;
  int stagnant_ = 0;
};

struct GoalCheckerType {
  const char* plugin;
  StandardGoalChecker::Kind kind;
};
constexpr GoalCheckerType kGoalCheckers[] = {
    {"nav2_controller::SimpleGoalChecker", StandardGoalChecker::Kind::Simple},
    {"nav2_controller::StoppedGoalChecker", StandardGoalChecker::Kind::Stopped},
    {"nav2_controller::PositionGoalChecker", StandardGoalChecker::Kind::Position},
    {"dwb_plugins::SimpleGoalChecker", StandardGoalChecker::Kind::Simple},
    {"dwb_plugins::StoppedGoalChecker", StandardGoalChecker::Kind::Stopped},
};

const std::vector<Nav2Key<GoalCheckerParameters>>& goalCheckerKeys() {
  using P = GoalCheckerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"xy_goal_tolerance", &P::xyTolerance, "m", "maximum distance to the goal"},
      {"yaw_goal_tolerance", &P::yawTolerance, "rad", "maximum heading difference to the goal"},
      {"stateful", &P::isStateful, "", "a reached position stays reached until a new path"},
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "the opposite heading is also accepted"},
      {"path_length_tolerance", &P::pathLengthTolerance, "m",
       "the goal is not reached while the remaining local path is longer", kSinceLyrical},
      {"rot_stopped_velocity", &P::rotStoppedVelocity, "rad/s",
       "lower speeds count as standing (StoppedGoalChecker)"},
      {"trans_stopped_velocity", &P::transStoppedVelocity, "m/s",
       "lower speeds count as standing (StoppedGoalChecker)"},
  };
  return kKeys;
}

const std::vector<Nav2Key<AxisGoalParameters>>& axisGoalKeys() {
  using P = AxisGoalParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"along_path_tolerance", &P::alongTolerance, "m",
       "tolerance along the direction of the path's end", kSinceLyrical},
      {"cross_track_tolerance", &P::acrossTolerance, "m",
       "tolerance across the direction of the path's end", kSinceLyrical},
      {"path_length_tolerance", &P::pathLengthTolerance, "m",
       "the goal is not reached while the remaining local path is longer", kSinceLyrical},
      {"is_overshoot_valid", &P::isOvershootValid, "",
       "a position beyond the goal counts as reached", kSinceLyrical},
      {"direction_estimation_distance", &P::directionDistance, "m",
       "length of the path's end that determines its direction", kMain},
  };
  return kKeys;
}

const std::vector<Nav2Key<AdaptiveGoalParameters>>& adaptiveGoalKeys() {
  using P = AdaptiveGoalParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"fine_xy_goal_tolerance", &P::fineTolerance, "m",
       "distance within which the goal is reached", kSinceLyrical},
      {"coarse_xy_goal_tolerance", &P::coarseTolerance, "m",
       "distance within which the goal is reached by a standing robot", kSinceLyrical},
      {"required_stagnation_cycles", &P::stagnationCycles, "",
       "number of consecutive checks in which the robot must stand still", kSinceLyrical},
      {"yaw_goal_tolerance", &P::yawTolerance, "rad", "maximum heading difference to the goal",
       kSinceLyrical},
      {"path_length_tolerance", &P::pathLengthTolerance, "m",
       "the goal is not reached while the remaining local path is longer", kSinceLyrical},
      {"rot_stopped_velocity", &P::rotStoppedVelocity, "rad/s", "lower speeds count as standing",
       kSinceLyrical},
      {"trans_stopped_velocity", &P::transStoppedVelocity, "m/s", "lower speeds count as standing",
       kSinceLyrical},
      {"stateful", &P::isStateful, "", "a reached position stays reached until a new path",
       kSinceLyrical},
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "the opposite heading is also accepted",
       kSinceLyrical},
  };
  return kKeys;
}

constexpr char kAxis[] = "nav2_controller::AxisGoalChecker";
constexpr char kAdaptive[] = "nav2_controller::AdaptiveToleranceGoalChecker";

/// Creates a checker with the values of a block, or returns their problems.
template <class Checker, class Parameters, class Make>
base::Result<std::unique_ptr<Checker>> makeChecker(const std::vector<Nav2Key<Parameters>>& table,
                                                   const Nav2ParameterBlock& block, Distro distro,
                                                   Make make) {
  base::Diagnostics problems;
  const auto parameters = applyBlock(Parameters(), table, block, distro, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::unique_ptr<Checker>(make(parameters)), std::move(problems)};
}

}  // namespace

Nav2KeyTable goalCheckerKeysOf(const std::string& plugin) {
  static const std::vector<std::pair<std::string, std::vector<std::string>>> kUnreadKeys = {
      {"SimpleGoalChecker", {"rot_stopped_velocity", "trans_stopped_velocity"}},
      {"StoppedGoalChecker", {}},
      {"PositionGoalChecker",
       {"yaw_goal_tolerance", "symmetric_yaw_tolerance", "rot_stopped_velocity",
        "trans_stopped_velocity"}}};
  static const std::vector<IgnoredKey> kIgnored = {
      {"xy_goal_tolerance_buffer", "not re-implemented: treated as 0", kSinceLyrical}};
  const std::string name = normalizedPluginClass(plugin);
  if (name == kAxis) {
    return keyTableOf(axisGoalKeys(), AxisGoalParameters());
  }
  if (name == kAdaptive) {
    return keyTableOf(adaptiveGoalKeys(), AdaptiveGoalParameters(), kIgnored);
  }
  Nav2KeyTable keys = keyTableOf(goalCheckerKeys(), GoalCheckerParameters(), kIgnored);
  for (const auto& [type, unread] : kUnreadKeys) {
    if (!base::endsWith(name, "::" + type)) {
      continue;
    }
    keys.rows.erase(std::remove_if(keys.rows.begin(), keys.rows.end(),
                                   [&unread = unread](const Nav2KeyTable::Row& row) {
                                     return std::find(unread.begin(), unread.end(), row.name) !=
                                            unread.end();
                                   }),
                    keys.rows.end());
  }
  return keys;
}

std::vector<std::string> goalCheckerPlugins() {
  std::vector<std::string> names;
  for (const GoalCheckerType& type : kGoalCheckers) {
    names.emplace_back(type.plugin);
  }
  names.insert(names.end(), {kAxis, kAdaptive});
  return names;
}

base::Result<std::unique_ptr<GoalChecker>> makeGoalChecker(const std::string& plugin, Distro distro,
                                                           const Nav2ParameterBlock& block) {
  const std::string name = normalizedPluginClass(plugin);
  if (name == kAxis) {
    return makeChecker<GoalChecker>(axisGoalKeys(), block, distro,
                                    [distro](const AxisGoalParameters& given) {
                                      return std::make_unique<AxisGoalChecker>(given, distro);
                                    });
  }
  if (name == kAdaptive) {
    return makeChecker<GoalChecker>(adaptiveGoalKeys(), block, distro,
                                    [](const AdaptiveGoalParameters& given) {
                                      return std::make_unique<AdaptiveGoalChecker>(given);
                                    });
  }
  for (const GoalCheckerType& type : kGoalCheckers) {
    if (name == type.plugin) {
      return makeChecker<GoalChecker>(
          goalCheckerKeys(), block, distro, [&](const GoalCheckerParameters& given) {
            return std::make_unique<StandardGoalChecker>(type.kind, distro, given);
          });
    }
  }
  return unknownPlugin(plugin, goalCheckerPlugins());
}

bool ProgressChecker::check(const Pose2& robot, double time) {
  if (!baseline_ || hasMoved(robot)) {
    baseline_ = robot;
    baselineTime_ = time;
    return true;
  }
  return time - baselineTime_ <= parameters_.movementTimeAllowance;
}

bool ProgressChecker::hasMoved(const Pose2& robot) const {
  if ((robot.position - baseline_->position).norm() > parameters_.movementRadius) {
    return true;
  }
  return kind_ == Kind::Pose &&
         std::abs(base::angleDiff(robot.heading, baseline_->heading)) > parameters_.movementAngle;
}

const std::vector<Nav2Key<ProgressCheckerParameters>>& progressCheckerKeys() {
  using P = ProgressCheckerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"required_movement_radius", &P::movementRadius, "m",
       "radius that the robot must leave to make progress"},
      {"required_movement_angle", &P::movementAngle, "rad",
       "a rotation by more than this also counts as progress (PoseProgressChecker)"},
      {"movement_time_allowance", &P::movementTimeAllowance, "s",
       "maximum time without progress; longer is a failure"},
  };
  return kKeys;
}

namespace {

constexpr char kSimpleProgressChecker[] = "nav2_controller::SimpleProgressChecker";

}  // namespace

std::vector<std::string> progressCheckerPlugins() {
  return {kSimpleProgressChecker, "nav2_controller::PoseProgressChecker"};
}

base::Result<std::unique_ptr<ProgressChecker>> makeProgressChecker(
    const std::string& plugin, Distro distro, const Nav2ParameterBlock& block) {
  const std::vector<std::string> known = progressCheckerPlugins();
  const auto found = std::find(known.begin(), known.end(), normalizedPluginClass(plugin));
  if (found == known.end()) {
    return unknownPlugin(plugin, known);
  }
  const bool isSimple = *found == kSimpleProgressChecker;
  return makeChecker<ProgressChecker>(
      progressCheckerKeys(), block, distro, [&](const ProgressCheckerParameters& given) {
        return std::make_unique<ProgressChecker>(
            isSimple ? ProgressChecker::Kind::Simple : ProgressChecker::Kind::Pose, given);
      });
}

}  // namespace sim2d::nav2
