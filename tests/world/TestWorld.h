#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/world/World.h"

/// Small scenarios and a behaviour for the tests of the world.
namespace testworld {

using namespace sim2d;

/// Everybody walks the own list of goals; `change` may alter the intents afterwards.
class ScriptedBehavior : public HumanBehavior {
 public:
  using Change = std::function<void(const WorldView&, Intents&)>;
  explicit ScriptedBehavior(Change change = {}) : change_(std::move(change)) {}

  void enter(int human, const WorldView& view) override {
    entered.push_back(view.constants(human).id);
  }
  void decide(const WorldView& view, Intents& intents) override {
    for (int human = 0; human < view.humanCount(); ++human) {
      const std::vector<GoalItem>& goals = intents.control(human).goals;
      Intent& intent = intents.of(human);
      intent.motion = goals.empty() ? Motion::Brake : Motion::Walk;
      intent.speed = view.constants(human).desiredSpeed;
      if (!goals.empty()) {
        intent.target = goals.front();
        intent.targetIsGoal = true;
      }
    }
    if (change_) {
      change_(view, intents);
    }
  }

  std::vector<int> entered;  // ids, in order

 private:
  Change change_;
};

inline void addGoal(Scenario& scenario, int id, double x, double y) {
  GlobalGoal goal;
  goal.id = id;
  goal.position = Vec2(x, y);
  scenario.goals.push_back(goal);
}

inline Human& addPerson(Scenario& scenario, int id, const Vec2& start, std::vector<int> goals = {},
                        double heading = 0.0) {
  Human human;
  human.id = id;
  human.name = "person" + std::to_string(id);
  human.initPose = {start, heading};
  human.goals = std::move(goals);
  human.radius = 0.4;
  human.maxVel = 1.5;
  human.goalRadius = 0.3;
  human.cyclicGoals = false;
  scenario.humans.push_back(human);
  return scenario.humans.back();
}

inline Robot& addRobot(Scenario& scenario, const Vec2& start, const Vec2& goal) {
  Robot robot;
  robot.name = "robot" + std::to_string(scenario.robots.size() + 1);
  robot.start = {start, 0.0};
  robot.goal.point = goal;
  scenario.robots.push_back(robot);
  return scenario.robots.back();
}

inline Obstacle& addWall(Scenario& scenario, const std::vector<Vec2>& line,
                         double thickness = 0.2) {
  Obstacle wall;
  wall.name = "wall" + std::to_string(scenario.obstacles.size() + 1);
  wall.kind = ObstacleKind::Wall;
  wall.points = line;
  wall.thickness = thickness;
  scenario.obstacles.push_back(wall);
  return scenario.obstacles.back();
}

inline Door& addDoor(Scenario& scenario, const Vec2& from, const Vec2& to, bool open,
                     std::vector<double> toggles) {
  Door door;
  door.name = "door" + std::to_string(scenario.doors.size() + 1);
  door.from = from;
  door.to = to;
  door.open = open;
  door.thickness = 0.1;
  door.toggles = std::move(toggles);
  scenario.doors.push_back(door);
  return scenario.doors.back();
}

/// Four walls round the rectangle.
inline void addRoom(Scenario& scenario, const Vec2& low, const Vec2& high) {
  addWall(scenario, {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low});
}

inline WorldSetup setupOf(Scenario scenario, ScriptedBehavior::Change change = {}) {
  WorldSetup setup;
  setup.scenario = std::make_shared<const Scenario>(std::move(scenario));
  setup.behavior = std::make_unique<ScriptedBehavior>(std::move(change));
  return setup;
}

inline base::Result<std::unique_ptr<World>> create(Scenario scenario,
                                                   ScriptedBehavior::Change change = {},
                                                   OccupancyGrid map = {}) {
  WorldSetup setup = setupOf(std::move(scenario), std::move(change));
  setup.map = std::move(map);
  return World::create(std::move(setup));
}

/// A world that must be possible.
inline std::unique_ptr<World> make(WorldSetup setup) {
  base::Result<std::unique_ptr<World>> world = World::create(std::move(setup));
  if (!world) {
    throw std::runtime_error(world.diagnostics().front().text());
  }
  return *std::move(world);
}
inline std::unique_ptr<World> make(Scenario scenario, ScriptedBehavior::Change change = {}) {
  return make(setupOf(std::move(scenario), std::move(change)));
}

inline Input inputOf(InputKind kind, int id, const Vec2& velocity = Vec2::Zero()) {
  Input input;
  input.kind = kind;
  input.id = id;
  input.velocity = velocity;
  return input;
}
inline Input placing(InputKind kind, int id, const Vec2& place) {
  Input input = inputOf(kind, id);
  input.pose.position = place;
  return input;
}

struct Recorded {
  std::int64_t step = 0;
  Event event;
};

/// Steps `count` times, or until the world fails; gathers events.
inline std::vector<Recorded> advance(World& world, int count,
                                     const std::function<void(const Frame&)>& look = {}) {
  std::vector<Recorded> events;
  for (int i = 0; i < count && world.step(); ++i) {
    for (const Event& event : world.frame().events) {
      events.push_back({world.stepIndex(), event});
    }
    if (look) {
      look(world.frame());
    }
  }
  return events;
}

inline std::vector<Recorded> ofKind(const std::vector<Recorded>& events, EventKind kind) {
  std::vector<Recorded> found;
  for (const Recorded& recorded : events) {
    if (recorded.event.kind == kind) {
      found.push_back(recorded);
    }
  }
  return found;
}

inline Vec2 positionOf(const Frame& frame, std::size_t row) {
  return {frame.humans.x[row], frame.humans.y[row]};
}
inline Vec2 robotPosition(const Frame& frame, std::size_t row = 0) {
  return {frame.robots.x[row], frame.robots.y[row]};
}
inline double speedOf(const Frame& frame, std::size_t row) {
  return Vec2(frame.humans.vx[row], frame.humans.vy[row]).norm();
}

/// Deepest overlap of two people [m].
inline double deepestOverlap(const Frame& frame, double radius) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < frame.humans.size(); ++i) {
    for (std::size_t k = i + 1; k < frame.humans.size(); ++k) {
      deepest =
          std::max(deepest, 2.0 * radius - (positionOf(frame, i) - positionOf(frame, k)).norm());
    }
  }
  return deepest;
}

}  // namespace testworld
