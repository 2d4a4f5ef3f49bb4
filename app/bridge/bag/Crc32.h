#pragma once

#include <cstdint>
#include <string_view>

namespace bridge {

/// CRC-32 of zlib, of `bytes` behind those of which `before` is the sum.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace bridge
