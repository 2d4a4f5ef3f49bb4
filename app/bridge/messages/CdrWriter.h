#pragma once

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
    } else if constexpr (kIsBlock<M>) {
      numbers<sizeof(typename BlockTraits<M>::Number)>(&message, BlockTraits<M>::kCount);
    } else {
      M::fields(message, *this);
    }
  }
  template <class T>
  void scalar(T value) {
    numbers<sizeof(T)>(&value, 1);
  }
  template <class C>
  void elements(const C& values) {
    using T = typename C::value_type;
    if constexpr (kIsPrimitive<T> && !std::is_same_v<T, bool>) {
      if (!values.empty()) {
        numbers<sizeof(T)>(values.data(), values.size());
      }
    } else if constexpr (kIsBlock<T>) {
      if (!values.empty()) {
        numbers<sizeof(typename BlockTraits<T>::Number)>(values.data(),
                                                         values.size() * BlockTraits<T>::kCount);
      }
    } else {
      for (const T& value : values) {  // of vector<bool> too
        put(value);
      }
    }
  }
  template <std::size_t Size>
  void numbers(const void* first, std::size_t count) {
    static_assert((Size & (Size - 1)) == 0);
    const std::size_t padding = (begin_ - at_) & (Size - 1);
    makeRoom(padding + Size * count);
    at_ += padding;  // what is skipped is zero
    std::memcpy(data_ + at_, first, Size * count);
    if constexpr (!kIsLittleEndianHost) {
      swapEach(data_ + at_, Size, count);
    }
    at_ += Size * count;
  }
  void text(std::string_view text);
  void makeRoom(std::size_t more) {
    if (room_ - at_ < more) {
      grow(more);
    }
  }
  void grow(std::size_t more);
  /// Takes away what has not been written.
  void flush();

  std::string& to_;  // longer than what is written, by zeros
  char* data_;       // its bytes
  std::size_t room_;
  std::size_t begin_;  // of the body
  std::size_t at_;     // so much is written
};

}  // namespace bridge
