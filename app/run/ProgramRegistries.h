#pragma once

#include <memory>

#include "sim2d/world/Registries.h"

namespace app {

/// All registries of the program, with the planner `nav2`, which is in a layer above the world.
sim2d::Registries builtinRegistries();
std::shared_ptr<const sim2d::Registries> sharedRegistries();

}  // namespace app
