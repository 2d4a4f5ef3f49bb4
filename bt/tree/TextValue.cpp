#include "bt/tree/TextValue.h"

#include <limits>

#include "sim2d/base/Text.h"

namespace bt {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t digitsFrom(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && isDigit(text[end])) {
    ++end;
  }
  return end - at;
}

/// The whole number that the text begins with; nothing when it begins with something else.
std::optional<long long> leadingInt(std::string_view text) {
  const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
  const std::size_t digits = digitsFrom(text, sign);
  return digits == 0 ? std::nullopt : base::parseInt(text.substr(0, sign + digits));
}

/// Length of the number that the text begins with, 0 = none.
std::size_t lengthOfReal(std::string_view text) {
  std::size_t end = !text.empty() && text[0] == '-' ? 1 : 0;
  const std::size_t whole = digitsFrom(text, end);
  end += whole;
  std::size_t decimals = 0;
  if (end < text.size() && text[end] == '.') {
    decimals = digitsFrom(text, end + 1);
    end += decimals + (whole + decimals > 0 ? 1 : 0);
  }
  if (whole + decimals == 0) {
    return 0;
  }
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t first = end + (sign ? 2 : 1);
    const std::size_t exponent = digitsFrom(text, first);
    end = exponent > 0 ? first + exponent : end;
  }
  return end;
}

}  // namespace

std::optional<int> intFromText(std::string_view text) {
  const std::optional<long long> value = leadingInt(text);
  if (!value || *value < std::numeric_limits<int>::min() ||
      *value > std::numeric_limits<int>::max()) {
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<std::int64_t> unsignedFromText(std::string_view text) {
  const std::optional<long long> value = leadingInt(text);
  if (!value || text[0] == '-' || *value > std::numeric_limits<std::uint32_t>::max()) {
    return std::nullopt;
  }
  return *value;
}

std::optional<double> doubleFromText(std::string_view text) {
  const std::size_t length = lengthOfReal(text);
  if (length == 0) {
    const bool infinite = text == "inf" || text == "-inf";
    return infinite ? base::parseDouble(text) : std::nullopt;
  }
  return base::parseDouble(text.substr(0, length));
}

std::optional<bool> boolFromText(std::string_view text) {
  if (text == "1" || text == "true" || text == "TRUE" || text == "True") {
    return true;
  }
  if (text == "0" || text == "false" || text == "FALSE" || text == "False") {
    return false;
  }
  return std::nullopt;
}

std::optional<base::NodeStatus> statusFromText(std::string_view text) {
  using base::NodeStatus;
  for (const NodeStatus status : {NodeStatus::Idle, NodeStatus::Running, NodeStatus::Success,
                                  NodeStatus::Failure, NodeStatus::Skipped}) {
    if (text == base::nodeStatusName(status)) {
      return status;
    }
  }
  return std::nullopt;
}

std::optional<double> cutNumber(std::string_view text, PortType type) {
  std::optional<double> read;
  if (type == PortType::Double) {
    read = doubleFromText(text);
  } else if (type == PortType::Int || type == PortType::Unsigned) {
    const std::optional<long long> whole = leadingInt(text);
    read = whole ? std::optional<double>(static_cast<double>(*whole)) : std::nullopt;
  }
  return read && read != base::parseDouble(text) ? read : std::nullopt;
}

bool isConvertible(std::string_view text, PortType type) {
  switch (type) {
    case PortType::Int:
      return intFromText(text).has_value();
    case PortType::Unsigned:
      return unsignedFromText(text).has_value();
    case PortType::Double:
      return doubleFromText(text).has_value();
    case PortType::Bool:
      return boolFromText(text).has_value();
    case PortType::Status:
      return statusFromText(text).has_value();
    case PortType::String:
    case PortType::Queue:
    case PortType::Any:
      return true;
  }
  return false;
}

}  // namespace bt
