#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/map/TraversableSpace.h"

namespace sim2d {

/// Coarse graph of the open cells of a large map for bodies of one radius. The map is divided into
/// square blocks; each 4-connected region of a block, all known or all unknown, is a node. Two
/// nodes are connected if their cells touch, or diagonally through a third node, so that a path
/// between nodes exists exactly where one between cells does. Edge lengths are those between the
/// anchors of the nodes in eight directions, so paths are up to about 8 % too long, plus about a
/// block. Immutable.
class BlockGraph {
 public:
  using Index = std::int32_t;

  BlockGraph(const DistanceField& field, double radius);

  /// The node of an open cell.
  Index nodeOf(Cell cell) const;
  /// The cell of lowest cost in the node; of several, the one nearest to the centre of the block.
  Cell anchor(Index node) const { return nodes_[at(node)].anchor; }
  /// Connected component of a node: paths exist only within a component.
  std::int32_t component(Index node) const { return component_[at(node)]; }
  bool isUnknown(Index node) const { return nodes_[at(node)].isUnknown; }
  std::size_t size() const { return nodes_.size(); }
  const base::StopFlag& stopFlag() const { return field_.stopFlag(); }
  int blockSide() const { return side_; }  // [cells]
  std::size_t bytes() const;

  /// visit(Index, std::uint32_t cost)
  template <class Visit>
  void forEachStep(Index from, Visit visit) const {
    for (std::uint32_t i = firstStep_[at(from)]; i < firstStep_[at(from) + 1]; ++i) {
      visit(steps_[i].to, steps_[i].cost);
    }
  }

 private:
  struct Node {
    Cell anchor;
    std::uint8_t cellCost = 0;
    bool isUnknown = false;
  };
  struct Step {
    Index to = 0;
    std::uint32_t cost = 0;
  };
  class Builder;

  static std::size_t at(Index node) { return static_cast<std::size_t>(node); }
  std::uint32_t costBetween(const Node& a, const Node& b) const;
  void labelComponents();

  const DistanceField& field_;
  double radius_;
  int side_;                              // block side [cells]
  int columns_;                           // blocks per row
  std::vector<Index> firstNode_;          // first node of each block, and the end
  std::vector<Node> nodes_;               // ordered by block, then by first cell
  std::vector<std::uint32_t> firstStep_;  // first step of each node, and the end
  std::vector<Step> steps_;
  std::vector<std::int32_t> component_;
};

}  // namespace sim2d
