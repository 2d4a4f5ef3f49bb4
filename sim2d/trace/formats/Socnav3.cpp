#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/JsonInput.h"

/// SocNav3 and SocNavData: a JSON object with a list "sequence" of instants, each with "timestamp"
/// [s], "robot" {x, y, angle}, "people" [{id, x, y, angle}] and "goal" {x, y, pos_threshold};
/// walls, objects and obstacle grid in the instants or next to the list. Metres and radians.
namespace sim2d {

namespace {

using Json = nlohmann::json;

constexpr double kWallThickness = 1e-5;  // [m], for walls given as lines

std::optional<double> finiteNumber(const Json& value) {
  constexpr double kLargest = 1e15;  // for times; positions have a lower limit
  if (!value.is_number() || !(std::fabs(value.get<double>()) <= kLargest)) {
    return std::nullopt;
  }
  return value.get<double>();
}

bool isPlace(double coordinate) {
  return std::fabs(coordinate) <= kFarthestPosition;
}

/// The first existing member of an object; null: none, or not an object.
const Json* jsonMember(const Json& of, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto found = of.is_object() ? of.find(name) : of.end();
        of.is_object() && found != of.end()) {
      return &*found;
    }
  }
  return nullptr;
}

/// The same, as a finite number.
std::optional<double> jsonNumber(const Json& of, std::initializer_list<const char*> names) {
  const Json* const member = jsonMember(of, names);
  return member == nullptr ? std::nullopt : finiteNumber(*member);
}

/// Radius [m] of a body: "radius", or half of the larger side of "shape".
std::optional<double> socnav3Radius(const Json& body) {
  if (const auto radius = jsonNumber(body, {"radius"})) {
    return *radius > 0.0 ? radius : std::nullopt;
  }
  const Json* const shape = jsonMember(body, {"shape"});
  if (shape == nullptr) {
    return std::nullopt;
  }
  const double side = std::max(jsonNumber(*shape, {"width"}).value_or(0.0),
                               jsonNumber(*shape, {"length", "height"}).value_or(0.0));
  const double radius = jsonNumber(*shape, {"radius"}).value_or(0.5 * side);
  return radius > 0.0 ? std::optional(radius) : std::nullopt;
}

/// Parses "[x1, y1, x2, y2]", "[[x1, y1], [x2, y2]]" or an object with x1, y1, x2, y2.
std::optional<Segment> wallOf(const Json& wall) {
  std::vector<double> numbers;
  const auto add = [&numbers](const Json& value) {
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
    for (const Json& part : wall) {
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
std::optional<Outline> outlineOf(const Json& object) {
  const auto x = jsonNumber(object, {"x"});
  const auto y = jsonNumber(object, {"y"});
  const Json* const shape = jsonMember(object, {"shape"});
  const Json& sized = shape != nullptr && shape->is_object() ? *shape : object;
  const Json* const type = jsonMember(sized, {"type"});
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
  if (const Json* const size = jsonMember(object, {"size"});
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
std::optional<std::vector<double>> valuesOf(const Json& data, std::size_t width,
                                            std::size_t height) {
  std::vector<double> values;
  const auto add = [&values](const Json& value) {
    const auto number = finiteNumber(value);
    values.push_back(number.value_or(0.0));
    return number.has_value();
  };
  if (!data.is_array()) {
    return std::nullopt;
  }
  for (const Json& row : data) {
    const bool isRow =
        row.is_array() && row.size() == width && std::all_of(row.begin(), row.end(), add);
    if (!isRow && (row.is_array() || !add(row))) {
      return std::nullopt;
    }
  }
  return values.size() == width * height ? std::optional(std::move(values)) : std::nullopt;
}

std::optional<OccupancyGrid> gridOf(const Json& grid) {
  const double width = jsonNumber(grid, {"width"}).value_or(0.0);
  const double height = jsonNumber(grid, {"height"}).value_or(0.0);
  const auto resolution = jsonNumber(grid, {"cell_size", "resolution"});
  const Json* const data = jsonMember(grid, {"data"});
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
void takeEach(const Json* list, const char* name, const TrackInput& input, Take take) {
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

/// Reads "walls", "objects" and "grid" from the first of `places` that has them. Invalid elements
/// are omitted with a warning.
void readSocnav3Surroundings(const std::vector<const Json*>& places, const TrackInput& input,
                             TrackFile& file) {
  const auto find = [&places](std::initializer_list<const char*> names) {
    const Json* found = nullptr;
    for (const Json* place : places) {
      found = found == nullptr && place != nullptr ? jsonMember(*place, names) : found;
    }
    return found;
  };
  TraceObstacle walls;
  walls.name = "walls";
  takeEach(find({"walls"}), "walls", input, [&walls](const Json& each, std::size_t /*index*/) {
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
  takeEach(find({"objects"}), "objects", input, [&file](const Json& each, std::size_t index) {
    const std::optional<Outline> outline = outlineOf(each);
    if (outline) {
      TraceObstacle object;
      object.name = "object" + std::to_string(index + 1);
      object.outlines.push_back(*outline);
      file.obstacles.push_back(std::move(object));
    }
    return outline.has_value();
  });
  if (const Json* const grid = find({"grid", "map"}); grid != nullptr && !grid->is_null()) {
    if (std::optional<OccupancyGrid> map = gridOf(*grid)) {
      file.map = *std::move(map);
    } else {
      input.warning("tracks.left-out", {1, "grid"});
    }
  }
}

class Socnav3Reader {
 public:
  explicit Socnav3Reader(const TrackInput& input) : input_(input) {}

  TrackFile read() {
    const std::optional<Json> root = parseJsonInput(input_);
    if (!root) {
      return {};
    }
    const Json* const sequence =
        root->is_array() ? &*root : jsonMember(*root, {"sequence", "frames", "trajectory"});
    if (sequence == nullptr || !sequence->is_array()) {
      problem("", "tracks.no-sequence");
      return {};
    }
    list_ = root->is_array()             ? ""
            : root->contains("sequence") ? "sequence"
            : root->contains("frames")   ? "frames"
                                         : "trajectory";
    const WordReader words(input_.path, input_.problems);
    for (std::size_t k = 0; k < sequence->size() && words.isUsable(); ++k) {
      takeInstant((*sequence)[k], k);
    }
    TrackFile file = finish();
    file.robotGoal = goal_;
    const Json* const first = sequence->empty() ? nullptr : &sequence->front();
    readSocnav3Surroundings({root->is_array() ? nullptr : &*root, first}, input_, file);
    return file;
  }

 private:
  /// `path`: within the list, "[3].robot".
  void problem(const std::string& path, std::string_view code, base::ProblemValues values = {}) {
    if (!places_) {
      places_.emplace(input_.text);
    }
    input_.error(code, std::move(values), places_->lineOf(list_ + path));
  }

  /// None: missing or not finite, which is reported.
  std::optional<double> number(const Json& of, std::initializer_list<const char*> names,
                               const std::string& path) {
    const std::optional<double> value = jsonNumber(of, names);
    if (!value) {
      problem(path, "tracks.no-member", {*names.begin(), path});
    }
    return value;
  }

  void takeInstant(const Json& instant, std::size_t index) {
    const std::string path = "[" + std::to_string(index) + "]";
    if (!instant.is_object()) {
      problem(path, "tracks.no-member", {"timestamp", path});
      return;
    }
    std::optional<double> time = jsonNumber(instant, {"timestamp", "time", "t"});
    if (index == 0) {
      hasTimes_ = time.has_value();
      begin_ = time.value_or(0.0);
    }
    if (!hasTimes_) {
      time = static_cast<double>(index);
    } else if (!time) {
      problem(path, "tracks.no-member", {"timestamp", path});
      return;
    }
    time = *time - begin_;  // Unix times exceed the precision
    if (const Json* const robot = jsonMember(instant, {"robot"}); robot != nullptr) {
      takeBody(*robot, *time, path + ".robot", robot_);
    }
    if (const Json* const people = jsonMember(instant, {"people", "humans", "pedestrians"})) {
      takePeople(*people, *time, path + ".people");
    }
    if (const Json* const goal = jsonMember(instant, {"goal"})) {
      takeGoal(*goal);
    }
  }

  void takeBody(const Json& body, double time, const std::string& path, Track& track) {
    const std::optional<double> x = number(body, {"x"}, path);
    const std::optional<double> y = x ? number(body, {"y"}, path) : std::nullopt;
    if (!x || !y) {
      return;
    }
    TrackPoint& point = track.points.emplace_back();
    point.time = time;
    point.position = Vec2(*x, *y);
    point.heading = jsonNumber(body, {"angle", "theta", "orientation", "heading", "a"});
    track.radius = track.radius ? track.radius : socnav3Radius(body);
  }

  /// A list, or an object with ids as keys.
  void takePeople(const Json& people, double time, const std::string& path) {
    if (!people.is_array() && !people.is_object()) {
      problem(path, "tracks.no-member", {"id", path});
      return;
    }
    std::size_t index = 0;
    for (const auto& [key, person] : people.items()) {
      const std::string place = path + "[" + std::to_string(index++) + "]";
      const Json* const id = jsonMember(person, {"id", "ID", "identifier", "name"});
      std::string word = people.is_object() ? key : std::string();
      if (id != nullptr && (id->is_number_integer() || id->is_string())) {
        word = id->is_string() ? id->get<std::string>() : std::to_string(id->get<long long>());
      }
      if (word.empty()) {
        problem(place, "tracks.no-member", {"id", place});
        continue;
      }
      takeBody(person, time, place, people_[word]);
    }
  }

  /// Of a list the last goal is used; a goal without a position means following a person.
  void takeGoal(const Json& goal) {
    if (goal.is_array() && !goal.empty() && goal.back().is_object()) {
      takeGoal(goal.back());
      return;
    }
    const auto x = jsonNumber(goal, {"x"});
    const auto y = jsonNumber(goal, {"y"});
    if (!x || !y) {
      return;
    }
    constexpr double kDefaultRadius = 0.2;  // [m]
    const double radius =
        jsonNumber(goal, {"pos_threshold", "radius", "threshold"}).value_or(kDefaultRadius);
    const Vec2 place(*x, *y);
    if (goal_ && (goal_->position - place).norm() > goal_->radius && !isGoalMoving_) {
      isGoalMoving_ = true;
      input_.warning("tracks.goal-changes");
    }
    goal_ = TraceGoal{0, place, radius > 0.0 ? radius : kDefaultRadius};
  }

  /// Numbers ids that are texts or out of range.
  TrackFile finish() {
    TrackFile file;
    constexpr long long kLargestId = 2000000000;  // the robot gets the next one
    const bool areNumbers = std::all_of(people_.begin(), people_.end(), [](const auto& person) {
      const std::optional<long long> id = base::parseInt(person.first);
      return id && *id >= 0 && *id <= kLargestId;
    });
    int next = 1;
    for (auto& [word, track] : people_) {
      track.id = areNumbers ? static_cast<int>(*base::parseInt(word)) : next;
      track.name = areNumbers ? "" : word;
      next = std::max(next, track.id) + 1;
      file.tracks.push_back(std::move(track));
    }
    if (!areNumbers) {
      std::vector<const Track*> numbered;
      for (const Track& track : file.tracks) {
        numbered.push_back(&track);
      }
      reportAssignedIds(input_, numbered);
    }
    if (!robot_.points.empty()) {
      robot_.id = next;
      robot_.name = "robot";
      robot_.isRobot = true;
      file.tracks.push_back(std::move(robot_));
    }
    if (!hasTimes_) {
      framesToSeconds(file, rateOf(input_, 0.0));
    }
    return file;
  }

  const TrackInput& input_;
  std::optional<JsonLineIndex> places_;
  std::string list_;  // name of the list of instants
  bool hasTimes_ = true, isGoalMoving_ = false;
  double begin_ = 0.0;  // [s]
  Track robot_;
  std::map<std::string, Track> people_;
  std::optional<TraceGoal> goal_;
};

FormatMatch matchFormat(const FilePreview& preview) {
  const char first = preview.row.empty() ? ' ' : preview.row.front().text.front();
  const auto holds = [&preview](std::string_view word) {
    return preview.text.find(word) != std::string_view::npos;
  };
  const bool isList = first == '[' && holds("\"robot\"") && holds("\"timestamp\"");
  const bool isObject =
      first == '{' && holds("\"sequence\"") && (holds("\"robot\"") || holds("\"people\""));
  return isList || isObject ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addSocnav3(TrackFormats& to) {
  to.add({"socnav3", 15, matchFormat,
          [](const TrackInput& input) { return Socnav3Reader(input).read(); }});
}

}  // namespace sim2d
