#include "editor/document/LiveCheck.h"

#include <QFileInfo>

#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

void LiveCheck::start(const sim2d::Scenario& scenario,
                      std::shared_ptr<const sim2d::OccupancyGrid> map, const QString& path) {
  const std::string file = QFileInfo(path).fileName().toStdString();
  task_.start([scenario, map = std::move(map), file] {
    return sim2d::checkScenario(scenario, sim2d::makeSurroundings(scenario, *map), file);
  });
}

}  // namespace editor
