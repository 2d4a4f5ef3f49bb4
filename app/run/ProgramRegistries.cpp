#include "app/run/ProgramRegistries.h"

#include "app/run/DataPaths.h"
#include "bt/robot/Nav2Planner.h"

namespace app {

sim2d::Registries programRegistries() {
  sim2d::Registries all = sim2d::programRegistries();
  bt::addNav2(all.planners, {shippedResources("nav2_params"), shippedResources("nav2_trees")});
  return all;
}

std::shared_ptr<const sim2d::Registries> sharedRegistries() {
  return std::make_shared<const sim2d::Registries>(programRegistries());
}

}  // namespace app
