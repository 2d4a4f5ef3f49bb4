#pragma once

#include <string>
#include <vector>

namespace sim2d::nav2 {

/// A class of Nav2 that is not re-implemented.
struct UnavailablePlugin {
  std::string name, nearest, why;
};

struct PluginMatch {
  bool isAvailable = false;
  std::string name;  // with "::"; the nearest class if there is no match, or ""
  std::string why;   // why a class in `unavailable` cannot be used
};

/// Looks up a class name in both spellings, "package::Class" and "package/Class".
PluginMatch matchPlugin(const std::string& className, const std::vector<std::string>& available,
                        const std::vector<UnavailablePlugin>& unavailable);

}  // namespace sim2d::nav2
