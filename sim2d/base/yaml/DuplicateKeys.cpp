#include "sim2d/base/yaml/DuplicateKeys.h"

#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/yaml/YamlEmitter.h"

namespace base {
namespace {

class Merger {
 public:
  Merger(DuplicateKeys rule, const std::string& file, Diagnostics& diagnostics)
      : rule_(rule), file_(file), diagnostics_(diagnostics) {}

  void merge(YamlNode& node) {
    if (node.isMap()) {
      node.items = withoutDuplicates(std::move(node.items));
    }
    for (YamlNode& item : node.items) {
      merge(item);
    }
  }

 private:
  std::vector<YamlNode> withoutDuplicates(std::vector<YamlNode> items) {
    std::vector<YamlNode> unique;
    std::map<std::string, std::size_t> places;  // indices into `unique`
    for (YamlNode& item : items) {
      const auto [place, isNew] = places.emplace(item.key, unique.size());
      if (isNew) {
        unique.push_back(std::move(item));
      } else {
        repeat(unique[place->second], std::move(item));
      }
    }
    return unique;
  }

  void repeat(YamlNode& first, YamlNode later) {
    const bool isMerged =
        rule_ == DuplicateKeys::LastWins && first.isMap() && (later.isMap() || later.isNull());
    if (isMerged) {
      diagnostics_.push_back(warning("yaml.block-repeated", {later.key, first.keyLine}, file_,
                                     later.keyLine, later.keyColumn));
      std::move(later.items.begin(), later.items.end(), std::back_inserter(first.items));
    } else if (rule_ == DuplicateKeys::LastWins) {
      diagnostics_.push_back(duplicateKeyWarning(later.key, later, first, file_));
      first = std::move(later);
    } else {
      diagnostics_.push_back(duplicateKeyWarning(later.key, first, later, file_));
    }
  }

  DuplicateKeys rule_;
  const std::string& file_;
  Diagnostics& diagnostics_;
};

}  // namespace

Diagnostic duplicateKeyWarning(const std::string& name, const YamlNode& kept,
                               const YamlNode& dropped, const std::string& file) {
  return warning("yaml.key-repeated", {name, kept.keyLine, dropped.keyLine}, file, dropped.keyLine,
                 dropped.keyColumn);
}

YamlNode parseYaml(std::string_view text, const std::string& file, DuplicateKeys rule,
                   Diagnostics& diagnostics) {
  YamlNode root =
      parseYaml(text, file, YamlSyntax{true, rule == DuplicateKeys::LastWins}, diagnostics);
  Merger(rule, file, diagnostics).merge(root);
  return root;
}

}  // namespace base
