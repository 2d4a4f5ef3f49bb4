#include "app/bridge/bag/Crc32.h"

#include <array>
#include <cstddef>

namespace bridge {
namespace {

constexpr std::uint32_t kPolynomial = 0xEDB88320U;
constexpr std::size_t kSlices = 8;  // bytes at once
using Table = std::array<std::array<std::uint32_t, 256>, kSlices>;

constexpr Table makeTable() {
  Table table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) {
      sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? kPolynomial : 0U);
    }
    table[0][byte] = sum;
  }
  for (std::size_t slice = 1; slice < kSlices; ++slice) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t last = table[slice - 1][byte];
      table[slice][byte] = (last >> 8U) ^ table[0][last & 0xFFU];
    }
  }
  return table;
}

constexpr Table kTable = makeTable();

std::uint32_t byteAt(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

}  // namespace

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  std::uint32_t sum = ~before;
  std::size_t at = 0;
  for (; at + kSlices <= bytes.size(); at += kSlices) {
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < kSlices; ++k) {
      const std::uint32_t mixed =
          byteAt(bytes, at + k) ^ (k < 4 ? (sum >> (8U * static_cast<unsigned>(k))) & 0xFFU : 0U);
      next ^= kTable[kSlices - 1 - k][mixed];
    }
    sum = next;
  }
  for (; at < bytes.size(); ++at) {
    sum = (sum >> 8U) ^ kTable[0][(sum ^ byteAt(bytes, at)) & 0xFFU];
  }
  return ~sum;
}

}  // namespace bridge
