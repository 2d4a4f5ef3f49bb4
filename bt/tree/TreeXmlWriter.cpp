#include <algorithm>
#include <utility>

#include "bt/tree/TreeXml.h"
#include "bt/tree/XmlText.h"

namespace bt {
namespace {

/// Appends elements with two blanks per level.
class Writer {
 public:
  explicit Writer(const NodeCatalogue& catalogue) : catalogue_(catalogue) {
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  }

  std::string file(const TreeFile& file);

 private:
  void open(const std::string& tag, const Attributes& attributes) {
    text_.append(2 * level_, ' ');
    text_ += "<" + tag;
    for (const Attribute& attribute : attributes) {
      text_ += " " + attribute.name + "=\"" + escapedXml(attribute.text) + "\"";
    }
  }
  void close(const std::string& tag) {
    text_.append(2 * level_, ' ');
    text_ += "</" + tag + ">\n";
  }
  void include(const Include& include);
  void tree(const TreeSpec& tree);
  void node(const NodeSpec& node, bool compact);
  void block(const XmlBlock& block);
  void part(const TreeFile& file, FilePart part);
  std::string tagOf(const NodeSpec& node) const;

  const NodeCatalogue& catalogue_;
  std::string text_;
  std::size_t level_ = 0;
  std::size_t nextInclude_ = 0;
  std::size_t nextTree_ = 0;
  std::size_t nextBlock_ = 0;
  bool modelDone_ = false;
};

void Writer::include(const Include& include) {
  Attributes attributes;
  if (!include.rosPackage.empty()) {
    attributes.push_back({"ros_pkg", include.rosPackage});
  }
  attributes.push_back({"path", include.path});
  open("include", attributes);
  text_ += "/>\n";
}

void Writer::tree(const TreeSpec& tree) {
  Attributes attributes = {{"ID", tree.id}};
  attributes.insert(attributes.end(), tree.others.begin(), tree.others.end());
  open("BehaviorTree", attributes);
  text_ += ">\n";
  ++level_;
  if (!tree.root.id.empty()) {
    node(tree.root, false);
  }
  --level_;
  close("BehaviorTree");
}

/// Tag of the explicit notation. Readers do not check the kind, so a guess is good enough for nodes
/// that nobody knows.
std::string Writer::tagOf(const NodeSpec& node) const {
  if (const NodeManifest* const manifest = catalogue_.find(node.id)) {
    return nodeKindName(manifest->kind);
  }
  const std::size_t children = node.children.size();
  return children == 0 ? "Action" : (children == 1 ? "Decorator" : "Control");
}

void Writer::node(const NodeSpec& node, bool compact) {
  const bool isExplicit = node.explicitNotation && !compact;
  const std::string tag = isExplicit ? tagOf(node) : node.id;
  Attributes attributes;
  const bool namesTree = !node.subTree.empty();  // also a SubTreePlus, which checks refuse later
  if (isExplicit || node.isSubTree() || namesTree) {
    attributes.push_back({"ID", node.isSubTree() || namesTree ? node.subTree : node.id});
  }
  if (!node.name.empty()) {
    attributes.push_back({"name", node.name});
  }
  attributes.insert(attributes.end(), node.ports.begin(), node.ports.end());
  if (node.autoRemap) {
    attributes.push_back({"_autoremap", "true"});
  }
  attributes.insert(attributes.end(), node.conditions.begin(), node.conditions.end());
  attributes.insert(attributes.end(), node.others.begin(), node.others.end());
  open(tag, attributes);
  if (node.children.empty()) {
    text_ += "/>\n";
    return;
  }
  text_ += ">\n";
  ++level_;
  for (const NodeSpec& child : node.children) {
    // The original engine refuses explicit children there.
    this->node(child, node.id == "ReactiveSequence");
  }
  --level_;
  close(tag);
}

void Writer::block(const XmlBlock& block) {
  open(block.tag, block.attributes);
  if (block.children.empty()) {
    text_ += block.text.empty() ? "/>\n" : ">" + escapedXml(block.text) + "</" + block.tag + ">\n";
    return;
  }
  text_ += ">" + escapedXml(block.text) + "\n";
  ++level_;
  for (const XmlBlock& child : block.children) {
    this->block(child);
  }
  --level_;
  close(block.tag);
}

void Writer::part(const TreeFile& file, FilePart part) {
  if (part == FilePart::Model && file.model && !modelDone_) {
    block(*file.model);
    modelDone_ = true;
  } else if (part == FilePart::Include && nextInclude_ < file.includes.size()) {
    include(file.includes[nextInclude_++]);
  } else if (part == FilePart::Tree && nextTree_ < file.trees.size()) {
    tree(file.trees[nextTree_++]);
  } else if (part == FilePart::Other && nextBlock_ < file.blocks.size()) {
    block(file.blocks[nextBlock_++]);
  }
}

std::string Writer::file(const TreeFile& file) {
  Attributes attributes;
  if (!file.mainTree.empty()) {
    attributes.push_back({"main_tree_to_execute", file.mainTree});
  }
  attributes.push_back({"BTCPP_format", "4"});
  open("root", attributes);
  text_ += ">\n";
  ++level_;
  std::vector<FilePart> parts = file.order;
  parts.push_back(FilePart::Model);
  parts.insert(parts.end(), file.includes.size(), FilePart::Include);
  parts.insert(parts.end(), file.trees.size(), FilePart::Tree);
  parts.insert(parts.end(), file.blocks.size(), FilePart::Other);
  for (const FilePart next : parts) {
    part(file, next);
  }
  --level_;
  close("root");
  return std::move(text_);
}

XmlBlock modelOfPort(const PortSpec& port) {
  XmlBlock block;
  block.tag = portDirectionTag(port.direction);
  block.attributes.push_back({"name", port.name});
  const std::string type = portTypeName(port.type);
  if (!type.empty()) {
    block.attributes.push_back({"type", type});
  }
  if (port.defaultText) {
    block.attributes.push_back({"default", *port.defaultText});
  }
  block.text = port.description;
  return block;
}

}  // namespace

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
  return Writer(catalogue).file(file);
}

std::string writeModel(const NodeCatalogue& catalogue) {
  TreeFile file;
  file.model = modelOf(catalogue);
  return writeTree(file, catalogue);
}

}  // namespace bt
