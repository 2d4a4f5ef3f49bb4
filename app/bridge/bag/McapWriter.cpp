#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/McapFormat.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Files.h"

namespace bridge {
namespace {

/// Writes an MCAP file (makeMcapWriter).
class McapWriter final : public BagWriter {
 public:
  explicit McapWriter(const std::string& path) : file_(path) {
    append(std::string(kMcapMagic));
    append(
        McapRecord(McapOp::Header).text("ros2").text("hunavsim " + app::programVersion()).finish());
  }

  std::uint16_t addChannel(ChannelInfo channel) override {
    const auto known = std::find_if(schemas_.begin(), schemas_.end(), [&](const Schema& schema) {
      return schema.type == channel.type;
    });
    states_.push_back({static_cast<std::uint16_t>(known - schemas_.begin() + 1), 0});
    if (known == schemas_.end()) {
      schemas_.push_back({channel.type, channel.definition, false});
    }
    return BagWriter::addChannel(std::move(channel));
  }

  void write(std::uint16_t channel, std::int64_t time, std::string_view message) override {
    ChannelState& to = states_[channel];
    if (to.messages == 0) {
      writeChannel(channel);
    }
    chunkTotals_.add(channel, time);
    index_[channel].emplace_back(time, chunk_.size());
    chunk_ += McapRecord(McapOp::Message)
                  .number(channel)
                  .number(to.messages++)
                  .number(time)
                  .number(time)
                  .finish(message.size());
    chunk_ += message;
    totals_.add(channel, time);
    if (chunk_.size() >= kChunk) {
      endChunk();
    }
  }

  void addMetadata(const std::string& name, const Entries& entries) override {
    endChunk();
    const std::uint64_t begin = position_;
    append(McapRecord(McapOp::Metadata).text(name).entries(entries).finish());
    metadataIndexes_.push_back(McapRecord(McapOp::MetadataIndex)
                                   .number(begin)
                                   .number(position_ - begin)
                                   .text(name)
                                   .finish());
  }

  bool hasFailed() const override { return file_.hasFailed(); }

  base::Diagnostics finish() override {
    endChunk();
    append(McapRecord(McapOp::DataEnd).number(dataSum_).finish());
    writeSummary();
    return file_.finish();
  }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 20U;  // [B] before compression

  struct ChannelState {
    std::uint16_t schema = 0;
    std::uint32_t messages = 0;  // above 0: the channel is written to a chunk
  };
  struct Schema {
    std::string type, definition;
    bool isWritten = false;
  };

  void append(const std::string& record) {
    file_.append(record);
    position_ += record.size();
    dataSum_ = crc32(record, dataSum_);
  }

  std::string schemaRecord(std::uint16_t id) const {
    const Schema& schema = schemas_[id - 1U];
    return McapRecord(McapOp::Schema)
        .number(id)
        .text(schema.type)
        .text("ros2msg")
        .text(schema.definition)
        .finish();
  }

  std::string channelRecord(std::uint16_t id) const {
    const ChannelInfo& channel = channels_[id];
    return McapRecord(McapOp::Channel)
        .number(id)
        .number(states_[id].schema)
        .text(channel.topic)
        .text("cdr")
        .entries({{"offered_qos_profiles", channel.qos}, {"topic_type_hash", ""}})
        .finish();
  }

  /// Writes the channel before its first message, into the same chunk.
  void writeChannel(std::uint16_t id) {
    Schema& schema = schemas_[states_[id].schema - 1U];
    if (!std::exchange(schema.isWritten, true)) {
      chunk_ += schemaRecord(states_[id].schema);
    }
    chunk_ += channelRecord(id);
  }

  /// Writes one index per channel and returns their positions.
  std::map<std::uint16_t, std::uint64_t> writeMessageIndexes() {
    std::map<std::uint16_t, std::uint64_t> places;
    for (const auto& [channel, messages] : index_) {
      places[channel] = position_;
      constexpr std::size_t kEntry = 2 * sizeof(std::uint64_t);
      McapRecord record(McapOp::MessageIndex);
      record.number(channel).number(static_cast<std::uint32_t>(messages.size() * kEntry));
      for (const auto& [time, offset] : messages) {
        record.number(time).number(offset);
      }
      append(record.finish());
    }
    return places;
  }

  void endChunk() {
    if (chunk_.empty()) {
      return;
    }
    const std::uint64_t begin = position_;
    const std::string_view packed = compressor_.compress(chunk_);
    append(McapRecord(McapOp::Chunk)
               .number(chunkTotals_.begin)
               .number(chunkTotals_.end)
               .number(static_cast<std::uint64_t>(chunk_.size()))
               .number(crc32(chunk_))
               .text("zstd")
               .bytes64(packed)
               .finish());
    const std::uint64_t end = position_;
    const std::map<std::uint16_t, std::uint64_t> indexes = writeMessageIndexes();
    chunkIndexes_.push_back(McapRecord(McapOp::ChunkIndex)
                                .number(chunkTotals_.begin)
                                .number(chunkTotals_.end)
                                .number(begin)
                                .number(end - begin)
                                .counts(indexes)
                                .number(position_ - end)
                                .text("zstd")
                                .number(static_cast<std::uint64_t>(packed.size()))
                                .number(static_cast<std::uint64_t>(chunk_.size()))
                                .finish());
    chunk_.clear();
    chunkTotals_ = {};
    index_.clear();
  }

  void writeSummary() {
    std::vector<std::string> schemas, channels;
    for (std::size_t k = 0; k < schemas_.size(); ++k) {
      if (schemas_[k].isWritten) {
        schemas.push_back(schemaRecord(static_cast<std::uint16_t>(k + 1)));
      }
    }
    for (std::size_t k = 0; k < channels_.size(); ++k) {
      if (states_[k].messages > 0) {
        channels.push_back(channelRecord(static_cast<std::uint16_t>(k)));
      }
    }
    std::string summary, offsets;
    const auto add = [&](McapOp op, const std::vector<std::string>& records) {
      const std::uint64_t begin = summary.size();
      for (const std::string& record : records) {
        summary += record;
      }
      if (!records.empty()) {
        offsets += McapRecord(McapOp::SummaryOffset)
                       .number(static_cast<std::uint8_t>(op))
                       .number(position_ + begin)
                       .number(summary.size() - begin)
                       .finish();
      }
    };
    add(McapOp::Schema, schemas);
    add(McapOp::Channel, channels);
    add(McapOp::Statistics, {McapRecord(McapOp::Statistics)
                                 .number(totals_.messages)
                                 .number(static_cast<std::uint16_t>(schemas.size()))
                                 .number(static_cast<std::uint32_t>(channels.size()))
                                 .number(std::uint32_t{0})  // attachments
                                 .number(static_cast<std::uint32_t>(metadataIndexes_.size()))
                                 .number(static_cast<std::uint32_t>(chunkIndexes_.size()))
                                 .number(totals_.begin)
                                 .number(totals_.end)
                                 .counts(totals_.perChannel)
                                 .finish()});
    add(McapOp::ChunkIndex, chunkIndexes_);
    add(McapOp::MetadataIndex, metadataIndexes_);
    const std::uint64_t begin = position_;
    McapRecord footer(McapOp::Footer);
    footer.number(begin).number(begin + summary.size());
    const std::string footerPrefix =
        McapRecord(footer).number(std::uint32_t{0}).finish().substr(0, kRecordHeaderSize + 16);
    const std::uint32_t sum = crc32(footerPrefix, crc32(offsets, crc32(summary)));
    append(summary + offsets + footer.number(sum).finish() + std::string(kMcapMagic));
  }

  base::AtomicFileWriter file_;
  std::uint64_t position_ = 0;
  std::uint32_t dataSum_ = 0;         // CRC of the bytes written
  std::vector<Schema> schemas_;       // ids from 1
  std::vector<ChannelState> states_;  // by channel
  ZstdCompressor compressor_;
  // The current chunk.
  std::string chunk_;
  Totals chunkTotals_;
  std::map<std::uint16_t, std::vector<std::pair<std::int64_t, std::uint64_t>>> index_;
  // Records of the summary.
  std::vector<std::string> chunkIndexes_, metadataIndexes_;
};

}  // namespace

std::unique_ptr<BagWriter> makeMcapWriter(const std::string& path) {
  return std::make_unique<McapWriter>(path);
}

}  // namespace bridge
