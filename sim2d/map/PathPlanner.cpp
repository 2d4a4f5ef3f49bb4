#include "sim2d/map/PathPlanner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "sim2d/map/GoalSearch.h"
#include "sim2d/map/Outlines.h"

namespace sim2d {

namespace {

using Polygons = std::vector<std::vector<Vec2>>;
constexpr double kMaxAround = 4e6;  // cells of a search around polygons

bool meets(const Polygons& polygons, const Vec2& from, const Vec2& to) {
  return std::any_of(polygons.begin(), polygons.end(), [&](const std::vector<Vec2>& polygon) {
    return entryPoint(polygon, from, to).has_value();
  });
}

/// A rectangle of cells, both corners included.
struct CellBox {
  Cell low, high;
};

/// Cells of a terrain inside a box and outside polygons. At most one object per thread.
class MaskedTerrain {
 public:
  using Index = Terrain::Index;

  MaskedTerrain(const Terrain& terrain, const CellBox& box, const OccupancyGrid& grid,
                const Polygons& closed)
      : terrain_(terrain), box_(box), isClosed_(marks(terrain.size())) {
    fillBox(0);
    for (const std::vector<Vec2>& polygon : closed) {
      close(grid, polygon);
    }
  }
  ~MaskedTerrain() { fillBox(1); }
  MaskedTerrain(const MaskedTerrain&) = delete;
  MaskedTerrain& operator=(const MaskedTerrain&) = delete;
  MaskedTerrain(MaskedTerrain&&) = delete;
  MaskedTerrain& operator=(MaskedTerrain&&) = delete;

  std::size_t size() const { return terrain_.size(); }
  const base::StopFlag& stopFlag() const { return terrain_.stopFlag(); }
  bool isUnknown(Index index) const { return terrain_.isUnknown(index); }
  bool isClosed(Index index) const { return isClosed_[static_cast<std::size_t>(index)] != 0; }
  template <class Visit>
  void forEachStep(Index from, Visit visit) const {
    terrain_.forEachStep(from, [&](Index to, std::uint32_t cost) {
      if (!isClosed(to)) {
        visit(to, cost);
      }
    });
  }

 private:
  /// All cells are closed between two searches: refilling the buffer of a large map would cost more
  /// than a search.
  static std::vector<char>& marks(std::size_t size) {
    thread_local std::vector<char> all;
    if (all.size() < size) {
      all.resize(size, 1);
    }
    return all;
  }

  void fillBox(char value) {
    for (int row = box_.low.row; row <= box_.high.row; ++row) {
      std::fill(isClosed_.begin() + terrain_.indexOf({box_.low.column, row}),
                isClosed_.begin() + terrain_.indexOf({box_.high.column, row}) + 1, value);
    }
  }

  void close(const OccupancyGrid& grid, const std::vector<Vec2>& polygon) {
    Cell low = box_.high;
    Cell high = box_.low;
    for (const Vec2& corner : polygon) {
      const Cell cell = grid.worldToCell(corner);
      low = {std::min(low.column, cell.column), std::min(low.row, cell.row)};
      high = {std::max(high.column, cell.column), std::max(high.row, cell.row)};
    }
    for (int row = std::max(low.row, box_.low.row); row <= std::min(high.row, box_.high.row);
         ++row) {
      for (int column = std::max(low.column, box_.low.column);
           column <= std::min(high.column, box_.high.column); ++column) {
        char& mark = isClosed_[static_cast<std::size_t>(terrain_.indexOf({column, row}))];
        if (mark == 0 && isInside(polygon, grid.cellToWorld({column, row}))) {
          mark = 1;
        }
      }
    }
  }

  const Terrain& terrain_;
  const CellBox box_;
  std::vector<char>& isClosed_;
};

/// The cells within kDetourRange of either cell.
CellBox boxAround(const OccupancyGrid& grid, Cell a, Cell b) {
  const int margin = static_cast<int>(PathPlanner::kDetourRange / grid.resolution());
  return {{std::max(0, std::min(a.column, b.column) - margin),
           std::max(0, std::min(a.row, b.row) - margin)},
          {std::min(grid.width() - 1, std::max(a.column, b.column) + margin),
           std::min(grid.height() - 1, std::max(a.row, b.row) + margin)}};
}

double cellsIn(const CellBox& box) {
  return double(box.high.column - box.low.column + 1) * double(box.high.row - box.low.row + 1);
}

/// A path over cells, to be shortened to straight legs.
class CellPath {
 public:
  explicit CellPath(const TraversableSpace& space, const Polygons& closed = {})
      : space_(space), closed_(closed) {}

  void append(const Vec2& place) {
    const int before = unknownUpTo_.empty() ? 0 : unknownUpTo_.back();
    places_.push_back(place);
    clearance_.push_back(space_.field().distanceAt(place));
    unknownUpTo_.push_back(before + (space_.isUnknown(place) ? 1 : 0));
  }

  std::vector<Vec2> tightened() const {
    std::vector<Vec2> points{places_.front()};
    for (std::size_t at = 0; at + 1 < places_.size();) {
      at = farthestFrom(at);
      if (places_[at] != points.back() || points.size() == 1) {
        points.push_back(places_[at]);
      }
    }
    return points;
  }

 private:
  /// A straight leg may replace the path between two places if it keeps about the clearance that
  /// the path has there (at most the preferred one, at least the radius), and enters unknown cells
  /// only where all places are unknown.
  bool canShorten(std::size_t from, std::size_t to, double lowest) const {
    const int unknown = unknownUpTo_[to] - (from > 0 ? unknownUpTo_[from - 1] : 0);
    const bool isAllUnknown = unknown == static_cast<int>(to - from + 1);
    if ((unknown > 0 && !isAllUnknown) || meets(closed_, places_[from], places_[to])) {
      return false;
    }
    const double wanted =
        std::min(space_.radius() + kPreferredClearance, lowest - space_.grid().resolution());
    const double clearance = std::max(space_.bodyRadius(), wanted);
    return space_.lineHasClearance(places_[from], places_[to], clearance, isAllUnknown);
  }

  /// The farthest place that a straight leg reaches, by exponential and binary search.
  std::size_t farthestFrom(std::size_t from) const {
    const std::size_t last = places_.size() - 1;
    std::vector<double> lowest{clearance_[from]};  // for places from..from + i
    const auto reaches = [&](std::size_t to) {
      while (lowest.size() <= to - from) {
        lowest.push_back(std::min(lowest.back(), clearance_[from + lowest.size()]));
      }
      return canShorten(from, to, lowest[to - from]);
    };
    std::size_t good = from + 1;
    std::size_t step = 1;
    while (good < last && reaches(std::min(good + step, last))) {
      good = std::min(good + step, last);
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (good + step <= last && reaches(good + step)) {
        good += step;
      }
    }
    return good;
  }

  const TraversableSpace& space_;
  Polygons closed_;  // polygons to avoid
  std::vector<Vec2> places_;
  std::vector<double> clearance_;  // [m]
  std::vector<int> unknownUpTo_;   // number of unknown places up to each
};

}  // namespace

double polylineLength(const std::vector<Vec2>& path) {
  return path.empty() ? 0.0 : polylineLength(path.front(), path, 1);
}

double polylineLength(const Vec2& from, const std::vector<Vec2>& path, std::size_t first) {
  double length = 0.0;
  Vec2 at = from;
  for (std::size_t i = first; i < path.size(); ++i) {
    length += (path[i] - at).norm();
    at = path[i];
  }
  return length;
}

PathPlanner::PathPlanner(std::shared_ptr<const DistanceField> field, double radius,
                         PathObjective objective)
    : space_(std::move(field), radius), objective_(objective) {
  assert(radius >= 0.0);
}

/// Created on first use: many bodies only need straight lines.
CellPathFinder& PathPlanner::finder() {
  if (finder_ == nullptr) {
    finder_ = makeCellPathFinder(space_, objective_);
  }
  return *finder_;
}

std::vector<Cell> PathPlanner::cellPath(Cell from, Cell to) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Cell> cells = finder().path(from, to);
  bytes_ = finder_->bytes();
  return cells;
}

/// Empty: there is no path.
std::vector<Vec2> PathPlanner::planThroughCells(const TraversableSpace::Anchor& from,
                                                const TraversableSpace::Anchor& to) {
  const std::vector<Cell> cells = cellPath(from.cell, to.cell);
  if (cells.empty()) {
    return {};
  }
  CellPath path(space_);
  path.append(from.place);
  for (const Cell cell : cells) {
    path.append(space_.grid().cellToWorld(cell));
  }
  path.append(to.place);
  return path.tightened();
}

std::vector<Vec2> PathPlanner::plan(const Vec2& start, const Vec2& goal) {
  const std::optional<TraversableSpace::Anchor> from = space_.anchorOf(start);
  const std::optional<TraversableSpace::Anchor> to = space_.anchorOf(goal);
  if (!from || !to) {
    return {};
  }
  std::vector<Vec2> path;
  const double comfortable = space_.bodyRadius() + kPreferredClearance;
  if (space_.lineHasClearance(from->place, to->place, comfortable, false)) {
    path = {from->place, to->place};
  } else {
    path = planThroughCells(*from, *to);
    if (path.empty()) {
      return {};
    }
  }
  if (from->place != start && space_.canExitTo(start, from->place)) {
    path.insert(path.begin(), start);
  }
  return path;
}

/// The cell costs of the finder also apply to any box. Null: the finder does not search cells.
const Terrain* PathPlanner::knownTerrain() {
  if (space_.field().isLarge()) {
    return nullptr;  // not worth building the block graph
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  const Terrain* const terrain = finder().clearanceTerrain();
  bytes_ = finder_->bytes();
  return terrain;
}

std::vector<Vec2> PathPlanner::planAround(const Vec2& start, const Vec2& goal,
                                          const Polygons& closed) {
  const std::optional<TraversableSpace::Anchor> from = space_.anchorOf(start);
  const std::optional<TraversableSpace::Anchor> to = space_.anchorOf(goal);
  if (!from || !to) {
    return {};
  }
  const CellBox box = boxAround(space_.grid(), from->cell, to->cell);
  if (cellsIn(box) > kMaxAround) {
    return {};
  }
  const Terrain* const known = knownTerrain();
  const std::optional<Terrain> own =
      known != nullptr ? std::optional<Terrain>()
                       : Terrain(space_.field(), space_.radius(), box.low, box.high);
  const Terrain& terrain = known != nullptr ? *known : *own;
  const MaskedTerrain open(terrain, box, space_.grid(), closed);
  const Terrain::Index begin = terrain.indexOf(from->cell);
  GoalSearch<MaskedTerrain> search(open, terrain.indexOf(to->cell));
  if (open.isClosed(begin) || open.isClosed(search.goal()) || !search.reach(begin)) {
    return {};
  }
  CellPath path(space_, closed);
  path.append(from->place);
  path.append(space_.grid().cellToWorld(from->cell));
  for (Terrain::Index at = begin; at != search.goal();) {
    at = search.next(at);
    path.append(space_.grid().cellToWorld(terrain.cellOf(at)));
  }
  path.append(to->place);
  return path.tightened();
}

bool PathPlanner::isReachable(const Vec2& start, const Vec2& goal) {
  const std::optional<TraversableSpace::Anchor> from = space_.anchorOf(start);
  const std::optional<TraversableSpace::Anchor> to = space_.anchorOf(goal);
  if (!from || !to) {
    return false;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool isThere = finder().isReachable(from->cell, to->cell);
  bytes_ = finder_->bytes();
  return isThere;
}

int PathPlanner::searches() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return finder_ == nullptr ? 0 : finder_->searches();
}

}  // namespace sim2d
