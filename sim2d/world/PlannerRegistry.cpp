#include "sim2d/base/Text.h"
#include "sim2d/world/planners/RobotController.h"

namespace sim2d {

void addAllPlanners(PlannerRegistry& to);

std::vector<std::string> PlannerRegistry::names() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries_) {
    names.push_back(entry.name);
  }
  return names;
}

base::Result<std::shared_ptr<RobotController>> PlannerRegistry::make(
    const ResolvedRobot& robot) const {
  for (const Entry& entry : entries_) {
    if (entry.name == robot.planner) {
      return entry.maker(robot);
    }
  }
  const std::optional<std::string> nearest = base::nearestName(robot.planner, names());
  return base::makeError("robot '" + robot.name + "': unknown planner '" + robot.planner + "'" +
                         (nearest ? " (did you mean '" + *nearest + "'?)" : std::string()));
}

const PlannerRegistry& robotPlanners() {
  static const PlannerRegistry kRegistry = [] {
    PlannerRegistry registry;
    addAllPlanners(registry);
    return registry;
  }();
  return kRegistry;
}

}  // namespace sim2d
