#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/McapCursor.h"

namespace bridge {

/// What all chunks of a file together may unpack to [B]: so much, and the second for each byte of
/// the file. A small file could go on unpacking for hours otherwise.
constexpr std::size_t kUnpackedOfAny = std::size_t{4} << 30U;
constexpr std::uint64_t kUnpackedPerByte = 100;

/// An MCAP file. With a summary only chunks that hold what is wanted are read; without one, or when
/// the file is cut off, it is read from the beginning as far as it is whole.
class McapReader final : public Bag {
 public:
  static base::Result<std::unique_ptr<Bag>> open(const std::string& path);

  const std::vector<BagChannel>& channels() const override { return channels_; }
  base::Diagnostics read(const std::vector<bool>& channels, const Visit& visit) override;
  std::string metadata(const std::string& name, const std::string& key) override;

 private:
  struct Chunk {
    std::uint64_t place = 0, size = 0;    // of its record, with the head
    bool isCut = false;                   // the file ends in it
    std::vector<std::uint16_t> channels;  // ids of those with messages in it
  };
  struct Placed {
    std::uint64_t place = 0;
    McapOp op = McapOp::Header;
    std::uint64_t size = 0;  // of the content
  };

  explicit McapReader(const std::string& path);
  std::optional<std::string> bytesAt(std::uint64_t place, std::uint64_t size);
  std::optional<Placed> recordAt(std::uint64_t place);
  bool readSummary();
  bool readSummaryRecord(const McapPiece& piece);
  void scan();
  void lookInto(const Placed& record);
  void note(const McapPiece& piece);  // schema, channel, metadata
  std::size_t placeOf(const BagChannel& channel);
  void noteMetadata(std::string_view content);
  std::uint64_t mostUnpacked() const { return kUnpackedOfAny + kUnpackedPerByte * size_; }
  bool mayUnpack(std::uint64_t size);
  std::optional<std::string> unpacked(std::string_view chunk, std::uint64_t place);
  void keepBeginning(std::uint64_t place);
  std::string beginningOf(const Chunk& chunk);
  void readChunk(const Chunk& chunk, const Visit& visit, const std::vector<bool>& wanted);
  /// The bytes that are left: no whole record.
  std::size_t visitMessages(std::string_view records, const Visit& visit,
                            const std::vector<bool>& wanted) const;
  void damaged(const char* part, std::uint64_t place);

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t unpacked_ = 0;  // [B] so far, of one reading
  std::vector<BagChannel> channels_;
  std::map<std::uint16_t, std::size_t> places_;   // of channel ids in channels_
  std::map<std::uint16_t, std::string> schemas_;  // names by id
  std::vector<Chunk> chunks_;                     // a message outside of any chunk is one by itself
  bool isIndexed_ = false;
  std::map<std::string, std::map<std::string, std::string>> metadata_;
  base::Diagnostics problems_;
};

}  // namespace bridge
