#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/trace/TrackImport.h"

namespace sim2d {
namespace {

using Json = nlohmann::ordered_json;

struct BodySample {
  base::Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double omega = 0.0;            // [rad/s]
  int goal = kNoGoal;
};

struct RecordSample {
  double time = 0.0;                 // [s] since the first state
  std::map<int, BodySample> people;  // by id
  std::map<int, BodySample> robots;  // by id, -1, -2 …
};

/// Pedestrian ids of robots, following those of the people.
std::map<int, int> pedestrianIds(const TraceHeader& header) {
  int next = 0;
  for (const TraceHuman& human : header.humans) {
    next = std::max(next, human.id);
  }
  std::map<int, int> ids;
  for (const TraceRobot& robot : header.robots) {
    ids[robot.id] = ++next;
  }
  return ids;
}

base::Diagnostics robotsAsPeople(const TraceHeader& header, const std::map<int, int>& ids,
                                 std::size_t from) {
  base::Diagnostics notes;
  for (std::size_t k = from; k < header.robots.size(); ++k) {
    const TraceRobot& robot = header.robots[k];
    notes.push_back(base::problem(base::Severity::Info, "export.robot-as-person",
                                  {robot.name, ids.at(robot.id)}));
  }
  return notes;
}

/// One line: {"scene": …}.
std::string lineOf(const char* name, Json content) {
  Json line;
  line[name] = std::move(content);
  return base::jsonText(line, -1) + "\n";
}

constexpr std::size_t kSceneSamples = 21;  // 9 observed and 12 predicted, as in TrajNet++

/// Collects the scenes of each body: intervals in which it is present without a gap.
class SceneWriter {
 public:
  explicit SceneWriter(double rate) : rate_(rate) {}

  /// Adds the sample with index `sample`; indices must increase.
  void see(int pedestrian, std::size_t sample) {
    Span& span = spans_[pedestrian];
    if (span.count == 0 || span.first + span.count != sample) {
      span = {sample, 0};
    }
    if (++span.count == kSceneSamples) {
      scenes_.push_back({span.first, pedestrian});
      span = {};
    }
  }
  std::string text() {
    std::sort(scenes_.begin(), scenes_.end());
    std::string text;
    for (std::size_t k = 0; k < scenes_.size(); ++k) {
      const auto& [first, pedestrian] = scenes_[k];
      text += lineOf("scene", {{"id", k},
                               {"p", pedestrian},
                               {"s", first},
                               {"e", first + kSceneSamples - 1},
                               {"fps", rate_}});
    }
    return text;
  }

 private:
  struct Span {
    std::size_t first = 0, count = 0;
  };
  double rate_;
  std::map<int, Span> spans_;
  std::vector<std::pair<std::size_t, int>> scenes_;  // first sample, pedestrian
};

/// Edges of obstacles and of doors that are closed at the start.
Json wallsOf(const TraceHeader& header) {
  Json walls = Json::array();
  for (const TraceObstacle& obstacle : header.obstacles) {
    const bool isOfGrid = !header.map.isEmpty() && obstacle.name == "map";
    if (isOfGrid || (obstacle.isDoor && obstacle.open)) {
      continue;
    }
    for (const Outline& outline : obstacle.outlines) {
      for (std::size_t k = 0; k < outline.points.size(); ++k) {
        const Vec2& a = outline.points[k];
        const Vec2& b = outline.points[(k + 1) % outline.points.size()];
        walls.push_back({a.x(), a.y(), b.x(), b.y()});
      }
    }
  }
  return walls;
}

/// Rows from bottom to top: 1 occupied, 0 free, -1 unknown.
Json gridOf(const OccupancyGrid& map) {
  Json rows = Json::array();
  for (int row = 0; row < map.height(); ++row) {
    Json cells = Json::array();
    for (int column = 0; column < map.width(); ++column) {
      const Cell cell{column, row};
      cells.push_back(map.isUnknown(cell) ? -1 : map.isWall(cell) ? 1 : 0);
    }
    rows.push_back(std::move(cells));
  }
  return {{"width", map.width()},
          {"height", map.height()},
          {"cell_size", map.resolution()},
          {"x_orig", map.origin().position.x()},
          {"y_orig", map.origin().position.y()},
          {"angle_orig", map.origin().heading},
          {"data", std::move(rows)}};
}

/// The robot's current goal, else its last one.
Json goalOf(const TraceRobot& robot, int goal) {
  const TraceGoal* const found = base::findBy(robot.goals, &TraceGoal::id, goal);
  const TraceGoal& meant = found == nullptr ? robot.goals.back() : *found;
  return {{"type", "go-to"},
          {"human", nullptr},
          {"x", meant.position.x()},
          {"y", meant.position.y()},
          {"angle", 0.0},
          {"pos_threshold", meant.radius},
          {"angle_threshold", base::kPi}};
}

Json shapeOf(double radius) {
  return {{"type", "circle"}, {"width", 2.0 * radius}, {"length", 2.0 * radius}};
}

Json robotOf(const TraceRobot& robot, const BodySample& body) {
  const Vec2 forward = base::directionOf(body.pose.heading);
  const Vec2 left(-forward.y(), forward.x());
  return {{"x", body.pose.position.x()},        {"y", body.pose.position.y()},
          {"angle", body.pose.heading},         {"speed_x", body.velocity.dot(forward)},
          {"speed_y", body.velocity.dot(left)}, {"speed_a", body.omega},
          {"shape", shapeOf(robot.radius)}};
}

Json personOf(int id, const BodySample& body, double radius) {
  return {{"id", id},
          {"x", body.pose.position.x()},
          {"y", body.pose.position.y()},
          {"angle", body.pose.heading},
          {"shape", shapeOf(radius)}};
}

/// One instant; null: the robot is absent.
Json instantOf(const TraceHeader& header, const RecordSample& sample,
               const std::map<int, int>& ids) {
  const TraceRobot& robot = header.robots.front();
  const auto body = sample.robots.find(robot.id);
  if (body == sample.robots.end()) {
    return nullptr;
  }
  Json people = Json::array();
  for (const auto& [id, person] : sample.people) {
    const TraceHuman* const human = header.human(id);
    people.push_back(personOf(id, person, human == nullptr ? TraceHuman().radius : human->radius));
  }
  for (const TraceRobot& other : header.robots) {
    const auto place = sample.robots.find(other.id);
    if (other.id != robot.id && place != sample.robots.end()) {
      people.push_back(personOf(ids.at(other.id), place->second, other.radius));
    }
  }
  Json instant = {{"timestamp", sample.time},
                  {"robot", robotOf(robot, body->second)},
                  {"goal", nullptr},
                  {"people", std::move(people)},
                  {"objects", Json::array()}};
  if (!robot.goals.empty()) {
    instant["goal"] = goalOf(robot, body->second.goal);
  }
  return instant;
}

constexpr double kSameTime = 1e-6;  // fraction of a step

BodySample sampleOf(const BodyColumns& columns, std::size_t k) {
  return {{{columns.x[k], columns.y[k]}, columns.heading[k]},
          {columns.vx[k], columns.vy[k]},
          columns.omega[k],
          columns.goal[k]};
}

BodySample between(const BodySample& a, const BodySample& b, double share) {
  BodySample sample = a;
  sample.pose.position += share * (b.pose.position - a.pose.position);
  sample.pose.heading =
      base::wrapToPi(a.pose.heading + share * base::angleDiff(b.pose.heading, a.pose.heading));
  sample.velocity += share * (b.velocity - a.velocity);
  sample.omega += share * (b.omega - a.omega);
  return sample;
}

std::map<int, BodySample> bodiesOf(const BodyColumns& columns) {
  std::map<int, BodySample> bodies;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    bodies.emplace(columns.id[k], sampleOf(columns, k));
  }
  return bodies;
}

/// Only bodies that are in both states.
std::map<int, BodySample> bodiesBetween(const BodyColumns& a, const BodyColumns& b, double share) {
  const std::map<int, BodySample> later = bodiesOf(b);
  std::map<int, BodySample> bodies;
  for (const auto& [id, body] : bodiesOf(a)) {
    if (const auto found = later.find(id); found != later.end()) {
      bodies.emplace(id, between(body, found->second, share));
    }
  }
  return bodies;
}

/// Samples from the first state to the last at intervals of 1 / `rate` [s]; rate 0: the states
/// themselves. Bodies present in both neighbouring states are interpolated linearly.
class RecordSamples {
 public:
  RecordSamples(const Trace& trace, double rate) : trace_(trace), rate_(rate) {
    if (trace.frames.empty()) {
      return;
    }
    const double span = trace.frames.back().time - trace.frames.front().time;
    size_ = rate > 0.0 ? static_cast<std::size_t>(std::floor(span * rate + kSameTime)) + 1
                       : trace.frames.size();
  }

  std::size_t size() const { return size_; }
  RecordSample at(std::size_t index) const {
    const std::vector<Frame>& frames = trace_.frames;
    RecordSample sample;
    if (!(rate_ > 0.0)) {
      const Frame& frame = frames[index];
      sample.time = frame.time - frames.front().time;
      sample.people = bodiesOf(frame.humans);
      sample.robots = bodiesOf(frame.robots);
      return sample;
    }
    sample.time = static_cast<double>(index) / rate_;
    const double time = frames.front().time + sample.time;
    const double slack = kSameTime * trace_.header.dt;
    const auto next =
        std::upper_bound(frames.begin(), frames.end(), time + slack,
                         [](double value, const Frame& frame) { return value < frame.time; });
    const Frame& before = *(next - 1);  // exists: the first state is not later
    if (next == frames.end() || time - before.time <= slack) {
      sample.people = bodiesOf(before.humans);
      sample.robots = bodiesOf(before.robots);
      return sample;
    }
    const double share = (time - before.time) / (next->time - before.time);
    sample.people = bodiesBetween(before.humans, next->humans, share);
    sample.robots = bodiesBetween(before.robots, next->robots, share);
    return sample;
  }

 private:
  const Trace& trace_;
  double rate_;
  std::size_t size_ = 0;
};

}  // namespace

base::Result<std::string> trajnetText(const Trace& trace, double rate) {
  constexpr double kDefaultRate = 2.5;  // [1/s]
  const double used = rate > 0.0 ? rate : kDefaultRate;
  const RecordSamples samples(trace, used);
  if (samples.size() == 0) {
    return base::error("export.no-states");
  }
  const std::map<int, int> ids = pedestrianIds(trace.header);
  SceneWriter scenes(used);
  std::string tracks;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto add = [&](int id, const BodySample& body) {
      scenes.see(id, k);
      tracks += lineOf(
          "track",
          {{"f", k}, {"p", id}, {"x", body.pose.position.x()}, {"y", body.pose.position.y()}});
    };
    const RecordSample sample = samples.at(k);
    for (const auto& [id, body] : sample.people) {
      add(id, body);
    }
    for (const auto& [id, body] : sample.robots) {
      add(ids.at(id), body);
    }
  }
  base::Diagnostics notes = robotsAsPeople(trace.header, ids, 0);
  std::string text = scenes.text();
  if (text.empty()) {
    notes.push_back(base::warning("export.no-scene", {kSceneSamples}));
  }
  return {text + tracks, std::move(notes)};
}

base::Result<std::string> socnav3Text(const Trace& trace, double rate) {
  const TraceHeader& header = trace.header;
  if (header.robots.empty()) {
    return base::error("export.no-robot");
  }
  const RecordSamples samples(trace, rate);
  const std::map<int, int> ids = pedestrianIds(header);
  std::string instants;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Json instant = instantOf(header, samples.at(k), ids);
    if (!instant.is_null()) {
      instants += (instants.empty() ? "\n  " : ",\n  ") + base::jsonText(instant, -1);
    }
  }
  if (instants.empty()) {
    return base::error("export.no-states");
  }
  std::string text = "{\n";
  if (!header.map.isEmpty()) {
    text += " \"grid\": " + base::jsonText(gridOf(header.map), -1) + ",\n";
  }
  text += " \"walls\": " + base::jsonText(wallsOf(header), -1) + ",\n";
  text += " \"sequence\": [" + instants + "\n ]\n}\n";
  return {std::move(text), robotsAsPeople(header, ids, 1)};
}

}  // namespace sim2d
