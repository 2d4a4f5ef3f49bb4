#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

/// Files that are written whole or not at all, and files for a while. A single text:
/// writeFileAtomically of Text.h.
namespace base {

struct FileContent {
  std::string path;
  std::string content;
};

/// writeFileAtomically (Text.h) for files that belong together: all are written beside their places
/// before the first one is put there; when one cannot be, those before it are put back as they
/// were. Empty = written.
Diagnostics writeFilesTogether(const std::vector<FileContent>& files);

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
  friend Diagnostics writeFilesTogether(const std::vector<FileContent>& files);

  static Diagnostics putTogether(const std::vector<FileContent>& files,
                                 const std::vector<std::unique_ptr<GrowingFile>>& made);
  bool isOpen() const { return problems_.empty() && descriptor_ >= 0; }
  void note(const std::error_code& error);
  std::error_code open();
  void flush();
  std::error_code write() const;
  std::error_code putInPlace();
  std::error_code keepOld();   // what stands there gets a second name until this object ends
  std::error_code takeBack();  // after putInPlace: as it was before
  bool close();
  void removeRest();

  std::string path_, target_;  // as named; what a symbolic link points at
  std::string waiting_;        // not written yet
  std::string new_, old_;      // names of the file beside its place, and of the one it replaces
  int descriptor_ = -1;
  Diagnostics problems_;
};

/// Bytes put aside on the disk, in a temporary file that has no name and is gone with this, however
/// the program ends. One thread writes; what append() has returned may be read by others meanwhile.
class ScratchFile {
 public:
  struct Piece {
    long long place = 0;
    std::size_t size = 0;  // [B]
  };
  /// In that folder; empty: in the first of $TMPDIR, /var/tmp (/tmp lies in memory on many systems)
  /// and /tmp that takes it. The disk counts as full when less than `leavesFree` [B] is left on it.
  explicit ScratchFile(std::string folder = {}, long long leavesFree = 0)
      : folder_(std::move(folder)), leavesFree_(leavesFree) {}

  /// None when the disk takes no more: problem() tells why.
  std::optional<Piece> append(std::string_view bytes);
  /// The same over what was put there before; false: it lies there in part, and problem() tells
  /// why.
  bool overwrite(const Piece& piece, std::string_view bytes);
  /// None when it cannot be read back.
  std::optional<std::string> read(const Piece& piece) const;
  /// The same into `to`, which has room for it.
  bool read(const Piece& piece, char* to) const;
  /// It will be read soon: the system may fetch it meanwhile.
  void announce(const Piece& piece) const;
  long long size() const { return end_; }  // [B]
  /// Of the last write that failed.
  const std::error_code& problem() const { return problem_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  bool open();
  bool openIn(const std::string& folder);
  bool hasRoom(std::size_t size);
  bool fail();  // by errno

  std::string folder_;
  long long leavesFree_ = 0;
  std::unique_ptr<std::FILE, Close> file_;  // made when it is first needed
  long long end_ = 0;
  std::error_code problem_;
};

}  // namespace base
