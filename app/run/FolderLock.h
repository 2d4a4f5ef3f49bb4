#pragma once

#include <memory>
#include <string>
#include <utility>

#include "sim2d/base/Result.h"

namespace app {

/// As long as it lives no other process of this program writes results into the folder. The end of
/// the process, however it comes, is the end of the lock; its file says who has it.
class FolderLock {
 public:
  static constexpr const char* kFile = ".hunavsim-lock";

  /// Error: another process has it, which is named; or the folder cannot be written to.
  static base::Result<std::unique_ptr<FolderLock>> take(const std::string& folder);
  /// The folder is made first where it is not there.
  static base::Result<std::unique_ptr<FolderLock>> makeAndTake(const std::string& folder);
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
