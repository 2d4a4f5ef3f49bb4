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
  const std::optional<std::int64_t> whole =
      value.isNumber() ? wholeNumber(value, 0.0, 1.0) : std::nullopt;
  return whole ? std::optional<bool>(*whole == 1) : std::nullopt;
}

template <>
std::optional<std::string_view> valueAs(const Value& value) {
  const bool hasText =
      value.type == ValueType::String || (value.type != ValueType::Unset && !value.text.empty());
  return hasText ? std::optional<std::string_view>(value.text) : std::nullopt;
}

template <>
std::optional<base::NodeStatus> valueAs(const Value& value) {
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
      return wrapped(valueAs<int>(value));
    case PortType::Unsigned:
      return wrapped(valueAs<std::int64_t>(value));
    case PortType::Double:
      return wrapped(valueAs<double>(value));
    case PortType::Bool:
      return wrapped(valueAs<bool>(value));
    case PortType::Status:
      return valueAs<base::NodeStatus>(value) ? std::optional<Value>(value) : std::nullopt;
    case PortType::String:
    case PortType::Queue:
      return withText(value);
  }
  return std::nullopt;
}

bool store(Slot& slot, const Value& value) {
  std::optional<Value> converted = convertTo(value, slot.type);
  if (!converted) {
    return false;
  }
  slot.value = *std::move(converted);
  slot.exists = true;
  ++slot.version;
  return true;
}

namespace {

/// A number was written in place.
bool noteWrite(Slot& slot, ValueType type) {
  slot.value.type = type;
  slot.value.text.clear();
  slot.exists = true;
  ++slot.version;
  return true;
}

}  // namespace

bool store(Slot& slot, double value) {
  if (slot.type != PortType::Double && slot.type != PortType::Any) {
    return store(slot, Value::of(value));
  }
  slot.value.real = value;
  return noteWrite(slot, ValueType::Double);
}

bool store(Slot& slot, int value) {
  if (slot.type != PortType::Int && slot.type != PortType::Any) {
    return store(slot, Value::of(value));
  }
  slot.value.integer = value;
  return noteWrite(slot, ValueType::Int);
}

}  // namespace bt
