#include "sim2d/map/PathPlanner.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

#include "sim2d/map/WalkSpace.h"

namespace sim2d {

namespace {

constexpr std::size_t kCacheBytes = std::size_t{128} << 20U;
constexpr std::size_t kMostFields = 64;

/// The places of a way over cells, to be pulled straight.
class CellWay {
 public:
  explicit CellWay(const WalkSpace& space) : space_(space) {}

  void append(const Vec2& place) {
    const int before = unknownUpTo_.empty() ? 0 : unknownUpTo_.back();
    places_.push_back(place);
    clearance_.push_back(space_.field().distanceAt(place));
    unknownUpTo_.push_back(before + (space_.isUnknown(place) ? 1 : 0));
  }

  std::vector<Vec2> pulled() const {
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
  /// A straight leg may replace the way between two places when it keeps about the clearance that
  /// the way has there (all that is wanted at most, the radius at least), and when it enters
  /// unknown cells only in place of such.
  bool canShorten(std::size_t from, std::size_t to, double lowest) const {
    const int unknown = unknownUpTo_[to] - (from > 0 ? unknownUpTo_[from - 1] : 0);
    const bool isAllUnknown = unknown == static_cast<int>(to - from + 1);
    if (unknown > 0 && !isAllUnknown) {
      return false;
    }
    const double wanted =
        std::min(space_.radius() + kWantedClearance, lowest - space_.grid().resolution());
    const double clearance = std::max(space_.bodyRadius(), wanted);
    return space_.lineKeeps(places_[from], places_[to], clearance, isAllUnknown);
  }

  /// The farthest place that a straight leg reaches, by doubling and halving.
  std::size_t farthestFrom(std::size_t from) const {
    const std::size_t last = places_.size() - 1;
    std::vector<double> lowest{clearance_[from]};  // of the places from..from + i
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

  const WalkSpace& space_;
  std::vector<Vec2> places_;
  std::vector<double> clearance_;  // [m]
  std::vector<int> unknownUpTo_;   // unknown places among those up to each
};

/// Which open cells of a terrain hang together: ways exist within a part and nowhere else. A
/// diagonal step passes two open cells, so cells hang together by their sides.
class OpenParts {
 public:
  explicit OpenParts(const Terrain& terrain) : parts_(terrain.size(), 0) {
    std::int32_t part = 0;
    for (Terrain::Index index = 0; index < static_cast<Terrain::Index>(parts_.size()); ++index) {
      if (terrain.isOpen(index) && partOf(index) == 0) {
        fill(terrain, index, ++part);
      }
    }
  }
  /// The part of a cell, from 1; 0 for closed cells.
  std::int32_t partOf(Terrain::Index index) const {
    return parts_[static_cast<std::size_t>(index)];
  }

 private:
  /// The closed cells all round a terrain keep the search inside.
  void fill(const Terrain& terrain, Terrain::Index from, std::int32_t part) {
    std::vector<Terrain::Index> waiting{from};
    parts_[static_cast<std::size_t>(from)] = part;
    while (!waiting.empty()) {
      const Terrain::Index at = waiting.back();
      waiting.pop_back();
      for (const Terrain::Index next :
           {at - 1, at + 1, at - terrain.stride(), at + terrain.stride()}) {
        if (terrain.isOpen(next) && partOf(next) == 0) {
          parts_[static_cast<std::size_t>(next)] = part;
          waiting.push_back(next);
        }
      }
    }
  }

  std::vector<std::int32_t> parts_;
};

}  // namespace

double Path::length() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += (points[i] - points[i - 1]).norm();
  }
  return sum;
}

struct PathPlanner::Search {
  Search(std::shared_ptr<const DistanceField> field, double radius)
      : space(std::move(field), radius) {}

  /// The field of an open goal cell; the least recently used one makes room.
  GoalField& fieldOf(Cell goal) {
    const Terrain& terrain = space.terrain();
    const Terrain::Index index = terrain.indexOf(goal);
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const auto& entry) { return entry->goal() == index; });
    if (found != fields.end()) {
      std::rotate(fields.begin(), found, found + 1);
      return *fields.front();
    }
    const std::size_t bytes = sizeof(std::uint32_t) * terrain.size();
    const std::size_t most = std::clamp<std::size_t>(kCacheBytes / bytes, 2, kMostFields);
    if (fields.size() >= most) {
      fields.pop_back();
    }
    fields.insert(fields.begin(), std::make_unique<GoalField>(terrain, index));
    return *fields.front();
  }

  std::vector<Vec2> walk(const WalkSpace::Anchor& start, const WalkSpace::Anchor& goal,
                         const GoalField& field) const {
    CellWay way(space);
    way.append(start.place);
    way.append(space.grid().cellToWorld(start.cell));
    for (Terrain::Index at = space.terrain().indexOf(start.cell); at != field.goal();) {
      at = field.next(at);
      way.append(space.grid().cellToWorld(space.terrain().cellOf(at)));
    }
    way.append(goal.place);
    return way.pulled();
  }

  /// Made once; answers for all pairs of places without a search.
  const OpenParts& openParts() {
    if (parts == nullptr) {
      parts = std::make_unique<OpenParts>(space.terrain());
    }
    return *parts;
  }

  WalkSpace space;
  std::mutex mutex;                                // of what follows
  std::vector<std::unique_ptr<GoalField>> fields;  // last used first
  std::unique_ptr<OpenParts> parts;
};

PathPlanner::PathPlanner(std::shared_ptr<const DistanceField> field, double radius)
    : search_(std::make_shared<Search>(std::move(field), radius)) {
  assert(radius >= 0.0);
}

double PathPlanner::radius() const {
  return search_->space.radius();
}

Path PathPlanner::plan(const Vec2& start, const Vec2& goal) {
  const WalkSpace& space = search_->space;
  const std::optional<WalkSpace::Anchor> from = space.anchorOf(start);
  const std::optional<WalkSpace::Anchor> to = space.anchorOf(goal);
  if (!from || !to) {
    return {};
  }
  Path path;
  const double comfortable = space.bodyRadius() + kWantedClearance;
  if (space.lineKeeps(from->place, to->place, comfortable, false)) {
    path.points = {from->place, to->place};
  } else {
    const std::lock_guard<std::mutex> lock(search_->mutex);
    GoalField& field = search_->fieldOf(to->cell);
    if (!field.reach(space.terrain().indexOf(from->cell))) {
      return {};
    }
    path.points = search_->walk(*from, *to, field);
  }
  if (from->place != start && space.leadsOut(start, from->place)) {
    path.points.insert(path.points.begin(), start);
  }
  return path;
}

bool PathPlanner::isReachable(const Vec2& start, const Vec2& goal) {
  const WalkSpace& space = search_->space;
  const std::optional<WalkSpace::Anchor> from = space.anchorOf(start);
  const std::optional<WalkSpace::Anchor> to = space.anchorOf(goal);
  const std::lock_guard<std::mutex> lock(search_->mutex);
  const auto partOf = [this, &space](const WalkSpace::Anchor& anchor) {
    return search_->openParts().partOf(space.terrain().indexOf(anchor.cell));
  };
  return from && to && partOf(*from) == partOf(*to);
}

bool PathPlanner::isClear(const Vec2& from, const Vec2& to) const {
  return search_->space.lineKeeps(from, to, search_->space.bodyRadius(), true);
}

std::optional<Vec2> PathPlanner::nearestFit(const Vec2& point) const {
  return search_->space.nearestFit(point);
}

}  // namespace sim2d
