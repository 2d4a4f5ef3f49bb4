#include <cmath>
#include <map>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

/// How much went on: turning round each other, new plans, arrivals.
namespace metrics {

namespace {

/// Turns that each person and the robot made around each other, with their sense.
class Winding : public Accumulator {
 public:
  void add(const Recording& recording, std::size_t sample) override {
    const Sample& now = recording.samples[sample];
    before_.swap(now_);
    now_.clear();
    std::size_t next = 0;
    for (const Person& person : now.people) {
      const double bearing = person.pair.bearing;
      const auto* then =
          findInOrder(before_, next, [&person](const Turned& one) { return one.id == person.id; });
      Turned turned{person.id, bearing, then != nullptr ? then->angle : angleOf(person.id)};
      turned.angle += then != nullptr ? base::angleDiff(bearing, then->bearing) : 0.0;
      now_.push_back(turned);
    }
    keepLost();
  }

  MetricValue value() const {
    double sum = 0.0;
    for (const auto& [id, angle] : lost_) {
      sum += std::fabs(angle) / (2.0 * base::kPi);
    }
    for (const Turned& one : now_) {
      sum += std::fabs(one.angle) / (2.0 * base::kPi);
    }
    return numberValue(sum);
  }

 private:
  struct Turned {
    int id = 0;
    double bearing = 0.0, angle = 0.0;
  };

  /// Takes back what was kept of somebody who was away.
  double angleOf(int id) {
    const auto found = lost_.find(id);
    const double angle = found != lost_.end() ? found->second : 0.0;
    if (found != lost_.end()) {
      lost_.erase(found);
    }
    return angle;
  }
  void keepLost() {
    std::size_t next = 0;
    for (const Turned& one : before_) {
      if (findInOrder(now_, next, [&one](const Turned& other) { return other.id == one.id; }) ==
          nullptr) {
        lost_[one.id] = one.angle;
      }
    }
  }

  std::vector<Turned> now_, before_;
  std::map<int, double> lost_;  // who is away: id, angle [rad]
};

bool isInRecord(const Recording& recording, double time) {
  constexpr double kSlack = 1e-9;
  return time >= recording.samples.front().time - kSlack &&
         time <= recording.samples.back().time + kSlack;
}

MetricValue replans(const Recording& recording, const MetricParameters& /*p*/) {
  const int robot = recording.samples.front().robot.id;
  double count = 0.0;
  for (const auto& [time, event] : recording.events) {
    const bool counts = event.kind == sim2d::EventKind::Replan && event.hasId && event.id == robot;
    count += counts && isInRecord(recording, time) ? 1.0 : 0.0;
  }
  return countValue(count);
}

/// First arrival of each.
std::map<int, double> arrivals(const Recording& recording) {
  std::map<int, double> times;
  for (const auto& [time, event] : recording.events) {
    if (event.kind == sim2d::EventKind::Arrived && event.hasId && isInRecord(recording, time)) {
      times.emplace(event.id, time - recording.samples.front().time);
    }
  }
  return times;
}

MetricValue aggregatedTime(const Recording& recording, const MetricParameters& /*p*/) {
  const std::map<int, double> times = arrivals(recording);
  double sum = 0.0;
  for (const auto& [id, time] : times) {
    sum += time;
  }
  return times.empty() ? undefinedValue("nobody arrived") : numberValue(sum);
}

MetricValue stoppedDistance(const Recording& recording, const MetricParameters& parameters) {
  if (recording.goals.empty()) {
    return undefinedValue("there is no goal");
  }
  double sum = 0.0;
  double count = 0.0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const Sample& now = recording.samples[i];
    while (begin < i &&
           now.time - recording.samples[begin + 1].time >= parameters.stoppedWindow - 1e-9) {
      ++begin;  // the last sample that is old enough
    }
    const bool isOld = now.time - recording.samples.front().time >= parameters.stoppedWindow - 1e-9;
    if (isOld && distance(now.robot, recording.samples[begin].robot) < parameters.stoppedDistance) {
      sum += distanceToGoals(recording, i);
      count += 1.0;
    }
  }
  return count > 0.0 ? numberValue(sum / count) : undefinedValue("the robot never stops");
}

}  // namespace

void addComplexity(MetricRegistry& to) {
  to.addStream(
      {"topological_complexity", "Winding around people", "turns", Category::Social,
       Better::Neutral, Needs{true, true},
       "sum over a of |sum over i of wrap(change of the bearing of a from the robot)| / 2 pi",
       "Mavrogiannis and Knepper 2019", "[0, inf)", Kind::Number, 0, ""},
      streamOf<Winding>(
          "",
          [](const Winding& winding, const Recording& /*recording*/,
             const MetricParameters& /*parameters*/) { return winding.value(); },
          [](const MetricParameters& /*parameters*/) { return std::make_unique<Winding>(); }));
  to.add({"replanning_count", "New plans of the robot", "", Category::Navigation, Better::Lower,
          Needs{}, "number of events replan of the robot", "Arena; MRPB", "0, 1, ...", Kind::Count,
          0, ""},
         replans);
  to.add({"aggregated_time", "Aggregated time to the goals", "s", Category::Navigation,
          Better::Lower, Needs{false}, "sum of the times of first arrival of people and robot",
          "Francis et al. 2025", "[0, inf)", Kind::Number, 0, ""},
         aggregatedTime);
  to.add({"mean_dist_to_target_not_moving", "Mean distance to the goal while stopped", "m",
          Category::Navigation, Better::Lower, Needs{true, false, false, false, true},
          "mean of the distance to the nearest goal over the samples with |p(t) - p(t - "
          "stopped_window)| < stopped_distance",
          "SEAN 2.0", "[0, inf)", Kind::Number, 0, ""},
         stoppedDistance);
}

}  // namespace metrics
