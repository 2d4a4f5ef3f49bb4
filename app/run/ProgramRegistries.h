#pragma once

#include <memory>

#include "sim2d/world/Registries.h"

namespace app {

/// All of this program, the planner `nav2` included, which lies above the world.
sim2d::Registries programRegistries();
std::shared_ptr<const sim2d::Registries> sharedRegistries();

}  // namespace app
