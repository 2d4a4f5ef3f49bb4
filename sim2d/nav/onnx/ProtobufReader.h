#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

/// Fields of a message in the wire format of Protocol Buffers
/// (https://protobuf.dev/programming-guides/encoding).
namespace sim2d {

struct ProtobufField {
  std::uint64_t number = 0;
  std::uint64_t value = 0;   // of a varint
  std::string_view bytes{};  // of a text, a message or packed values
  bool isVarint = false;
  bool hasBytes = false;
};

/// Reads the fields of a message in order.
class ProtobufReader {
 public:
  explicit ProtobufReader(std::string_view message) : rest_(message) {}

  /// The next field; nullopt at the end, and after bytes that are no field.
  std::optional<ProtobufField> next() {
    if (rest_.empty() || isDamaged_) {
      return std::nullopt;
    }
    const std::optional<ProtobufField> field = read();
    isDamaged_ = !field;
    return field;
  }
  /// True once bytes were found that are no field.
  bool isDamaged() const { return isDamaged_; }

 private:
  std::optional<std::uint64_t> varint() {
    constexpr unsigned kBits = 7, kMost = 64;
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < kMost && !rest_.empty(); shift += kBits) {
      const auto byte = static_cast<unsigned char>(rest_.front());
      rest_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80U) {
        return value;
      }
    }
    return std::nullopt;
  }

  std::optional<std::string_view> take(std::uint64_t size) {
    if (size > rest_.size()) {
      return std::nullopt;
    }
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(size));
    rest_.remove_prefix(taken.size());
    return taken;
  }

  std::optional<ProtobufField> read() {
    enum Wire : unsigned { Varint = 0, Fixed64 = 1, Bytes = 2, Fixed32 = 5 };
    const std::optional<std::uint64_t> key = varint();
    if (!key || *key >> 3U == 0) {
      return std::nullopt;
    }
    ProtobufField field;
    field.number = *key >> 3U;
    const unsigned wire = *key & 7U;
    if (wire == Fixed64 || wire == Fixed32) {
      return take(wire == Fixed64 ? 8 : 4) ? std::optional(field) : std::nullopt;
    }
    const std::optional<std::uint64_t> value =
        wire == Varint || wire == Bytes ? varint() : std::nullopt;
    const std::optional<std::string_view> bytes =
        value && wire == Bytes ? take(*value) : std::nullopt;
    if (!value || (wire == Bytes && !bytes)) {
      return std::nullopt;
    }
    field.isVarint = wire == Varint;
    field.hasBytes = wire == Bytes;
    field.value = *value;
    field.bytes = bytes.value_or(std::string_view());
    return field;
  }

  std::string_view rest_;
  bool isDamaged_ = false;
};

}  // namespace sim2d
