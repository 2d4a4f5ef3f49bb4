#include <optional>
#include <string>

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

bool isFree(const std::vector<Start>& placed, const Start& start, const Vec2& place) {
  for (const Start& other : placed) {
    const bool pass = start.passesPeople && other.passesPeople;
    if (!pass && (*other.position - place).norm() < start.radius + other.radius - kOverlap) {
      return false;
    }
  }
  return true;
}

/// The nearest free place that can be seen from the start, on rings round it.
std::optional<Vec2> nearestFree(const std::vector<Start>& placed, const Start& start, Ways& ways) {
  for (double distance = kRing; distance <= kReach; distance += kRing) {
    for (int k = 0; k < kPlacesOnRing; ++k) {
      const double angle = 2.0 * base::kPi * k / kPlacesOnRing;
      const Vec2 place = *start.position + distance * Vec2(base::cos(angle), base::sin(angle));
      if (isFree(placed, start, place) && ways.clearance(place) >= start.radius &&
          ways.isClear(start.radius, *start.position, place)) {
        return place;
      }
    }
  }
  return std::nullopt;
}

void put(std::vector<Start>& placed, const Start& start, Ways& ways, base::Diagnostics& problems) {
  if (!isFree(placed, start, *start.position)) {
    const std::string who = "start of '" + start.name + "' " + shown(*start.position);
    if (const std::optional<Vec2> place = nearestFree(placed, start, ways)) {
      *start.position = *place;
      problems.push_back(
          about(base::makeWarning(who + " is taken by another body, " + shown(*place) + " is used"),
                start.key));
    } else {
      problems.push_back(about(
          base::makeWarning(who + " is taken by another body and no place is free within 1 m; they "
                                  "are pushed apart"),
          start.key));
    }
  }
  placed.push_back(start);
}

}  // namespace

void partStarts(WorldModel& model, Ways& ways, base::Diagnostics& problems) {
  std::vector<Start> placed;
  for (Person& person : model.people) {
    if (person.constants.startTime <= 0.0) {
      put(placed,
          {person.constants.name, person.definition->key, person.constants.radius,
           &person.constants.start.position, model.peoplePass},
          ways, problems);
    }
  }
  for (ResolvedRobot& robot : model.robots) {
    put(placed,
        {robot.name, keyOfRobot(model, robot), reachOf(robot), &robot.start.position, false}, ways,
        problems);
  }
}

}  // namespace sim2d
