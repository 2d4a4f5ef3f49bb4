#include "editor/trees/TreeRefusals.h"

#include <algorithm>
#include <map>
#include <optional>

#include <QObject>

#include "editor/document/PersonTree.h"
#include "editor/panels/behavior/TreeOutline.h"

namespace editor {

namespace {

/// "An Inverter", "A Sequence".
QString withArticle(const bt::NodeSpec& node) {
  const QString id = QString::fromStdString(node.isSubTree() ? "SubTree" : node.id);
  const bool isVowel = !id.isEmpty() && QStringLiteral("AEIOU").contains(id.front().toUpper());
  return (isVowel ? QObject::tr("An %1") : QObject::tr("A %1")).arg(id);
}

QString childCountText(std::size_t count) {
  return count == 1 ? QObject::tr("one child") : QObject::tr("%1 children").arg(count);
}

QString rootText() {
  return QObject::tr("A tree can have only one root");
}

/// The limit of the parent if it cannot hold `added` more children.
QString limitIfExceeded(const bt::NodeSpec& parent, std::size_t added) {
  const int most = maxChildCount(parent);
  const bool fits = most < 0 || parent.children.size() + added <= static_cast<std::size_t>(most);
  return fits ? QString() : childLimitText(parent);
}

QString goneText() {
  return QObject::tr("The node no longer exists");
}

}  // namespace

QString childLimitText(const bt::NodeSpec& node) {
  const int most = maxChildCount(node);
  if (most < 0) {
    return {};
  }
  return most == 0   ? QObject::tr("%1 takes no children").arg(withArticle(node))
         : most == 1 ? QObject::tr("%1 takes one child only").arg(withArticle(node))
                     : QObject::tr("%1 takes at most %2 children").arg(withArticle(node)).arg(most);
}

QString whyNotAdded(const bt::TreeFile& file, const NodeLocation& parent, std::size_t count) {
  const bt::NodeSpec* node = nodeAt(file, parent);
  return node == nullptr ? goneText() : limitIfExceeded(*node, count);
}

QString whyNotRemoved(const bt::TreeFile& file, const std::vector<NodeLocation>& places) {
  for (const NodeLocation& place : places) {
    if (nodeAt(file, place) == nullptr) {
      return goneText();
    }
    if (place.isRoot()) {
      return QObject::tr("A tree needs a root: replace it instead");
    }
  }
  return places.empty() ? QObject::tr("Select a node first") : QString();
}

QString whyNotDuplicated(const bt::TreeFile& file, const std::vector<NodeLocation>& places) {
  const std::vector<NodeLocation> outer = withoutDescendants(places);
  std::map<std::pair<std::string, bt::NodePath>, std::size_t> added;  // By parent.
  for (const NodeLocation& place : outer) {
    if (place.isRoot()) {
      return rootText();
    }
    ++added[{place.tree, place.parent().path}];
  }
  for (const auto& [parent, count] : added) {
    QString why = whyNotAdded(file, {parent.first, parent.second}, count);
    if (!why.isEmpty()) {
      return why;
    }
  }
  return outer.empty() ? QObject::tr("Select a node first") : QString();
}

QString whyNotWrapped(const bt::TreeFile& file, const std::vector<NodeLocation>& places,
                      const bt::NodeSpec& around) {
  const std::vector<NodeLocation> outer = withoutDescendants(places);
  const bool isGone = std::any_of(outer.begin(), outer.end(), [&file](const NodeLocation& each) {
    return nodeAt(file, each) == nullptr;
  });
  if (outer.empty() || isGone) {
    return isGone ? goneText() : QObject::tr("Select a node first");
  }
  if (outer.size() > 1 && !areSiblings(outer)) {
    return QObject::tr("Only nodes with the same parent can be wrapped together");
  }
  return limitIfExceeded(around, outer.size());
}

QString whyNotReplaced(const bt::TreeFile& file, const NodeLocation& place,
                       const bt::NodeSpec& by) {
  const bt::NodeSpec* node = nodeAt(file, place);
  if (node == nullptr) {
    return goneText();
  }
  bt::NodeSpec empty = by;
  empty.children.clear();
  const QString limit = limitIfExceeded(empty, node->children.size());
  return limit.isEmpty() ? limit
                         : QObject::tr("%1: %2 has %3")
                               .arg(limit, nodeTitle(*node), childCountText(node->children.size()));
}

QString whyNotUnwrapped(const bt::TreeFile& file, const NodeLocation& place) {
  const bt::NodeSpec* node = nodeAt(file, place);
  if (node == nullptr) {
    return goneText();
  }
  if (node->children.empty()) {
    return QObject::tr("%1 has no children").arg(nodeTitle(*node));
  }
  if (node->children.size() == 1) {
    return {};
  }
  if (place.isRoot()) {
    return rootText();
  }
  const bt::NodeSpec* above = nodeAt(file, place.parent());
  return limitIfExceeded(*above, node->children.size() - 1);
}

QString whyNotExtracted(const bt::TreeFile& file, const NodeLocation& place) {
  if (nodeAt(file, place) == nullptr) {
    return goneText();
  }
  return place.isRoot() ? QObject::tr("The root already has a tree of its own") : QString();
}

QString whyNotInlined(const bt::TreeFile& file, const NodeLocation& place) {
  const bt::NodeSpec* node = nodeAt(file, place);
  if (node == nullptr || !node->isSubTree()) {
    return node == nullptr ? goneText() : QObject::tr("Only a SubTree can be inlined");
  }
  if (!node->autoRemap || !node->ports.empty()) {
    return QObject::tr("%1 has its own blackboard entries").arg(nodeTitle(*node));
  }
  if (!node->conditions.empty()) {
    return QObject::tr("%1 has pre- or postconditions").arg(nodeTitle(*node));
  }
  const bt::TreeSpec* tree = file.find(node->subTree);
  if (tree == nullptr || tree->root.id.empty()) {
    return tree == nullptr ? QObject::tr("%1 is in an included file").arg(nodeTitle(*node))
                           : QObject::tr("%1 is empty").arg(nodeTitle(*node));
  }
  return runsTree(tree->root, tree->id) ? QObject::tr("%1 contains itself").arg(nodeTitle(*node))
                                        : QString();
}

QString whyNotMovedBy(const bt::TreeFile& file, const NodeLocation& place, int by) {
  const bt::NodeSpec* node = nodeAt(file, place);
  if (node == nullptr) {
    return goneText();
  }
  const bt::NodeSpec* above = place.isRoot() ? nullptr : nodeAt(file, place.parent());
  if (above == nullptr || above->children.size() == 1) {
    return above == nullptr ? QObject::tr("The root has no siblings")
                            : QObject::tr("%1 is the only child").arg(nodeTitle(*node));
  }
  const int to = place.path.back() + by;
  if (to < 0 || to >= static_cast<int>(above->children.size())) {
    return (by < 0 ? QObject::tr("%1 is the first child") : QObject::tr("%1 is the last child"))
        .arg(nodeTitle(*node));
  }
  return {};
}

}  // namespace editor
