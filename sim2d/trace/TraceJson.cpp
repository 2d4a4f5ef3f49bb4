#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim2d/base/Problems.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;  // newest known

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

/// Takes the parts of a header out of objects; every problem is noted with the path of the member.
class JsonReader {
 public:
  JsonReader(const std::string& file, base::Diagnostics& problems)
      : file_(file), problems_(problems) {}

  template <class T>
  T part(const Json& json, const std::string& path) {
    T part;
    forEachMember(part, [&](const char* name, auto& member) { read(json, path, name, member); });
    check(path, part);
    return part;
  }

 private:
  void error(const std::string& path, std::string_view code, base::ProblemValues values = {}) {
    problems_.push_back(base::within(path, base::error(code, std::move(values), file_)));
  }

  const Json* member(const Json& object, const std::string& path, const char* key) {
    const auto found = object.find(key);
    if (found == object.end()) {
      error(path + key, "trace.missing");
      return nullptr;
    }
    return &*found;
  }
  /// One of the type that `fits` asks for.
  const Json* member(const Json& object, const std::string& path, const char* key,
                     bool (Json::*fits)() const noexcept, std::string_view otherwise) {
    const Json* json = member(object, path, key);
    if (json != nullptr && !(json->*fits)()) {
      error(path + key, otherwise);
      return nullptr;
    }
    return json;
  }

  static bool finite(const Json& json, double& value) {
    if (!json.is_number()) {
      return false;
    }
    value = json.get<double>();
    return std::isfinite(value);
  }

  // read: each type of a member as it stands in the file.
  void read(const Json& object, const std::string& path, const char* key, std::string& value) {
    if (const Json* json = member(object, path, key, &Json::is_string, "trace.no-text")) {
      value = json->get<std::string>();
    }
  }

  void read(const Json& object, const std::string& path, const char* key, bool& value) {
    if (const Json* json = member(object, path, key, &Json::is_boolean, "trace.no-boolean")) {
      value = json->get<bool>();
    }
  }

  void read(const Json& object, const std::string& path, const char* key, double& value) {
    const Json* json = member(object, path, key);
    if (json != nullptr && !finite(*json, value)) {
      error(path + key, "trace.no-number");
    }
  }

  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  void read(const Json& object, const std::string& path, const char* key, Integer& value) {
    const Json* json = member(object, path, key);
    if (json == nullptr) {
      return;
    }
    const bool fits = json->is_number_unsigned()
                          ? json->get<std::uint64_t>() <=
                                static_cast<std::uint64_t>(std::numeric_limits<Integer>::max())
                          : json->is_number_integer() &&
                                json->get<std::int64_t>() >= std::numeric_limits<Integer>::min();
    if (!fits) {
      error(path + key, "trace.no-integer");
    } else {
      value = json->get<Integer>();
    }
  }

  /// Calls `each(element, path)` for the elements of a list.
  template <class Each>
  void forEach(const Json& object, const std::string& path, const char* key, Each each) {
    if (const Json* json = member(object, path, key, &Json::is_array, "trace.no-list")) {
      for (std::size_t k = 0; k < json->size(); ++k) {
        each((*json)[k], path + key + "[" + std::to_string(k) + "]");
      }
    }
  }

  template <class T, class = decltype(T::members())>
  void read(const Json& object, const std::string& path, const char* key, std::vector<T>& to) {
    forEachObject(object, path, key, [&](const Json& item, const std::string& where) {
      to.push_back(part<T>(item, where));
    });
  }
  template <class Each>
  void forEachObject(const Json& object, const std::string& path, const char* key, Each each) {
    forEach(object, path, key, [&](const Json& item, const std::string& where) {
      if (item.is_object()) {
        each(item, where + ".");
      } else {
        error(where, "trace.no-object");
      }
    });
  }

  void read(const Json& object, const std::string& path, const char* key,
            std::vector<TraceGoal>& goals) {
    forEachObject(object, path, key, [&](const Json& item, const std::string& where) {
      TraceGoal& goal = goals.emplace_back();
      read(item, where, "id", goal.id);
      read(item, where, "x", goal.position.x());
      read(item, where, "y", goal.position.y());
      read(item, where, "radius", goal.radius);
    });
  }

  void read(const Json& object, const std::string& path, const char* key, std::vector<Vec2>& to) {
    forEach(object, path, key, [&](const Json& json, const std::string& where) {
      Vec2 point = Vec2::Zero();
      if (json.is_array() && json.size() == 2 && finite(json[0], point.x()) &&
          finite(json[1], point.y())) {
        to.push_back(point);
      } else {
        error(where, "trace.no-point");
      }
    });
  }

  void read(const Json& object, const std::string& path, const char* key, std::vector<double>& to) {
    forEach(object, path, key, [&](const Json& item, const std::string& where) {
      if (!finite(item, to.emplace_back())) {
        error(where, "trace.no-number");
      }
    });
  }

  void read(const Json& object, const std::string& path, const char* name,
            std::vector<std::pair<std::string, double>>& to) {
    const Json* parameters = member(object, path, name, &Json::is_object, "trace.no-object");
    if (parameters == nullptr) {
      return;
    }
    for (const auto& [key, value] : parameters->items()) {
      double number = std::numeric_limits<double>::infinity();
      if (value == "inf" || value == "-inf") {
        to.emplace_back(key, value == "inf" ? number : -number);
      } else if (finite(value, number)) {
        to.emplace_back(key, number);
      } else {
        error(path + name + "." + key, "trace.no-parameter");
      }
    }
  }

  void read(const Json& object, const std::string& path, const char* name,
            std::vector<Outline>& to) {
    const Json* outlines = member(object, path, name, &Json::is_array, "trace.no-list");
    for (std::size_t k = 0; outlines != nullptr && k < outlines->size(); ++k) {
      const std::string key = std::to_string(k);
      read(Json{{key, (*outlines)[k]}}, path + name + ".", key.c_str(), to.emplace_back().points);
    }
  }

  void read(const Json& root, const std::string& path, const char* name, OccupancyGrid& map) {
    const Json* json = member(root, path, name, &Json::is_object, "trace.no-object");
    if (json == nullptr) {
      return;
    }
    int width = 0;
    int height = 0;
    double resolution = 0.05;
    Pose2 origin;
    read(*json, "map.", "width", width);
    read(*json, "map.", "height", height);
    read(*json, "map.", "resolution", resolution);
    read(*json, "map.", "x", origin.position.x());
    read(*json, "map.", "y", origin.position.y());
    read(*json, "map.", "heading", origin.heading);
    requirePositive("map.resolution", resolution);
    const Json* runs = member(*json, "map.", "cells");
    std::vector<std::int8_t> cells;
    const bool sized = width >= 0 && height >= 0;
    const std::size_t count =
        sized ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0;
    if (!sized || runs == nullptr || !expandCells(*runs, count, cells)) {
      error("map.cells", "trace.bad-cells");
    } else if (!cells.empty() && resolution > 0.0) {
      map = OccupancyGrid(width, height, resolution, origin, std::move(cells));
    }
  }

  /// Scenarios that say nothing about metrics have no such member.
  void read(const Json& root, const std::string& path, const char* key, TraceMetrics& metrics) {
    if (root.contains(key)) {
      if (const Json* json = member(root, path, key, &Json::is_object, "trace.no-object")) {
        metrics = part<TraceMetrics>(*json, path + key + ".");
      }
    }
  }

  void requirePositive(const std::string& path, double value) {
    if (value <= 0.0) {
      error(path, "trace.not-positive");
    }
  }
  template <class T>
  void check(const std::string& path, const T& part) {
    if constexpr (std::is_same_v<T, TraceHeader>) {
      if (part.format > kFormat) {
        error("format", "trace.newer", {kFormat});
      }
      requirePositive(path + "dt", part.dt);
      requirePositive(path + "record_every", part.recordEvery);
    } else if constexpr (std::is_same_v<T, TraceHuman> || std::is_same_v<T, TraceRobot>) {
      requirePositive(path + "radius", part.radius);
    }
  }

  const std::string& file_;
  base::Diagnostics& problems_;
};

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
  auto header = JsonReader(file, problems).part<TraceHeader>(root, "");
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(header), std::move(problems)};
}

}  // namespace sim2d
