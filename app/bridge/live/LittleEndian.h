#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace live {

/// Decodes the first four bytes; requires at least four.
inline std::uint32_t littleEndian32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(bytes[i])) << 8U * i;
  }
  return value;
}

template <class Unsigned>
void appendLittleEndian(std::string& to, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    to += static_cast<char>(value >> 8U * i & 0xFFU);
  }
}

}  // namespace live
