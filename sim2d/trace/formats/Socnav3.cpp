#include <algorithm>
#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/JsonInput.h"
#include "sim2d/trace/Socnav3Surroundings.h"

/// SocNav3 and SocNavData: a JSON object with a list "sequence" of instants, each with "timestamp"
/// [s], "robot" {x, y, angle}, "people" [{id, x, y, angle}] and "goal" {x, y, pos_threshold};
/// walls, objects and obstacle grid in the instants or next to the list. Metres and radians.
namespace sim2d {

namespace {

using Json = nlohmann::json;

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
