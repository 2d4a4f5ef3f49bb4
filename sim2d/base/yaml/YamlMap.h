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

/// Typed reading of maps of a YAML tree; every problem is reported with its place. The one layer
/// for all YAML files of the program.
namespace base {

/// What one reading gathers beside the values.
struct ReadReport {
  std::string file;
  Diagnostics diagnostics;
  std::set<std::string> knownPaths;  // dotted, below ros__parameters
  std::map<EntityId, int> lines;

  /// The problem of a value, with its place in the file.
  void add(const YamlNode& at, Diagnostic problem, EntityId entity = {});
};

/// A map of which each key is asked for once by type; what nobody asked for is unknown.
class YamlMap {
 public:
  /// `node` null or absent counts as an empty map; neither map nor null is an error.
  YamlMap(const YamlNode* node, std::string path, EntityId entity, ReadReport& report);

  /// The value, and the key is known from now on. Null counts as absent, with a warning.
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
  /// One of `words`; another one is an error with the nearest.
  std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& words);
  /// Whether the key has a value; an error otherwise.
  bool demand(const std::string& key);
  /// As above; an error where the key or its value is missing.
  double required(const std::string& key, Range range = kAnyNumber);
  /// An item of a list under that key.
  std::optional<long long> integerOf(const YamlNode& value, const std::string& key);

  /// About a value under that key, at its place.
  void add(const YamlNode& at, const std::string& key, Diagnostic problem);
  void error(const std::string& key, std::string_view code, ProblemValues values = {});
  void warning(const std::string& key, std::string_view code, ProblemValues values = {});
  /// Asked for: not reported and not kept by takeUnknown.
  void know(const std::string& key);
  bool isKnown(const std::string& key) const { return known_.count(key) != 0; }
  /// Keys nobody asked for, with a warning each, in the order found.
  UnknownKeys takeUnknown();

 private:
  static constexpr long long kNoEnd = std::numeric_limits<long long>::max();
  struct NumberText {
    std::optional<long long> integer;
    std::optional<double> number;
  };

  const YamlNode& place(const std::string& key) const;
  NumberText parse(const YamlNode& value, const std::string& key);
  std::optional<double> numberOf(const YamlNode& value, const std::string& key, Range range);
  const std::vector<YamlNode>& items(const std::string& key);  // none: nothing, or no list

  const YamlNode* node_;
  std::string path_;
  EntityId entity_;
  ReadReport& report_;
  std::set<std::string> known_;
};

/// The keys of a map as text, without a word about them.
UnknownKey unknownKey(const YamlNode& value);

}  // namespace base
