#include "sim2d/nav/nav2/params/ParameterPatch.h"

#include <algorithm>
#include <map>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace sim2d::nav2 {

namespace {

constexpr const char* kFile = "parameters";

/// The lines of a text and the offsets at which they begin.
class TextLines {
 public:
  explicit TextLines(const std::string& text) : text_(text), starts_{0} {
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (text[at] == '\n' && at + 1 < text.size()) {
        starts_.push_back(at + 1);
      }
    }
  }

  std::size_t count() const { return starts_.size(); }
  std::size_t start(std::size_t line) const {
    return line < count() ? starts_[line] : text_.size();
  }
  /// Without its line break.
  std::string_view line(std::size_t number) const {
    std::string_view whole(text_);
    whole = whole.substr(start(number), start(number + 1) - start(number));
    while (!whole.empty() && (whole.back() == '\n' || whole.back() == '\r')) {
      whole.remove_suffix(1);
    }
    return whole;
  }
  std::size_t indent(std::size_t number) const {
    return std::min(line(number).find_first_not_of(' '), line(number).size());
  }
  bool isBlank(std::size_t number) const {
    const std::string_view rest = line(number).substr(indent(number));
    return rest.empty() || rest.front() == '#' || rest.front() == '\t';
  }
  /// The line behind the value of a key; numbers from 0. Blank lines and comments at its end do not
  /// belong to it.
  std::size_t endOfBlock(std::size_t keyLine, std::size_t keyIndent) const {
    std::size_t end = keyLine + 1;
    for (std::size_t k = keyLine + 1; k < count(); ++k) {
      if (isBlank(k)) {
        continue;
      }
      const bool isItem = indent(k) == keyIndent && line(k)[keyIndent] == '-';
      if (indent(k) <= keyIndent && !isItem) {
        break;
      }
      end = k + 1;
    }
    return end;
  }

 private:
  const std::string& text_;
  std::vector<std::size_t> starts_;
};

/// Behind the closing quote of a quoted scalar.
std::size_t endOfQuotes(const std::string& text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text[at] == quote) {
      if (quote == '"' || at + 1 >= text.size() || text[at + 1] != quote) {
        return at + 1;
      }
      ++at;  // '' stands for a quote
    }
  }
  return std::string::npos;
}

/// Behind the closing bracket of a flow collection.
std::size_t endOfBrackets(const std::string& text, std::size_t at) {
  int depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = endOfQuotes(text, at);
      continue;
    }
    depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    ++at;
    if (depth == 0) {
      return at;
    }
  }
  return std::string::npos;
}

/// Behind a plain scalar on one line.
std::size_t endOfPlain(const std::string& text, std::size_t at, bool isInFlow) {
  std::size_t end = at;
  for (; at < text.size() && text[at] != '\n' && text[at] != '\r'; ++at) {
    const bool isComment =
        text[at] == '#' && at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t');
    const bool isEnd = isInFlow && (text[at] == ',' || text[at] == ']' || text[at] == '}');
    if (isComment || isEnd) {
      break;
    }
    end = text[at] == ' ' || text[at] == '\t' ? end : at + 1;
  }
  return end;
}

std::size_t endOfValue(const std::string& text, std::size_t at, bool isInFlow) {
  const char c = at < text.size() ? text[at] : '|';
  if (c == '|' || c == '>' || c == '*' || c == '&' || c == '!') {
    return std::string::npos;  // block scalars, aliases, anchors and tags
  }
  return c == '"' || c == '\''  ? endOfQuotes(text, at)
         : c == '[' || c == '{' ? endOfBrackets(text, at)
                                : endOfPlain(text, at, isInFlow);
}

/// Replaces a value in its place.
std::optional<std::string> replaced(const std::string& text, const base::YamlNode& value,
                                    const std::string& yaml) {
  const TextLines lines(text);
  if (value.line < 1 || value.keyLine < 1 || value.isMap()) {
    return std::nullopt;
  }
  const auto keyLine = static_cast<std::size_t>(value.keyLine) - 1;
  const auto keyColumn = static_cast<std::size_t>(value.keyColumn) - 1;
  std::size_t from = lines.start(static_cast<std::size_t>(value.line) - 1) +
                     static_cast<std::size_t>(value.column) - 1;
  std::size_t to = 0;
  std::string before;
  if (value.isNull() || (value.isList() && from < text.size() && text[from] == '-')) {
    from = text.find(':', lines.start(keyLine) + keyColumn + value.key.size());
    from = from == std::string::npos ? from : from + 1;
    const std::size_t end = lines.start(lines.endOfBlock(keyLine, keyColumn));
    to = value.isNull() || end == 0 ? from
                                    : end - (end < text.size() || text.back() == '\n' ? 1 : 0);
    before = " ";
  } else {
    const bool isInFlow = lines.line(keyLine).substr(0, keyColumn).find('{') != std::string::npos;
    to = endOfValue(text, from, isInFlow);
  }
  if (from == std::string::npos || to == std::string::npos || from > to) {
    return std::nullopt;
  }
  return text.substr(0, from) + before + yaml + text.substr(to);
}

/// Adds a parameter below the last one of the same map.
std::optional<std::string> insertedBeside(const std::string& text, const GivenParameter& sibling,
                                          const ParameterValue& value) {
  const base::YamlNode& node = *sibling.value;
  if (node.keyLine < 1 || sibling.name.size() < node.key.size()) {
    return std::nullopt;
  }
  const std::string map = sibling.name.substr(0, sibling.name.size() - node.key.size());
  const TextLines lines(text);
  const auto keyLine = static_cast<std::size_t>(node.keyLine) - 1;
  const auto indent = static_cast<std::size_t>(node.keyColumn) - 1;
  if (value.name.compare(0, map.size(), map) != 0 || lines.indent(keyLine) != indent) {
    return std::nullopt;  // in another map, or in a flow map
  }
  const std::size_t at = lines.start(lines.endOfBlock(keyLine, indent));
  const bool endsLine = at > 0 && text[at - 1] == '\n';
  return text.substr(0, at) + (endsLine ? "" : "\n") + std::string(indent, ' ') +
         value.name.substr(map.size()) + ": " + value.yaml + "\n" + text.substr(at);
}

/// The number of leading characters of a name, up to a dot, that another name shares.
std::size_t sharedPath(const std::string& a, const std::string& b) {
  std::size_t shared = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()) && a[k] == b[k]; ++k) {
    shared = a[k] == '.' ? k + 1 : shared;
  }
  return shared;
}

/// Texts with the parameter added: beside its siblings, or in a new block at the end.
std::vector<std::string> insertions(const std::string& text, const NodeParameters& node,
                                    const ParameterValue& value) {
  std::vector<const GivenParameter*> siblings;
  for (const GivenParameter& given : node.given) {
    if (!given.isWildcard && !given.file.empty() && given.value != nullptr) {
      siblings.push_back(&given);
    }
  }
  std::reverse(siblings.begin(), siblings.end());  // the last one of equally close ones first
  std::stable_sort(siblings.begin(), siblings.end(),
                   [&](const GivenParameter* a, const GivenParameter* b) {
                     return sharedPath(a->name, value.name) > sharedPath(b->name, value.name);
                   });
  std::vector<std::string> found;
  for (const GivenParameter* sibling : siblings) {
    if (const auto inserted = insertedBeside(text, *sibling, value)) {
      found.push_back(*inserted);
    }
  }
  const std::string line = value.name + ": " + value.yaml + "\n";
  const std::string start = text + (base::endsWith(text, "\n") ? "" : "\n") + value.node + ":\n";
  found.push_back(start + "  ros__parameters:\n    " + line);
  found.push_back(start + "  " + value.node + ":\n    ros__parameters:\n      " + line);
  return found;
}

using FlatParameters = std::map<std::string, std::string>;

FlatParameters flattened(const ParameterFile& file) {
  FlatParameters all;
  for (const NodeParameters& node : file.nodes()) {
    for (const GivenParameter& given : node.given) {
      all[node.nameSpace + "/" + node.node + ":" + given.name] = base::emitYaml(*given.value);
    }
  }
  return all;
}

std::string normalized(const std::string& yaml) {
  base::Diagnostics problems;
  return base::emitYaml(base::parseYaml(yaml, kFile, problems));
}

/// Whether the new text differs from the file by this value only.
bool isOnlyChange(const ParameterFile& before, const std::string& text, const ParameterValue& value,
                  const std::string& robot) {
  const base::Result<ParameterFile> after = ParameterFile::parse(text, kFile);
  if (!after) {
    return false;
  }
  const NodeParameters node = after->parametersOf(value.node, robot);
  const GivenParameter* const found = node.find(value.name);
  if (found == nullptr || found->isWildcard ||
      base::emitYaml(*found->value) != normalized(value.yaml)) {
    return false;
  }
  const FlatParameters old = flattened(before);
  FlatParameters now = flattened(*after);
  std::size_t changes = 0;
  for (const auto& [path, yaml] : old) {
    const auto same = now.find(path);
    if (same == now.end()) {
      return false;
    }
    changes += same->second != yaml ? 1 : 0;
    now.erase(same);
  }
  return changes + now.size() <= 1;
}

}  // namespace

std::optional<std::string> withParameter(const std::string& text, const ParameterValue& value,
                                         const std::string& robot) {
  const base::Result<ParameterFile> file = ParameterFile::parse(text, kFile);
  if (!file) {
    return std::nullopt;
  }
  const NodeParameters node = file->parametersOf(value.node, robot);
  const GivenParameter* const given = node.find(value.name);
  const bool isOwn = given != nullptr && !given->isWildcard && given->value != nullptr;
  std::vector<std::string> candidates;
  if (!isOwn) {
    candidates = insertions(text, node, value);
  } else if (const auto changed = replaced(text, *given->value, value.yaml)) {
    candidates.push_back(*changed);
  }
  const auto good = std::find_if(candidates.begin(), candidates.end(), [&](const auto& candidate) {
    return isOnlyChange(*file, candidate, value, robot);
  });
  return good == candidates.end() ? std::nullopt : std::optional(*good);
}

}  // namespace sim2d::nav2
