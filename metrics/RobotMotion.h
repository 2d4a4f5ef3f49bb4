#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "metrics/MetricRegistry.h"

/// Quantities of the robot's run that several metrics share.
namespace metrics {

constexpr char kNoGoal[] = "the robot has no goal";
constexpr char kNoObstacles[] = "the recording has no map and no obstacles";

bool isInGoalRegion(const RunContext& context, const Vec2& position,
                    const MetricParameters& parameters);
/// Whether the robot neither drives nor turns.
bool isStanding(const Robot& robot, const MetricParameters& parameters);
/// Whether the robot has arrived by the last sample: by an event if events record arrivals,
/// otherwise by its position in the goal region (always in profile hunav2).
bool isCompleted(const Instant& last);
double distanceToGoals(const RunContext& context, const Vec2& position);  // nearest goal; inf: none

/// gap < limit; fast for distant people.
bool isWithin(const Robot& robot, const Pedestrian& person, double limit);

/// Arrival time of the robot, as used by all metrics: the time of the event or, if events do not
/// record arrivals, the first sample of its last uninterrupted stay in the goal region.
class ArrivalTime : public Accumulator {
 public:
  void add(const Instant& at) override;
  /// From the first sample [s]; empty: not arrived.
  std::optional<double> time(const Instant& last) const;

 private:
  std::optional<double> since_;  // start of the stay [s]
};

/// The path of the robot.
class RobotPath : public Accumulator {
 public:
  void add(const Instant& at) override;
  double length() const { return length_; }        // L [m]
  double turning() const { return turns_.sum(); }  // [rad]
  MetricValue headingChanges() const { return withTerms(turns_); }
  const Vec2& start() const { return start_; }
  double startHeading() const { return startHeading_; }

 private:
  double length_ = 0.0;
  SeriesSum turns_;  // 0, then |turn| per sample
  Vec2 start_ = Vec2::Zero();
  double startHeading_ = 0.0;
};

/// Contacts that start at each sample and their causes: the gap of a person to the robot falls
/// below a limit. The closing speeds determine the cause.
class Contacts : public Accumulator {
 public:
  void add(const Instant& at) override;
  double count() const { return count_; }                   // regardless of the cause
  const std::vector<int>& begun() const { return begun_; }  // person ids, at the newest sample
  MetricValue byRobot() const { return withTerms(byRobot_, Kind::Count); }
  MetricValue byPerson() const { return withTerms(byPerson_, Kind::Count); }

 protected:
  explicit Contacts(double limit) : limit_(limit) {}  // [m]

 private:
  struct ContactCauses {
    double robot = 0.0, person = 0.0;
  };
  static void addContactStart(const Instant& at, const Pedestrian& person, ContactCauses& to);

  double limit_;
  double count_ = 0.0;
  SeriesSum byRobot_, byPerson_;
  std::vector<int> touching_, touchingNow_, begun_;
};

/// One accumulator for all metrics with the same limit.
template <double MetricParameters::*kLimit>
class ContactsWithin : public Contacts {
 public:
  explicit ContactsWithin(const MetricParameters& parameters) : Contacts(parameters.*kLimit) {}
};

/// Contacts of the robot with obstacles: its clearance falls to 0 or below.
class ObstacleContacts {
 public:
  void add(const Instant& at);
  bool hasBegun() const { return hasBegun_; }  // a contact starts at the newest sample
  double count() const { return count_; }

 private:
  bool touches_ = false, hasBegun_ = false;
  double count_ = 0.0;
};

/// Jerk of a sampled speed with a bandwidth that does not depend on the sampling: the second
/// derivative of the least-squares parabola of the speed, interpolated linearly between samples,
/// within half a window to each side of a sample. Samples farther apart than half a window limit
/// the bandwidth themselves; then the second difference of three speeds is used. Stores the samples
/// of one window. Source: the smoothing differentiator of Savitzky and Golay 1964 for continuous
/// signals.
class Jerk {
 public:
  /// `halfWindow` [s].
  explicit Jerk(double halfWindow) : half_(halfWindow) {}

  /// Adds the next speed [m/s] at a time [s] that is not earlier than the previous one. Calls
  /// `take(jerk)` [m/s³] for each sample whose window is complete, in order, from the second sample
  /// on; NaN: a neighbour has the same time, or the window starts before the first sample.
  /// `between(jerk)` receives the jerk at the midpoint between that sample and the previous one, if
  /// defined, so that the maximum depends less on the sampling times.
  void add(double time, double speed, const std::function<void(double)>& take,
           const std::function<void(double)>& between);

 private:
  struct Point {
    double time = 0.0, speed = 0.0;
  };
  bool isCoarse() const;  // around the next sample to be reported
  double secondDifference() const;
  double windowed(const Point& centre) const;
  double integral(const Point& from, const Point& to, const Point& centre) const;

  double half_;
  std::deque<Point> points_;     // samples of the next window
  std::size_t next_ = 1;         // index in points_
  std::optional<double> first_;  // time of the first sample [s]
};

}  // namespace metrics
