#include "sim2d/world/realism/SceneFiles.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {

namespace fs = std::filesystem;

std::string sceneName(const RealismTest& test) {
  std::string name = "realism_" + test.name + "_agents";
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Scenario sceneOf(const RealismTest& test) {
  return test.scene({"das", 1, {}}).scenario(sceneName(test), test.duration);
}

base::Diagnostics writeScenes(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  base::Diagnostics problems;
  std::set<fs::path> written;
  for (const RealismTest& test : realismTests()) {
    const fs::path path = fs::path(folder) / (sceneName(test) + ".yaml");
    base::append(problems, base::writeFileAtomically(path.string(), writeScenario(sceneOf(test))));
    written.insert(path);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (written.count(entry.path()) == 0) {
      fs::remove(entry.path(), error);
    }
  }
  return problems;
}

}  // namespace sim2d
