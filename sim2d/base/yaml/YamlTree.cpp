#include "sim2d/base/yaml/YamlTree.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include "sim2d/base/Text.h"

namespace base {
namespace {

/// Length [bytes] of a UTF-8 character with this first byte; 0: invalid.
std::size_t sequenceLength(unsigned char lead) {
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  return (lead >= 0x80 && lead < 0xC2) || lead > 0xF4 ? 0 : length;
}

// YAML limits keys to 1024 characters, and escaping may use four characters for one.
constexpr std::size_t kLongestKey = 200;

// Keys of a map: a block per listed agent, as many unlisted ones, and other keys.
constexpr std::size_t kMaxKeys = 5 * kMaxPeople / 2;

constexpr const char* kAgents = "agents";
constexpr std::string_view kYamlTags = "tag:yaml.org,2002:";

std::string shortTag(const std::string& tag) {
  return startsWith(tag, kYamlTags) ? "!!" + tag.substr(kYamlTags.size()) : tag;
}

constexpr std::size_t kMaxCopied = 100000;  // values per file; nested aliases multiply
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

/// Ends parsing after a reported error.
struct ParsingAborted {};

/// Builds the tree from the parser's events.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& file, const YamlSyntax& rules, Diagnostics& diagnostics)
      : file_(file), rules_(rules), diagnostics_(diagnostics) {}

  YamlNode root;

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { add(nodeAt(mark), anchor); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    YamlNode node = nodeAt(mark);
    if (!rules_.isRosFile) {
      report(node.line, node.column, "yaml.alias");
    }
    add(rules_.isRosFile ? copyOf(anchor, std::move(node)) : std::move(node));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode node = nodeAt(mark, scalarNode(value));
    node.quoted = tag == "!";
    setTag(node, tag);
    add(std::move(node), anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(mark, tag, YamlNode::Kind::List, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(mark, tag, YamlNode::Kind::Map, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    YamlNode node;
    YamlNode key;
    bool hasKey = false;
    bool isAgents = false;
    YAML::anchor_t anchor = 0;  // 0: none
    std::map<std::string, int> keyLines;
  };

  static YamlNode nodeAt(const YAML::Mark& mark, YamlNode node = {}) {
    node.line = mark.line + 1;  // yaml-cpp counts from 0
    node.column = mark.column + 1;
    return node;
  }
  static void setTag(YamlNode& node, const std::string& tag) {
    if (tag != "?" && tag != "!") {
      node.tag = shortTag(tag);
      node.quoted = node.quoted || node.tag == "!!str";
    }
  }
  void report(int line, int column, std::string_view code, ProblemValues values = {}) {
    diagnostics_.push_back(error(code, std::move(values), file_, line, column));
  }
  void open(const YAML::Mark& mark, const std::string& tag, YamlNode::Kind kind,
            YAML::anchor_t anchor) {
    Open entry;
    entry.anchor = anchor;
    entry.node = nodeAt(mark, YamlNode(kind));
    setTag(entry.node, tag);
    entry.isAgents = kind == YamlNode::Kind::List && !open_.empty() && open_.back().hasKey &&
                     open_.back().key.text == kAgents;
    open_.push_back(std::move(entry));
  }
  void close() {
    YamlNode node = std::move(open_.back().node);
    const YAML::anchor_t anchor = open_.back().anchor;
    open_.pop_back();
    if (rules_.isRosFile && node.isMap()) {
      replaceMergeKeys(node);
    }
    add(std::move(node), anchor);
  }
  void add(YamlNode node, YAML::anchor_t anchor = 0) {
    if (rules_.isRosFile && anchor != 0) {
      aliased_[anchor] = node;
    }
    if (open_.empty()) {
      root = std::move(node);
      return;
    }
    Open& parent = open_.back();
    checkCounts(parent, node);
    if (!parent.node.isMap()) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.hasKey) {
      setKey(parent, std::move(node));
    } else {
      node.key = parent.key.text;
      node.keyIsPlain = parent.key.isScalar() && !parent.key.quoted;
      node.keyLine = parent.key.line;
      node.keyColumn = parent.key.column;
      parent.node.items.push_back(std::move(node));
      parent.hasKey = false;
    }
  }
  /// Limits counts while parsing, before a huge file fills the memory.
  void checkCounts(const Open& parent, const YamlNode& next) {
    const std::size_t count = parent.node.items.size();
    if (parent.isAgents && count == kMaxPeople) {
      report(next.line, next.column, "yaml.too-many-people", {kMaxPeople});
      throw ParsingAborted();
    }
    if (parent.node.isMap() && count == kMaxKeys) {
      report(next.line, next.column, "yaml.too-many-keys", {kMaxKeys, kMaxPeople});
      throw ParsingAborted();
    }
  }
  void setKey(Open& parent, YamlNode key) {
    if (key.isMap() || key.isList()) {
      report(key.line, key.column, "yaml.key-no-word");
    } else if (key.text.size() > kLongestKey) {
      report(key.line, key.column, "yaml.key-too-long", {key.text.size()});
    } else if (!rules_.keepsDuplicates) {
      const auto found = parent.keyLines.emplace(key.text, key.line);
      if (!found.second) {
        report(key.line, key.column, "yaml.key-twice", {key.text, found.first->second});
      }
    }
    parent.key = std::move(key);
    parent.hasKey = true;
  }

  /// The value with this anchor (`&name`) for the alias (`*name`) at `at`; it keeps its own line
  /// and column. Warns once per file. Errors: unknown anchor (also an alias inside its own value),
  /// or too many copied values.
  YamlNode copyOf(YAML::anchor_t anchor, YamlNode at) {
    const auto found = aliased_.find(anchor);
    if (found == aliased_.end()) {
      report(at.line, at.column, "yaml.alias-without-value");
      return at;
    }
    if (!std::exchange(isAliasReported_, true)) {
      diagnostics_.push_back(warning("yaml.alias-replaced", {}, file_, at.line, at.column));
    }
    const std::size_t before = copied_;
    copied_ += sizeOf(found->second);
    if (copied_ <= kMaxCopied) {
      return found->second;
    }
    if (before <= kMaxCopied) {
      report(at.line, at.column, "yaml.too-many-aliases", {kMaxCopied});
    }
    return at;
  }
  /// The maps that a merge key inserts; empty with an error if its value is invalid.
  std::vector<YamlNode> mapsToMerge(YamlNode value) {
    const bool isListOfMaps = value.isList() && std::all_of(value.items.begin(), value.items.end(),
                                                            std::mem_fn(&YamlNode::isMap));
    if (isListOfMaps) {
      return std::move(value.items);
    }
    if (value.isMap()) {
      return {std::move(value)};
    }
    if (!value.isNull()) {
      report(value.keyLine, value.keyColumn, "yaml.merge-no-map");
    }
    return {};
  }
  /// Replaces the merge keys of a map (`<<: *defaults`, `<<: [*a, *b]`) by the keys of the merged
  /// maps. Keys of the map itself and of earlier maps take precedence.
  void replaceMergeKeys(YamlNode& map) {
    if (std::none_of(map.items.begin(), map.items.end(), isMergeKey)) {
      return;
    }
    std::vector<YamlNode> own, merged;
    for (YamlNode& item : map.items) {
      if (!isMergeKey(item)) {
        own.push_back(std::move(item));
        continue;
      }
      for (YamlNode& from : mapsToMerge(std::move(item))) {
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

  const std::string& file_;
  const YamlSyntax& rules_;
  Diagnostics& diagnostics_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, YamlNode> aliased_;  // values with an anchor
  std::size_t copied_ = 0;                      // values
  bool isAliasReported_ = false;
};

/// Appends a further document to the first if both are maps, as ROS 2 parameter files are read;
/// otherwise adds an error.
void appendDocument(YamlNode next, const std::string& file, const YamlSyntax& rules, YamlNode& root,
                    Diagnostics& diagnostics) {
  const bool isMerged =
      rules.isRosFile && (root.isMap() || root.isNull()) && (next.isMap() || next.isNull());
  diagnostics.push_back(problem(isMerged ? Severity::Warning : Severity::Error,
                                isMerged ? "yaml.documents-merged" : "yaml.second-document", {},
                                file, next.line, next.column));
  if (isMerged && root.isNull()) {
    root = std::move(next);
  } else if (isMerged) {
    std::move(next.items.begin(), next.items.end(), std::back_inserter(root.items));
  }
}

void parseInto(TreeBuilder& builder, const std::string& text, const std::string& file,
               const YamlSyntax& rules, Diagnostics& diagnostics) {
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    YamlNode first = std::move(builder.root);
    builder.root = {};
    while (parser.HandleNextDocument(builder)) {
      appendDocument(std::exchange(builder.root, {}), file, rules, first, diagnostics);
      if (!rules.isRosFile) {
        break;
      }
    }
    builder.root = std::move(first);
  } catch (const ParsingAborted&) {
    builder.root = {};
  } catch (const YAML::Exception& problem) {
    // yaml-cpp's message for lists nested too deeply
    const bool deep = problem.msg == "bad file";
    diagnostics.push_back(error("yaml.not-valid", {deep ? "nested too deeply" : problem.msg}, file,
                                problem.mark.line + 1, problem.mark.column + 1));
  }
}

int firstBinaryLine(std::string_view text) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = sequenceLength(lead);
    bool good = length > 0 && i + length <= text.size();
    good = good && (lead >= 0x20 || lead == '\n' || lead == '\r' || lead == '\t');
    for (std::size_t k = 1; good && k < length; ++k) {
      good = (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
    }
    if (!good) {
      return line;
    }
    line += lead == '\n' ? 1 : 0;
    i += length;
  }
  return 0;
}

void findTabs(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  int line = 0;
  for (const std::string& content : split(text, '\n')) {
    ++line;
    const std::size_t word = content.find_first_not_of(" \t\r");
    const std::size_t tab = content.find('\t');
    if (word != std::string::npos && content[word] != '#' && tab < word) {
      diagnostics.push_back(error("yaml.tab", {}, file, line, static_cast<int>(tab) + 1));
    }
  }
}

std::string withUnixLineEnds(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") {
    text.remove_prefix(3);
  }
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      result.push_back(text[i]);
    } else if (i + 1 == text.size() || text[i + 1] != '\n') {
      result.push_back('\n');
    }
  }
  return result;
}

/// Checks for tabs before parsing, because the parser's message is less specific. In ROS files only
/// after a parse error, as tabs inside brackets are valid.
YamlNode parsedText(const std::string& clean, const std::string& file, const YamlSyntax& rules,
                    Diagnostics& diagnostics) {
  Diagnostics tabs, found;
  findTabs(clean, file, tabs);
  if (!tabs.empty() && !rules.isRosFile) {
    append(diagnostics, tabs);
    return {};
  }
  TreeBuilder builder(file, rules, found);
  parseInto(builder, clean, file, rules, found);
  append(diagnostics, hasErrors(found) && !tabs.empty() ? tabs : found);
  return std::move(builder.root);
}

/// Leaves one value for each key of the maps in the tree.
class DuplicateMerger {
 public:
  DuplicateMerger(DuplicateKeys rule, const std::string& file, Diagnostics& diagnostics)
      : rule_(rule), file_(file), diagnostics_(diagnostics) {}

  void merge(YamlNode& node) {
    if (node.isMap()) {
      std::vector<YamlNode> unique;
      std::map<std::string, std::size_t> places;  // indices into `unique`
      for (YamlNode& item : node.items) {
        const auto [place, isNew] = places.emplace(item.key, unique.size());
        if (isNew) {
          unique.push_back(std::move(item));
        } else {
          repeat(unique[place->second], std::move(item));
        }
      }
      node.items = std::move(unique);
    }
    for (YamlNode& item : node.items) {
      merge(item);
    }
  }

 private:
  void repeat(YamlNode& first, YamlNode later) {
    const bool isLast = rule_ == DuplicateKeys::LastWins;
    if (isLast && first.isMap() && (later.isMap() || later.isNull())) {
      diagnostics_.push_back(warning("yaml.block-repeated", {later.key, first.keyLine}, file_,
                                     later.keyLine, later.keyColumn));
      std::move(later.items.begin(), later.items.end(), std::back_inserter(first.items));
      return;
    }
    diagnostics_.push_back(isLast ? duplicateKeyWarning(later.key, later, first, file_)
                                  : duplicateKeyWarning(later.key, first, later, file_));
    if (isLast) {
      first = std::move(later);
    }
  }

  DuplicateKeys rule_;
  const std::string& file_;
  Diagnostics& diagnostics_;
};

}  // namespace

const YamlNode* YamlNode::find(std::string_view name) const {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [name](const YamlNode& item) { return item.key == name; });
  return isMap() && found != items.end() ? &*found : nullptr;
}

YamlNode* YamlNode::find(std::string_view name) {
  return const_cast<YamlNode*>(static_cast<const YamlNode*>(this)->find(name));
}

YamlNode& YamlNode::child(const std::string& name) {
  if (!isMap()) {
    kind = Kind::Map;
    text.clear();
    items.clear();
  }
  if (YamlNode* found = find(name)) {
    return *found;
  }
  items.emplace_back();
  items.back().key = name;
  return items.back();
}

YamlNode keyNode(const YamlNode& value) {
  YamlNode node = scalarNode(value.key);
  node.line = value.keyLine;
  node.column = value.keyColumn;
  return node;
}

YamlNode scalarNode(std::string text) {
  return YamlNode(YamlNode::Kind::Scalar, std::move(text));
}

YamlNode stringNode(const std::string& text) {
  YamlNode node = scalarNode(text);
  node.quoted = needsQuotes(text);
  return node;
}

YamlNode parseYaml(std::string_view text, const std::string& file, const YamlSyntax& rules,
                   Diagnostics& diagnostics) {
  const std::string clean = withUnixLineEnds(text);
  if (const int line = firstBinaryLine(clean); line > 0) {
    diagnostics.push_back(error("yaml.not-text", {}, file, line));
    return {};
  }
  return parsedText(clean, file, rules, diagnostics);
}

YamlNode parseYaml(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  return parseYaml(text, file, YamlSyntax(), diagnostics);
}

YamlNode parseYaml(std::string_view text, const std::string& file, DuplicateKeys rule,
                   Diagnostics& diagnostics) {
  const YamlSyntax rules{true, rule == DuplicateKeys::LastWins};
  YamlNode root = parseYaml(text, file, rules, diagnostics);
  DuplicateMerger(rule, file, diagnostics).merge(root);
  return root;
}

Diagnostic duplicateKeyWarning(const std::string& name, const YamlNode& kept,
                               const YamlNode& dropped, const std::string& file) {
  return warning("yaml.key-repeated", {name, kept.keyLine, dropped.keyLine}, file, dropped.keyLine,
                 dropped.keyColumn);
}

std::string scalarText(const std::string& yaml) {
  Diagnostics problems;
  const YamlNode node = parseYaml(yaml, {}, problems);
  return node.isScalar() && !hasErrors(problems) ? node.text : yaml;
}

}  // namespace base
