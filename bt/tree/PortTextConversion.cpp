#include "bt/tree/PortTextConversion.h"

#include <charconv>
#include <cmath>

#include "sim2d/base/Text.h"

namespace bt {
namespace {

/// The number at the start of the text; empty if there is none or if it is out of range.
template <class T>
std::optional<T> leadingNumber(std::string_view text) {
  T value{};
  const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), value);
  return end.ec == std::errc() ? std::optional<T>(value) : std::nullopt;
}

}  // namespace

std::optional<int> intFromText(std::string_view text) {
  return leadingNumber<int>(text);
}

std::optional<std::int64_t> unsignedFromText(std::string_view text) {
  const std::optional<std::uint32_t> value = leadingNumber<std::uint32_t>(text);
  return value ? std::optional<std::int64_t>(*value) : std::nullopt;
}

std::optional<double> doubleFromText(std::string_view text) {
  const std::optional<double> value = leadingNumber<double>(text);
  const bool isNumber = value && (std::isfinite(*value) || text == "inf" || text == "-inf");
  return isNumber ? value : std::nullopt;
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

std::vector<std::string> splitQueue(std::string_view list) {
  std::vector<std::string> elements = base::split(std::string(list), ';');
  if (!elements.empty() && elements.back().empty()) {
    elements.pop_back();
  }
  return elements;
}

std::optional<double> partiallyReadNumber(std::string_view text, PortType type) {
  std::optional<double> read;
  if (type == PortType::Double) {
    read = doubleFromText(text);
  } else if (type == PortType::Int || type == PortType::Unsigned) {
    const std::optional<long long> whole = leadingNumber<long long>(text);
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
