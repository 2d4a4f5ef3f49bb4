#include "app/bridge/bag/McapWriter.h"

#include <algorithm>
#include <utility>

#include "app/bridge/bag/Compression.h"
#include "app/run/DataPaths.h"

namespace bridge {
namespace {

/// The number of elements written to the file: those with messages.
template <class List>
std::size_t writtenCount(const List& list) {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [](const auto& each) { return each.isWritten; }));
}

}  // namespace

McapWriter::McapWriter(const std::string& path) : file_(path) {
  append(std::string(kMcapMagic));
  append(
      McapRecord(McapOp::Header).text("ros2").text("hunavsim " + app::programVersion()).finish());
}

void McapWriter::append(const std::string& record) {
  file_.append(record);
  position_ += record.size();
  dataSum_ = crc32(record, dataSum_);
}

std::uint16_t McapWriter::addChannel(ChannelInfo channel) {
  Channel made;
  const auto known = std::find_if(schemas_.begin(), schemas_.end(), [&](const Schema& schema) {
    return schema.type == channel.type;
  });
  made.schema = static_cast<std::uint16_t>(known - schemas_.begin() + 1);
  if (known == schemas_.end()) {
    schemas_.push_back({channel.type, channel.definition, false});
  }
  made.info = std::move(channel);
  channels_.push_back(std::move(made));
  return static_cast<std::uint16_t>(channels_.size() - 1);
}

std::string McapWriter::schemaRecord(std::uint16_t id) const {
  const Schema& schema = schemas_[id - 1U];
  return McapRecord(McapOp::Schema)
      .number(id)
      .text(schema.type)
      .text("ros2msg")
      .bytes(schema.definition)
      .finish();
}

std::string McapWriter::channelRecord(std::uint16_t id) const {
  const Channel& channel = channels_[id];
  return McapRecord(McapOp::Channel)
      .number(id)
      .number(channel.schema)
      .text(channel.info.topic)
      .text("cdr")
      .entries(channel.info.metadata)
      .finish();
}

/// Writes the channel before its first message, into the same chunk.
void McapWriter::writeChannelOnce(Channel& channel, std::uint16_t id) {
  Schema& schema = schemas_[channel.schema - 1U];
  if (!schema.isWritten) {
    chunk_ += schemaRecord(channel.schema);
    schema.isWritten = true;
  }
  chunk_ += channelRecord(id);
  channel.isWritten = true;
}

void McapWriter::write(std::uint16_t channel, std::int64_t time, std::string_view message) {
  Channel& to = channels_[channel];
  if (!to.isWritten) {
    writeChannelOnce(to, channel);
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

/// Writes one index per channel and returns their positions.
std::map<std::uint16_t, std::uint64_t> McapWriter::writeMessageIndexes() {
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

void McapWriter::endChunk() {
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

void McapWriter::addMetadata(const std::string& name, const Entries& entries) {
  endChunk();
  const std::uint64_t begin = position_;
  append(McapRecord(McapOp::Metadata).text(name).entries(entries).finish());
  metadataIndexes_.push_back(McapRecord(McapOp::MetadataIndex)
                                 .number(begin)
                                 .number(position_ - begin)
                                 .text(name)
                                 .finish());
}

std::string McapWriter::statisticsRecord() const {
  return McapRecord(McapOp::Statistics)
      .number(totals_.messages)
      .number(static_cast<std::uint16_t>(writtenCount(schemas_)))
      .number(static_cast<std::uint32_t>(writtenCount(channels_)))
      .number(std::uint32_t{0})  // attachments
      .number(static_cast<std::uint32_t>(metadataIndexes_.size()))
      .number(static_cast<std::uint32_t>(chunkIndexes_.size()))
      .number(totals_.begin)
      .number(totals_.end)
      .counts(totals_.perChannel)
      .finish();
}

void McapWriter::writeSummary() {
  std::vector<std::string> schemas, channels;
  for (std::size_t k = 0; k < schemas_.size(); ++k) {
    if (schemas_[k].isWritten) {
      schemas.push_back(schemaRecord(static_cast<std::uint16_t>(k + 1)));
    }
  }
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    if (channels_[k].isWritten) {
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
  add(McapOp::Statistics, {statisticsRecord()});
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

base::Diagnostics McapWriter::finish() {
  endChunk();
  append(McapRecord(McapOp::DataEnd).number(dataSum_).finish());
  writeSummary();
  return file_.finish();
}

}  // namespace bridge
