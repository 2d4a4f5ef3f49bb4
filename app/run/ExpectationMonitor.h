#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim2d/scenario/Expectation.h"
#include "sim2d/trace/Frame.h"

namespace app {

/// Whether an expectation of a card holds in a run.
struct ExpectationOutcome {
  std::string text;            // as in the card
  bool holds = false;          // with `never`: it has not happened
  std::optional<double> time;  // when it first happened [s]; none: not in its interval
};

/// Observes the states of a run without robots and decides whether the expectations of its card
/// hold. Definitions: a person reaches a goal within 0.5 m of it; a person stands below 0.1 m/s; a
/// place is an area (inside), a door (within 1.5 m) or a goal (within 1 m). One thread.
class ExpectationMonitor {
 public:
  /// The scenario must outlive this. Expectations without a valid form are skipped: the check of
  /// the scenario reports them.
  explicit ExpectationMonitor(const sim2d::Scenario& scenario);

  void add(const sim2d::Frame& frame);
  std::vector<ExpectationOutcome> outcomes() const;
  /// The time after which no state matters [s]; infinite if an expectation has no end.
  double horizon() const;
  /// Whether all that is expected has happened and nothing is excluded by `never`.
  bool isDecided() const;

 private:
  struct Item {
    sim2d::Expectation expectation;
    int subject = 0;              // id, if a name is given
    std::optional<int> other;     // id of the object, if it is a person
    std::set<int> people;         // ids of the people who have done it
    std::map<int, double> since;  // Stands: start of standing [s] per person
    std::optional<double> time;   // when the number of people was reached
  };

  std::optional<int> idOf(const std::string& name) const;
  bool happens(Item& item, int id, std::size_t row, const sim2d::Frame& frame) const;
  bool hasEvent(const Item& item, int id, const sim2d::Frame& frame) const;
  bool stands(Item& item, int id, std::size_t row, const sim2d::Frame& frame) const;
  double distanceTo(const Item& item, const base::Vec2& from, const sim2d::Frame& frame) const;
  void observe(Item& item, const sim2d::Frame& frame) const;

  const sim2d::Scenario& scenario_;
  std::vector<Item> items_;
};

}  // namespace app
