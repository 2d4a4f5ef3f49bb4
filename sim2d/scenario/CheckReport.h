#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "sim2d/scenario/ScenarioCheck.h"

/// Shared parts of checkScenario. Private to this folder.
namespace sim2d {

/// The entity of a problem, and the prefix of its text: "anna", "anna: footprint", or none.
struct Subject {
  Subject(EntityId id, std::string place = {}) : entity(id), where(std::move(place)) {}  // NOLINT
  Subject(const NamedEntity& thing) : Subject(thing.key, thing.name) {}                  // NOLINT

  EntityId entity;
  std::string where;
};

struct CheckReport {
  std::string file;
  base::Diagnostics diagnostics;

  void add(base::Severity severity, const Subject& subject, std::string_view code,
           base::ProblemValues values = {});
  void error(const Subject& subject, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Error, subject, code, std::move(values));
  }
  void warning(const Subject& subject, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Warning, subject, code, std::move(values));
  }
};

void checkShapes(const Scenario& scenario, CheckReport& report);
/// False: a coordinate is not finite or beyond a million metres, so paths cannot be planned.
bool checkCoordinates(const Scenario& scenario, CheckReport& report);
void checkPlaces(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report);

}  // namespace sim2d
