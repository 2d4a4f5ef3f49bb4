#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/map/Terrain.h"

namespace sim2d {

/// The open cells of a large map for bodies of one radius, in square blocks: each piece of a block
/// whose cells hang together by their sides, all known or all unknown, is a node. Two nodes are
/// joined where their cells touch, or over a corner by way of a third one, so ways exist between
/// nodes exactly where they exist between cells. Lengths are those between the anchors of nodes in
/// eight directions, hence up to about 8 % too long and rough by a block. Immutable.
class BlockGraph {
 public:
  using Index = std::int32_t;

  BlockGraph(const DistanceField& field, double radius);

  /// The node of an open cell.
  Index nodeOf(Cell cell) const;
  /// Of its cells with the most room the one nearest to the middle of the block.
  Cell anchor(Index node) const { return nodes_[at(node)].anchor; }
  /// Ways exist within a part and nowhere else.
  std::int32_t part(Index node) const { return part_[at(node)]; }
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
    std::uint8_t price = 0;
    bool isUnknown = false;
  };
  struct Step {
    Index to = 0;
    std::uint32_t cost = 0;
  };
  class Builder;

  static std::size_t at(Index node) { return static_cast<std::size_t>(node); }
  std::uint32_t costBetween(const Node& a, const Node& b) const;
  void numberParts();

  const DistanceField& field_;
  double radius_;
  int side_;                              // of a block [cells]
  int columns_;                           // of blocks
  std::vector<Index> firstNode_;          // by block, and the end
  std::vector<Node> nodes_;               // block by block, in the order of their first cells
  std::vector<std::uint32_t> firstStep_;  // by node, and the end
  std::vector<Step> steps_;
  std::vector<std::int32_t> part_;
};

}  // namespace sim2d
