#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/tree/TreeXml.h"
#include "bt/tree/XmlText.h"
#include "sim2d/base/Find.h"

namespace bt {
namespace {

using Position = std::size_t;  // offset in the text

struct SourceAttribute {
  std::string name;
  Position begin = 0, value = 0, end = 0;  // of the name; after the opening, the closing quote
};

/// Position of an element in the text: [begin, end).
struct SourceElement {
  std::string tag;
  Position begin = 0, body = 0;   // `body`: after the '>' of its start tag
  Position bodyEnd = 0, end = 0;  // of the end tag
  bool isClosed = false;          // "<X/>"
  std::vector<SourceAttribute> attributes;
  std::vector<SourceElement> children;
};

/// Scans the elements of well-formed XML text.
class SourceScanner {
 public:
  explicit SourceScanner(std::string_view text) : text_(text) {}
  std::optional<SourceElement> root();

 private:
  bool skip(std::string_view begin, std::string_view end);
  SourceElement startTag();
  void readAttribute(SourceElement& element);
  bool isBlank() const { return std::string_view(" \t\r\n").find(text_[at_]) != text_.npos; }
  void skipBlanks() {
    while (at_ < text_.size() && isBlank()) {
      ++at_;
    }
  }
  std::string word();

  std::string_view text_;
  Position at_ = 0;
};

bool SourceScanner::skip(std::string_view begin, std::string_view end) {
  if (text_.substr(at_, begin.size()) != begin) {
    return false;
  }
  const Position found = text_.find(end, at_ + begin.size());
  at_ = found == text_.npos ? text_.size() : found + end.size();
  return true;
}

std::string SourceScanner::word() {
  const Position begin = at_;
  while (at_ < text_.size() && !isBlank() &&
         std::string_view("=/>").find(text_[at_]) == std::string_view::npos) {
    ++at_;
  }
  return std::string(text_.substr(begin, at_ - begin));
}

void SourceScanner::readAttribute(SourceElement& element) {
  SourceAttribute attribute;
  attribute.begin = at_;
  attribute.name = word();
  skipBlanks();
  ++at_;  // '='
  skipBlanks();
  const char quote = at_ < text_.size() ? text_[at_] : '"';
  attribute.value = at_ + 1;
  const Position close = text_.find(quote, std::min(attribute.value, text_.size()));
  attribute.end = at_ = close == text_.npos ? text_.size() : close + 1;
  element.attributes.push_back(std::move(attribute));
}

SourceElement SourceScanner::startTag() {
  SourceElement element;
  element.begin = at_++;
  element.tag = word();
  for (skipBlanks(); at_ < text_.size() && text_[at_] != '>'; skipBlanks()) {
    if (text_[at_] == '/') {
      element.isClosed = true;
      ++at_;
    } else {
      readAttribute(element);
    }
  }
  element.body = element.bodyEnd = element.end = std::min(at_ + 1, text_.size());
  at_ = element.end;
  return element;
}

std::optional<SourceElement> SourceScanner::root() {
  std::vector<SourceElement> open;
  while (at_ < text_.size()) {
    const bool isSkipped = text_[at_] != '<' || skip("<!--", "-->") || skip("<![CDATA[", "]]>") ||
                           skip("<?", "?>") || skip("<!", ">");
    if (isSkipped) {
      at_ = text_.find('<', at_);
      continue;
    }
    std::optional<SourceElement> done;
    if (text_.substr(at_, 2) == "</" && !open.empty()) {
      done = std::move(open.back());
      open.pop_back();
      done->bodyEnd = at_;
      skip("</", ">");
      done->end = at_;
    } else {
      SourceElement element = startTag();
      element.isClosed ? (void)(done = std::move(element)) : open.push_back(std::move(element));
    }
    if (done && open.empty()) {
      return done;
    }
    if (done) {
      open.back().children.push_back(*std::move(done));
    }
  }
  return std::nullopt;
}

struct ChildMatch {
  int before = -1, now = -1;  // index, -1: none
};

/// Index of the first of before[from, to) with the ID and name of `now`, otherwise the first with
/// its ID, otherwise `to`.
std::size_t indexOfSimilar(const std::vector<NodeSpec>& before, std::size_t from, std::size_t to,
                           const NodeSpec& now) {
  std::size_t like = to;
  for (std::size_t k = from; k < to; ++k) {
    if (before[k].id == now.id && before[k].name == now.name) {
      return k;
    }
    like = like == to && before[k].id == now.id ? k : like;
  }
  return like;
}

/// Matches the children of two versions of a node: equal ones by their longest common subsequence,
/// then similar ones between them. In the order of `now`, without removed children.
std::vector<ChildMatch> matchChildren(const std::vector<NodeSpec>& before,
                                      const std::vector<NodeSpec>& now) {
  const std::size_t rows = before.size(), columns = now.size();
  std::vector<std::vector<int>> common(rows + 1, std::vector<int>(columns + 1, 0));
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t k = columns; k-- > 0;) {
      common[i][k] = before[i] == now[k] ? common[i + 1][k + 1] + 1
                                         : std::max(common[i + 1][k], common[i][k + 1]);
    }
  }
  std::vector<ChildMatch> pairs;
  std::size_t i = 0, k = 0;
  const auto between = [&](std::size_t toRow, std::size_t toColumn) {
    for (; k < toColumn; ++k) {
      const std::size_t same = indexOfSimilar(before, i, toRow, now[k]);
      const bool isFound = same < toRow;
      pairs.push_back({isFound ? static_cast<int>(same) : -1, static_cast<int>(k)});
      i = isFound ? same + 1 : i;
    }
    i = toRow;
  };
  for (std::size_t row = 0, column = 0; row < rows && column < columns;) {
    if (before[row] == now[column]) {
      between(row, column);
      pairs.push_back({static_cast<int>(i++), static_cast<int>(k++)});
      ++row;
      ++column;
    } else if (common[row + 1][column] >= common[row][column + 1]) {
      ++row;
    } else {
      ++column;
    }
  }
  between(rows, columns);
  return pairs;
}

/// A node of the old text that has a comment inside or before it.
struct NodeWithComment {
  const NodeSpec* node = nullptr;
  const SourceElement* source = nullptr;
  Position begin = 0;  // of the comment before it, otherwise of the element
};

class TreeRewriter {
 public:
  TreeRewriter(std::string_view text, const NodeCatalogue& catalogue)
      : text_(text), catalogue_(catalogue) {}
  std::optional<std::string> rewrite(const TreeFile& before, const TreeFile& now);

 private:
  std::string part(Position from, Position to) const {
    return std::string(text_.substr(from, to - from));
  }
  /// The blanks before an element that starts its line, otherwise empty.
  std::string indentationOf(Position begin) const;
  void write(const TreeSpec& before, const TreeSpec& now, const SourceElement& source);
  void write(const NodeSpec& before, const NodeSpec& now, const SourceElement& source);
  void writeStart(const NodeSpec& before, const NodeSpec& now, const SourceElement& source);
  void writeChildren(const NodeSpec& before, const NodeSpec& now, const SourceElement& source);
  void writeNew(const NodeSpec& node, bool compact, const std::string& margin);
  void findComments(const NodeSpec& node, const SourceElement& source, Position behind);
  const NodeWithComment* findNodeWithComment(const NodeSpec& node) const;
  std::string textWithComments(const NodeSpec& node, bool compact, const std::string& margin) const;
  void findCommentsOfTrees(const TreeFile& before, const SourceElement& root);
  void writeNewTrees(const TreeFile& before, const TreeFile& now, const std::string& margin);
  Position writeMainTree(const std::string& before, const std::string& now,
                         const SourceElement& root);

  std::string_view text_;
  const NodeCatalogue& catalogue_;
  std::string result_;
  std::vector<NodeWithComment> nodesWithComments_;  // nodes of the old text
  bool canRewrite_ = true;
};

/// Collects nodes that have comments. `behind` is the end of the previous element or of the
/// enclosing start tag; a comment on that line belongs to that element.
void TreeRewriter::findComments(const NodeSpec& node, const SourceElement& source,
                                Position behind) {
  if (source.children.size() != node.children.size()) {
    return;
  }
  const std::string_view gap = text_.substr(behind, source.begin - behind);
  const Position line = gap.find('\n');
  const Position said = line == gap.npos ? gap.npos : gap.find("<!--", line);
  const bool isInside =
      text_.substr(source.begin, source.end - source.begin).find("<!--") != text_.npos;
  if (said != gap.npos || isInside) {
    nodesWithComments_.push_back({&node, &source, said == gap.npos ? source.begin : behind + said});
  }
  for (std::size_t k = 0; isInside && k < node.children.size(); ++k) {
    findComments(node.children[k], source.children[k],
                 k == 0 ? source.body : source.children[k - 1].end);
  }
}

const NodeWithComment* TreeRewriter::findNodeWithComment(const NodeSpec& node) const {
  return base::findIf(nodesWithComments_,
                      [&node](const NodeWithComment& each) { return *each.node == node; });
}

/// The lines of a node at a new position, without the last line break. The comments of an equal
/// node of the old text are included.
std::string TreeRewriter::textWithComments(const NodeSpec& node, bool compact,
                                           const std::string& margin) const {
  const NodeWithComment* like = findNodeWithComment(node);
  if (like != nullptr && !(compact && like->node->explicitNotation)) {
    const std::string before = indentationOf(like->source->begin);
    std::string lines = margin;
    for (Position from = like->begin; from < like->source->end;) {
      const Position line = std::min(text_.find('\n', from), like->source->end);
      lines += part(from, line);
      from = line + 1;
      if (line < like->source->end) {
        const bool isIndented = text_.substr(from, before.size()) == before;
        lines += "\n" + (isIndented ? margin : std::string());
        from += isIndented ? before.size() : 0;
      }
    }
    return lines;
  }
  NodeSpec alone = node;
  alone.children.clear();
  std::string text = toXmlText(alone, catalogue_, compact, margin);
  text.pop_back();
  if (node.children.empty()) {
    return text;
  }
  const Position tag = margin.size() + 1;
  const std::string name = text.substr(tag, text.find_first_of(" \t/>", tag) - tag);
  text = text.substr(0, text.rfind("/>")) + ">";
  for (const NodeSpec& child : node.children) {
    text += "\n" + textWithComments(child, node.id == "ReactiveSequence", margin + "  ");
  }
  return text + "\n" + margin + "</" + name + ">";
}

std::string TreeRewriter::indentationOf(Position begin) const {
  const Position line = text_.rfind('\n', begin);
  const Position from = line == text_.npos ? 0 : line + 1;
  const std::string margin = part(from, begin);
  return margin.find_first_not_of(" \t") == margin.npos ? margin : std::string();
}

void TreeRewriter::writeNew(const NodeSpec& node, bool compact, const std::string& margin) {
  result_ += "\n" + textWithComments(node, compact, margin);
}

void TreeRewriter::writeStart(const NodeSpec& before, const NodeSpec& now,
                              const SourceElement& source) {
  const Attributes was = attributesOf(before);
  const Attributes is = attributesOf(now);
  Position from = source.begin;
  for (const SourceAttribute& attribute : source.attributes) {
    const std::string* old = findAttribute(was, attribute.name);
    const std::string* wanted = findAttribute(is, attribute.name);
    if (wanted == nullptr && old != nullptr) {  // with the blanks before it
      const Position blanks = text_.find_last_not_of(" \t\r\n", attribute.begin - 1) + 1;
      result_ += part(from, blanks);
      from = attribute.end;
    } else if (wanted != nullptr && old != nullptr && *wanted != *old) {
      result_ += part(from, attribute.value - 1) + '"' + escapedXml(*wanted) + '"';
      from = attribute.end;
    }
  }
  const Position last = source.attributes.empty() ? source.begin + 1 + source.tag.size()
                                                  : source.attributes.back().end;
  result_ += from < last ? part(from, last) : std::string();
  for (const Attribute& attribute : is) {
    if (findAttribute(was, attribute.name) == nullptr) {
      result_ += " " + attribute.name + "=\"" + escapedXml(attribute.text) + "\"";
    }
  }
  result_ += source.isClosed && !now.children.empty() ? ">" : part(last, source.body);
}

void TreeRewriter::writeChildren(const NodeSpec& before, const NodeSpec& now,
                                 const SourceElement& source) {
  const bool compact = now.id == "ReactiveSequence";
  const std::string own = indentationOf(source.begin);
  const std::string margin =
      source.children.empty() ? own + "  " : indentationOf(source.children.front().begin);
  const auto behind = [&](int child) {
    return child < 0 ? source.body : source.children[static_cast<std::size_t>(child)].end;
  };
  for (const ChildMatch& pair : matchChildren(before.children, now.children)) {
    const NodeSpec& child = now.children[static_cast<std::size_t>(pair.now)];
    if (pair.before < 0) {
      writeNew(child, compact, margin);
      continue;
    }
    const auto place = static_cast<std::size_t>(pair.before);
    const Position gap = behind(pair.before - 1);  // comments of removed children are removed too
    result_ += part(gap, source.children[place].begin);
    write(before.children[place], child, source.children[place]);
  }
  if (!source.isClosed) {
    const std::string rest =
        part(behind(static_cast<int>(source.children.size()) - 1), source.bodyEnd);
    const bool isFirst = source.children.empty() && !now.children.empty() &&
                         rest.find_first_not_of(" \t\r\n") == rest.npos;
    result_ += (isFirst ? "\n" + own : rest) + part(source.bodyEnd, source.end);
  } else if (!now.children.empty()) {
    result_ += "\n" + own + "</" + source.tag + ">";
  }
}

void TreeRewriter::write(const NodeSpec& before, const NodeSpec& now, const SourceElement& source) {
  if (before == now) {
    result_ += part(source.begin, source.end);
    return;
  }
  canRewrite_ = canRewrite_ && source.children.size() == before.children.size();
  if (!canRewrite_) {
    return;
  }
  if (before.id != now.id || before.subTree != now.subTree) {
    const std::string margin = indentationOf(source.begin);
    result_ += textWithComments(now, false, margin).substr(margin.size());
    return;
  }
  writeStart(before, now, source);
  writeChildren(before, now, source);
}

void TreeRewriter::write(const TreeSpec& before, const TreeSpec& now, const SourceElement& source) {
  canRewrite_ = canRewrite_ && before.others == now.others && source.children.size() == 1;
  if (!canRewrite_) {
    return;
  }
  const SourceElement& root = source.children.front();
  result_ += part(source.begin, root.begin);
  write(before.root, now.root, root);
  result_ += part(root.end, source.end);
}

/// Returns the offset up to which the text is written.
Position TreeRewriter::writeMainTree(const std::string& before, const std::string& now,
                                     const SourceElement& root) {
  if (before == now) {
    return 0;
  }
  const std::string words = " main_tree_to_execute=\"" + escapedXml(now) + "\"";
  for (const SourceAttribute& attribute : root.attributes) {
    if (attribute.name == "main_tree_to_execute") {
      result_ += part(0, attribute.begin) + (now.empty() ? std::string() : words.substr(1));
      return attribute.end;
    }
  }
  const Position behindTag = root.begin + 1 + root.tag.size();
  result_ += part(0, behindTag) + words;
  return behindTag;
}

void TreeRewriter::findCommentsOfTrees(const TreeFile& before, const SourceElement& root) {
  std::size_t place = 0;
  for (const SourceElement& element : root.children) {
    const bool isTree = element.tag == "BehaviorTree";
    if (isTree && place < before.trees.size() && element.children.size() == 1) {
      findComments(before.trees[place].root, element.children.front(), element.body);
    }
    place += isTree ? 1 : 0;
  }
}

void TreeRewriter::writeNewTrees(const TreeFile& before, const TreeFile& now,
                                 const std::string& margin) {
  for (const TreeSpec& tree : now.trees) {
    if (before.find(tree.id) != nullptr) {
      continue;
    }
    std::string text = toXmlText(tree, catalogue_, margin);
    const std::string plain = toXmlText(tree.root, catalogue_, false, margin + "  ");
    const Position at = text.find(plain);
    if (at != text.npos) {
      text.replace(at, plain.size() - 1, textWithComments(tree.root, false, margin + "  "));
    }
    text.pop_back();
    result_ += "\n" + text;
  }
}

/// Removed trees are dropped together with the text before them; new trees follow the last one.
std::optional<std::string> TreeRewriter::rewrite(const TreeFile& before, const TreeFile& now) {
  const std::optional<SourceElement> root = SourceScanner(text_).root();
  const bool isSame =
      before.includes == now.includes && before.model == now.model && before.blocks == now.blocks;
  if (!root || !isSame || root->isClosed) {
    return std::nullopt;
  }
  findCommentsOfTrees(before, *root);
  std::size_t number = 0;
  Position from = writeMainTree(before.mainTree, now.mainTree, *root);
  for (const SourceElement& element : root->children) {
    if (element.tag != "BehaviorTree" || number >= before.trees.size()) {
      continue;
    }
    const TreeSpec& old = before.trees[number++];
    const TreeSpec* tree = now.find(old.id);
    if (tree != nullptr) {
      result_ += part(from, element.begin);
      write(old, *tree, element);
    }
    from = element.end;
    if (number == before.trees.size()) {
      writeNewTrees(before, now, indentationOf(element.begin));
    }
  }
  result_ += part(from, text_.size());
  return canRewrite_ && number == before.trees.size() ? std::optional(std::move(result_))
                                                      : std::nullopt;
}

}  // namespace

std::string rewriteTree(const std::string& before, const TreeFile& file,
                        const NodeCatalogue& catalogue) {
  if (const base::Result<TreeFile> old = readTreeText(before)) {
    if (*old == file) {
      return before;
    }
    if (std::optional<std::string> text = TreeRewriter(before, catalogue).rewrite(*old, file)) {
      const base::Result<TreeFile> again = readTreeText(*text);
      if (again && *again == file) {
        return *std::move(text);
      }
    }
  }
  return writeTree(file, catalogue);
}

}  // namespace bt
