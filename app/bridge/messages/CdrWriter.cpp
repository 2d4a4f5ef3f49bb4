#include "app/bridge/messages/CdrWriter.h"

#include "app/bridge/messages/ByteOrder.h"

namespace bridge {

CdrWriter::CdrWriter(std::string& to) : to_(to) {
  to_.append("\0\1\0\0", 4);  // plain CDR, little endian; no options
  begin_ = to_.size();
}

void CdrWriter::align(std::size_t size) {
  const std::size_t over = (to_.size() - begin_) % size;
  if (over > 0) {
    to_.append(size - over, '\0');
  }
}

void CdrWriter::text(std::string_view text) {
  scalar(static_cast<std::uint32_t>(text.size() + 1));
  to_.append(text);
  to_ += '\0';
}

void CdrWriter::numbers(const void* first, std::size_t size, std::size_t count) {
  to_.append(static_cast<const char*>(first), size * count);
  if constexpr (!kIsLittleEndianHost) {
    swapEach(&to_[to_.size() - size * count], size, count);
  }
}

}  // namespace bridge
