#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/capsule/Archive.h"
#include "app/capsule/CapsuleManifest.h"
#include "sim2d/base/Result.h"

namespace capsule {

/// A new folder for temporary files; removed with its content at the end of its life.
class TemporaryFolder {
 public:
  /// In $TMPDIR, otherwise in /tmp. Error: it cannot be created.
  static base::Result<TemporaryFolder> create();
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept;
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }  // without links

 private:
  explicit TemporaryFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

/// Reads the manifest of a capsule. Errors: missing, damaged, newer format.
base::Result<CapsuleManifest> readCapsuleManifest(const ArchiveReader& archive,
                                                  const std::string& file);

/// Where an input of an unpacked capsule lies; empty: it was not packed.
std::string pathOfInput(const CapsuleInput& input, const std::string& root);

/// The unpacked folder that corresponds to the working folder of the study: inputs with relative
/// recorded paths lie below it. Commands of external planners are relative to it. Empty: unknown.
std::string workingFolderOf(const CapsuleManifest& manifest, const std::string& root);

/// A text that may name unpacked inputs, with their recorded paths instead.
std::string withRecordedPaths(std::string text, const CapsuleManifest& manifest,
                              const std::string& root);

/// Rewrites the paths in the manifest of an unpacked single run: those of inputs become absolute
/// paths below `root`. Runs are replayed and displayed by this manifest.
base::Diagnostics relocateRun(const CapsuleManifest& manifest, const std::string& root);

/// Files that a run of an unpacked study has read: an error for each that is not an input of the
/// capsule, or does not have the content that the study recorded. `file`: name of the capsule.
base::Diagnostics foreignInputs(const std::vector<app::InputHash>& used,
                                const CapsuleManifest& manifest, const std::string& root,
                                const std::string& file);

/// Replaces the folder of an unpacked capsule in places of problems by the name of the capsule.
base::Diagnostics atMembers(base::Diagnostics problems, const std::string& root,
                            const std::string& file);

/// A study that was unpacked to be displayed.
struct UnpackedStudy {
  bool isBatch = true;     // otherwise a single run
  std::string folder;      // of the batch or the run
  std::string experiment;  // path of the experiment file of a batch
};
/// Unpacks a capsule into a folder, which must be empty or missing, so that its study can be
/// displayed. Checksums are not compared. Errors: not a capsule, damaged, not writable.
base::Result<UnpackedStudy> unpackStudy(const std::string& file, const std::string& folder);

}  // namespace capsule
