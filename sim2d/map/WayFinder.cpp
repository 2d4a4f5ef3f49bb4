#include "sim2d/map/WayFinder.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include "sim2d/map/BlockGraph.h"
#include "sim2d/map/GoalField.h"

namespace sim2d {

namespace {

constexpr std::size_t kCacheBytes = std::size_t{384} << 20U;
constexpr std::size_t kMostFields = 512;

/// Searches by their goals; the least recently used ones make room.
template <class Ground>
class Searches {
 public:
  using Index = typename Ground::Index;

  explicit Searches(const Ground& ground) : ground_(ground) {}

  /// That of the goal, which has reached `from`; null: no way leads there.
  const GoalSearch<Ground>* reached(Index from, Index goal) {
    GoalSearch<Ground>& search = to(goal);
    const bool isReached = search.reach(from);
    kept_.front().bytes = search.bytes();
    while (kept_.size() > 1 && (kept_.size() > kMostFields || bytes() > kCacheBytes)) {
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
    std::unique_ptr<GoalSearch<Ground>> search;
    std::size_t bytes = 0;
  };

  GoalSearch<Ground>& to(Index goal) {
    const auto found = std::find_if(kept_.begin(), kept_.end(), [goal](const Kept& kept) {
      return kept.search->goal() == goal;
    });
    if (found != kept_.end()) {
      std::rotate(kept_.begin(), found, found + 1);
    } else {
      ++made_;
      kept_.insert(kept_.begin(), Kept{std::make_unique<GoalSearch<Ground>>(ground_, goal)});
    }
    return *kept_.front().search;
  }

  const Ground& ground_;
  std::vector<Kept> kept_;  // last used first
  int made_ = 0;
};

/// A number of the part that each cell of a terrain is in, 0 for closed cells. Ways exist within a
/// part and nowhere else. A diagonal step passes two open cells, so cells hang together by their
/// sides.
std::vector<std::int32_t> openParts(const Terrain& terrain) {
  std::vector<std::int32_t> parts(terrain.size(), 0);
  std::vector<Terrain::Index> waiting;
  std::int32_t part = 0;
  const auto enter = [&](Terrain::Index index) {
    std::int32_t& its = parts[static_cast<std::size_t>(index)];
    if (terrain.isOpen(index) && its == 0) {
      its = part;
      waiting.push_back(index);
    }
  };
  for (Terrain::Index index = 0; index < static_cast<Terrain::Index>(parts.size()); ++index) {
    ++part;
    enter(index);
    while (!waiting.empty()) {  // the closed cells all round a terrain keep the search inside
      terrain.stopFlag().check();
      const Terrain::Index at = waiting.back();
      waiting.pop_back();
      for (const Terrain::Index side : {-1, 1, -terrain.stride(), terrain.stride()}) {
        enter(at + side);
      }
    }
  }
  return parts;
}

template <class Ground>
void appendWay(const Ground& terrain, const GoalSearch<Ground>& field, Cell from,
               std::vector<Cell>& way) {
  for (Terrain::Index at = terrain.indexOf(from); at != field.goal();) {
    at = field.next(at);
    way.push_back(terrain.cellOf(at));
  }
}

template <class Ground>
class CellWays : public WayFinder {
 public:
  explicit CellWays(const WalkSpace& space)
      : terrain_(space.field(), space.radius()), searches_(terrain_) {}

  bool isReachable(Cell from, Cell to) override {
    if (parts_.empty()) {  // made once; answers for all pairs of places without a search
      parts_ = openParts(terrain_);
    }
    return partOf(from) == partOf(to);
  }

  std::vector<Cell> way(Cell from, Cell to) override {
    const GoalSearch<Ground>* const field =
        searches_.reached(terrain_.indexOf(from), terrain_.indexOf(to));
    if (field == nullptr) {
      return {};
    }
    std::vector<Cell> way = {from};
    appendWay(terrain_, *field, from, way);
    return way;
  }

  int searches() const override { return searches_.made(); }
  std::size_t bytes() const override {
    return terrain_.size() + sizeof(std::int32_t) * parts_.size() + searches_.bytes();
  }
  const Terrain* roomTerrain() const override {
    return std::is_same_v<Ground, Terrain> ? &terrain_ : nullptr;
  }

 private:
  std::int32_t partOf(Cell cell) const {
    return parts_[static_cast<std::size_t>(terrain_.indexOf(cell))];
  }

  Ground terrain_;
  Searches<Ground> searches_;
  std::vector<std::int32_t> parts_;
};

/// Which blocks to pass comes from the graph, with lengths that are rough by about a block; how to
/// pass them from the cells, so that ways keep their clearance and exist where they do by cells.
class BlockWays : public WayFinder {
 public:
  explicit BlockWays(const WalkSpace& space)
      : space_(space), graph_(space.field(), space.radius()), searches_(graph_) {}

  bool isReachable(Cell from, Cell to) override {
    return graph_.part(graph_.nodeOf(from)) == graph_.part(graph_.nodeOf(to));
  }

  std::vector<Cell> way(Cell from, Cell to) override {
    BlockGraph::Index node = graph_.nodeOf(from);
    const GoalSearch<BlockGraph>* const search = searches_.reached(node, graph_.nodeOf(to));
    if (search == nullptr) {
      return {};
    }
    std::vector<Cell> way = {from};
    while (node != search->goal()) {
      node = search->next(node);
      appendLeg(node == search->goal() ? to : graph_.anchor(node), way);
    }
    if (way.back() != to) {  // both in one block
      appendLeg(to, way);
    }
    return way;
  }

  int searches() const override { return searches_.made(); }
  std::size_t bytes() const override { return graph_.bytes() + searches_.bytes(); }

 private:
  /// Straight where that keeps the clearance of the worse end, to one cell, else cell by cell
  /// within the blocks of both ends, which hold a way between them.
  void appendLeg(Cell to, std::vector<Cell>& way) const {
    const Cell from = way.back();
    const DistanceField& field = space_.field();
    const double lowest = std::min({field.distanceAt(from), field.distanceAt(to),
                                    space_.radius() + kWantedClearance}) -
                          field.grid().resolution();
    const bool isUnknown = field.grid().isUnknown(from) && field.grid().isUnknown(to);
    if (space_.lineKeeps(field.grid().cellToWorld(from), field.grid().cellToWorld(to),
                         std::max(space_.bodyRadius(), lowest), isUnknown)) {
      way.push_back(to);
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
    GoalField search(blocks, blocks.indexOf(to));
    if (search.reach(blocks.indexOf(from))) {
      appendWay(blocks, search, from, way);
    }
  }

  const WalkSpace& space_;
  BlockGraph graph_;
  Searches<BlockGraph> searches_;
};

}  // namespace

std::unique_ptr<WayFinder> makeWayFinder(const WalkSpace& space, Prices prices) {
  if (prices == Prices::Length) {
    return std::make_unique<CellWays<EvenTerrain>>(space);
  }
  if (space.field().isLarge()) {
    return std::make_unique<BlockWays>(space);
  }
  return std::make_unique<CellWays<Terrain>>(space);
}

}  // namespace sim2d
