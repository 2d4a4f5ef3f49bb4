#pragma once

#include <optional>
#include <vector>

#include "metrics/MetricRegistry.h"

/// Quantities of the robot's run that several metrics use.
namespace metrics {

constexpr char kNoGoal[] = "the robot has no goal";
constexpr char kNoObstacles[] = "the record has no map and no obstacles";

bool isInGoalRegion(const RunContext& context, const Vec2& position,
                    const MetricParameters& parameters);
/// Neither drives nor turns.
bool isStanding(const Robot& robot, const MetricParameters& parameters);
/// Whether the robot has arrived by the last sample: by the event where events record arrivals,
/// else by its position in the goal region, as always in the original.
bool isCompleted(const Instant& last);
double distanceToGoals(const RunContext& context, const Vec2& position);  // nearest goal; inf: none

/// gap < limit; quick for whoever is clearly farther away.
bool isWithin(const Robot& robot, const Person& person, double limit);

/// When the robot arrived. All metrics share this definition: at the event; where events do not
/// record arrivals, at the first sample of its last uninterrupted stay in the goal region.
class Arriving : public Accumulator {
 public:
  void add(const Instant& at) override;
  /// From the first sample [s]; none: it has not arrived.
  std::optional<double> time(const Instant& last) const;

 private:
  std::optional<double> since_;  // begin of the stay [s]
};

/// The way that the robot made.
class RobotWay : public Accumulator {
 public:
  void add(const Instant& at) override;
  double length() const { return length_; }        // L [m]
  double turning() const { return turns_.sum(); }  // [rad]
  MetricValue headingChanges() const { return withTerms(turns_); }
  const Vec2& start() const { return start_; }
  double startHeading() const { return startHeading_; }

 private:
  double length_ = 0.0;
  SeriesSum turns_;  // of 0, then |turn|
  Vec2 start_ = Vec2::Zero();
  double startHeading_ = 0.0;
};

/// Contacts that begin at each sample and who ran into whom: a person whose gap to the robot falls
/// below a limit, told apart by the closing speeds.
class Contacts : public Accumulator {
 public:
  void add(const Instant& at) override;
  double count() const { return count_; }                   // whoever caused them
  const std::vector<int>& begun() const { return begun_; }  // with these, at the newest sample
  MetricValue byRobot() const { return withTerms(byRobot_, Kind::Count); }
  MetricValue byPerson() const { return withTerms(byPerson_, Kind::Count); }

 protected:
  explicit Contacts(double limit) : limit_(limit) {}  // [m]

 private:
  struct Culprits {
    double robot = 0.0, person = 0.0;
  };
  static void addEntry(const Instant& at, const Person& person, Culprits& to);

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
  bool hasBegun() const { return hasBegun_; }  // one, at the newest sample
  double count() const { return count_; }

 private:
  bool touches_ = false, hasBegun_ = false;
  double count_ = 0.0;
};

}  // namespace metrics
