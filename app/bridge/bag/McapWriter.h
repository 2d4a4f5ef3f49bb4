#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/Compression.h"
#include "app/bridge/bag/McapFormat.h"
#include "sim2d/base/Files.h"

namespace bridge {

/// Writes an MCAP file of profile ros2: CDR messages in zstd-compressed chunks of about 1 MiB, with
/// checksums, indexes and a summary. Writes to a temporary file, which finish() moves to its final
/// path. Memory: one chunk, and 100 bytes per earlier chunk. Channels of one type share a schema.
/// Not thread-safe.
class McapWriter final : public BagWriter {
 public:
  static constexpr std::size_t kChunk = std::size_t{1} << 20U;  // [B] before compression

  explicit McapWriter(const std::string& path);

  std::uint16_t addChannel(ChannelInfo channel) override;
  void write(std::uint16_t channel, std::int64_t time, std::string_view message) override;
  void addMetadata(const std::string& name, const Entries& entries) override;
  bool hasFailed() const override { return file_.hasFailed(); }
  base::Diagnostics finish() override;
  const Totals& totals() const override { return totals_; }

 private:
  struct Channel {
    ChannelInfo info;
    std::uint16_t schema = 0;
    std::uint32_t messages = 0;
    bool isWritten = false;  // written to a chunk
  };
  struct Schema {
    std::string type, definition;
    bool isWritten = false;
  };

  void append(const std::string& record);
  void writeChannelOnce(Channel& channel, std::uint16_t id);
  void endChunk();
  std::map<std::uint16_t, std::uint64_t> writeMessageIndexes();
  std::string schemaRecord(std::uint16_t id) const;
  std::string channelRecord(std::uint16_t id) const;
  std::string statisticsRecord() const;
  void writeSummary();

  base::AtomicFileWriter file_;
  std::uint64_t position_ = 0;
  std::uint32_t dataSum_ = 0;      // CRC of the bytes written
  std::vector<Schema> schemas_;    // ids from 1
  std::vector<Channel> channels_;  // ids from 0
  Totals totals_;
  ZstdCompressor compressor_;
  // The current chunk.
  std::string chunk_;
  Totals chunkTotals_;
  std::map<std::uint16_t, std::vector<std::pair<std::int64_t, std::uint64_t>>> index_;
  // Records of the summary.
  std::vector<std::string> chunkIndexes_, metadataIndexes_;
};

}  // namespace bridge
