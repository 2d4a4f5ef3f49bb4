#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bridge {

/// As one frame of zstd.
std::string zstdPacked(std::string_view bytes);
/// None: they are no frame of zstd, or not of `size` bytes. Memory is taken as bytes come.
std::optional<std::string> zstdUnpacked(std::string_view packed, std::size_t size);

/// What the beginning of such a frame holds, up to `most` bytes.
std::string zstdBeginning(std::string_view packed, std::size_t most);

}  // namespace bridge
