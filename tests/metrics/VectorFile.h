#pragma once

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "SampledRun.h"

/// Test vectors of metrics: inputs and expected values as JSON.
namespace vectors {

using Json = nlohmann::ordered_json;

inline double numberOf(const Json& json) {
  if (json.is_string()) {
    return json == "inf" ? HUGE_VAL : std::nan("");
  }
  return json.is_boolean() ? (json.get<bool>() ? 1.0 : 0.0) : json.get<double>();
}

inline base::Vec2 pointOf(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>()};
}

inline void readBody(const Json& json, metrics::Body& body) {
  body.id = json["id"].get<int>();
  body.position = {json["x"].get<double>(), json["y"].get<double>()};
  body.heading = json["yaw"].get<double>();
  body.velocity = {json["vx"].get<double>(), json["vy"].get<double>()};
  body.speed = json["linear_vel"].get<double>();
  body.omega = json["angular_vel"].get<double>();
  body.radius = json["radius"].get<double>();
  for (const Json& point : json["closest_obs"]) {
    body.obstacles.push_back({pointOf(point), 0.0, false});
  }
}

inline sim2d::OccupancyGrid mapOf(const Json& json) {
  if (json.is_null()) {
    return {};
  }
  const int width = json["width"].get<int>();
  const int height = json["height"].get<int>();
  std::vector<std::int8_t> cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                 0);
  const auto fill = [&](const char* key, std::int8_t value) {
    for (const Json& cell : json[key]) {
      const auto place = cell[1].get<std::size_t>() * static_cast<std::size_t>(width);
      cells[place + cell[0].get<std::size_t>()] = value;
    }
  };
  fill("occupied_cells", 100);
  fill("unknown_cells", -1);
  return {width, height, json["resolution"].get<double>(), {pointOf(json["origin"]), 0.0}, cells};
}

inline metrics::Sample sampleOf(const Json& step) {
  metrics::Sample sample;
  sample.time = step["t"].get<double>();
  readBody(step["robot"], sample.robot);
  for (const sim2d::Obstacles::Point& point : sample.robot.obstacles) {
    const double distance = (point.position - sample.robot.position).norm();
    sample.robot.obstacleDistance =
        std::min(sample.robot.obstacleDistance.value_or(distance), distance);
  }
  for (const Json& agent : step["agents"]) {
    metrics::Pedestrian person;
    readBody(agent, person);
    person.group = agent["group_id"].get<int>();
    person.behavior = agent["behavior"].get<int>();
    person.state = agent["behavior_state"].get<int>();
    sample.people.push_back(std::move(person));
  }
  return sample;
}

inline metrics::SampledRun sampledRunOf(const Json& file) {
  metrics::SampledRun recording;
  recording.hasRobot = true;
  recording.hasObstacles = true;  // every sample brings the points near it
  recording.map = mapOf(file["map"]);
  for (const Json& step : file["steps"]) {
    recording.samples.push_back(sampleOf(step));
  }
  const Json& robot = file["steps"].back()["robot"];
  for (const Json& goal : robot["goals"]) {
    recording.goals.push_back({0, pointOf(goal), robot["goal_radius"].get<double>()});
  }
  return recording;
}

}  // namespace vectors
