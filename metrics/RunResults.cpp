#include "metrics/RunResults.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>

#include "metrics/RobotMotion.h"
#include "sim2d/base/Text.h"

namespace metrics {

namespace {

constexpr double kSlower = 0.1;  // [m/s]

struct Moment {
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  double heading = 0.0;
};

/// A person's trajectory in one record.
struct PersonTrajectory {
  std::map<std::int64_t, Moment> moments;                   // by step
  std::vector<std::pair<std::int64_t, std::string>> goals;  // reached goals: step, id
};

std::map<int, PersonTrajectory> trajectoriesOf(const sim2d::Trace& trace) {
  std::map<int, PersonTrajectory> ways;
  for (const sim2d::Frame& frame : trace.frames) {
    const sim2d::HumanColumns& humans = frame.humans;
    for (std::size_t k = 0; k < humans.size(); ++k) {
      ways[humans.id[k]].moments[frame.step] = {
          Vec2(humans.x[k], humans.y[k]), Vec2(humans.vx[k], humans.vy[k]), humans.heading[k]};
    }
  }
  for (const auto& [step, event] : trace.events) {
    const auto way = ways.find(event.id);
    if (event.kind == sim2d::EventKind::Goal && event.hasId && way != ways.end()) {
      way->second.goals.emplace_back(step, event.text);
    }
  }
  return ways;
}

double lengthUntil(const PersonTrajectory& way, std::int64_t step, const Seam& seam) {
  double length = 0.0;
  const Moment* before = nullptr;
  for (const auto& [at, moment] : way.moments) {
    if (at > step) {
      break;
    }
    if (before != nullptr) {
      length += lengthOf(seam.nearest(moment.position, before->position) - before->position);
    }
    before = &moment;
  }
  return length;
}

/// Number of equal goals, counted from the first.
std::size_t equalGoalCount(const PersonTrajectory& with, const PersonTrajectory& without) {
  const auto differ = std::mismatch(
      with.goals.begin(), with.goals.end(), without.goals.begin(), without.goals.end(),
      [](const auto& a, const auto& b) { return a.second == b.second; });
  return static_cast<std::size_t>(differ.first - with.goals.begin());
}

PersonEffect effectOf(int id, const PersonTrajectory& with, const PersonTrajectory& without,
                      const sim2d::TraceHeader& header) {
  const double dt = header.dt;
  const Seam seam = seamOf(header);
  PersonEffect effect;
  effect.id = id;
  const std::size_t goals = equalGoalCount(with, without);
  std::int64_t end = std::min(with.moments.rbegin()->first, without.moments.rbegin()->first);
  std::int64_t endWithout = end;
  if (goals > 0) {
    end = with.goals[goals - 1].first;
    endWithout = without.goals[goals - 1].first;
  }
  effect.detour = lengthUntil(with, end, seam) - lengthUntil(without, endWithout, seam);
  if (goals > 0 || (with.goals.empty() && without.goals.empty())) {
    effect.delay = static_cast<double>(end - endWithout) * dt;
  }
  const Moment* before = nullptr;
  const Moment* beforeWithout = nullptr;
  std::int64_t lastStep = 0;
  double count = 0.0;
  for (const auto& [step, moment] : with.moments) {
    const auto other = without.moments.find(step);
    if (other == without.moments.end()) {
      continue;
    }
    const Moment& twin = other->second;
    if (before != nullptr) {
      effect.extraForce += lengthOf((moment.velocity - before->velocity) -
                                    (twin.velocity - beforeWithout->velocity));
      const bool isSlower = lengthOf(moment.velocity) < lengthOf(twin.velocity) - kSlower;
      effect.slowedTime += isSlower ? static_cast<double>(step - lastStep) * dt : 0.0;
    }
    effect.disturbance += std::fabs(base::angleDiff(moment.heading, twin.heading));
    count += 1.0;
    before = &moment;
    beforeWithout = &twin;
    lastStep = step;
  }
  effect.disturbance /= std::max(count, 1.0);
  return effect;
}

struct Column {
  const char* name;
  const char* title;
  const char* unit;
  const char* formula;
  const char* range;
  double PersonEffect::*member;
};
constexpr Column kColumns[] = {
    {"detour", "Detours caused by the robot", "m",
     "path length to the last common goal with - without the robot", "(-inf, inf)",
     &PersonEffect::detour},
    {"delay", "Delays caused by the robot", "s", "time of the last common goal with - without",
     "(-inf, inf)", &PersonEffect::delay},
    {"extra_force", "Velocity changes caused by the robot", "m/s",
     "sum of |change of velocity with - without|", "[0, inf)", &PersonEffect::extraForce},
    {"slowed_time", "Time slowed down by the robot", "s",
     "time in which the speed is lower by more than 0.1 m/s; a sample counts the time since the "
     "sample before it",
     "[0, inf)", &PersonEffect::slowedTime},
    {"heading_disturbance", "Heading changes caused by the robot", "rad",
     "mean over the samples of |wrap(heading with - without)|", "[0, inf)",
     &PersonEffect::disturbance}};

}  // namespace

std::vector<PersonEffect> personEffects(const sim2d::Trace& with, const sim2d::Trace& without) {
  const std::map<int, PersonTrajectory> ways = trajectoriesOf(with);
  const std::map<int, PersonTrajectory> others = trajectoriesOf(without);
  std::vector<PersonEffect> effects;
  for (const auto& [id, way] : ways) {
    const auto other = others.find(id);
    if (other != others.end()) {
      effects.push_back(effectOf(id, way, other->second, with.header));
    }
  }
  return effects;
}

std::vector<MetricInfo> effectInfos() {
  std::vector<MetricInfo> infos;
  for (const Column& column : kColumns) {
    infos.push_back({std::string("counterfactual_") + column.name, column.title, column.unit,
                     Category::Social, Better::Lower, Needs{true, true},
                     std::string("sum over people of ") + column.formula, "HuNavSim Desktop",
                     column.range});
  }
  return infos;
}

std::vector<MetricResult> effectSums(const std::vector<PersonEffect>& effects) {
  std::vector<MetricResult> results;
  for (const MetricInfo& info : effectInfos()) {
    double sum = 0.0;
    bool isKnown = false;
    for (const PersonEffect& effect : effects) {
      const double value = effect.*kColumns[results.size()].member;
      isKnown = isKnown || !std::isnan(value);
      sum += std::isnan(value) ? 0.0 : value;
    }
    const char* why = effects.empty() ? "no person is in both runs"
                                      : "no person reaches the same goal in both runs";
    results.push_back({info, isKnown ? MetricValue(sum) : undefinedValue(why)});
  }
  return results;
}

std::string effectsCsv(const std::vector<PersonEffect>& effects) {
  std::string text = "id";
  for (const Column& column : kColumns) {
    text += std::string(",") + column.name;
  }
  text += "\n";
  for (const PersonEffect& effect : effects) {
    text += std::to_string(effect.id);
    for (const Column& column : kColumns) {
      const double value = effect.*column.member;
      text += std::isnan(value) ? "," : "," + base::formatDouble(value);
    }
    text += "\n";
  }
  return text;
}

void PlanningTime::add(double seconds) {
  ++steps_;
  const double change = seconds - mean_;
  mean_ += change / static_cast<double>(steps_);
  squares_ += change * (seconds - mean_);
}

std::vector<MetricInfo> planningTimeInfos() {
  const char source[] = "MRPB; SRPB";
  return {{"planning_time_mean", "Mean planning time", "s", Category::Navigation, Better::Lower,
           Needs{},
           "mean over time steps of the wall-clock time in which all robots compute their "
           "commands",
           source},
          {"planning_time_std", "Standard deviation of the planning time", "s",
           Category::Navigation, Better::Lower, Needs{},
           "sample standard deviation of that time over the time steps", source}};
}

std::vector<MetricResult> PlanningTime::results() const {
  std::vector<MetricResult> results;
  for (MetricInfo& info : planningTimeInfos()) {
    results.push_back({std::move(info), undefinedValue("no planner was called")});
  }
  if (steps_ > 0) {
    results[0].value = mean_;
    results[1].value = steps_ > 1 ? std::sqrt(squares_ / static_cast<double>(steps_ - 1))
                                  : undefinedValue("at least two steps are needed");
  }
  return results;
}

namespace {

/// Records the robot's positions.
class PathRecorder : public Accumulator {
 public:
  void add(const Instant& at) override {
    places_.emplace_back(at.elapsed(), at.now.robot.position);
  }
  const TimedPath& places() const { return places_; }

 private:
  TimedPath places_;
};

/// Records the positions where contacts start.
class ContactRecorder : public ContactsWithin<&MetricParameters::contactDistance> {
 public:
  using ContactsWithin::ContactsWithin;

  void add(const Instant& at) override {
    ContactsWithin::add(at);
    obstacles_.add(at);
    for (const int person : begun()) {
      places_.push_back({at.now.time, at.now.robot.position, person});
    }
    if (obstacles_.hasBegun()) {
      places_.push_back({at.now.time, at.now.robot.position});
    }
  }
  const std::vector<RobotContact>& places() const { return places_; }

 private:
  ObstacleContacts obstacles_;
  std::vector<RobotContact> places_;
};

template <class Places>
auto recordedBy(const sim2d::Trace& trace, const Selection& selection,
                const MetricParameters& parameters) {
  std::decay_t<decltype(std::declval<Places>().places())> places;
  MetricEntry entry;
  entry.info.key = "places";
  entry.computation = metricOf<Places>([&places](const Places& all) {
    places = all.places();
    return MetricValue();
  });
  Selection only = *selectionOfKeys({});
  only.own = {entry};
  only.window = selection.window;
  only.robotId = selection.robotId;
  only.behaviors = false;
  const std::vector<sim2d::TraceRobot>& robots = trace.header.robots;
  if (trace.header.robot(selection.robotId) == nullptr && !robots.empty()) {
    only.robotId = robots.front().id;
  }
  return evaluate(trace, only, parameters) ? places : decltype(places)();
}

}  // namespace

TimedPath robotPathOf(const sim2d::Trace& trace, const Selection& selection,
                      const MetricParameters& parameters) {
  return recordedBy<PathRecorder>(trace, selection, parameters);
}

std::vector<RobotContact> robotContacts(const sim2d::Trace& trace, const Selection& selection,
                                        const MetricParameters& parameters) {
  return recordedBy<ContactRecorder>(trace, selection, parameters);
}

}  // namespace metrics
