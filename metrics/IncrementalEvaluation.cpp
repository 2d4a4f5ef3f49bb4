#include "metrics/IncrementalEvaluation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "metrics/RobotMotion.h"
#include "sim2d/base/Find.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/RecordedPoints.h"

namespace metrics {

namespace {

std::shared_ptr<const RunContext> withReference(RunContext context, const Selection& selection) {
  if (!selection.reference.empty()) {
    context.reference = selection.reference;
  }
  return std::make_shared<const RunContext>(std::move(context));
}

Selection forSubset(Selection selection) {
  selection.series = selection.behaviorSeries;
  selection.seriesOnDisk = false;
  return selection;
}

bool isActive(const Sample& sample) {
  return std::any_of(sample.people.begin(), sample.people.end(),
                     [](const Pedestrian& person) { return person.state != 0; });
}

/// Copies the sample for the people of one type. Moves their obstacle points.
Sample takePeopleOfType(Sample& sample, int behavior) {
  const auto isOne = [behavior](const Pedestrian& person) { return person.behavior == behavior; };
  Sample part;
  part.people.reserve(
      static_cast<std::size_t>(std::count_if(sample.people.begin(), sample.people.end(), isOne)));
  part.time = sample.time;
  part.robot = sample.robot;
  for (Pedestrian& person : sample.people) {
    if (isOne(person)) {
      std::vector<sim2d::Obstacles::Point> points = std::move(person.obstacles);
      person.obstacles.clear();
      part.people.push_back(person);
      part.people.back().obstacles = std::move(points);
    }
  }
  return part;
}

/// HuNavSim's evaluator writes the series for all people if a metric has none of its own.
void copyMissingSeries(std::vector<MetricResult>& results, const std::vector<MetricResult>& all) {
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (!results[k].value.series) {
      results[k].value.series = all[k].value.series;
    }
  }
}

}  // namespace

IncrementalEvaluation::IncrementalEvaluation(const RunContext& context, const Selection& selection,
                                             const MetricParameters& parameters,
                                             const MetricRegistry& registry)
    : context_(withReference(context, selection)),
      selection_(selection),
      parameters_(parameters),
      gate_(selection.window, context),
      all_(context_, selection, parameters, registry) {
  // Creates the feeds of all types, since people of a type may appear later.
  for (std::size_t k = 0; selection.behaviors && k < kBehaviors; ++k) {
    behaviors_[k].feed = std::make_unique<AccumulatorSet>(
        context_, forSubset(selection), parameters, registry, PeopleFilter::Subset);
  }
}

void IncrementalEvaluation::note(double time, const sim2d::Event& event) {
  gate_.note(time, event);
  if (sim2d::isRobotArrival(event, context_->robotId) && !arrival_) {
    arrival_ = time;
    all_.addArrivalEvent(time);
    for (Behavior& behavior : behaviors_) {
      if (behavior.feed) {
        behavior.feed->addArrivalEvent(time);
      }
    }
  }
  if (event.kind == sim2d::EventKind::Enter && event.hasId) {
    entered_.insert(event.id);
  }
  if (!isOver_) {
    all_.note(time, event, isOnPath(time));
  }
}

/// An explicit start or end of the window replaces both ends of the robot's path.
bool IncrementalEvaluation::isWholeRecord() const {
  return usesHunavProfile() || selection_.window.from != "begin" ||
         selection_.window.until != "end";
}

bool IncrementalEvaluation::isOnPath(double time) const {
  if (!context_->hasRobot || isWholeRecord()) {
    return context_->hasRobot;
  }
  const bool isLate = arrival_ && time > *arrival_ + kTimeSlack;
  return time >= context_->robotStartTime - kTimeSlack && !isLate;
}

/// For an arrival between two samples the path ends at the second one.
RobotPathState IncrementalEvaluation::pathStateOf(const Sample& sample) {
  const double time = sample.time;
  RobotPathState onWay;
  onWay.is = isOnPath(arrival_ && !isAtGoal_ ? std::min(time, *arrival_) : time);
  isAtGoal_ = isAtGoal_ || (arrival_ && time >= *arrival_ - kTimeSlack);
  pathStart_ = onWay.is && !pathStart_ ? time : pathStart_;
  if (onWay.is && !arrival_ && !isWholeRecord() && !context_->goals.empty()) {
    const bool stands = isStanding(sample.robot, parameters_);
    hasMoved_ = hasMoved_ || !stands;
    onWay.isAtGoal = !context_->eventsReportArrivals && hasMoved_ && stands &&
                     isInGoalRegion(*context_, sample.robot.position, parameters_);
    onWay.isTooLate = time - *pathStart_ >= parameters_.timeLimit;
  }
  return onWay;
}

void IncrementalEvaluation::markNew(Sample& sample) {
  for (Pedestrian& person : sample.people) {
    person.isNew = entered_.count(person.id) > 0;
  }
  entered_.clear();
}

void IncrementalEvaluation::addToBehaviors(Sample& sample, const RobotPathState& onWay) {
  const bool anyActive = isActive(sample);
  for (std::size_t k = 0; k < kBehaviors; ++k) {
    Behavior& behavior = behaviors_[k];
    if (!behavior.feed) {
      continue;
    }
    Sample part = takePeopleOfType(sample, static_cast<int>(k) + 1);
    behavior.isMet = behavior.isMet || !part.people.empty();
    // HuNavSim's evaluator drops types that are missing at any sample.
    if (usesHunavProfile() && part.people.empty()) {
      behavior.feed.reset();
      continue;
    }
    if (selection_.behaviorSeries) {
      // Activity of the people of this type; HuNavSim's evaluator considers all people.
      behavior.active.push_back((usesHunavProfile() ? anyActive : isActive(part)) ? 1.0 : 0.0);
    }
    behavior.feed->add(std::move(part), onWay);
  }
}

void IncrementalEvaluation::add(Sample sample) {
  hasSamples_ = true;
  if (!gate_.takes(sample)) {
    isOver_ = gate_.isOver(sample.time);
    if (all_.size() == 0 || isOver_) {
      all_.forgetEvents();
    }
    return;
  }
  first_ = all_.size() == 0 ? sample.time : first_;
  if (selection_.series) {
    times_.push_back(sample.time - first_);
  }
  const RobotPathState onWay = pathStateOf(sample);
  markNew(sample);
  all_.add(std::move(sample), onWay);
  if (selection_.behaviors) {
    addToBehaviors(all_.newest(), onWay);
  }
}

base::Result<Evaluation> IncrementalEvaluation::finish(const SeriesSink& sink) const {
  if (!hasSamples_) {
    return base::error("metrics.no-samples");
  }
  if (const std::optional<base::Diagnostic> wrong = windowError(selection_.window)) {
    return base::withContext("metrics", *wrong);
  }
  if (all_.size() == 0) {
    return base::error("metrics.empty-window", {selection_.window.from, selection_.window.until});
  }
  Evaluation evaluation;
  evaluation.parameters = parameters_;
  evaluation.tag = selection_.tag;
  evaluation.robotId = selection_.robotId;
  evaluation.runId = selection_.runId;
  evaluation.isSelection = selection_.keys.has_value();
  evaluation.times = times_;
  evaluation.results = all_.values(nullptr, sink);
  evaluation.evaluatedPaths = all_.evaluatedPaths();
  if (all_.hasLostSeries()) {
    return base::error("metrics.series-lost");
  }
  for (std::size_t k = 0; k < kBehaviors; ++k) {
    if (!behaviors_[k].feed || !behaviors_[k].isMet) {
      continue;
    }
    BehaviorEvaluation behavior{static_cast<int>(k) + 1, behaviors_[k].active,
                                behaviors_[k].feed->values(&evaluation.results)};
    if (usesHunavProfile() && selection_.behaviorSeries) {
      copyMissingSeries(behavior.results, evaluation.results);
    }
    evaluation.behaviors.push_back(std::move(behavior));
  }
  return evaluation;
}

std::vector<std::string> robotNames(const std::vector<sim2d::TraceRobot>& robots) {
  std::vector<std::string> names;
  names.reserve(robots.size());
  for (const sim2d::TraceRobot& robot : robots) {
    std::string name = robot.name.empty() ? "robot" + std::to_string(-robot.id) : robot.name;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) {
          const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
          return !isLetter && !(c >= '0' && c <= '9') && c != '-';
        },
        '_');
    while (std::find(names.begin(), names.end(), name) != names.end()) {
      name += '_';
    }
    names.push_back(std::move(name));
  }
  return names;
}

FrameEvaluation::RobotEvaluation::RobotEvaluation(std::string its, const sim2d::TraceHeader& header,
                                                  const Selection& selection,
                                                  const MetricParameters& parameters,
                                                  const PrecomputedScene& known)
    : name(std::move(its)),
      id(selection.robotId),
      builder(header, selection.robotId, known),
      running(builder.context(), selection, parameters) {}

base::Result<Evaluation> FrameEvaluation::RobotEvaluation::finish(
    const RobotSeriesSink& sink) const {
  base::Result<Evaluation> made =
      running.finish(sink ? SeriesSink([&](const MetricInfo& info, const Series& series) {
        sink(name, info, series);
      })
                          : SeriesSink());
  if (made) {
    made->robot = name;
  }
  return made;
}

/// The window of this robot is empty, unlike that of the first.
Evaluation FrameEvaluation::RobotEvaluation::without(const Evaluation& first,
                                                     const base::Diagnostics& why) const {
  Evaluation evaluation;
  evaluation.parameters = first.parameters;
  evaluation.tag = first.tag;
  evaluation.runId = first.runId;
  evaluation.robotId = id;
  evaluation.robot = name;
  evaluation.isSelection = first.isSelection;
  evaluation.results.reserve(first.results.size());
  for (const MetricResult& result : first.results) {
    evaluation.results.push_back({result.info, undefinedValue(why.front().message)});
  }
  return evaluation;
}

FrameEvaluation::FrameEvaluation(const sim2d::TraceHeader& header, const Selection& selection,
                                 const MetricParameters& parameters,
                                 const PrecomputedScene& known) {
  const std::vector<std::string> names = robotNames(header.robots);
  robots_.reserve(header.robots.size() + 1);
  std::string chosen;
  for (std::size_t k = 0; k < names.size(); ++k) {
    chosen = header.robots[k].id == selection.robotId ? names[k] : chosen;
  }
  robots_.emplace_back(chosen, header, selection, parameters, known);
  for (std::size_t k = 0; selection.everyRobot && k < names.size(); ++k) {
    if (header.robots[k].id != selection.robotId) {
      Selection other = selection;
      other.robotId = header.robots[k].id;
      other.reference.clear();  // is of another robot
      robots_.emplace_back(names[k], header, other, parameters, known);
    }
  }
}

void FrameEvaluation::addHumans(const std::vector<sim2d::TraceHuman>& humans) {
  for (RobotEvaluation& robot : robots_) {
    robot.builder.addHumans(humans);
  }
}

void FrameEvaluation::note(double time, const sim2d::Event& event) {
  for (RobotEvaluation& robot : robots_) {
    robot.running.note(time, event);
  }
}

void FrameEvaluation::append(const sim2d::Frame& frame) {
  std::vector<Pedestrian> people = robots_.front().builder.peopleOf(frame);
  for (std::size_t k = robots_.size(); k-- > 1;) {
    robots_[k].running.add(robots_[k].builder.sampleOf(frame, people));
  }
  robots_.front().running.add(robots_.front().builder.sampleOf(frame, std::move(people)));
}

base::Result<Evaluation> FrameEvaluation::finish(const RobotSeriesSink& sink) const {
  base::Result<Evaluation> first = robots_.front().finish(sink);
  for (std::size_t k = 1; first && k < robots_.size(); ++k) {
    base::Result<Evaluation> other = robots_[k].finish(sink);
    first->others.push_back(other ? *std::move(other)
                                  : robots_[k].without(*first, other.diagnostics()));
  }
  return first;
}

const MetricResult* Evaluation::find(std::string_view key) const {
  return findResult(results, key);
}

const MetricResult* findResult(const std::vector<MetricResult>& results, std::string_view key) {
  return base::findIf(results,
                      [key](const MetricResult& result) { return result.info.key == key; });
}

namespace {

/// Passes the events and frames of a record in the order of time; events before the frame of their
/// time.
template <class Note, class Add>
void replay(const sim2d::Trace& trace, Note note, Add add) {
  auto event = trace.events.begin();
  const auto noteUntil = [&](double time) {
    for (; event != trace.events.end(); ++event) {
      const double itsTime = static_cast<double>(event->first) * trace.header.dt;
      if (itsTime > time + kTimeSlack) {
        return;
      }
      note(itsTime, event->second);
    }
  };
  for (const sim2d::Frame& frame : trace.frames) {
    noteUntil(frame.time);
    add(frame);
  }
  noteUntil(HUGE_VAL);
}

void takePoints(const sim2d::RecordedPoints::Range& points, Body& body) {
  body.obstacles.clear();
  for (const Vec2& point : points) {
    body.obstacles.push_back({point, lengthOf(point - body.position), false});
  }
}

Sample sampleWithPoints(const sim2d::Frame& frame, const sim2d::RecordedPoints& points,
                        SampleBuilder& builder) {
  std::vector<Pedestrian> people = builder.peopleOf(frame);
  for (Pedestrian& person : people) {
    if (points.hasPeople()) {
      takePoints(points.of(frame.step, person.id, false), person);
    }
  }
  Sample sample = builder.sampleOf(frame, std::move(people));
  if (points.hasRobot()) {
    Robot& robot = sample.robot;
    takePoints(points.of(frame.step, robot.id, true), robot);
    for (const sim2d::Obstacles::Point& point : robot.obstacles) {
      robot.obstacleDistance =
          std::min(robot.obstacleDistance.value_or(point.distance), point.distance);
    }
  }
  return sample;
}

}  // namespace

base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const Selection& selection,
                                  const MetricParameters& parameters) {
  FrameEvaluation evaluation(trace.header, selection, parameters);
  replay(
      trace, [&](double time, const sim2d::Event& event) { evaluation.note(time, event); },
      [&](const sim2d::Frame& frame) { evaluation.append(frame); });
  return evaluation.finish();
}

/// A record with points has at most one robot.
base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                  const Selection& selection, const MetricParameters& parameters) {
  if (points.isEmpty()) {
    return evaluate(trace, selection, parameters);
  }
  SampleBuilder builder(trace.header, selection.robotId);
  RunContext context = builder.context();
  context.hasObstacles = context.hasObstacles || points.hasRobot();
  IncrementalEvaluation running(context, selection, parameters);
  replay(
      trace, [&](double time, const sim2d::Event& event) { running.note(time, event); },
      [&](const sim2d::Frame& frame) { running.add(sampleWithPoints(frame, points, builder)); });
  base::Result<Evaluation> made = running.finish();
  const std::vector<sim2d::TraceRobot>& robots = trace.header.robots;
  for (std::size_t k = 0; made && k < robots.size(); ++k) {
    if (robots[k].id == selection.robotId) {
      made->robot = robotNames(robots)[k];
    }
  }
  return made;
}

}  // namespace metrics
