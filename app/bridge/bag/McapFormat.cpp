#include "app/bridge/bag/McapFormat.h"

#include <algorithm>
#include <new>
#include <utility>
#include <zlib.h>
#include <zstd.h>

namespace bridge {

McapRecord::McapRecord(McapOp op) {
  bytes_ += static_cast<char>(op);
  bytes_.append(kRecordHeaderSize - 1, '\0');
}

McapRecord& McapRecord::entries(const McapEntries& entries) {
  std::size_t size = 0;
  for (const auto& [key, value] : entries) {
    size += 2 * sizeof(std::uint32_t) + key.size() + value.size();
  }
  number(static_cast<std::uint32_t>(size));
  for (const auto& [key, value] : entries) {
    text(key);
    text(value);
  }
  return *this;
}

McapRecord& McapRecord::counts(const std::map<std::uint16_t, std::uint64_t>& counts) {
  const std::size_t each = sizeof(std::uint16_t) + sizeof(std::uint64_t);
  number(static_cast<std::uint32_t>(counts.size() * each));
  for (const auto& [channel, count] : counts) {
    number(channel);
    number(count);
  }
  return *this;
}

const std::string& McapRecord::finish(std::size_t following) {
  std::string size;
  base::appendLittleEndian(size, std::uint64_t{bytes_.size() - kRecordHeaderSize + following});
  bytes_.replace(1, size.size(), size);
  return bytes_;
}

ZstdCompressor::ZstdCompressor() : context_(ZSTD_createCCtx(), &ZSTD_freeCCtx) {
  if (context_ == nullptr) {
    throw std::bad_alloc();
  }
}

std::string_view ZstdCompressor::compress(std::string_view bytes) {
  constexpr int kLevel = 1;  // fast, because the run is simulated concurrently
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
