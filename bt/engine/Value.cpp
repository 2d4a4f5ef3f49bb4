#include "bt/engine/Value.h"

#include <cmath>
#include <limits>
#include <utility>

#include "bt/tree/TextValue.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

/// A whole number within the limits, or nothing.
std::optional<std::int64_t> wholeNumber(const Value& value, double lowest, double highest) {
  const double number = value.number();
  if (!(number >= lowest && number <= highest) || number != std::floor(number)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(number);
}

/// A number in an entry for text stays a number, for scripts, and carries its text as well.
Value withText(const Value& value) {
  Value result = value;
  if (value.isNumber()) {
    result.text = value.toText();
  }
  return result;
}

template <class T>
std::optional<Value> wrapped(const std::optional<T>& value) {
  return value ? std::optional<Value>(Value::of(*value)) : std::nullopt;
}

}  // namespace

Value Value::of(std::int64_t value) {
  Value result;
  result.type = value == static_cast<int>(value) ? ValueType::Int : ValueType::Long;
  result.integer = value;
  return result;
}

Value Value::of(double value) {
  Value result;
  result.type = ValueType::Double;
  result.real = value;
  return result;
}

Value Value::of(bool value) {
  Value result;
  result.type = ValueType::Bool;
  result.integer = value ? 1 : 0;
  return result;
}

Value Value::of(std::string_view value) {
  Value result;
  result.type = ValueType::String;
  result.text = value;
  return result;
}

std::string Value::toText() const {
  switch (type) {
    case ValueType::Unset:
      return {};
    case ValueType::Int:
    case ValueType::Long:
      return std::to_string(integer);
    case ValueType::Double:
      return base::formatDouble(real);
    case ValueType::Bool:
      return integer != 0 ? "true" : "false";
    case ValueType::String:
      return text;
  }
  return {};
}

bool operator==(const Value& a, const Value& b) {
  if (a.type != b.type || a.type == ValueType::Unset) {
    return a.type == b.type;
  }
  if (a.type == ValueType::String) {
    return a.text == b.text;
  }
  return a.type == ValueType::Double ? a.real == b.real : a.integer == b.integer;
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

std::optional<std::int64_t> toUnsigned(const Value& value) {
  if (value.type == ValueType::String) {
    return unsignedFromText(value.text);
  }
  return value.isNumber() ? wholeNumber(value, 0.0, std::numeric_limits<std::uint32_t>::max())
                          : std::nullopt;
}

std::optional<bool> toBool(const Value& value) {
  if (value.type == ValueType::String) {
    return boolFromText(value.text);
  }
  const std::optional<std::int64_t> whole =
      value.isNumber() ? wholeNumber(value, 0.0, 1.0) : std::nullopt;
  return whole ? std::optional<bool>(*whole == 1) : std::nullopt;
}

std::optional<std::string_view> toStringView(const Value& value) {
  const bool hasText =
      value.type == ValueType::String || (value.type != ValueType::Unset && !value.text.empty());
  return hasText ? std::optional<std::string_view>(value.text) : std::nullopt;
}

std::optional<base::NodeStatus> toStatus(const Value& value) {
  return value.type == ValueType::String ? statusFromText(value.text) : std::nullopt;
}

std::optional<Value> convertTo(const Value& value, PortType type) {
  if (value.type == ValueType::Unset) {
    return std::nullopt;
  }
  switch (type) {
    case PortType::Any:
      return value;
    case PortType::Int:
      return wrapped(toInt(value));
    case PortType::Unsigned:
      return wrapped(toUnsigned(value));
    case PortType::Double:
      return wrapped(toDouble(value));
    case PortType::Bool:
      return wrapped(toBool(value));
    case PortType::Status:
      return toStatus(value) ? std::optional<Value>(value) : std::nullopt;
    case PortType::String:
    case PortType::Queue:
      return withText(value);
  }
  return std::nullopt;
}

namespace {

bool noteWrite(Slot& slot) {
  slot.exists = true;
  ++slot.version;
  return true;
}

}  // namespace

bool store(Slot& slot, const Value& value) {
  std::optional<Value> converted = convertTo(value, slot.type);
  if (!converted) {
    return false;
  }
  slot.value = *std::move(converted);
  return noteWrite(slot);
}

bool store(Slot& slot, double value) {
  if (slot.type != PortType::Double && slot.type != PortType::Any) {
    return store(slot, Value::of(value));
  }
  slot.value.type = ValueType::Double;
  slot.value.real = value;
  slot.value.text.clear();
  return noteWrite(slot);
}

bool store(Slot& slot, int value) {
  if (slot.type != PortType::Int && slot.type != PortType::Any) {
    return store(slot, Value::of(value));
  }
  slot.value.type = ValueType::Int;
  slot.value.integer = value;
  slot.value.text.clear();
  return noteWrite(slot);
}

}  // namespace bt
