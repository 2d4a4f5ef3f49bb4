#include "bt/tree/TreeXml.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include <tinyxml2.h>

#include "bt/tree/TextValue.h"
#include "bt/tree/TreeXmlV3.h"
#include "bt/tree/XmlText.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kTemplateText = "{GOAL_SEQUENCE}";

bool isExplicitTag(const std::string& tag) {
  return tag == "Action" || tag == "Condition" || tag == "Control" || tag == "Decorator" ||
         tag == "SubTree" || tag == "SubTreePlus";
}

bool isSubTreeTag(const std::string& tag) {
  return tag == "SubTree" || tag == "SubTreePlus";
}

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

XmlBlock blockOf(const XMLElement& element) {
  XmlBlock block;
  block.tag = element.Name();
  block.text = ownText(element);
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    block.attributes.push_back({a->Name(), a->Value()});
  }
  for (const XMLElement* c = element.FirstChildElement(); c; c = c->NextSiblingElement()) {
    block.children.push_back(blockOf(*c));
  }
  return block;
}

/// Turns the elements of one document into a TreeFile and gathers every problem on the way.
class Reader {
 public:
  explicit Reader(const std::string& fileName) { file_.path = fileName; }

  void readRoot(const XMLElement& root);
  TreeFile takeFile() { return std::move(file_); }
  base::Diagnostics& problems() { return problems_; }

 private:
  void error(const XMLElement& at, std::string message) {
    problems_.push_back(base::makeError(std::move(message), file_.path, at.GetLineNum()));
  }
  void warn(const XMLElement& at, std::string message) {
    problems_.push_back(base::makeWarning(std::move(message), file_.path, at.GetLineNum()));
  }
  void readFormat(const XMLElement& root);
  void readPart(const XMLElement& element, bool needsId);
  void readInclude(const XMLElement& element);
  void readTree(const XMLElement& element, bool needsId);
  void readTreeAttributes(const XMLElement& element, TreeSpec& tree);
  NodeSpec readNode(const XMLElement& element, int depth);
  void readIdentity(const XMLElement& element, NodeSpec& node);
  void readAttribute(const XMLElement& element, const Attribute& attribute, NodeSpec& node);
  void checkAttributes(const XMLElement& element);
  void checkName(const XMLElement& element, const std::string& name, const char* what);
  void lookForTemplate(const XMLElement& element);

  TreeFile file_;
  base::Diagnostics problems_;
};

void Reader::readRoot(const XMLElement& root) {
  if (std::string(root.Name()) != "root") {
    error(root, "the document element is <" + std::string(root.Name()) + ">, not <root>");
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
    error(root, "the file holds no <BehaviorTree>");
  }
}

void Reader::readFormat(const XMLElement& root) {
  const char* const format = root.Attribute("BTCPP_format");
  if (!format) {
    file_.format = 3;
    warn(root, "BTCPP_format is missing (read as 4, with the conversions for format 3)");
  } else if (std::string(format) == "3") {
    file_.format = 3;
  } else if (std::string(format) != "4") {
    warn(root, "BTCPP_format '" + std::string(format) + "' is unknown (read as 4)");
  }
}

void Reader::readPart(const XMLElement& element, bool needsId) {
  const std::string tag = element.Name();
  if (tag == "BehaviorTree") {
    file_.order.push_back(FilePart::Tree);
    readTree(element, needsId);
  } else if (tag == "include") {
    file_.order.push_back(FilePart::Include);
    readInclude(element);
  } else if (tag == "TreeNodesModel") {
    if (file_.model) {
      error(element, "a second <TreeNodesModel>");
      return;
    }
    file_.order.push_back(FilePart::Model);
    file_.model = blockOf(element);
  } else {
    const std::optional<std::string> near =
        base::nearestName(tag, {"BehaviorTree", "TreeNodesModel", "include"});
    warn(element, "element <" + tag + "> below <root> is not known" +
                      (near ? " (did you mean <" + *near + ">?)" : std::string()));
    file_.order.push_back(FilePart::Other);
    file_.blocks.push_back(blockOf(element));
  }
}

void Reader::readInclude(const XMLElement& element) {
  checkAttributes(element);
  Include include;
  include.line = element.GetLineNum();
  if (const char* const path = element.Attribute("path")) {
    include.path = path;
  }
  if (const char* const package = element.Attribute("ros_pkg")) {
    include.rosPackage = package;
  }
  if (include.path.empty()) {
    error(element, "<include> without path");
  }
  file_.includes.push_back(std::move(include));
}

void Reader::readTreeAttributes(const XMLElement& element, TreeSpec& tree) {
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    if (std::string(a->Name()) == "ID") {
      tree.id = a->Value();
    } else {
      tree.others.push_back({a->Name(), a->Value()});
    }
  }
}

void Reader::readTree(const XMLElement& element, bool needsId) {
  checkAttributes(element);
  TreeSpec tree;
  tree.line = element.GetLineNum();
  readTreeAttributes(element, tree);
  if (tree.id.empty() && needsId) {
    error(element, "<BehaviorTree> without ID");
  } else if (tree.id.empty()) {
    tree.id = file_.mainTree.empty() ? "BehaviorTree" : file_.mainTree;
  } else {
    checkName(element, tree.id, "tree ID");
  }
  const int children = childCount(element);
  if (children != 1) {
    error(element, "tree '" + tree.id + "' has " + std::to_string(children) +
                       " root nodes (exactly one is needed)");
  }
  lookForTemplate(element);
  if (const XMLElement* const root = element.FirstChildElement()) {
    tree.root = readNode(*root, 1);
  }
  if (!tree.id.empty() && file_.find(tree.id)) {
    error(element, "tree ID '" + tree.id + "' is used twice in this file");
  }
  file_.trees.push_back(std::move(tree));
}

NodeSpec Reader::readNode(const XMLElement& element, int depth) {
  NodeSpec node;
  node.line = element.GetLineNum();
  if (depth > kMaxNesting) {
    error(element,
          "nodes are nested deeper than " + std::to_string(kMaxNesting) + " (use SubTrees)");
    return node;
  }
  checkAttributes(element);
  readIdentity(element, node);
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    readAttribute(element, {a->Name(), a->Value()}, node);
  }
  lookForTemplate(element);
  for (const XMLElement* c = element.FirstChildElement(); c; c = c->NextSiblingElement()) {
    node.children.push_back(readNode(*c, depth + 1));
  }
  if (file_.format == 3) {
    convertFromVersion3(node, file_.path, problems_);
  }
  return node;
}

void Reader::readIdentity(const XMLElement& element, NodeSpec& node) {
  const std::string tag = element.Name();
  const char* const id = element.Attribute("ID");
  const bool isExplicit = isExplicitTag(tag);
  if (isExplicit && (!id || *id == '\0')) {
    error(element, "<" + tag + "> without ID");
  } else if (!isExplicit && id) {
    error(element, "<" + tag +
                       "> must not have an ID (only <Action>, <Condition>, <Control>, "
                       "<Decorator> and <SubTree> have one)");
  }
  if (isSubTreeTag(tag)) {
    node.id = tag;
    node.subTree = id ? id : "";
  } else {
    node.id = isExplicit && id ? id : tag;
    node.explicitNotation = isExplicit;
  }
  checkName(element, node.isSubTree() ? node.subTree : node.id, "node ID");
}

void Reader::readAttribute(const XMLElement& element, const Attribute& attribute, NodeSpec& node) {
  const std::string& name = attribute.name;
  if (name == "ID") {
    return;
  }
  if (name == "name") {
    node.name = attribute.text;
  } else if (isConditionName(name)) {
    node.conditions.push_back(attribute);
  } else if (name == "_autoremap" && isSubTreeTag(element.Name())) {
    const std::optional<bool> value = boolFromText(attribute.text);
    if (!value) {
      error(element, "_autoremap is '" + attribute.text + "', not true or false");
    }
    node.autoRemap = value.value_or(false);
  } else if (std::isalpha(static_cast<unsigned char>(name[0])) == 0) {
    node.others.push_back(attribute);
  } else {
    checkName(element, name, "port name");
    node.ports.push_back(attribute);
  }
}

void Reader::checkAttributes(const XMLElement& element) {
  std::set<std::string> seen;
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    if (!seen.insert(a->Name()).second) {
      error(element, "attribute '" + std::string(a->Name()) + "' is given twice");
    }
  }
}

void Reader::checkName(const XMLElement& element, const std::string& name, const char* what) {
  if (const char bad = forbiddenCharacter(name)) {
    error(element, std::string(what) + " '" + name + "' holds the character '" + bad +
                       "', which is not allowed there");
  }
}

void Reader::lookForTemplate(const XMLElement& element) {
  for (const tinyxml2::XMLNode* n = element.FirstChild(); n; n = n->NextSibling()) {
    const tinyxml2::XMLText* const text = n->ToText();
    if (text && file_.templateLine == 0 &&
        std::string(text->Value()).find(kTemplateText) != std::string::npos) {
      file_.templateLine = text->GetLineNum();
    }
  }
}

/// Anything behind the document element except comments, or several of them.
const XMLElement* secondRoot(const XMLElement& root) {
  return root.NextSiblingElement();
}

}  // namespace

base::Result<TreeFile> readTreeText(std::string_view xml, const std::string& fileName) {
  if (const std::optional<base::Diagnostic> bad = problemOfText(xml, fileName)) {
    return *bad;
  }
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS) {
    return base::makeError(messageOfXmlError(document.ErrorID()), fileName,
                           document.ErrorLineNum());
  }
  const XMLElement* const root = document.RootElement();
  if (!root) {
    return base::makeError("the file holds no element", fileName, 1);
  }
  Reader reader(fileName);
  reader.readRoot(*root);
  if (const XMLElement* const second = secondRoot(*root)) {
    reader.problems().push_back(
        base::makeError("a second document element <" + std::string(second->Name()) + ">", fileName,
                        second->GetLineNum()));
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
