#pragma once

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"
#include "sim2d/base/yaml/YamlTree.h"

/// Typed access to maps of a YAML tree. Problems are reported with line and column. All YAML
/// readers of the program use it.
namespace base {

/// Diagnostics and other results of reading a file.
struct ReadReport {
  std::string file;
  Diagnostics diagnostics;
  std::set<std::string> knownPaths;  // dotted, below ros__parameters
  std::map<EntityId, int> lines;

  /// Adds a problem at the place of a value.
  void add(const YamlNode& at, Diagnostic problem, EntityId entity = {});
};

/// A map whose keys are read by type. Keys that are never read are reported as unknown.
class YamlMap {
 public:
  /// `node` null or a null value counts as an empty map; a value that is not a map is an error.
  YamlMap(const YamlNode* node, std::string path, EntityId entity, ReadReport& report);

  /// The value; the key becomes known. Null counts as absent, with a warning.
  const YamlNode* find(const std::string& key);
  const YamlNode& node() const { return *node_; }
  const std::string& path() const { return path_; }
  EntityId entity() const { return entity_; }
  ReadReport& report() { return report_; }
  std::string pathOf(const std::string& key) const;
  YamlMap map(const std::string& key);

  std::optional<double> number(const std::string& key, Range range = kAnyNumber);
  std::optional<long long> integer(const std::string& key, long long low, long long high = kNoEnd);
  std::optional<bool> boolean(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::vector<double> numbers(const std::string& key, Range range = kAnyNumber);
  std::vector<int> integers(const std::string& key);
  std::vector<std::string> names(const std::string& key);
  /// The value if it is one of `words`; else an error with the nearest one.
  std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& words);
  /// Whether the key has a value; adds an error if not.
  bool requireKey(const std::string& key);
  /// As number(); a missing key or value is an error.
  double required(const std::string& key, Range range = kAnyNumber);
  /// Converts an item of the list under that key.
  std::optional<long long> integerOf(const YamlNode& value, const std::string& key);

  /// Adds a problem at a value under that key.
  void add(const YamlNode& at, const std::string& key, Diagnostic problem);
  void error(const std::string& key, std::string_view code, ProblemValues values = {});
  void warning(const std::string& key, std::string_view code, ProblemValues values = {});
  /// Marks a key as known: takeUnknownKeys does not return it.
  void markKnown(const std::string& key);
  bool isKnown(const std::string& key) const { return known_.count(key) != 0; }
  /// Keys that were never read, in file order, each with a warning.
  UnknownKeys takeUnknownKeys();

 private:
  static constexpr long long kNoEnd = std::numeric_limits<long long>::max();
  struct NumberText {
    std::optional<long long> integer;
    std::optional<double> number;
  };

  const YamlNode& place(const std::string& key) const;
  NumberText parse(const YamlNode& value, const std::string& key);
  std::optional<double> numberOf(const YamlNode& value, const std::string& key, Range range);
  const std::vector<YamlNode>& items(const std::string& key);  // empty if missing or not a list

  const YamlNode* node_;
  std::string path_;
  EntityId entity_;
  ReadReport& report_;
  std::set<std::string> known_;
};

/// A key and its value as text, without a warning.
UnknownKey unknownKey(const YamlNode& value);

}  // namespace base
