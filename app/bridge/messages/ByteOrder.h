#pragma once

#include <algorithm>
#include <cstddef>

namespace bridge {

constexpr bool kIsLittleEndianHost = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;

/// Turns the bytes of each of `count` numbers of `size` bytes round.
inline void swapEach(char* first, std::size_t size, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::reverse(first + i * size, first + (i + 1) * size);
  }
}

}  // namespace bridge
