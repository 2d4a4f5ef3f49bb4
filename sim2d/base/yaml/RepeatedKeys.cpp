#include "sim2d/base/yaml/RepeatedKeys.h"

#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/yaml/YamlText.h"

namespace base {
namespace {

class Merger {
 public:
  Merger(RepeatedKeys rule, const std::string& file, Diagnostics& diagnostics)
      : rule_(rule), file_(file), diagnostics_(diagnostics) {}

  void merge(YamlNode& node) {
    if (node.isMap()) {
      node.items = withoutRepeats(std::move(node.items));
    }
    for (YamlNode& item : node.items) {
      merge(item);
    }
  }

 private:
  std::vector<YamlNode> withoutRepeats(std::vector<YamlNode> items) {
    std::vector<YamlNode> unique;
    std::map<std::string, std::size_t> places;  // in `unique`
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
        rule_ == RepeatedKeys::LastCounts && first.isMap() && (later.isMap() || later.isNull());
    if (isMerged) {
      diagnostics_.push_back(warning("yaml.block-repeated", {later.key, first.keyLine}, file_,
                                     later.keyLine, later.keyColumn));
      std::move(later.items.begin(), later.items.end(), std::back_inserter(first.items));
    } else if (rule_ == RepeatedKeys::LastCounts) {
      diagnostics_.push_back(repeatedKey(later.key, later, first, file_));
      first = std::move(later);
    } else {
      diagnostics_.push_back(repeatedKey(later.key, first, later, file_));
    }
  }

  RepeatedKeys rule_;
  const std::string& file_;
  Diagnostics& diagnostics_;
};

}  // namespace

Diagnostic repeatedKey(const std::string& name, const YamlNode& kept, const YamlNode& dropped,
                       const std::string& file) {
  return warning("yaml.key-repeated", {name, kept.keyLine, dropped.keyLine}, file, dropped.keyLine,
                 dropped.keyColumn);
}

YamlNode parseYaml(std::string_view text, const std::string& file, RepeatedKeys rule,
                   Diagnostics& diagnostics) {
  YamlNode root =
      parseYaml(text, file, YamlRules{true, rule == RepeatedKeys::LastCounts}, diagnostics);
  Merger(rule, file, diagnostics).merge(root);
  return root;
}

}  // namespace base
