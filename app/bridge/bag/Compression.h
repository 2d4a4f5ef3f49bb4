#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;

namespace bridge {

/// Compresses blocks, reusing its memory. Not thread-safe.
class ZstdCompressor {
 public:
  ZstdCompressor();
  /// Returns one zstd frame, valid until the next call.
  std::string_view compress(std::string_view bytes);

 private:
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> context_;
  std::string buffer_;
};

/// Decompresses a frame. Nothing: not a zstd frame or not of `size` bytes. Memory grows with the
/// output.
std::optional<std::string> zstdDecompressed(std::string_view compressed, std::size_t size);

/// Decompresses the beginning of a possibly truncated frame, up to `most` bytes.
std::string zstdDecompressedPrefix(std::string_view compressed, std::size_t most);

/// The zlib CRC-32 of `bytes`. `before`: the CRC of the preceding bytes.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace bridge
