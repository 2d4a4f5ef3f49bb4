#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/LittleEndian.h"

struct ZSTD_CCtx_s;

/// Records of MCAP files (https://mcap.dev/spec): an opcode, an 8-byte length, the content. All
/// numbers are little-endian.
namespace bridge {

constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};
constexpr std::size_t kRecordHeaderSize = 9;  // [B], opcode and length

enum class McapOp : std::uint8_t {
  Header = 1,
  Footer = 2,
  Schema = 3,
  Channel = 4,
  Message = 5,
  Chunk = 6,
  MessageIndex = 7,
  ChunkIndex = 8,
  Statistics = 0x0B,
  Metadata = 0x0C,
  MetadataIndex = 0x0D,
  SummaryOffset = 0x0E,
  DataEnd = 0x0F
};

using McapEntries = std::vector<std::pair<std::string, std::string>>;

/// Builds one record. The length is set by finish().
class McapRecord {
 public:
  explicit McapRecord(McapOp op);

  template <class T>
  McapRecord& number(T value) {
    base::appendLittleEndian(bytes_, value);
    return *this;
  }
  McapRecord& text(std::string_view text) {  // 4-byte length
    return number(static_cast<std::uint32_t>(text.size())).raw(text);
  }
  McapRecord& bytes64(std::string_view bytes) {  // 8-byte length
    return number(static_cast<std::uint64_t>(bytes.size())).raw(bytes);
  }
  McapRecord& entries(const McapEntries& entries);
  /// A map from channel ids to numbers.
  McapRecord& counts(const std::map<std::uint16_t, std::uint64_t>& counts);

  /// `following`: number of content bytes appended separately after this buffer.
  const std::string& finish(std::size_t following = 0);

 private:
  McapRecord& raw(std::string_view bytes) {
    bytes_.append(bytes);
    return *this;
  }

  std::string bytes_;
};

/// Reads the fields of a record in order. After the end, all values are 0 or empty, and hasFailed()
/// is true.
class McapFields {
 public:
  explicit McapFields(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  T number() {
    return base::littleEndian<T>(take(sizeof(T)));
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view bytes64() { return take(number<std::uint64_t>()); }
  std::string_view rest() { return take(bytes_.size()); }
  std::string_view skip(std::size_t size) { return take(size); }
  bool atEnd() const { return bytes_.empty(); }
  bool hasFailed() const { return hasFailed_; }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) {
      hasFailed_ = true;
      bytes_ = {};
      return {};
    }
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(size));
    bytes_.remove_prefix(taken.size());
    return taken;
  }

  std::string_view bytes_;
  bool hasFailed_ = false;
};

/// A record within a buffer.
struct McapRecordView {
  McapOp op = McapOp::Header;
  std::string_view content;
};

/// Removes the next record from `bytes`. False at the end, or if the rest is not a complete record
/// (`bytes` is then not empty).
inline bool nextRecord(std::string_view& bytes, McapRecordView& piece) {
  if (bytes.size() < kRecordHeaderSize) {
    return false;
  }
  McapFields head(bytes.substr(0, kRecordHeaderSize));
  piece.op = static_cast<McapOp>(head.number<std::uint8_t>());
  const auto size = head.number<std::uint64_t>();
  if (size > bytes.size() - kRecordHeaderSize) {
    return false;
  }
  piece.content = bytes.substr(kRecordHeaderSize, static_cast<std::size_t>(size));
  bytes.remove_prefix(kRecordHeaderSize + piece.content.size());
  return true;
}

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
