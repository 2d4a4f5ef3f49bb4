#pragma once

#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

namespace app {

/// SHA-256 (FIPS 180-4) in lower-case hexadecimal digits.
std::string sha256Of(const std::string& bytes);
/// The hash of a file's content, "-" for standard input; nullopt if it cannot be read.
std::optional<std::string> sha256OfFile(const std::string& path);
/// Reads a regular file piece by piece. False: it cannot be read.
bool readPieces(const std::string& path, const std::function<void(std::string_view)>& take);

/// The files that a manifest lists in `outputs`, names relative to its folder, with their SHA-256.
using FileHashes = std::map<std::string, std::string>;

/// Whether a relative name stays inside its folder.
bool isWithin(const std::string& name);

/// The path of an entry of a folder.
std::string pathIn(const std::string& folder, const std::string& name);
/// The absolute path of a file without `.` and `..`; links are not resolved.
std::string absolutePath(const std::string& path);
/// The status of an entry itself, not of the target of a link. An inaccessible entry counts as
/// missing.
std::filesystem::file_status statusOf(const std::string& path);
/// Whether there is an entry of any kind with this path.
bool entryExists(const std::string& path);

/// A manifest as far as it concerns folders.
struct Manifest {
  static constexpr const char* kName = "manifest.json";
  static constexpr const char* kHiddenName =
      ".hunavsim-manifest.json";  // in folders of other programs

  std::string text = "{}";  // a JSON object, empty if the file is missing or is something else
  std::string kind;         // "evaluation" and others; empty for runs and batches
  bool listsOutputs = false;
  FileHashes outputs;

  /// Whether the file of the folder is regular and has the listed hash.
  bool matches(const std::string& folder, const std::string& name) const;
};

/// Reads the manifest of a folder. Error: it cannot be read.
base::Result<Manifest> readManifest(const std::string& folder, const char* name = Manifest::kName);

/// Input files for a manifest: [{"path", "sha256"}]; a null hash and a warning for a file that is
/// missing or unreadable.
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

/// This file name means standard input.
constexpr char kStandardInput[] = "-";

/// Finds an input file of a run by name, relative to the working folder, the run folder or its
/// parent, and by hash.
std::optional<std::string> findInput(const std::string& named, const std::string& runFolder,
                                     const std::string& sha256);

/// Checks that each of these files has the hash listed in manifest.json, or neither exists nor is
/// listed. No problems without a manifest or a list in it.
base::Diagnostics checkManifestFiles(const std::string& folder,
                                     const std::vector<std::string>& names);

/// A file and its content hash.
struct InputHash {
  std::string path, sha256;  // empty hash: missing or unreadable
};

/// The paths, as given, of inputs whose files differ from what was hashed. Missing files and
/// standard input count as unchanged. `folder`: of relative paths; empty: the working folder.
std::vector<std::string> changedInputs(const std::vector<InputHash>& inputs,
                                       const std::string& folder = {});

/// Hashes of input files at first use, to detect later changes. One thread.
class InputFingerprints {
 public:
  /// Returns the index of a file and hashes it on first use.
  std::size_t add(const std::string& path);
  /// All files by index, as they were at first use.
  const std::vector<InputHash>& all() const { return files_; }

  /// The files as they were at first use. A file that has changed or is missing is followed by a
  /// second entry with its current hash. Reads only files that were modified since.
  std::vector<InputHash> withChanges(const std::vector<std::size_t>& numbers);

  using Time = std::pair<std::time_t, long>;  // [s], [ns]
  /// The current time of the file system clock.
  static Time now();
  /// Whether one of these files was modified at that time or later, so that a reader may have read
  /// other content than was hashed.
  bool anyModifiedSince(const std::vector<std::size_t>& numbers, const Time& time) const;

 private:
  /// Time of change, size, device, inode: differs whenever a file is written or replaced.
  using Stamp = std::tuple<Time, long long, unsigned long long, unsigned long long>;
  static std::optional<Stamp> stampOf(const std::string& path);

  std::vector<InputHash> files_;
  std::vector<std::optional<Stamp>> stamps_;  // nullopt: the file was missing
  std::map<std::string, std::size_t> numbers_;
};

}  // namespace app
