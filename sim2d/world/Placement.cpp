#include "sim2d/world/Placement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

constexpr double kPositionTolerance = 1e-9;  // [m]
constexpr double kOverlap = 0.01;            // [m], accepted overlap of starts
constexpr double kRingSpacing = 0.05;        // [m] between rings of candidate places
constexpr int kPlacesOnRing = 24;
constexpr int kMaxOverlapping = 1000;  // maximum number of overlapping starts

/// Moves the point to a place where a body of this radius fits; `what` names it in messages.
void fit(Vec2& point, double radius, const std::string& what, EntityId entity,
         const NavigationMap& navigation, base::Diagnostics& problems) {
  const std::optional<Vec2> place = navigation.nearestFreePosition(radius, point);
  EntityProblems found(entity, what + " " + base::pointText(point), problems);
  found.need(place.has_value(), "world.body-does-not-fit");
  if (place && (*place - point).norm() > kPositionTolerance) {
    found.add(base::warning("world.body-moved", {base::pointText(*place)}));
    point = *place;
  }
}

/// Largest radius of the bodies that use each goal by a planned path, by goal id.
std::map<int, double> radiiByGoal(const WorldModel& model) {
  std::map<int, double> radii;
  const auto include = [&radii](int goal, double radius) {
    double& largest = radii[goal];
    largest = std::max(largest, radius);
  };
  for (const Person& person : model.people) {
    if (person.constants.route == Route::Planned) {
      for (const int goal : person.plan->written) {
        include(goal, person.constants.radius);
      }
    }
  }
  for (const ResolvedRobot& robot : model.robots) {
    for (const int goal : robot.goalIds) {
      include(goal, circumscribedRadius(robot));
    }
  }
  return radii;
}

struct Start {
  std::string name;
  EntityId key;
  double radius = 0.35;  // [m]
  Vec2* position = nullptr;
  bool passesPeople = false;
};

/// Start positions in square cells as wide as the two largest bodies, so that only the neighbouring
/// cells need to be searched.
class PlacedStarts {
 public:
  explicit PlacedStarts(double largestRadius) : cell_(std::max(0.1, 2.0 * largestRadius)) {}

  /// Skips a start that covers no additional area, so that many people at the same place are not
  /// searched repeatedly.
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
        if (found != starts_.end() && overlaps(found->second, start, place)) {
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
    constexpr double kLastCell = 1e15;  // cells; positions beyond share the last one
    return static_cast<std::int64_t>(std::clamp(std::floor(place / cell_), -kLastCell, kLastCell));
  }
  static bool overlaps(const std::vector<Start>& others, const Start& start, const Vec2& place) {
    return std::any_of(others.begin(), others.end(), [&](const Start& other) {
      const bool pass = start.passesPeople && other.passesPeople;
      return !pass && (*other.position - place).norm() < start.radius + other.radius - kOverlap;
    });
  }

  double cell_;  // [m]
  std::map<Cell, std::vector<Start>> starts_;
};

/// Nearest free place that is visible from the start, on rings around it.
std::optional<Vec2> nearestFree(const PlacedStarts& placed, const Start& start,
                                const NavigationMap& navigation) {
  double distance = kRingSpacing;
  while (distance <= kMaxPlacementShift) {
    for (int k = 0; k < kPlacesOnRing; ++k) {
      const double angle = 2.0 * base::kPi * k / kPlacesOnRing;
      const Vec2 place = *start.position + distance * Vec2(base::cos(angle), base::sin(angle));
      if (placed.isFree(start, place) && navigation.clearance(place) >= start.radius &&
          navigation.isClear(start.radius, *start.position, place)) {
        return place;
      }
    }
    distance += kRingSpacing;
  }
  return std::nullopt;
}

/// Returns false if it still overlaps another body.
bool placeStart(PlacedStarts& placed, const Start& start, const NavigationMap& navigation,
                base::Diagnostics& problems) {
  bool isParted = true;
  if (!placed.isFree(start, *start.position)) {
    const std::string place = "start of '" + start.name + "' " + base::pointText(*start.position);
    EntityProblems found(start.key, {}, problems);
    if (const std::optional<Vec2> taken = nearestFree(placed, start, navigation)) {
      *start.position = *taken;
      found.add(base::warning("world.start-taken", {place, base::pointText(*taken)}));
    } else {
      found.add(base::warning("world.start-crowded", {place}));
      isParted = false;
    }
  }
  placed.add(start);
  return isParted;
}

/// Moves the later one of overlapping starts (robots come after people) to the nearest free place
/// within 1 m, with a warning that contains both points.
void separateStarts(WorldModel& model, const NavigationMap& navigation,
                    base::Diagnostics& problems) {
  std::vector<Start> starts;
  for (Person& person : model.people) {
    if (person.constants.startTime <= 0.0) {
      starts.push_back({person.constants.name, person.key, person.constants.radius,
                        &person.constants.start.position, model.peoplePass});
    }
  }
  for (std::size_t i = 0; i < model.robots.size(); ++i) {
    ResolvedRobot& robot = model.robots[i];
    starts.push_back(
        {robot.name, model.robotKeys[i], circumscribedRadius(robot), &robot.start.position, false});
  }
  double largest = 0.0;
  for (const Start& start : starts) {
    largest = std::max(largest, start.radius);
  }
  PlacedStarts placed(largest);
  int crowded = 0;
  for (const Start& start : starts) {
    crowded += placeStart(placed, start, navigation, problems) ? 0 : 1;
    if (crowded > kMaxOverlapping) {
      EntityProblems(start.key, {}, problems)
          .add(base::error("world.too-many-crowded", {kMaxOverlapping}));
      return;
    }
  }
}

}  // namespace

std::vector<Vec2> placementPoints(const WorldModel& model) {
  std::vector<Vec2> places;
  for (const Person& person : model.people) {
    places.push_back(person.constants.start.position);
  }
  for (const ResolvedRobot& robot : model.robots) {
    places.push_back(robot.start.position);
    places.insert(places.end(), robot.goals.begin(), robot.goals.end());
  }
  for (const auto& goal : model.globalGoals) {
    places.push_back(goal.second);
  }
  for (const Area* area : model.areas) {
    places.insert(places.end(), area->points.begin(), area->points.end());
  }
  return places;
}

void checkPlacement(const WorldModel& model, base::Diagnostics& problems) {
  for (const Person& person : model.people) {
    const Pose2& start = person.constants.start;
    EntityProblems found(person.key, "person '" + person.constants.name + "'", problems);
    found.need(base::isWithinCoordinateRange(start.position) && std::isfinite(start.heading),
               "world.pose-too-far");
    for (const int goal : person.plan->written) {
      found.need(model.globalGoals.count(goal) != 0, "world.goal-unknown", {goal});
    }
  }
  for (std::size_t i = 0; i < model.robots.size(); ++i) {
    const ResolvedRobot& robot = model.robots[i];
    EntityProblems(model.robotKeys[i], "robot '" + robot.name + "'", problems)
        .need(
            base::isWithinCoordinateRange(robot.start.position) &&
                std::isfinite(robot.start.heading) &&
                std::all_of(robot.goals.begin(), robot.goals.end(), base::isWithinCoordinateRange),
            "world.robot-too-far");
  }
  for (const GlobalGoal& goal : model.environment->goals) {
    EntityProblems(goal.key, {}, problems)
        .need(base::isWithinCoordinateRange(goal.position), "world.goal-too-far", {goal.id});
  }
}

void fitPlacement(WorldModel& model, const NavigationMap& navigation, base::Diagnostics& problems) {
  const std::map<int, double> radii = radiiByGoal(model);
  for (const GlobalGoal& goal : model.environment->goals) {
    const auto radius = radii.find(goal.id);
    if (radius != radii.end() && radius->second > 0.0) {
      fit(model.globalGoals[goal.id], radius->second, "goal " + std::to_string(goal.id), goal.key,
          navigation, problems);
    }
  }
  for (Person& person : model.people) {
    fit(person.constants.start.position, person.constants.radius,
        "start of '" + person.constants.name + "'", person.key, navigation, problems);
  }
  for (std::size_t k = 0; k < model.robots.size(); ++k) {
    ResolvedRobot& robot = model.robots[k];
    const EntityId key = model.robotKeys[k];
    fit(robot.start.position, circumscribedRadius(robot), "start of '" + robot.name + "'", key,
        navigation, problems);
    for (std::size_t i = 0; i < robot.goals.size(); ++i) {
      if (robot.goalIds[i] > 0) {
        robot.goals[i] = model.globalGoals.at(robot.goalIds[i]);
      } else {
        fit(robot.goals[i], circumscribedRadius(robot), "goal of '" + robot.name + "'", key,
            navigation, problems);
      }
    }
  }
  separateStarts(model, navigation, problems);
}

void removeUnreachableGoals(WorldModel& model, const NavigationMap& navigation,
                            base::Diagnostics& problems) {
  for (Person& person : model.people) {
    if (person.constants.route == Route::Direct) {
      continue;
    }
    EntityProblems found(person.key, "person '" + person.constants.name + "'", problems);
    GoalPlan plan = *person.plan;
    const auto isOutOfReach = [&](const GoalItem& goal) {
      const bool isReachable = navigation.isReachable(
          person.constants.radius, person.constants.start.position, goal.position);
      if (!isReachable) {
        found.add(base::warning("world.goal-out-of-reach", {goal.id}));
      }
      return !isReachable;
    };
    plan.goals.erase(std::remove_if(plan.goals.begin(), plan.goals.end(), isOutOfReach),
                     plan.goals.end());
    if (plan.goals.size() < person.plan->goals.size()) {
      person.plan = std::make_shared<GoalPlan>(std::move(plan));
    }
  }
  for (std::size_t k = 0; k < model.robots.size(); ++k) {
    ResolvedRobot& robot = model.robots[k];
    EntityProblems found(model.robotKeys[k], "robot '" + robot.name + "'", problems);
    std::vector<Vec2> goals;
    std::vector<int> ids;
    for (std::size_t i = 0; i < robot.goals.size(); ++i) {
      if (navigation.isReachable(circumscribedRadius(robot), robot.start.position,
                                 robot.goals[i])) {
        goals.push_back(robot.goals[i]);
        ids.push_back(robot.goalIds[i]);
      } else {
        found.add(base::warning("world.point-out-of-reach", {base::pointText(robot.goals[i])}));
      }
    }
    robot.goals = std::move(goals);
    robot.goalIds = std::move(ids);
  }
}

}  // namespace sim2d
