#include "sim2d/scenario/MapView.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

const YamlNode& emptyMap() {
  static const YamlNode kEmpty = [] {
    YamlNode node;
    node.kind = YamlNode::Kind::Map;
    return node;
  }();
  return kEmpty;
}

std::string described(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::Map:
      return "a map";
    case YamlNode::Kind::List:
      return "a list";
    case YamlNode::Kind::Null:
      return "empty";
    case YamlNode::Kind::Scalar:
      break;
  }
  return "'" + node.text + "'";
}

std::string limitsText(const Range& range) {
  const std::string low = base::formatDouble(range.low);
  if (range.above && !std::isinf(range.high)) {
    return "must be above " + low + " and at most " + base::formatDouble(range.high);
  }
  if (!std::isinf(range.low) && !std::isinf(range.high)) {
    return "must be from " + low + " to " + base::formatDouble(range.high);
  }
  if (!std::isinf(range.high)) {
    return "must be at most " + base::formatDouble(range.high);
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
  const std::string digits = base::lowered(text.substr(start + (hex ? 2 : 1)));
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
  result.integer = base::parseInt(node.text);
  result.number = base::parseDouble(node.text);
  if (node.quoted && result.number) {
    report.warning(node, context.path + ": a number in quotes, ROS 2 takes it for a string",
                   context.entity);
  }
  return result;
}

}  // namespace

void ReadReport::add(base::Severity severity, const YamlNode& at, const std::string& message,
                     EntityId entity) {
  diagnostics.push_back({severity, file, at.line, at.column, message, entity});
}

void ReadReport::error(const YamlNode& at, const std::string& message, EntityId entity) {
  add(base::Severity::Error, at, message, entity);
}

void ReadReport::warning(const YamlNode& at, const std::string& message, EntityId entity) {
  add(base::Severity::Warning, at, message, entity);
}

void ReadReport::info(const YamlNode& at, const std::string& message, EntityId entity) {
  add(base::Severity::Info, at, message, entity);
}

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
  if (value < range.low || value > range.high || (range.above && value == range.low)) {
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

MapView::MapView(const YamlNode* node, std::string path, EntityId entity, ReadReport& report)
    : node_(node != nullptr && node->isMap() ? node : &emptyMap()),
      path_(std::move(path)),
      entity_(entity),
      report_(report) {
  if (node != nullptr && !node->isMap() && !node->isNull()) {
    report.error(*node, path_ + ": must be a map, found " + described(*node), entity);
  }
}

std::string MapView::pathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void MapView::know(const std::string& key) {
  known_.insert(key);
  report_.knownPaths.insert(pathOf(key));
}

const YamlNode& MapView::place(const std::string& key) const {
  const YamlNode* found = node_->find(key);
  return found != nullptr ? *found : *node_;
}

const YamlNode* MapView::find(const std::string& key) {
  know(key);
  const YamlNode* found = node_->find(key);
  if (found != nullptr && found->isNull()) {
    report_.warning(*found, pathOf(key) + ": no value (taken as absent)", entity_);
    return nullptr;
  }
  return found;
}

MapView MapView::map(const std::string& key) {
  return {find(key), pathOf(key), entity_, report_};
}

std::optional<double> MapView::number(const std::string& key, Range range) {
  const YamlNode* found = find(key);
  return found == nullptr ? std::nullopt
                          : readNumber(*found, {pathOf(key), entity_}, range, report_);
}

std::optional<long long> MapView::bigInteger(const std::string& key, long long low) {
  const YamlNode* found = find(key);
  if (found == nullptr) {
    return std::nullopt;
  }
  const auto value = readInteger(*found, {pathOf(key), entity_}, report_);
  if (value && *value < low) {
    error(key, found->text + " must be at least " + std::to_string(low));
    return std::nullopt;
  }
  return value;
}

std::optional<int> MapView::integer(const std::string& key, long long low, long long high) {
  const YamlNode* found = find(key);
  if (found == nullptr) {
    return std::nullopt;
  }
  const auto value = readInteger(*found, {pathOf(key), entity_}, report_);
  if (!value) {
    return std::nullopt;
  }
  if (*value < low || *value > high) {
    error(key,
          found->text + " must be from " + std::to_string(low) + " to " + std::to_string(high));
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<bool> MapView::boolean(const std::string& key) {
  const YamlNode* found = find(key);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->isScalar()) {
    const std::string word = base::lowered(found->text);
    static const std::set<std::string> kTrue = {"true", "yes", "on", "y", "1"};
    static const std::set<std::string> kFalse = {"false", "no", "off", "n", "0"};
    if (kTrue.count(word) != 0) {
      return true;
    }
    if (kFalse.count(word) != 0) {
      return false;
    }
  }
  error(key, described(*found) + " is neither true nor false");
  return std::nullopt;
}

std::optional<std::string> MapView::text(const std::string& key) {
  const YamlNode* found = find(key);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (!found->isScalar()) {
    error(key, "must be a text, found " + described(*found));
    return std::nullopt;
  }
  return found->text;
}

const YamlNode* MapView::list(const std::string& key) {
  const YamlNode* found = find(key);
  if (found != nullptr && !found->isList()) {
    error(key, "must be a list, found " + described(*found));
    return nullptr;
  }
  return found;
}

std::vector<double> MapView::numbers(const std::string& key, Range range) {
  std::vector<double> values;
  if (const YamlNode* found = list(key)) {
    for (const YamlNode& item : found->items) {
      if (const auto value = readNumber(item, {pathOf(key), entity_}, range, report_)) {
        values.push_back(*value);
      }
    }
  }
  return values;
}

std::vector<int> MapView::integers(const std::string& key) {
  std::vector<int> values;
  if (const YamlNode* found = list(key)) {
    for (const YamlNode& item : found->items) {
      const auto value = readInteger(item, {pathOf(key), entity_}, report_);
      if (value && *value == static_cast<int>(*value)) {
        values.push_back(static_cast<int>(*value));
      } else if (value) {
        report_.error(item, pathOf(key) + ": " + item.text + " is too large", entity_);
      }
    }
  }
  return values;
}

std::vector<std::string> MapView::names(const std::string& key) {
  std::vector<std::string> values;
  std::set<std::string_view> seen;
  if (const YamlNode* found = list(key)) {
    for (const YamlNode& item : found->items) {
      if (!item.isScalar() || item.text.empty()) {
        report_.error(item, pathOf(key) + ": " + described(item) + " is not a name", entity_);
      } else if (!seen.insert(item.text).second) {
        report_.error(item, pathOf(key) + ": '" + item.text + "' is listed twice", entity_);
      } else {
        values.push_back(item.text);
      }
    }
  }
  return values;
}

std::optional<int> MapView::choice(const std::string& key, const std::vector<std::string>& words) {
  const auto word = text(key);
  if (!word) {
    return std::nullopt;
  }
  const auto found = std::find(words.begin(), words.end(), *word);
  if (found != words.end()) {
    return static_cast<int>(found - words.begin());
  }
  std::string all;
  for (const std::string& each : words) {
    all += (all.empty() ? "" : ", ") + each;
  }
  const auto near = base::nearestName(*word, words);
  error(key, "'" + *word + "' is unknown (" +
                 (near ? "did you mean '" + *near + "'? " : std::string()) + "one of " + all + ")");
  return std::nullopt;
}

bool MapView::demand(const std::string& key) {
  const YamlNode* found = node_->find(key);
  if (found != nullptr && !found->isNull()) {
    return true;
  }
  know(key);
  error(key, "is missing");
  return false;
}

double MapView::required(const std::string& key, Range range) {
  return demand(key) ? number(key, range).value_or(0.0) : 0.0;
}

std::optional<int> MapView::requiredChoice(const std::string& key,
                                           const std::vector<std::string>& words) {
  return demand(key) ? choice(key, words) : std::nullopt;
}

void MapView::error(const std::string& key, const std::string& message) {
  report_.error(place(key), pathOf(key) + ": " + message, entity_);
}

void MapView::warning(const std::string& key, const std::string& message) {
  report_.warning(place(key), pathOf(key) + ": " + message, entity_);
}

UnknownKey unknownKey(const YamlNode& value) {
  return {value.key, emitYaml(value)};
}

UnknownKeys MapView::takeUnknown() {
  UnknownKeys unknown;
  for (const YamlNode& item : node_->items) {
    if (isKnown(item.key)) {
      continue;
    }
    const auto near = base::nearestName(item.key, {known_.begin(), known_.end()});
    YamlNode at;
    at.line = item.keyLine;
    at.column = item.keyColumn;
    report_.warning(at,
                    "unknown key '" + item.key + "'" +
                        (path_.empty() ? std::string() : " in " + path_) +
                        (near ? " (did you mean '" + *near + "'?)" : " (kept)"),
                    entity_);
    unknown.push_back(unknownKey(item));
  }
  return unknown;
}

}  // namespace sim2d
