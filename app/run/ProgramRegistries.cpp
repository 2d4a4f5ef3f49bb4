#include "app/run/ProgramRegistries.h"

#include "app/run/Nav2Robots.h"
#include "bt/robot/Nav2Planner.h"

namespace app {

sim2d::Registries programRegistries() {
  sim2d::Registries all = sim2d::programRegistries();
  bt::addNav2(all.planners, shippedNav2());
  return all;
}

std::shared_ptr<const sim2d::Registries> sharedRegistries() {
  return std::make_shared<const sim2d::Registries>(programRegistries());
}

}  // namespace app
