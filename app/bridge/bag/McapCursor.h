#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/bridge/bag/McapFormat.h"

namespace bridge {

/// Fields of a record, in order. Beyond the end all is 0 or empty, and hasFailed().
class McapFields {
 public:
  explicit McapFields(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  T number() {
    const std::string_view raw = take(sizeof(T));
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < raw.size(); ++k) {
      value |= std::uint64_t{static_cast<unsigned char>(raw[k])} << (8U * k);
    }
    return static_cast<T>(value);
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view bytes64() { return take(number<std::uint64_t>()); }
  std::string_view rest() { return take(bytes_.size()); }
  std::string_view skip(std::size_t size) { return take(size); }
  bool atEnd() const { return bytes_.empty(); }
  bool hasFailed() const { return hasFailed_; }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) {
      hasFailed_ = true;
      bytes_ = {};
      return {};
    }
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(size));
    bytes_.remove_prefix(taken.size());
    return taken;
  }

  std::string_view bytes_;
  bool hasFailed_ = false;
};

/// A record within bytes.
struct McapPiece {
  McapOp op = McapOp::Header;
  std::string_view content;
};

/// The next record, which is taken off; false at the end, or when the rest is no whole record
/// (`bytes` is not empty then).
inline bool nextRecord(std::string_view& bytes, McapPiece& piece) {
  if (bytes.size() < kRecordHead) {
    return false;
  }
  McapFields head(bytes.substr(0, kRecordHead));
  piece.op = static_cast<McapOp>(head.number<std::uint8_t>());
  const auto size = head.number<std::uint64_t>();
  if (size > bytes.size() - kRecordHead) {
    return false;
  }
  piece.content = bytes.substr(kRecordHead, static_cast<std::size_t>(size));
  bytes.remove_prefix(kRecordHead + piece.content.size());
  return true;
}

}  // namespace bridge
