#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/RobotSensors.h"

namespace sim2d {

/// The robots: what they see, what their planners say, what their limits leave of it, goals.
class RobotDrive {
 public:
  RobotDrive(std::vector<std::shared_ptr<Planner>> planners, const WorldModel& model);

  /// In the next `command` instead of what the planner says.
  /// A planner that is driven from outside takes it as the newest word.
  void steer(std::size_t robot, const BodyTwist& command);
  /// It was put somewhere else and takes itself to be there, at rest.
  void relocate(std::size_t robot, const Pose2& pose) { sensors_.relocate(robot, pose); }
  /// Commands of this step, within the limits of speed and acceleration. Emits `replan`.
  const std::vector<BodyTwist>& command(const FrozenWorld& world, WorldState& state);
  /// From now on the robot drives by the planner and the limits that it has there.
  void takePlanner(std::size_t robot, const RobotDrive& from) {
    planners_[robot] = from.planners_[robot];
    bodies_[robot] = from.bodies_[robot];
  }
  /// Sensors and planners draw by another seed from now on.
  void reseed(std::uint64_t seed);
  /// What a planner said when it could not go on; empty: nothing did.
  const std::string& failure() const { return failure_; }
  /// After the step: goals that are over, arrivals.
  void afterMotion(const WorldModel& model, WorldState& state);

  void tellSenses(bool wanted) { wantsSenses_ = wanted; }
  void tellScans(bool wanted) { wantsScans_ = wanted; }
  void watchPlanners(std::shared_ptr<const PlannerWatch> watch) { watch_ = std::move(watch); }
  /// Of all robots in the last `command`; null unless asked for.
  std::shared_ptr<const std::vector<RobotSenses>> senses() const { return senses_; }
  /// Turns of recorded lidars in the last `command`, put in the place of what `scans` had.
  void takeScans(std::vector<RecordedScan>& scans) {
    scans.clear();
    scans.swap(scans_);
  }

  /// Nodes of the trees that drive robots which returned another status in the last `command` than
  /// in the one before; by -1, -2 ….
  void takeTreeChanges(TreeChanges& changes) {
    changes.append(treeChanges_);
    treeChanges_.clear();
  }
  /// The planners, for reports.
  const std::vector<std::shared_ptr<Planner>>& planners() const { return planners_; }

  std::vector<Vec2> path(std::size_t robot, const WorldModel& model, const WorldState& state) const;

 private:
  void sense(const FrozenWorld& world);
  void addSenses(std::size_t robot, bool isAsked);
  void addPlanner(RobotSenses& senses, const Planner& planner) const;
  void watch(Planner& planner) const;
  void takeEvents(std::size_t robot, int id, WorldState& state);
  void passGoals(std::size_t robot, const ResolvedRobot& constants, WorldState& state);
  void noteEnd(std::size_t robot);
  /// Into `observation_`: what the robot knows.
  void observe(const FrozenWorld& world, std::size_t robot);
  BodyTwist ask(std::size_t robot, const std::string& name);
  void noteTree(std::size_t robot, int id, bool isAsked);

  std::vector<std::shared_ptr<Planner>> planners_;
  std::vector<RobotBody> bodies_;
  RobotSensors sensors_;
  std::vector<ScanUse> scanUses_;  // of each robot, in this step
  std::vector<RecordedScan> scans_;
  std::vector<std::vector<base::NodeStatus>> statuses_;  // of trees, in the last step
  TreeChanges treeChanges_;
  /// Of robots whose planners end goals themselves, in this step.
  struct Ending {
    bool isDecided = false;            // by the planner, which was asked
    std::optional<NavigationEnd> end;  // what it decided
  };
  std::vector<Ending> endings_;
  std::vector<BodyTwist> commands_;
  std::map<std::size_t, BodyTwist> steered_;
  std::string failure_;
  bool wantsSenses_ = false, wantsScans_ = false;
  std::shared_ptr<const PlannerWatch> watch_;
  std::shared_ptr<std::vector<RobotSenses>> senses_;
  Observation observation_;  // its memory is used again
};

}  // namespace sim2d
