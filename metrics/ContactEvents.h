#pragma once

#include <vector>

#include "metrics/MetricRegistry.h"

namespace metrics {

/// Contacts that begin at each sample and who ran into whom: a person whose gap to the robot falls
/// below a limit, told apart by the closing speeds.
class ContactEvents : public Accumulator {
 public:
  explicit ContactEvents(double limit) : limit_(limit) {}
  void add(const Recording& recording, std::size_t sample) override;

  double count() const { return count_; }  // whoever caused them
  const std::vector<double>& byRobot() const { return byRobot_; }
  const std::vector<double>& byPerson() const { return byPerson_; }

 private:
  void addEntry(const Sample& now, const Sample* before, const Person& person);

  double limit_;  // [m]
  double count_ = 0.0;
  std::vector<double> byRobot_, byPerson_;  // per sample
  std::vector<int> touching_, touchingNow_;
};

/// One accumulator for all metrics with the same limit.
using ContactReader =
    std::function<MetricValue(const ContactEvents&, const Recording&, const MetricParameters&)>;
Stream contactStream(double MetricParameters::*limit, const std::string& name, ContactReader read);

}  // namespace metrics
