#include <deque>
#include <iterator>
#include <map>
#include <utility>

#include "bt/tree/TreeXml.h"
#include "bt/tree/XmlText.h"

namespace bt {
namespace {

constexpr const char* kTreeTag = "BehaviorTree";

void append(Attributes& to, const Attributes& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Indents by two blanks per level. Children are written on separate lines. `isOpen`: an element
/// without children gets an end tag too.
void write(const XmlElement& block, std::size_t level, bool isOpen, std::string& text) {
  const std::string margin(2 * level, ' ');
  text += margin + "<" + block.tag;
  for (const Attribute& attribute : block.attributes) {
    text += " " + attribute.name + "=\"" + escapedXml(attribute.text) + "\"";
  }
  if (block.children.empty() && !isOpen) {
    text += block.text.empty() ? "/>\n" : ">" + escapedXml(block.text) + "</" + block.tag + ">\n";
    return;
  }
  text += ">" + escapedXml(block.text) + "\n";
  for (const XmlElement& child : block.children) {
    write(child, level + 1, child.tag == kTreeTag && level == 0, text);
  }
  text += margin + "</" + block.tag + ">\n";
}

XmlElement toXmlElement(const Include& include) {
  XmlElement block;
  block.tag = "include";
  if (!include.rosPackage.empty()) {
    block.attributes.push_back({"ros_pkg", include.rosPackage});
  }
  block.attributes.push_back({"path", include.path});
  return block;
}

/// Tag of the explicit notation. Readers do not check the kind, so a guess is sufficient for nodes
/// that are not in the catalogue.
std::string tagOf(const NodeSpec& node, const NodeCatalogue& catalogue) {
  if (const NodeManifest* const manifest = catalogue.find(node.id)) {
    return nodeKindName(manifest->kind);
  }
  const std::size_t children = node.children.size();
  return children == 0 ? "Action" : (children == 1 ? "Decorator" : "Control");
}

XmlElement toXmlElement(const NodeSpec& node, const NodeCatalogue& catalogue, bool compact) {
  const bool isExplicit = node.explicitNotation && !compact;
  XmlElement block;
  block.tag = isExplicit ? tagOf(node, catalogue) : node.id;
  const bool namesTree = !node.subTree.empty();  // also a SubTreePlus; the checks reject it later
  if (isExplicit || node.isSubTree() || namesTree) {
    block.attributes.push_back({"ID", node.isSubTree() || namesTree ? node.subTree : node.id});
  }
  append(block.attributes, attributesOf(node));
  for (const NodeSpec& child : node.children) {
    // BehaviorTree.CPP rejects the explicit notation for these children.
    block.children.push_back(toXmlElement(child, catalogue, node.id == "ReactiveSequence"));
  }
  return block;
}

XmlElement toXmlElement(const TreeSpec& tree, const NodeCatalogue& catalogue) {
  XmlElement block;
  block.tag = kTreeTag;
  block.attributes = {{"ID", tree.id}};
  append(block.attributes, tree.others);
  if (!tree.root.id.empty()) {
    block.children.push_back(toXmlElement(tree.root, catalogue, false));
  }
  return block;
}

/// The parts in file order, followed by those that the order does not list.
std::vector<XmlElement> partsOf(const TreeFile& file, const NodeCatalogue& catalogue) {
  std::map<FilePart, std::deque<XmlElement>> rest;
  if (file.model) {
    rest[FilePart::Model].push_back(*file.model);
  }
  for (const Include& include : file.includes) {
    rest[FilePart::Include].push_back(toXmlElement(include));
  }
  for (const TreeSpec& tree : file.trees) {
    rest[FilePart::Tree].push_back(toXmlElement(tree, catalogue));
  }
  rest[FilePart::Other].assign(file.blocks.begin(), file.blocks.end());
  std::vector<XmlElement> parts;
  for (const FilePart next : file.order) {
    if (!rest[next].empty()) {
      parts.push_back(std::move(rest[next].front()));
      rest[next].pop_front();
    }
  }
  for (auto& [kind, blocks] : rest) {
    std::move(blocks.begin(), blocks.end(), std::back_inserter(parts));
  }
  return parts;
}

XmlElement modelOfPort(const PortSpec& port) {
  XmlElement block;
  block.tag = portDirectionTag(port.direction);
  block.attributes.push_back({"name", port.key});
  const std::string type = portTypeName(port.portType);
  if (!type.empty()) {
    block.attributes.push_back({"type", type});
  }
  if (port.fallbackText()) {
    block.attributes.push_back({"default", *port.fallbackText()});
  }
  block.text = port.help;
  return block;
}

std::string indentLines(const XmlElement& block, const std::string& margin, bool isOpen) {
  std::string text;
  write(block, 0, isOpen, text);
  std::string moved;
  for (std::size_t at = 0; at < text.size();) {  // values contain no raw line breaks
    const std::size_t end = text.find('\n', at);
    moved += margin + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return moved;
}

}  // namespace

Attributes attributesOf(const NodeSpec& node) {
  Attributes all;
  if (!node.name.empty()) {
    all.push_back({"name", node.name});
  }
  append(all, node.ports);
  if (node.autoRemap) {
    all.push_back({"_autoremap", "true"});
  }
  append(all, node.conditions);
  append(all, node.others);
  return all;
}

std::string toXmlText(const NodeSpec& node, const NodeCatalogue& catalogue, bool compact,
                      const std::string& margin) {
  return indentLines(toXmlElement(node, catalogue, compact), margin, false);
}

std::string toXmlText(const TreeSpec& tree, const NodeCatalogue& catalogue,
                      const std::string& margin) {
  return indentLines(toXmlElement(tree, catalogue), margin, true);
}

std::string writeNode(const NodeSpec& node, const NodeCatalogue& catalogue) {
  return toXmlText(node, catalogue, false, {});
}

XmlElement modelOf(const NodeCatalogue& catalogue) {
  XmlElement model;
  model.tag = "TreeNodesModel";
  for (const NodeManifest& manifest : catalogue.all()) {
    if (manifest.origin == NodeOrigin::BehaviorTreeCpp) {
      continue;
    }
    XmlElement entry;
    entry.tag = nodeKindName(manifest.kind);
    entry.attributes.push_back({"ID", manifest.id});
    for (const PortSpec& port : manifest.ports) {
      entry.children.push_back(modelOfPort(port));
    }
    model.children.push_back(std::move(entry));
  }
  return model;
}

std::string writeTree(const TreeFile& file, const NodeCatalogue& catalogue) {
  XmlElement root;
  root.tag = "root";
  if (!file.mainTree.empty()) {
    root.attributes.push_back({"main_tree_to_execute", file.mainTree});
  }
  root.attributes.push_back({"BTCPP_format", "4"});
  root.children = partsOf(file, catalogue);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  write(root, 0, true, text);
  return text;
}

std::string writeModel(const NodeCatalogue& catalogue) {
  TreeFile file;
  file.model = modelOf(catalogue);
  return writeTree(file, catalogue);
}

}  // namespace bt
