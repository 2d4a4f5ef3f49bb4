#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Types.h"

/// Values of blackboard entries and ports.
namespace bt {

enum class ValueType : std::uint8_t { Unset, Int, Double, Bool, String };

struct Value {
  ValueType type = ValueType::Unset;
  union {
    std::int64_t integer = 0;  // Int, Bool
    double real;               // Double
  };
  std::string text;  // String; also of a number in an entry for text, otherwise empty then

  static Value of(int value) { return of(static_cast<std::int64_t>(value)); }
  static Value of(std::int64_t value);
  static Value of(double value);
  static Value of(bool value);
  static Value of(std::string_view value);
  bool isNumber() const { return type != ValueType::Unset && type != ValueType::String; }
  double number() const { return type == ValueType::Double ? real : static_cast<double>(integer); }
  std::string toText() const;  // for lists; "" when unset
};
bool operator==(const Value& a, const Value& b);

/// Reads with the conversions that ports allow: text is parsed, a real becomes a whole number only
/// when it is one, a number becomes a bool only when it is 0 or 1. Nothing = does not fit.
namespace detail {
std::optional<int> convertedToInt(const Value& value);
std::optional<double> convertedToDouble(const Value& value);
}  // namespace detail
inline std::optional<int> toInt(const Value& value) {
  return value.type == ValueType::Int && value.integer == static_cast<int>(value.integer)
             ? static_cast<int>(value.integer)
             : detail::convertedToInt(value);
}
inline std::optional<double> toDouble(const Value& value) {
  return value.type == ValueType::Double ? value.real : detail::convertedToDouble(value);
}
std::optional<std::int64_t> toUnsigned(const Value& value);
std::optional<bool> toBool(const Value& value);
std::optional<std::string_view> toStringView(const Value& value);
std::optional<base::NodeStatus> toStatus(const Value& value);

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

/// Where a port takes its value.
struct PortBinding {
  enum class Kind : std::uint8_t { Missing, Constant, Entry };
  Kind kind = Kind::Missing;
  bool isDefault = false;  // the constant is the default of the manifest
  PortType type = PortType::Any;
  std::int32_t index = -1;  // of the constant or the slot
};

}  // namespace bt
