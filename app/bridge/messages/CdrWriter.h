#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "app/bridge/messages/FieldKinds.h"

namespace bridge {

/// Writes XCDR1 "plain CDR", little endian: the four bytes of encapsulation, then every primitive
/// aligned to its size, counted from behind them. The bytes are appended to `to`.
/// A visitor for the `fields` of messages.
class CdrWriter {
 public:
  explicit CdrWriter(std::string& to);

  template <class T>
  void operator()(const char* /*name*/, const T& value) {
    write(value);
  }

  template <class T>
  void write(const T& value) {
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
      message(value);
    }
  }

  /// The fields of a message; one byte for a message without any.
  template <class M>
  void message(const M& message) {
    if constexpr (kIsEmptyMessage<M>) {
      scalar(std::uint8_t{0});
    } else {
      M::fields(message, *this);
    }
  }

 private:
  template <class T>
  void scalar(T value) {
    align(sizeof(T));
    numbers(&value, sizeof(T), 1);
  }
  template <class C>
  void elements(const C& values) {
    using T = typename C::value_type;
    if constexpr (kIsPrimitive<T> && !std::is_same_v<T, bool>) {
      if (!values.empty()) {
        align(sizeof(T));
        numbers(values.data(), sizeof(T), values.size());
      }
    } else {
      for (const T& value : values) {  // of vector<bool> too
        write(value);
      }
    }
  }
  void text(std::string_view text);
  void align(std::size_t size);
  void numbers(const void* first, std::size_t size, std::size_t count);

  std::string& to_;
  std::size_t begin_;  // of the body in to_
};

}  // namespace bridge
