#include <algorithm>
#include <string>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"

namespace sim2d::nav2 {

const std::vector<DwbCriticType>& dwbCriticTypes() {
  static const std::vector<DwbCriticType> kTypes = [] {
    std::vector<DwbCriticType> types;
    for (const auto& part : {obstacleCriticTypes(), mapGridCriticTypes(), motionCriticTypes()}) {
      types.insert(types.end(), part.begin(), part.end());
    }
    return types;
  }();
  return kTypes;
}

const DwbCriticType* dwbCriticType(const std::string& name,
                                   const std::vector<std::string>& namespaces) {
  const auto find = [](const std::string& plugin) -> const DwbCriticType* {
    const auto& types = dwbCriticTypes();
    const auto found = std::find_if(types.begin(), types.end(), [&](const DwbCriticType& type) {
      return plugin == type.plugin;
    });
    return found == types.end() ? nullptr : &*found;
  };
  std::string plugin = pluginName(name);
  if (plugin.find("Critic") == std::string::npos) {
    plugin += "Critic";
  }
  if (plugin.find("::") != std::string::npos) {
    return find(plugin);
  }
  for (const std::string& space : namespaces) {
    if (const DwbCriticType* type = find(base::join({space, plugin}, "::"))) {
      return type;
    }
  }
  return nullptr;
}

}  // namespace sim2d::nav2
