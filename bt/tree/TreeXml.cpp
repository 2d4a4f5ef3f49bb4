#include "bt/tree/TreeXml.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <set>
#include <utility>

#include <tinyxml2.h>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/XmlText.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kTemplateText = "{GOAL_SEQUENCE}";

int childCount(const XMLElement& element) {
  int count = 0;
  for (const XMLElement* c = element.FirstChildElement(); c; c = c->NextSiblingElement()) {
    ++count;
  }
  return count;
}

std::string ownText(const XMLElement& element) {
  std::string text;
  for (const tinyxml2::XMLNode* n = element.FirstChild(); n; n = n->NextSibling()) {
    if (const tinyxml2::XMLText* const part = n->ToText()) {
      text += part->Value();
    }
  }
  return base::trimmed(text);
}

Attributes attributesOf(const XMLElement& element) {
  Attributes attributes;
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    attributes.push_back({a->Name(), a->Value()});
  }
  return attributes;
}

bool isSubTreeTag(const std::string& tag) {
  return tag == "SubTree" || tag == "SubTreePlus";
}

/// A parsed piece of a file.
struct ParsedChunk {
  XmlChunk source;
  tinyxml2::XMLDocument document;
  std::vector<const XMLElement*> elements;
  const ParsedChunk* next = nullptr;
};

const ParsedChunk& chunkOf(const tinyxml2::XMLNode& node) {
  return *static_cast<const ParsedChunk*>(node.GetDocument()->GetUserData());
}

int lineOf(const tinyxml2::XMLNode& node) {
  return chunkOf(node).source.lineInFile(node.GetLineNum());
}

/// The element that a placeholder element stands for, or the element itself.
const XMLElement& placed(const XMLElement& element) {
  const ParsedChunk* const next = chunkOf(element).next;
  if (next == nullptr || std::string(element.Name()) != kChunkTag) {
    return element;
  }
  const std::size_t number = element.UnsignedAttribute("n");
  return number < next->elements.size() ? *next->elements[number] : element;
}

/// Returns the first error, if any.
std::optional<base::Diagnostic> parseChunks(std::string_view text, const std::string& fileName,
                                            std::deque<ParsedChunk>& pieces) {
  for (XmlChunk& source : splitByDepth(text)) {
    ParsedChunk& piece = pieces.emplace_back();
    piece.source = std::move(source);
    tinyxml2::XMLDocument& document = piece.document;
    document.SetUserData(&piece);
    const std::string& its = piece.source.text;
    if (document.Parse(its.data(), its.size()) != tinyxml2::XML_SUCCESS) {
      return base::error("tree.not-xml", {messageOfXmlError(document.ErrorID())}, fileName,
                         piece.source.lineInFile(document.ErrorLineNum()));
    }
    if (!document.RootElement()) {
      return base::error("tree.no-element", {}, fileName, 1);
    }
    for (const XMLElement* e = document.RootElement(); e; e = e->NextSiblingElement()) {
      piece.elements.push_back(e);
    }
    if (pieces.size() > 1) {
      pieces[pieces.size() - 2].next = &piece;
    }
  }
  return std::nullopt;
}

/// Converts the elements of one document to a TreeFile and collects all problems.
class TreeReader {
 public:
  explicit TreeReader(const std::string& fileName) { file_.path = fileName; }

  void readRoot(const XMLElement& root);
  TreeFile takeFile() { return std::move(file_); }
  base::Diagnostics& problems() { return problems_; }

 private:
  void error(const XMLElement& at, std::string_view code, base::ProblemValues values = {});
  void warn(const XMLElement& at, std::string_view code, base::ProblemValues values = {});
  void readFormat(const XMLElement& root);
  void readPart(const XMLElement& element, bool needsId);
  XmlElement readBlock(const XMLElement& element, int depth);
  void readInclude(const XMLElement& element);
  void readTree(const XMLElement& element, bool needsId);
  NodeSpec readNode(const XMLElement& element, int depth);
  void readIdentity(const XMLElement& element, NodeSpec& node);
  void readAttribute(const XMLElement& element, const Attribute& attribute, NodeSpec& node);
  void checkAttributes(const XMLElement& element);
  void checkName(const XMLElement& element, const std::string& name, const char* what);
  void lookForTemplate(const XMLElement& element);

  TreeFile file_;
  base::Diagnostics problems_;
};

void TreeReader::error(const XMLElement& at, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::error(code, std::move(values), file_.path, lineOf(at)));
}

void TreeReader::warn(const XMLElement& at, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::warning(code, std::move(values), file_.path, lineOf(at)));
}

void TreeReader::readRoot(const XMLElement& root) {
  if (std::string(root.Name()) != "root") {
    error(root, "tree.not-root", {root.Name()});
    return;
  }
  checkAttributes(root);
  readFormat(root);
  if (const char* const main = root.Attribute("main_tree_to_execute")) {
    file_.mainTree = main;
  }
  const bool several = childCount(root) > 1;
  lookForTemplate(root);
  for (const XMLElement* c = root.FirstChildElement(); c; c = c->NextSiblingElement()) {
    readPart(*c, several);
  }
  if (file_.trees.empty() && file_.includes.empty() && !file_.model) {
    error(root, "tree.no-tree");
  }
}

void TreeReader::readFormat(const XMLElement& root) {
  const char* const format = root.Attribute("BTCPP_format");
  if (!format) {
    file_.format = 3;
    warn(root, "tree.no-format");
  } else if (std::string(format) == "3") {
    file_.format = 3;
  } else if (std::string(format) != "4") {
    warn(root, "tree.unknown-format", {format});
  }
}

void TreeReader::readPart(const XMLElement& element, bool needsId) {
  const std::string tag = element.Name();
  if (tag == "BehaviorTree") {
    file_.order.push_back(FilePart::Tree);
    readTree(element, needsId);
  } else if (tag == "include") {
    file_.order.push_back(FilePart::Include);
    readInclude(element);
  } else if (tag == "TreeNodesModel") {
    if (file_.model) {
      error(element, "tree.second-model");
      return;
    }
    file_.order.push_back(FilePart::Model);
    file_.model = readBlock(element, 1);
  } else {
    warn(element, "tree.unknown-element",
         {tag, base::nearestName(tag, {"BehaviorTree", "TreeNodesModel", "include"})});
    file_.order.push_back(FilePart::Other);
    file_.blocks.push_back(readBlock(element, 1));
  }
}

XmlElement TreeReader::readBlock(const XMLElement& element, int depth) {
  XmlElement block;
  if (depth > kMaxNesting) {
    error(element, "tree.too-nested", {kMaxNesting});
    return block;
  }
  block.tag = element.Name();
  block.text = ownText(element);
  block.attributes = attributesOf(element);
  for (const XMLElement* c = element.FirstChildElement(); c; c = c->NextSiblingElement()) {
    block.children.push_back(readBlock(placed(*c), depth + 1));
  }
  return block;
}

void TreeReader::readInclude(const XMLElement& element) {
  checkAttributes(element);
  Include include;
  include.line = lineOf(element);
  if (const char* const path = element.Attribute("path")) {
    include.path = path;
  }
  if (const char* const package = element.Attribute("ros_pkg")) {
    include.rosPackage = package;
  }
  if (include.path.empty()) {
    error(element, "tree.include-without-path");
  }
  file_.includes.push_back(std::move(include));
}

void TreeReader::readTree(const XMLElement& element, bool needsId) {
  checkAttributes(element);
  TreeSpec tree;
  tree.line = lineOf(element);
  tree.others = attributesOf(element);
  if (const std::string* const id = findAttribute(tree.others, "ID")) {
    tree.id = *id;
    removeAttribute(tree.others, "ID");
  }
  if (tree.id.empty() && needsId) {
    error(element, "tree.without-id", {element.Name()});
  } else if (tree.id.empty()) {
    tree.id = file_.mainTree.empty() ? "BehaviorTree" : file_.mainTree;
  }
  checkName(element, tree.id, "tree ID");
  const int children = childCount(element);
  if (children != 1) {
    error(element, "tree.root-nodes", {tree.id, children});
  }
  lookForTemplate(element);
  if (const XMLElement* const root = element.FirstChildElement()) {
    tree.root = readNode(*root, 1);
  }
  if (!tree.id.empty() && file_.find(tree.id)) {
    error(element, "tree.id-twice", {tree.id});
  }
  file_.trees.push_back(std::move(tree));
}

void TreeReader::lookForTemplate(const XMLElement& element) {
  for (const tinyxml2::XMLNode* n = element.FirstChild(); n; n = n->NextSibling()) {
    const tinyxml2::XMLText* const text = n->ToText();
    if (text && file_.templateLine == 0 &&
        std::string(text->Value()).find(kTemplateText) != std::string::npos) {
      file_.templateLine = lineOf(*text);
    }
  }
}

NodeSpec TreeReader::readNode(const XMLElement& element, int depth) {
  NodeSpec node;
  node.line = lineOf(element);
  if (depth > kMaxNesting) {
    error(element, "tree.too-nested", {kMaxNesting});
    return node;
  }
  checkAttributes(element);
  readIdentity(element, node);
  for (const Attribute& attribute : attributesOf(element)) {
    readAttribute(element, attribute, node);
  }
  lookForTemplate(element);
  for (const XMLElement* c = element.FirstChildElement(); c; c = c->NextSiblingElement()) {
    node.children.push_back(readNode(placed(*c), depth + 1));
  }
  if (file_.format == 3) {
    convertFromVersion3(node, file_.path, problems_);
  }
  return node;
}

void TreeReader::readIdentity(const XMLElement& element, NodeSpec& node) {
  const std::string tag = element.Name();
  const char* const id = element.Attribute("ID");
  const bool isSubTree = isSubTreeTag(tag);
  const bool isExplicit =
      isSubTree || tag == "Action" || tag == "Condition" || tag == "Control" || tag == "Decorator";
  if (isExplicit && (!id || *id == '\0')) {
    error(element, "tree.without-id", {tag});
  } else if (!isExplicit && id) {
    error(element, "tree.id-not-allowed", {tag});
  }
  if (isSubTree) {
    node.id = tag;
    node.subTree = id ? id : "";
  } else {
    node.id = isExplicit && id ? id : tag;
    node.explicitNotation = isExplicit;
  }
  checkName(element, isSubTree ? node.subTree : node.id, "node ID");
}

void TreeReader::readAttribute(const XMLElement& element, const Attribute& attribute,
                               NodeSpec& node) {
  const std::string& name = attribute.name;
  if (name == "ID") {
    return;
  }
  if (name == "name") {
    node.name = attribute.text;
  } else if (std::find(kConditionNames.begin(), kConditionNames.end(), name) !=
             kConditionNames.end()) {
    node.conditions.push_back(attribute);
  } else if (name == "_autoremap" && isSubTreeTag(element.Name())) {
    const std::optional<bool> value = boolFromText(attribute.text);
    if (!value) {
      error(element, "tree.not-boolean", {attribute.text});
    }
    node.autoRemap = value.value_or(false);
  } else if (std::isalpha(static_cast<unsigned char>(name[0])) == 0) {
    node.others.push_back(attribute);
  } else {
    checkName(element, name, "port name");
    node.ports.push_back(attribute);
  }
}

void TreeReader::checkAttributes(const XMLElement& element) {
  std::set<std::string> seen;
  for (const Attribute& attribute : attributesOf(element)) {
    if (!seen.insert(attribute.name).second) {
      error(element, "tree.attribute-twice", {attribute.name});
    }
  }
}

void TreeReader::checkName(const XMLElement& element, const std::string& name, const char* what) {
  if (const char bad = forbiddenCharacter(name)) {
    error(element, "tree.bad-character", {what, name, std::string(1, bad)});
  }
}

}  // namespace

base::Result<TreeFile> readTreeText(std::string_view xml, const std::string& fileName) {
  if (const std::optional<base::Diagnostic> bad = encodingProblem(xml, fileName)) {
    return *bad;
  }
  int bareAmpersand = 0;
  const std::string text = withEscapedAmpersands(xml, bareAmpersand);
  std::deque<ParsedChunk> pieces;  // a deque keeps the addresses valid
  if (const std::optional<base::Diagnostic> bad = parseChunks(text, fileName, pieces)) {
    return *bad;
  }
  const XMLElement* const root = pieces.front().document.RootElement();
  TreeReader reader(fileName);
  if (bareAmpersand > 0) {
    reader.problems().push_back(base::warning("tree.bare-ampersand", {}, fileName, bareAmpersand));
  }
  reader.readRoot(*root);
  if (const XMLElement* const second = root->NextSiblingElement()) {
    reader.problems().push_back(
        base::error("tree.second-root", {second->Name()}, fileName, lineOf(*second)));
  }
  if (base::hasErrors(reader.problems())) {
    return reader.problems();
  }
  return {reader.takeFile(), reader.problems()};
}

base::Result<TreeFile> readTree(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  return readTreeText(*text, path);
}

}  // namespace bt
