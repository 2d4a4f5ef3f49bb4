#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "app/bridge/messages/ByteOrder.h"
#include "app/bridge/messages/FieldKinds.h"

namespace bridge {

/// Writes XCDR1 "plain CDR", little endian: the four bytes of encapsulation, then every primitive
/// aligned to its size, counted from behind them. The bytes are appended to `to`, where all of a
/// message or value stands when its call is over. A visitor for the `fields` of messages.
class CdrWriter {
 public:
  explicit CdrWriter(std::string& to);

  /// For `fields` within `message`.
  template <class T>
  void operator()(const char* /*name*/, const T& value) {
    put(value);
  }
  template <class T>
  void write(const T& value) {
    put(value);
    flush();
  }
  /// The fields of a message; one byte for a message without any.
  template <class M>
  void message(const M& message) {
    putMessage(message);
    flush();
  }

 private:
  static constexpr std::size_t kPending = 256;  // [bytes]

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
    } else {
      M::fields(message, *this);
    }
  }
  /// Most of a message is single numbers: they are gathered first.
  template <class T>
  void scalar(T value) {
    static_assert(sizeof(T) <= sizeof(std::uint64_t));
    if (used_ + 2 * sizeof(T) > kPending) {
      flush();
    }
    const std::size_t padding = paddingFor(sizeof(T));
    std::memset(&pending_[used_], 0, padding);
    used_ += padding;
    std::memcpy(&pending_[used_], &value, sizeof(T));
    if constexpr (!kIsLittleEndianHost) {
      swapEach(&pending_[used_], sizeof(T), 1);
    }
    used_ += sizeof(T);
  }
  template <class C>
  void elements(const C& values) {
    using T = typename C::value_type;
    if constexpr (kIsPrimitive<T> && !std::is_same_v<T, bool>) {
      if (!values.empty()) {
        numbers(values.data(), sizeof(T), values.size());
      }
    } else {
      for (const T& value : values) {  // of vector<bool> too
        put(value);
      }
    }
  }
  std::size_t paddingFor(std::size_t size) const {
    return (size - (to_.size() + used_ - begin_) % size) % size;
  }
  void text(std::string_view text);
  void numbers(const void* first, std::size_t size, std::size_t count);
  void flush() {
    to_.append(pending_.data(), used_);
    used_ = 0;
  }

  std::string& to_;
  std::size_t begin_;  // of the body in to_
  std::array<char, kPending> pending_;
  std::size_t used_ = 0;
};

}  // namespace bridge
