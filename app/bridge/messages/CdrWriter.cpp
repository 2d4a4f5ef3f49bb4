#include "app/bridge/messages/CdrWriter.h"

namespace bridge {

CdrWriter::CdrWriter(std::string& to) : to_(to) {
  to_.append("\0\1\0\0", 4);  // plain CDR, little endian; no options
  begin_ = to_.size();
}

void CdrWriter::text(std::string_view text) {
  scalar(static_cast<std::uint32_t>(text.size() + 1));
  if (used_ + text.size() + 1 > kPending) {
    flush();
  }
  if (text.size() + 1 > kPending) {
    to_.append(text);
  } else {
    std::memcpy(&pending_[used_], text.data(), text.size());
    used_ += text.size();
  }
  scalar(char{0});
}

void CdrWriter::numbers(const void* first, std::size_t size, std::size_t count) {
  const std::size_t padding = paddingFor(size);
  flush();
  to_.append(padding, '\0');
  to_.append(static_cast<const char*>(first), size * count);
  if constexpr (!kIsLittleEndianHost) {
    swapEach(&to_[to_.size() - size * count], size, count);
  }
}

}  // namespace bridge
