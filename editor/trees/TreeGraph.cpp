#include "editor/trees/TreeGraph.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "editor/look/CoreText.h"
#include "editor/panels/behavior/TreeOutline.h"

namespace editor {

namespace {

constexpr double kMinWidth = 104.0, kMaxWidth = 220.0;  // Node width [px].
constexpr double kTextMargin = 10.0;
constexpr double kSignRoom = 24.0;    // To the right of the second line.
constexpr double kDropReach = 170.0;  // Maximum distance from the mouse to a target [px].
constexpr double kDropMargin = 12.0;  // Targets before the first child and after the last.

double lengthOf(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

QString nodeDetail(const bt::NodeSpec& node) {
  const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
  if (node.isSubTree()) {
    return QObject::tr("Subtree");
  }
  if (manifest == nullptr) {
    return QObject::tr("unknown node");
  }
  QStringList parts;
  if (!node.name.empty() && node.name != node.id) {
    parts << QString::fromStdString(node.id);
  }
  parts << nodeValues(node);
  parts.removeAll(QString());
  return parts.isEmpty() ? coreText(bt::nodeKindName(manifest->kind))
                         : parts.join(QStringLiteral(" · "));
}

void TreeGraph::setTree(const PersonTree& tree) {
  tree_ = tree;
  nodes_ = outlineOf(tree_);
  names_ = recordedNames(nodes_);
  children_.assign(nodes_.size(), {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent >= 0) {
      children_[static_cast<std::size_t>(nodes_[i].parent)].push_back(static_cast<int>(i));
    }
  }
  findProblems();
  layOut();
}

void TreeGraph::findProblems() {
  problems_.assign(nodes_.size(), {});
  if (nodes_.empty()) {
    return;
  }
  for (const bt::TreeIssue& issue : bt::checkTrees(tree_.table, treeCatalogue())) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].tree == issue.treeId && nodes_[i].path == issue.node) {
        problems_[i].push_back(
            {issue.diagnostic.severity, treeProblemText(issue.diagnostic, true)});
      }
    }
  }
}

NodeLocation TreeGraph::locationOf(int number) const {
  return {node(number).tree, node(number).path};
}

int TreeGraph::nodeAtLocation(const NodeLocation& place, int beside) const {
  int best = -1;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int number = static_cast<int>(i);
    const bool isThere = nodes_[i].tree == place.tree && nodes_[i].path == place.path;
    if (isThere && (best < 0 || std::abs(number - beside) < std::abs(best - beside))) {
      best = number;
    }
  }
  return best;
}

bool TreeGraph::isUnknown(int number) const {
  return treeCatalogue().find(node(number).node->id) == nullptr;
}

bool TreeGraph::isFolded(int number) const {
  if (!has(number) || childrenOf(number).empty()) {
    return false;
  }
  const auto chosen = folds_.find(names_[static_cast<std::size_t>(number)]);
  return chosen != folds_.end()
             ? chosen->second
             : node(number).node->isSubTree() && !isEditable(childrenOf(number).front());
}

void TreeGraph::setFolded(int number, bool folded) {
  folds_[names_[static_cast<std::size_t>(number)]] = folded;
  layOut();
}

void TreeGraph::unfoldAll() {
  for (const std::string& name : names_) {
    folds_[name] = false;
  }
  layOut();
}

void TreeGraph::foldAll() {
  for (std::size_t i = 1; i < names_.size(); ++i) {
    folds_[names_[i]] = nodes_[i].parent == 0;
  }
  layOut();
}

void TreeGraph::show(int number) {
  if (!has(number) || isShown(number)) {
    return;
  }
  for (int above = node(number).parent; above >= 0; above = node(above).parent) {
    if (isFolded(above)) {
      folds_[names_[static_cast<std::size_t>(above)]] = false;
    }
  }
  layOut();
}

int TreeGraph::below(int number) const {
  int last = number + 1;  // Descendants follow their ancestor.
  while (last < static_cast<int>(nodes_.size()) && isBelow(last, number)) {
    ++last;
  }
  return last - number - 1;
}

bool TreeGraph::isBelow(int number, int above) const {
  while (number > above) {
    number = node(number).parent;
  }
  return number == above;
}

void TreeGraph::setDirection(TreeDirection direction) {
  direction_ = direction;
  layOut();
}

double TreeGraph::widthOf(int number) const {
  const bt::NodeSpec& spec = *node(number).node;
  const double title =
      QFontMetricsF(theme_.font(9.5, QFont::DemiBold)).horizontalAdvance(nodeTitle(spec));
  const double detail = QFontMetricsF(theme_.font(9.0)).horizontalAdvance(nodeDetail(spec));
  return std::ceil(
      std::clamp(std::max(title, detail + kSignRoom) + 2.0 * kTextMargin, kMinWidth, kMaxWidth));
}

void TreeGraph::layOut() {
  std::vector<LayoutNode> seen;
  std::vector<int> places(nodes_.size(), -1);  // Indices among the visible nodes.
  shown_.clear();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int parent = nodes_[i].parent;
    const bool isHidden =
        parent >= 0 && (places[static_cast<std::size_t>(parent)] < 0 || isFolded(parent));
    if (!isHidden) {
      places[i] = static_cast<int>(shown_.size());
      shown_.push_back(static_cast<int>(i));
      seen.push_back({parent < 0 ? -1 : places[static_cast<std::size_t>(parent)],
                      widthOf(static_cast<int>(i)), kNodeHeight});
    }
  }
  const LayoutGaps gaps =
      direction_ == TreeDirection::Down ? LayoutGaps{8.0, 44.0} : LayoutGaps{12.0, 44.0};
  const TreeLayoutResult laid = layOutTree(seen, direction_, gaps);
  boxes_.assign(nodes_.size(), {});
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    const LayoutBox& box = laid.boxes[k];
    boxes_[static_cast<std::size_t>(shown_[k])] =
        QRectF(std::round(box.x) + kMargin, std::round(box.y) + kMargin, box.width, box.height);
  }
  bounds_ = QRectF(0.0, 0.0, laid.width + 2.0 * kMargin, laid.height + 2.0 * kMargin);
  if (positionSource_ == PositionSource::File && hasStoredPositions()) {
    applyStoredPositions();
  }
}

bool TreeGraph::hasStoredPositions() const {
  const auto hasPlace = [](const OutlineNode& each) {
    return storedNodePosition(*each.node).has_value();
  };
  return !nodes_.empty() && hasPlace(nodes_.front()) &&
         std::any_of(nodes_.begin() + 1, nodes_.end(), hasPlace);
}

void TreeGraph::applyStoredPositions() {
  const std::vector<QRectF> ours = boxes_;
  QRectF all;
  for (const int each : shown_) {  // Parents precede children.
    const auto k = static_cast<std::size_t>(each);
    const int parent = node(each).parent;
    if (const std::optional<QPointF> place = storedNodePosition(*node(each).node)) {
      boxes_[k].moveTopLeft(*place);
    } else if (parent >= 0) {
      const auto above = static_cast<std::size_t>(parent);
      boxes_[k].moveTopLeft(boxes_[above].topLeft() + ours[k].topLeft() - ours[above].topLeft());
    }
    all = all.isNull() ? boxes_[k] : all.united(boxes_[k]);
  }
  for (const int each : shown_) {
    boxes_[static_cast<std::size_t>(each)].translate(QPointF(kMargin, kMargin) - all.topLeft());
  }
  bounds_ = QRectF(QPointF(), all.size() + QSizeF(2.0 * kMargin, 2.0 * kMargin));
}

/// Lines follow the direction in which most children lie in the file.
void TreeGraph::setPositionSource(PositionSource positionSource) {
  positionSource_ = positionSource;
  if (positionSource == PositionSource::File) {
    int down = 0;
    for (const OutlineNode& each : nodes_) {
      const auto place = storedNodePosition(*each.node);
      const auto above =
          each.parent < 0 ? std::nullopt : storedNodePosition(*node(each.parent).node);
      if (place && above) {
        const QPointF way = *place - *above;
        down += std::abs(way.y()) >= std::abs(way.x()) ? 1 : -1;
      }
    }
    direction_ = down >= 0 ? TreeDirection::Down : TreeDirection::Right;
  }
  layOut();
}

int TreeGraph::nodeAt(const QPointF& at) const {
  for (const int each : shown_) {
    if (box(each).contains(at)) {
      return each;
    }
  }
  return -1;
}

QPointF TreeGraph::outlet(int number) const {
  const QRectF& its = box(number);
  return direction_ == TreeDirection::Down ? QPointF(its.center().x(), its.bottom())
                                           : QPointF(its.right(), its.center().y());
}

QPointF TreeGraph::inlet(int number) const {
  const QRectF& its = box(number);
  return direction_ == TreeDirection::Down ? QPointF(its.center().x(), its.top())
                                           : QPointF(its.left(), its.center().y());
}

int TreeGraph::beside(int number, Way way) const {
  if (!isShown(number)) {
    return shown_.empty() ? -1 : shown_.front();
  }
  const bool isDown = direction_ == TreeDirection::Down;
  const Way up = isDown ? Way::Up : Way::Left, down = isDown ? Way::Down : Way::Right;
  if (way == up) {
    return std::max(node(number).parent, 0);
  }
  if (way == down) {
    const bool hasSeen = !childrenOf(number).empty() && !isFolded(number);
    return hasSeen ? childrenOf(number).front() : number;
  }
  return nextOnLevel(number, way == Way::Right || way == Way::Down ? 1.0 : -1.0);
}

/// The next node of the level, independent of the parent; the node itself if there is none.
int TreeGraph::nextOnLevel(int number, double sign) const {
  const bool isDown = direction_ == TreeDirection::Down;
  const auto across = [&](int each) {
    return isDown ? box(each).center().x() : box(each).center().y();
  };
  const auto along = [&](int each) { return isDown ? box(each).top() : box(each).left(); };
  int best = number;
  double least = 0.0;
  for (const int each : shown_) {
    const double far = sign * (across(each) - across(number));
    const bool isOnLevel = std::abs(along(each) - along(number)) < 1.0;
    if (isOnLevel && far > 0.0 && (best == number || far < least)) {
      best = each;
      least = far;
    }
  }
  return best;
}

DropTarget TreeGraph::onlyTargetBelow(int parent) const {
  const bool isDown = direction_ == TreeDirection::Down;
  const QPointF gap = isDown ? QPointF(0.0, 20.0) : QPointF(20.0, 0.0);
  const QPointF at = outlet(parent) + gap;
  const QPointF half = isDown ? QPointF(0.4 * box(parent).width(), 0.0) : QPointF(0.0, 18.0);
  return {DropTarget::How::Below, parent, 0, QLineF(at - half, at + half), at};
}

void TreeGraph::addTargetsBelow(int parent, std::vector<DropTarget>& places) const {
  if (childrenOf(parent).empty()) {
    places.push_back(onlyTargetBelow(parent));
    return;
  }
  const bool isDown = direction_ == TreeDirection::Down;
  const std::vector<int>& children = childrenOf(parent);
  const QPointF half = 0.5 * kNodeHeight * (isDown ? QPointF(0.0, 1.0) : QPointF(1.0, 0.0));
  const auto edge = [&](int child, bool isEnd) {
    const QRectF& its = box(child);
    return isDown ? (isEnd ? its.right() : its.left()) : (isEnd ? its.bottom() : its.top());
  };
  const QPointF level = box(children.front()).center();
  for (int index = 0; index <= static_cast<int>(children.size()); ++index) {
    const auto k = static_cast<std::size_t>(index);
    const double across = index == 0 ? edge(children.front(), false) - kDropMargin
                          : k == children.size()
                              ? edge(children.back(), true) + kDropMargin
                              : 0.5 * (edge(children[k - 1], true) + edge(children[k], false));
    const QPointF at = isDown ? QPointF(across, level.y()) : QPointF(level.x(), across);
    places.push_back({DropTarget::How::Below, parent, index, QLineF(at - half, at + half), at});
  }
}

/// Returns true if the moved nodes, or one new node, fit beside the remaining children.
bool TreeGraph::canHoldChildren(int parent, const std::vector<int>& moving) const {
  const int most = maxChildCount(*node(parent).node);
  const std::vector<int>& children = childrenOf(parent);
  const auto stay = std::count_if(children.begin(), children.end(), [&moving](int child) {
    return std::find(moving.begin(), moving.end(), child) == moving.end();
  });
  return most < 0 || static_cast<std::size_t>(stay) + std::max<std::size_t>(moving.size(), 1) <=
                         static_cast<std::size_t>(most);
}

std::vector<DropTarget> TreeGraph::dropTargets(const bt::NodeSpec& what,
                                               const std::vector<int>& moving) const {
  std::vector<DropTarget> places;
  for (const int each : shown_) {
    const bool isMoving =
        std::any_of(moving.begin(), moving.end(), [&](int above) { return isBelow(each, above); });
    if (!isEditable(each) || isMoving || isFolded(each)) {
      continue;
    }
    if (canHoldChildren(each, moving)) {
      addTargetsBelow(each, places);
    }
    if (moving.empty() && canHaveChildren(what)) {
      const QPointF above = direction_ == TreeDirection::Down ? QPointF(0, -12) : QPointF(-12, 0);
      places.push_back({DropTarget::How::Around, each, 0, {}, inlet(each) + above});
    }
  }
  return places;
}

std::optional<DropTarget> TreeGraph::dropTargetAt(const QPointF& at, const bt::NodeSpec& what,
                                                  const std::vector<int>& moving) const {
  const std::vector<DropTarget> places = dropTargets(what, moving);
  const int under = nodeAt(at);
  const DropTarget* best = nullptr;
  if (under >= 0) {  // In the middle of a node: into it, else around it.
    const QRectF inner =
        box(under).adjusted(0.2 * box(under).width(), 0.0, -0.2 * box(under).width(), 0.0);
    for (const DropTarget& place : places) {
      const bool isInto = place.node == under && inner.contains(at);
      if (isInto && (best == nullptr || place.how == DropTarget::How::Below)) {
        best = &place;  // The last one: after all children.
      }
    }
  }
  if (best == nullptr) {
    for (const DropTarget& place : places) {
      const double far = lengthOf(place.centre, at);
      if (far < kDropReach && (best == nullptr || far < lengthOf(best->centre, at))) {
        best = &place;
      }
    }
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

}  // namespace editor
