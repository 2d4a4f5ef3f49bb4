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

/// The type with which a value was created. Long: an integer written in a script (int64_t); no port
/// has this type. List: the remaining elements of a queue.
enum class ValueType : std::uint8_t { Unset, Int, Long, Unsigned, Bool, Double, String, List };

struct Value {
  ValueType type = ValueType::Unset;
  PortType element = PortType::Any;  // for List
  union {
    std::int64_t integer = 0;  // integers and Bool; number of remaining elements of a List
    double real;               // Double
  };
  mutable std::string text;  // String; elements separated by ';'; cached text of a number

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
/// The text for string ports and '..': "0.500000" for a real, "1" for true.
std::string portText(const Value& value);
/// Copies without the cached text of numbers.
void copyValue(Value& to, const Value& from);

/// Reads a value with the conversions that ports allow: text is parsed; a real becomes an integer
/// only if it is integral; an integer becomes a bool only if it is 0 or 1 (a real always); a number
/// becomes text. Empty: does not fit.
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
std::optional<std::int64_t> valueAs(const Value& value);  // for Unsigned
template <>
std::optional<bool> valueAs(const Value& value);
template <>
std::optional<std::string_view> valueAs(const Value& value);
template <>
std::optional<base::NodeStatus> valueAs(const Value& value);

/// `value` as read by a port of this type, or empty. `element`: element type of a queue.
std::optional<Value> convertTo(const Value& value, PortType type, PortType element = PortType::Any);

/// One entry of the blackboard. `type` is declared by the first port or typed value; later values
/// must fit it or the current value, see below.
struct Slot {
  Value value;
  PortType type = PortType::Any;     // Any: not declared yet
  PortType element = PortType::Any;  // for Queue
  bool exists = false;               // created at load or written since
  bool isObject = false;             // declared as BT::Any: first value is not text from a script
  std::uint32_t version = 0;         // counts the writes
};

/// Blackboard::set<T> with a value of type T: a leaf writes to an output port, or the host to an
/// entry. Returns false, without writing, if the value does not fit the type of the entry.
bool store(Slot& slot, const Value& value);
bool store(Slot& slot, double value);  // overloads for writes in every step, without allocation
bool store(Slot& slot, int value);
/// Any::copyInto: the current value keeps its type. Returns false if the new value does not fit.
bool copyInto(Value& to, const Value& from);
/// Assignment in a script. `number` is the number in a text value; empty: not a number.
bool assign(Slot& slot, const Value& value, const std::optional<double>& number);
/// Blackboard::set<Any>, as in SetBlackboard: the type must be that of the entry.
bool storeAny(Slot& slot, const Value& value);
/// Removes the entry as if it had never existed.
void remove(Slot& slot);

/// The source of a port's value. Eight bytes, since ports dominate the memory traffic of a tick.
struct PortBinding {
  enum class Kind : std::uint8_t { Missing, Constant, Entry };
  std::uint32_t offset = 0;  // [bytes] in its column; Missing: constant 0, which is unset
  Kind kind = Kind::Missing;
  bool isDefault = false;  // the constant is the default of the manifest
  PortType type = PortType::Any;
};
static_assert(sizeof(PortBinding) == 8);
constexpr std::uint32_t offsetOf(std::size_t index) {
  return static_cast<std::uint32_t>(index * sizeof(Slot));
}
/// `column`: the constants of the program or the entries of a tree, according to binding.kind.
inline const Slot& boundSlot(const Slot* column, const PortBinding& binding) {
  return *reinterpret_cast<const Slot*>(reinterpret_cast<const std::byte*>(column) +
                                        binding.offset);
}
inline Slot& boundSlot(Slot* column, const PortBinding& binding) {
  return *reinterpret_cast<Slot*>(reinterpret_cast<std::byte*>(column) + binding.offset);
}

}  // namespace bt
