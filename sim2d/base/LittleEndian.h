#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Whole numbers as bytes, lowest byte first.
namespace base {

/// Appends the lowest `size` bytes of the number.
template <class T>
void appendLittleEndian(std::string& to, T value, std::size_t size = sizeof(T)) {
  for (std::size_t i = 0; i < size; ++i) {
    to += static_cast<char>(static_cast<std::uint64_t>(value) >> 8U * i & 0xFFU);
  }
}

/// The number in the first bytes, or in all bytes if there are fewer than T has.
template <class T>
T littleEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(T) && i < bytes.size(); ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << 8U * i;
  }
  return static_cast<T>(value);
}

}  // namespace base
