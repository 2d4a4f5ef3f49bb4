#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/world/HumanBehavior.h"
#include "sim2d/world/NeighborGrid.h"
#include "sim2d/world/Registries.h"

namespace sim2d {

constexpr double kTimeTolerance = 1e-9;     // [s]; tolerance of event times against rounding
constexpr double kMaxPlausibleSpeed = 1e3;  // [m/s]; above it a run has diverged

/// A corridor along x with joined ends (periodic boundary).
struct PeriodicCorridor {
  double low = 0.0;     // [m]
  double length = 0.0;  // [m]; 0: not periodic

  bool isClosed() const { return length > 0.0; }
  /// The equivalent place inside the corridor.
  Vec2 inside(const Vec2& place) const;
  /// Offset to add to `place` to get its image nearest to `seenFrom`.
  Vec2 shift(const Vec2& place, const Vec2& seenFrom) const;
  /// Calls visit(centre) for `place` and its images in the two neighbouring periods.
  template <class Visit>
  void forEachImage(const Vec2& place, Visit visit) const {
    visit(place);
    if (isClosed()) {
      visit(Vec2(place.x() + length, place.y()));
      visit(Vec2(place.x() - length, place.y()));
    }
  }
  /// True if, of the images that forEachImage gave of `seenFrom`, `centre` is the nearest to
  /// `place`.
  bool isNearestImage(const Vec2& place, const Vec2& seenFrom, const Vec2& centre) const {
    return !isClosed() || centre.x() == seenFrom.x() - shift(place, seenFrom).x();
  }
};

/// Goal list shared by people with the same goals.
struct GoalPlan {
  std::vector<int> written;     // ids of goals, as in the scenario
  std::vector<GoalItem> goals;  // at the start, without unknown and unreachable ones
};

/// Constants of one person. People with equal properties share the model and the plan.
struct Person {
  ResolvedHuman constants;
  EntityId key;
  std::shared_ptr<const PedestrianModel> model;
  std::shared_ptr<GoalPlan> plan;  // modified only while the world is built
  int copiedFrom = -1;             // index of the person that an input copied
};

/// Constants of a run. People by ascending id; sources append to the end.
struct WorldModel {
  std::shared_ptr<const Environment> environment;
  std::shared_ptr<const Registries> registries;
  Compatibility compatibility;
  double dt = 0.05;            // [s]
  std::uint64_t seed = 1;      // of the properties of people
  std::uint64_t drawSeed = 1;  // of draws during the run; usually equal to `seed`
  int threads = 1;
  bool exact = false;
  bool peoplePass = false;  // people pass through each other, as in the original
  PeriodicCorridor ring;
  ObstaclePoints obstaclePoints = ObstaclePoints::Boundary;
  double stuckAfter = 0.0;  // of robots [s]; 0: disabled
  std::vector<Person> people;
  std::vector<ResolvedRobot> robots;             // -1, -2 …
  std::vector<EntityId> robotKeys;               // parallel to `robots`
  std::map<int, Vec2> globalGoals;               // adjusted to where a body fits
  std::vector<const Door*> doors;                // listed ones
  std::vector<const Area*> areas;                // listed ones
  std::vector<const Area*> speedZones;           // listed areas of kind speed
  std::vector<const Dock*> docks;                // listed ones
  std::map<std::string, Human> sourceTemplates;  // templates of people from sources, by name

  int lastId = 0;  // largest assigned id; people from sources and copies get the next ones
};

/// Distance outside `goal_radius` within which a goal still counts as reached when the robot's
/// planner reports success [m]: the default `tolerance` of Nav2's planners, by which a path may end
/// beside the goal.
constexpr double kGoalReachedTolerance = 0.5;

/// A goal that the robot's planner has ended.
struct GoalResult {
  NavigationResult result;
  double time = 0.0;         // of the state after it [s]
  double distance = 0.0;     // true distance from the robot's centre to the goal in that state [m]
  int goal = 0;              // goal id; 0: none
  int number = 1;            // 1-based index in the robot's list
  bool isReached = false;    // success within goal_radius + kGoalReachedTolerance
  bool isExternal = false;   // goal set from outside
  bool isOneOfMany = false;  // the robot has several goals
};

/// "0.213 m from the goal", "goal 2: planner NO_VALID_PATH (208), 3.4 m from the goal".
std::string goalResultText(const GoalResult& end);
/// Reason for the failure without the distance, or the distance on success: "planner NO_VALID_PATH
/// (208)".
std::string goalResultReason(const GoalResult& end);

struct RobotState {
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();        // [m/s]
  double linear = 0.0;                 // of the wheels, along the heading [m/s]
  double lateral = 0.0;                // same, to the left [m/s]
  double omega = 0.0;                  // [rad/s]
  std::size_t goal = 0;                // index of the current goal
  std::optional<Vec2> externalGoal{};  // external goal, replaces those of the scenario
  int externalGoalCount = 0;           // number of external goals so far
  double arrivedAt = -1.0;             // [s]; < 0: not arrived
  /// Time at which the last goal ended while one of them was not reached [s]; < 0: none. Only with
  /// planners that end goals themselves.
  double endTime = -1.0;
  std::vector<GoalResult> goalResults{};  // results of those planners, oldest first
  double battery = 1.0;                   // charge, 0 to 1; of robots with a battery
  bool isCharging = false;
};

/// Current goal of the robot; none if it has none (left).
inline std::optional<Vec2> currentGoal(const ResolvedRobot& robot, const RobotState& state) {
  const bool isOnList = !state.externalGoal && state.goal < robot.goals.size();
  return isOnList ? std::optional<Vec2>(robot.goals[state.goal]) : state.externalGoal;
}

/// State of a run, in columns parallel to WorldModel::people.
struct WorldState {
  std::int64_t step = 0;
  double time = 0.0;  // step * dt [s]
  std::vector<char> present;
  std::vector<Vec2> positions, velocities;  // [m], [m/s]
  std::vector<double> heading, omega;
  std::vector<HumanControl> controls;
  std::vector<char> active;  // column `state` of the recording
  std::vector<char> held;    // stopped by an input
  std::vector<RobotState> robots;
  std::vector<char> doorOpen;
  std::vector<Event> events;  // of the current step, unordered

  Vec2 position(std::size_t human) const { return positions[human]; }
  Vec2 velocity(std::size_t human) const { return velocities[human]; }
  Pose2 pose(std::size_t human) const { return {position(human), heading[human]}; }
  /// Adds one person, not present yet.
  void append(const Person& person);
  void emit(EventKind kind, int id, std::string text = {}) {
    events.push_back({kind, id, true, 0, false, std::move(text)});
  }
};

/// State of the world while people decide and move. Nothing in it changes then except the headings
/// of people who turn in place, which only they themselves read.
struct FrozenWorld {
  const WorldModel& model;
  const WorldState& state;
  const NeighborGrid& grid;
  const Obstacles& obstacles;
  const NavigationMap& navigation;
};

/// Resolved properties of a person in this run, with seed-dependent variation except start and
/// first goal. With all quirks of the original, its model and direct routes are the defaults.
ResolvedHuman resolvePerson(const WorldModel& model, const Human& human);

/// Properties of a robot that its own software may use.
RobotBody bodyOf(const ResolvedRobot& robot);
/// Circumscribed radius of the footprint or disc [m].
double circumscribedRadius(const ResolvedRobot& robot);
/// Point of the robot's outline nearest to `point`; `inside`: the point is within the outline.
Obstacles::Point nearestPointOf(const ResolvedRobot& robot, const Pose2& pose, const Vec2& point);

}  // namespace sim2d
