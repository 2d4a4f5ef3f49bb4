#include <algorithm>
#include <numeric>
#include <type_traits>

#include "sim2d/map/BlockGraph.h"
#include "sim2d/map/GoalSearch.h"
#include "sim2d/map/PathPlanner.h"

namespace sim2d {

namespace {

constexpr std::size_t kCacheBytes = std::size_t{384} << 20U;
constexpr std::size_t kMaxFields = 512;

/// LRU cache of searches by goal.
template <class Graph>
class SearchCache {
 public:
  using Index = typename Graph::Index;

  explicit SearchCache(const Graph& graph) : graph_(graph) {}

  /// The search for `goal`, extended to `from`; null: unreachable.
  const GoalSearch<Graph>* reached(Index from, Index goal) {
    GoalSearch<Graph>& search = to(goal);
    const bool isReached = search.reach(from);
    kept_.front().bytes = search.bytes();
    while (kept_.size() > 1 && (kept_.size() > kMaxFields || bytes() > kCacheBytes)) {
      kept_.pop_back();
    }
    return isReached ? &search : nullptr;
  }
  int made() const { return made_; }
  std::size_t bytes() const {
    return std::accumulate(kept_.begin(), kept_.end(), std::size_t{0},
                           [](std::size_t sum, const Kept& kept) { return sum + kept.bytes; });
  }

 private:
  struct Kept {
    std::unique_ptr<GoalSearch<Graph>> search;
    std::size_t bytes = 0;
  };

  GoalSearch<Graph>& to(Index goal) {
    const auto found = std::find_if(kept_.begin(), kept_.end(), [goal](const Kept& kept) {
      return kept.search->goal() == goal;
    });
    if (found != kept_.end()) {
      std::rotate(kept_.begin(), found, found + 1);
    } else {
      ++made_;
      kept_.insert(kept_.begin(), Kept{std::make_unique<GoalSearch<Graph>>(graph_, goal)});
    }
    return *kept_.front().search;
  }

  const Graph& graph_;
  std::vector<Kept> kept_;  // most recently used first
  int made_ = 0;
};

/// Connected component of each cell, 0 for closed cells; paths exist only within a component. A
/// diagonal step passes two open cells, so 4-connectivity is sufficient.
std::vector<std::int32_t> connectedComponents(const Terrain& terrain) {
  std::vector<std::int32_t> components(terrain.size(), 0);
  std::vector<Terrain::Index> waiting;
  std::int32_t component = 0;
  const auto enter = [&](Terrain::Index index) {
    std::int32_t& its = components[static_cast<std::size_t>(index)];
    if (terrain.isOpen(index) && its == 0) {
      its = component;
      waiting.push_back(index);
    }
  };
  for (Terrain::Index index = 0; index < static_cast<Terrain::Index>(components.size()); ++index) {
    ++component;
    enter(index);
    while (!waiting.empty()) {  // the closed border keeps the fill inside
      terrain.stopFlag().check();
      const Terrain::Index at = waiting.back();
      waiting.pop_back();
      for (const Terrain::Index side : {-1, 1, -terrain.stride(), terrain.stride()}) {
        enter(at + side);
      }
    }
  }
  return components;
}

template <class Graph>
void appendPath(const Graph& terrain, const GoalSearch<Graph>& field, Cell from,
                std::vector<Cell>& path) {
  for (Terrain::Index at = terrain.indexOf(from); at != field.goal();) {
    at = field.next(at);
    path.push_back(terrain.cellOf(at));
  }
}

template <class Graph>
class GridPathFinder : public CellPathFinder {
 public:
  explicit GridPathFinder(const TraversableSpace& space)
      : terrain_(space.field(), space.radius()), searches_(terrain_) {}

  bool isReachable(Cell from, Cell to) override {
    if (components_.empty()) {  // computed once; decides all queries without a search
      components_ = connectedComponents(terrain_);
    }
    return componentOf(from) == componentOf(to);
  }

  std::vector<Cell> path(Cell from, Cell to) override {
    const GoalSearch<Graph>* const field =
        searches_.reached(terrain_.indexOf(from), terrain_.indexOf(to));
    if (field == nullptr) {
      return {};
    }
    std::vector<Cell> path = {from};
    appendPath(terrain_, *field, from, path);
    return path;
  }

  int searches() const override { return searches_.made(); }
  std::size_t bytes() const override {
    return terrain_.size() + sizeof(std::int32_t) * components_.size() + searches_.bytes();
  }
  const Terrain* clearanceTerrain() const override {
    return std::is_same_v<Graph, Terrain> ? &terrain_ : nullptr;
  }

 private:
  std::int32_t componentOf(Cell cell) const {
    return components_[static_cast<std::size_t>(terrain_.indexOf(cell))];
  }

  Graph terrain_;
  SearchCache<Graph> searches_;
  std::vector<std::int32_t> components_;
};

/// The graph selects the blocks to pass, with lengths accurate to about a block; the legs between
/// them are searched in cells, so that paths keep their clearance and exist exactly where cell
/// paths do.
class BlockPathFinder : public CellPathFinder {
 public:
  explicit BlockPathFinder(const TraversableSpace& space)
      : space_(space), graph_(space.field(), space.radius()), searches_(graph_) {}

  bool isReachable(Cell from, Cell to) override {
    return graph_.component(graph_.nodeOf(from)) == graph_.component(graph_.nodeOf(to));
  }

  std::vector<Cell> path(Cell from, Cell to) override {
    BlockGraph::Index node = graph_.nodeOf(from);
    const GoalSearch<BlockGraph>* const search = searches_.reached(node, graph_.nodeOf(to));
    if (search == nullptr) {
      return {};
    }
    std::vector<Cell> path = {from};
    while (node != search->goal()) {
      node = search->next(node);
      appendLeg(node == search->goal() ? to : graph_.anchor(node), path);
    }
    if (path.back() != to) {  // both cells are in one block
      appendLeg(to, path);
    }
    return path;
  }

  int searches() const override { return searches_.made(); }
  std::size_t bytes() const override { return graph_.bytes() + searches_.bytes(); }

 private:
  /// A straight leg if it keeps the lower clearance of both ends, to one cell; else a search in the
  /// cells of both blocks, which always connect them.
  void appendLeg(Cell to, std::vector<Cell>& path) const {
    const Cell from = path.back();
    const DistanceField& field = space_.field();
    const double lowest = std::min({field.distanceAt(from), field.distanceAt(to),
                                    space_.radius() + kPreferredClearance}) -
                          field.grid().resolution();
    const bool isUnknown = field.grid().isUnknown(from) && field.grid().isUnknown(to);
    if (space_.lineHasClearance(field.grid().cellToWorld(from), field.grid().cellToWorld(to),
                                std::max(space_.bodyRadius(), lowest), isUnknown)) {
      path.push_back(to);
      return;
    }
    const int side = graph_.blockSide();
    const auto first = [side](int a, int b) { return std::min(a, b) / side * side; };
    const auto last = [side](int a, int b, int size) {
      return std::min((std::max(a, b) / side + 1) * side, size) - 1;
    };
    const OccupancyGrid& grid = field.grid();
    const Terrain blocks(
        field, space_.radius(), {first(from.column, to.column), first(from.row, to.row)},
        {last(from.column, to.column, grid.width()), last(from.row, to.row, grid.height())});
    CellGoalSearch search(blocks, blocks.indexOf(to));
    if (search.reach(blocks.indexOf(from))) {
      appendPath(blocks, search, from, path);
    }
  }

  const TraversableSpace& space_;
  BlockGraph graph_;
  SearchCache<BlockGraph> searches_;
};

}  // namespace

std::unique_ptr<CellPathFinder> makeCellPathFinder(const TraversableSpace& space,
                                                   PathObjective objective) {
  if (objective == PathObjective::Length) {
    return std::make_unique<GridPathFinder<UniformTerrain>>(space);
  }
  if (space.field().isLarge()) {
    return std::make_unique<BlockPathFinder>(space);
  }
  return std::make_unique<GridPathFinder<Terrain>>(space);
}

}  // namespace sim2d
