#include "editor/document/LiveCheck.h"

#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/World.h"

namespace editor {

void LiveCheck::start(const sim2d::Scenario& scenario,
                      std::shared_ptr<const sim2d::OccupancyGrid> map, LiveTrees trees,
                      const std::map<base::EntityId, int>& lines) {
  task_.start([scenario, map = std::move(map), trees = std::move(trees), lines] {
    sim2d::KnownNames names;
    names.models = sim2d::modelNames();
    names.planners = sim2d::plannerNames();
    names.robotTypes = sim2d::robotTypeNames();
    base::Diagnostics found = sim2d::checkScenario(
        scenario, sim2d::makeSurroundings(scenario, *map), trees.places.scenarioPath, names);
    sim2d::addLines(found, lines);
    base::append(found, treeIssues(scenario, trees.trees, trees.places));
    return found;
  });
}

}  // namespace editor
