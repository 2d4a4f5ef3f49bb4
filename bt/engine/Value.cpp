#include "bt/engine/Value.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

constexpr double kLargestLong = 9.2e18;  // larger reals do not fit into int64_t

/// An integer within the limits, or empty.
std::optional<std::int64_t> wholeNumber(const Value& value, double lowest, double highest) {
  const double number = value.number();
  if (!(number >= lowest && number <= highest) || number != std::floor(number)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(number);
}

template <class T>
std::optional<Value> wrapped(const std::optional<T>& value) {
  return value ? std::optional<Value>(Value::of(*value)) : std::nullopt;
}

}  // namespace

std::string Value::toText() const {
  switch (type) {
    case ValueType::Unset:
      return {};
    case ValueType::Int:
    case ValueType::Long:
    case ValueType::Unsigned:
      return std::to_string(integer);
    case ValueType::Double:
      return base::formatDouble(real);
    case ValueType::Bool:
      return integer != 0 ? "true" : "false";
    case ValueType::String:
    case ValueType::List:
      return text;
  }
  return {};
}

std::string portText(const Value& value) {
  if (value.isWhole()) {
    return std::to_string(value.integer);
  }
  if (value.type != ValueType::Double) {
    return value.toText();
  }
  constexpr int kDigits = 6;          // like std::to_string, independent of the locale
  std::array<char, 400> buffer = {};  // the largest double has 309 digits before the point
  const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                                 value.real, std::chars_format::fixed, kDigits);
  return {buffer.data(), end.ptr};
}

void copyValue(Value& to, const Value& from) {
  to.type = from.type;
  to.element = from.element;
  to.integer = from.integer;  // also copies the bits of a real
  if (from.isNumber()) {
    to.text.clear();
  } else {
    to.text = from.text;
  }
}

namespace detail {

std::optional<int> convertedToInt(const Value& value) {
  if (value.type == ValueType::String) {
    return intFromText(value.text);
  }
  if (!value.isNumber()) {
    return std::nullopt;
  }
  const std::optional<std::int64_t> whole =
      wholeNumber(value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  return whole ? std::optional<int>(static_cast<int>(*whole)) : std::nullopt;
}

std::optional<double> convertedToDouble(const Value& value) {
  if (value.type == ValueType::String) {
    return doubleFromText(value.text);
  }
  return value.isNumber() ? std::optional<double>(value.number()) : std::nullopt;
}

}  // namespace detail

template <>
std::optional<std::int64_t> valueAs(const Value& value) {
  if (value.type == ValueType::String) {
    return unsignedFromText(value.text);
  }
  return value.isNumber() ? wholeNumber(value, 0.0, std::numeric_limits<std::uint32_t>::max())
                          : std::nullopt;
}

template <>
std::optional<bool> valueAs(const Value& value) {
  if (value.type == ValueType::String) {
    return boolFromText(value.text);
  }
  if (value.type == ValueType::Double) {
    return value.real != 0.0;
  }
  const bool isOne = value.isWhole() && (value.integer == 0 || value.integer == 1);
  return isOne ? std::optional<bool>(value.integer == 1) : std::nullopt;
}

template <>
std::optional<std::string_view> valueAs(const Value& value) {
  if (value.type == ValueType::Unset || value.type == ValueType::List) {
    return std::nullopt;
  }
  if (value.isNumber() && value.text.empty()) {
    value.text = portText(value);
  }
  return value.text;
}

template <>
std::optional<base::NodeStatus> valueAs(const Value& value) {
  constexpr int kStatuses = 5;
  if (value.isNumber()) {
    const std::optional<int> number = detail::convertedToInt(value);
    const bool isOne = number && *number >= 0 && *number < kStatuses;
    return isOne ? std::optional(static_cast<base::NodeStatus>(*number)) : std::nullopt;
  }
  return value.type == ValueType::String ? statusFromText(value.text) : std::nullopt;
}

namespace {

/// Text as a queue. Empty: an element does not have that type.
std::optional<Value> queueFromText(const Value& text, PortType element) {
  if (text.type != ValueType::String) {
    return std::nullopt;
  }
  Value list(ValueType::List, 0, text.text);
  list.element = element;
  for (const std::string& part : splitQueue(text.text)) {
    if (!isConvertible(part, element)) {
      return std::nullopt;
    }
    ++list.integer;
  }
  return list;
}

/// The type that a value of this type declares for an entry.
PortType declaredType(const Value& value) {
  switch (value.type) {
    case ValueType::Int:
      return PortType::Int;
    case ValueType::Unsigned:
      return PortType::Unsigned;
    case ValueType::Bool:
      return PortType::Bool;
    case ValueType::Double:
      return PortType::Double;
    case ValueType::String:
      return PortType::String;
    case ValueType::List:
      return PortType::Queue;
    case ValueType::Long:  // no port has it, so it fits no declared entry
    case ValueType::Unset:
      break;
  }
  return PortType::Any;
}

bool isDeclaredAs(const Slot& slot, const Value& value) {
  return declaredType(value) == slot.type &&
         (slot.type != PortType::Queue || slot.element == value.element);
}

bool noteWrite(Slot& slot) {
  slot.exists = true;
  ++slot.version;
  return true;
}

void declare(Slot& slot, const Value& value) {
  slot.type = declaredType(value);
  slot.element = value.element;
  slot.isObject = false;
}

/// A number may be written to an entry of another numeric type if it fits.
bool isSafe(const Value& value, PortType type) {
  switch (type) {
    case PortType::Int:
      return detail::convertedToInt(value).has_value();
    case PortType::Unsigned:
      return valueAs<std::int64_t>(value).has_value();
    case PortType::Double:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::optional<Value> convertTo(const Value& value, PortType type, PortType element) {
  if (value.type == ValueType::Unset) {
    return std::nullopt;
  }
  switch (type) {
    case PortType::Any:
      return value;
    case PortType::Int:
      return wrapped(valueAs<int>(value));
    case PortType::Unsigned:
      if (const std::optional<std::int64_t> number = valueAs<std::int64_t>(value)) {
        return Value(ValueType::Unsigned, *number);
      }
      return std::nullopt;
    case PortType::Double:
      return wrapped(valueAs<double>(value));
    case PortType::Bool:
      return wrapped(valueAs<bool>(value));
    case PortType::Status:
      return valueAs<base::NodeStatus>(value) ? std::optional<Value>(value) : std::nullopt;
    case PortType::String:
      return value.type == ValueType::List
                 ? std::nullopt
                 : std::optional(Value::of(std::string_view(*valueAs<std::string_view>(value))));
    case PortType::Queue:
      return value.type == ValueType::List ? std::optional(value) : queueFromText(value, element);
  }
  return std::nullopt;
}

bool copyInto(Value& to, const Value& from) {
  if (to.type == ValueType::Unset) {
    copyValue(to, from);
    return true;
  }
  if (to.isNumber() && from.isNumber()) {
    if (to.type == ValueType::Double) {
      to.real = from.number();
    } else if (from.isWhole()) {
      to.integer = from.integer;
    } else {
      const std::optional<std::int64_t> whole = wholeNumber(from, -kLargestLong, kLargestLong);
      if (!whole) {
        return false;
      }
      to.integer = *whole;
    }
    const bool isLarge = to.type == ValueType::Int && to.integer != static_cast<int>(to.integer);
    to.type = isLarge ? ValueType::Long : to.type;
    to.text.clear();
    return true;
  }
  if (to.type != from.type || (to.type == ValueType::List && to.element != from.element)) {
    return false;
  }
  copyValue(to, from);
  return true;
}

bool assign(Slot& slot, const Value& value, const std::optional<double>& number) {
  const bool isEmpty = slot.value.type == ValueType::Unset;
  const bool isDeclared = slot.type != PortType::Any || slot.isObject;
  if (value.type == ValueType::String && slot.value.type != ValueType::String &&
      (isDeclared || !isEmpty)) {
    // Only text is converted: to the declared type, otherwise to a number.
    const bool hasConverter = slot.type != PortType::Any && slot.type != PortType::Status;
    if (hasConverter) {
      const std::optional<Value> converted = convertTo(value, slot.type, slot.element);
      if (!converted) {
        return false;
      }
      copyValue(slot.value, *converted);
    } else if (!slot.value.isNumber() || !number) {
      return false;
    } else {
      copyValue(slot.value, Value::of(*number));
    }
    return noteWrite(slot);
  }
  return copyInto(slot.value, value) && noteWrite(slot);
}

bool storeAny(Slot& slot, const Value& value) {
  if (!slot.exists) {
    declare(slot, value);
  } else if (slot.type == PortType::Any) {
    slot.isObject = true;
  } else if (!isDeclaredAs(slot, value)) {
    return false;
  }
  copyValue(slot.value, value);
  return noteWrite(slot);
}

void remove(Slot& slot) {
  slot = Slot();
}

bool store(Slot& slot, const Value& value) {
  if (!slot.exists || slot.type == PortType::Any) {
    const bool wasThere = slot.exists;
    declare(slot, value);
    if (!wasThere && value.type == ValueType::String) {
      slot.type = PortType::Any;  // text that creates an entry declares no type
    }
    copyValue(slot.value, value);
    return noteWrite(slot);
  }
  if (isDeclaredAs(slot, value)) {
    return copyInto(slot.value, value) && noteWrite(slot);
  }
  if (value.type == ValueType::String) {
    const std::optional<Value> converted = convertTo(value, slot.type, slot.element);
    return converted && copyInto(slot.value, *converted) && noteWrite(slot);
  }
  return value.isNumber() && isSafe(value, slot.type) && copyInto(slot.value, value) &&
         noteWrite(slot);
}

bool store(Slot& slot, double value) {
  if (slot.type != PortType::Double || slot.value.type != ValueType::Double) {
    return store(slot, Value::of(value));
  }
  slot.value.real = value;
  slot.value.text.clear();
  return noteWrite(slot);
}

bool store(Slot& slot, int value) {
  if (slot.type != PortType::Int || slot.value.type != ValueType::Int) {
    return store(slot, Value::of(value));
  }
  slot.value.integer = value;
  slot.value.text.clear();
  return noteWrite(slot);
}

}  // namespace bt
