#include "sim2d/trace/TraceJson.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "sim2d/trace/JsonFields.h"

namespace sim2d {

namespace {

constexpr int kFormat = 1;  // newest known

void requirePositive(JsonFields& fields, const std::string& path, double value) {
  if (value <= 0.0) {
    fields.error(path, "trace.not-positive");
  }
}

/// Points as lists of two numbers, and whatever JsonFields knows.
template <class T>
void readMember(JsonFields& fields, const Json& json, const std::string& path, const char* key,
                T& to) {
  if constexpr (std::is_same_v<T, std::vector<Vec2>>) {
    fields.points(json, path, key, to);
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    fields.readInt(json, path, key, to);
  } else {
    fields.read(json, path, key, to);
  }
}

void readMember(JsonFields& fields, const Json& json, const std::string& path, const char* key,
                std::vector<TraceGoal>& goals) {
  fields.objects(json, path, key, goals, [&](const Json& item, const std::string& where) {
    TraceGoal goal;
    fields.readInt(item, where, "id", goal.id);
    fields.read(item, where, "x", goal.position.x());
    fields.read(item, where, "y", goal.position.y());
    fields.read(item, where, "radius", goal.radius);
    return goal;
  });
}

void readMember(JsonFields& fields, const Json& json, const std::string& path, const char* key,
                std::vector<double>& to) {
  fields.forEach(json, path, key, [&](const Json& item, const std::string& where) {
    double value = 0.0;
    if (!JsonFields::finite(item, value)) {
      fields.error(where, "trace.no-number");
    }
    to.push_back(value);
  });
}

void readMember(JsonFields& fields, const Json& json, const std::string& path, const char* name,
                std::vector<std::pair<std::string, double>>& to) {
  const Json* parameters = fields.member(json, path, name);
  if (parameters == nullptr) {
    return;
  }
  if (!parameters->is_object()) {
    fields.error(path + name, "trace.no-object");
    return;
  }
  const std::string where = path + name + ".";
  for (const auto& [key, value] : parameters->items()) {
    double number = 0.0;
    if (value == "inf" || value == "-inf") {
      const double infinity = std::numeric_limits<double>::infinity();
      to.emplace_back(key, value == "inf" ? infinity : -infinity);
    } else if (JsonFields::finite(value, number)) {
      to.emplace_back(key, number);
    } else {
      fields.error(where + key, "trace.no-parameter");
    }
  }
}

void readMember(JsonFields& fields, const Json& json, const std::string& path, const char* name,
                std::vector<Outline>& to) {
  const Json* outlines = fields.member(json, path, name);
  if (outlines != nullptr && outlines->is_array()) {
    for (std::size_t k = 0; k < outlines->size(); ++k) {
      const std::string key = std::to_string(k);
      Outline outline;
      fields.points(Json{{key, (*outlines)[k]}}, path + name + ".", key.c_str(), outline.points);
      to.push_back(std::move(outline));
    }
  } else if (outlines != nullptr) {
    fields.error(path + name, "trace.no-list");
  }
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

void readMember(JsonFields& fields, const Json& root, const std::string& path, const char* name,
                OccupancyGrid& map) {
  const Json* json = fields.member(root, path, name);
  if (json == nullptr) {
    return;
  }
  if (!json->is_object()) {
    fields.error("map", "trace.no-object");
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
    fields.error("map.cells", "trace.bad-cells");
  } else if (!cells.empty() && resolution > 0.0) {
    map = OccupancyGrid(width, height, resolution, origin, std::move(cells));
  }
}

template <class T>
T readPart(JsonFields& fields, const Json& json, const std::string& path);

template <class T, class = decltype(T::members())>
void readMember(JsonFields& fields, const Json& json, const std::string& path, const char* key,
                std::vector<T>& to) {
  fields.objects(json, path, key, to, [&](const Json& item, const std::string& where) {
    return readPart<T>(fields, item, where);
  });
}

/// Scenarios that say nothing about metrics have no such member.
void readMember(JsonFields& fields, const Json& root, const std::string& path, const char* key,
                TraceMetrics& metrics) {
  const auto found = root.find(key);
  if (found != root.end() && !found->is_object()) {
    fields.error(path + key, "trace.no-object");
  } else if (found != root.end()) {
    metrics = readPart<TraceMetrics>(fields, *found, path + key + ".");
  }
}

void check(JsonFields& fields, const std::string& path, const TraceHuman& human) {
  requirePositive(fields, path + "radius", human.radius);
}
void check(JsonFields& fields, const std::string& path, const TraceRobot& robot) {
  requirePositive(fields, path + "radius", robot.radius);
}
void check(JsonFields& fields, const std::string& path, const TraceHeader& header) {
  if (header.format > kFormat) {
    fields.error("format", "trace.newer", {kFormat});
  }
  requirePositive(fields, path + "dt", header.dt);
  requirePositive(fields, path + "record_every", header.recordEvery);
}
template <class T>
void check(JsonFields& /*fields*/, const std::string& /*path*/, const T& /*part*/) {}

template <class T>
T readPart(JsonFields& fields, const Json& json, const std::string& path) {
  T part;
  forEachMember(
      part, [&](const char* name, auto& member) { readMember(fields, json, path, name, member); });
  check(fields, path, part);
  return part;
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
  return base::error("trace.not-json", {}, file, line, static_cast<int>(end - lineStart) + 1);
}

}  // namespace

base::Result<TraceHeader> parseTraceJson(const std::string& text, const std::string& file) {
  Json root;
  try {
    root = Json::parse(text);
  } catch (const Json::parse_error& error) {
    return syntaxError(text, error.byte, file);
  } catch (const Json::exception& error) {  // a number out of range
    return base::error("trace.number-too-large", {error.what()}, file);
  }
  base::Diagnostics problems;
  if (!root.is_object()) {
    return base::error("trace.no-json-object", {}, file, 1, 1);
  }
  JsonFields fields(file, problems);
  auto header = readPart<TraceHeader>(fields, root, "");
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(header), std::move(problems)};
}

}  // namespace sim2d
