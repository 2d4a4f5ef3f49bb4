#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Types.h"

/// Values of blackboard entries and ports, with the types and conversions of BT::Any and
/// BT::Blackboard of BehaviorTree.CPP 4.10.
namespace bt {

/// The type with which a value was made. Long: a whole number written in a script (int64_t), which
/// no port has. List: the remaining elements of a queue.
enum class ValueType : std::uint8_t { Unset, Int, Long, Unsigned, Bool, Double, String, List };

struct Value {
  ValueType type = ValueType::Unset;
  PortType element = PortType::Any;  // of a List
  union {
    std::int64_t integer = 0;  // whole numbers and Bool; number of remaining elements of a List
    double real;               // Double
  };
  mutable std::string text;  // String; elements with ';' between; of a number its text, once asked

  Value() = default;
  Value(ValueType itsType, std::int64_t whole, std::string_view itsText = {})
      : type(itsType), integer(whole), text(itsText) {}
  static Value of(int value) { return {ValueType::Int, value}; }
  static Value of(std::int64_t value) { return {ValueType::Long, value}; }
  static Value of(bool value) { return {ValueType::Bool, value ? 1 : 0}; }
  static Value of(double value) {
    Value result(ValueType::Double, 0);
    result.real = value;
    return result;
  }
  static Value of(std::string_view value) { return {ValueType::String, 0, value}; }
  bool isWhole() const { return type >= ValueType::Int && type <= ValueType::Bool; }
  bool isNumber() const { return type >= ValueType::Int && type <= ValueType::Double; }
  double number() const { return type == ValueType::Double ? real : static_cast<double>(integer); }
  std::string toText() const;  // for display: "0.5", "true"; "" when unset
};
/// The text that string ports and '..' see: "0.500000" for a real, "1" for true.
std::string engineText(const Value& value);
/// Copies without touching the text of numbers.
void copyValue(Value& to, const Value& from);

/// Reads with the conversions that ports allow: text is parsed, a real becomes a whole number only
/// when it is one, a whole number becomes a bool only when it is 0 or 1 (a real always), a number
/// becomes text. Nothing = does not fit.
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

/// `value` as a port of this type reads it, or nothing. `element`: element type of a queue.
std::optional<Value> convertTo(const Value& value, PortType type, PortType element = PortType::Any);

/// One entry of the blackboard. `type` is the type that the first port or typed value declared;
/// later values must fit it or the present value, see below.
struct Slot {
  Value value;
  PortType type = PortType::Any;     // Any: not declared yet
  PortType element = PortType::Any;  // of a Queue
  bool exists = false;               // created at load or written since
  bool isObject = false;             // declared as BT::Any: its first value is not text of a script
  std::uint32_t version = 0;         // counts the writes
};

/// Blackboard::set<T> of a value of type T: a leaf writes to an output port, or the host to an
/// entry. False = the value does not fit the type of the entry; nothing is written then.
bool store(Slot& slot, const Value& value);
bool store(Slot& slot, double value);  // the two that are written in every step; no allocation
bool store(Slot& slot, int value);
/// Any::copyInto: the present value keeps its type. False = the new value does not fit.
bool copyInto(Value& to, const Value& from);
/// The assignment of a script. `number`: the number in a text; nothing = the text is not a number.
bool assign(Slot& slot, const Value& value, const std::optional<double>& number);
/// Blackboard::set<Any>, as SetBlackboard does: the type must be that of the entry.
bool storeAny(Slot& slot, const Value& value);
/// As if the entry had never existed.
void remove(Slot& slot);

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
