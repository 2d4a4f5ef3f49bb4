#include "sim2d/world/Registries.h"

#include "sim2d/nav/RobotTypes.h"

namespace sim2d {

// Written by CMake, from the files of models/ and of nav/planners/.
void addAllModels(ModelRegistry& to);
void addAllPlanners(PlannerRegistry& to);

Registries programRegistries() {
  Registries all;
  addAllPlanners(all.planners);
  addAllModels(all.models);
  for (const RobotType& type : robotTypes()) {
    all.robotTypes.add(type.name, {}, {});
  }
  return all;
}

KnownNames knownNames(const Registries& registries) {
  KnownNames names;
  names.models = registries.models.names();
  names.planners = registries.planners.names();
  names.robotTypes = registries.robotTypes.names();
  for (const auto& planner : registries.planners.entries()) {
    names.plannerParameters[planner.name] = planner.parameters;
  }
  for (const auto& model : registries.models.entries()) {
    names.modelParameters[model.name] = model.parameters;
  }
  return names;
}

std::optional<double> ownBodyRadius(const Registries& registries, const ResolvedHuman& person) {
  const auto* const model = registries.models.find(person.model);
  return model != nullptr ? model->make(person)->ownBodyRadius(person) : std::nullopt;
}

}  // namespace sim2d
