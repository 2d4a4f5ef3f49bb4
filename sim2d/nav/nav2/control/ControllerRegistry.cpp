#include "sim2d/nav/nav2/control/ControllerRegistry.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace sim2d::nav2 {

namespace {

const std::vector<ControllerType>& controllerTypes() {
  static const std::vector<ControllerType> kTypes = {regulatedPurePursuit(), dwbController(),
                                                     gracefulController(), rotationShim(),
                                                     mppiController()};
  return kTypes;
}

}  // namespace

const char* controllerErrorName(ControllerError code) {
  static constexpr std::array<const char*, 8> kNames = {
      "UNKNOWN",           "INVALID_CONTROLLER",      "TF_ERROR",         "INVALID_PATH",
      "PATIENCE_EXCEEDED", "FAILED_TO_MAKE_PROGRESS", "NO_VALID_CONTROL", "CONTROLLER_TIMED_OUT"};
  if (code == ControllerError::None) {
    return "NONE";
  }
  const auto at =
      static_cast<std::size_t>(code) - static_cast<std::size_t>(ControllerError::Unknown);
  return at < kNames.size() ? kNames[at] : kNames[0];
}

base::Diagnostic unknownPlugin(const std::string& found, const std::vector<std::string>& known) {
  return base::error(
      "nav2.unknown-plugin",
      {found, base::nearestName(normalizedPluginClass(found), known), base::join(known, ", ")});
}

const ControllerType* findController(const std::string& plugin) {
  return base::findBy(controllerTypes(), &ControllerType::plugin, normalizedPluginClass(plugin));
}

base::Result<std::unique_ptr<Controller>> makeController(const std::string& plugin,
                                                         const ControllerSetup& setup) {
  const ControllerType* type = findController(plugin);
  if (type == nullptr) {
    return unknownPlugin(plugin, controllerPlugins());
  }
  return type->make(setup);
}

std::vector<std::string> controllerPlugins() {
  std::vector<std::string> names;
  for (const ControllerType& type : controllerTypes()) {
    names.push_back(type.plugin);
  }
  return names;
}

}  // namespace sim2d::nav2
