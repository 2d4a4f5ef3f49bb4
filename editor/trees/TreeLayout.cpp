#include "editor/trees/TreeLayout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kNone = -1;

/// State of a node during the layout across the levels. Names are those of the paper: the position
/// of a node is `prelim` plus the `mod` of all its ancestors.
struct Walker {
  int parent = kNone, firstChild = kNone, lastChild = kNone, left = kNone, right = kNone;
  int number = 0;  // Index among its siblings.
  int depth = 0;
  double breadth = 0.0;  // Extent across the levels.
  double prelim = 0.0, mod = 0.0, change = 0.0, shift = 0.0, middle = 0.0;
  int thread = kNone, ancestor = kNone;
};

/// Uses an invisible root (the last entry) above the roots of the list.
class TidyTree {
 public:
  TidyTree(const std::vector<LayoutNode>& nodes, TreeDirection direction, double gap);
  std::vector<double> centres();
  int depthOf(std::size_t node) const { return walkers_[node].depth - 1; }

 private:
  Walker& at(int node) { return walkers_[static_cast<std::size_t>(node)]; }
  double distance(int a, int b) { return gap_ + 0.5 * (at(a).breadth + at(b).breadth); }
  int nextLeft(int node) {
    return at(node).firstChild != kNone ? at(node).firstChild : at(node).thread;
  }
  int nextRight(int node) {
    return at(node).lastChild != kNone ? at(node).lastChild : at(node).thread;
  }
  void link(int child, int parent);
  void placeChildren(int parent);
  int apportion(int node, int defaultAncestor);
  void moveSubtree(int from, int to, double shift);
  void executeShifts(int parent);

  std::vector<Walker> walkers_;
  double gap_;
};

TidyTree::TidyTree(const std::vector<LayoutNode>& nodes, TreeDirection direction, double gap)
    : walkers_(nodes.size() + 1), gap_(gap) {
  const int root = static_cast<int>(nodes.size());
  for (int node = 0; node < root; ++node) {
    const LayoutNode& from = nodes[static_cast<std::size_t>(node)];
    at(node).breadth = direction == TreeDirection::Down ? from.width : from.height;
    at(node).ancestor = node;
    link(node, from.parent == kNone ? root : from.parent);
  }
}

void TidyTree::link(int child, int parent) {
  Walker& above = at(parent);
  Walker& self = at(child);
  self.parent = parent;
  self.depth = above.depth + 1;
  self.left = above.lastChild;
  if (above.lastChild == kNone) {
    above.firstChild = child;
  } else {
    at(above.lastChild).right = child;
    self.number = at(above.lastChild).number + 1;
  }
  above.lastChild = child;
}

/// The subtrees of the children are already placed relative to each child.
void TidyTree::placeChildren(int parent) {
  if (at(parent).firstChild == kNone) {
    return;
  }
  int defaultAncestor = at(parent).firstChild;
  for (int child = at(parent).firstChild; child != kNone; child = at(child).right) {
    Walker& self = at(child);
    if (self.left == kNone) {
      self.prelim = self.middle;
    } else {
      self.prelim = at(self.left).prelim + distance(self.left, child);
      self.mod = self.prelim - self.middle;
    }
    defaultAncestor = apportion(child, defaultAncestor);
  }
  executeShifts(parent);
  at(parent).middle = 0.5 * (at(at(parent).firstChild).prelim + at(at(parent).lastChild).prelim);
}

/// Moves a subtree to the right until it does not overlap those to its left.
int TidyTree::apportion(int node, int defaultAncestor) {
  if (at(node).left == kNone) {
    return defaultAncestor;
  }
  int insideRight = node, outsideRight = node;  // Contours of this subtree …
  int insideLeft = at(node).left;               // … and of those to its left.
  int outsideLeft = at(at(node).parent).firstChild;
  double sumInsideRight = at(insideRight).mod, sumOutsideRight = at(outsideRight).mod;
  double sumInsideLeft = at(insideLeft).mod, sumOutsideLeft = at(outsideLeft).mod;
  while (nextRight(insideLeft) != kNone && nextLeft(insideRight) != kNone) {
    insideLeft = nextRight(insideLeft);
    insideRight = nextLeft(insideRight);
    outsideLeft = nextLeft(outsideLeft);
    outsideRight = nextRight(outsideRight);
    at(outsideRight).ancestor = node;
    const double shift = at(insideLeft).prelim + sumInsideLeft - at(insideRight).prelim -
                         sumInsideRight + distance(insideLeft, insideRight);
    if (shift > 0.0) {
      const int ancestor = at(insideLeft).ancestor;
      const bool isSibling = at(ancestor).parent == at(node).parent;
      moveSubtree(isSibling ? ancestor : defaultAncestor, node, shift);
      sumInsideRight += shift;
      sumOutsideRight += shift;
    }
    sumInsideLeft += at(insideLeft).mod;
    sumInsideRight += at(insideRight).mod;
    sumOutsideLeft += at(outsideLeft).mod;
    sumOutsideRight += at(outsideRight).mod;
  }
  if (nextRight(insideLeft) != kNone && nextRight(outsideRight) == kNone) {
    at(outsideRight).thread = nextRight(insideLeft);
    at(outsideRight).mod += sumInsideLeft - sumOutsideRight;
  }
  if (nextLeft(insideRight) != kNone && nextLeft(outsideLeft) == kNone) {
    at(outsideLeft).thread = nextLeft(insideRight);
    at(outsideLeft).mod += sumInsideRight - sumOutsideLeft;
    return node;
  }
  return defaultAncestor;
}

void TidyTree::moveSubtree(int from, int to, double shift) {
  const double share = shift / (at(to).number - at(from).number);
  at(to).change -= share;
  at(to).shift += shift;
  at(from).change += share;
  at(to).prelim += shift;
  at(to).mod += shift;
}

void TidyTree::executeShifts(int parent) {
  double shift = 0.0, change = 0.0;
  for (int child = at(parent).lastChild; child != kNone; child = at(child).left) {
    at(child).prelim += shift;
    at(child).mod += shift;
    change += at(child).change;
    shift += at(child).shift + change;
  }
}

std::vector<double> TidyTree::centres() {
  const int root = static_cast<int>(walkers_.size()) - 1;
  for (int node = root - 1; node >= 0; --node) {  // Children before their parents.
    placeChildren(node);
  }
  placeChildren(root);
  std::vector<double> sums(walkers_.size(), 0.0);  // Sums of `mod` over the ancestors of a node.
  std::vector<double> places;
  places.reserve(walkers_.size());
  for (int node = 0; node < root; ++node) {  // Parents before their children.
    const auto parent = static_cast<std::size_t>(at(node).parent);
    sums[static_cast<std::size_t>(node)] = sums[parent] + at(static_cast<int>(parent)).mod;
    places.push_back(at(node).prelim + sums[static_cast<std::size_t>(node)]);
  }
  return places;
}

}  // namespace

TreeLayoutResult layOutTree(const std::vector<LayoutNode>& nodes, TreeDirection direction,
                            const LayoutGaps& gaps) {
  const bool isDown = direction == TreeDirection::Down;
  TidyTree tidy(nodes, direction, gaps.sibling);
  const std::vector<double> centres = tidy.centres();
  std::vector<double> depths;  // Depth of each level, then its start [px].
  double least = 0.0;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const auto level = static_cast<std::size_t>(tidy.depthOf(node));
    depths.resize(std::max(depths.size(), level + 1), 0.0);
    depths[level] = std::max(depths[level], isDown ? nodes[node].height : nodes[node].width);
    const double edge = centres[node] - 0.5 * (isDown ? nodes[node].width : nodes[node].height);
    least = node == 0 ? edge : std::min(least, edge);
  }
  double begin = 0.0;
  for (double& depth : depths) {
    const double its = depth;
    depth = begin;
    begin += its + gaps.level;
  }
  TreeLayoutResult places;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const LayoutNode& from = nodes[node];
    const double along = depths[static_cast<std::size_t>(tidy.depthOf(node))];
    const double across = centres[node] - 0.5 * (isDown ? from.width : from.height) - least;
    places.boxes.push_back(
        {isDown ? across : along, isDown ? along : across, from.width, from.height});
    places.width = std::max(places.width, places.boxes.back().x + from.width);
    places.height = std::max(places.height, places.boxes.back().y + from.height);
  }
  return places;
}

namespace {

constexpr double kFarthestPlace = 1e6;  // [px]

std::optional<QPointF> positionFromTexts(const std::string& x, const std::string& y) {
  const std::optional<double> across = base::parseDouble(base::trimmed(x));
  const std::optional<double> down = base::parseDouble(base::trimmed(y));
  const bool isPlace = across && down && std::fabs(*across) <= kFarthestPlace &&
                       std::fabs(*down) <= kFarthestPlace;  // Also excludes NaN.
  return isPlace ? std::optional(QPointF(*across, *down)) : std::nullopt;
}

}  // namespace

std::optional<QPointF> storedNodePosition(const bt::NodeSpec& node) {
  const std::string* x = bt::findAttribute(node.others, "_x");
  const std::string* y = bt::findAttribute(node.others, "_y");
  if (x != nullptr && y != nullptr) {
    return positionFromTexts(*x, *y);
  }
  for (const char* name : {"_pos", "_position"}) {
    const std::string* both = bt::findAttribute(node.others, name);
    const std::size_t middle = both == nullptr ? std::string::npos : both->find_first_of(";,");
    if (middle != std::string::npos) {
      return positionFromTexts(both->substr(0, middle), both->substr(middle + 1));
    }
  }
  return std::nullopt;
}

}  // namespace editor
