#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

/// YAML as a plain tree that keeps what the scenario files need and a YAML library throws away:
/// order and repetition of keys, places, the text of numbers, quotes. For the readers of the
/// program.
namespace base {

struct YamlNode {
  enum class Kind { Null, Scalar, List, Map };

  YamlNode() = default;
  explicit YamlNode(Kind ofKind, std::string scalar = {}) : kind(ofKind), text(std::move(scalar)) {}

  Kind kind = Kind::Null;
  std::string text;             // of a scalar, without quotes
  bool quoted = false;          // not a plain scalar: a string whatever it looks like
  std::string tag;              // explicit tag, "!!str"; empty = none
  int line = 0, column = 0;     // from 1; 0 = made by the program
  std::vector<YamlNode> items;  // of a list, or the values of a map

  // as a value of a map:
  std::string key;
  bool keyIsPlain = false;  // was written without quotes
  int keyLine = 0, keyColumn = 0;

  bool isMap() const { return kind == Kind::Map; }
  bool isList() const { return kind == Kind::List; }
  bool isScalar() const { return kind == Kind::Scalar; }
  bool isNull() const { return kind == Kind::Null; }
  const YamlNode* find(std::string_view name) const;
  YamlNode* find(std::string_view name);
  /// The value of `name`, made as null at the end when it is not there. Turns null into a map.
  YamlNode& child(const std::string& name);
};

/// A key that we do not know, kept as YAML text (block style, not indented), in the order found.
struct UnknownKey {
  std::string key;
  std::string yaml;

  friend bool operator==(const UnknownKey& a, const UnknownKey& b) {
    return a.key == b.key && a.yaml == b.yaml;
  }
};
using UnknownKeys = std::vector<UnknownKey>;

/// The key of a value of a map, as a node at its place.
YamlNode keyNode(const YamlNode& value);
YamlNode scalarNode(std::string text);         // plain text as it stands (numbers, true, false)
YamlNode stringNode(const std::string& text);  // quoted where YAML 1.1 would read something else

/// People that the list `agents` of a file may name; what is longer is not read to its end.
constexpr std::size_t kMostPeople = 100000;

/// The only document of a text. Problems (syntax, tabs, repeated keys, aliases, not UTF-8, too many
/// people) go to `diagnostics`; with errors the tree must not be used.
YamlNode parseYaml(std::string_view text, const std::string& file, Diagnostics& diagnostics);

/// Block style, two spaces per level, lists indented under their key; no newline at the end.
std::string emitYaml(const YamlNode& node);

/// What a scalar in this text says, without its quotes; the text itself when it is none.
std::string scalarText(const std::string& yaml);

/// The text would be something else than a string, or no plain scalar at all.
bool needsQuotes(std::string_view text);

/// Number of comments, those inside quotes and block scalars not counted.
int countComments(std::string_view text);

}  // namespace base
