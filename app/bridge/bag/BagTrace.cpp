#include "app/bridge/bag/BagTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/bag/RunBag.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/TraceTexts.h"

namespace bridge {
namespace {

constexpr double kNanosecond = 1e-9;  // [s]
constexpr double kSamePlace = 1e-6;   // [m]

const std::vector<sim2d::TraceGoal>* goalsOf(const sim2d::TraceHeader& header, int id) {
  for (const sim2d::TraceRobot& robot : header.robots) {
    if (robot.id == id) {
      return &robot.goals;
    }
  }
  const sim2d::TraceHuman* const human = header.human(id);
  return human != nullptr ? &human->goals : nullptr;
}

/// The id of the goal of a record that stands there.
int goalAt(const sim2d::TraceHeader& header, int id, const std::optional<base::Vec2>& place) {
  const std::vector<sim2d::TraceGoal>* const goals = goalsOf(header, id);
  if (!place || goals == nullptr) {
    return sim2d::kNoGoal;
  }
  const auto found = std::find_if(goals->begin(), goals->end(), [&](const sim2d::TraceGoal& goal) {
    return (goal.position - *place).norm() < kSamePlace;
  });
  return found == goals->end() ? sim2d::kNoGoal : found->id;
}

/// A run of ours: header and events by their texts, bodies by their messages.
class OwnTrace {
 public:
  OwnTrace(Bag& bag, const std::string& path) : bag_(bag), path_(path) {}

  base::Result<sim2d::Trace> make() {
    sim2d::TraceTexts texts{{path_ + " trajectory", {}},
                            {path_ + " events.csv", bag_.metadata(kRunMetadata, "events.csv")},
                            {path_ + " trace.json", bag_.metadata(kRunMetadata, "trace.json")}};
    const base::Result<sim2d::TraceHeader> header =
        sim2d::parseTraceJson(texts.header.content, texts.header.path);
    if (!header) {
      return header.diagnostics();
    }
    BagBodies bodies(bag_, ownTopics(bag_.channels()), path_);
    base::Diagnostics problems = bodies.read();
    if (base::hasErrors(problems)) {
      return problems;
    }
    texts.trajectory.content = rowsOf(bodies, *header);
    base::Result<sim2d::Trace> trace = sim2d::parseTrace(texts);
    base::append(problems, trace.diagnostics());
    return trace ? base::Result<sim2d::Trace>(*std::move(trace), std::move(problems))
                 : base::Result<sim2d::Trace>(std::move(problems));
  }

 private:
  using Frames = std::map<std::int64_t, sim2d::Frame>;  // by step

  static void add(const BagBody& body, const sim2d::TraceHeader& header, bool isRobot,
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

  /// As trajectory.csv has them: its reader checks them.
  static std::string rowsOf(const BagBodies& bodies, const sim2d::TraceHeader& header) {
    Frames frames;
    for (const auto& [id, body] : bodies.people()) {
      add(body, header, false, frames);
    }
    const std::map<int, BagBody>& robots = bodies.robots();
    for (auto robot = robots.rbegin(); robot != robots.rend(); ++robot) {  // -1, -2 …
      add(robot->second, header, true, frames);
    }
    std::string rows = sim2d::headLine(sim2d::kTrajectoryColumns);
    for (const auto& [step, frame] : frames) {
      sim2d::appendTrajectoryRows(rows, frame);
    }
    return rows;
  }

  Bag& bag_;
  const std::string& path_;
};

/// A recording of others, brought onto a grid of times.
class ForeignTrace {
 public:
  ForeignTrace(const BagBodies& bodies, const sim2d::TrackOptions& options, std::string path)
      : bodies_(bodies), options_(options) {
    file_.file = std::move(path);
  }

  base::Result<sim2d::Trace> make() {
    for (const std::map<int, BagBody>* bodies : {&bodies_.people(), &bodies_.robots()}) {
      for (const auto& [id, body] : *bodies) {
        for (const BagSample& sample : body.samples) {
          begin_ = std::min(begin_.value_or(sample.time), sample.time);
        }
      }
    }
    for (const auto& [id, body] : bodies_.people()) {
      addTrack(body, id, true);
    }
    const BagBody* const robot = robotSeenMost();
    if (robot != nullptr) {
      addTrack(*robot, freeId(), !robot->told);
      file_.tracks.back().isRobot = true;
      takeGoal(*robot);
    }
    base::Result<sim2d::Trace> trace = sim2d::traceOfTracks(file_, options_);
    if (trace) {
      describe(*trace, robot);
    }
    return trace;
  }
  /// What was left out on the way.
  base::Diagnostics remarks() const {
    return left_ == 0 ? base::Diagnostics()
                      : base::Diagnostics{base::warning("bag.same-stamp", {left_}, file_.file)};
  }

 private:
  /// Some wrappers tell of a robot of another id until theirs is there.
  const BagBody* robotSeenMost() const {
    const BagBody* most = nullptr;
    for (const auto& [id, body] : bodies_.robots()) {
      most = most == nullptr || body.samples.size() > most->samples.size() ? &body : most;
    }
    return most;
  }

  int freeId() const {
    const auto& people = bodies_.people();
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

  /// `hasStamps`: of its own; robot_states shares those of people, often one for two.
  void addTrack(const BagBody& body, int id, bool hasStamps) {
    sim2d::Track track;
    track.id = id;
    track.name = body.name;
    if (body.told && body.told->radius > 0.0F) {
      track.radius = asWritten(body.told->radius);
    }
    std::int64_t last = 0;
    for (const BagSample& sample : body.samples) {
      if (!track.points.empty() && sample.time == last) {  // recorded twice
        const bool isElsewhere = sample.pose.position != track.points.back().position;
        left_ += isElsewhere && hasStamps ? 1U : 0U;
        continue;
      }
      last = sample.time;
      sim2d::TrackPoint point;
      point.time = static_cast<double>(sample.time - begin_.value_or(0)) * kNanosecond;
      point.position = sample.pose.position;
      point.velocity = sample.velocity;
      point.heading = sample.heading;
      point.angularSpeed = sample.omega;
      track.points.push_back(point);
    }
    track.group = body.samples.empty() ? -1 : body.samples.front().group;
    file_.tracks.push_back(std::move(track));
  }

  void takeGoal(const BagBody& robot) {
    if (!options_.robotGoal && robot.told && !robot.told->goals.empty()) {
      const geometry_msgs::Point& place = robot.told->goals.back().position;
      options_.robotGoal = base::Vec2(place.x, place.y);
    }
  }

  static void describeHuman(const BagBody& body, sim2d::TraceHuman& human) {
    human.name = body.name.empty() ? human.name : body.name;
    if (!body.told) {
      return;
    }
    const hunav_msgs::Agent& agent = *body.told;
    human.desiredSpeed = asWritten(agent.desiredVelocity);
    human.behavior = std::clamp<int>(agent.behavior.type, 1, 6);
    human.configuration = std::clamp<int>(agent.behavior.configuration, 0, 3);
    human.cyclicGoals = agent.cyclicGoals;
    for (std::size_t k = 0; k < agent.goals.size(); ++k) {
      const geometry_msgs::Point& place = agent.goals[k].position;
      human.goals.push_back(
          {static_cast<int>(k) + 1, {place.x, place.y}, asWritten(agent.goalRadius)});
    }
  }

  void describe(sim2d::Trace& trace, const BagBody* robot) const {
    for (sim2d::TraceHuman& human : trace.header.humans) {
      const auto body = bodies_.people().find(human.id);
      if (body != bodies_.people().end()) {
        describeHuman(body->second, human);
      }
    }
    if (robot != nullptr && robot->told && !trace.header.robots.empty()) {
      sim2d::TraceRobot& told = trace.header.robots.front();
      told.name = robot->name.empty() ? told.name : robot->name;
      for (sim2d::TraceGoal& goal : told.goals) {
        const double radius = asWritten(robot->told->goalRadius);
        goal.radius = radius > 0.0 ? radius : goal.radius;
      }
    }
    if (bodies_.map()) {
      sim2d::setMap(trace, *bodies_.map());
    }
  }

  const BagBodies& bodies_;
  sim2d::TrackOptions options_;
  sim2d::TrackFile file_;
  std::optional<std::int64_t> begin_;  // [ns]; stamps since 1970 leave a double few digits
  std::size_t left_ = 0;               // samples with the stamp of one before, but elsewhere
};

/// Used as it was written: no choice of topics or robots, no other step.
bool isUsedAsItIs(Bag& bag, const BagUse& use, const sim2d::TrackOptions& options) {
  const bool isChosen = !use.people.empty() || !use.robot.empty() || !use.map.empty() ||
                        options.robotId || !options.robotName.empty() || options.robotGoal ||
                        options.step > 0.0;
  return !isChosen && !bag.metadata(kRunMetadata, "trace.json").empty() &&
         ownTopics(bag.channels()).people;
}

}  // namespace

base::Result<sim2d::Trace> readBagTrace(const std::string& path, const BagUse& use,
                                        const sim2d::TrackOptions& options) {
  base::Result<std::unique_ptr<Bag>> bag = openBag(path);
  base::Diagnostics problems = bag.diagnostics();
  if (!bag) {
    return problems;
  }
  base::Result<sim2d::Trace> trace = base::error("bag.no-bag", {}, path);
  if (isUsedAsItIs(**bag, use, options)) {
    trace = OwnTrace(**bag, path).make();
  } else {
    const BagChoice choice = chooseTopics((*bag)->channels(), use, path, problems);
    if (base::hasErrors(problems)) {
      return problems;
    }
    BagBodies bodies(**bag, choice, path);
    base::append(problems, bodies.read());
    if (base::hasErrors(problems)) {
      return problems;
    }
    ForeignTrace foreign(bodies, options, path);
    trace = foreign.make();
    base::append(problems, foreign.remarks());
  }
  base::append(problems, trace.diagnostics());
  return trace ? base::Result<sim2d::Trace>(*std::move(trace), std::move(problems))
               : base::Result<sim2d::Trace>(std::move(problems));
}

}  // namespace bridge
