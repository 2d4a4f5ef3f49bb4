#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;

namespace bridge {

/// Packs one piece after the other in the same memory. Thread: one at a time.
class ZstdPacker {
 public:
  ZstdPacker();
  /// As one frame of zstd, valid until the next call.
  std::string_view packed(std::string_view bytes);

 private:
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> context_;
  std::string packed_;
};

/// None: they are no frame of zstd, or not of `size` bytes. Memory is taken as bytes come.
std::optional<std::string> zstdUnpacked(std::string_view packed, std::size_t size);

/// What the beginning of such a frame holds, up to `most` bytes.
std::string zstdBeginning(std::string_view packed, std::size_t most);

}  // namespace bridge
