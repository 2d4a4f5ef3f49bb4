#include "sim2d/base/yaml/YamlMap.h"

#include <algorithm>

#include "sim2d/base/Text.h"

namespace base {
namespace {

const YamlNode& emptyMap() {
  static const YamlNode kEmpty = [] {
    YamlNode node;
    node.kind = YamlNode::Kind::Map;
    return node;
  }();
  return kEmpty;
}

}  // namespace

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

void ReadReport::add(Severity severity, const YamlNode& at, const std::string& message,
                     EntityId entity) {
  diagnostics.push_back({severity, file, at.line, at.column, message, entity});
}

void ReadReport::error(const YamlNode& at, const std::string& message, EntityId entity) {
  add(Severity::Error, at, message, entity);
}

void ReadReport::warning(const YamlNode& at, const std::string& message, EntityId entity) {
  add(Severity::Warning, at, message, entity);
}

void ReadReport::info(const YamlNode& at, const std::string& message, EntityId entity) {
  add(Severity::Info, at, message, entity);
}

YamlMap::YamlMap(const YamlNode* node, std::string path, EntityId entity, ReadReport& report)
    : node_(node != nullptr && node->isMap() ? node : &emptyMap()),
      path_(std::move(path)),
      entity_(entity),
      report_(report) {
  if (node != nullptr && !node->isMap() && !node->isNull()) {
    report.error(*node, path_ + ": must be a map, found " + described(*node), entity);
  }
}

std::string YamlMap::pathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void YamlMap::know(const std::string& key) {
  known_.insert(key);
  report_.knownPaths.insert(pathOf(key));
}

const YamlNode& YamlMap::place(const std::string& key) const {
  const YamlNode* found = node_->find(key);
  return found != nullptr ? *found : *node_;
}

const YamlNode* YamlMap::find(const std::string& key) {
  know(key);
  const YamlNode* found = node_->find(key);
  if (found != nullptr && found->isNull()) {
    report_.warning(*found, pathOf(key) + ": no value (taken as absent)", entity_);
    return nullptr;
  }
  return found;
}

YamlMap YamlMap::map(const std::string& key) {
  return {find(key), pathOf(key), entity_, report_};
}

std::optional<double> YamlMap::number(const std::string& key, Range range) {
  const YamlNode* found = find(key);
  return found == nullptr ? std::nullopt
                          : readNumber(*found, {pathOf(key), entity_}, range, report_);
}

std::optional<long long> YamlMap::bigInteger(const std::string& key, long long low) {
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

std::optional<int> YamlMap::integer(const std::string& key, long long low, long long high) {
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

std::optional<bool> YamlMap::boolean(const std::string& key) {
  const YamlNode* found = find(key);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->isScalar()) {
    const std::string word = lowered(found->text);
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

std::optional<std::string> YamlMap::text(const std::string& key) {
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

const YamlNode* YamlMap::list(const std::string& key) {
  const YamlNode* found = find(key);
  if (found != nullptr && !found->isList()) {
    error(key, "must be a list, found " + described(*found));
    return nullptr;
  }
  return found;
}

std::vector<double> YamlMap::numbers(const std::string& key, Range range) {
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

std::vector<int> YamlMap::integers(const std::string& key) {
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

std::vector<std::string> YamlMap::names(const std::string& key) {
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

std::optional<int> YamlMap::choice(const std::string& key, const std::vector<std::string>& words) {
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
  const auto near = nearestName(*word, words);
  error(key, "'" + *word + "' is unknown (" +
                 (near ? "did you mean '" + *near + "'? " : std::string()) + "one of " + all + ")");
  return std::nullopt;
}

bool YamlMap::demand(const std::string& key) {
  const YamlNode* found = node_->find(key);
  if (found != nullptr && !found->isNull()) {
    return true;
  }
  know(key);
  error(key, "is missing");
  return false;
}

double YamlMap::required(const std::string& key, Range range) {
  return demand(key) ? number(key, range).value_or(0.0) : 0.0;
}

std::optional<int> YamlMap::requiredChoice(const std::string& key,
                                           const std::vector<std::string>& words) {
  return demand(key) ? choice(key, words) : std::nullopt;
}

void YamlMap::error(const std::string& key, const std::string& message) {
  report_.error(place(key), pathOf(key) + ": " + message, entity_);
}

void YamlMap::warning(const std::string& key, const std::string& message) {
  report_.warning(place(key), pathOf(key) + ": " + message, entity_);
}

UnknownKey unknownKey(const YamlNode& value) {
  return {value.key, emitYaml(value)};
}

UnknownKeys YamlMap::takeUnknown() {
  UnknownKeys unknown;
  for (const YamlNode& item : node_->items) {
    if (isKnown(item.key)) {
      continue;
    }
    const auto near = nearestName(item.key, {known_.begin(), known_.end()});
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

}  // namespace base
