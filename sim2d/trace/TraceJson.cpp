#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/trace/JsonInput.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;  // latest known format
constexpr char kWrap[] = "wrap_x";
constexpr char kDrive[] = "kinematics";
constexpr char kCustomTree[] = "custom_tree";

/// Expands run lengths to `count` cells; false if they do not match.
bool expandCells(const Json& json, std::size_t count, std::vector<std::int8_t>& cells) {
  if (!json.is_array() || json.size() % 2 != 0) {
    return false;
  }
  cells.reserve(count);
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

/// Reads the parts of the header; problems are reported with the path of the member.
class JsonReader {
 public:
  JsonReader(const std::string& text, const std::string& file, base::Diagnostics& problems)
      : text_(text), file_(file), problems_(problems) {}

  template <class T>
  T part(const Json& json, const std::string& path) {
    T part;
    forEachMember(part,
                  [&](const char* name, auto& member) { readMember(json, path, name, member); });
    check(path, part);
    return part;
  }

 private:
  void error(const std::string& where, std::string_view code, base::ProblemValues values = {}) {
    if (!places_) {
      places_.emplace(text_);
    }
    problems_.push_back(base::withContext(
        where, base::error(code, std::move(values), file_, places_->lineOf(where))));
  }
  bool expect(bool fits, const std::string& where, std::string_view otherwise) {
    if (!fits) {
      error(where, otherwise);
    }
    return fits;
  }

  /// `metrics`, `wrap_x`, `custom_tree` and (in older files) `kinematics` are optional, all other
  /// members required.
  template <class T>
  void readMember(const Json& object, const std::string& path, const char* key, T& value) {
    const auto found = object.find(key);
    if (found != object.end()) {
      read(*found, path + key, value);
    } else if (!std::is_same_v<T, TraceMetrics> && std::string_view(key) != kWrap &&
               std::string_view(key) != kDrive && std::string_view(key) != kCustomTree) {
      error(path + key, "trace.missing");
    }
  }

  static bool finite(const Json& json, double& value) {
    if (!json.is_number()) {
      return false;
    }
    value = json.get<double>();
    return std::isfinite(value);
  }
  template <class Integer>
  static bool fits(const Json& json) {
    using Limits = std::numeric_limits<Integer>;
    return json.is_number_unsigned()
               ? json.get<std::uint64_t>() <= static_cast<std::uint64_t>(Limits::max())
               : json.is_number_integer() && json.get<std::int64_t>() >= Limits::min();
  }

  // read: one overload per member type.
  void read(const Json& json, const std::string& where, std::string& value) {
    if (expect(json.is_string(), where, "trace.no-text")) {
      value = json.get<std::string>();
    }
  }
  void read(const Json& json, const std::string& where, bool& value) {
    if (expect(json.is_boolean(), where, "trace.no-boolean")) {
      value = json.get<bool>();
    }
  }
  void read(const Json& json, const std::string& where, double& value) {
    expect(finite(json, value), where, "trace.no-number");
  }
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  void read(const Json& json, const std::string& where, Integer& value) {
    if (expect(fits<Integer>(json), where, "trace.no-integer")) {
      value = json.get<Integer>();
    }
  }

  template <class T>
  void read(const Json& json, const std::string& where, std::vector<T>& values) {
    const std::size_t count =
        expect(json.is_array(), where, "trace.no-list") ? json.size() : std::size_t(0);
    for (std::size_t k = 0; k < count; ++k) {
      readElement(json[k], where + "[" + std::to_string(k) + "]", values);
    }
  }
  void readElement(const Json& json, const std::string& where, std::vector<double>& to) {
    read(json, where, to.emplace_back());
  }
  void readElement(const Json& json, const std::string& where, std::vector<Outline>& to) {
    read(json, where, to.emplace_back().points);
  }
  void readElement(const Json& json, const std::string& where, std::vector<Vec2>& to) {
    Vec2 point = Vec2::Zero();
    if (expect(json.is_array() && json.size() == 2 && finite(json[0], point.x()) &&
                   finite(json[1], point.y()),
               where, "trace.no-point")) {
      to.push_back(point);
    }
  }
  void readElement(const Json& json, const std::string& where, std::vector<TraceGoal>& to) {
    if (expect(json.is_object(), where, "trace.no-object")) {
      TraceGoal& goal = to.emplace_back();
      readMember(json, where + ".", "id", goal.id);
      readMember(json, where + ".", "x", goal.position.x());
      readMember(json, where + ".", "y", goal.position.y());
      readMember(json, where + ".", "radius", goal.radius);
    }
  }
  template <class Part>
  void readElement(const Json& json, const std::string& where, std::vector<Part>& to) {
    if (expect(json.is_object(), where, "trace.no-object")) {
      to.push_back(part<Part>(json, where + "."));
    }
  }

  void read(const Json& json, const std::string& where,
            std::vector<std::pair<std::string, double>>& to) {
    if (!expect(json.is_object(), where, "trace.no-object")) {
      return;
    }
    for (const auto& [key, value] : json.items()) {
      double number = std::numeric_limits<double>::infinity();
      if (value == "inf" || value == "-inf") {
        to.emplace_back(key, value == "inf" ? number : -number);
      } else if (expect(finite(value, number), base::join({where, key}, "."),
                        "trace.no-parameter")) {
        to.emplace_back(key, number);
      }
    }
  }

  void read(const Json& json, const std::string& where, OccupancyGrid& map) {
    if (!expect(json.is_object(), where, "trace.no-object")) {
      return;
    }
    int width = 0;
    int height = 0;
    double resolution = 0.05;
    Pose2 origin;
    readMember(json, "map.", "width", width);
    readMember(json, "map.", "height", height);
    readMember(json, "map.", "resolution", resolution);
    readMember(json, "map.", "x", origin.position.x());
    readMember(json, "map.", "y", origin.position.y());
    readMember(json, "map.", "heading", origin.heading);
    requirePositive("map.resolution", resolution);
    const bool sized = width >= 0 && height >= 0;
    if (sized && std::int64_t{width} * height > kMaxMapCells) {
      error("map", "trace.map-too-large", {kMaxMapCells, width, height});
      return;
    }
    const std::size_t count =
        sized ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0;
    std::vector<std::int8_t> cells;
    const auto runs = json.find("cells");
    if (runs == json.end()) {
      error("map.cells", "trace.missing");
    }
    if (expect(sized && runs != json.end() && expandCells(*runs, count, cells), "map.cells",
               "trace.bad-cells") &&
        !cells.empty() && resolution > 0.0) {
      map = OccupancyGrid(width, height, resolution, origin, std::move(cells));
    }
  }

  void read(const Json& json, const std::string& where, TraceMetrics& metrics) {
    if (expect(json.is_object(), where, "trace.no-object")) {
      metrics = part<TraceMetrics>(json, where + ".");
    }
  }

  void requirePositive(const std::string& where, double value) {
    expect(value > 0.0, where, "trace.not-positive");
  }
  template <class T>
  void check(const std::string& path, const T& part) {
    if constexpr (std::is_same_v<T, TraceHeader>) {
      if (part.format > kFormat) {
        error("format", "trace.newer", {kFormat});
      }
      requirePositive(path + "dt", part.dt);
      requirePositive(path + "record_every", part.recordEvery);
      const bool isWrap =
          part.wrapX.empty() || (part.wrapX.size() == 2 && part.wrapX[0] < part.wrapX[1]);
      expect(isWrap, path + kWrap, "trace.no-list");
    } else if constexpr (std::is_same_v<T, TraceHuman> || std::is_same_v<T, TraceRobot>) {
      requirePositive(path + "radius", part.radius);
    }
  }

  const std::string& text_;
  const std::string& file_;
  base::Diagnostics& problems_;
  std::optional<JsonLineIndex> places_;  // created for the first problem
};

/// `reason` ends with the number in quotes: "number overflow parsing '1e999'".
base::Diagnostic tooLarge(const std::string& text, const std::string& reason,
                          const std::string& file) {
  const std::size_t quote = std::min(reason.find('\''), reason.size());
  const std::string number = reason.substr(std::min(quote + 1, reason.size()));
  const std::size_t at = text.find(number.substr(0, number.find('\'')));
  const base::Diagnostic place = jsonSyntaxError(text, at == std::string::npos ? 0 : at + 1, file);
  return base::error("trace.number-too-large", {reason}, file, place.line, place.column);
}

// toJson: one overload per member type.
/// Numbers that are not finite become strings.
Json toJson(double value) {
  if (std::isfinite(value)) {
    return value;
  }
  return std::isnan(value) ? "nan" : (value > 0 ? "inf" : "-inf");
}
Json toJson(const Vec2& point) {
  return {toJson(point.x()), toJson(point.y())};
}
Json toJson(const TraceGoal& goal) {
  return {{"id", goal.id},
          {"x", toJson(goal.position.x())},
          {"y", toJson(goal.position.y())},
          {"radius", toJson(goal.radius)}};
}
Json toJson(const std::vector<std::pair<std::string, double>>& parameters) {
  Json json = Json::object();
  for (const auto& [key, value] : parameters) {
    json[key] = toJson(value);
  }
  return json;
}

/// Alternating values and repetition counts, row by row from the lower left.
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
          {"resolution", toJson(map.resolution())},
          {"x", toJson(map.origin().position.x())},
          {"y", toJson(map.origin().position.y())},
          {"heading", toJson(map.origin().heading)},
          {"cells", runLengths(map.cells())}};
}

template <class T>
Json toJson(const std::vector<T>& values);

/// Structs by their members; strings, numbers and booleans unchanged.
template <class T>
Json toJson(const T& value) {
  if constexpr (std::is_same_v<T, Outline>) {
    return toJson(value.points);
  } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
    Json json = Json::object();
    forEachMember(value,
                  [&json](const char* name, const auto& member) { json[name] = toJson(member); });
    if constexpr (std::is_same_v<T, TraceHuman>) {
      if (!value.customTree) {
        json.erase(kCustomTree);
      }
    }
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
  return base::jsonText(json, -1);
}

/// One line per member; lists have one line per element.
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

base::Result<TraceHeader> parseTraceJson(const std::string& text, const std::string& file) {
  Json root;
  try {
    root = Json::parse(base::shallowJson(text));
  } catch (const Json::parse_error& error) {
    return jsonSyntaxError(text, error.byte, file);
  } catch (const Json::exception& error) {  // number out of range
    return tooLarge(text, base::jsonErrorMessage(error.what()), file);
  }
  base::Diagnostics problems;
  if (!root.is_object()) {
    return base::error("trace.no-json-object", {}, file, 1, 1);
  }
  auto header = JsonReader(text, file, problems).part<TraceHeader>(root, "");
  return base::resultOf(std::move(header), std::move(problems));
}

std::string traceJson(const TraceHeader& header) {
  Json root = toJson(header);
  if (header.metrics == TraceMetrics()) {
    root.erase("metrics");
  }
  if (header.wrapX.empty()) {
    root.erase(kWrap);
  }
  std::string text = "{";
  for (const auto& [key, value] : root.items()) {
    text += (text.size() == 1 ? "\n " : ",\n ") + compact(key) + ": " + memberText(value);
  }
  return text + "\n}\n";
}

}  // namespace sim2d
