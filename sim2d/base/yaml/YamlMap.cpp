#include "sim2d/base/yaml/YamlMap.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "sim2d/base/Text.h"

namespace base {
namespace {

/// Integers with a prefix as in ROS 2's parser (strtol with base 0): 0 is octal, 0x hexadecimal.
std::optional<long long> prefixedInteger(const std::string& text) {
  const bool negative = text[0] == '-';
  const std::size_t start = negative || text[0] == '+' ? 1 : 0;
  if (text.size() < start + 2 || text[start] != '0') {
    return std::nullopt;
  }
  const bool hex = text[start + 1] == 'x' || text[start + 1] == 'X';
  const std::string_view digits = std::string_view(text).substr(start + (hex ? 2 : 1));
  const char* const end = digits.data() + digits.size();
  unsigned long long value = 0;
  const auto read = std::from_chars(digits.data(), end, value, hex ? 16 : 8);
  if (digits.size() > 15 || read.ec != std::errc() || read.ptr != end) {
    return std::nullopt;
  }
  const auto size = static_cast<long long>(value);  // of at most 60 bits
  return negative ? -size : size;
}

const YamlNode& emptyMap() {
  static const YamlNode kEmpty(YamlNode::Kind::Map);
  return kEmpty;
}

/// Names, choices and paths must not contain line ends, zero bytes or other control characters.
bool hasControlCharacter(const std::string& text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; });
}

/// A description for messages: "a list", "'text'".
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

}  // namespace

void ReadReport::add(const YamlNode& at, Diagnostic problem, EntityId entity) {
  problem.file = file;
  problem.line = at.line;
  problem.column = at.column;
  problem.entity = entity;
  diagnostics.push_back(std::move(problem));
}

YamlMap::YamlMap(const YamlNode* node, std::string path, EntityId entity, ReadReport& report)
    : node_(node != nullptr && node->isMap() ? node : &emptyMap()),
      path_(std::move(path)),
      entity_(entity),
      report_(report) {
  if (node != nullptr && !node->isMap() && !node->isNull()) {
    report.add(*node, withContext(path_, base::error("yaml.no-map", {described(*node)})), entity);
  }
}

std::string YamlMap::pathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void YamlMap::markKnown(const std::string& key) {
  known_.insert(key);
  report_.knownPaths.insert(pathOf(key));
}

const YamlNode& YamlMap::place(const std::string& key) const {
  const YamlNode* found = node_->find(key);
  return found != nullptr ? *found : *node_;
}

const YamlNode* YamlMap::find(const std::string& key) {
  markKnown(key);
  const YamlNode* found = node_->find(key);
  if (found != nullptr && found->isNull()) {
    warning(key, "yaml.no-value");
    return nullptr;
  }
  return found;
}

YamlMap YamlMap::map(const std::string& key) {
  return {find(key), pathOf(key), entity_, report_};
}

YamlMap::NumberText YamlMap::parse(const YamlNode& value, const std::string& key) {
  NumberText result;
  if (!value.isScalar() || value.text.empty()) {
    return result;
  }
  result.integer = prefixedInteger(value.text);
  if (result.integer) {
    add(value, key, base::warning("yaml.octal", {value.text, *result.integer}));
    result.number = static_cast<double>(*result.integer);
    return result;
  }
  result.integer = parseInt(value.text);
  result.number = parseDouble(value.text);
  if (value.quoted && result.number) {
    add(value, key, base::warning("yaml.quoted-number"));
  }
  return result;
}

std::optional<double> YamlMap::numberOf(const YamlNode& value, const std::string& key,
                                        Range range) {
  const std::optional<double> number = parse(value, key).number;
  if (!number) {
    add(value, key, base::error("yaml.not-number", {described(value)}));
  } else if (!std::isfinite(*number)) {
    add(value, key, base::error("yaml.not-finite", {value.text}));
  } else if (!range.contains(*number)) {
    add(value, key, outOfRange(value.text, range));
  } else {
    return number;
  }
  return std::nullopt;
}

std::optional<long long> YamlMap::integerOf(const YamlNode& value, const std::string& key) {
  const NumberText parsed = parse(value, key);
  if (parsed.integer) {
    return parsed.integer;
  }
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (parsed.number && std::fabs(*parsed.number) < kExact &&
      std::floor(*parsed.number) == *parsed.number) {
    add(value, key, base::warning("yaml.double-for-integer", {value.text}));
    return static_cast<long long>(*parsed.number);
  }
  add(value, key, base::error("yaml.not-integer", {described(value)}));
  return std::nullopt;
}

std::optional<double> YamlMap::number(const std::string& key, Range range) {
  const YamlNode* found = find(key);
  return found == nullptr ? std::nullopt : numberOf(*found, key, range);
}

std::optional<long long> YamlMap::integer(const std::string& key, long long low, long long high) {
  const YamlNode* found = find(key);
  const auto value = found == nullptr ? std::nullopt : integerOf(*found, key);
  if (!value || (*value >= low && *value <= high)) {
    return value;
  }
  if (high == kNoEnd) {
    error(key, "yaml.too-low", {found->text, low});
  } else {
    error(key, "yaml.out-of-range", {found->text, low, high});
  }
  return std::nullopt;
}

std::optional<bool> YamlMap::boolean(const std::string& key) {
  const YamlNode* found = find(key);
  if (found == nullptr) {
    return std::nullopt;
  }
  static const std::map<std::string, bool> kWords = {
      {"true", true},   {"yes", true}, {"on", true},   {"y", true},  {"1", true},
      {"false", false}, {"no", false}, {"off", false}, {"n", false}, {"0", false}};
  const auto word = kWords.find(found->isScalar() ? toLower(found->text) : std::string());
  if (word != kWords.end()) {
    return word->second;
  }
  error(key, "yaml.not-boolean", {described(*found)});
  return std::nullopt;
}

std::optional<std::string> YamlMap::text(const std::string& key) {
  const YamlNode* found = find(key);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (!found->isScalar()) {
    error(key, "yaml.no-text", {described(*found)});
    return std::nullopt;
  }
  if (hasControlCharacter(found->text)) {
    error(key, "yaml.control-character", {escapedControls(found->text)});
    return std::nullopt;
  }
  return found->text;
}

const std::vector<YamlNode>& YamlMap::items(const std::string& key) {
  const YamlNode* found = find(key);
  if (found != nullptr && !found->isList()) {
    error(key, "yaml.no-list", {described(*found)});
  }
  return found != nullptr && found->isList() ? found->items : emptyMap().items;
}

std::vector<double> YamlMap::numbers(const std::string& key, Range range) {
  std::vector<double> values;
  for (const YamlNode& item : items(key)) {
    if (const auto value = numberOf(item, key, range)) {
      values.push_back(*value);
    }
  }
  return values;
}

std::vector<int> YamlMap::integers(const std::string& key) {
  std::vector<int> values;
  for (const YamlNode& item : items(key)) {
    const auto value = integerOf(item, key);
    if (value && *value == static_cast<int>(*value)) {
      values.push_back(static_cast<int>(*value));
    } else if (value) {
      add(item, key, base::error("yaml.too-large", {item.text}));
    }
  }
  return values;
}

std::vector<std::string> YamlMap::names(const std::string& key) {
  std::vector<std::string> values;
  std::set<std::string_view> seen;
  for (const YamlNode& item : items(key)) {
    if (!item.isScalar() || item.text.empty()) {
      add(item, key, base::error("yaml.not-name", {described(item)}));
    } else if (hasControlCharacter(item.text)) {
      add(item, key, base::error("yaml.control-character", {escapedControls(item.text)}));
    } else if (!seen.insert(item.text).second) {
      add(item, key, base::error("yaml.listed-twice", {item.text}));
    } else {
      values.push_back(item.text);
    }
  }
  return values;
}

std::optional<std::string> YamlMap::choice(const std::string& key,
                                           const std::vector<std::string>& words) {
  auto word = text(key);
  if (!word || std::find(words.begin(), words.end(), *word) != words.end()) {
    return word;
  }
  error(key, "yaml.unknown-word", {*word, nearestName(*word, words), join(words, ", ")});
  return std::nullopt;
}

bool YamlMap::requireKey(const std::string& key) {
  const YamlNode* found = node_->find(key);
  if (found != nullptr && !found->isNull()) {
    return true;
  }
  markKnown(key);
  error(key, "yaml.missing");
  return false;
}

double YamlMap::required(const std::string& key, Range range) {
  return requireKey(key) ? number(key, range).value_or(0.0) : 0.0;
}

void YamlMap::add(const YamlNode& at, const std::string& key, Diagnostic problem) {
  report_.add(at, withContext(pathOf(key), std::move(problem)), entity_);
}

void YamlMap::error(const std::string& key, std::string_view code, ProblemValues values) {
  add(place(key), key, base::error(code, std::move(values)));
}

void YamlMap::warning(const std::string& key, std::string_view code, ProblemValues values) {
  add(place(key), key, base::warning(code, std::move(values)));
}

UnknownKey unknownKey(const YamlNode& value) {
  return {value.key, emitYaml(value)};
}

UnknownKeys YamlMap::takeUnknownKeys() {
  UnknownKeys unknown;
  for (const YamlNode& item : node_->items) {
    if (isKnown(item.key)) {
      continue;
    }
    const auto near = nearestName(item.key, {known_.begin(), known_.end()});
    report_.add(keyNode(item),
                near ? base::warning("yaml.unknown-key", {item.key, path_, near})
                     : base::warning("yaml.unknown-key-kept", {item.key, path_}),
                entity_);
    unknown.push_back(unknownKey(item));
  }
  return unknown;
}

}  // namespace base
