#include "app/bridge/bag/Compression.h"

#include <new>
#include <utility>
#include <zstd.h>

namespace bridge {

std::string zstdPacked(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), ZSTD_CLEVEL_DEFAULT);
  if (ZSTD_isError(size) != 0U) {  // there is room, so it is memory that is missing
    throw std::bad_alloc();
  }
  packed.resize(size);
  return packed;
}

std::optional<std::string> zstdUnpacked(std::string_view packed, std::size_t size) {
  std::string bytes(size, '\0');
  const std::size_t made = ZSTD_decompress(bytes.data(), size, packed.data(), packed.size());
  return made == size ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace bridge
