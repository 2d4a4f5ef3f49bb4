#pragma once

#include <variant>

#include "sim2d/nav/Planner.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {

/// What a world can be made of. Each world is handed its own; thread: read only, any.
struct Registries {
  PlannerRegistry planners;
  ModelRegistry models;
  base::Registry<std::monostate> robotTypes;  // their numbers are keys of the robot
};
/// All of this program.
Registries programRegistries();
KnownNames knownNames(const Registries& registries);
/// The radius that counts in a run instead of the scenario's, where the person's model has one [m].
std::optional<double> ownBodyRadius(const Registries& registries, const ResolvedHuman& person);

}  // namespace sim2d
