#include "app/run/DataPaths.h"

#include <algorithm>
#include <filesystem>

#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;

std::string programPath() {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  return error ? std::string() : path.string();
}

namespace {

std::string dataFolder(const std::string& name) {
  const fs::path folder = fs::path(programPath()).parent_path();
  for (const char* place : {"../share/hunavsim", "../.."}) {
    std::error_code error;
    const fs::path found = (folder / place / name).lexically_normal();
    if (fs::is_directory(found, error)) {
      return found.string();
    }
  }
  return {};
}

}  // namespace

std::string shippedMapsFolder() {
  return dataFolder("maps");
}

std::string shippedResources(const std::string& folder) {
  return dataFolder("resources/" + folder);
}

std::vector<ShippedScenario> shippedScenarios() {
  std::vector<ShippedScenario> found;
  std::error_code error;
  const fs::path generated = fs::path(programPath()).parent_path() / "maps";
  for (const fs::path& maps : {fs::path(shippedMapsFolder()), generated}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(maps, error)) {
      const bool mayBe = entry.path().extension() == ".yaml";
      const auto text = mayBe ? base::readTextFile(entry.path().string()) : std::string();
      if (text && text->find("hunav_loader:") != std::string::npos) {
        found.push_back({entry.path().stem().string(), entry.path().string()});
      }
    }
  }
  std::sort(found.begin(), found.end(),
            [](const ShippedScenario& a, const ShippedScenario& b) { return a.name < b.name; });
  return found;
}

std::string scenarioFile(const std::string& fileOrName) {
  std::error_code ignored;
  if (!fs::exists(fileOrName, ignored)) {
    for (const ShippedScenario& shipped : shippedScenarios()) {
      if (shipped.name == fileOrName) {
        return shipped.path;
      }
    }
  }
  return fileOrName;
}

std::optional<base::Diagnostic> unknownScenario(const std::string& word,
                                                const std::vector<std::string>& others) {
  std::error_code ignored;
  if (word.empty() || word == "-" || word.find('/') != std::string::npos ||
      fs::exists(word, ignored)) {
    return std::nullopt;
  }
  std::vector<std::string> names = others;
  for (const ShippedScenario& shipped : shippedScenarios()) {
    names.push_back(shipped.name);
  }
  const std::string stem = fs::path(word).stem().string();
  return base::error(others.empty() ? "file.unknown-scenario" : "file.unknown-word",
                     {base::nearestName(stem, names)}, word);
}

std::string programVersion() {
  return HUNAVSIM_VERSION;
}

}  // namespace app
