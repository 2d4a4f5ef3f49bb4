#pragma once

#include <memory>

#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/scenario/Scenario.h"

/// A room of 12 x 9 m with a wall that has a gap, and some people, made in code.
namespace small {

inline std::shared_ptr<const sim2d::OccupancyGrid> room() {
  constexpr int kWidth = 240;
  constexpr int kHeight = 180;
  std::vector<std::int8_t> cells(static_cast<std::size_t>(kWidth) * kHeight, 0);
  const auto wall = [&](int left, int bottom, int right, int top) {
    for (int row = bottom; row < top; ++row) {
      for (int column = left; column < right; ++column) {
        const int cell = row * kWidth + column;
        cells[static_cast<std::size_t>(cell)] = 100;
      }
    }
  };
  wall(0, 0, kWidth, 4);
  wall(0, kHeight - 4, kWidth, kHeight);
  wall(0, 0, 4, kHeight);
  wall(kWidth - 4, 0, kWidth, kHeight);
  wall(118, 0, 122, 70);
  wall(118, 110, 122, kHeight);
  return std::make_shared<sim2d::OccupancyGrid>(kWidth, kHeight, 0.05, sim2d::Pose2{},
                                                std::move(cells));
}

inline sim2d::Human person(int key, const char* name, const sim2d::Vec2& at, double heading,
                           sim2d::BehaviorType type, std::vector<int> goals) {
  sim2d::Human human;
  human.key = {base::EntityKind::Human, key};
  human.name = name;
  human.id = key;
  human.initPose = {at, heading};
  human.behavior.type = type;
  human.goals = std::move(goals);
  return human;
}

inline sim2d::GlobalGoal goal(int key, int id, const sim2d::Vec2& at) {
  sim2d::GlobalGoal value;
  value.key = {base::EntityKind::Goal, key};
  value.id = id;
  value.position = at;
  return value;
}

inline sim2d::Scenario scenario() {
  using sim2d::BehaviorType;
  sim2d::Scenario result;
  result.goals = {goal(11, 1, {9.5, 7.5}), goal(12, 2, {2.0, 7.0}), goal(13, 3, {10.0, 1.5})};
  result.humans = {person(1, "Ana", {2.0, 2.0}, 0.6, BehaviorType::Regular, {1, 2}),
                   person(2, "Ben", {4.0, 6.5}, -1.2, BehaviorType::Impassive, {3}),
                   person(3, "Chloe", {7.5, 3.0}, 2.4, BehaviorType::Curious, {2, 1, 3}),
                   person(4, "Emma", {9.0, 5.0}, 1.6, BehaviorType::Surprised, {1}),
                   person(5, "Farid", {3.2, 3.8}, 3.1, BehaviorType::Scared, {}),
                   person(6, "Greta", {8.0, 6.6}, -0.4, BehaviorType::Threatening, {2})};
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, 21};
  robot.name = "robot1";
  robot.start = {{10.6, 3.4}, base::kPi};
  robot.goal.point = sim2d::Vec2(1.5, 1.0);
  result.robots = {robot};
  sim2d::Obstacle table;
  table.key = {base::EntityKind::Obstacle, 31};
  table.name = "table1";
  table.pose = {{4.2, 1.4}, 0.3};
  table.length = 1.6;
  table.width = 0.8;
  sim2d::Obstacle column;
  column.key = {base::EntityKind::Obstacle, 32};
  column.name = "column1";
  column.kind = sim2d::ObstacleKind::Circle;
  column.pose.position = {8.6, 1.6};
  column.radius = 0.4;
  result.obstacles = {table, column};
  sim2d::Area area;
  area.key = {base::EntityKind::Area, 41};
  area.name = "queue";
  area.points = {{0.6, 4.6}, {2.2, 4.6}, {2.2, 5.8}, {0.6, 5.8}};
  result.areas = {area};
  sim2d::Door door;
  door.key = {base::EntityKind::Door, 51};
  door.name = "door1";
  door.from = {6.0, 4.0};
  door.to = {6.0, 5.0};
  result.doors = {door};
  return result;
}

}  // namespace small
