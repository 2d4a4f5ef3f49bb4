#include "editor/trees/TreeGroups.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

/// As it is once the node `gone` has been taken out; `index` counts children of it.
void follow(const TreePlace& gone, TreePlace& parent, int& index) {
  const TreePlace above = gone.parent();
  if (!above.holds(parent)) {
    return;
  }
  const std::size_t level = gone.path.size() - 1;
  if (parent.path.size() > level) {
    parent.path[level] -= parent.path[level] > gone.path.back() ? 1 : 0;
  } else {
    index -= index > gone.path.back() ? 1 : 0;
  }
}

}  // namespace

std::vector<TreePlace> withoutInner(std::vector<TreePlace> places) {
  std::sort(places.begin(), places.end(), [](const TreePlace& a, const TreePlace& b) {
    return std::tie(a.tree, a.path) < std::tie(b.tree, b.path);
  });
  std::vector<TreePlace> outer;
  for (TreePlace& place : places) {  // parents come before their children
    if (outer.empty() || !outer.back().holds(place)) {
      outer.push_back(std::move(place));
    }
  }
  return outer;
}

bool areSiblings(const std::vector<TreePlace>& places) {
  return std::all_of(places.begin(), places.end(), [&places](const TreePlace& each) {
    return !each.isRoot() && !places.front().isRoot() && each.parent() == places.front().parent();
  });
}

MaybePlaces removeNodes(bt::TreeFile& file, const std::vector<TreePlace>& places) {
  const std::vector<TreePlace> outer = withoutInner(places);
  MaybePlace left;
  for (auto place = outer.rbegin(); place != outer.rend(); ++place) {
    left = removeNode(file, *place);
    if (!left) {
      return std::nullopt;
    }
  }
  return left ? MaybePlaces({*left}) : std::nullopt;
}

MaybePlaces addNodes(bt::TreeFile& file, const TreePlace& parent, int index,
                     const std::vector<bt::NodeSpec>& nodes) {
  std::vector<TreePlace> added;
  for (const bt::NodeSpec& node : nodes) {
    const MaybePlace place = addNode(file, parent, index + static_cast<int>(added.size()), node);
    if (!place) {
      return std::nullopt;
    }
    added.push_back(*place);
  }
  return added.empty() ? std::nullopt : MaybePlaces(std::move(added));
}

MaybePlaces moveNodes(bt::TreeFile& file, const std::vector<TreePlace>& places,
                      const TreePlace& parent, int index) {
  const std::vector<TreePlace> outer = withoutInner(places);
  std::vector<bt::NodeSpec> nodes;
  for (const TreePlace& place : outer) {
    const bt::NodeSpec* node = nodeAt(file, place);
    if (node == nullptr || place.isRoot() || place.holds(parent)) {
      return std::nullopt;
    }
    nodes.push_back(*node);
  }
  const bool isThere = areSiblings(outer) && !outer.empty() && outer.front().parent() == parent;
  const int first = outer.empty() ? 0 : outer.front().path.back();
  const int count = static_cast<int>(outer.size());
  const bool isOneRow = isThere && outer.back().path.back() == first + count - 1;
  if (isOneRow && index >= first && index <= first + count) {
    return std::nullopt;  // there they are
  }
  TreePlace to = parent;
  for (auto place = outer.rbegin(); place != outer.rend(); ++place) {
    if (!removeNode(file, *place)) {
      return std::nullopt;
    }
    follow(*place, to, index);
  }
  return addNodes(file, to, index, nodes);
}

MaybePlaces wrapNodes(bt::TreeFile& file, const std::vector<TreePlace>& places,
                      bt::NodeSpec around) {
  const std::vector<TreePlace> outer = withoutInner(places);
  if (outer.size() == 1) {
    const MaybePlace place = wrapNode(file, outer.front(), std::move(around));
    return place ? MaybePlaces({*place}) : std::nullopt;
  }
  if (outer.empty() || !areSiblings(outer)) {
    return std::nullopt;
  }
  for (const TreePlace& place : outer) {
    const bt::NodeSpec* node = nodeAt(file, place);
    if (node == nullptr || !takesChild(around)) {
      return std::nullopt;
    }
    around.children.push_back(*node);
  }
  if (!removeNodes(file, outer)) {
    return std::nullopt;
  }
  return addNodes(file, outer.front().parent(), outer.front().path.back(), {std::move(around)});
}

MaybePlaces duplicateNodes(bt::TreeFile& file, const std::vector<TreePlace>& places) {
  const std::vector<TreePlace> outer = withoutInner(places);
  std::vector<TreePlace> added;
  if (areSiblings(outer) && !outer.empty()) {
    std::vector<bt::NodeSpec> copies;
    for (const TreePlace& place : outer) {
      const bt::NodeSpec* node = nodeAt(file, place);
      copies.push_back(node == nullptr ? bt::NodeSpec() : *node);
    }
    return addNodes(file, outer.front().parent(), outer.back().path.back() + 1, copies);
  }
  for (auto place = outer.rbegin(); place != outer.rend(); ++place) {
    const MaybePlace copy = duplicateNode(file, *place);
    if (!copy) {
      return std::nullopt;
    }
    for (TreePlace& later : added) {  // those behind have moved on by one
      const std::size_t level = copy->path.size() - 1;
      if (copy->parent().holds(later) && later.path.size() > level &&
          later.path[level] >= copy->path.back()) {
        ++later.path[level];
      }
    }
    added.insert(added.begin(), *copy);
  }
  return added.empty() ? std::nullopt : MaybePlaces(std::move(added));
}

std::string nodesText(const std::vector<const bt::NodeSpec*>& nodes) {
  std::string text;
  for (const bt::NodeSpec* node : nodes) {
    text += nodeText(*node);
  }
  return text;
}

base::Result<std::vector<bt::NodeSpec>> nodesFromText(const std::string& text, bt::TreeFile& into) {
  const base::Result<bt::NodeSpec> one = nodeFromText(text, into);
  if (one) {
    return std::vector<bt::NodeSpec>{*one};
  }
  const base::Result<bt::NodeSpec> row =
      nodeFromText("<Sequence>" + base::trimmed(text) + "</Sequence>", into);
  if (!row || row->children.empty()) {
    return one.diagnostics();
  }
  return row->children;
}

}  // namespace editor
