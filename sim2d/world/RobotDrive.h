#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotRoute.h"
#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/RobotSensors.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// The robots: sensing, planner calls, limits of commands, goals.
class RobotDrive {
 public:
  RobotDrive(std::vector<std::shared_ptr<Planner>> planners, const WorldModel& model);

  /// Overrides the planner's command in the next `command`. A teleop planner takes it as its latest
  /// command.
  void steer(std::size_t robot, const BodyTwist& command);
  /// Call after the robot was teleported: its pose estimate becomes the true pose, at rest.
  void relocate(std::size_t robot, const Pose2& pose) { sensors_.relocate(robot, pose); }
  /// Commands of this step, within the limits of speed and acceleration. Emits `replan`.
  const std::vector<BodyTwist>& command(const FrozenWorld& world, WorldState& state);
  /// Replaces the planner and limits of the robot by those of `from`.
  void replacePlanner(std::size_t robot, const RobotDrive& from) {
    planners_[robot] = from.planners_[robot];
    bodies_[robot] = from.bodies_[robot];
  }
  /// Sets the seed of sensors and planners.
  void reseed(std::uint64_t seed);
  /// Error of a planner; empty: none.
  const std::string& failure() const { return failure_; }
  /// Call after the step: handles ended goals and arrivals.
  void afterMotion(const WorldModel& model, WorldState& state);

  void publishSensors(bool wanted) { publishesSensors_ = wanted; }
  void enableScans(bool wanted) { publishesScans_ = wanted; }
  void setPlannerDebug(std::shared_ptr<const PlannerDebugFlags> watch) {
    watch_ = std::move(watch);
  }
  /// Of all robots in the last `command`; null unless enabled.
  std::shared_ptr<const std::vector<RobotTelemetry>> senses() const { return senses_; }
  /// Recorded lidar scans of the last `command`; replaces the contents of `scans`.
  void takeScans(std::vector<RecordedScan>& scans) {
    scans.clear();
    scans.swap(scans_);
  }

  /// Nodes of robots' trees whose status changed in the last `command`; by -1, -2 ….
  void takeTreeChanges(TreeChanges& changes) {
    changes.append(treeChanges_);
    treeChanges_.clear();
  }
  /// For reports.
  const std::vector<std::shared_ptr<Planner>>& planners() const { return planners_; }

  std::vector<Vec2> path(std::size_t robot, const WorldModel& model, const WorldState& state) const;

 private:
  void sense(const FrozenWorld& world);
  void addPerception(std::size_t robot, bool isCalled);
  void addPlanner(RobotTelemetry& senses, const Planner& planner) const;
  void watch(Planner& planner) const;
  void takeEvents(std::size_t robot, int id, WorldState& state);
  void passGoals(std::size_t robot, const ResolvedRobot& constants, WorldState& state);
  void recordNavigationResult(std::size_t robot);
  /// Fills `observation_`.
  void observe(const FrozenWorld& world, std::size_t robot);
  BodyTwist callPlanner(std::size_t robot, const std::string& name);
  void recordTreeStatus(std::size_t robot, int id, bool isCalled);

  std::vector<std::shared_ptr<Planner>> planners_;
  std::vector<RobotBody> bodies_;
  RobotSensors sensors_;
  std::vector<ScanDemand> scanUses_;  // per robot, in this step
  std::vector<RecordedScan> scans_;
  std::vector<std::vector<base::NodeStatus>> statuses_;  // of the trees, in the last step
  TreeChanges treeChanges_;
  /// Of robots whose planners decide the end of goals, in this step.
  struct GoalDecision {
    bool isDecided = false;               // the planner decides, and it was called
    std::optional<NavigationResult> end;  // its result
  };
  std::vector<GoalDecision> goalDecisions_;
  std::vector<BodyTwist> commands_;
  std::map<std::size_t, BodyTwist> overrides_;
  std::string failure_;
  bool publishesSensors_ = false, publishesScans_ = false;
  std::shared_ptr<const PlannerDebugFlags> watch_;
  std::shared_ptr<std::vector<RobotTelemetry>> senses_;
  Observation observation_;  // reused buffer
};

/// Emits the event `goal` for a goal of the robot's list.
void emitGoal(const ResolvedRobot& robot, std::size_t goal, WorldState& state);

/// Handles the result of the robot's planner for the current goal, or several goals starting with
/// it. Emits `navigation_succeeded` or `navigation_failed`, `goal` for reached goals, and `arrived`
/// if all goals of the robot are reached. `now`: the robot's part of `state`.
void completeGoals(const ResolvedRobot& robot, const NavigationResult& end, RobotState& now,
                   WorldState& state);

/// Detects stuck robots: those with a goal whose distance to it, along the path around the walls,
/// has not decreased by 0.1 m within WorldModel::stuckAfter seconds. Robots that have not started
/// yet do not count, nor robots without a path while a door will still toggle. Not thread-safe.
class StuckRobots {
 public:
  explicit StuckRobots(const WorldModel& model);

  /// Call after each step. Emits `stuck` when a robot becomes stuck.
  void update(const WorldModel& model, WorldState& state, const NavigationMap& navigation,
              bool willDoorToggle);
  /// [s]; reset when it has come half a metre nearer, or has another goal.
  std::optional<double> stuckSince(std::size_t robot) const;

 private:
  struct MonitoredRobot {
    StuckDetector watch;
    std::optional<double> since;
  };
  static MonitoredRobot unstuck(const WorldModel& model);

  std::vector<MonitoredRobot> robots_;  // empty: not enabled
  double nextCheck_ = 0.0;              // [s]
};

}  // namespace sim2d
