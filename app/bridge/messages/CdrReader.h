#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "app/bridge/messages/FieldKinds.h"
#include "sim2d/base/Result.h"

namespace bridge {

/// Reads XCDR1 "plain CDR" of either byte order from bytes that may be anything. Each length is
/// held against the bytes that are left before anything is allocated. What is wrong first is kept;
/// after it nothing is read. A visitor for the `fields` of messages.
class CdrReader {
 public:
  /// `bytes` begin with the four of encapsulation; they must outlive this.
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
      value = truth();
    } else if constexpr (kIsPrimitive<T>) {
      numbers(&value, sizeof(T), 1);
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
  /// Bytes that were not read.
  std::size_t rest() const { return bytes_.size() - position_; }
  /// More than three bytes at the end, which is no padding, count as a mistake.
  void requireEnd();
  /// What is wrong; only after hasFailed(). `type` names the message.
  base::Diagnostic problem(std::string_view type) const;

 private:
  template <class S>
  void sequence(S& values) {
    using T = typename S::value_type;
    const std::uint32_t count = length(kIsPrimitive<T> ? sizeof(T) : 1, kBoundOf<S>);
    values.clear();
    if constexpr (std::is_same_v<T, bool>) {
      for (std::uint32_t i = 0; i < count && !hasFailed(); ++i) {
        values.push_back(truth());
      }
    } else if constexpr (kIsPrimitive<T>) {
      values.resize(count);
      if (count > 0) {
        numbers(values.data(), sizeof(T), count);
      }
    } else {
      for (std::uint32_t i = 0; i < count && !hasFailed(); ++i) {  // grows with what is read
        values.emplace_back();
        read(values.back());
      }
    }
  }
  template <class A>
  void array(A& values) {
    using T = typename A::value_type;
    if constexpr (kIsPrimitive<T> && !std::is_same_v<T, bool>) {
      numbers(values.data(), sizeof(T), values.size());
    } else {
      for (auto& value : values) {
        read(value);
      }
    }
  }
  bool truth();
  void text(std::string& text, std::size_t bound);
  /// The count in front of a sequence whose elements take `least` bytes or more each.
  std::uint32_t length(std::size_t least, std::size_t bound);
  void numbers(void* first, std::size_t size, std::size_t count);
  void fail(std::string_view code, std::uint64_t found);

  std::string_view bytes_;  // behind the encapsulation
  std::size_t position_ = 0;
  bool isSwapped_ = false;
  const char* field_ = "";
  std::string_view code_;  // of what is wrong; empty: nothing
  std::uint64_t found_ = 0;
};

}  // namespace bridge
