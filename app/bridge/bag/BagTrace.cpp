#include "app/bridge/bag/BagTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/bag/RunBagWriter.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Find.h"

namespace bridge {
namespace {

/// The result with problems that precede its own.
base::Result<sim2d::Trace> withProblems(base::Diagnostics problems,
                                        base::Result<sim2d::Trace> trace) {
  base::append(problems, trace.diagnostics());
  return trace ? base::Result<sim2d::Trace>(*std::move(trace), std::move(problems))
               : base::Result<sim2d::Trace>(std::move(problems));
}

const std::vector<sim2d::TraceGoal>* goalsOf(const sim2d::TraceHeader& header, int id) {
  if (const sim2d::TraceRobot* const robot = header.robot(id)) {
    return &robot->goals;
  }
  const sim2d::TraceHuman* const human = header.human(id);
  return human != nullptr ? &human->goals : nullptr;
}

/// The id of the goal at this position; kNoGoal: none.
int goalAt(const sim2d::TraceHeader& header, int id, const std::optional<base::Vec2>& place) {
  const std::vector<sim2d::TraceGoal>* const goals = goalsOf(header, id);
  if (!place || goals == nullptr) {
    return sim2d::kNoGoal;
  }
  const sim2d::TraceGoal* const found = base::findIf(*goals, [&](const sim2d::TraceGoal& goal) {
    return (goal.position - *place).norm() < kSamePlace;
  });
  return found == nullptr ? sim2d::kNoGoal : found->id;
}

using Frames = std::map<std::int64_t, sim2d::Frame>;  // by step

void addStates(const BagBody& body, const sim2d::TraceHeader& header, bool isRobot,
               Frames& frames) {
  for (const BagSample& sample : body.samples) {
    const std::int64_t step =
        std::llround(static_cast<double>(sample.time) * kNanosecond / header.dt);
    sim2d::Frame& frame = frames[step];
    frame.step = step;
    frame.time = static_cast<double>(step) * header.dt;
    sim2d::BodyColumns& columns =
        isRobot ? frame.robots : static_cast<sim2d::BodyColumns&>(frame.humans);
    columns.add(body.id, sample.pose, sample.velocity.value_or(base::Vec2::Zero()),
                sample.omega.value_or(0.0), goalAt(header, body.id, sample.goal));
    if (!isRobot) {
      frame.humans.group.push_back(sample.group);
      frame.humans.state.push_back(sample.state);
    }
  }
}

/// The rows of trajectory.csv, so that its reader validates them.
std::string rowsOf(const BagBodies& bodies, const sim2d::TraceHeader& header) {
  Frames frames;
  for (const auto& [id, body] : bodies.people) {
    addStates(body, header, false, frames);
  }
  const std::map<int, BagBody>& robots = bodies.robots;
  for (auto robot = robots.rbegin(); robot != robots.rend(); ++robot) {  // ids -1, -2 …
    addStates(robot->second, header, true, frames);
  }
  std::string rows = sim2d::headerLine(sim2d::kTrajectoryColumns);
  for (const auto& [step, frame] : frames) {
    sim2d::appendTrajectoryRows(rows, frame);
  }
  return rows;
}

/// Creates the trace of a hunavsim run: header and events from the metadata, bodies from the
/// messages.
base::Result<sim2d::Trace> readHunavsimBag(Bag& bag, const std::string& path) {
  sim2d::TraceTexts texts{{path + " trajectory", {}},
                          {path + " events.csv", bag.metadata(kRunMetadata, "events.csv")},
                          {path + " trace.json", bag.metadata(kRunMetadata, "trace.json")}};
  const base::Result<sim2d::TraceHeader> header =
      sim2d::parseTraceJson(texts.header.content, texts.header.path);
  if (!header) {
    return header.diagnostics();
  }
  base::Diagnostics problems;
  const BagBodies bodies = readBodies(bag, hunavsimTopics(bag.channels()), path, problems);
  if (base::hasErrors(problems) || bodies.hasInvalidSamples) {
    return problems;  // the run cannot be reconstructed
  }
  texts.trajectory.content = rowsOf(bodies, *header);
  return withProblems(std::move(problems), sim2d::parseTrace(texts));
}

/// Whether the bag is used unmodified: no options for topics, robots or time step.
bool isUnmodified(Bag& bag, const BagTopicOptions& use, const sim2d::TrackOptions& options) {
  const bool isChosen = !use.people.empty() || !use.robot.empty() || !use.map.empty() ||
                        options.robotId || !options.robotName.empty() || options.robotGoal ||
                        options.step > 0.0;
  return !isChosen && !bag.metadata(kRunMetadata, "trace.json").empty() &&
         hunavsimTopics(bag.channels()).people;
}

constexpr double kUsualGoalRadius = 0.2;  // [m]
constexpr double kStanding = 0.05;        // [m], noise of a body at rest
constexpr double kArrivalSlack = 0.3;     // [m]; a goal given up farther away was abandoned

/// Creates a trace from a third-party recording, resampled to a uniform time grid.
class ThirdPartyTrace {
 public:
  ThirdPartyTrace(const BagBodies& bodies, const sim2d::TrackOptions& options, std::string path)
      : bodies_(bodies), options_(options) {
    file_.file = std::move(path);
  }

  base::Result<sim2d::Trace> make(sim2d::RecordedPoints* points) {
    findBegin();
    for (const auto& [id, body] : bodies_.people) {
      addTrack(body, id, true);
    }
    const BagBody* const robot = robotWithMostSamples();
    if (robot != nullptr) {
      addTrack(*robot, freeId(), !robot->properties);
      file_.tracks.back().isRobot = true;
    }
    base::Result<sim2d::Trace> trace = sim2d::traceOfTracks(file_, options_, &links_);
    if (trace) {
      isRobotOfBag_ = robot != nullptr && robotOfTrace() == robot;
      describe(*trace);
      if (points != nullptr) {
        takePoints(*points);
      }
    }
    return trace;
  }
  /// Warnings about discarded data.
  base::Diagnostics remarks() const {
    return discardedSamples_ == 0 ? base::Diagnostics()
                                  : base::Diagnostics{base::warning(
                                        "bag.same-stamp", {discardedSamples_}, file_.file)};
  }

 private:
  void findBegin() {
    for (const std::map<int, BagBody>* bodies : {&bodies_.people, &bodies_.robots}) {
      for (const auto& [id, body] : *bodies) {
        for (const BagSample& sample : body.samples) {
          begin_ = std::min(begin_.value_or(sample.time), sample.time);
        }
      }
    }
  }

  /// Some wrappers publish a robot with another id until their own is available.
  const BagBody* robotWithMostSamples() const {
    const BagBody* most = nullptr;
    for (const auto& [id, body] : bodies_.robots) {
      most = most == nullptr || body.samples.size() > most->samples.size() ? &body : most;
    }
    return most;
  }

  /// The body that is the trace's robot: a person, if the user has selected one.
  const BagBody* robotOfTrace() const {
    const sim2d::TrackLinks::Link* const link =
        base::findBy(links_.links, &sim2d::TrackLinks::Link::isRobot, true);
    return link == nullptr ? nullptr : bodiesOfTracks_[link->track];
  }

  int freeId() const {
    const auto& people = bodies_.people;
    const int last = people.empty() ? -1 : std::max(people.rbegin()->first, 0);
    if (last < std::numeric_limits<int>::max()) {
      return last + 1;
    }
    int id = 0;
    while (people.count(id) > 0) {
      ++id;
    }
    return id;
  }

  double secondsOf(std::int64_t time) const {
    return static_cast<double>(time - begin_.value_or(0)) * kNanosecond;
  }

  /// `hasStamps`: has its own stamps. robot_states uses those of people, often one for two
  /// messages.
  void addTrack(const BagBody& body, int id, bool hasStamps) {
    sim2d::Track track;
    track.id = id;
    track.name = body.name;
    if (body.properties && body.properties->radius > 0.0F) {
      track.radius = shortestDecimal(body.properties->radius);
    }
    bodiesOfTracks_.push_back(&body);
    std::vector<const BagSample*>& taken = samples_.emplace_back();
    for (const BagSample& sample : body.samples) {
      if (!taken.empty() && sample.time == taken.back()->time) {  // duplicate
        const bool isElsewhere = sample.pose.position != track.points.back().position;
        discardedSamples_ += isElsewhere && hasStamps ? 1U : 0U;
        continue;
      }
      taken.push_back(&sample);
      sim2d::TrackPoint point;
      point.time = secondsOf(sample.time);
      point.position = sample.pose.position;
      point.velocity = sample.velocity;
      point.heading = sample.heading;
      point.angularSpeed = sample.omega;
      point.group = sample.group;
      point.state = sample.state;
      track.points.push_back(point);
    }
    track.group = body.samples.empty() ? -1 : body.samples.front().group;
    file_.tracks.push_back(std::move(track));
  }

  /// Takes the points of the observation nearest to each time step.
  void takePoints(sim2d::RecordedPoints& points) const {
    for (const sim2d::TrackLinks::Link& link : links_.links) {
      points.add(link.step, link.id, link.isRobot, samples_[link.track][link.point]->obstacles);
    }
    points.sort();
  }

  static void addParameters(const hunav_msgs::AgentBehavior& behavior, sim2d::TraceHuman& human) {
    for (const auto& [key, member] : kBehaviorParameters) {
      const float value = behavior.*member;
      if (value > 0.0F && value <= static_cast<float>(kMostFactor)) {
        human.parameters.emplace_back(key, shortestDecimal(value));
      }
    }
  }

  static void describeHuman(const BagBody& body, sim2d::TraceHuman& human) {
    human.name = body.name.empty() ? human.name : body.name;
    if (!body.properties) {
      return;
    }
    const hunav_msgs::Agent& agent = *body.properties;
    human.desiredSpeed =
        agent.desiredVelocity > 0.0F ? shortestDecimal(agent.desiredVelocity) : human.desiredSpeed;
    human.behavior = std::clamp<int>(agent.behavior.type, 1, 6);
    human.configuration = std::clamp<int>(agent.behavior.configuration, 0, 3);
    human.cyclicGoals = agent.cyclicGoals;
    addParameters(agent.behavior, human);
    for (std::size_t k = 0; k < agent.goals.size(); ++k) {
      const geometry_msgs::Point& place = agent.goals[k].position;
      human.goals.push_back(
          {static_cast<int>(k) + 1, {place.x, place.y}, shortestDecimal(agent.goalRadius)});
    }
  }

  /// The goals in the robot's messages, then those sent to it.
  std::vector<base::Vec2> goalsOf(const BagBody& body) const {
    std::vector<base::Vec2> goals;
    for (std::size_t k = 0; body.properties && k < body.properties->goals.size(); ++k) {
      const geometry_msgs::Point& place = body.properties->goals[k].position;
      goals.emplace_back(place.x, place.y);
    }
    for (const base::Vec2& sent : bodies_.goals) {
      if (isRobotOfBag_ && std::none_of(goals.begin(), goals.end(), [&](const base::Vec2& goal) {
            return (goal - sent).norm() < kSamePlace;
          })) {
        goals.push_back(sent);
      }
    }
    return goals;
  }

  void describeRobot(sim2d::Trace& trace, const BagBody& body) const {
    sim2d::TraceRobot& robot = trace.header.robots.front();
    robot.startTime = startOf(body);
    double radius = 0.0;  // of the goals
    if (body.properties) {
      robot.name = body.name.empty() ? robot.name : body.name;
      robot.maxVel = body.properties->desiredVelocity > 0.0F
                         ? shortestDecimal(body.properties->desiredVelocity)
                         : robot.maxVel;
      radius = shortestDecimal(body.properties->goalRadius);
    }
    if (!options_.robotGoal) {
      for (const base::Vec2& goal : goalsOf(body)) {
        robot.goals.push_back({0, goal, kUsualGoalRadius});
      }
    }
    for (sim2d::TraceGoal& goal : robot.goals) {
      goal.radius = radius > 0.0 ? radius : goal.radius;
    }
    if (!options_.robotGoal && !robot.goals.empty() &&
        !addArrival(trace, body, trace.header.robots.front().id, robot.goals)) {
      sim2d::addArrivalEvent(trace, robot.goals.back());
    }
  }

  /// The time of the first goal if the robot stood still until then: a robot waiting for its goal
  /// has not started.
  double startOf(const BagBody& body) const {
    const std::optional<std::int64_t> sent = bodies_.firstGoal;
    if (!isRobotOfBag_ || !sent || body.samples.empty() || *sent > body.samples.back().time) {
      return 0.0;
    }
    const base::Vec2& place = body.samples.front().pose.position;
    for (const BagSample& sample : body.samples) {
      if (sample.time < *sent && (sample.pose.position - place).norm() > kStanding) {
        return 0.0;
      }
    }
    return std::max(secondsOf(*sent) - links_.begin, 0.0);
  }

  /// Adds an arrival event at the first message without goals after the last one with goals, if the
  /// body is at a goal then.
  bool addArrival(sim2d::Trace& trace, const BagBody& body, int id,
                  const std::vector<sim2d::TraceGoal>& goals) const {
    const auto last = std::find_if(body.samples.rbegin(), body.samples.rend(),
                                   [](const BagSample& sample) { return sample.goal.has_value(); });
    if (last == body.samples.rend() || last == body.samples.rbegin()) {
      return false;
    }
    const BagSample& then = *std::prev(last);
    const bool isThere = std::any_of(goals.begin(), goals.end(), [&](const sim2d::TraceGoal& goal) {
      return (goal.position - then.pose.position).norm() <= goal.radius + kArrivalSlack;
    });
    const double time = secondsOf(then.time) - links_.begin;
    const auto frame = std::lower_bound(
        trace.frames.begin(), trace.frames.end(), time - 1e-6 * trace.header.dt,
        [](const sim2d::Frame& each, double wanted) { return each.time < wanted; });
    if (!isThere || frame == trace.frames.end()) {
      return false;
    }
    sim2d::Event event;
    event.kind = sim2d::EventKind::Arrived;
    event.id = id;
    trace.events.emplace_back(frame->step, std::move(event));
    return true;
  }

  /// An outline in every message is an obstacle; one that appears or disappears is a door.
  void addObstacles(sim2d::Trace& trace) const {
    const std::vector<BagObstacles>& all = bodies_.obstacles;
    for (const BagObstacles& some : all) {
      for (const BagObstacles::Part& part : some.parts) {
        if (base::findBy(trace.header.obstacles, &sim2d::TraceObstacle::name, part.name)) {
          continue;
        }
        const auto isIn = [&part](const BagObstacles& outlines) {
          return base::findBy(outlines.parts, &BagObstacles::Part::name, part.name) != nullptr;
        };
        sim2d::TraceObstacle obstacle;
        obstacle.name = part.name;
        obstacle.outlines = part.outlines;
        bool isThere = isIn(all.front());
        obstacle.open = !isThere;
        for (const BagObstacles& later : all) {
          if (isIn(later) != isThere) {
            isThere = !isThere;
            obstacle.toggles.push_back(secondsOf(later.time) - links_.begin);
          }
        }
        obstacle.isDoor = !obstacle.toggles.empty();
        trace.header.obstacles.push_back(std::move(obstacle));
      }
    }
  }

  void describe(sim2d::Trace& trace) const {
    for (sim2d::TraceHuman& human : trace.header.humans) {
      const auto body = bodies_.people.find(human.id);
      if (body != bodies_.people.end()) {
        describeHuman(body->second, human);
        if (!human.cyclicGoals && !human.goals.empty()) {
          addArrival(trace, body->second, human.id, human.goals);
        }
      }
    }
    const BagBody* const robot = robotOfTrace();
    if (robot != nullptr && !trace.header.robots.empty()) {
      describeRobot(trace, *robot);
    }
    addObstacles(trace);
    if (bodies_.map) {
      sim2d::setMap(trace, *bodies_.map);
    }
    std::stable_sort(trace.events.begin(), trace.events.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  const BagBodies& bodies_;
  sim2d::TrackOptions options_;
  sim2d::TrackFile file_;
  sim2d::TrackLinks links_;
  bool isRobotOfBag_ = false;  // the trace's robot is a robot of the bag
  std::vector<const BagBody*> bodiesOfTracks_;
  std::vector<std::vector<const BagSample*>> samples_;  // by track and point
  std::optional<std::int64_t> begin_;  // [ns]; epoch times exceed the precision of a double
  std::size_t discardedSamples_ = 0;   // samples with a duplicate stamp but another position
};

/// Creates a trace from a third-party recording, using only its messages.
base::Result<sim2d::Trace> readThirdPartyBag(Bag& bag, const std::string& path,
                                             const BagTopicOptions& use,
                                             const sim2d::TrackOptions& options,
                                             sim2d::RecordedPoints* points) {
  base::Diagnostics problems;
  const TopicSelection choice = selectTopics(bag.channels(), use, path, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  const BagBodies bodies = readBodies(bag, choice, path, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  ThirdPartyTrace foreign(bodies, options, path);
  base::Result<sim2d::Trace> trace = foreign.make(points);
  base::append(problems, foreign.remarks());
  return withProblems(std::move(problems), std::move(trace));
}

}  // namespace

base::Result<sim2d::Trace> readBagTrace(const std::string& path, const BagTopicOptions& use,
                                        const sim2d::TrackOptions& options,
                                        sim2d::RecordedPoints* points) {
  base::Result<std::unique_ptr<Bag>> bag = openBag(path);
  base::Diagnostics problems = bag.diagnostics();
  if (!bag) {
    return problems;
  }
  if (isUnmodified(**bag, use, options)) {
    base::Result<sim2d::Trace> own = readHunavsimBag(**bag, path);
    if (own) {
      return withProblems(std::move(problems), std::move(own));
    }
    problems.push_back(
        base::warning("bag.not-as-written", {own.diagnostics().front().message}, path));
  }
  return withProblems(std::move(problems), readThirdPartyBag(**bag, path, use, options, points));
}

}  // namespace bridge
