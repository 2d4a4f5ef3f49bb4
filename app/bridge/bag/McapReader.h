#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/McapFormat.h"

namespace bridge {

/// Limits for the total decompressed size of a file [B]: a constant, plus a multiple of the file
/// size. Otherwise a small file could take hours to decompress.
constexpr std::size_t kMinDecompressionLimit = std::size_t{4} << 30U;
constexpr std::uint64_t kMaxCompressionRatio = 100;

/// Reads an MCAP file. With a summary, only chunks with wanted channels are read. Without one, or
/// if the file is truncated, it is scanned from the beginning to the last complete record.
class McapReader final : public Bag {
 public:
  static base::Result<std::unique_ptr<Bag>> open(const std::string& path);

  const std::vector<BagChannel>& channels() const override { return channels_; }
  base::Diagnostics read(const std::vector<bool>& channels, const Visit& visit) override;
  std::string metadata(const std::string& name, const std::string& key) override;

 private:
  struct Chunk {
    std::uint64_t place = 0, size = 0;    // of the record, including its header
    bool isTruncated = false;             // truncated by the end of the file
    std::vector<std::uint16_t> channels;  // ids of channels with messages
  };
  struct RecordPosition {
    std::uint64_t place = 0;
    McapOp op = McapOp::Header;
    std::uint64_t size = 0;  // of the content
  };

  explicit McapReader(const std::string& path);
  std::optional<std::string> bytesAt(std::uint64_t place, std::uint64_t size);
  std::optional<RecordPosition> recordAt(std::uint64_t place);
  bool readSummary();
  bool readSummaryRecord(const McapRecordView& piece);
  void scan();
  void indexRecord(const RecordPosition& record);
  void note(const McapRecordView& piece);  // handles schema, channel, metadata
  std::size_t placeOf(const BagChannel& channel);
  void noteMetadata(std::string_view content);
  std::uint64_t maxDecompressedSize() const {
    return kMinDecompressionLimit + kMaxCompressionRatio * size_;
  }
  bool mayDecompress(std::uint64_t size);
  std::optional<std::string> decompressChunk(std::string_view chunk, std::uint64_t place);
  void readTruncatedRecord(std::uint64_t place);
  std::string beginningOf(const Chunk& chunk);
  void readChunk(const Chunk& chunk, const Visit& visit, const std::vector<bool>& wanted);
  /// Returns the number of bytes left, an incomplete record.
  std::size_t visitMessages(std::string_view records, const Visit& visit,
                            const std::vector<bool>& wanted) const;
  void damaged(const char* part, std::uint64_t place);

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t decompressedSize_ = 0;  // [B], decompressed in this pass
  std::vector<BagChannel> channels_;
  std::map<std::uint16_t, std::size_t> places_;   // channel id -> index in channels_
  std::map<std::uint16_t, std::string> schemas_;  // id -> type name
  std::vector<Chunk> chunks_;                     // also messages outside chunks, one entry each
  bool isIndexed_ = false;
  std::map<std::string, std::map<std::string, std::string>> metadata_;
  base::Diagnostics problems_;
};

}  // namespace bridge
