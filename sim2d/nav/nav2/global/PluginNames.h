#pragma once

#include <string>
#include <vector>

namespace sim2d::nav2 {

/// A class of Nav2 that is not here.
struct KnownElsewhere {
  std::string name, nearest, why;
};

struct PluginMatch {
  bool isOffered = false;
  std::string name;  // with "::"; if not offered what comes nearest, or ""
  std::string why;   // of a class that is known elsewhere
};

/// Looks a class name up in both of its spellings, "package::Class" and "package/Class".
PluginMatch matchPlugin(const std::string& className, const std::vector<std::string>& offered,
                        const std::vector<KnownElsewhere>& elsewhere);

}  // namespace sim2d::nav2
