#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

/// The sentences under `expect` of a scenario's card: what happens in a run without robots. They
/// refer to events and positions of the run:
///
///     SUBJECT [never] PREDICATE [before T s | after T s | from T to T s]
///
///     anna reaches goal 2 before 12 s         anna says "hello" before 5 s
///     anna stands at door1 for 2 s            anna starts ConversationFormation before 20 s
///     anna comes within 1.5 m of ben          3 people arrive before 60 s
///
/// SUBJECT is a person, or `N people`: at least so many different people.
namespace sim2d {

/// One sentence, taken apart. Distances [m], times [s].
struct Expectation {
  enum class What {
    ReachesGoal,
    Arrives,
    Enters,
    Leaves,
    Says,
    Hears,
    Starts,
    Ends,
    Stands,
    Nears,
    Touches
  };

  std::string text;       // as written
  std::string subject;    // name of a person; empty: `people` of them
  int people = 0;         // least number of different people
  bool isDenied = false;  // `never`
  What what = What::Arrives;
  std::string object;   // person, area or door; text of speech; name of a tree node
  int goal = 0;         // number of a global goal; 0: none
  double amount = 0.0;  // Stands: duration; Nears: distance
  double from = 0.0;    // not before
  double until = std::numeric_limits<double>::infinity();
};

/// Error: the text has none of the forms (problem `card.expectation-form`).
base::Result<Expectation> parseExpectation(const std::string& text);

/// The forms of the predicate, for messages: "reaches goal N, arrives, …".
std::string expectationForms();

/// People, areas, doors and goals ("goal 7") that the scenario does not have. The people of a
/// source, `<area>_<number>`, count as existing.
std::vector<std::string> unknownNames(const Expectation& expectation, const Scenario& scenario);

}  // namespace sim2d
