#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace base {

/// Bytes put aside on the disk, in a temporary file without a name that is gone with this. One
/// thread appends; what append() has returned may be read by others meanwhile.
class ScratchFile {
 public:
  struct Piece {
    long long place = 0;
    std::size_t size = 0;  // [B]
  };
  /// None when the disk takes no more.
  std::optional<Piece> append(std::string_view bytes);
  /// None when it cannot be read back.
  std::optional<std::string> read(const Piece& piece) const;
  /// The same into `to`, which has room for it.
  bool read(const Piece& piece, char* to) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;  // made when it is first needed
  long long end_ = 0;
};

}  // namespace base
