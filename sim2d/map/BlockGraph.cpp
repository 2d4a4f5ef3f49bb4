#include "sim2d/map/BlockGraph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim2d {

namespace {

using Index = BlockGraph::Index;
using Pair = std::pair<Index, Index>;

constexpr int kMinSide = 12;             // [cells]
constexpr double kMaxGraphBlocks = 6e4;  // a search over them takes about 7 ms
constexpr Index kNoLabel = -1;

int sideFor(const OccupancyGrid& grid) {
  const double cells = static_cast<double>(grid.width()) * grid.height();
  return std::max(kMinSide, static_cast<int>(std::ceil(std::sqrt(cells / kMaxGraphBlocks))));
}

/// Flood fill: labels the cells connected to `first` within the rectangle.
void floodFill(const Terrain& terrain, Terrain::Index first, Cell low, Cell high, Index label,
               std::vector<Index>& labels) {
  std::vector<Terrain::Index> waiting;
  const bool isUnknown = terrain.isUnknown(first);
  const auto enter = [&](Terrain::Index index) {
    Index& its = labels[static_cast<std::size_t>(index)];
    if (its == kNoLabel && terrain.isOpen(index) && terrain.isUnknown(index) == isUnknown) {
      its = label;
      waiting.push_back(index);
    }
  };
  enter(first);
  while (!waiting.empty()) {
    const Terrain::Index index = waiting.back();
    waiting.pop_back();
    const Cell cell = terrain.cellOf(index);
    if (cell.column > low.column) {
      enter(index - 1);
    }
    if (cell.column < high.column) {
      enter(index + 1);
    }
    if (cell.row > low.row) {
      enter(index - terrain.stride());
    }
    if (cell.row < high.row) {
      enter(index + terrain.stride());
    }
  }
}

/// visit(Terrain::Index) for each cell of the rectangle, row by row.
template <class Visit>
void forEachCell(const Terrain& terrain, Cell low, Cell high, Visit visit) {
  for (int row = low.row; row <= high.row; ++row) {
    const Terrain::Index first = terrain.indexOf({low.column, row});
    for (int i = 0; i <= high.column - low.column; ++i) {
      visit(first + i);
    }
  }
}

/// Labels the connected regions of a block from `label` on, in the order of their first cells.
/// Returns the next free label.
Index labelRegions(const Terrain& terrain, Cell low, Cell high, Index label,
                   std::vector<Index>& labels) {
  forEachCell(terrain, low, high, [&](Terrain::Index index) {
    if (terrain.isOpen(index) && labels[static_cast<std::size_t>(index)] == kNoLabel) {
      floodFill(terrain, index, low, high, label++, labels);
    }
  });
  return label;
}

void sortUnique(std::vector<Pair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

/// Processes the map one row of blocks at a time, to limit memory.
class BlockGraph::Builder {
 public:
  explicit Builder(BlockGraph& graph) : graph_(graph), grid_(graph.field_.grid()) {}

  void build() {
    below_.assign(static_cast<std::size_t>(grid_.width()) + 2, kNoLabel);
    for (int row = 0; row < grid_.height(); row += graph_.side_) {
      graph_.field_.stopFlag().check();
      addRow(row);
    }
    graph_.firstNode_.push_back(static_cast<Index>(graph_.nodes_.size()));
    sortUnique(adjacent_);
    addSteps();
  }

 private:
  void addRow(int row) {
    const Cell low{0, row};
    const Cell high{grid_.width() - 1, std::min(row + graph_.side_, grid_.height()) - 1};
    const Terrain terrain(graph_.field_, graph_.radius_, low, high);
    labels_.assign(terrain.size(), kNoLabel);
    for (int column = 0; column < grid_.width(); column += graph_.side_) {
      const int last = std::min(column + graph_.side_, grid_.width()) - 1;
      addBlock(terrain, {column, row}, {last, high.row});
    }
    addAdjacentPairs(terrain, low, high);
    const auto top = labels_.begin() + terrain.indexOf({-1, high.row});
    below_.assign(top, top + terrain.stride());
  }

  void addBlock(const Terrain& terrain, Cell low, Cell high) {
    const auto first = static_cast<Index>(graph_.nodes_.size());
    graph_.firstNode_.push_back(first);
    const Index end = labelRegions(terrain, low, high, first, labels_);
    graph_.nodes_.resize(at(end));
    const Vec2 middle(0.5 * (low.column + high.column), 0.5 * (low.row + high.row));
    std::vector<double> nearest(at(end - first), 0.0);
    forEachCell(terrain, low, high, [&](Terrain::Index index) {
      const Index label = labels_[static_cast<std::size_t>(index)];
      if (label == kNoLabel) {
        return;
      }
      Node& node = graph_.nodes_[at(label)];
      const Cell cell = terrain.cellOf(index);
      const auto cellCost = static_cast<std::uint8_t>(terrain.cellCost(index));
      const double offset = (Vec2(cell.column, cell.row) - middle).squaredNorm();
      double& best = nearest[at(label - first)];
      if (node.cellCost == 0 ||
          std::make_pair(cellCost, offset) < std::make_pair(node.cellCost, best)) {
        node = {cell, cellCost, terrain.isUnknown(index)};
        best = offset;
      }
    });
  }

  /// Collects pairs of nodes with adjacent cells, in both directions.
  void addAdjacentPairs(const Terrain& terrain, Cell low, Cell high) {
    std::vector<Pair> found;
    const auto note = [&found](Index a, Index b) {
      if (a != b && a != kNoLabel && b != kNoLabel &&
          (found.empty() || found.back() != Pair(a, b))) {
        found.emplace_back(a, b);
      }
    };
    for (int row = low.row; row <= high.row; ++row) {
      const auto first = static_cast<std::size_t>(terrain.indexOf({0, row}));
      const Index* const below =
          row == low.row ? below_.data() + 1 : labels_.data() + terrain.indexOf({0, row - 1});
      for (std::size_t i = 0; i < static_cast<std::size_t>(grid_.width()); ++i) {
        note(below[i], labels_[first + i]);
      }
      for (std::size_t i = 1; i < static_cast<std::size_t>(grid_.width()); ++i) {
        note(labels_[first + i - 1], labels_[first + i]);
      }
    }
    sortUnique(found);
    for (const auto& [a, b] : found) {
      adjacent_.emplace_back(a, b);
      adjacent_.emplace_back(b, a);
    }
  }

  Cell blockOf(Index node) const {
    const Cell anchor = graph_.nodes_[at(node)].anchor;
    return {anchor.column / graph_.side_, anchor.row / graph_.side_};
  }

  bool isDiagonal(Index a, Index b) const {
    const Cell first = blockOf(a);
    const Cell second = blockOf(b);
    return first.column != second.column && first.row != second.row &&
           graph_.isUnknown(a) == graph_.isUnknown(b);
  }

  void addSteps() {
    std::vector<std::size_t> first(graph_.size() + 1, 0);  // first pair of each node in adjacent_
    for (const Pair& pair : adjacent_) {
      ++first[at(pair.first) + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) {
      first[i] += first[i - 1];
    }
    std::vector<Index> ends;
    graph_.firstStep_.push_back(0);
    for (Index node = 0; node < static_cast<Index>(graph_.size()); ++node) {
      graph_.stopFlag().check();
      ends.clear();
      for (std::size_t i = first[at(node)]; i < first[at(node) + 1]; ++i) {
        const Index beside = adjacent_[i].second;
        ends.push_back(beside);
        for (std::size_t k = first[at(beside)]; k < first[at(beside) + 1]; ++k) {
          const Index far = adjacent_[k].second;
          if (graph_.isUnknown(beside) == graph_.isUnknown(node) && isDiagonal(node, far)) {
            ends.push_back(far);
          }
        }
      }
      std::sort(ends.begin(), ends.end());
      ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
      for (const Index end : ends) {
        const Node& from = graph_.nodes_[at(node)];
        graph_.steps_.push_back({end, graph_.costBetween(from, graph_.nodes_[at(end)])});
      }
      graph_.firstStep_.push_back(static_cast<std::uint32_t>(graph_.steps_.size()));
    }
  }

  BlockGraph& graph_;
  const OccupancyGrid& grid_;
  std::vector<Index> labels_, below_;  // of the current row of blocks; of the cells below it
  std::vector<Pair> adjacent_;
};

BlockGraph::BlockGraph(const DistanceField& field, double radius)
    : field_(field),
      radius_(radius),
      side_(sideFor(field.grid())),
      columns_((field.grid().width() + side_ - 1) / side_) {
  Builder(*this).build();
  labelComponents();
}

std::uint32_t BlockGraph::costBetween(const Node& a, const Node& b) const {
  const double length = std::hypot(a.anchor.column - b.anchor.column, a.anchor.row - b.anchor.row);
  const auto cost =
      static_cast<std::uint32_t>(std::lround(kCellLength * length * (a.cellCost + b.cellCost)));
  return a.isUnknown || b.isUnknown ? kUnknownFactor * cost : cost;
}

void BlockGraph::labelComponents() {
  component_.assign(size(), kNoLabel);
  std::vector<Index> waiting;
  for (Index node = 0; node < static_cast<Index>(size()); ++node) {
    if (component_[at(node)] != kNoLabel) {
      continue;
    }
    component_[at(node)] = node;
    waiting.push_back(node);
    while (!waiting.empty()) {
      const Index from = waiting.back();
      waiting.pop_back();
      forEachStep(from, [&](Index to, std::uint32_t) {
        if (component_[at(to)] == kNoLabel) {
          component_[at(to)] = node;
          waiting.push_back(to);
        }
      });
    }
  }
}

Index BlockGraph::nodeOf(Cell cell) const {
  const Cell low{cell.column / side_ * side_, cell.row / side_ * side_};
  const int number = cell.row / side_ * columns_ + cell.column / side_;
  const auto block = static_cast<std::size_t>(number);
  const Index first = firstNode_[block];
  if (firstNode_[block + 1] - first == 1) {
    return first;
  }
  const OccupancyGrid& grid = field_.grid();
  const Cell high{std::min(low.column + side_, grid.width()) - 1,
                  std::min(low.row + side_, grid.height()) - 1};
  const Terrain terrain(field_, radius_, low, high);
  std::vector<Index> labels(terrain.size(), kNoLabel);
  labelRegions(terrain, low, high, first, labels);
  return labels[static_cast<std::size_t>(terrain.indexOf(cell))];
}

std::size_t BlockGraph::bytes() const {
  return sizeof(Index) * firstNode_.capacity() + sizeof(Node) * nodes_.capacity() +
         sizeof(std::uint32_t) * firstStep_.capacity() + sizeof(Step) * steps_.capacity() +
         sizeof(std::int32_t) * component_.capacity();
}

}  // namespace sim2d
