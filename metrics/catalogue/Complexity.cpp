#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "metrics/RobotMotion.h"
#include "sim2d/trace/Frame.h"

/// Complexity of the run: mutual winding, replanning, arrivals.
namespace metrics {

namespace {

/// Signed turns of each person and the robot around each other. A jump is not a turn: the bearing
/// restarts.
class Winding : public Accumulator {
 public:
  void add(const Instant& at) override {
    before_.swap(now_);
    now_.clear();
    std::size_t next = 0;
    for (const Pedestrian& person : at.now.people) {
      const double bearing = person.pair.bearing;
      const WindingAngle* then = findInOrder(before_, next, person.id);
      WindingAngle turned{person.id, person.position, bearing, 0.0};
      turned.angle = then != nullptr ? then->angle : angleOf(person.id);
      if (then != nullptr && !hasJumped(then->position, person, at.context.seam)) {
        turned.angle += base::angleDiff(bearing, then->bearing);
      }
      now_.push_back(turned);
    }
    keepLost();
  }

  double turns() const {
    double sum = 0.0;
    for (const auto& [id, angle] : lost_) {
      sum += std::fabs(angle) / (2.0 * base::kPi);
    }
    for (const WindingAngle& one : now_) {
      sum += std::fabs(one.angle) / (2.0 * base::kPi);
    }
    return sum;
  }

 private:
  struct WindingAngle {
    int id = 0;
    Vec2 position = Vec2::Zero();
    double bearing = 0.0, angle = 0.0;
  };

  /// Returns the angle of a person who was absent.
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
    for (const WindingAngle& one : before_) {
      if (findInOrder(now_, next, one.id) == nullptr) {
        lost_[one.id] = one.angle;
      }
    }
  }

  std::vector<WindingAngle> now_, before_;
  std::map<int, double> lost_;  // absent people: id, angle [rad]
};

class Replans : public Accumulator {
 public:
  void note(const RunContext& context, double /*elapsed*/, const sim2d::Event& event) override {
    const bool isOurs = event.hasId && event.id == context.robotId;
    count_ += isOurs && event.kind == sim2d::EventKind::Replan ? 1.0 : 0.0;
  }
  double count() const { return count_; }

 private:
  double count_ = 0.0;
};

/// First arrival of each; bodies with goals that do not arrive count with the whole time.
class Arrivals : public Accumulator {
 public:
  void add(const Instant& at) override {
    for (const Pedestrian& person : at.now.people) {
      if (person.wantsToArrive) {
        wanting_.insert(person.id);
      }
    }
    robot_.add(at);
  }
  void note(const RunContext& context, double elapsed, const sim2d::Event& event) override {
    const bool isPerson = event.kind == sim2d::EventKind::Arrived && event.hasId && event.id >= 0;
    if (isPerson || sim2d::isRobotArrival(event, context.robotId)) {
      times_.emplace(event.id, elapsed);
    }
  }
  MetricValue sum(const Instant& last) const {
    double sum = 0.0;
    std::size_t count = times_.size();
    for (const auto& [id, time] : times_) {
      sum += time;
    }
    const auto wait = [&](int id) {
      const bool isLate = times_.count(id) == 0;
      sum += isLate ? last.elapsed() : 0.0;
      count += isLate ? 1 : 0;
    };
    for (const int id : wanting_) {
      wait(id);
    }
    const std::optional<double> arrival = robot_.time(last);
    const bool isTold = times_.count(last.context.robotId) > 0;
    if (last.context.hasRobot && !isTold && arrival && !last.usesHunavProfile()) {
      sum += *arrival;  // not recorded by events
      ++count;
    } else if (last.context.hasRobot && !last.context.goals.empty()) {
      wait(last.context.robotId);
    }
    return count > 0 ? MetricValue(sum) : undefinedValue("no person has a goal");
  }

 private:
  std::map<int, double> times_;  // [s] from the first sample
  std::set<int> wanting_;        // people who were present
  ArrivalTime robot_;
};

/// Distance to the goals while the robot has hardly moved for a time window.
class StoppedDistance : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double window = at.parameters.stoppedWindow - 1e-9;
    const double time = at.now.time;
    const Vec2& place = at.now.robot.position;
    places_.emplace_back(time, place);
    while (places_.size() > 1 && time - places_[1].first >= window) {
      places_.pop_front();  // the last one that is old enough is kept
    }
    if (at.elapsed() >= window &&
        lengthOf(place - places_.front().second) < at.parameters.stoppedDistance) {
      sum_ += distanceToGoals(at.context, place);
      count_ += 1.0;
    }
  }
  MetricValue mean(const Instant& last) const {
    if (last.context.goals.empty()) {
      return undefinedValue("there is no goal");
    }
    return count_ > 0.0 ? sum_ / count_ : undefinedValue("the robot never stops");
  }

 private:
  std::deque<std::pair<double, Vec2>> places_;  // time [s], position
  double sum_ = 0.0, count_ = 0.0;
};

constexpr char kComplexityMetrics[] = R"(
= Social Behavior|neutral|robot, people|Mavrogiannis and Knepper 2019
topological_complexity|Winding around people|turns|[0, inf)|sum over a of |sum over i of wrap(b_i - b_(i-1))| / 2 pi, b = bearing of a from the robot = angle of
  C, over the i at which a is present, was present at i-1 and has not jumped; for a person who returns the sum continues
= Navigation Performance|lower|robot|Arena; MRPB
replanning_count|Replans of the robot||0, 1, ...|number of events replan with the robot's id and t_0 <= time <= t_(N-1)
= Navigation Performance|lower|nothing|Francis et al. 2025
aggregated_time|Aggregated time to the goals|s|[0, inf)|sum over the people with goals (goals not empty and cyclic_goals false in trace.json) that were present,
  all people with an event arrived within the used samples, and the robot if it has a goal, of the time of the first such event (robot: its arrival, 0 if that
  is before the first sample) from the first sample of the record, T for those who do not arrive by the last sample; undefined if there are none
= Navigation Performance|lower|robot, goal|SEAN 2.0
mean_dist_to_target_not_moving|Mean distance to the goal while stopped|m|[0, inf)|mean over i of min over goals of |p_i - g|, over the i with t_i -
  t_0 >= stopped_window and |p_i - p_j| < stopped_distance, j = last sample with t_j <= t_i - stopped_window (times to 1e-9 s); undefined if there is
  none
)";

}  // namespace

void addComplexity(MetricRegistry& to) {
  to.add(kComplexityMetrics,
         {{"topological_complexity", metricOf<Winding>(&Winding::turns)},
          {"replanning_count", metricOf<Replans>(&Replans::count)},
          {"aggregated_time", metricOf<Arrivals>(&Arrivals::sum)},
          {"mean_dist_to_target_not_moving", metricOf<StoppedDistance>(&StoppedDistance::mean)}});
}

}  // namespace metrics
