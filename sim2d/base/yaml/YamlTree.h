#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

/// YAML as a tree that keeps what YAML libraries drop: order and repetition of keys, lines and
/// columns, the text of numbers, quotes.
namespace base {

struct YamlNode {
  enum class Kind { Null, Scalar, List, Map };

  YamlNode() = default;
  explicit YamlNode(Kind ofKind, std::string scalar = {}) : kind(ofKind), text(std::move(scalar)) {}

  Kind kind = Kind::Null;
  std::string text;             // of a scalar, without quotes
  bool quoted = false;          // quoted, so always a string
  std::string tag;              // explicit tag, "!!str"; empty = none
  int line = 0, column = 0;     // from 1; 0: created by the program
  std::vector<YamlNode> items;  // of a list, or the values of a map

  // for values of a map:
  std::string key;
  bool keyIsPlain = false;  // written without quotes
  int keyLine = 0, keyColumn = 0;

  bool isMap() const { return kind == Kind::Map; }
  bool isList() const { return kind == Kind::List; }
  bool isScalar() const { return kind == Kind::Scalar; }
  bool isNull() const { return kind == Kind::Null; }
  const YamlNode* find(std::string_view name) const;
  YamlNode* find(std::string_view name);
  /// The value of `name`; appends a null value if it is missing. Turns null into a map.
  YamlNode& child(const std::string& name);
};

/// An unknown key, kept as YAML text (block style, not indented), in file order.
struct UnknownKey {
  std::string key;
  std::string yaml;

  friend bool operator==(const UnknownKey& a, const UnknownKey& b) {
    return a.key == b.key && a.yaml == b.yaml;
  }
};
using UnknownKeys = std::vector<UnknownKey>;

/// The key of a map value as a node with its line and column.
YamlNode keyNode(const YamlNode& value);
YamlNode scalarNode(std::string text);         // unquoted (numbers, true, false)
YamlNode stringNode(const std::string& text);  // quoted if YAML 1.1 would read another type

/// Largest number of agents in the list `agents` of a file; reading stops beyond it.
constexpr std::size_t kMaxPeople = 100000;

/// Parses a text with one document. Problems (syntax, tabs, repeated keys, aliases, not UTF-8, too
/// many agents) are added to `diagnostics`; with errors the tree must not be used.
YamlNode parseYaml(std::string_view text, const std::string& file, Diagnostics& diagnostics);

/// Syntax that is accepted in addition to that of the program's own files.
struct YamlSyntax {
  bool keepsDuplicates = false;  // keeps repeated keys
  /// ROS 2 parameter file: aliases (`*name`) and merge keys (`<<`) are resolved, further documents
  /// are appended, and tabs are allowed wherever YAML allows them; each with a warning.
  bool isRosFile = false;
};
/// As above, with these rules.
YamlNode parseYaml(std::string_view text, const std::string& file, const YamlSyntax& rules,
                   Diagnostics& diagnostics);

/// Third-party files may repeat keys. Each repetition is a warning with both lines; which value
/// counts depends on the program that the file is written for.
enum class DuplicateKeys {
  LastWins,  // ROS 2 parameter files (rcl_yaml_param_parser): maps are merged, also across
             // documents; aliases and merge keys are resolved, as launch tools do
  FirstWins  // files read with yaml-cpp: map_server maps, rosbag2 metadata
};
/// As above, but repeated keys are not errors: in the result each key of a map is unique.
YamlNode parseYaml(std::string_view text, const std::string& file, DuplicateKeys rule,
                   Diagnostics& diagnostics);
/// The warning for a repeated key: the value at `kept` is used, the one at `dropped` is not.
Diagnostic duplicateKeyWarning(const std::string& name, const YamlNode& kept,
                               const YamlNode& dropped, const std::string& file);

/// Block style, two spaces per level, lists indented under their key; no newline at the end.
std::string emitYaml(const YamlNode& node);

/// The value of a scalar text without its quotes; the text itself if it is not a scalar.
std::string scalarText(const std::string& yaml);

/// The text as a double-quoted YAML scalar on one line.
std::string quotedText(std::string_view text);

/// Whether YAML would not read the plain text as this string.
bool needsQuotes(std::string_view text);

/// Whether a line of the text begins with this key, which may be indented, in quotes, or after a
/// brace or a namespace ("/ns/amcl:"). The text may have errors of syntax; comments have no keys.
bool hasKeyLine(std::string_view text, std::string_view key);

/// Number of comments, excluding '#' in quotes and block scalars.
int countComments(std::string_view text);

}  // namespace base
