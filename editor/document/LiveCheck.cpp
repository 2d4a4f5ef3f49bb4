#include "editor/document/LiveCheck.h"

#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/World.h"

namespace editor {

void LiveCheck::start(const sim2d::Scenario& scenario,
                      std::shared_ptr<const sim2d::OccupancyGrid> map, const QString& path,
                      const std::map<base::EntityId, int>& lines) {
  task_.start([scenario, map = std::move(map), file = path.toStdString(), lines] {
    sim2d::KnownNames names;
    names.models = sim2d::modelNames();
    names.planners = sim2d::plannerNames();
    names.robotTypes = sim2d::robotTypeNames();
    base::Diagnostics found =
        sim2d::checkScenario(scenario, sim2d::makeSurroundings(scenario, *map), file, names);
    sim2d::addLines(found, lines);
    return found;
  });
}

}  // namespace editor
