#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "sim2d/scenario/ScenarioCheck.h"

/// The parts of checkScenario. Private to this folder.
namespace sim2d {

struct CheckReport {
  std::string file;
  base::Diagnostics diagnostics;

  /// About a thing, or about a part of it when `where` names one ("anna: footprint").
  void add(base::Severity severity, EntityId entity, const std::string& where,
           std::string_view code, base::ProblemValues values = {});
  void error(EntityId entity, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Error, entity, {}, code, std::move(values));
  }
  void warning(EntityId entity, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Warning, entity, {}, code, std::move(values));
  }
  template <class Named>
  void error(const Named& thing, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Error, thing.key, thing.name, code, std::move(values));
  }
  template <class Named>
  void warning(const Named& thing, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Warning, thing.key, thing.name, code, std::move(values));
  }
};

template <class T, class Visit>
void forEachListed(const std::vector<T>& all, Visit visit) {
  for (const T& each : all) {
    if (each.listed) {
      visit(each);
    }
  }
}

void checkShapes(const Scenario& scenario, CheckReport& report);
/// False when a coordinate is not finite or beyond a million metres: no planning with those.
bool checkCoordinates(const Scenario& scenario, CheckReport& report);
void checkPlaces(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report);

}  // namespace sim2d
