#pragma once

#include <vector>

#include "metrics/MetricRegistry.h"

namespace metrics {

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
