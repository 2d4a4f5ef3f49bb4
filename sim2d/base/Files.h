#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "sim2d/base/Result.h"

/// Files that are written whole or not at all; a single text: writeFileAtomically of Text.h.
namespace base {

struct FileContent {
  std::string path;
  std::string content;
};

/// writeFileAtomically (Text.h) for files that belong together: all are written beside their places
/// before the first one is put there; when one cannot be, those before it are put back as they
/// were. Empty = written.
Diagnostics writeFilesTogether(const std::vector<FileContent>& files);

class NewFile;

/// A file written piece by piece beside its place and put there at the end, so a reader sees the
/// old or the new content, never half. Folders are made, the permissions of a replaced file and
/// symbolic links stay. What was not finished leaves nothing behind. One thread at a time.
class GrowingFile {
 public:
  explicit GrowingFile(std::string path);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  GrowingFile(GrowingFile&&) = delete;
  GrowingFile& operator=(GrowingFile&&) = delete;

  void append(std::string_view content);
  /// Something could not be written: the rest is not tried, finish() tells why.
  bool hasFailed() const { return !problems_.empty(); }
  /// All that was appended is on the disk, still beside its place; what finish() would tell.
  const Diagnostics& complete();
  /// Empty = the file is in its place.
  Diagnostics finish();

 private:
  void note(const std::error_code& error);
  void flush();

  std::string path_;
  std::string waiting_;  // not written yet
  Diagnostics problems_;
  std::unique_ptr<NewFile> part_;
};

}  // namespace base
