#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/bag/BagWriter.h"
#include "app/bridge/bag/Compression.h"
#include "app/bridge/bag/McapFormat.h"
#include "sim2d/base/Files.h"

namespace bridge {

/// An MCAP file of profile ros2: CDR messages in chunks of about a mebibyte, compressed by zstd,
/// with checksums, indexes and a summary. Written beside its place and put there by finish(). In
/// memory: one chunk, and 100 bytes per chunk before. Channels of one type share its schema. One
/// thread at a time.
class McapWriter final : public BagWriter {
 public:
  static constexpr std::size_t kChunk = std::size_t{1} << 20U;  // [B] before compression

  explicit McapWriter(const std::string& path);

  std::uint16_t addChannel(WrittenChannel channel) override;
  void write(std::uint16_t channel, std::int64_t time, std::string_view message) override;
  void addMetadata(const std::string& name, const Entries& entries) override;
  bool hasFailed() const override { return file_.hasFailed(); }
  base::Diagnostics finish() override;
  const Totals& totals() const override { return totals_; }

 private:
  struct Channel {
    WrittenChannel told;
    std::uint16_t schema = 0;
    std::uint32_t messages = 0;
    bool isIntroduced = false;  // in a chunk
  };
  struct Schema {
    std::string type, definition;
    bool isIntroduced = false;
  };
  struct Span {
    std::int64_t begin = 0, end = 0;  // [ns]
    void add(std::int64_t time, bool isFirst);
  };

  void append(const std::string& record);
  void introduce(Channel& channel, std::uint16_t id);
  void endChunk();
  std::map<std::uint16_t, std::uint64_t> writeMessageIndexes();
  std::string schemaRecord(std::uint16_t id) const;
  std::string channelRecord(std::uint16_t id) const;
  std::string statisticsRecord() const;
  void writeSummary();

  base::GrowingFile file_;
  std::uint64_t position_ = 0;
  std::uint32_t dataSum_ = 0;      // of all that was written
  std::vector<Schema> schemas_;    // ids from 1
  std::vector<Channel> channels_;  // ids from 0
  Totals totals_;
  ZstdPacker packer_;
  // the chunk that is being made
  std::string chunk_;
  Span chunkSpan_;
  std::map<std::uint16_t, std::vector<std::pair<std::int64_t, std::uint64_t>>> index_;
  // of the summary
  std::vector<std::string> chunkIndexes_, metadataIndexes_;
};

}  // namespace bridge
