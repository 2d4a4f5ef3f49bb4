#pragma once

#include <variant>

#include "sim2d/nav/Planner.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {

/// Planners, models and robot types available to a world. Thread-safe, read-only.
struct Registries {
  PlannerRegistry planners;
  ModelRegistry models;
  base::Registry<std::monostate> robotTypes;  // their figures are keys of the robot
};
/// All entries of this program.
Registries builtinRegistries();
KnownNames knownNames(const Registries& registries);
/// Radius that the person's model uses instead of the scenario's, if any [m].
std::optional<double> bodyRadiusOverride(const Registries& registries, const ResolvedHuman& person);

}  // namespace sim2d
