#include "app/bridge/bag/Compression.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>
#include <zstd.h>

namespace bridge {

namespace {

constexpr int kLevel = 1;  // the fastest that is not much larger: a run goes on beside it

}  // namespace

ZstdPacker::ZstdPacker() : context_(ZSTD_createCCtx(), &ZSTD_freeCCtx) {
  if (context_ == nullptr) {
    throw std::bad_alloc();
  }
}

std::string_view ZstdPacker::packed(std::string_view bytes) {
  packed_.resize(std::max(packed_.size(), ZSTD_compressBound(bytes.size())));
  const std::size_t size = ZSTD_compressCCtx(context_.get(), packed_.data(), packed_.size(),
                                             bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0U) {  // there is room, so it is memory that is missing
    throw std::bad_alloc();
  }
  return {packed_.data(), size};
}

std::optional<std::string> zstdUnpacked(std::string_view packed, std::size_t size) {
  std::string bytes = zstdBeginning(packed, size);
  return bytes.size() == size ? std::optional(std::move(bytes)) : std::nullopt;
}

std::string zstdBeginning(std::string_view packed, std::size_t most) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                          &ZSTD_freeDStream);
  std::string bytes;
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
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

}  // namespace bridge
