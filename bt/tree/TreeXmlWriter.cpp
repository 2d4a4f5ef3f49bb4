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

/// Two blanks per level. An element with children has them on lines of their own; `isOpen`: also
/// one without.
void write(const XmlBlock& block, std::size_t level, bool isOpen, std::string& text) {
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
  for (const XmlBlock& child : block.children) {
    write(child, level + 1, child.tag == kTreeTag && level == 0, text);
  }
  text += margin + "</" + block.tag + ">\n";
}

XmlBlock blockOf(const Include& include) {
  XmlBlock block;
  block.tag = "include";
  if (!include.rosPackage.empty()) {
    block.attributes.push_back({"ros_pkg", include.rosPackage});
  }
  block.attributes.push_back({"path", include.path});
  return block;
}

/// Tag of the explicit notation. Readers do not check the kind, so a guess is good enough for nodes
/// that nobody knows.
std::string tagOf(const NodeSpec& node, const NodeCatalogue& catalogue) {
  if (const NodeManifest* const manifest = catalogue.find(node.id)) {
    return nodeKindName(manifest->kind);
  }
  const std::size_t children = node.children.size();
  return children == 0 ? "Action" : (children == 1 ? "Decorator" : "Control");
}

XmlBlock blockOf(const NodeSpec& node, const NodeCatalogue& catalogue, bool compact) {
  const bool isExplicit = node.explicitNotation && !compact;
  XmlBlock block;
  block.tag = isExplicit ? tagOf(node, catalogue) : node.id;
  const bool namesTree = !node.subTree.empty();  // also a SubTreePlus, which checks refuse later
  if (isExplicit || node.isSubTree() || namesTree) {
    block.attributes.push_back({"ID", node.isSubTree() || namesTree ? node.subTree : node.id});
  }
  if (!node.name.empty()) {
    block.attributes.push_back({"name", node.name});
  }
  append(block.attributes, node.ports);
  if (node.autoRemap) {
    block.attributes.push_back({"_autoremap", "true"});
  }
  append(block.attributes, node.conditions);
  append(block.attributes, node.others);
  for (const NodeSpec& child : node.children) {
    // The original engine refuses explicit children there.
    block.children.push_back(blockOf(child, catalogue, node.id == "ReactiveSequence"));
  }
  return block;
}

XmlBlock blockOf(const TreeSpec& tree, const NodeCatalogue& catalogue) {
  XmlBlock block;
  block.tag = kTreeTag;
  block.attributes = {{"ID", tree.id}};
  append(block.attributes, tree.others);
  if (!tree.root.id.empty()) {
    block.children.push_back(blockOf(tree.root, catalogue, false));
  }
  return block;
}

/// The parts in the order of the file, then those that it does not name.
std::vector<XmlBlock> partsOf(const TreeFile& file, const NodeCatalogue& catalogue) {
  std::map<FilePart, std::deque<XmlBlock>> rest;
  if (file.model) {
    rest[FilePart::Model].push_back(*file.model);
  }
  for (const Include& include : file.includes) {
    rest[FilePart::Include].push_back(blockOf(include));
  }
  for (const TreeSpec& tree : file.trees) {
    rest[FilePart::Tree].push_back(blockOf(tree, catalogue));
  }
  rest[FilePart::Other].assign(file.blocks.begin(), file.blocks.end());
  std::vector<XmlBlock> parts;
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

XmlBlock modelOfPort(const PortSpec& port) {
  XmlBlock block;
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

std::string behindMargin(const XmlBlock& block, const std::string& margin, bool isOpen) {
  std::string text;
  write(block, 0, isOpen, text);
  std::string moved;
  for (std::size_t at = 0; at < text.size();) {  // line breaks in values are written as references
    const std::size_t end = text.find('\n', at);
    moved += margin + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return moved;
}

}  // namespace

std::string textOf(const NodeSpec& node, const NodeCatalogue& catalogue, bool compact,
                   const std::string& margin) {
  return behindMargin(blockOf(node, catalogue, compact), margin, false);
}

std::string textOf(const TreeSpec& tree, const NodeCatalogue& catalogue,
                   const std::string& margin) {
  return behindMargin(blockOf(tree, catalogue), margin, true);
}

std::string writeNode(const NodeSpec& node, const NodeCatalogue& catalogue) {
  return textOf(node, catalogue, false, {});
}

XmlBlock modelOf(const NodeCatalogue& catalogue) {
  XmlBlock model;
  model.tag = "TreeNodesModel";
  for (const NodeManifest& manifest : catalogue.all()) {
    if (manifest.origin == NodeOrigin::BehaviorTreeCpp) {
      continue;
    }
    XmlBlock entry;
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
  XmlBlock root;
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
