#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bridge {

/// As one frame of zstd.
std::string zstdPacked(std::string_view bytes);
/// None: they are no frames of zstd, or not of `size` bytes in the end. `size` is what is made room
/// for: look at it before.
std::optional<std::string> zstdUnpacked(std::string_view packed, std::size_t size);

}  // namespace bridge
