#include <cctype>
#include <set>
#include <utility>

#include <tinyxml2.h>

#include "bt/tree/TextValue.h"
#include "bt/tree/TreeReader.h"
#include "bt/tree/TreeXml.h"
#include "bt/tree/TreeXmlV3.h"
#include "bt/tree/XmlText.h"

/// The part of the reader that reads nodes.
namespace bt {
namespace {

using tinyxml2::XMLElement;

bool isExplicitTag(const std::string& tag) {
  return tag == "Action" || tag == "Condition" || tag == "Control" || tag == "Decorator" ||
         tag == "SubTree" || tag == "SubTreePlus";
}

bool isSubTreeTag(const std::string& tag) {
  return tag == "SubTree" || tag == "SubTreePlus";
}

}  // namespace

NodeSpec TreeReader::readNode(const XMLElement& element, int depth) {
  NodeSpec node;
  node.line = element.GetLineNum();
  if (depth > kMaxNesting) {
    error(element, "tree.too-nested", {kMaxNesting});
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

void TreeReader::readIdentity(const XMLElement& element, NodeSpec& node) {
  const std::string tag = element.Name();
  const char* const id = element.Attribute("ID");
  const bool isExplicit = isExplicitTag(tag);
  if (isExplicit && (!id || *id == '\0')) {
    error(element, "tree.without-id", {tag});
  } else if (!isExplicit && id) {
    error(element, "tree.id-not-allowed", {tag});
  }
  if (isSubTreeTag(tag)) {
    node.id = tag;
    node.subTree = id ? id : "";
  } else {
    node.id = isExplicit && id ? id : tag;
    node.explicitNotation = isExplicit;
  }
  checkName(element, isSubTreeTag(tag) ? node.subTree : node.id, "node ID");
}

void TreeReader::readAttribute(const XMLElement& element, const Attribute& attribute,
                               NodeSpec& node) {
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
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    if (!seen.insert(a->Name()).second) {
      error(element, "tree.attribute-twice", {a->Name()});
    }
  }
}

void TreeReader::checkName(const XMLElement& element, const std::string& name, const char* what) {
  if (const char bad = forbiddenCharacter(name)) {
    error(element, "tree.bad-character", {what, name, std::string(1, bad)});
  }
}

}  // namespace bt
