#include "app/run/DataPaths.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "sim2d/base/ProgramFile.h"
#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;

std::string programPath() {
  return base::programFile();
}

namespace {

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

constexpr const char* kDataVariable = "HUNAVSIM_DATA";

/// The folder of the variable that replaces data folders; empty: the variable is not set.
fs::path replacedData() {
  const char* const given = std::getenv(kDataVariable);
  return given == nullptr ? fs::path() : fs::path(given);
}

std::string dataFolder(const std::string& name) {
  const fs::path replaced = replacedData();
  if (!replaced.empty() && isFolder(replaced / name)) {
    return (replaced / name).string();
  }
  std::error_code error;
  fs::path folder = fs::weakly_canonical(base::codeFile(), error).parent_path();
  for (; folder.has_relative_path(); folder = folder.parent_path()) {
    const bool isSourceTree = fs::exists(folder / "CMakeLists.txt", error) &&
                              isFolder(folder / "maps") && isFolder(folder / "resources");
    for (const fs::path& place : {folder / "share/hunavsim", isSourceTree ? folder : fs::path()}) {
      if (!place.empty() && isFolder(place / name)) {
        return (place / name).string();
      }
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

std::string generatedMapsFolder() {
  const fs::path replaced = replacedData();
  if (!replaced.empty() && isFolder(replaced / "maps")) {
    return {};  // those of the replaced folder are all
  }
  return (fs::path(programPath()).parent_path() / "maps").string();
}

DataFolderOverride::DataFolderOverride(const std::string& folder) {
  const char* const given = std::getenv(kDataVariable);
  former_ = given == nullptr ? std::nullopt : std::optional<std::string>(given);
  ::setenv(kDataVariable, folder.c_str(), 1);
}

DataFolderOverride::~DataFolderOverride() {
  if (former_) {
    ::setenv(kDataVariable, former_->c_str(), 1);
  } else {
    ::unsetenv(kDataVariable);
  }
}

std::string builtManual() {
  const fs::path folder = fs::path(programPath()).parent_path();
  for (const char* place :
       {"manual/html", "manual", "../share/hunavsim/manual/html", "../share/hunavsim/manual"}) {
    std::error_code error;
    const fs::path found = (folder / place).lexically_normal();
    if (fs::is_regular_file(found / "index.html", error)) {
      return found.string();
    }
  }
  return {};
}

std::vector<ShippedScenario> shippedScenarios() {
  std::vector<ShippedScenario> found;
  std::error_code error;
  for (const fs::path& maps : {fs::path(shippedMapsFolder()), fs::path(generatedMapsFolder())}) {
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

base::Result<std::vector<std::string>> scenarioFiles(const std::vector<std::string>& filesOrNames) {
  std::vector<std::string> paths;
  base::Diagnostics problems;
  for (const std::string& given : filesOrNames) {
    paths.push_back(scenarioFile(given));
    if (std::optional<base::Diagnostic> unknown = unknownScenario(paths.back())) {
      problems.push_back(*std::move(unknown));
    }
  }
  return base::resultOf(std::move(paths), std::move(problems));
}

std::string programVersion() {
  return HUNAVSIM_VERSION;
}

}  // namespace app
