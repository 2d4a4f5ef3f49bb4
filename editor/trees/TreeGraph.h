#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QLineF>
#include <QRectF>
#include <QStringList>

#include "editor/document/PersonTree.h"
#include "editor/look/Theme.h"
#include "editor/trees/TreeEdits.h"
#include "editor/trees/TreeLayout.h"

namespace editor {

/// Where something that is dragged would go.
struct DropPlace {
  enum class How { Below, Around };
  How how = How::Below;
  int node = -1;   // Below: the parent; Around: what it would hold
  int index = 0;   // Below: before which child
  QLineF mark;     // of Below
  QPointF centre;  // of the place
};

/// The tree of a person as it is drawn: which nodes are seen and where, and what is wrong with
/// them. Numbers of nodes are those of outlineOf(). Coordinates: x right, y down [px at 100 %].
class TreeGraph {
 public:
  static constexpr double kNodeHeight = 46.0;
  static constexpr double kMargin = 24.0;  // around all

  explicit TreeGraph(const Theme& theme) : theme_(theme) {}
  ~TreeGraph() = default;
  Q_DISABLE_COPY_MOVE(TreeGraph)  // the nodes point into the tree

  /// Folds stay by the names of the nodes.
  void setTree(const PersonTree& tree);
  const PersonTree& tree() const { return tree_; }
  const std::vector<OutlineNode>& nodes() const { return nodes_; }
  const OutlineNode& node(int number) const { return nodes_[static_cast<std::size_t>(number)]; }
  const std::vector<std::string>& names() const { return names_; }  // as records have them
  const std::vector<int>& childrenOf(int node) const {
    return children_[static_cast<std::size_t>(node)];
  }
  bool has(int node) const { return node >= 0 && node < static_cast<int>(nodes_.size()); }
  TreePlace placeOf(int node) const;
  /// The node there, the one nearest to `beside` when a tree is run in several places; -1 = none.
  int nodeAtPlace(const TreePlace& place, int beside = 0) const;
  bool isEditable(int number) const { return node(number).isEditable; }
  bool isUnknown(int node) const;

  /// What a SubTree of an included file runs is folded at first.
  bool isFolded(int node) const;
  void setFolded(int node, bool folded);
  void unfoldAll();
  void foldAll();             // what is below the children of the root
  void show(int node);        // unfolds what hides it
  int below(int node) const;  // how many nodes stand below, seen or not

  /// Ours, or that of the file for nodes that have a place there; the others keep their way from
  /// the parent.
  enum class Placing { Ours, File };
  void setPlacing(Placing placing);
  Placing placing() const { return placing_; }
  bool hasFilePlaces() const;  // of the root and of one other node at least
  void setDirection(TreeDirection direction);
  TreeDirection direction() const { return direction_; }
  const std::vector<int>& shown() const { return shown_; }  // parents before their children
  bool isShown(int node) const { return has(node) && !box(node).isNull(); }
  const QRectF& box(int node) const { return boxes_[static_cast<std::size_t>(node)]; }
  QRectF bounds() const { return bounds_; }
  int nodeAt(const QPointF& at) const;  // -1 = none
  /// Where the parent's and the child's ends of a line are.
  QPointF outlet(int node) const;
  QPointF inlet(int node) const;
  /// The seen node beside one: to the parent, the first child, the sibling before or after.
  enum class Way { Up, Down, Left, Right };  // on the screen
  int beside(int node, Way way) const;

  /// For a node like this, or for the nodes `moving` of the tree with all below them.
  std::optional<DropPlace> dropAt(const QPointF& at, const bt::NodeSpec& what,
                                  const std::vector<int>& moving) const;

  struct Problem {
    base::Severity severity = base::Severity::Warning;
    QString text;
  };
  const std::vector<Problem>& problemsOf(int node) const {
    return problems_[static_cast<std::size_t>(node)];
  }

 private:
  void findProblems();
  void layOut();
  void moveToFilePlaces();
  double widthOf(int node) const;
  bool isBelow(int node, int above) const;  // or the same
  std::vector<DropPlace> dropPlaces(const bt::NodeSpec& what, const std::vector<int>& moving) const;
  bool hasRoom(int parent, const std::vector<int>& moving) const;
  int nextOnLevel(int number, double sign) const;
  DropPlace onlyPlaceBelow(int parent) const;
  void addPlacesBelow(int parent, std::vector<DropPlace>& places) const;

  const Theme theme_;  // for the widths of texts
  PersonTree tree_;
  std::vector<OutlineNode> nodes_;
  std::vector<std::string> names_;
  std::vector<std::vector<int>> children_;
  std::vector<std::vector<Problem>> problems_;
  std::map<std::string, bool> folds_;  // those that were chosen
  TreeDirection direction_ = TreeDirection::Down;
  Placing placing_ = Placing::Ours;
  std::vector<int> shown_;
  std::vector<QRectF> boxes_;  // null: not shown
  QRectF bounds_;
};

/// The second line of a node: its values, or what it is.
QString nodeDetail(const bt::NodeSpec& node);

}  // namespace editor
