#include <cmath>

#include <nlohmann/json.hpp>

#include "sim2d/trace/Trace.h"

namespace sim2d {

namespace {

using Json = nlohmann::ordered_json;

/// JSON knows finite numbers only.
Json number(double value) {
  if (std::isfinite(value)) {
    return value;
  }
  return std::isnan(value) ? "nan" : (value > 0 ? "inf" : "-inf");
}

Json pointsJson(const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (const Vec2& point : points) {
    list.push_back({number(point.x()), number(point.y())});
  }
  return list;
}

Json goalsJson(const std::vector<TraceGoal>& goals) {
  Json list = Json::array();
  for (const TraceGoal& goal : goals) {
    list.push_back({{"id", goal.id},
                    {"x", number(goal.position.x())},
                    {"y", number(goal.position.y())},
                    {"radius", number(goal.radius)}});
  }
  return list;
}

Json humanJson(const TraceHuman& human) {
  Json parameters = Json::object();
  for (const auto& [key, value] : human.parameters) {
    parameters[key] = number(value);
  }
  return {{"id", human.id},
          {"name", human.name},
          {"kind", human.kind},
          {"model", human.model},
          {"radius", number(human.radius)},
          {"mass", number(human.mass)},
          {"desired_speed", number(human.desiredSpeed)},
          {"group", human.group},
          {"behavior", human.behavior},
          {"configuration", human.configuration},
          {"cyclic_goals", human.cyclicGoals},
          {"goals", goalsJson(human.goals)},
          {"parameters", parameters}};
}

Json robotJson(const TraceRobot& robot) {
  return {{"id", robot.id},
          {"name", robot.name},
          {"type", robot.type},
          {"planner", robot.planner},
          {"radius", number(robot.radius)},
          {"mass", number(robot.mass)},
          {"max_vel", number(robot.maxVel)},
          {"max_acc", number(robot.maxAcc)},
          {"max_omega", number(robot.maxOmega)},
          {"max_alpha", number(robot.maxAlpha)},
          {"start_time", number(robot.startTime)},
          {"goals", goalsJson(robot.goals)},
          {"footprint", pointsJson(robot.footprint)}};
}

Json obstacleJson(const TraceObstacle& obstacle) {
  Json toggles = Json::array();
  for (const double toggle : obstacle.toggles) {
    toggles.push_back(number(toggle));
  }
  Json outlines = Json::array();
  for (const Outline& outline : obstacle.outlines) {
    outlines.push_back(pointsJson(outline.points));
  }
  return {{"name", obstacle.name},
          {"door", obstacle.isDoor},
          {"open", obstacle.open},
          {"toggles", toggles},
          {"outlines", outlines}};
}

/// Value and number of repetitions in turn, row by row from the lower left.
Json runLengths(const std::vector<std::int8_t>& cells) {
  Json list = Json::array();
  for (std::size_t k = 0; k < cells.size();) {
    std::size_t end = k;
    while (end < cells.size() && cells[end] == cells[k]) {
      ++end;
    }
    list.push_back(static_cast<int>(cells[k]));
    list.push_back(end - k);
    k = end;
  }
  return list;
}

Json mapJson(const OccupancyGrid& map) {
  return {{"width", map.width()},
          {"height", map.height()},
          {"resolution", number(map.resolution())},
          {"x", number(map.origin().position.x())},
          {"y", number(map.origin().position.y())},
          {"heading", number(map.origin().heading)},
          {"cells", runLengths(map.cells())}};
}

Json metricsJson(const TraceMetrics& metrics) {
  Json parameters = Json::object();
  for (const auto& [key, value] : metrics.parameters) {
    parameters[key] = number(value);
  }
  return {{"from", metrics.from},
          {"until", metrics.until},
          {"frequency", number(metrics.frequency)},
          {"tag", metrics.tag},
          {"run_id", metrics.runId},
          {"selection", metrics.selection},
          {"parameters", parameters}};
}

template <class T, class ToJson>
Json listJson(const std::vector<T>& values, ToJson toJson) {
  Json list = Json::array();
  for (const T& value : values) {
    list.push_back(toJson(value));
  }
  return list;
}

std::string compact(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// One line per member, in lists of objects one line per object.
std::string memberText(const Json& value) {
  if (!value.is_array() || value.empty()) {
    return compact(value);
  }
  std::string text = "[";
  for (std::size_t k = 0; k < value.size(); ++k) {
    text += (k == 0 ? "\n  " : ",\n  ") + compact(value[k]);
  }
  return text + "\n ]";
}

}  // namespace

std::string traceJson(const TraceHeader& header) {
  Json root = {{"format", header.format},
               {"scenario", header.scenario},
               {"dt", number(header.dt)},
               {"record_every", header.recordEvery},
               {"seed", header.seed},
               {"obstacle_points", header.obstaclePoints},
               {"humans", listJson(header.humans, humanJson)},
               {"robots", listJson(header.robots, robotJson)},
               {"obstacles", listJson(header.obstacles, obstacleJson)},
               {"map", mapJson(header.map)}};
  if (!(header.metrics == TraceMetrics())) {
    root["metrics"] = metricsJson(header.metrics);
  }
  std::string text = "{";
  for (const auto& [key, value] : root.items()) {
    text += (text.size() == 1 ? "\n " : ",\n ") + compact(key) + ": " + memberText(value);
  }
  return text + "\n}\n";
}

}  // namespace sim2d
