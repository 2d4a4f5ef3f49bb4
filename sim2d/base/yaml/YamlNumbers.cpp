#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlMap.h"

namespace base {
namespace {

std::string limitsText(const Range& range) {
  const std::string low = formatDouble(range.low);
  if (range.above && !std::isinf(range.high)) {
    return "must be above " + low + " and at most " + formatDouble(range.high);
  }
  if (!std::isinf(range.low) && !std::isinf(range.high)) {
    return "must be from " + low + " to " + formatDouble(range.high);
  }
  if (!std::isinf(range.high)) {
    return "must be at most " + formatDouble(range.high);
  }
  return (range.above ? "must be above " : "must be at least ") + low;
}

/// Integers in the way of ROS 2's parser (C's strtol with base 0): a leading 0 means octal, 0x
/// hexadecimal.
std::optional<long long> prefixedInteger(const std::string& text) {
  const bool negative = text[0] == '-';
  const std::size_t start = negative || text[0] == '+' ? 1 : 0;
  if (text.size() < start + 2 || text[start] != '0') {
    return std::nullopt;
  }
  const bool hex = text[start + 1] == 'x' || text[start + 1] == 'X';
  const std::string digits = lowered(text.substr(start + (hex ? 2 : 1)));
  static constexpr std::string_view kDigits = "0123456789abcdef";
  const std::size_t base = hex ? 16 : 8;
  if (digits.empty() || digits.size() > 15) {
    return std::nullopt;
  }
  long long value = 0;
  for (const char c : digits) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos || digit >= base) {
      return std::nullopt;
    }
    value = value * static_cast<long long>(base) + static_cast<long long>(digit);
  }
  return negative ? -value : value;
}

struct NumberText {
  std::optional<long long> integer;
  std::optional<double> number;
};

NumberText parseNumber(const YamlNode& node, const ValueContext& context, ReadReport& report) {
  NumberText result;
  if (!node.isScalar() || node.text.empty()) {
    return result;
  }
  result.integer = prefixedInteger(node.text);
  if (result.integer) {
    report.warning(node,
                   context.path + ": " + node.text + " is read as " +
                       std::to_string(*result.integer) + ", as ROS 2 does (a leading 0 is octal)",
                   context.entity);
    result.number = static_cast<double>(*result.integer);
    return result;
  }
  result.integer = parseInt(node.text);
  result.number = parseDouble(node.text);
  if (node.quoted && result.number) {
    report.warning(node, context.path + ": a number in quotes, ROS 2 takes it for a string",
                   context.entity);
  }
  return result;
}

}  // namespace

std::optional<double> readNumber(const YamlNode& node, const ValueContext& context, Range range,
                                 ReadReport& report) {
  const NumberText parsed = parseNumber(node, context, report);
  if (!parsed.number) {
    report.error(node, context.path + ": " + described(node) + " is not a number", context.entity);
    return std::nullopt;
  }
  const double value = *parsed.number;
  if (!std::isfinite(value)) {
    report.error(node, context.path + ": " + node.text + " is not a finite number", context.entity);
    return std::nullopt;
  }
  if (!range.contains(value)) {
    report.error(node, context.path + ": " + node.text + " " + limitsText(range), context.entity);
    return std::nullopt;
  }
  return value;
}

std::optional<long long> readInteger(const YamlNode& node, const ValueContext& context,
                                     ReadReport& report) {
  const NumberText parsed = parseNumber(node, context, report);
  if (parsed.integer) {
    return parsed.integer;
  }
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (parsed.number && std::fabs(*parsed.number) < kExact &&
      std::floor(*parsed.number) == *parsed.number) {
    report.warning(node,
                   context.path + ": " + node.text + " is written as a double, ROS 2 wants " +
                       "an integer here",
                   context.entity);
    return static_cast<long long>(*parsed.number);
  }
  report.error(node, context.path + ": " + described(node) + " is not an integer", context.entity);
  return std::nullopt;
}

}  // namespace base
