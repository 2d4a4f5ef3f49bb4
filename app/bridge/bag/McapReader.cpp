#include "app/bridge/bag/McapReader.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "app/bridge/bag/Crc32.h"

namespace bridge {
namespace {

constexpr std::uint64_t kFooter = kRecordHead + 20;  // [B]

}  // namespace

McapReader::McapReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  std::error_code error;
  size_ = std::filesystem::file_size(path, error);
  size_ = error ? 0 : size_;
}

void McapReader::damaged(const char* part, std::uint64_t place) {
  problems_.push_back(base::warning("bag.damaged", {part, std::to_string(place)}, path_));
}

/// None when the file is shorter.
std::optional<std::string> McapReader::bytesAt(std::uint64_t place, std::uint64_t size) {
  if (place > size_ || size > size_ - place) {
    return std::nullopt;
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(place));
  file_.read(bytes.data(), static_cast<std::streamsize>(size));
  return file_ ? std::optional(std::move(bytes)) : std::nullopt;
}

/// Its head alone is read; none when it goes beyond the end.
std::optional<McapReader::Placed> McapReader::recordAt(std::uint64_t place) {
  const std::optional<std::string> head = bytesAt(place, kRecordHead);
  if (!head) {
    return std::nullopt;
  }
  McapFields fields(*head);
  Placed record;
  record.place = place;
  record.op = static_cast<McapOp>(fields.number<std::uint8_t>());
  record.size = fields.number<std::uint64_t>();
  return record.size <= size_ - place - kRecordHead ? std::optional(record) : std::nullopt;
}

void McapReader::noteMetadata(std::string_view content) {
  McapFields fields(content);
  std::map<std::string, std::string>& entries = metadata_[std::string(fields.text())];
  McapFields pairs(fields.text());
  while (!pairs.atEnd() && !pairs.hasFailed()) {
    const std::string key(pairs.text());
    entries[key] = std::string(pairs.text());
  }
}

/// Several writers of one topic have a channel each.
std::size_t McapReader::placeOf(const BagChannel& channel) {
  const auto known = std::find_if(channels_.begin(), channels_.end(), [&](const BagChannel& other) {
    return other.topic == channel.topic && other.type == channel.type;
  });
  const auto place = static_cast<std::size_t>(known - channels_.begin());
  if (known == channels_.end()) {
    channels_.push_back(channel);
  }
  return place;
}

void McapReader::note(const McapPiece& piece) {
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
      places_[id] = placeOf(channel);
    }
  } else if (piece.op == McapOp::Metadata) {
    noteMetadata(piece.content);
  }
}

bool McapReader::readSummaryRecord(const McapPiece& piece) {
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
    const std::optional<Placed> record = recordAt(fields.number<std::uint64_t>());
    const std::optional<std::string> content =
        record ? bytesAt(record->place + kRecordHead, record->size) : std::nullopt;
    if (content) {
      noteMetadata(*content);
    }
  } else {
    note(piece);
  }
  return !fields.hasFailed();
}

/// False: there is none, or it is damaged; nothing is known then.
bool McapReader::readSummary() {
  const std::uint64_t tail = kFooter + kMcapMagic.size();
  if (size_ < tail + kMcapMagic.size()) {
    return false;
  }
  const std::optional<std::string> end = bytesAt(size_ - tail, tail);
  if (!end || end->substr(kFooter) != kMcapMagic ||
      static_cast<McapOp>(end->front()) != McapOp::Footer) {
    return false;
  }
  McapFields footer(std::string_view(*end).substr(kRecordHead));
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
  for (McapPiece piece; isFine && nextRecord(rest, piece);) {
    isFine = readSummaryRecord(piece);
  }
  std::set<std::uint64_t> places;  // a chunk named a thousand times would be read as often
  const bool isEachOnce = std::all_of(chunks_.begin(), chunks_.end(), [&](const Chunk& chunk) {
    return places.insert(chunk.place).second;
  });
  isIndexed_ = isFine && isEachOnce && rest.empty() && !chunks_.empty() && !channels_.empty();
  return isIndexed_;
}

/// What is in a record of the data section, when there is no summary.
void McapReader::lookInto(const Placed& record) {
  const bool isChunk = record.op == McapOp::Chunk;
  if (isChunk || record.op == McapOp::Message) {
    chunks_.push_back({record.place, kRecordHead + record.size, false, {}});
  }
  const bool isTold =
      record.op == McapOp::Schema || record.op == McapOp::Channel || record.op == McapOp::Metadata;
  if (!isChunk && !isTold) {
    return;
  }
  const std::optional<std::string> content = bytesAt(record.place + kRecordHead, record.size);
  if (!content) {
    return;
  }
  if (isTold) {
    note({record.op, *content});
    return;
  }
  const std::optional<std::string> records = unpacked(*content, record.place);
  std::string_view rest = records ? std::string_view(*records) : std::string_view();
  for (McapPiece piece; nextRecord(rest, piece);) {
    note(piece);
  }
}

/// From the beginning to the end of the data, or as far as the records are whole.
void McapReader::scan() {
  channels_.clear();
  places_.clear();
  schemas_.clear();
  chunks_.clear();
  metadata_.clear();
  std::uint64_t place = kMcapMagic.size();
  bool isOver = false;
  while (!isOver) {
    const std::optional<Placed> record = recordAt(place);
    if (!record) {
      problems_.push_back(base::warning("bag.cut", {std::to_string(place)}, path_));
      keepBeginning(place);
      return;
    }
    lookInto(*record);
    if (unpacked_ > mostUnpacked()) {
      return;
    }
    place += kRecordHead + record->size;
    isOver = record->op == McapOp::DataEnd || record->op == McapOp::Footer;
  }
}

base::Result<std::unique_ptr<Bag>> McapReader::open(const std::string& path) {
  std::unique_ptr<McapReader> reader(new McapReader(path));  // NOLINT: private constructor
  const std::optional<std::string> magic = reader->bytesAt(0, kMcapMagic.size());
  if (!magic || *magic != kMcapMagic) {
    return base::error("bag.no-bag", {}, path);
  }
  if (!reader->readSummary()) {
    reader->scan();
  }
  base::Diagnostics told;  // what is damaged is told by read()
  for (const base::Diagnostic& each : std::exchange(reader->problems_, {})) {
    if (each.code == "bag.cut" || each.severity == base::Severity::Error) {
      told.push_back(each);
    }
  }
  if (base::hasErrors(told)) {
    return told;
  }
  return {std::unique_ptr<Bag>(std::move(reader)), std::move(told)};
}

std::string McapReader::metadata(const std::string& name, const std::string& key) {
  const auto record = metadata_.find(name);
  if (record == metadata_.end()) {
    return {};
  }
  const auto entry = record->second.find(key);
  return entry == record->second.end() ? std::string() : entry->second;
}

base::Result<std::unique_ptr<Bag>> openMcap(const std::string& path) {
  return McapReader::open(path);
}

}  // namespace bridge
