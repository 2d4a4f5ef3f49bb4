#pragma once

#include <memory>
#include <string>
#include <utility>

#include "sim2d/base/Result.h"

namespace app {

/// Excludes other hunavsim processes from writing results into a folder. The lock ends with the
/// process in any case; its file names the owner.
class FolderLock {
 public:
  static constexpr const char* kFile = ".hunavsim-lock";

  /// Error: locked by another process, which is named, or the folder is not writable.
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

  std::string path_;
  int file_;
};

}  // namespace app
