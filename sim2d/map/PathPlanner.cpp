#include "sim2d/map/PathPlanner.h"

#include <algorithm>
#include <cassert>
#include <utility>

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
      const Terrain::Index at = waiting.back();
      waiting.pop_back();
      for (const Terrain::Index side : {-1, 1, -terrain.stride(), terrain.stride()}) {
        enter(at + side);
      }
    }
  }
  return parts;
}

}  // namespace

double lengthOfWay(const std::vector<Vec2>& way) {
  return way.empty() ? 0.0 : lengthOfWay(way.front(), way, 1);
}

double lengthOfWay(const Vec2& from, const std::vector<Vec2>& way, std::size_t first) {
  double length = 0.0;
  Vec2 at = from;
  for (std::size_t i = first; i < way.size(); ++i) {
    length += (way[i] - at).norm();
    at = way[i];
  }
  return length;
}

PathPlanner::PathPlanner(std::shared_ptr<const DistanceField> field, double radius)
    : space_(std::move(field), radius) {
  assert(radius >= 0.0);
}

/// The field of an open goal cell; the least recently used one makes room.
GoalField& PathPlanner::fieldOf(Cell goal) {
  const Terrain& terrain = space_.terrain();
  const Terrain::Index index = terrain.indexOf(goal);
  const auto found = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const auto& entry) { return entry->goal() == index; });
  if (found != fields_.end()) {
    std::rotate(fields_.begin(), found, found + 1);
    return *fields_.front();
  }
  const std::size_t bytes = sizeof(std::uint32_t) * terrain.size();
  const std::size_t most = std::clamp<std::size_t>(kCacheBytes / bytes, 2, kMostFields);
  if (fields_.size() >= most) {
    fields_.pop_back();
  }
  fields_.insert(fields_.begin(), std::make_unique<GoalField>(terrain, index));
  return *fields_.front();
}

std::vector<Vec2> PathPlanner::walk(const WalkSpace::Anchor& start, const WalkSpace::Anchor& goal,
                                    const GoalField& field) const {
  CellWay way(space_);
  way.append(start.place);
  way.append(space_.grid().cellToWorld(start.cell));
  for (Terrain::Index at = space_.terrain().indexOf(start.cell); at != field.goal();) {
    at = field.next(at);
    way.append(space_.grid().cellToWorld(space_.terrain().cellOf(at)));
  }
  way.append(goal.place);
  return way.pulled();
}

std::vector<Vec2> PathPlanner::plan(const Vec2& start, const Vec2& goal) {
  const std::optional<WalkSpace::Anchor> from = space_.anchorOf(start);
  const std::optional<WalkSpace::Anchor> to = space_.anchorOf(goal);
  if (!from || !to) {
    return {};
  }
  std::vector<Vec2> way;
  const double comfortable = space_.bodyRadius() + kWantedClearance;
  if (space_.lineKeeps(from->place, to->place, comfortable, false)) {
    way = {from->place, to->place};
  } else {
    const std::lock_guard<std::mutex> lock(mutex_);
    GoalField& field = fieldOf(to->cell);
    if (!field.reach(space_.terrain().indexOf(from->cell))) {
      return {};
    }
    way = walk(*from, *to, field);
  }
  if (from->place != start && space_.leadsOut(start, from->place)) {
    way.insert(way.begin(), start);
  }
  return way;
}

bool PathPlanner::isReachable(const Vec2& start, const Vec2& goal) {
  const std::optional<WalkSpace::Anchor> from = space_.anchorOf(start);
  const std::optional<WalkSpace::Anchor> to = space_.anchorOf(goal);
  if (!from || !to) {
    return false;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (parts_.empty()) {  // made once; answers for all pairs of places without a search
    parts_ = openParts(space_.terrain());
  }
  const auto partOf = [this](Cell cell) {
    return parts_[static_cast<std::size_t>(space_.terrain().indexOf(cell))];
  };
  return partOf(from->cell) == partOf(to->cell);
}

}  // namespace sim2d
