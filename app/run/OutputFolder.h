#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/run/FolderLock.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Result.h"

namespace app {

/// Writes the files of one command into a folder: all or none, one process at a time, without
/// overwriting files that hunavsim did not create. The files are written to
/// `.hunavsim-new-<process>`, which commit() renames to `.hunavsim-commit` and moves to their
/// places (FolderLock); manifest.json lists them with their hashes. Only files with the hash listed
/// there are replaced or removed. Names are relative to the folder. One thread.
class OutputFolder {
 public:
  /// Creates the folder and takes its lock. Error: locked by another process, which is named, or
  /// not writable. `force`: files that hunavsim did not create may be overwritten.
  static base::Result<std::unique_ptr<OutputFolder>> open(const std::string& folder, bool force,
                                                          const char* manifest = Manifest::kName);
  /// Without commit() the folder is unchanged.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;

  /// An error for each existing file or folder with one of these names that must not be
  /// overwritten.
  base::Diagnostics conflictingFiles(const std::vector<std::string>& names) const;
  const std::string& path() const { return folder_; }
  /// The manifest that the folder had at open(), or of the last commit.
  const Manifest& manifest() const { return former_; }
  /// The folder for new files until commit().
  const std::string& staging() const { return staging_; }
  /// Error: the name is outside the folder.
  base::Diagnostics write(const std::string& name, std::string_view content);
  /// Sets the SHA-256 of a complete file of the staging folder, so that commit() does not read it
  /// again.
  void setHash(const std::string& name, std::string sha256) {
    newHashes_[name] = std::move(sha256);
  }
  /// Replaces staging paths by final paths in problems.
  base::Diagnostics withFinalPaths(base::Diagnostics problems) const;

  /// What commit() does with files that the manifest lists and that are not written again.
  enum class EarlierFiles { Removed, Kept };
  /// With EarlierFiles::Kept: these earlier files are removed nevertheless, unless written again.
  void removeOnCommit(const std::vector<std::string>& names) { removedOnCommit_ = names; }
  /// Moves all files of the staging folder to their places. `manifest`: a JSON object, to which the
  /// list of files is added as "outputs"; with EarlierFiles::Kept, the earlier manifest stays with
  /// a new list. Errors: nothing has changed, unless a rename fails. More files may be written and
  /// committed afterwards.
  base::Diagnostics commit(const std::string& manifest, EarlierFiles earlier);

 private:
  OutputFolder(std::string folder, bool force, bool isNew, const char* manifest);
  bool isOwnFile(const std::string& name) const;
  bool isConflicting(const std::string& name) const;

  std::string folder_, staging_;
  bool force_, isNew_;
  const char* manifest_;
  std::unique_ptr<FolderLock> lock_;
  Manifest former_;
  FileHashes newHashes_;  // of new files
  std::vector<std::string> removedOnCommit_;
};

/// Adds files to a folder of another program, all or none. `kind`: of the command, for the
/// manifest; `dropped`: earlier files to remove unless written again.
base::Diagnostics writeIntoForeignFolder(const std::string& folder,
                                         const std::vector<base::FileContent>& files,
                                         const char* kind, bool force,
                                         const std::vector<std::string>& dropped = {});

/// For commands that write one file, also several at a time into one folder. Error: the file exists
/// and the hidden manifest of its folder does not list it with its present hash, unless `force` is
/// given.
base::Diagnostics checkOverwrite(const std::string& file, bool force);
/// Writes the file unless checkOverwrite() reports it; a file with the same content is no error.
base::Diagnostics writeFile(const std::string& file, const std::string& content, bool force);
/// Adds a written file to the hidden manifest. `kind`: of the command, for a new manifest. Waits
/// for other processes that do the same.
base::Diagnostics recordOutputFile(const std::string& file, const char* kind);

}  // namespace app
