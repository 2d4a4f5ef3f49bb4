#include "app/bridge/bag/Compression.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>
#include <zlib.h>
#include <zstd.h>

namespace bridge {

namespace {

constexpr int kLevel = 1;  // fast, because the run is simulated concurrently

}  // namespace

ZstdCompressor::ZstdCompressor() : context_(ZSTD_createCCtx(), &ZSTD_freeCCtx) {
  if (context_ == nullptr) {
    throw std::bad_alloc();
  }
}

std::string_view ZstdCompressor::compress(std::string_view bytes) {
  buffer_.resize(std::max(buffer_.size(), ZSTD_compressBound(bytes.size())));
  const std::size_t size = ZSTD_compressCCtx(context_.get(), buffer_.data(), buffer_.size(),
                                             bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0U) {  // the buffer is large enough: out of memory
    throw std::bad_alloc();
  }
  return {buffer_.data(), size};
}

std::optional<std::string> zstdDecompressed(std::string_view compressed, std::size_t size) {
  std::string bytes = zstdDecompressedPrefix(compressed, size);
  return bytes.size() == size ? std::optional(std::move(bytes)) : std::nullopt;
}

std::string zstdDecompressedPrefix(std::string_view compressed, std::size_t most) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                          &ZSTD_freeDStream);
  std::string bytes;
  ZSTD_inBuffer in{compressed.data(), compressed.size(), 0};
  std::size_t made = 1;
  while (stream && made > 0 && bytes.size() < most) {
    std::string piece(std::min(most - bytes.size(), ZSTD_DStreamOutSize()), '\0');
    ZSTD_outBuffer out{piece.data(), piece.size(), 0};
    const std::size_t code = ZSTD_decompressStream(stream.get(), &out, &in);
    made = ZSTD_isError(code) != 0U ? 0 : out.pos;
    bytes.append(piece, 0, out.pos);
  }
  return bytes;
}

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace bridge
