#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace app {

/// Folders of the program's own data, found relative to the program: the source tree beside a
/// build folder, or <prefix>/share/hunavsim after an installation. Empty when there are none.
std::string shippedMapsFolder();
std::string shippedResources(const std::string& folder);  // "nav2_trees"

/// A scenario that comes with the program: stored in the folder above, or made by the build and in
/// `maps` beside the program.
struct ShippedScenario {
  std::string name;  // file name without .yaml
  std::string path;
};
std::vector<ShippedScenario> shippedScenarios();  // by name

/// A word that is neither a file nor a shipped scenario, with the nearest of these and `others`;
/// nothing for what is a path.
std::optional<base::Diagnostic> unknownScenario(const std::string& word,
                                                const std::vector<std::string>& others = {});

/// The path of the shipped scenario of this name, unless there is such a file; else `fileOrName`.
std::string scenarioFile(const std::string& fileOrName);

std::string programPath();     // of the running executable
std::string programVersion();  // "0.1.0"
std::string programCommit();   // of the source tree it was built from, or "unknown"

}  // namespace app
