#pragma once

#include <string>

#include "sim2d/scenario/ScenarioCheck.h"

/// The parts of checkScenario. Private to this folder.
namespace sim2d {

struct CheckReport {
  std::string file;
  base::Diagnostics diagnostics;

  void error(EntityId entity, const std::string& message);
  void warning(EntityId entity, const std::string& message);
  void info(EntityId entity, const std::string& message);
};

void checkNames(const Scenario& scenario, CheckReport& report);
void checkReferences(const Scenario& scenario, const KnownNames& names, CheckReport& report);
void checkPeople(const Scenario& scenario, CheckReport& report);
void checkShapes(const Scenario& scenario, CheckReport& report);
/// False when a coordinate is not finite or beyond a million metres: no planning with those.
bool checkCoordinates(const Scenario& scenario, CheckReport& report);
void checkPlaces(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report);

}  // namespace sim2d
