#include "sim2d/trace/Socnav3Surroundings.h"

#include <algorithm>
#include <cmath>

#include "sim2d/map/MapReader.h"
#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

constexpr double kWallThickness = 1e-5;  // [m], for walls given as lines

std::optional<double> finiteNumber(const nlohmann::json& value) {
  constexpr double kLargest = 1e15;  // for times; positions have a lower limit
  if (!value.is_number() || !(std::fabs(value.get<double>()) <= kLargest)) {
    return std::nullopt;
  }
  return value.get<double>();
}

bool isPlace(double coordinate) {
  return std::fabs(coordinate) <= kFarthestPosition;
}

/// Parses "[x1, y1, x2, y2]", "[[x1, y1], [x2, y2]]" or an object with x1, y1, x2, y2.
std::optional<Segment> wallOf(const nlohmann::json& wall) {
  std::vector<double> numbers;
  const auto add = [&numbers](const nlohmann::json& value) {
    if (const auto number = finiteNumber(value)) {
      numbers.push_back(*number);
    }
  };
  if (wall.is_object()) {
    for (const char* name : {"x1", "y1", "x2", "y2"}) {
      if (wall.contains(name)) {
        add(wall[name]);
      }
    }
  } else if (wall.is_array()) {
    for (const nlohmann::json& part : wall) {
      if (part.is_array()) {
        std::for_each(part.begin(), part.end(), add);
      } else {
        add(part);
      }
    }
  }
  if (numbers.size() != 4 || !std::all_of(numbers.begin(), numbers.end(), isPlace)) {
    return std::nullopt;
  }
  return Segment{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

/// A disc, or a rectangle with its length along its angle.
std::optional<Outline> outlineOf(const nlohmann::json& object) {
  const auto x = jsonNumber(object, {"x"});
  const auto y = jsonNumber(object, {"y"});
  const nlohmann::json* const shape = jsonMember(object, {"shape"});
  const nlohmann::json& sized = shape != nullptr && shape->is_object() ? *shape : object;
  const nlohmann::json* const type = jsonMember(sized, {"type"});
  const bool isDisc = type != nullptr && type->is_string() && *type == "circle";
  const auto isSize = [](double size) { return size > 0.0 && isPlace(size); };
  if (!x || !y || !isPlace(*x) || !isPlace(*y)) {
    return std::nullopt;
  }
  if (isDisc) {
    const double radius = socnav3Radius(object).value_or(0.0);
    return isSize(radius) ? std::optional(circleOutline({*x, *y}, radius)) : std::nullopt;
  }
  double width = jsonNumber(sized, {"width"}).value_or(0.0);
  double length = jsonNumber(sized, {"length", "height"}).value_or(0.0);
  if (const nlohmann::json* const size = jsonMember(object, {"size"});
      size != nullptr && size->is_array() && size->size() == 2) {
    length = finiteNumber((*size)[0]).value_or(0.0);
    width = finiteNumber((*size)[1]).value_or(0.0);
  }
  const double angle = jsonNumber(object, {"angle", "orientation", "theta"}).value_or(0.0);
  return isSize(width) && isSize(length)
             ? std::optional(boxOutline({{*x, *y}, angle}, length, width))
             : std::nullopt;
}

/// Values 0 and 1, or 0 to 100; -1: unknown.
std::vector<std::int8_t> cellsOf(const std::vector<double>& values) {
  const bool isShare = std::all_of(values.begin(), values.end(), [](double v) { return v <= 1.0; });
  std::vector<std::int8_t> cells;
  cells.reserve(values.size());
  for (const double value : values) {
    const double scaled = isShare && value > 0.0 ? 100.0 * value : value;
    cells.push_back(static_cast<std::int8_t>(std::lround(std::clamp(scaled, -1.0, 100.0))));
  }
  return cells;
}

/// Rows beginning at y_orig, or one flat list.
std::optional<std::vector<double>> valuesOf(const nlohmann::json& data, std::size_t width,
                                            std::size_t height) {
  std::vector<double> values;
  const auto add = [&values](const nlohmann::json& value) {
    const auto number = finiteNumber(value);
    values.push_back(number.value_or(0.0));
    return number.has_value();
  };
  if (!data.is_array()) {
    return std::nullopt;
  }
  for (const nlohmann::json& row : data) {
    const bool isRow =
        row.is_array() && row.size() == width && std::all_of(row.begin(), row.end(), add);
    if (!isRow && (row.is_array() || !add(row))) {
      return std::nullopt;
    }
  }
  return values.size() == width * height ? std::optional(std::move(values)) : std::nullopt;
}

std::optional<OccupancyGrid> gridOf(const nlohmann::json& grid) {
  const double width = jsonNumber(grid, {"width"}).value_or(0.0);
  const double height = jsonNumber(grid, {"height"}).value_or(0.0);
  const auto resolution = jsonNumber(grid, {"cell_size", "resolution"});
  const nlohmann::json* const data = jsonMember(grid, {"data"});
  constexpr double kLongest = 1e6;  // [cells] per side
  const bool isSized = width >= 1.0 && height >= 1.0 && width <= kLongest && height <= kLongest &&
                       width * height <= static_cast<double>(kMaxMapCells) && resolution &&
                       *resolution > 0.0 && *resolution <= 1000.0 && data != nullptr;
  if (!isSized) {
    return std::nullopt;
  }
  const auto values =
      valuesOf(*data, static_cast<std::size_t>(width), static_cast<std::size_t>(height));
  if (!values) {
    return std::nullopt;
  }
  const Pose2 origin{
      {jsonNumber(grid, {"x_orig"}).value_or(0.0), jsonNumber(grid, {"y_orig"}).value_or(0.0)},
      jsonNumber(grid, {"angle_orig"}).value_or(0.0)};
  return OccupancyGrid(static_cast<int>(width), static_cast<int>(height), *resolution, origin,
                       cellsOf(*values));
}

/// Calls `take(element, index)` for each element of a list; warns with the number of rejected ones.
template <class Take>
void takeEach(const nlohmann::json* list, const char* name, const TrackInput& input, Take take) {
  if (list == nullptr || list->is_null()) {
    return;
  }
  std::size_t refused = list->is_array() ? 0 : 1;
  for (std::size_t k = 0; list->is_array() && k < list->size(); ++k) {
    refused += take((*list)[k], k) ? 0U : 1U;
  }
  if (refused > 0) {
    input.warning("tracks.left-out", {refused, name});
  }
}

}  // namespace

const nlohmann::json* jsonMember(const nlohmann::json& of,
                                 std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto found = of.is_object() ? of.find(name) : of.end();
        of.is_object() && found != of.end()) {
      return &*found;
    }
  }
  return nullptr;
}

std::optional<double> jsonNumber(const nlohmann::json& of,
                                 std::initializer_list<const char*> names) {
  const nlohmann::json* const member = jsonMember(of, names);
  return member == nullptr ? std::nullopt : finiteNumber(*member);
}

std::optional<double> socnav3Radius(const nlohmann::json& body) {
  if (const auto radius = jsonNumber(body, {"radius"})) {
    return *radius > 0.0 ? radius : std::nullopt;
  }
  const nlohmann::json* const shape = jsonMember(body, {"shape"});
  if (shape == nullptr) {
    return std::nullopt;
  }
  const double side = std::max(jsonNumber(*shape, {"width"}).value_or(0.0),
                               jsonNumber(*shape, {"length", "height"}).value_or(0.0));
  const double radius = jsonNumber(*shape, {"radius"}).value_or(0.5 * side);
  return radius > 0.0 ? std::optional(radius) : std::nullopt;
}

void readSocnav3Surroundings(const std::vector<const nlohmann::json*>& places,
                             const TrackInput& input, TrackFile& file) {
  const auto find = [&places](std::initializer_list<const char*> names) {
    const nlohmann::json* found = nullptr;
    for (const nlohmann::json* place : places) {
      found = found == nullptr && place != nullptr ? jsonMember(*place, names) : found;
    }
    return found;
  };
  TraceObstacle walls;
  walls.name = "walls";
  takeEach(find({"walls"}), "walls", input,
           [&walls](const nlohmann::json& each, std::size_t /*index*/) {
             const std::optional<Segment> wall = wallOf(each);
             if (wall && wall->a != wall->b) {
               for (Outline& outline : wallOutlines({wall->a, wall->b}, kWallThickness)) {
                 walls.outlines.push_back(std::move(outline));
               }
             }
             return wall.has_value();
           });
  if (!walls.outlines.empty()) {
    file.obstacles.push_back(std::move(walls));
  }
  takeEach(find({"objects"}), "objects", input,
           [&file](const nlohmann::json& each, std::size_t index) {
             const std::optional<Outline> outline = outlineOf(each);
             if (outline) {
               TraceObstacle object;
               object.name = "object" + std::to_string(index + 1);
               object.outlines.push_back(*outline);
               file.obstacles.push_back(std::move(object));
             }
             return outline.has_value();
           });
  if (const nlohmann::json* const grid = find({"grid", "map"});
      grid != nullptr && !grid->is_null()) {
    if (std::optional<OccupancyGrid> map = gridOf(*grid)) {
      file.map = *std::move(map);
    } else {
      input.warning("tracks.left-out", {1, "grid"});
    }
  }
}

}  // namespace sim2d
