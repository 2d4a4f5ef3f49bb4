#include "app/bridge/groot/WatchedTree.h"

#include <utility>

#include "bt/engine/Program.h"
#include "bt/human/HumanNodes.h"
#include "bt/tree/TreeXml.h"

namespace groot {

namespace {

class Numbering {
 public:
  explicit Numbering(const bt::TreeTable& table) : table_(table) {}

  WatchedTree make() {
    file_.mainTree = table_.mainTree;
    if (const bt::TreeTable::Entry* main = table_.find(table_.mainTree)) {
      addPart(*main, {}, {}, {});
    }
    const bt::NodeLibrary library = bt::humanNodes();
    addAliases(library);
    const bt::NodeCatalogue& catalogue = library.catalogue();
    file_.model = bt::modelOf(catalogue);
    file_.order.assign(file_.trees.size(), bt::FilePart::Tree);
    file_.order.push_back(bt::FilePart::Model);
    watched_.xml = bt::writeTree(file_, catalogue);
    return std::move(watched_);
  }

 private:
  void addAliases(const bt::NodeLibrary& library) {
    const auto program = bt::compile(table_, library);
    if (!program) {
      return;
    }
    for (const bt::Program::Entry& alias : (*program)->aliases()) {
      watched_.aliases.emplace_back(alias.key, (*program)->keyOf(alias.slot));
    }
  }

  /// `path`: of the node that stands for it; empty: it is the main tree.
  void addPart(const bt::TreeTable::Entry& entry, const std::string& fullPath,
               const std::string& prefix, const std::string& path) {
    watched_.parts.push_back({fullPath, prefix, entry.tree.id});
    const std::size_t place = file_.trees.size();
    bt::TreeSpec& tree = file_.trees.emplace_back();
    tree.id = entry.tree.id;
    tree.others = {{"_fullpath", fullPath}};
    const std::string& label = entry.tree.root.label();
    bt::NodeSpec root =
        numbered(entry.tree.root, fullPath, path.empty() ? label : path + "/" + label);
    file_.trees[place].root = std::move(root);  // others were added meanwhile
  }

  bt::NodeSpec numbered(const bt::NodeSpec& node, const std::string& fullPath,
                        const std::string& path) {
    bt::NodeSpec told = node;
    told.children.clear();
    const std::string number = std::to_string(++watched_.nodes);
    bt::setText(told.others, "_uid", number);
    bt::removeText(told.others, "_fullpath");
    if (node.isSubTree()) {
      const std::string name = node.name.empty() ? node.subTree + "::" + number : node.name;
      const std::string own = fullPath.empty() ? name : fullPath + "/" + name;
      bt::setText(told.others, "_fullpath", own);
      if (const bt::TreeTable::Entry* entry = table_.find(node.subTree)) {
        addPart(*entry, own, path + "/", path);
      }
      return told;
    }
    told.name = node.label();
    const std::vector<std::string> names = bt::siblingNames(node.children);
    for (std::size_t k = 0; k < node.children.size(); ++k) {
      told.children.push_back(numbered(node.children[k], fullPath, path + "/" + names[k]));
    }
    return told;
  }

  const bt::TreeTable& table_;
  bt::TreeFile file_;
  WatchedTree watched_;
};

}  // namespace

WatchedTree watchedTree(const bt::TreeTable& table) {
  return Numbering(table).make();
}

}  // namespace groot
