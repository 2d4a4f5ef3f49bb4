#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/world/GoalEnd.h"
#include "sim2d/world/HumanBehavior.h"
#include "sim2d/world/NeighborGrid.h"
#include "sim2d/world/Registries.h"

namespace sim2d {

constexpr double kTick = 1e-9;    // [s]; a time has come so much early, rounding does not delay it
constexpr double kFastest = 1e3;  // [m/s]; beyond it a run has diverged

/// A corridor along x whose ends are joined: who passes one comes in at the other.
struct Ring {
  double low = 0.0;     // [m]
  double length = 0.0;  // [m]; 0: the plane is plain

  bool isClosed() const { return length > 0.0; }
  /// The place inside the corridor.
  Vec2 inside(const Vec2& place) const;
  /// What to add to `place` to get its image nearest to `seenFrom`.
  Vec2 shift(const Vec2& place, const Vec2& seenFrom) const;
  /// Calls visit(centre) for `place` and for its images one turn to either side.
  template <class Visit>
  void forEachImage(const Vec2& place, Visit visit) const {
    visit(place);
    if (isClosed()) {
      visit(Vec2(place.x() + length, place.y()));
      visit(Vec2(place.x() - length, place.y()));
    }
  }
  /// Of the images that forEachImage gave of `seenFrom`, `centre` is the one nearest to `place`.
  bool isNearestImage(const Vec2& place, const Vec2& seenFrom, const Vec2& centre) const {
    return !isClosed() || centre.x() == seenFrom.x() - shift(place, seenFrom).x();
  }
};

/// Where people want to go, for all who want the same.
struct GoalPlan {
  std::vector<int> written;     // ids of goals, as in the scenario
  std::vector<GoalItem> goals;  // at the start, without those that nobody knows or comes to
};

/// What stays the same for one person. Who is alike shares the model, and the plan.
struct Person {
  ResolvedHuman constants;
  EntityId key;
  std::shared_ptr<const PedestrianModel> model;
  std::shared_ptr<GoalPlan> plan;  // written to while the world is built alone
  int copiedFrom = -1;             // index of the person of whom an input made this copy
};

/// What stays the same during a run. People by ascending id; sources append to the end.
struct WorldModel {
  std::shared_ptr<const Environment> environment;
  std::shared_ptr<const Registries> registries;
  Compatibility compatibility;
  double dt = 0.05;            // [s]
  std::uint64_t seed = 1;      // of who is there
  std::uint64_t drawSeed = 1;  // of what is drawn while it runs; nearly always the same
  int threads = 1;
  bool exact = false;
  bool peoplePass = false;  // through each other, as in the original
  Ring ring;
  ObstaclePoints obstaclePoints = ObstaclePoints::Boundary;
  double stuckAfter = 0.0;  // of robots [s]; 0: never
  std::vector<Person> people;
  std::vector<ResolvedRobot> robots;      // -1, -2 …
  std::vector<EntityId> robotKeys;        // beside them
  std::map<int, Vec2> globalGoals;        // where a body fits
  std::vector<const Door*> doors;         // listed ones
  std::vector<const Area*> areas;         // listed ones
  std::vector<const Dock*> docks;         // listed ones
  std::map<std::string, Human> patterns;  // whom the people of sources are like, by name

  int lastId = 0;  // the greatest given; people from sources and copies get the ones after it
};

struct RobotState {
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double linear = 0.0;           // of the wheels, along the heading [m/s]
  double lateral = 0.0;          // idem, to the left [m/s]
  double omega = 0.0;            // [rad/s]
  std::size_t goal = 0;          // index of the current one
  std::optional<Vec2> order{};   // a goal from outside, in place of those of the scenario
  int orders = 0;                // so far
  double arrivedAt = -1.0;       // [s]; < 0: on the way
  /// When the last goal was over with one of them not reached [s]; < 0: this has not happened. Only
  /// with planners that end goals themselves.
  double endedAt = -1.0;
  std::vector<GoalEnd> goalEnds{};  // results of those planners, oldest first
  double battery = 1.0;             // charge, 0 to 1; of robots with a battery
  bool isCharging = false;
};

/// Where the robot drives to; none: nowhere (any more).
inline std::optional<Vec2> currentGoal(const ResolvedRobot& robot, const RobotState& state) {
  const bool isOnList = !state.order && state.goal < robot.goals.size();
  return isOnList ? std::optional<Vec2>(robot.goals[state.goal]) : state.order;
}

/// What changes, in columns beside WorldModel::people.
struct WorldState {
  std::int64_t step = 0;
  double time = 0.0;  // step * dt [s]
  std::vector<char> present;
  std::vector<Vec2> positions, velocities;  // [m], [m/s]
  std::vector<double> heading, omega;
  std::vector<HumanControl> controls;
  std::vector<char> active;  // column `state` of the record
  std::vector<char> held;    // stopped from outside
  std::vector<RobotState> robots;
  std::vector<char> doorOpen;
  std::vector<Event> events;  // of the current step, in no order

  Vec2 position(std::size_t human) const { return positions[human]; }
  Vec2 velocity(std::size_t human) const { return velocities[human]; }
  Pose2 pose(std::size_t human) const { return {position(human), heading[human]}; }
  /// One more person, not present yet.
  void append(const Person& person);
  void emit(EventKind kind, int id, std::string text = {}) {
    events.push_back({kind, id, true, 0, false, std::move(text)});
  }
};

/// The world as it is while people decide and move: nothing of it changes then but the headings of
/// those who turn on the spot, which nobody else reads.
struct FrozenWorld {
  const WorldModel& model;
  const WorldState& state;
  const NeighborGrid& grid;
  const Obstacles& obstacles;
  const NavigationMap& navigation;
};

/// What counts for a person in this run; with all of the original also its model and straight ways,
/// unless the scenario says otherwise, and as the seed draws it but for start and first goal.
ResolvedHuman resolvePerson(const WorldModel& model, const Human& human);

/// What its own software may know of a robot.
RobotBody bodyOf(const ResolvedRobot& robot);
/// The footprint's, or the disc's, largest extent from the centre [m].
double reachOf(const ResolvedRobot& robot);
/// Point of the robot's outline nearest to `point`; `inside`: the point is within the outline.
Obstacles::Point nearestPointOf(const ResolvedRobot& robot, const Pose2& pose, const Vec2& point);

}  // namespace sim2d
