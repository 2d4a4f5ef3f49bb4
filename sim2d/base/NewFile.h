#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "sim2d/base/Result.h"

namespace base {

/// A file of its own beside its place; closed and removed again unless it was put there. The part
/// that the writers of whole files (Text.h, FileSet.h) and of growing ones (GrowingFile.h) share.
class NewFile {
 public:
  /// Opened for writing. Folders are made, the permissions of a replaced file and symbolic links
  /// stay. Nothing and an error in `problems` when that cannot be.
  static std::unique_ptr<NewFile> open(const std::string& path, Diagnostics& problems);

  explicit NewFile(std::filesystem::path target);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  NewFile(NewFile&&) = delete;
  NewFile& operator=(NewFile&&) = delete;

  std::error_code write(std::string_view content) const;
  std::error_code toDisk() const;  // what was written stays when the power fails
  std::error_code putInPlace();
  /// The file that stands there gets a second name until this object ends.
  std::error_code keepOld();
  /// After putInPlace: as it was before.
  std::error_code takeBack();

 private:
  std::error_code make();
  std::error_code keepMode() const;
  bool close();

  std::filesystem::path target_;
  std::string name_;
  std::string old_;  // second name of the file that was replaced
  int descriptor_ = -1;
};

/// "cannot write the file: permission denied" at the file.
Diagnostic fileError(std::string_view code, const std::string& path, const std::error_code& why);
std::error_code lastError();  // of the last call to the system

}  // namespace base
