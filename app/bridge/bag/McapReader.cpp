#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/McapFormat.h"

namespace bridge {
namespace {

constexpr std::uint64_t kFooter = kRecordHeaderSize + 20;         // [B]
constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 30U;  // [B], limit per chunk

/// Limits for the total decompressed size of a file [B]: a constant, plus a multiple of the file
/// size. Otherwise a small file could take hours to decompress.
constexpr std::size_t kMinDecompressionLimit = std::size_t{4} << 30U;
constexpr std::uint64_t kMaxCompressionRatio = 100;

/// Reads an MCAP file. With a summary, only chunks with wanted channels are read. Without one, or
/// if the file is truncated, it is scanned from the beginning to the last complete record.
class McapReader final : public Bag {
 public:
  explicit McapReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(path, error);
    size_ = error ? 0 : size_;
  }
  /// Errors: not an MCAP file. Warnings: the file is truncated.
  base::Diagnostics open() {
    const std::optional<std::string> magic = bytesAt(0, kMcapMagic.size());
    if (!magic || *magic != kMcapMagic) {
      return {base::error("bag.no-bag", {}, path_)};
    }
    if (!readSummary()) {
      scan();
    }
    base::Diagnostics openProblems;  // damage is reported by read()
    for (const base::Diagnostic& each : std::exchange(problems_, {})) {
      if (each.code == "bag.cut" || each.severity == base::Severity::Error) {
        openProblems.push_back(each);
      }
    }
    return openProblems;
  }

  const std::vector<BagChannel>& channels() const override { return channels_; }
  base::Diagnostics read(const std::vector<bool>& channels, const Visit& visit) override {
    problems_.clear();
    decompressedSize_ = 0;
    const auto isWanted = [&](std::uint16_t id) {
      const auto place = places_.find(id);
      return place != places_.end() && channels[place->second];
    };
    for (const Chunk& chunk : chunks_) {
      if (!isIndexed_ || chunk.channels.empty() ||
          std::any_of(chunk.channels.begin(), chunk.channels.end(), isWanted)) {
        readChunk(chunk, visit, channels);
      }
      if (decompressedSize_ > maxDecompressedSize()) {
        break;
      }
    }
    return std::move(problems_);
  }
  std::string metadata(const std::string& name, const std::string& key) override {
    const auto record = metadata_.find(name);
    if (record == metadata_.end()) {
      return {};
    }
    const auto entry = record->second.find(key);
    return entry == record->second.end() ? std::string() : entry->second;
  }

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

  /// Nothing if the file is shorter.
  std::optional<std::string> bytesAt(std::uint64_t place, std::uint64_t size) {
    if (place > size_ || size > size_ - place) {
      return std::nullopt;
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(place));
    file_.read(bytes.data(), static_cast<std::streamsize>(size));
    return file_ ? std::optional(std::move(bytes)) : std::nullopt;
  }
  /// Reads only the record header. Nothing if the record exceeds the file.
  std::optional<RecordPosition> recordAt(std::uint64_t place) {
    const std::optional<std::string> head = bytesAt(place, kRecordHeaderSize);
    if (!head) {
      return std::nullopt;
    }
    McapFields fields(*head);
    RecordPosition record;
    record.place = place;
    record.op = static_cast<McapOp>(fields.number<std::uint8_t>());
    record.size = fields.number<std::uint64_t>();
    return record.size <= size_ - place - kRecordHeaderSize ? std::optional(record) : std::nullopt;
  }
  /// False: there is no summary, or it is damaged; then nothing is set.
  bool readSummary() {
    const std::uint64_t tail = kFooter + kMcapMagic.size();
    if (size_ < tail + kMcapMagic.size()) {
      return false;
    }
    const std::optional<std::string> end = bytesAt(size_ - tail, tail);
    if (!end || end->substr(kFooter) != kMcapMagic ||
        static_cast<McapOp>(end->front()) != McapOp::Footer) {
      return false;
    }
    McapFields footer(std::string_view(*end).substr(kRecordHeaderSize));
    const auto begin = footer.number<std::uint64_t>();
    footer.skip(sizeof(std::uint64_t));
    const auto sum = footer.number<std::uint32_t>();
    const std::uint64_t stop = size_ - tail;
    if (begin == 0 || begin > stop) {
      return false;
    }
    const std::optional<std::string> bytes = bytesAt(begin, stop - begin);
    const std::string_view summed = std::string_view(*end).substr(0, kFooter - sizeof(sum));
    if (!bytes || (sum != 0 && crc32(summed, crc32(*bytes)) != sum)) {
      return false;
    }
    bool isFine = true;
    std::string_view rest = *bytes;
    for (McapRecordView piece; isFine && nextRecord(rest, piece);) {
      isFine = readSummaryRecord(piece);
    }
    std::set<std::uint64_t> places;  // rejects duplicates, which would be read repeatedly
    const bool isEachOnce = std::all_of(chunks_.begin(), chunks_.end(), [&](const Chunk& chunk) {
      return places.insert(chunk.place).second;
    });
    isIndexed_ = isFine && isEachOnce && rest.empty() && !chunks_.empty() && !channels_.empty();
    return isIndexed_;
  }
  bool readSummaryRecord(const McapRecordView& piece) {
    McapFields fields(piece.content);
    if (piece.op == McapOp::ChunkIndex) {
      Chunk chunk;
      fields.skip(2 * sizeof(std::uint64_t));  // times
      chunk.place = fields.number<std::uint64_t>();
      chunk.size = fields.number<std::uint64_t>();
      McapFields indexes(fields.text());
      while (!indexes.atEnd() && !indexes.hasFailed()) {
        chunk.channels.push_back(indexes.number<std::uint16_t>());
        indexes.skip(sizeof(std::uint64_t));
      }
      chunks_.push_back(std::move(chunk));
    } else if (piece.op == McapOp::MetadataIndex) {
      const std::optional<RecordPosition> record = recordAt(fields.number<std::uint64_t>());
      const std::optional<std::string> content =
          record ? bytesAt(record->place + kRecordHeaderSize, record->size) : std::nullopt;
      if (content) {
        noteMetadata(*content);
      }
    } else {
      note(piece);
    }
    return !fields.hasFailed();
  }
  /// Scans from the beginning to the end of the data or the last complete record.
  void scan() {
    channels_.clear();
    places_.clear();
    schemas_.clear();
    chunks_.clear();
    metadata_.clear();
    std::uint64_t place = kMcapMagic.size();
    bool isOver = false;
    while (!isOver) {
      const std::optional<RecordPosition> record = recordAt(place);
      if (!record) {
        problems_.push_back(base::warning("bag.cut", {std::to_string(place)}, path_));
        readTruncatedRecord(place);
        return;
      }
      indexRecord(*record);
      if (decompressedSize_ > maxDecompressedSize()) {
        return;
      }
      place += kRecordHeaderSize + record->size;
      isOver = record->op == McapOp::DataEnd || record->op == McapOp::Footer;
    }
  }
  /// Indexes a record of the data section when there is no summary.
  void indexRecord(const RecordPosition& record) {
    const bool isChunk = record.op == McapOp::Chunk;
    if (isChunk || record.op == McapOp::Message) {
      chunks_.push_back({record.place, kRecordHeaderSize + record.size, false, {}});
    }
    const bool isDefinition = record.op == McapOp::Schema || record.op == McapOp::Channel ||
                              record.op == McapOp::Metadata;
    if (!isChunk && !isDefinition) {
      return;
    }
    const std::optional<std::string> content =
        bytesAt(record.place + kRecordHeaderSize, record.size);
    if (!content) {
      return;
    }
    if (isDefinition) {
      note({record.op, *content});
      return;
    }
    const std::optional<std::string> records = decompressChunk(*content, record.place);
    std::string_view rest = records ? std::string_view(*records) : std::string_view();
    for (McapRecordView piece; nextRecord(rest, piece);) {
      note(piece);
    }
  }
  // handles schema, channel, metadata
  void note(const McapRecordView& piece) {
    McapFields fields(piece.content);
    if (piece.op == McapOp::Schema) {
      const auto id = fields.number<std::uint16_t>();
      schemas_.emplace(id, std::string(fields.text()));
    } else if (piece.op == McapOp::Channel) {
      const auto id = fields.number<std::uint16_t>();
      const auto schema = schemas_.find(fields.number<std::uint16_t>());
      BagChannel channel;
      channel.topic = std::string(fields.text());
      channel.encoding = std::string(fields.text());
      channel.type = schema == schemas_.end() ? std::string() : schema->second;
      if (!fields.hasFailed() && places_.count(id) == 0) {
        places_[id] = indexOfChannel(channel, channels_);
      }
    } else if (piece.op == McapOp::Metadata) {
      noteMetadata(piece.content);
    }
  }
  void noteMetadata(std::string_view content) {
    McapFields fields(content);
    std::map<std::string, std::string>& entries = metadata_[std::string(fields.text())];
    McapFields pairs(fields.text());
    while (!pairs.atEnd() && !pairs.hasFailed()) {
      const std::string key(pairs.text());
      entries[key] = std::string(pairs.text());
    }
  }
  std::uint64_t maxDecompressedSize() const {
    return kMinDecompressionLimit + kMaxCompressionRatio * size_;
  }
  /// False: the total decompressed size is above the limit. This is reported, and reading stops.
  bool mayDecompress(std::uint64_t size) {
    decompressedSize_ += size;
    const bool isAllowed = decompressedSize_ <= maxDecompressedSize();
    if (!isAllowed) {
      problems_ = {base::error("bag.unpacked", {std::to_string(maxDecompressedSize())}, path_)};
    }
    return isAllowed;
  }
  /// The records of a chunk. Nothing: damaged (reported).
  std::optional<std::string> decompressChunk(std::string_view chunk, std::uint64_t place) {
    McapFields fields(chunk);
    fields.skip(2 * sizeof(std::uint64_t));
    const auto size = fields.number<std::uint64_t>();
    const auto sum = fields.number<std::uint32_t>();
    const std::string compression(fields.text());
    const std::string_view packed = fields.bytes64();
    if (!compression.empty() && compression != "zstd") {
      const base::Diagnostic unknown = base::warning("bag.compression", {compression}, path_);
      if (problems_.empty() || problems_.back().code != unknown.code) {  // once for all chunks
        problems_.push_back(unknown);
      }
      return std::nullopt;
    }
    std::optional<std::string> records;
    if (!fields.hasFailed() && size <= kMostUnpacked) {
      if (!mayDecompress(size)) {
        return std::nullopt;
      }
      records = compression.empty() ? std::optional(std::string(packed))
                                    : zstdDecompressed(packed, static_cast<std::size_t>(size));
    }
    if (!records || (sum != 0 && crc32(*records) != sum)) {
      damaged("chunk", place);
      return std::nullopt;
    }
    return records;
  }
  /// Reads the last record of a truncated file: a chunk may contain complete messages.
  void readTruncatedRecord(std::uint64_t place) {
    Chunk chunk{place, size_ - std::min(place, size_), true, {}};
    const std::string records = beginningOf(chunk);
    std::string_view rest = records;
    for (McapRecordView piece; nextRecord(rest, piece);) {
      note(piece);
    }
    if (!records.empty()) {
      chunks_.push_back(std::move(chunk));
    }
  }
  /// The available records of a truncated chunk, which may end with an incomplete record.
  std::string beginningOf(const Chunk& chunk) {
    const std::optional<std::string> bytes = bytesAt(chunk.place, chunk.size);
    if (!bytes || bytes->size() < kRecordHeaderSize ||
        static_cast<McapOp>(bytes->front()) != McapOp::Chunk) {
      return {};
    }
    McapFields fields(std::string_view(*bytes).substr(kRecordHeaderSize));
    fields.skip(2 * sizeof(std::uint64_t));  // times
    const auto size = std::min(fields.number<std::uint64_t>(), kMostUnpacked);
    fields.skip(sizeof(std::uint32_t));  // checksum
    const std::string compression(fields.text());
    fields.skip(sizeof(std::uint64_t));
    const std::string_view packed = fields.rest();
    if (fields.hasFailed() || (!compression.empty() && compression != "zstd")) {
      return {};
    }
    return compression.empty() ? std::string(packed)
                               : zstdDecompressedPrefix(packed, static_cast<std::size_t>(size));
  }
  void readChunk(const Chunk& chunk, const Visit& visit, const std::vector<bool>& wanted) {
    if (chunk.isTruncated) {  // reported by open()
      visitMessages(beginningOf(chunk), visit, wanted);
      return;
    }
    const std::optional<RecordPosition> record = recordAt(chunk.place);
    const std::optional<std::string> bytes =
        record ? bytesAt(chunk.place, kRecordHeaderSize + record->size) : std::nullopt;
    if (!bytes || (record->op != McapOp::Chunk && record->op != McapOp::Message)) {
      damaged("chunk", chunk.place);
      return;
    }
    const std::optional<std::string> records =
        record->op == McapOp::Message
            ? bytes
            : decompressChunk(std::string_view(*bytes).substr(kRecordHeaderSize), chunk.place);
    if (records && visitMessages(*records, visit, wanted) > 0) {
      damaged("message", chunk.place);
    }
  }
  /// Returns the number of bytes left, an incomplete record.
  std::size_t visitMessages(std::string_view records, const Visit& visit,
                            const std::vector<bool>& wanted) const {
    McapRecordView piece;
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
  void damaged(const char* part, std::uint64_t place) {
    problems_.push_back(base::warning("bag.damaged", {part, std::to_string(place)}, path_));
  }

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

}  // namespace

base::Result<std::unique_ptr<Bag>> openMcap(const std::string& path) {
  auto reader = std::make_unique<McapReader>(path);
  base::Diagnostics problems = reader->open();
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::unique_ptr<Bag>(std::move(reader)), std::move(problems)};
}

}  // namespace bridge
