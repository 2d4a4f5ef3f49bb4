#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/run/ManifestFiles.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Result.h"

namespace app {

/// Excludes other hunavsim processes from writing results into a folder. The lock ends with the
/// process in any case; its file names the owner. Acquiring it completes the commit of a killed
/// process first.
///
/// A commit: a folder with all new files, manifest.json among them, gets the name kCommitFolder;
/// from then on the new files count. They are moved to their places, the manifest last.
class FolderLock {
 public:
  // Reserved names: entries with them are removed.
  static constexpr const char* kFile = ".hunavsim-lock";
  static constexpr const char* kCommitFolder = ".hunavsim-commit";
  static constexpr const char* kStagingPrefix = ".hunavsim-new-";

  /// Error: locked by another process, which is named, the folder is not writable, or the commit of
  /// a killed process cannot be completed.
  static base::Result<std::unique_ptr<FolderLock>> acquire(const std::string& folder);
  /// Creates the folder first if it is missing.
  static base::Result<std::unique_ptr<FolderLock>> createAndAcquire(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  FolderLock(std::string path, base::FileDescriptor file)
      : path_(std::move(path)), file_(std::move(file)) {}
  static base::Result<std::unique_ptr<FolderLock>> acquireOnly(const std::string& folder);

  std::string path_;
  base::FileDescriptor file_;
};

/// Moves the files of kCommitFolder to their places and removes files that are no longer listed.
/// Can be repeated after an interruption at any point. Requires the lock.
base::Diagnostics finishCommit(const std::string& folder);
/// Completes the commit of a killed process before the folder is read. Error: another process
/// writes to the folder, or the commit cannot be completed.
base::Diagnostics completeCommit(const std::string& folder);

/// Flushes the entries of a folder to disk.
void flushFolder(const std::string& folder);
/// All files below a folder, sorted relative names.
base::Result<std::vector<std::string>> filesBelow(const std::string& folder);
/// The error of the last system call, when writing a file.
base::Diagnostic writeProblem(const std::string& path);

/// Whether the name is a lock, staging or commit entry, not a result.
bool isInternalEntry(const std::string& name);
/// The target name of a temporary file (base::AtomicFileWriter) that a killed process left; nullopt
/// for other names.
std::optional<std::string> targetOfTemporary(const std::string& name);

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
/// and the hidden manifest of its folder does not list it with its current hash, unless `force` is
/// given.
base::Diagnostics checkOverwrite(const std::string& file, bool force);
/// Writes the file unless checkOverwrite() reports it; a file with the same content is no error.
base::Diagnostics writeFile(const std::string& file, const std::string& content, bool force);
/// Adds a written file to the hidden manifest. `kind`: of the command, for a new manifest. Waits
/// for other processes that do the same.
base::Diagnostics recordOutputFile(const std::string& file, const char* kind);

}  // namespace app
