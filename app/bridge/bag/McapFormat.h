#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Records of MCAP files (https://mcap.dev/spec): an opcode, a length of eight bytes, the content.
/// All numbers are little endian.
namespace bridge {

constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};
constexpr std::size_t kRecordHead = 9;  // [B] opcode and length

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

/// One record; its length is known at the end.
class McapRecord {
 public:
  explicit McapRecord(McapOp op);

  template <class T>
  McapRecord& number(T value) {
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      bytes_ += static_cast<char>((static_cast<std::uint64_t>(value) >> (8U * k)) & 0xFFU);
    }
    return *this;
  }
  McapRecord& text(std::string_view text);      // length of four bytes
  McapRecord& bytes(std::string_view bytes);    // the same
  McapRecord& bytes64(std::string_view bytes);  // length of eight bytes
  McapRecord& entries(const McapEntries& entries);
  /// A map from channels to numbers.
  McapRecord& counts(const std::map<std::uint16_t, std::uint64_t>& counts);

  /// `following`: so many bytes of its content come behind what stands here.
  const std::string& finish(std::size_t following = 0);

 private:
  McapRecord& raw(std::string_view bytes);

  std::string bytes_;
};

}  // namespace bridge
