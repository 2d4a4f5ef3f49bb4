#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Types.h"

/// Values of blackboard entries and ports.
namespace bt {

/// Long: a whole number that is too large for an int.
enum class ValueType : std::uint8_t { Unset, Int, Long, Double, Bool, String };

struct Value {
  ValueType type = ValueType::Unset;
  union {
    std::int64_t integer = 0;  // Int, Long, Bool
    double real;               // Double
  };
  std::string text;  // String; also of a number in an entry for text, otherwise empty then

  Value() = default;
  Value(ValueType itsType, std::int64_t whole, std::string_view itsText = {})
      : type(itsType), integer(whole), text(itsText) {}
  static Value of(int value) { return of(static_cast<std::int64_t>(value)); }
  static Value of(std::int64_t value) {
    const bool isInt = value == static_cast<int>(value);
    return {isInt ? ValueType::Int : ValueType::Long, value};
  }
  static Value of(bool value) { return {ValueType::Bool, value ? 1 : 0}; }
  static Value of(double value) {
    Value result(ValueType::Double, 0);
    result.real = value;
    return result;
  }
  static Value of(std::string_view value) { return {ValueType::String, 0, value}; }
  bool isNumber() const { return type != ValueType::Unset && type != ValueType::String; }
  double number() const { return type == ValueType::Double ? real : static_cast<double>(integer); }
  std::string toText() const;  // for lists; "" when unset
};

/// Reads with the conversions that ports allow: text is parsed, a real becomes a whole number only
/// when it is one, a number becomes a bool only when it is 0 or 1. Nothing = does not fit.
namespace detail {
std::optional<int> convertedToInt(const Value& value);
std::optional<double> convertedToDouble(const Value& value);
}  // namespace detail
template <class T>
std::optional<T> valueAs(const Value& value);
template <>
inline std::optional<int> valueAs(const Value& value) {
  return value.type == ValueType::Int ? static_cast<int>(value.integer)
                                      : detail::convertedToInt(value);
}
template <>
inline std::optional<double> valueAs(const Value& value) {
  return value.type == ValueType::Double ? value.real : detail::convertedToDouble(value);
}
template <>
std::optional<std::int64_t> valueAs(const Value& value);  // of Unsigned
template <>
std::optional<bool> valueAs(const Value& value);
template <>
std::optional<std::string_view> valueAs(const Value& value);
template <>
std::optional<base::NodeStatus> valueAs(const Value& value);

/// `value` as an entry of type `type` takes it, or nothing.
std::optional<Value> convertTo(const Value& value, PortType type);

/// One entry of the blackboard. `type` is fixed by its first typed use; Any = not yet fixed.
struct Slot {
  Value value;
  PortType type = PortType::Any;
  bool exists = false;        // created at load or written since
  std::uint32_t version = 0;  // counts the writes
};
/// False = the value does not fit the type of the entry; nothing is written then.
bool store(Slot& slot, const Value& value);
bool store(Slot& slot, double value);  // the two that are written in every step; no allocation
bool store(Slot& slot, int value);

/// Where a port takes its value. Eight bytes, as ports are most of what a tick reads.
struct PortBinding {
  enum class Kind : std::uint8_t { Missing, Constant, Entry };
  std::uint32_t offset = 0;  // [bytes] in its column; of what is missing: constant 0, unset
  Kind kind = Kind::Missing;
  bool isDefault = false;  // the constant is the default of the manifest
  PortType type = PortType::Any;
};
static_assert(sizeof(PortBinding) == 8);
constexpr std::uint32_t offsetOf(std::size_t index) {
  return static_cast<std::uint32_t>(index * sizeof(Slot));
}
/// `column`: the constants of the program or the entries of a tree, as the binding's kind says.
inline const Slot& boundSlot(const Slot* column, const PortBinding& binding) {
  return *reinterpret_cast<const Slot*>(reinterpret_cast<const std::byte*>(column) +
                                        binding.offset);
}
inline Slot& boundSlot(Slot* column, const PortBinding& binding) {
  return *reinterpret_cast<Slot*>(reinterpret_cast<std::byte*>(column) + binding.offset);
}

}  // namespace bt
