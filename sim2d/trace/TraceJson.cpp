#include "sim2d/trace/TraceJson.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/trace/JsonFields.h"

namespace sim2d {

namespace {

constexpr int kFormat = 1;  // newest known

void requirePositive(JsonFields& fields, const std::string& path, double value) {
  if (value <= 0.0) {
    fields.error(path, "must be greater than 0");
  }
}

void readGoals(JsonFields& fields, const Json& json, const std::string& path,
               std::vector<TraceGoal>& goals) {
  fields.objects(json, path, "goals", goals, [&](const Json& item, const std::string& where) {
    TraceGoal goal;
    fields.readInt(item, where, "id", goal.id);
    fields.read(item, where, "x", goal.position.x());
    fields.read(item, where, "y", goal.position.y());
    fields.read(item, where, "radius", goal.radius);
    return goal;
  });
}

void readParameters(JsonFields& fields, const Json& json, const std::string& path,
                    std::vector<std::pair<std::string, double>>& to) {
  const Json* parameters = fields.member(json, path, "parameters");
  if (parameters == nullptr) {
    return;
  }
  if (!parameters->is_object()) {
    fields.error(path + "parameters", "must be an object");
    return;
  }
  const std::string where = path + "parameters.";
  for (const auto& [key, value] : parameters->items()) {
    double number = 0.0;
    if (value == "inf" || value == "-inf") {
      const double infinity = std::numeric_limits<double>::infinity();
      to.emplace_back(key, value == "inf" ? infinity : -infinity);
    } else if (JsonFields::finite(value, number)) {
      to.emplace_back(key, number);
    } else {
      fields.error(where + key, "must be a number");
    }
  }
}

TraceHuman readHuman(JsonFields& fields, const Json& json, const std::string& path) {
  TraceHuman human;
  fields.readInt(json, path, "id", human.id);
  fields.read(json, path, "name", human.name);
  fields.read(json, path, "kind", human.kind);
  fields.read(json, path, "model", human.model);
  fields.read(json, path, "radius", human.radius);
  fields.read(json, path, "mass", human.mass);
  fields.read(json, path, "desired_speed", human.desiredSpeed);
  fields.readInt(json, path, "group", human.group);
  fields.readInt(json, path, "behavior", human.behavior);
  fields.readInt(json, path, "configuration", human.configuration);
  fields.read(json, path, "cyclic_goals", human.cyclicGoals);
  readGoals(fields, json, path, human.goals);
  readParameters(fields, json, path, human.parameters);
  requirePositive(fields, path + "radius", human.radius);
  return human;
}

TraceRobot readRobot(JsonFields& fields, const Json& json, const std::string& path) {
  TraceRobot robot;
  fields.readInt(json, path, "id", robot.id);
  fields.read(json, path, "name", robot.name);
  fields.read(json, path, "type", robot.type);
  fields.read(json, path, "planner", robot.planner);
  fields.read(json, path, "radius", robot.radius);
  fields.read(json, path, "mass", robot.mass);
  fields.read(json, path, "max_vel", robot.maxVel);
  fields.read(json, path, "max_acc", robot.maxAcc);
  fields.read(json, path, "max_omega", robot.maxOmega);
  fields.read(json, path, "max_alpha", robot.maxAlpha);
  fields.read(json, path, "start_time", robot.startTime);
  readGoals(fields, json, path, robot.goals);
  fields.points(json, path, "footprint", robot.footprint);
  requirePositive(fields, path + "radius", robot.radius);
  return robot;
}

TraceObstacle readObstacle(JsonFields& fields, const Json& json, const std::string& path) {
  TraceObstacle obstacle;
  fields.read(json, path, "name", obstacle.name);
  fields.read(json, path, "door", obstacle.isDoor);
  fields.read(json, path, "open", obstacle.open);
  fields.forEach(json, path, "toggles", [&](const Json& item, const std::string& where) {
    double time = 0.0;
    if (!JsonFields::finite(item, time)) {
      fields.error(where, "must be a finite number");
    }
    obstacle.toggles.push_back(time);
  });
  const Json* outlines = fields.member(json, path, "outlines");
  if (outlines != nullptr && outlines->is_array()) {
    for (std::size_t k = 0; k < outlines->size(); ++k) {
      const std::string key = std::to_string(k);
      Outline outline;
      fields.points(Json{{key, (*outlines)[k]}}, path + "outlines.", key.c_str(), outline.points);
      obstacle.outlines.push_back(std::move(outline));
    }
  } else if (outlines != nullptr) {
    fields.error(path + "outlines", "must be a list");
  }
  return obstacle;
}

/// Undoes the run lengths; never grows beyond `count`, whatever the file claims.
bool expandCells(const Json& json, std::size_t count, std::vector<std::int8_t>& cells) {
  if (!json.is_array() || json.size() % 2 != 0) {
    return false;
  }
  for (std::size_t k = 0; k < json.size(); k += 2) {
    if (!json[k].is_number_integer() || !json[k + 1].is_number_unsigned()) {
      return false;
    }
    const auto value = json[k].get<std::int64_t>();
    const auto repeat = json[k + 1].get<std::uint64_t>();
    if (value < -1 || value > 100 || repeat > count - cells.size()) {
      return false;
    }
    cells.insert(cells.end(), repeat, static_cast<std::int8_t>(value));
  }
  return cells.size() == count;
}

void readMap(JsonFields& fields, const Json& root, OccupancyGrid& map) {
  const Json* json = fields.member(root, "", "map");
  if (json == nullptr) {
    return;
  }
  if (!json->is_object()) {
    fields.error("map", "must be an object");
    return;
  }
  int width = 0;
  int height = 0;
  double resolution = 0.05;
  Pose2 origin;
  fields.readInt(*json, "map.", "width", width);
  fields.readInt(*json, "map.", "height", height);
  fields.read(*json, "map.", "resolution", resolution);
  fields.read(*json, "map.", "x", origin.position.x());
  fields.read(*json, "map.", "y", origin.position.y());
  fields.read(*json, "map.", "heading", origin.heading);
  requirePositive(fields, "map.resolution", resolution);
  const Json* runs = fields.member(*json, "map.", "cells");
  std::vector<std::int8_t> cells;
  const bool sized = width >= 0 && height >= 0;
  const std::size_t count =
      sized ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0;
  if (!sized || runs == nullptr || !expandCells(*runs, count, cells)) {
    fields.error("map.cells", "must be pairs of value and repetitions that fill width * height");
  } else if (!cells.empty() && resolution > 0.0) {
    map = OccupancyGrid(width, height, resolution, origin, std::move(cells));
  }
}

/// Scenarios that say nothing about metrics have no such member.
void readMetrics(JsonFields& fields, const Json& root, TraceMetrics& metrics) {
  const auto found = root.find("metrics");
  if (found == root.end()) {
    return;
  }
  if (!found->is_object()) {
    fields.error("metrics", "must be an object");
    return;
  }
  const std::string path = "metrics.";
  fields.read(*found, path, "from", metrics.from);
  fields.read(*found, path, "until", metrics.until);
  fields.read(*found, path, "frequency", metrics.frequency);
  fields.read(*found, path, "tag", metrics.tag);
  fields.readInt(*found, path, "run_id", metrics.runId);
  fields.read(*found, path, "selection", metrics.selection);
  readParameters(fields, *found, path, metrics.parameters);
}

TraceHeader readHeader(JsonFields& fields, const Json& root) {
  TraceHeader header;
  fields.readInt(root, "", "format", header.format);
  if (header.format > kFormat) {
    fields.error("format", "is newer than this program knows (" + std::to_string(kFormat) + ")");
  }
  fields.read(root, "", "scenario", header.scenario);
  fields.read(root, "", "dt", header.dt);
  fields.readInt(root, "", "record_every", header.recordEvery);
  fields.readInt(root, "", "seed", header.seed);
  fields.read(root, "", "obstacle_points", header.obstaclePoints);
  fields.objects(root, "", "humans", header.humans, [&](const Json& json, const std::string& path) {
    return readHuman(fields, json, path);
  });
  fields.objects(root, "", "robots", header.robots, [&](const Json& json, const std::string& path) {
    return readRobot(fields, json, path);
  });
  fields.objects(
      root, "", "obstacles", header.obstacles,
      [&](const Json& json, const std::string& path) { return readObstacle(fields, json, path); });
  readMap(fields, root, header.map);
  readMetrics(fields, root, header.metrics);
  requirePositive(fields, "dt", header.dt);
  requirePositive(fields, "record_every", header.recordEvery);
  return header;
}

base::Diagnostic syntaxError(const std::string& text, std::size_t byte, const std::string& file) {
  const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
  int line = 1;
  std::size_t lineStart = 0;
  for (std::size_t k = 0; k < end; ++k) {
    if (text[k] == '\n') {
      ++line;
      lineStart = k + 1;
    }
  }
  return base::makeError("not valid JSON (cut or damaged file?)", file, line,
                         static_cast<int>(end - lineStart) + 1);
}

}  // namespace

base::Result<TraceHeader> parseTraceJson(const std::string& text, const std::string& file) {
  Json root;
  try {
    root = Json::parse(text);
  } catch (const Json::parse_error& error) {
    return syntaxError(text, error.byte, file);
  } catch (const Json::exception& error) {  // a number out of range
    return base::makeError(error.what(), file);
  }
  base::Diagnostics problems;
  if (!root.is_object()) {
    return base::makeError("must be a JSON object", file, 1, 1);
  }
  JsonFields fields(file, problems);
  TraceHeader header = readHeader(fields, root);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(header), std::move(problems)};
}

}  // namespace sim2d
