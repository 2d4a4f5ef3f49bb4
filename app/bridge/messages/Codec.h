#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/bridge/messages/FieldTraits.h"
#include "sim2d/base/Result.h"

namespace bridge {

/// Reads XCDR1 "plain CDR" of either byte order from untrusted bytes. Every count is checked
/// against the remaining bytes before memory is allocated. The first error is kept, and nothing is
/// read after it. It is a visitor for the `fields` functions of messages.
class CdrReader {
 public:
  /// `bytes` start with the 4-byte encapsulation header and must outlive the reader.
  explicit CdrReader(std::string_view bytes);

  template <class T>
  void operator()(const char* name, T& value) {
    if (code_.empty()) {
      field_ = name;
      read(value);
    }
  }

  template <class T>
  void read(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = readBool();
    } else if constexpr (kIsPrimitive<T>) {
      readNumbers(&value, sizeof(T), 1);
    } else if constexpr (kIsString<T>) {
      text(value, kBoundOf<T>);
    } else if constexpr (kIsSequence<T>) {
      sequence(value);
    } else if constexpr (kIsArray<T>) {
      array(value);
    } else {
      message(value);
    }
  }

  template <class M>
  void message(M& message) {
    if constexpr (kIsEmptyMessage<M>) {
      std::uint8_t dummy = 0;
      read(dummy);
    } else {
      M::fields(message, *this);
    }
  }

  bool hasFailed() const { return !code_.empty(); }
  /// Number of bytes not read yet.
  std::size_t rest() const { return bytes_.size() - position_; }
  /// Fails if more than 3 bytes, the maximum padding, remain.
  void requireEnd();
  /// The error. Call only if hasFailed(). `type` is the name of the message type.
  base::Diagnostic problem(std::string_view type) const;

 private:
  template <class S>
  void sequence(S& values) {
    using T = typename S::value_type;
    const std::uint32_t count = readLength(kIsPrimitive<T> ? sizeof(T) : 1, kBoundOf<S>);
    values.clear();
    if constexpr (std::is_same_v<T, bool>) {
      for (std::uint32_t i = 0; i < count && !hasFailed(); ++i) {
        values.push_back(readBool());
      }
    } else if constexpr (kIsPrimitive<T>) {
      values.resize(count);
      if (count > 0) {
        readNumbers(values.data(), sizeof(T), count);
      }
    } else {
      for (std::uint32_t i = 0; i < count && !hasFailed(); ++i) {  // grows with the elements read
        values.emplace_back();
        read(values.back());
      }
    }
  }
  template <class A>
  void array(A& values) {
    using T = typename A::value_type;
    if constexpr (kIsPrimitive<T> && !std::is_same_v<T, bool>) {
      readNumbers(values.data(), sizeof(T), values.size());
    } else {
      for (auto& value : values) {
        read(value);
      }
    }
  }
  bool readBool();
  void text(std::string& text, std::size_t bound);
  /// The element count of a sequence whose elements take at least `least` bytes each.
  std::uint32_t readLength(std::size_t least, std::size_t bound);
  void readNumbers(void* first, std::size_t size, std::size_t count);
  void fail(std::string_view code, std::uint64_t found);

  std::string_view bytes_;  // without the encapsulation header
  std::size_t position_ = 0;
  bool isSwapped_ = false;
  const char* field_ = "";
  std::string_view code_;  // of the first error; empty: no error
  std::uint64_t found_ = 0;
};

constexpr bool kIsLittleEndianHost = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;

/// Reverses the bytes of each of `count` numbers of `size` bytes.
inline void swapBytes(char* first, std::size_t size, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::reverse(first + i * size, first + (i + 1) * size);
  }
}

/// Writes XCDR1 "plain CDR", little endian: the 4-byte encapsulation header, then every primitive
/// aligned to its size relative to the end of the header. Bytes are appended to `to`; a message or
/// value is complete when its call returns. It is a visitor for the `fields` functions of messages.
class CdrWriter {
 public:
  explicit CdrWriter(std::string& to);

  /// Called by the `fields` function of a message.
  template <class T>
  void operator()(const char* /*name*/, const T& value) {
    put(value);
  }
  template <class T>
  void write(const T& value) {
    put(value);
    flush();
  }
  /// Writes the fields of a message, or one zero byte if it has no fields.
  template <class M>
  void message(const M& message) {
    putMessage(message);
    flush();
  }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      scalar(static_cast<std::uint8_t>(value ? 1 : 0));
    } else if constexpr (kIsPrimitive<T>) {
      scalar(value);
    } else if constexpr (kIsString<T>) {
      text(value);
    } else if constexpr (kIsSequence<T>) {
      scalar(static_cast<std::uint32_t>(value.size()));
      elements(value);
    } else if constexpr (kIsArray<T>) {
      elements(value);
    } else {
      putMessage(value);
    }
  }
  template <class M>
  void putMessage(const M& message) {
    if constexpr (kIsEmptyMessage<M>) {
      scalar(std::uint8_t{0});
    } else if constexpr (kIsPacked<M>) {
      writeNumbers<sizeof(typename PackedTraits<M>::Number)>(&message, PackedTraits<M>::kCount);
    } else {
      M::fields(message, *this);
    }
  }
  template <class T>
  void scalar(T value) {
    writeNumbers<sizeof(T)>(&value, 1);
  }
  template <class C>
  void elements(const C& values) {
    using T = typename C::value_type;
    if constexpr (kIsPrimitive<T> && !std::is_same_v<T, bool>) {
      if (!values.empty()) {
        writeNumbers<sizeof(T)>(values.data(), values.size());
      }
    } else if constexpr (kIsPacked<T>) {
      if (!values.empty()) {
        writeNumbers<sizeof(typename PackedTraits<T>::Number)>(
            values.data(), values.size() * PackedTraits<T>::kCount);
      }
    } else {
      for (const T& value : values) {  // also for vector<bool>
        put(value);
      }
    }
  }
  template <std::size_t Size>
  void writeNumbers(const void* first, std::size_t count) {
    static_assert((Size & (Size - 1)) == 0);
    const std::size_t padding = (bodyBegin_ - position_) & (Size - 1);
    ensureCapacity(padding + Size * count);
    position_ += padding;  // the padding is already zero
    std::memcpy(data_ + position_, first, Size * count);
    if constexpr (!kIsLittleEndianHost) {
      swapBytes(data_ + position_, Size, count);
    }
    position_ += Size * count;
  }
  void text(std::string_view text);
  void ensureCapacity(std::size_t more) {
    if (capacity_ - position_ < more) {
      grow(more);
    }
  }
  void grow(std::size_t more);
  /// Truncates the buffer to the bytes written.
  void flush();

  std::string& output_;  // longer than the bytes written, filled with zeros
  char* data_;           // bytes of output_
  std::size_t capacity_;
  std::size_t bodyBegin_;  // first byte after the encapsulation header
  std::size_t position_;   // number of bytes written
};

/// Whether bytes after the last field are accepted. Up to three bytes of padding always are.
enum class TrailingBytes { Refused, Ignored };

/// The message as CDR bytes with the 4-byte encapsulation header, for DDS, MCAP and the live view.
/// `expected`: approximate size of the result [bytes], reserved in advance.
template <class M>
std::string encode(const M& message, std::size_t expected = 0) {
  std::string bytes;
  bytes.reserve(expected);
  CdrWriter(bytes).message(message);
  return bytes;
}

/// Decodes a message. Returns an error if the bytes are not a message of this type; any bytes are
/// safe.
template <class M>
base::Result<M> decode(std::string_view bytes, TrailingBytes rest = TrailingBytes::Refused) {
  M message;
  CdrReader reader(bytes);
  reader.message(message);
  if (rest == TrailingBytes::Refused) {
    reader.requireEnd();
  }
  if (reader.hasFailed()) {
    return reader.problem(M::kType);
  }
  return message;
}

/// The DDS type name: "geometry_msgs/msg/Twist" -> "geometry_msgs::msg::dds_::Twist_".
std::string ddsTypeName(std::string_view type);

/// The inverse of ddsTypeName. Empty if `ddsType` is not a ROS type name.
std::string rosTypeName(std::string_view ddsType);

/// A supported message, request or response type.
struct KnownType {
  std::string_view type;   // "hunav_msgs/msg/Agents"
  const char* definition;  // in the ros2msg format
};

/// All supported types, in the order of AllMessages.
const std::vector<KnownType>& knownTypes();
const KnownType* findType(std::string_view type);  // null: unknown type

}  // namespace bridge
