#include "sim2d/base/ScratchFile.h"

#include <unistd.h>
#include <utility>

namespace base {

std::optional<ScratchFile::Piece> ScratchFile::append(std::string_view bytes) {
  if (!file_) {
    file_.reset(std::tmpfile());
  }
  const Piece piece{end_, bytes.size()};
  while (file_ && !bytes.empty()) {
    const ssize_t count = pwrite(fileno(file_.get()), bytes.data(), bytes.size(), end_);
    if (count <= 0) {
      end_ = piece.place;
      return std::nullopt;
    }
    bytes.remove_prefix(static_cast<std::size_t>(count));
    end_ += count;
  }
  return file_ ? std::make_optional(piece) : std::nullopt;
}

bool ScratchFile::read(const Piece& piece, char* to) const {
  std::size_t done = 0;
  while (file_ && done < piece.size) {
    const auto place = piece.place + static_cast<long long>(done);
    const ssize_t count = pread(fileno(file_.get()), to + done, piece.size - done, place);
    if (count <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(count);
  }
  return done == piece.size;
}

std::optional<std::string> ScratchFile::read(const Piece& piece) const {
  std::string bytes(piece.size, '\0');
  return read(piece, bytes.data()) ? std::make_optional(std::move(bytes)) : std::nullopt;
}

}  // namespace base
