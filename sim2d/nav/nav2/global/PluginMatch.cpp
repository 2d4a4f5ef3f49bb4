#include "sim2d/nav/nav2/global/PluginMatch.h"

#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {
namespace {

/// "nav2_navfn_planner::NavfnPlanner" -> "NavfnPlanner".
std::string bareClassName(const std::string& name) {
  const std::size_t colons = name.rfind("::");
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

}  // namespace

PluginMatch matchPlugin(const std::string& className, const std::vector<std::string>& available,
                        const std::vector<UnavailablePlugin>& unavailable) {
  const std::string name = normalizedPluginClass(className);
  if (std::find(available.begin(), available.end(), name) != available.end()) {
    return {true, name, ""};
  }
  for (const UnavailablePlugin& known : unavailable) {
    if (known.name == name) {
      return {false, known.nearest, known.why};
    }
  }
  for (const std::string& each : available) {  // the same class name in another package
    if (bareClassName(each) == bareClassName(name)) {
      return {false, each, ""};
    }
  }
  return {false, base::nearestName(name, available).value_or(""), ""};
}

}  // namespace sim2d::nav2
