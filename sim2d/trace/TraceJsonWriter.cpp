#include <cmath>
#include <type_traits>

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

// toJson: each type of a member as it stands in the file.
Json toJson(double value) {
  return number(value);
}
Json toJson(const Vec2& point) {
  return {number(point.x()), number(point.y())};
}
Json toJson(const TraceGoal& goal) {
  return {{"id", goal.id},
          {"x", number(goal.position.x())},
          {"y", number(goal.position.y())},
          {"radius", number(goal.radius)}};
}
Json toJson(const std::vector<std::pair<std::string, double>>& parameters) {
  Json json = Json::object();
  for (const auto& [key, value] : parameters) {
    json[key] = number(value);
  }
  return json;
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

Json toJson(const OccupancyGrid& map) {
  return {{"width", map.width()},
          {"height", map.height()},
          {"resolution", number(map.resolution())},
          {"x", number(map.origin().position.x())},
          {"y", number(map.origin().position.y())},
          {"heading", number(map.origin().heading)},
          {"cells", runLengths(map.cells())}};
}

template <class T>
Json toJson(const std::vector<T>& values);

/// A part by its members; texts, numbers and flags as they are.
template <class T>
Json toJson(const T& value) {
  if constexpr (std::is_same_v<T, Outline>) {
    return toJson(value.points);
  } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
    Json json = Json::object();
    forEachMember(value,
                  [&json](const char* name, const auto& member) { json[name] = toJson(member); });
    return json;
  } else {
    return value;
  }
}

template <class T>
Json toJson(const std::vector<T>& values) {
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
  Json root = toJson(header);
  if (header.metrics == TraceMetrics()) {
    root.erase("metrics");
  }
  std::string text = "{";
  for (const auto& [key, value] : root.items()) {
    text += (text.size() == 1 ? "\n " : ",\n ") + compact(key) + ": " + memberText(value);
  }
  return text + "\n}\n";
}

}  // namespace sim2d
