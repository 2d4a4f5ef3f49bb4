#include "bt/tree/TreeXml.h"

#include <utility>

#include <tinyxml2.h>

#include "bt/tree/TreeReader.h"
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

}  // namespace

void TreeReader::error(const XMLElement& at, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::error(code, std::move(values), file_.path, at.GetLineNum()));
}

void TreeReader::warn(const XMLElement& at, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::warning(code, std::move(values), file_.path, at.GetLineNum()));
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
    file_.model = blockOf(element);
  } else {
    warn(element, "tree.unknown-element",
         {tag, base::nearestName(tag, {"BehaviorTree", "TreeNodesModel", "include"})});
    file_.order.push_back(FilePart::Other);
    file_.blocks.push_back(blockOf(element));
  }
}

void TreeReader::readInclude(const XMLElement& element) {
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
    error(element, "tree.include-without-path");
  }
  file_.includes.push_back(std::move(include));
}

void TreeReader::readTreeAttributes(const XMLElement& element, TreeSpec& tree) {
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    if (std::string(a->Name()) == "ID") {
      tree.id = a->Value();
    } else {
      tree.others.push_back({a->Name(), a->Value()});
    }
  }
}

void TreeReader::readTree(const XMLElement& element, bool needsId) {
  checkAttributes(element);
  TreeSpec tree;
  tree.line = element.GetLineNum();
  readTreeAttributes(element, tree);
  if (tree.id.empty() && needsId) {
    error(element, "tree.without-id", {element.Name()});
  } else if (tree.id.empty()) {
    tree.id = file_.mainTree.empty() ? "BehaviorTree" : file_.mainTree;
  } else {
    checkName(element, tree.id, "tree ID");
  }
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
      file_.templateLine = text->GetLineNum();
    }
  }
}

base::Result<TreeFile> readTreeText(std::string_view xml, const std::string& fileName) {
  if (const std::optional<base::Diagnostic> bad = problemOfText(xml, fileName)) {
    return *bad;
  }
  int bareAmpersand = 0;
  const std::string text = withEscapedAmpersands(xml, bareAmpersand);
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    return base::error("tree.not-xml", {messageOfXmlError(document.ErrorID())}, fileName,
                       document.ErrorLineNum());
  }
  const XMLElement* const root = document.RootElement();
  if (!root) {
    return base::error("tree.no-element", {}, fileName, 1);
  }
  TreeReader reader(fileName);
  if (bareAmpersand > 0) {
    reader.problems().push_back(base::warning("tree.bare-ampersand", {}, fileName, bareAmpersand));
  }
  reader.readRoot(*root);
  if (const XMLElement* const second = root->NextSiblingElement()) {
    reader.problems().push_back(
        base::error("tree.second-root", {second->Name()}, fileName, second->GetLineNum()));
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
