#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {

Scenario withoutDefaults(Scenario scenario, const FieldTables& tables) {
  const DesktopSettings desktop = scenario.desktop;
  const auto drop = [&](auto& entities) {
    for (auto& entity : entities) {
      dropDefaults(entity, desktop, tables);
    }
  };
  for (Human& human : scenario.humans) {
    dropDefaults(human.ours, desktop, tables);
  }
  drop(scenario.robots);
  drop(scenario.obstacles);
  drop(scenario.doors);
  drop(scenario.areas);
  dropDefaults(scenario.desktop, desktop, tables);
  dropDefaults(scenario.desktop.metrics, desktop, tables);
  return scenario;
}

Scenario withoutDefaults(const Scenario& scenario) {
  return withoutDefaults(scenario, fieldTables());
}

}  // namespace sim2d
