#include "app/capsule/InputTree.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/capsule/CapsuleManifest.h"
#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

/// The path below a folder; nullopt: it is elsewhere.
std::optional<fs::path> below(const fs::path& path, const fs::path& folder) {
  if (folder.empty()) {
    return std::nullopt;
  }
  const auto [ofPath, ofFolder] =
      std::mismatch(path.begin(), path.end(), folder.begin(), folder.end());
  if (ofFolder != folder.end() || ofPath == path.end()) {
    return std::nullopt;
  }
  fs::path rest;
  for (auto part = ofPath; part != path.end(); ++part) {
    rest /= *part;
  }
  return rest;
}

/// The member of a shipped file; nullopt: the path is not one of those.
std::optional<std::string> sharedMember(const fs::path& path) {
  std::error_code ignored;
  const fs::path maps = app::shippedMapsFolder();
  const fs::path resources =
      maps.empty() ? fs::path() : maps.parent_path() / "resources";  // also of a source tree
  const std::pair<fs::path, const char*> folders[] = {
      {app::generatedMapsFolder(), "maps/generated"}, {maps, "maps"}, {resources, "resources"}};
  for (const fs::path& place : {path, fs::weakly_canonical(path, ignored)}) {
    for (const auto& [folder, name] : folders) {
      if (const auto rest = below(place, folder)) {
        return kSharedFolder + (fs::path(name) / *rest).string();
      }
    }
  }
  return std::nullopt;
}

/// The deepest folder that contains both.
fs::path commonFolder(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto [of, other] = std::pair(a.begin(), b.begin());
       of != a.end() && other != b.end() && *of == *other; ++of, ++other) {
    common /= *of;
  }
  return common;
}

}  // namespace

std::optional<std::string> locateInput(const std::string& named, const std::string& studyFolder,
                                       const std::string& sha256) {
  if (named.empty() || named == app::kStandardInput) {
    return std::nullopt;
  }
  std::error_code ignored;
  const fs::path folder = studyFolder;
  for (const fs::path& path : {fs::path(named), folder / named, folder / ".." / named}) {
    if (app::sha256OfFile(path.string()) == sha256) {
      return fs::absolute(path, ignored).lexically_normal().string();
    }
  }
  return std::nullopt;
}

std::vector<std::string> inputMembers(const std::vector<std::string>& paths) {
  std::vector<std::string> members;
  std::optional<fs::path> common;
  for (const std::string& path : paths) {
    members.push_back(sharedMember(path).value_or(""));
    if (members.back().empty()) {
      const fs::path folder = fs::path(path).parent_path();
      common = common ? commonFolder(*common, folder) : folder;
    }
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    if (members[k].empty()) {
      const auto rest = below(paths[k], *common);
      members[k] = "inputs/files/" + rest.value_or(fs::path(paths[k]).filename()).string();
    }
  }
  return members;
}

}  // namespace capsule
