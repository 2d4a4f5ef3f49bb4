#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "sim2d/base/yaml/YamlTree.h"

/// Anchors, aliases and merge keys of YAML, replaced while a file is read. Private to this folder.
namespace base {

/// The values that have an anchor (`&name`), and copies of them for their aliases (`*name`).
class YamlAliases {
 public:
  using Anchor = std::size_t;  // yaml-cpp numbers them

  void keep(Anchor anchor, YamlNode node) { nodes_[anchor] = std::move(node); }
  /// The value for an alias at the place of `at`, with the places of the value. A warning once per
  /// file; errors: the anchor is unknown (an alias in its own value), or the copies of the file
  /// become too many.
  YamlNode copyOf(Anchor anchor, YamlNode at, const std::string& file, Diagnostics& diagnostics);

 private:
  std::map<Anchor, YamlNode> nodes_;
  std::size_t copied_ = 0;  // values
  bool isReported_ = false;
};

/// Merge keys of a map (`<<: *defaults`, `<<: [*a, *b]`) replaced by the keys that they add: those
/// that the map does not have itself, and that no map before has added.
void replaceMergeKeys(YamlNode& map, const std::string& file, Diagnostics& diagnostics);

}  // namespace base
