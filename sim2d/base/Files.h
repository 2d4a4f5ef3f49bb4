#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

/// Atomic writing of files, and temporary files. For a single text use writeFileAtomically
/// (Text.h).
namespace base {

/// Owns a file descriptor. -1: none.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int number() const { return number_; }
  bool isOpen() const { return number_ >= 0; }
  void close() {
    if (number_ >= 0) {
      ::close(std::exchange(number_, -1));
    }
  }

 private:
  int number_ = -1;
};

struct FileContent {
  std::string path;
  std::string content;
};

/// Writes several files, all or none: each is first written next to its target, then all are
/// renamed. If one fails, the files already replaced are restored. Empty: all are written.
Diagnostics writeFilesAtomically(const std::vector<FileContent>& files);

/// Writes a file in pieces to a temporary name next to it and renames it at the end, so that
/// readers see the old or the new content. Creates folders; keeps the permissions of the replaced
/// file and symbolic links. Without finish() the temporary file is removed. Not thread-safe.
class AtomicFileWriter {
 public:
  explicit AtomicFileWriter(std::string path);
  ~AtomicFileWriter();
  AtomicFileWriter(const AtomicFileWriter&) = delete;
  AtomicFileWriter& operator=(const AtomicFileWriter&) = delete;
  AtomicFileWriter(AtomicFileWriter&&) = delete;
  AtomicFileWriter& operator=(AtomicFileWriter&&) = delete;

  void append(std::string_view content);
  /// A write failed: further content is ignored, and finish() returns the error.
  bool hasFailed() const { return !problems_.empty(); }
  /// Where the content is until finish(), for libraries that write files themselves. Empty: it
  /// could not be created.
  const std::string& temporaryPath() const { return temporaryPath_; }
  /// Syncs the content to disk under the temporary name and returns the errors so far.
  const Diagnostics& complete();
  /// Renames the file to its target. Empty: it is written.
  Diagnostics finish();

 private:
  friend Diagnostics writeFilesAtomically(const std::vector<FileContent>& files);

  static Diagnostics replaceAll(const std::vector<FileContent>& files,
                                const std::vector<std::unique_ptr<AtomicFileWriter>>& made);
  bool isOpen() const { return problems_.empty() && descriptor_.isOpen(); }
  void note(const std::error_code& error);
  std::error_code open();
  void flush();
  std::error_code write() const;
  std::error_code replaceTarget();
  std::error_code backUpTarget();   // links or copies the target to backupPath_
  std::error_code restoreTarget();  // undoes replaceTarget
  void removeTemporaryFiles();

  std::string path_, targetPath_;           // as given; with symbolic links resolved
  std::string buffer_;                      // buffered content
  std::string temporaryPath_, backupPath_;  // paths of the temporary file and of the backup
  FileDescriptor descriptor_;
  Diagnostics problems_;
};

/// An unnamed temporary file; the system removes it when the process ends. One thread writes; other
/// threads may read pieces that append() has returned.
class ScratchFile {
 public:
  struct Piece {
    long long place = 0;
    std::size_t size = 0;  // [B]
  };
  /// Creates the file in `folder`; if empty, in the first usable of $TMPDIR, /var/tmp and /tmp (on
  /// many systems /tmp is in memory). The disk counts as full when less than `minFreeSpace` [B]
  /// would remain.
  explicit ScratchFile(std::string folder = {}, long long minFreeSpace = 0)
      : folder_(std::move(folder)), minFreeSpace_(minFreeSpace) {}

  /// None: the write failed, see problem().
  std::optional<Piece> append(std::string_view bytes);
  /// Overwrites a piece that append() returned. False: it is written in part, see problem().
  bool overwrite(const Piece& piece, std::string_view bytes);
  /// None: it cannot be read.
  std::optional<std::string> read(const Piece& piece) const;
  /// Reads into `to`, which has `piece.size` bytes.
  bool read(const Piece& piece, char* to) const;
  /// Asks the system to read the piece ahead.
  void prefetch(const Piece& piece) const;
  long long size() const { return end_; }  // [B]
  /// The error of the last failed write.
  const std::error_code& problem() const { return problem_; }

 private:
  bool open();
  bool openIn(const std::string& folder);
  bool hasFreeSpace(std::size_t size);
  bool fail();  // sets problem_ from errno

  std::string folder_;
  long long minFreeSpace_ = 0;
  FileDescriptor file_;  // opened on first use
  long long end_ = 0;
  std::error_code problem_;
};

}  // namespace base
