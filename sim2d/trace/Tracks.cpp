#include "sim2d/trace/Tracks.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackSegments.h"

namespace sim2d {
namespace {

constexpr double kOnGrid = 1e-6;   // fraction of a step
constexpr double kOffGrid = 0.01;  // fraction of a step; larger offsets are reported
constexpr double kMaxInstants = 2e6;
constexpr double kFewInstants = 1e5;     // allowed for any number of observations
constexpr double kFewStates = 2e6;       // allowed for any number of observations
constexpr double kPerPoint = 100.0;      // instants and states per observation
constexpr double kPerOwnStep = 1000.0;   // the same if the user sets the step
constexpr double kMaxSteps = 1e15;       // for input times: larger integers are not exact
constexpr double kDefaultRadius = 0.35;  // [m]
constexpr double kGoalRadius = 0.2;      // [m], for a goal given by the user
constexpr int kRobotId = -1;

void appendState(BodyColumns& columns, int id, const TrackState& state) {
  columns.add(id, {state.position, state.heading}, state.velocity, state.omega, kNoGoal);
}

class TraceBuilder {
 public:
  TraceBuilder(const TrackFile& file, const TrackOptions& options, TrackLinks* links)
      : file_(file), options_(options), links_(links) {
    for (const Track& track : file.tracks) {
      observations_ += track.points.size();
    }
  }

  base::Result<Trace> make() {
    robot_ = checkTracks(file_, options_, problems_);
    if (base::hasErrors(problems_) || !makeGrid()) {
      return limitedPerKind(problems_);
    }
    rates_.emplace(file_, step_);
    reportGrid();
    trace_.header.scenario = std::filesystem::path(file_.file).filename().string();
    trace_.header.dt = step_;
    trace_.header.obstacles = file_.obstacles;
    if (!file_.map.isEmpty()) {
      setMap(trace_, file_.map);
    }
    std::vector<const Track*> tracks;
    for (const Track& track : file_.tracks) {
      if (&track != robot_ && !track.points.empty()) {
        tracks.push_back(&track);
      }
    }
    std::sort(tracks.begin(), tracks.end(),
              [](const Track* a, const Track* b) { return a->id < b->id; });
    for (const Track* track : tracks) {
      addPerson(*track);
      if (static_cast<double>(states_) > mostFor(kFewStates)) {
        problems_.push_back(base::error("tracks.too-many-states",
                                        {static_cast<long long>(mostFor(kFewStates))}, file_.file));
        return problems_;
      }
    }
    if (robot_ != nullptr) {
      addRobot();
    }
    if (links_ != nullptr) {
      links_->begin = timeOf(first_);
    }
    return {std::move(trace_), std::move(problems_)};
  }

 private:
  bool refuseLength(double most) {
    problems_.push_back(base::error("tracks.too-long", {static_cast<int>(most)}, file_.file));
    return false;
  }

  /// Limits instants and states in proportion to the observations (at least `few`), so that a small
  /// file cannot cause a huge recording.
  double mostFor(double few) const {
    const double perPoint = options_.step > 0.0 ? kPerOwnStep : kPerPoint;
    return std::max(few, perPoint * static_cast<double>(observations_));
  }

  /// Determines step, start and number of instants.
  bool makeGrid() {
    double begin = std::numeric_limits<double>::infinity();
    double end = -begin;
    for (const Track& track : file_.tracks) {
      if (!track.points.empty()) {
        begin = std::min(begin, track.points.front().time);
        end = std::max(end, track.points.back().time);
      }
    }
    const double told = options_.step > 0.0 ? options_.step : file_.step;
    const double median = told > 0.0 ? told : medianInterval(file_.tracks);
    step_ = median > 0.0 ? median : 1.0;  // single observations: any step
    if (!((end - begin) / step_ <= kMaxSteps)) {
      return refuseLength(kMaxInstants);
    }
    start_ = begin + commonPhase(begin);
    first_ = 0;
    double last = std::floor((end - begin) / step_ + kOnGrid);
    if (robot_ != nullptr) {
      first_ = indexFrom(robot_->points.front().time);
      last = std::floor((robot_->points.back().time - start_) / step_ + kOnGrid);
      last = std::max(last, static_cast<double>(first_));  // observed between two instants
    }
    const double most = std::min(kMaxInstants, mostFor(kFewInstants));
    if (!(last <= kMaxInstants) || !(last - static_cast<double>(first_) <= most)) {
      return refuseLength(most);
    }
    const auto count = static_cast<std::size_t>(last) - first_ + 1;
    trace_.frames.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      trace_.frames[k].step = static_cast<std::int64_t>(k);
      trace_.frames[k].time = static_cast<double>(k) * step_;
    }
    return true;
  }

  /// Offset (<= 0) from `begin` to a grid that matches the most observations (of the robot, if
  /// there is one).
  double commonPhase(double begin) const {
    if (file_.isSparse) {
      return 0.0;
    }
    std::map<long long, std::size_t> counts;  // by millionths of a step
    for (const Track& track : file_.tracks) {
      if (robot_ != nullptr && &track != robot_) {
        continue;
      }
      for (const TrackPoint& point : track.points) {
        const double steps = (point.time - begin) / step_;
        const double phase = std::floor((steps - std::floor(steps + kOnGrid)) / kOnGrid + 0.5);
        ++counts[static_cast<long long>(phase)];
      }
    }
    const auto most =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const double phase = static_cast<double>(most->first) * kOnGrid;
    return most->second == 1 || phase <= 2.0 * kOnGrid ? 0.0 : (phase - 1.0) * step_;
  }

  /// First instant at or after the time.
  std::size_t indexFrom(double time) const {
    return static_cast<std::size_t>(std::max(std::ceil((time - start_) / step_ - kOnGrid), 0.0));
  }
  double timeOf(std::size_t index) const { return start_ + static_cast<double>(index) * step_; }

  /// Calls `take(frame, state, nearest observation)` for the recorded instants within the stay; a
  /// stay between two instants is assigned to the nearest.
  template <class Take>
  void forEachInstant(const TrackSegment& segment, Take take) {
    std::size_t from = indexFrom(segment.begin());
    const double slack = kOnGrid * step_;
    if (timeOf(from) > segment.end() + slack) {
      from = static_cast<std::size_t>(std::llround((segment.begin() - start_) / step_));
      takeAt(from, segment, take);
      return;
    }
    const std::size_t past = first_ + trace_.frames.size();
    for (std::size_t k = std::max(from, first_); k < past && timeOf(k) <= segment.end() + slack;
         ++k) {
      takeAt(k, segment, take);
    }
  }
  template <class Take>
  void takeAt(std::size_t index, const TrackSegment& segment, Take take) {
    if (index >= first_ && index - first_ < trace_.frames.size()) {
      take(trace_.frames[index - first_], segment.at(timeOf(index), kOnGrid * step_),
           segment.nearest(timeOf(index)));
    }
  }

  /// Reports that observations are resampled to a common grid.
  void reportGrid() {
    if (rates_->report(problems_) || file_.isSparse || options_.step > 0.0) {
      return;
    }
    if (const std::size_t count = countOffGrid(); count > 0) {
      problems_.push_back(
          base::warning("tracks.off-grid", {count, base::formatDouble(step_)}, file_.file));
    }
  }

  /// Observations between the instants of the recording.
  std::size_t countOffGrid() const {
    std::size_t count = 0;
    for (const Track& track : file_.tracks) {
      for (const TrackPoint& point : track.points) {
        const double steps = (point.time - start_) / step_;
        count += std::fabs(steps - std::round(steps)) > kOffGrid ? 1U : 0U;
      }
    }
    return count;
  }

  void addPerson(const Track& track) {
    bool isThere = false;
    const double most = mostFor(kFewStates);
    for (const TrackSegment& segment : segmentsOf(track, rates_->longestGap(track))) {
      if (static_cast<double>(states_) > most) {
        break;
      }
      forEachInstant(segment,
                     [&](Frame& frame, const TrackState& state, const TrackPoint& nearest) {
                       HumanColumns& humans = frame.humans;
                       if (!humans.id.empty() && humans.id.back() == track.id) {
                         return;  // two short stays at one instant
                       }
                       appendState(humans, track.id, state);
                       humans.group.push_back(nearest.group.value_or(track.group));
                       humans.state.push_back(nearest.state);
                       link(frame, track, nearest);
                       isThere = true;
                       ++states_;
                     });
    }
    if (isThere) {
      TraceHuman human;
      human.id = track.id;
      human.name = "person" + std::to_string(track.id);
      human.kind = "adult";
      human.model = "recorded";
      human.radius = track.radius.value_or(kDefaultRadius);
      human.group = track.group;
      trace_.header.humans.push_back(std::move(human));
    }
  }

  void link(const Frame& frame, const Track& track, const TrackPoint& nearest) const {
    if (links_ != nullptr) {
      const bool isRobot = &track == robot_;
      links_->links.push_back({frame.step, isRobot ? kRobotId : track.id, isRobot,
                               static_cast<std::size_t>(&track - file_.tracks.data()),
                               static_cast<std::size_t>(&nearest - track.points.data())});
    }
  }

  /// The robot is always present: gaps in its track are straight lines, and the longest is
  /// reported.
  void reportGap() {
    const std::vector<TrackPoint>& points = robot_->points;
    const TrackPoint* before = nullptr;
    double longest = rates_->longestGap(*robot_);
    for (std::size_t k = 1; k < points.size(); ++k) {
      if (const double gap = points[k].time - points[k - 1].time; gap > longest) {
        longest = gap;
        before = &points[k - 1];
      }
    }
    if (before != nullptr) {
      problems_.push_back(base::warning("tracks.robot-gap", {base::formatDouble(longest)},
                                        file_.file, before->line, before->column));
    }
  }

  void addRobot() {
    reportGap();
    const TrackSegment segment(robot_->points.data(),
                               robot_->points.data() + robot_->points.size());
    double fastest = 0.0;
    for (std::size_t k = 0; k < trace_.frames.size(); ++k) {
      const double time = timeOf(first_ + k);
      const TrackState state = segment.at(time, kOnGrid * step_);
      appendState(trace_.frames[k].robots, kRobotId, state);
      link(trace_.frames[k], *robot_, segment.nearest(time));
      fastest = std::max(fastest, state.velocity.norm());
    }
    TraceRobot robot;
    robot.name = "robot1";
    robot.type = "recorded";
    robot.planner = "recorded";
    robot.radius = robot_->radius.value_or(kDefaultRadius);
    robot.maxVel = fastest > 0.0 ? fastest : robot.maxVel;
    if (options_.robotGoal || file_.robotGoal) {
      robot.goals.push_back(options_.robotGoal ? TraceGoal{0, *options_.robotGoal, kGoalRadius}
                                               : *file_.robotGoal);
      addArrivalEvent(trace_, robot.goals.back());
    }
    trace_.header.robots.push_back(std::move(robot));
  }

  const TrackFile& file_;
  const TrackOptions& options_;
  TrackLinks* links_;
  base::Diagnostics problems_;
  const Track* robot_ = nullptr;
  double step_ = 1.0, start_ = 0.0;
  std::size_t first_ = 0;
  std::size_t observations_ = 0;
  std::size_t states_ = 0;  // number of people's states so far
  std::optional<TrackRates> rates_;
  Trace trace_;
};

}  // namespace

base::Result<Trace> traceOfTracks(const TrackFile& file, const TrackOptions& options,
                                  TrackLinks* links) {
  return TraceBuilder(file, options, links).make();
}

void addArrivalEvent(Trace& trace, const TraceGoal& goal) {
  std::size_t first = trace.frames.size();
  for (std::size_t k = trace.frames.size(); k-- > 0;) {
    const RobotColumns& robots = trace.frames[k].robots;
    const Vec2 place(robots.x.back(), robots.y.back());
    if ((place - goal.position).norm() > goal.radius) {
      break;
    }
    first = k;
  }
  if (first < trace.frames.size()) {
    Event event;
    event.kind = EventKind::Arrived;
    event.id = kRobotId;
    trace.events.emplace_back(trace.frames[first].step, event);
  }
}

void setMap(Trace& trace, OccupancyGrid map) {
  std::vector<TraceObstacle>& obstacles = trace.header.obstacles;
  obstacles.erase(std::remove_if(obstacles.begin(), obstacles.end(),
                                 [](const TraceObstacle& o) { return o.name == kRecordedMap; }),
                  obstacles.end());
  TraceObstacle walls;
  walls.name = kRecordedMap;
  walls.outlines = traceOutlines(map);
  obstacles.insert(obstacles.begin(), std::move(walls));
  trace.header.map = std::move(map);
}

}  // namespace sim2d
