#include "app/bridge/bag/McapFormat.h"

namespace bridge {

McapRecord::McapRecord(McapOp op) {
  bytes_ += static_cast<char>(op);
  bytes_.append(kRecordHeaderSize - 1, '\0');
}

McapRecord& McapRecord::text(std::string_view text) {
  return bytes(text);
}

McapRecord& McapRecord::bytes(std::string_view bytes) {
  number(static_cast<std::uint32_t>(bytes.size()));
  return raw(bytes);
}

McapRecord& McapRecord::bytes64(std::string_view bytes) {
  number(static_cast<std::uint64_t>(bytes.size()));
  return raw(bytes);
}

McapRecord& McapRecord::raw(std::string_view bytes) {
  bytes_.append(bytes);
  return *this;
}

McapRecord& McapRecord::entries(const McapEntries& entries) {
  std::size_t size = 0;
  for (const auto& [key, value] : entries) {
    size += 2 * sizeof(std::uint32_t) + key.size() + value.size();
  }
  number(static_cast<std::uint32_t>(size));
  for (const auto& [key, value] : entries) {
    text(key);
    text(value);
  }
  return *this;
}

McapRecord& McapRecord::counts(const std::map<std::uint16_t, std::uint64_t>& counts) {
  const std::size_t each = sizeof(std::uint16_t) + sizeof(std::uint64_t);
  number(static_cast<std::uint32_t>(counts.size() * each));
  for (const auto& [channel, count] : counts) {
    number(channel);
    number(count);
  }
  return *this;
}

const std::string& McapRecord::finish(std::size_t following) {
  std::string size;
  base::appendLittleEndian(size, std::uint64_t{bytes_.size() - kRecordHeaderSize + following});
  bytes_.replace(1, size.size(), size);
  return bytes_;
}

}  // namespace bridge
