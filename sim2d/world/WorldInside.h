#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/world/Goals.h"
#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/Physics.h"
#include "sim2d/world/Population.h"
#include "sim2d/world/RobotDrive.h"
#include "sim2d/world/RobotProgress.h"
#include "sim2d/world/World.h"
#include "sim2d/world/WorldViewOf.h"

namespace sim2d {

/// What a world is made of, checked.
struct WorldParts {
  WorldModel model;
  Surroundings surroundings;
  std::unique_ptr<NavigationMap> navigation;
  std::vector<std::shared_ptr<Planner>> planners;  // one per robot
};

/// Resolves the scenario, moves starts and goals to where bodies fit, and leaves out goals that
/// nobody can reach. Gathers every problem.
base::Result<std::unique_ptr<WorldParts>> buildWorld(const WorldSetup& setup);

/// The state as a frame, but for the paths of robots, inputs and the changes of trees. It already
/// has the forces of all people in the step that led to it. The events are taken from the state and
/// put in order. The memory of the frame is used again.
void fillFrame(const WorldModel& model, WorldState& state, Frame& frame);

/// Everybody so far with all resolved numbers, outlines, map.
TraceHeader makeHeader(const WorldModel& model, const Surroundings& surroundings);

/// Names of the parts of the surroundings: "map", then listed obstacles, then listed doors.
std::vector<std::string> partNames(const Environment& scenario);

/// A disc on its way.
struct MovingDisc {
  Vec2 position = Vec2::Zero();  // [m]
  Vec2 velocity = Vec2::Zero();  // wanted; what is left of it afterwards [m/s]
  double radius = 0.35;          // [m]
  double mass = 80.0;            // [kg]
  const std::vector<Obstacles::Point>* walls = nullptr;  // boundary points near the disc
};
struct DiscPair {
  int first = 0, second = 0;
  double shift = 0.0;  // of the second along x, to where it acts [m]
};

/// Takes from the velocities what would press discs into each other or into walls before the step
/// ends: each pair that would, loses closing speed by a plastic impact shared by mass, in the order
/// given, repeated until nothing changes. Discs stop half a millimetre before they meet.
void keepApart(std::vector<MovingDisc>& discs, const std::vector<DiscPair>& pairs, double dt);

constexpr std::size_t kSmallWorld = 65;  // people; so few are all left to the solver

/// The parts of a world and the order of the step.
class RunningWorld : public World {
 public:
  RunningWorld(WorldParts parts, std::unique_ptr<HumanBehavior> minds);

  bool step(const StepInputs& inputs) override;
  const std::string& failure() const override { return failure_; }
  const base::Diagnostics& refused() const override { return refused_; }
  void goOnAs(World& world, std::uint64_t seed) override;
  std::vector<std::string> robotReports() const override {
    std::vector<std::string> reports;
    for (const std::shared_ptr<Planner>& planner : robots_.planners()) {
      reports.push_back(planner->reportJson());
    }
    return reports;
  }
  void measure(StepTimes* times) override { times_ = times; }
  void tellSenses(bool wanted) override {
    robots_.tellSenses(wanted);
    tellsWays_ = wanted;
  }
  void tellScans(bool wanted) override { robots_.tellScans(wanted); }
  void watchPlanners(std::shared_ptr<const PlannerWatch> watch) override {
    robots_.watchPlanners(std::move(watch));
  }
  const Frame& frame() const override { return frame_; }
  std::optional<double> arrivedAt() const override;
  std::optional<double> finishedAt() const override;
  std::vector<RobotOnWay> robotsOnWay() const override;
  TraceHeader header() const override { return makeHeader(model_, surroundings_); }
  const Obstacles& obstacles() const override { return surroundings_.obstacles; }
  const WorldView& view() const override { return view_; }
  HumanBehavior& behavior() override { return *behavior_; }

 private:
  /// What a body may run into: the solver cares for all but `Nothing`.
  enum class Nearness : std::uint8_t { Nothing, Person, Solid };

  void addRobotBodies();
  /// Inputs from outside; `taken_` has those that were possible.
  void take(const StepInputs& inputs);
  /// What is wrong with the input; empty: it acts.
  std::string take(Input& input);
  std::string takeForPerson(const Input& input);
  std::string placeRobot(Input& input) const;
  std::string putRobot(Input& input);
  std::string orderRobot(Input& input);
  std::string setEntry(int human, const std::string& words);
  void holdStopped();
  bool hadGoal(std::size_t robot) const;
  /// The latest of the times of all robots that had goals; none: one of them is negative.
  std::optional<double> lastOf(const std::function<double(const RobotState&)>& timeOf) const;
  std::string addCopy(Input& input);
  /// Doors and people whose time has come; the grid afterwards.
  void applyInputs(StepWatch& watch);
  void toggleDoors();
  void setDoor(std::size_t door, bool open);
  void updateNavigation();
  void place(const std::vector<std::size_t>& newcomers);
  void put(std::size_t human, const Pose2& pose, const Vec2& velocity);
  void enter(std::size_t human);
  void leave(std::size_t human);
  void finishRounds();
  void afterMotion();
  bool willDoorToggle() const;

  void decide();
  /// What a failed step says; empty: all numbers are fine.
  std::string trouble(const std::vector<BodyTwist>& commands) const;
  /// Of a body, before contacts.
  Vec2 wantedVelocity(std::size_t body, const std::vector<BodyTwist>& commands) const;
  void moveBodies(const std::vector<BodyTwist>& commands);
  void placeDiscs(const std::vector<BodyTwist>& commands);
  void findPairs();
  void findNearness();
  bool isNearWallOrRobot(const MovingDisc& person) const;
  int subSteps() const;
  bool meetsSomething(std::size_t robot) const;
  bool mayMeet(const DiscPair& pair) const;
  std::string faultOf(const Touch& touch, const std::vector<BodyTwist>& commands) const;
  void tellContacts(const std::vector<BodyTwist>& commands);
  void readPeople();
  Vec2 aroundTheRing(std::size_t human, const Pose2& pose);
  void readRobots(const std::vector<BodyTwist>& commands);
  void publish();
  void publishWays();

  /// Bodies are those of the robots, then of people as they came in.
  bool isRobot(std::size_t body) const { return body < model_.robots.size(); }
  std::size_t humanOf(std::size_t body) const { return humans_[body - model_.robots.size()]; }
  int idOf(std::size_t body) const;
  int bodyOf(std::size_t human) const { return bodies_[human]; }

  struct Steering {  // of a person by an input
    std::size_t human = 0;
    Vec2 velocity = Vec2::Zero();  // [m/s]
    bool isBeside = false;         // what the person wants
  };

  WorldModel model_;
  Surroundings surroundings_;
  const base::NeededWork ways_;  // whatever becomes of the map from here on
  std::unique_ptr<NavigationMap> navigation_;
  WorldState state_;
  NeighborGrid grid_;
  Physics physics_;
  FrozenWorld frozen_;
  WorldViewOf view_;
  Intents intents_;
  std::unique_ptr<HumanBehavior> behavior_;
  PersonMotion motion_;
  Goals goals_;
  Population population_;
  RobotDrive robots_;
  RobotProgress progress_;
  Frame frame_;
  std::string failure_;
  base::Diagnostics refused_;           // inputs of the last step
  StepTimes* times_ = nullptr;          // null: nobody measures
  std::vector<Steering> steerings_;     // in this step
  StepInputs taken_;                    // idem
  std::vector<std::size_t> newcomers_;  // by inputs of this step
  std::vector<std::size_t> toggled_;    // times of each door that are over
  bool doorsChanged_ = false;           // since the navigation map was updated
  bool tellsWays_ = false;              // of people, in frames
  std::vector<int> bodies_;             // of the people; -1: never present
  std::vector<std::size_t> humans_;     // whose bodies they are, after those of robots
  std::vector<double> headingsBefore_;
  std::vector<Touch> touches_, touchesBefore_;
  std::vector<std::string> partNames_;
  std::vector<MovingDisc> discs_;
  std::vector<DiscPair> pairs_;
  std::vector<Nearness> nearness_;    // per body, in this step
  std::vector<Vec2> chords_;          // direction of each robot in the middle of the step
  std::vector<double> robotReaches_;  // of the circle around each robot [m]
  std::vector<std::vector<Obstacles::Point>> robotWalls_;  // near each robot
};

}  // namespace sim2d
