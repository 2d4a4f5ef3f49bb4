#include "metrics/Samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "metrics/ShortestPaths.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Frame.h"

namespace metrics {

double lengthOf(const Vec2& vector) {
  return std::hypot(vector.x(), vector.y());
}

double distance(const Body& a, const Body& b) {
  return lengthOf(a.position - b.position);
}

double distance(const Robot& robot, const Pedestrian& person) {
  return person.pair.isKnown ? person.pair.distance : lengthOf(robot.position - person.position);
}

double gap(const Robot& robot, const Pedestrian& person) {
  return distance(robot, person) - robot.radius - person.radius;
}

Vec2 Seam::nearest(const Vec2& place, const Vec2& seenFrom) const {
  const double turns = isThere() ? std::round((seenFrom.x() - place.x()) / length) : 0.0;
  return {place.x() + turns * length, place.y()};
}

Seam seamOf(const sim2d::TraceHeader& header) {
  return header.wrapX.size() == 2 ? Seam{header.wrapX[0], header.wrapX[1] - header.wrapX[0]}
                                  : Seam();
}

bool hasJumped(const Vec2& before, const Pedestrian& now, const Seam& seam) {
  return now.isNew || seam.nearest(now.position, before) != now.position;
}

const Pedestrian* findPerson(const Sample& sample, int id) {
  return base::findBy(sample.people, &Pedestrian::id, id);
}

namespace {

constexpr char kMapName[] = "map";
constexpr char kRecorded[] = "recorded";  // planner of a robot that was not simulated
constexpr char kSocialFactorKey[] = "social_force_factor";
constexpr double kObstacleReach = 5.0;  // [m]

template <class Columns>
void copyMotion(const Columns& columns, std::size_t k, Body& body) {
  body.id = columns.id[k];
  body.position = Vec2(columns.x[k], columns.y[k]);
  body.heading = columns.heading[k];
  body.velocity = Vec2(columns.vx[k], columns.vy[k]);
  body.speed = lengthOf(body.velocity);
  body.omega = columns.omega[k];
}

std::optional<double> socialFactorOf(const sim2d::TraceHuman& human) {
  using Parameter = std::pair<std::string, double>;
  const Parameter* const found =
      base::findBy(human.parameters, &Parameter::first, kSocialFactorKey);
  return found != nullptr ? std::optional<double>(found->second) : std::nullopt;
}

}  // namespace

std::vector<Vec2> shortestPath(const RunContext& context, const Vec2& from, const Vec2& to) {
  return context.routes ? context.routes->shortest(from, to) : std::vector<Vec2>{from, to};
}

SampleBuilder::SampleBuilder(const sim2d::TraceHeader& header, int robotId)
    : SampleBuilder(header, robotId, {}) {}

SampleBuilder::SampleBuilder(const sim2d::TraceHeader& header, int robotId,
                             const PrecomputedScene& known)
    : robotId_(robotId),
      header_(header),
      pathCache_(known.routes),
      usesRays_(header.obstaclePoints == "rays") {
  addHumans(header.humans);
  header_.humans.clear();
  for (const sim2d::TraceObstacle& obstacle : header_.obstacles) {
    Door door;
    door.part = all_.add(obstacle.outlines);
    if (obstacle.name != kMapName) {
      door.drawnPart = drawn_.add(obstacle.outlines);
      hasDrawn_ = true;
    }
    if (obstacle.isDoor) {
      door.openAtStart = obstacle.open;
      door.toggles = obstacle.toggles;
      doors_.push_back(door);
    }
  }
  if (known.obstacles != nullptr) {
    all_ = *known.obstacles;
  } else {
    all_.build();
  }
  drawn_.build();
}

void SampleBuilder::addHumans(const std::vector<sim2d::TraceHuman>& humans) {
  for (const sim2d::TraceHuman& human : humans) {
    humans_[human.id] = {human.radius, human.behavior, socialFactorOf(human),
                         !human.goals.empty() && !human.cyclicGoals};
  }
}

RunContext SampleBuilder::context() const {
  RunContext context;
  context.map = header_.map;
  context.seam = seamOf(header_);
  context.hasObstacles = !header_.map.isEmpty() ||
                         std::any_of(header_.obstacles.begin(), header_.obstacles.end(),
                                     [](const auto& each) { return !each.outlines.empty(); });
  sim2d::Obstacles standing = all_;
  for (const Door& door : doors_) {
    standing.setEnabled(door.part, false);
  }
  context.walls = std::make_shared<const sim2d::Obstacles>(std::move(standing));
  const sim2d::TraceRobot* robot = header_.robot(robotId_);
  if (robot == nullptr) {
    return context;
  }
  context.hasRobot = true;
  context.robotId = robotId_;
  context.robotStartTime = robot->startTime;
  context.robotMaxSpeed = robot->maxVel;
  context.eventsReportArrivals = !robot->planner.empty() && robot->planner != kRecorded;
  context.goals = robot->goals;
  context.routes = pathCache_ != nullptr
                       ? pathCache_->of(header_, context.walls, robot->radius)
                       : std::make_shared<ShortestPaths>(header_.map, context.walls, robot->radius);
  return context;
}

void SampleBuilder::setDoors(double time) {
  for (const Door& door : doors_) {
    const auto passed = std::count_if(door.toggles.begin(), door.toggles.end(),
                                      [&](double toggle) { return toggle - kTimeSlack <= time; });
    const bool open = door.openAtStart != (passed % 2 == 1);
    all_.setEnabled(door.part, !open);
    drawn_.setEnabled(door.drawnPart, !open);
  }
}

void SampleBuilder::addObstaclePoints(Body& body) {
  buffer_.clear();
  if (usesRays_) {
    all_.rayPoints(body.position, buffer_);
  } else {
    all_.boundaryPoints(body.position, buffer_);
  }
  body.obstacles = buffer_;
}

Sample SampleBuilder::sampleOf(const sim2d::Frame& frame, std::vector<Pedestrian> people) {
  setDoors(frame.time);
  Sample sample;
  sample.time = frame.time;
  const sim2d::TraceRobot* robot = header_.robot(robotId_);
  for (std::size_t k = 0; robot != nullptr && k < frame.robots.size(); ++k) {
    if (frame.robots.id[k] == robotId_) {
      copyMotion(frame.robots, k, sample.robot);
      sample.robot.radius = robot->radius;
      addObstaclePoints(sample.robot);
      const double clearance = all_.clearance(sample.robot.position, kObstacleReach);
      if (clearance < kObstacleReach) {
        sample.robot.obstacleDistance = clearance;
      }
    }
  }
  sample.people = std::move(people);
  const Vec2& eye = sample.robot.position;
  for (Pedestrian& person : sample.people) {  // `all_` first: usually cached by the robot's sensors
    person.screened = hasDrawn_ && robot != nullptr && !all_.isVisible(person.position, eye) &&
                      !drawn_.isVisible(person.position, eye);
  }
  return sample;
}

std::vector<Pedestrian> SampleBuilder::peopleOf(const sim2d::Frame& frame) {
  setDoors(frame.time);
  std::vector<Pedestrian> people(frame.humans.size());
  for (std::size_t k = 0; k < frame.humans.size(); ++k) {
    Pedestrian& person = people[k];
    copyMotion(frame.humans, k, person);
    person.group = frame.humans.group[k];
    person.state = frame.humans.state[k];
    const auto found = humans_.find(person.id);
    if (found != humans_.end()) {
      const Traits& traits = found->second;
      person.radius = traits.radius;
      person.behavior = traits.behavior;
      person.socialFactor = traits.socialFactor;
      person.wantsToArrive = traits.wantsToArrive;
    }
    addObstaclePoints(person);
  }
  return people;
}

namespace {

constexpr double kMotionSpeed = 0.01;  // [m/s]
constexpr double kNever = std::numeric_limits<double>::infinity();

/// The argument of "time 3.5" or "event say".
std::string argumentOf(const std::string& text, const std::string& word) {
  const std::string start = word + " ";
  return base::startsWith(text, start) ? base::trimmed(text.substr(start.size())) : "";
}

std::optional<base::Diagnostic> boundProblem(const std::string& text,
                                             const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), text) != words.end()) {
    return std::nullopt;
  }
  if (const std::string time = argumentOf(text, "time"); !time.empty()) {
    const std::optional<double> value = base::parseDouble(time);
    return value && std::isfinite(*value) ? std::nullopt
                                          : std::optional(base::error("metrics.no-time", {time}));
  }
  if (const std::string kind = argumentOf(text, "event"); !kind.empty()) {
    return sim2d::eventKindOf(kind) ? std::nullopt
                                    : std::optional(base::error("metrics.unknown-event", {kind}));
  }
  return base::error("metrics.unknown-bound", {text, base::join(words, ", ")});
}

/// Kind of "event KIND".
std::optional<sim2d::EventKind> kindOf(const std::string& text) {
  const std::string kind = argumentOf(text, "event");
  return kind.empty() ? std::nullopt : sim2d::eventKindOf(kind);
}

/// The time of "time T".
std::optional<double> timeArgument(const std::string& text) {
  const std::string time = argumentOf(text, "time");
  return time.empty() ? std::nullopt : base::parseDouble(time);
}

}  // namespace

std::optional<base::Diagnostic> windowError(const Window& window) {
  if (auto wrong = boundProblem(window.from, {"begin", "goal", "motion"})) {
    return base::withContext("from", *std::move(wrong));
  }
  if (auto wrong = boundProblem(window.until, {"end", "arrival"})) {
    return base::withContext("until", *std::move(wrong));
  }
  if (!(window.frequency >= 0.0) || std::isinf(window.frequency)) {
    return base::error("metrics.negative-frequency");
  }
  return std::nullopt;
}

WindowFilter::WindowFilter(Window window, const RunContext& context)
    : window_(std::move(window)),
      robotId_(context.robotId),
      begin_(timeArgument(window_.from)),
      end_(timeArgument(window_.until)),
      newest_(-kNever),
      next_(-kNever) {
  if (window_.from == "begin") {
    begin_ = -kNever;
  } else if (window_.from == "goal") {
    begin_ = context.robotStartTime;
  }
  end_ = window_.until == "end" ? kNever : end_;
}

void WindowFilter::begin(double time) {
  if (begin_) {
    return;
  }
  begin_ = time;
  if (!end_ && lastEnding_ && *lastEnding_ >= time) {
    end_ = lastEnding_;
  }
}

bool WindowFilter::ends(const sim2d::Event& event) const {
  return window_.until == "arrival" ? sim2d::isRobotArrival(event, robotId_)
                                    : kindOf(window_.until) == event.kind;
}

void WindowFilter::note(double time, const sim2d::Event& event) {
  if (kindOf(window_.from) == event.kind) {
    begin(time);
  }
  if (end_ || !ends(event)) {
    return;
  }
  lastEnding_ = time;
  if (begin_ && time >= *begin_) {
    end_ = time;
  }
}

/// For an arrival between two samples the second one is the last.
bool WindowFilter::isPast(double time) const {
  const bool isMet = end_ && (window_.until != "arrival" || newest_ >= *end_ - kTimeSlack);
  return isMet && time > *end_ + kTimeSlack;
}

bool WindowFilter::isOver(double time) const {
  return begin_ && isPast(time);
}

bool WindowFilter::takes(const Sample& sample) {
  if (window_.from == "motion" && sample.robot.speed > kMotionSpeed) {
    begin(sample.time);
  }
  const bool isInside = begin_ && sample.time >= *begin_ - kTimeSlack && !isPast(sample.time);
  if (!isInside || sample.time < next_ - kTimeSlack) {
    return false;
  }
  newest_ = sample.time;
  if (window_.frequency > 0.0) {
    // The grid starts at the first sample and does not drift if steps do not match it.
    first_ = taken_ == 0 ? sample.time : first_;
    const double place = std::floor((sample.time - first_ + kTimeSlack) * window_.frequency);
    taken_ = std::max(taken_, static_cast<long long>(place)) + 1;
    next_ = first_ + static_cast<double>(taken_) / window_.frequency;
  }
  return true;
}

}  // namespace metrics
