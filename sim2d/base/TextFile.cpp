#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "sim2d/base/LfsPointer.h"
#include "sim2d/base/Text.h"

namespace base {

namespace {

class OpenFile {
 public:
  /// A pipe does not wait for somebody who writes.
  explicit OpenFile(const std::string& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(OpenFile&&) = delete;
  OpenFile& operator=(OpenFile&&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

Diagnostic tooLarge(const std::string& path, std::size_t most) {
  return error("file.too-large", {most >> 20U}, path);
}

Diagnostic unreadable(const std::string& path, int error) {
  return base::error("file.cannot-read", {std::generic_category().message(error)}, path);
}

/// All that follows in an open file; `expected` bytes of it are likely.
Result<std::string> readAll(int descriptor, const std::string& path, std::size_t expected,
                            std::size_t most) {
  constexpr std::size_t kReadPiece = std::size_t{1} << 16U;  // [B]
  std::string content;
  std::size_t size = 0;
  while (true) {
    if (size == content.size()) {
      content.resize(std::max(size == 0 ? expected + 1 : 2 * size, size + kReadPiece));
    }
    const ssize_t count = ::read(descriptor, content.data() + size, content.size() - size);
    if (count < 0 && errno != EINTR) {
      return unreadable(path, errno);
    }
    size += count > 0 ? static_cast<std::size_t>(count) : 0;
    if (size > most) {
      return tooLarge(path, most);
    }
    if (count == 0) {
      content.resize(size);
      return content;
    }
  }
}

/// The text unchanged, or an error if it is a Git LFS pointer.
Result<std::string> withoutPointer(Result<std::string> text, const std::string& path) {
  return text && isLfsPointer(*text) ? error("file.lfs-pointer", {}, path) : std::move(text);
}

/// Read once: the files of a run are looked at more than once.
const Result<std::string>& standardInput() {
  static const Result<std::string> kText =
      withoutPointer(readAll(STDIN_FILENO, "-", 0, kMostRecord), "-");
  return kText;
}

}  // namespace

Result<std::string> readTextFile(const std::string& path, std::size_t most) {
  if (path == "-") {
    return standardInput();
  }
  const OpenFile file(path);
  struct stat about = {};
  if (file.descriptor() < 0 || ::fstat(file.descriptor(), &about) != 0) {
    return unreadable(path, errno);
  }
  if (S_ISDIR(about.st_mode)) {
    return unreadable(path, EISDIR);
  }
  if (!S_ISREG(about.st_mode)) {
    return error("file.no-file", {}, path);
  }
  const auto size = static_cast<std::size_t>(std::max<off_t>(about.st_size, 0));
  return size > most ? Result<std::string>(tooLarge(path, most))
                     : withoutPointer(readAll(file.descriptor(), path, size, most), path);
}

Diagnostics lfsPointerProblem(const std::string& path) {
  const OpenFile file(path);
  std::array<char, 64> begin{};
  const ssize_t count =
      file.descriptor() < 0 ? 0 : ::read(file.descriptor(), begin.data(), begin.size());
  const std::string_view text(begin.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return isLfsPointer(text) ? Diagnostics{error("file.lfs-pointer", {}, path)} : Diagnostics();
}

}  // namespace base
