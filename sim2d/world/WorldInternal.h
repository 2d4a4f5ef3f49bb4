#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/Physics.h"
#include "sim2d/world/Population.h"
#include "sim2d/world/RobotDrive.h"
#include "sim2d/world/World.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// WorldView of the running world.
class WorldStateView : public WorldView {
 public:
  explicit WorldStateView(const FrozenWorld& world)
      : world_(world), model_(world.model), state_(world.state) {}

  std::int64_t step() const override { return state_.step + 1; }
  double time() const override { return state_.time; }
  double dt() const override { return model_.dt; }
  std::uint64_t seed() const override { return model_.drawSeed; }
  const Environment& scenario() const override { return *model_.environment; }
  const Compatibility& compatibility() const override { return model_.compatibility; }

  int humanCount() const override { return static_cast<int>(model_.people.size()); }
  bool isPresent(int human) const override { return state_.present[at(human)] != 0; }
  int indexOf(int humanId) const override {
    const int guess = model_.people.empty() ? -1 : humanId - model_.people.front().constants.id;
    if (guess >= 0 && guess < humanCount() && model_.people[at(guess)].constants.id == humanId) {
      return guess;  // consecutive ids
    }
    const auto found =
        std::lower_bound(model_.people.begin(), model_.people.end(), humanId,
                         [](const Person& person, int id) { return person.constants.id < id; });
    const bool isThere = found != model_.people.end() && found->constants.id == humanId;
    return isThere ? static_cast<int>(found - model_.people.begin()) : -1;
  }
  const ResolvedHuman& constants(int human) const override {
    return model_.people[at(human)].constants;
  }
  int copiedFrom(int human) const override { return model_.people[at(human)].copiedFrom; }
  Pose2 pose(int human) const override { return state_.pose(at(human)); }
  Vec2 velocity(int human) const override { return state_.velocity(at(human)); }
  void near(int human, double range, std::vector<int>& found) const override {
    found.clear();
    const Vec2 centre = state_.position(at(human));
    world_.grid.forEachNear(centre, range, [&](int other) {
      if (other != human) {
        found.push_back(other);
      }
    });
    std::sort(found.begin(), found.end(), [&](int a, int b) {
      const double first = (state_.position(at(a)) - centre).norm();
      const double second = (state_.position(at(b)) - centre).norm();
      return first != second ? first < second : a < b;
    });
  }

  int robotCount() const override { return static_cast<int>(state_.robots.size()); }
  Pose2 robotPose(int robot) const override { return state_.robots[at(robot)].pose; }
  Vec2 robotVelocity(int robot) const override { return state_.robots[at(robot)].velocity; }
  double robotRadius(int robot) const override {
    return circumscribedRadius(model_.robots[at(robot)]);
  }
  int nearestRobot(int human) const override {
    int nearest = -1;
    double least = 0.0;
    for (int robot = 0; robot < robotCount(); ++robot) {
      const double distance = (robotPose(robot).position - state_.position(at(human))).norm();
      if (nearest < 0 || distance < least) {
        nearest = robot;
        least = distance;
      }
    }
    return nearest;
  }

  std::optional<Vec2> globalGoal(int id) const override {
    const auto found = model_.globalGoals.find(id);
    return found == model_.globalGoals.end() ? std::nullopt : std::optional<Vec2>(found->second);
  }
  const Area* area(const std::string& name) const override {
    const auto found = std::find_if(model_.areas.begin(), model_.areas.end(),
                                    [&](const Area* area) { return area->name == name; });
    return found == model_.areas.end() ? nullptr : *found;
  }
  bool isVisible(const Vec2& from, const Vec2& to) const override {
    constexpr int kQuirkNoOcclusion = 34;
    return model_.compatibility.has(kQuirkNoOcclusion) || world_.obstacles.isVisible(from, to);
  }
  bool isReachable(int human, const Vec2& point) const override {
    const ResolvedHuman& person = constants(human);
    return person.route == Route::Direct ||
           world_.navigation.isReachable(person.radius, state_.position(at(human)), point);
  }
  std::optional<double> pathLength(int human, const Vec2& point) const override {
    const ResolvedHuman& person = constants(human);
    if (person.route == Route::Direct) {
      return (point - state_.position(at(human))).norm();
    }
    const std::vector<Vec2> way =
        world_.navigation.plan(person.radius, state_.position(at(human)), point);
    return way.empty() ? std::nullopt : std::optional<double>(polylineLength(way));
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  const FrozenWorld& world_;
  const WorldModel& model_;
  const WorldState& state_;
};

/// Validated parts of a world.
struct WorldParts {
  WorldModel model;
  Surroundings surroundings;
  std::unique_ptr<NavigationMap> navigation;
  std::vector<std::shared_ptr<Planner>> planners;  // one per robot
};

/// Resolves the scenario, moves starts and goals to places where bodies fit, and removes
/// unreachable goals. Collects all problems.
base::Result<std::unique_ptr<WorldParts>> buildWorld(const WorldSetup& setup);

/// Converts the state to a frame, except paths of robots, inputs and tree changes. `frame` must
/// already contain the forces of all people in the step that led to it. The events are moved from
/// the state and sorted. Reuses the memory of the frame.
void fillFrame(const WorldModel& model, WorldState& state, Frame& frame);

/// All people so far with all resolved numbers, outlines, map.
TraceHeader makeHeader(const WorldModel& model, const Surroundings& surroundings);

/// Names of the parts of the surroundings: "map", then listed obstacles, then listed doors.
std::vector<std::string> partNames(const Environment& scenario);

/// A moving disc.
struct MovingDisc {
  Vec2 position = Vec2::Zero();                          // [m]
  Vec2 velocity = Vec2::Zero();                          // desired; afterwards limited [m/s]
  double radius = 0.35;                                  // [m]
  double mass = 80.0;                                    // [kg]
  const std::vector<Obstacles::Point>* walls = nullptr;  // boundary points near the disc
};
struct DiscPair {
  int first = 0, second = 0;
  double shift = 0.0;  // offset of the second along x in a closed corridor [m]
};

/// Limits velocities that would press discs into each other or into walls before the step ends:
/// each such pair loses its closing speed by a plastic impact shared by mass, in the given order,
/// repeated until nothing changes. Discs stop half a millimetre before contact.
void keepApart(std::vector<MovingDisc>& discs, const std::vector<DiscPair>& pairs, double dt);

constexpr std::size_t kSolverPeopleLimit = 65;  // people; up to here the solver handles all

/// Implementation of World.
class RunningWorld : public World {
 public:
  RunningWorld(WorldParts parts, std::unique_ptr<HumanBehavior> humanBehavior);

  bool step(const StepInputs& inputs) override;
  const std::string& failure() const override { return failure_; }
  const base::Diagnostics& refused() const override { return refused_; }
  void continueWith(World& world, std::uint64_t seed) override;
  std::vector<std::string> plannerReports() const override {
    std::vector<std::string> reports;
    for (const std::shared_ptr<Planner>& planner : robots_.planners()) {
      reports.push_back(planner->manifestJson());
    }
    return reports;
  }
  void measure(StepTimes* times) override { times_ = times; }
  void publishSensors(bool wanted) override {
    robots_.publishSensors(wanted);
    publishesPaths_ = wanted;
  }
  void enableScans(bool wanted) override { robots_.enableScans(wanted); }
  void setPlannerDebug(std::shared_ptr<const PlannerDebugFlags> watch) override {
    robots_.setPlannerDebug(std::move(watch));
  }
  const Frame& frame() const override { return frame_; }
  std::optional<double> arrivedAt() const override;
  std::optional<double> finishedAt() const override;
  std::vector<RobotStatus> robotStatuses() const override;
  TraceHeader header() const override { return makeHeader(model_, surroundings_); }
  const Obstacles& obstacles() const override { return surroundings_.obstacles; }
  const WorldView& view() const override { return view_; }
  HumanBehavior& behavior() override { return *behavior_; }

 private:
  /// What a body may touch; the solver handles all bodies except `Nothing`.
  enum class Nearness : std::uint8_t { Nothing, Person, Solid };

  void addRobotBodies();
  /// Applies external inputs; `acceptedInputs_` contains the accepted ones.
  void take(const StepInputs& inputs);
  /// Returns the problem of the input; empty: accepted.
  std::string take(Input& input);
  std::string applyToPerson(const Input& input);
  std::string fitRobot(Input& input) const;
  std::string teleportRobot(Input& input);
  std::string setExternalGoal(Input& input);
  std::string setBlackboardEntry(int human, const std::string& words);
  void applyHolds();
  bool hadGoal(std::size_t robot) const;
  /// Latest of the times of all robots that had goals; none if one of them is negative.
  std::optional<double> latestTime(const std::function<double(const RobotState&)>& timeOf) const;
  std::string spawnCopy(Input& input);
  /// Door toggles and people whose time has come; then the grid.
  void applyInputs(StepTimer& watch);
  void toggleDoors();
  void setDoor(std::size_t door, bool open);
  void updateNavigation();
  void place(const std::vector<std::size_t>& newcomers);
  void teleportPerson(std::size_t human, const Pose2& pose, const Vec2& velocity);
  void enter(std::size_t human);
  void leave(std::size_t human);
  void handleArrivals();
  void afterMotion();
  bool willDoorToggle() const;

  void decide();
  /// Reason of a failed step; empty: all numbers are valid.
  std::string divergenceMessage(const std::vector<BodyTwist>& commands) const;
  /// Desired velocity of a body, before contacts.
  Vec2 wantedVelocity(std::size_t body, const std::vector<BodyTwist>& commands) const;
  void moveBodies(const std::vector<BodyTwist>& commands);
  void placeDiscs(const std::vector<BodyTwist>& commands);
  void findPairs();
  void findNearness();
  bool isNearWallOrRobot(const MovingDisc& person) const;
  int subSteps() const;
  bool mayTouchAnything(std::size_t robot) const;
  bool mayTouch(const DiscPair& pair) const;
  std::string contactDescription(const Contact& touch,
                                 const std::vector<BodyTwist>& commands) const;
  void emitContacts(const std::vector<BodyTwist>& commands);
  void readPeople();
  Vec2 wrapIntoCorridor(std::size_t human, const Pose2& pose);
  void readRobots(const std::vector<BodyTwist>& commands);
  void publish();
  void publishPaths();

  /// Bodies are numbered: robots, then people in the order of entry.
  bool isRobot(std::size_t body) const { return body < model_.robots.size(); }
  std::size_t humanOf(std::size_t body) const { return humans_[body - model_.robots.size()]; }
  int idOf(std::size_t body) const;
  int bodyOf(std::size_t human) const { return bodies_[human]; }

  struct VelocityOverride {  // of a person, by an input
    std::size_t human = 0;
    Vec2 velocity = Vec2::Zero();  // [m/s]
    bool isBeside = false;         // added to the person's own desired velocity
  };

  WorldModel model_;
  Surroundings surroundings_;
  const base::StopInhibitor pathWork_;  // keeps routing computations required
  std::unique_ptr<NavigationMap> navigation_;
  WorldState state_;
  NeighborGrid grid_;
  Physics physics_;
  FrozenWorld frozen_;
  WorldStateView view_;
  Intents intents_;
  std::unique_ptr<HumanBehavior> behavior_;
  PersonMotion motion_;
  PersonGoals goals_;
  Population population_;
  RobotDrive robots_;
  StuckRobots stuckRobots_;
  Frame frame_;
  std::string failure_;
  base::Diagnostics refused_;                        // rejected inputs of the last step
  StepTimes* times_ = nullptr;                       // null: not measured
  std::vector<VelocityOverride> velocityOverrides_;  // in this step
  StepInputs acceptedInputs_;                        // accepted inputs of this step
  std::vector<std::size_t> newcomers_;               // added by inputs of this step
  std::vector<std::size_t> pastToggles_;             // number of past toggle times per door
  bool doorsChanged_ = false;                        // since the last update of the navigation map
  bool publishesPaths_ = false;                      // include paths of people in frames
  std::vector<int> bodies_;                          // body per person; -1: never present
  std::vector<std::size_t> humans_;                  // person per body, after those of robots
  std::vector<double> headingsBefore_;
  std::vector<Contact> contacts_, contactsBefore_;
  std::vector<std::string> partNames_;
  std::vector<MovingDisc> discs_;
  std::vector<DiscPair> pairs_;
  std::vector<Nearness> nearness_;  // per body, in this step
  std::vector<Vec2> chords_;        // mean direction of each robot in the step
  std::vector<double> robotRadii_;  // circumscribed radius of each robot [m]
  std::vector<std::vector<Obstacles::Point>> robotWalls_;  // near each robot
};

}  // namespace sim2d
