#include "sim2d/base/yaml/YamlAliases.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace base {
namespace {

constexpr std::size_t kMostCopied = 100000;  // values of a file; aliases of aliases multiply
constexpr const char* kMergeKey = "<<";

std::size_t sizeOf(const YamlNode& node) {
  std::size_t size = 1;
  for (const YamlNode& item : node.items) {
    size += sizeOf(item);
  }
  return size;
}

bool isMergeKey(const YamlNode& value) {
  return value.key == kMergeKey && value.keyIsPlain;
}

/// The maps that a merge key adds; empty with an error where they are none.
std::vector<YamlNode> mergedMaps(YamlNode value, const std::string& file,
                                 Diagnostics& diagnostics) {
  std::vector<YamlNode> maps;
  const bool isListOfMaps =
      value.isList() && std::all_of(value.items.begin(), value.items.end(),
                                    [](const YamlNode& item) { return item.isMap(); });
  if (isListOfMaps) {
    maps = std::move(value.items);
  } else if (value.isMap()) {
    maps.push_back(std::move(value));
  } else if (!value.isNull()) {
    diagnostics.push_back(error("yaml.merge-no-map", {}, file, value.keyLine, value.keyColumn));
  }
  return maps;
}

}  // namespace

YamlNode YamlAliases::copyOf(Anchor anchor, YamlNode at, const std::string& file,
                             Diagnostics& diagnostics) {
  const auto found = nodes_.find(anchor);
  if (found == nodes_.end()) {
    diagnostics.push_back(error("yaml.alias-without-value", {}, file, at.line, at.column));
    return at;
  }
  if (!std::exchange(isReported_, true)) {
    diagnostics.push_back(warning("yaml.alias-replaced", {}, file, at.line, at.column));
  }
  const std::size_t before = copied_;
  copied_ += sizeOf(found->second);
  if (copied_ > kMostCopied) {
    if (before <= kMostCopied) {
      diagnostics.push_back(
          error("yaml.too-many-aliases", {kMostCopied}, file, at.line, at.column));
    }
    return at;
  }
  return found->second;
}

void replaceMergeKeys(YamlNode& map, const std::string& file, Diagnostics& diagnostics) {
  if (std::none_of(map.items.begin(), map.items.end(), isMergeKey)) {
    return;
  }
  std::vector<YamlNode> own, merged;
  for (YamlNode& item : map.items) {
    if (!isMergeKey(item)) {
      own.push_back(std::move(item));
      continue;
    }
    for (YamlNode& from : mergedMaps(std::move(item), file, diagnostics)) {
      std::move(from.items.begin(), from.items.end(), std::back_inserter(merged));
    }
  }
  map.items = std::move(own);
  for (YamlNode& item : merged) {
    if (map.find(item.key) == nullptr) {
      map.items.push_back(std::move(item));
    }
  }
}

}  // namespace base
