#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Sha256.h"
#include "sim2d/base/Result.h"

namespace app {

/// Names of the files that a manifest lists in `outputs`, relative to its folder, with their
/// SHA-256.
using FileHashes = std::map<std::string, std::string>;

/// Whether a name stays in the folder that it is relative to.
bool isWithin(const std::string& name);

/// The text of the manifest of this name in a folder, an object; "{}" where there is none. Error:
/// the disk does not give it.
base::Result<std::string> manifestText(const std::string& folder, const char* name);
base::Result<FileHashes> listedFiles(const std::string& folder, const char* manifest);

/// Files that were read, for a manifest: [{"path", "sha256"}]; null and a warning where one is gone
/// or damaged by now.
template <class Json>
Json inputHashes(const std::vector<std::string>& paths, base::Diagnostics& warnings) {
  Json inputs = Json::array();
  for (const std::string& path : paths) {
    const std::optional<std::string> hash = sha256OfFile(path);
    inputs.push_back({{"path", path}, {"sha256", hash ? Json(*hash) : Json()}});
    if (!hash) {
      warnings.push_back(base::warning("file.not-hashed", {}, path));
    }
  }
  return inputs;
}

/// A scenario of this name is read from the standard input.
constexpr char kStandardInput[] = "-";

/// A file that a run was made of: from where the run was started, or beside its folder, as long as
/// it still has these bytes.
std::optional<std::string> findInput(const std::string& named, const std::string& runFolder,
                                     const std::string& sha256);

/// Whether a regular file is there as it is listed.
bool isAsListed(const std::string& folder, const FileHashes& listed, const std::string& name);

/// Whether each of these files is the one that manifest.json lists, or not there and not listed.
/// Fine without a manifest or a list in it.
base::Diagnostics checkListed(const std::string& folder, const std::vector<std::string>& names);

}  // namespace app
