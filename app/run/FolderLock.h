#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

namespace app {

/// Excludes other hunavsim processes from writing results into a folder. The lock ends with the
/// process in any case; its file names the owner. Whoever takes it completes the commit of a killed
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
  FolderLock(std::string path, int file) : path_(std::move(path)), file_(file) {}
  static base::Result<std::unique_ptr<FolderLock>> acquireOnly(const std::string& folder);

  std::string path_;
  int file_;
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

}  // namespace app
