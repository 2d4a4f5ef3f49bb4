#include <algorithm>
#include <utility>

#include "app/bridge/bag/Compression.h"
#include "app/bridge/bag/Crc32.h"
#include "app/bridge/bag/McapReader.h"

namespace bridge {
namespace {

constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 30U;  // [B] of one chunk

}  // namespace

/// False: all chunks together are too much, which is told; the file is given up then.
bool McapReader::mayUnpack(std::uint64_t size) {
  unpacked_ += size;
  const bool isAllowed = unpacked_ <= mostUnpacked();
  if (!isAllowed) {
    problems_ = {base::error("bag.unpacked", {std::to_string(mostUnpacked())}, path_)};
  }
  return isAllowed;
}

/// The records of a chunk; none when it is damaged, which is told.
std::optional<std::string> McapReader::unpacked(std::string_view chunk, std::uint64_t place) {
  McapFields fields(chunk);
  fields.skip(2 * sizeof(std::uint64_t));
  const auto size = fields.number<std::uint64_t>();
  const auto sum = fields.number<std::uint32_t>();
  const std::string compression(fields.text());
  const std::string_view packed = fields.bytes64();
  if (!compression.empty() && compression != "zstd") {
    const base::Diagnostic unknown = base::warning("bag.compression", {compression}, path_);
    if (problems_.empty() || problems_.back().code != unknown.code) {  // once for many chunks
      problems_.push_back(unknown);
    }
    return std::nullopt;
  }
  std::optional<std::string> records;
  if (!fields.hasFailed() && size <= kMostUnpacked) {
    if (!mayUnpack(size)) {
      return std::nullopt;
    }
    records = compression.empty() ? std::optional(std::string(packed))
                                  : zstdUnpacked(packed, static_cast<std::size_t>(size));
  }
  if (!records || (sum != 0 && crc32(*records) != sum)) {
    damaged("chunk", place);
    return std::nullopt;
  }
  return records;
}

/// The records in the part of a chunk that is there: whole ones and the beginning of another.
std::string McapReader::beginningOf(const Chunk& chunk) {
  const std::optional<std::string> bytes = bytesAt(chunk.place, chunk.size);
  if (!bytes || bytes->size() < kRecordHead ||
      static_cast<McapOp>(bytes->front()) != McapOp::Chunk) {
    return {};
  }
  McapFields fields(std::string_view(*bytes).substr(kRecordHead));
  fields.skip(2 * sizeof(std::uint64_t));  // times
  const auto size = std::min(fields.number<std::uint64_t>(), kMostUnpacked);
  fields.skip(sizeof(std::uint32_t));  // checksum of all of it
  const std::string compression(fields.text());
  fields.skip(sizeof(std::uint64_t));
  const std::string_view packed = fields.rest();
  if (fields.hasFailed() || (!compression.empty() && compression != "zstd")) {
    return {};
  }
  return compression.empty() ? std::string(packed)
                             : zstdBeginning(packed, static_cast<std::size_t>(size));
}

/// The file ends in the record there: of a chunk some messages may be whole.
void McapReader::keepBeginning(std::uint64_t place) {
  Chunk chunk{place, size_ - std::min(place, size_), true, {}};
  const std::string records = beginningOf(chunk);
  std::string_view rest = records;
  for (McapPiece piece; nextRecord(rest, piece);) {
    note(piece);
  }
  if (!records.empty()) {
    chunks_.push_back(std::move(chunk));
  }
}

std::size_t McapReader::visitMessages(std::string_view records, const Visit& visit,
                                      const std::vector<bool>& wanted) const {
  McapPiece piece;
  while (nextRecord(records, piece)) {
    if (piece.op != McapOp::Message) {
      continue;
    }
    McapFields fields(piece.content);
    const auto channel = places_.find(fields.number<std::uint16_t>());
    fields.skip(sizeof(std::uint32_t));  // sequence
    const auto time = fields.number<std::int64_t>();
    fields.skip(sizeof(std::uint64_t));  // publish time
    if (!fields.hasFailed() && channel != places_.end() && wanted[channel->second]) {
      visit(channel->second, time, fields.rest());
    }
  }
  return records.size();
}

void McapReader::readChunk(const Chunk& chunk, const Visit& visit,
                           const std::vector<bool>& wanted) {
  if (chunk.isCut) {  // told when it was opened
    visitMessages(beginningOf(chunk), visit, wanted);
    return;
  }
  const std::optional<Placed> record = recordAt(chunk.place);
  const std::optional<std::string> bytes =
      record ? bytesAt(chunk.place, kRecordHead + record->size) : std::nullopt;
  if (!bytes || (record->op != McapOp::Chunk && record->op != McapOp::Message)) {
    damaged("chunk", chunk.place);
    return;
  }
  const std::optional<std::string> records =
      record->op == McapOp::Message
          ? bytes
          : unpacked(std::string_view(*bytes).substr(kRecordHead), chunk.place);
  if (records && visitMessages(*records, visit, wanted) > 0) {
    damaged("message", chunk.place);
  }
}

base::Diagnostics McapReader::read(const std::vector<bool>& channels, const Visit& visit) {
  problems_.clear();
  unpacked_ = 0;
  const auto isWanted = [&](std::uint16_t id) {
    const auto place = places_.find(id);
    return place != places_.end() && channels[place->second];
  };
  for (const Chunk& chunk : chunks_) {
    if (!isIndexed_ || chunk.channels.empty() ||
        std::any_of(chunk.channels.begin(), chunk.channels.end(), isWanted)) {
      readChunk(chunk, visit, channels);
    }
    if (unpacked_ > mostUnpacked()) {
      break;
    }
  }
  return std::move(problems_);
}

}  // namespace bridge
