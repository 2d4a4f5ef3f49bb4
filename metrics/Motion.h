#pragma once

#include <optional>
#include <vector>

#include "metrics/MetricRegistry.h"

/// Quantities of the robot's run that several metrics use.
namespace metrics {

constexpr char kNoGoal[] = "the robot has no goal";

bool isInGoalRegion(const RunContext& context, const Vec2& position,
                    const MetricParameters& parameters);
/// At the last sample.
bool isCompleted(const Instant& last);
double distanceToGoals(const RunContext& context, const Vec2& position);  // nearest goal; inf: none

/// Ways on the map or straight.
std::vector<Vec2> shortestPath(const RunContext& context, const Vec2& from, const Vec2& to);

/// The way that the robot made.
class RobotWay : public Accumulator {
 public:
  void add(const Instant& at) override;
  double length() const { return length_; }            // L [m]
  const SeriesSum& turning() const { return turns_; }  // terms: 0, then |turn| [rad]
  const Vec2& start() const { return start_; }
  double startHeading() const { return startHeading_; }

 private:
  double length_ = 0.0;
  SeriesSum turns_;
  Vec2 start_ = Vec2::Zero();
  double startHeading_ = 0.0;
};

/// Changes of the robot's speed from sample to sample: accelerations of the intervals [m/s^2], 0
/// where no time passes, and changes of them around the inner samples [m/s^3].
class SpeedChanges {
 public:
  void add(const Instant& at);
  bool hasAcceleration() const { return count_ > 1; }  // an interval ended
  double acceleration() const { return acceleration_; }
  double interval() const { return interval_; }  // [s]
  bool isInner() const { return count_ > 2; }    // the sample before has neighbours
  /// Around the sample before; none where no time passes.
  const std::optional<double>& jerk() const { return jerk_; }

 private:
  std::size_t count_ = 0;
  double acceleration_ = 0.0, interval_ = 0.0, timeBefore_ = 0.0;  // of the sample before [s]
  std::optional<double> jerk_;
};

/// Contacts that begin at each sample and who ran into whom: a person whose gap to the robot falls
/// below a limit, told apart by the closing speeds.
class ContactEvents {
 public:
  explicit ContactEvents(double limit) : limit_(limit) {}  // [m]
  void add(const Instant& at);

  double count() const { return count_; }  // whoever caused them
  const SeriesSum& byRobot() const { return byRobot_; }
  const SeriesSum& byPerson() const { return byPerson_; }

 private:
  struct Culprits {
    double robot = 0.0, person = 0.0;
  };
  static void addEntry(const Instant& at, const Person& person, Culprits& to);

  double limit_;
  double count_ = 0.0;
  SeriesSum byRobot_, byPerson_;
  std::vector<int> touching_, touchingNow_;
};

/// One accumulator for all metrics with the same limit.
template <double MetricParameters::*kLimit>
class ContactsWithin : public Accumulator {
 public:
  explicit ContactsWithin(const MetricParameters& parameters) : events_(parameters.*kLimit) {}
  void add(const Instant& at) override { events_.add(at); }

  MetricValue all(const Instant& /*last*/) const { return countValue(events_.count()); }
  MetricValue byRobot(const Instant& /*last*/) const { return valueOf(events_.byRobot()); }
  MetricValue byPerson(const Instant& /*last*/) const { return valueOf(events_.byPerson()); }

 private:
  static MetricValue valueOf(const SeriesSum& sum) {
    return withSeries(countValue(sum.sum()), sum.terms(), Kind::Count);
  }
  ContactEvents events_;
};

}  // namespace metrics
