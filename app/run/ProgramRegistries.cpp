#include "app/run/ProgramRegistries.h"

#include "app/run/Nav2Robots.h"
#include "bt/robot/Nav2Planner.h"

namespace app {

sim2d::Registries builtinRegistries() {
  sim2d::Registries all = sim2d::builtinRegistries();
  bt::addNav2(all.planners, shippedNav2Folders());
  return all;
}

std::shared_ptr<const sim2d::Registries> sharedRegistries() {
  return std::make_shared<const sim2d::Registries>(builtinRegistries());
}

}  // namespace app
