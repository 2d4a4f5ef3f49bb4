#include "sim2d/nav/nav2/global/PluginNames.h"

#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/Nav2Block.h"

namespace sim2d::nav2 {
namespace {

/// "nav2_navfn_planner::NavfnPlanner" -> "NavfnPlanner".
std::string classPart(const std::string& name) {
  const std::size_t colons = name.rfind("::");
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

}  // namespace

PluginMatch matchPlugin(const std::string& className, const std::vector<std::string>& offered,
                        const std::vector<KnownElsewhere>& elsewhere) {
  const std::string name = pluginName(className);
  if (std::find(offered.begin(), offered.end(), name) != offered.end()) {
    return {true, name, ""};
  }
  for (const KnownElsewhere& known : elsewhere) {
    if (known.name == name) {
      return {false, known.nearest, known.why};
    }
  }
  for (const std::string& each : offered) {  // the right class of another package
    if (classPart(each) == classPart(name)) {
      return {false, each, ""};
    }
  }
  return {false, base::nearestName(name, offered).value_or(""), ""};
}

}  // namespace sim2d::nav2
