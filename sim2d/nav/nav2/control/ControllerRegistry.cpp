#include "sim2d/nav/nav2/control/ControllerRegistry.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {

const char* controllerErrorName(ControllerError code) {
  switch (code) {
    case ControllerError::None:
      return "NONE";
    case ControllerError::Unknown:
      return "UNKNOWN";
    case ControllerError::InvalidController:
      return "INVALID_CONTROLLER";
    case ControllerError::TfError:
      return "TF_ERROR";
    case ControllerError::InvalidPath:
      return "INVALID_PATH";
    case ControllerError::PatienceExceeded:
      return "PATIENCE_EXCEEDED";
    case ControllerError::FailedToMakeProgress:
      return "FAILED_TO_MAKE_PROGRESS";
    case ControllerError::NoValidControl:
      return "NO_VALID_CONTROL";
    case ControllerError::ControllerTimedOut:
      return "CONTROLLER_TIMED_OUT";
  }
  return "UNKNOWN";
}

base::Diagnostic unknownPlugin(const std::string& found, const std::vector<std::string>& known) {
  std::string all;
  for (const std::string& name : known) {
    all += (all.empty() ? "" : ", ") + name;
  }
  return base::error("nav2.unknown-plugin",
                     {found, base::nearestName(normalizedPluginClass(found), known), all});
}

const ControllerType* ControllerRegistry::find(const std::string& plugin, Distro distro) const {
  const std::string name = normalizedPluginClass(plugin);
  const auto found = std::find_if(types_.begin(), types_.end(), [&](const ControllerType& type) {
    return type.plugin == name && includesDistro(type.distros, distro);
  });
  return found == types_.end() ? nullptr : &*found;
}

std::vector<std::string> ControllerRegistry::plugins(Distro distro) const {
  std::vector<std::string> names;
  for (const ControllerType& type : types_) {
    if (includesDistro(type.distros, distro)) {
      names.push_back(type.plugin);
    }
  }
  return names;
}

base::Result<std::unique_ptr<Controller>> ControllerRegistry::make(
    const std::string& plugin, const ControllerSetup& setup) const {
  const ControllerType* type = find(plugin, setup.distro);
  if (type == nullptr) {
    return unknownPlugin(plugin, plugins(setup.distro));
  }
  return type->make(setup);
}

const ControllerRegistry& controllerRegistry() {
  static const ControllerRegistry kRegistry = [] {
    ControllerRegistry registry;
    addRegulatedPurePursuit(registry);
    addDwb(registry);
    addGraceful(registry);
    addRotationShim(registry);
    addMppi(registry);
    return registry;
  }();
  return kRegistry;
}

}  // namespace sim2d::nav2
