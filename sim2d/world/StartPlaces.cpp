#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/world/Placement.h"

namespace sim2d {
namespace {

constexpr double kOverlap = 0.01;  // [m] that starts may stand in each other
constexpr double kReach = 1.0;     // [m] that a start may be moved
constexpr double kRing = 0.05;     // [m] between the places tried
constexpr int kPlacesOnRing = 24;

struct Start {
  std::string name;
  EntityId key;
  double radius = 0.35;  // [m]
  Vec2* position = nullptr;
  bool passesPeople = false;
};

/// The starts so far, in square cells as wide as the largest two bodies, so that only the cells
/// round a place need a look.
class PlacedStarts {
 public:
  explicit PlacedStarts(double largestRadius) : cell_(std::max(0.1, 2.0 * largestRadius)) {}

  /// Who takes no room that is not taken is left out, so that a heap of people in one place is not
  /// looked through by each of them.
  void add(const Start& start) {
    std::vector<Start>& starts = starts_[cellOf(*start.position)];
    const bool isHidden = std::any_of(starts.begin(), starts.end(), [&start](const Start& other) {
      return *other.position == *start.position && other.radius >= start.radius &&
             other.passesPeople == start.passesPeople;
    });
    if (!isHidden) {
      starts.push_back(start);
    }
  }

  bool isFree(const Start& start, const Vec2& place) const {
    const Cell middle = cellOf(place);
    for (std::int64_t x = middle.first - 1; x <= middle.first + 1; ++x) {
      for (std::int64_t y = middle.second - 1; y <= middle.second + 1; ++y) {
        const auto found = starts_.find({x, y});
        if (found != starts_.end() && standsIn(found->second, start, place)) {
          return false;
        }
      }
    }
    return true;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;

  Cell cellOf(const Vec2& place) const { return {indexOf(place.x()), indexOf(place.y())}; }
  std::int64_t indexOf(double place) const {
    constexpr double kFarthest = 1e15;  // cells; what is beyond shares the last one
    return static_cast<std::int64_t>(std::clamp(std::floor(place / cell_), -kFarthest, kFarthest));
  }
  static bool standsIn(const std::vector<Start>& others, const Start& start, const Vec2& place) {
    return std::any_of(others.begin(), others.end(), [&](const Start& other) {
      const bool pass = start.passesPeople && other.passesPeople;
      return !pass && (*other.position - place).norm() < start.radius + other.radius - kOverlap;
    });
  }

  double cell_;  // [m]
  std::map<Cell, std::vector<Start>> starts_;
};

double largestRadius(const WorldModel& model) {
  double largest = 0.0;
  for (const Person& person : model.people) {
    largest = std::max(largest, person.constants.radius);
  }
  for (const ResolvedRobot& robot : model.robots) {
    largest = std::max(largest, reachOf(robot));
  }
  return largest;
}

/// The nearest free place that can be seen from the start, on rings round it.
std::optional<Vec2> nearestFree(const PlacedStarts& placed, const Start& start,
                                const NavigationMap& navigation) {
  for (double distance = kRing; distance <= kReach; distance += kRing) {
    for (int k = 0; k < kPlacesOnRing; ++k) {
      const double angle = 2.0 * base::kPi * k / kPlacesOnRing;
      const Vec2 place = *start.position + distance * Vec2(base::cos(angle), base::sin(angle));
      if (placed.isFree(start, place) && navigation.clearance(place) >= start.radius &&
          navigation.isClear(start.radius, *start.position, place)) {
        return place;
      }
    }
  }
  return std::nullopt;
}

void put(PlacedStarts& placed, const Start& start, const NavigationMap& navigation,
         base::Diagnostics& problems) {
  if (!placed.isFree(start, *start.position)) {
    const std::string place = "start of '" + start.name + "' " + shown(*start.position);
    if (const std::optional<Vec2> taken = nearestFree(placed, start, navigation)) {
      *start.position = *taken;
      problems.push_back(
          about(base::warning("world.start-taken", {place, shown(*taken)}), start.key));
    } else {
      problems.push_back(about(base::warning("world.start-crowded", {place}), start.key));
    }
  }
  placed.add(start);
}

}  // namespace

void partStarts(WorldModel& model, const NavigationMap& navigation, base::Diagnostics& problems) {
  PlacedStarts placed(largestRadius(model));
  for (Person& person : model.people) {
    if (person.constants.startTime <= 0.0) {
      put(placed,
          {person.constants.name, person.key, person.constants.radius,
           &person.constants.start.position, model.peoplePass},
          navigation, problems);
    }
  }
  for (ResolvedRobot& robot : model.robots) {
    put(placed,
        {robot.name, keyOfRobot(model, robot), reachOf(robot), &robot.start.position, false},
        navigation, problems);
  }
}

}  // namespace sim2d
