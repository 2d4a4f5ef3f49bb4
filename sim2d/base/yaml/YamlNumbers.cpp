#include <cmath>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlMap.h"

namespace base {
namespace {

Diagnostic outOfRange(const std::string& found, const Range& range) {
  const bool isBounded = !std::isinf(range.high);
  if (isBounded && range.above) {
    return error("yaml.out-of-half-open-range", {found, range.low, range.high});
  }
  if (isBounded) {
    return std::isinf(range.low) ? error("yaml.too-high", {found, range.high})
                                 : error("yaml.out-of-range", {found, range.low, range.high});
  }
  return error(range.above ? "yaml.not-above" : "yaml.too-low", {found, range.low});
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

void tell(const YamlNode& node, const ValueContext& context, Diagnostic problem,
          ReadReport& report) {
  report.add(node, within(context.path, std::move(problem)), context.entity);
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
    tell(node, context, warning("yaml.octal", {node.text, *result.integer}), report);
    result.number = static_cast<double>(*result.integer);
    return result;
  }
  result.integer = parseInt(node.text);
  result.number = parseDouble(node.text);
  if (node.quoted && result.number) {
    tell(node, context, warning("yaml.quoted-number"), report);
  }
  return result;
}

}  // namespace

std::optional<double> readNumber(const YamlNode& node, const ValueContext& context, Range range,
                                 ReadReport& report) {
  const NumberText parsed = parseNumber(node, context, report);
  if (!parsed.number) {
    tell(node, context, error("yaml.not-number", {described(node)}), report);
    return std::nullopt;
  }
  const double value = *parsed.number;
  if (!std::isfinite(value)) {
    tell(node, context, error("yaml.not-finite", {node.text}), report);
    return std::nullopt;
  }
  if (!range.contains(value)) {
    tell(node, context, outOfRange(node.text, range), report);
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
    tell(node, context, warning("yaml.double-for-integer", {node.text}), report);
    return static_cast<long long>(*parsed.number);
  }
  tell(node, context, error("yaml.not-integer", {described(node)}), report);
  return std::nullopt;
}

}  // namespace base
