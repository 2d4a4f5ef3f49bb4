#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

void checkPolygon(const std::vector<Vec2>& points, const Subject& subject, CheckReport& report) {
  if (points.size() >= 3 && !isSimple(points)) {
    report.error(subject, "shape.sides-cross");
  }
}

/// Whether all points are in range.
bool checkPoints(const std::vector<Vec2>& points, const Subject& subject, CheckReport& report) {
  bool isGood = true;
  for (const Vec2& point : points) {
    if (!base::isWithinCoordinateRange(point)) {
      report.error(subject, "shape.too-far", {point.x(), point.y()});
      isGood = false;
    }
  }
  return isGood;
}

bool checkPose(const Pose2& pose, const Subject& subject, CheckReport& report) {
  const bool isNear = checkPoints({pose.position}, subject, report);
  const bool isAngle = std::fabs(pose.heading) <= base::kMaxCoordinate;
  if (!isAngle) {
    report.error(subject, "shape.no-angle", {pose.heading});
  }
  return isNear && isAngle;
}

/// A position that a body must fit.
struct Place {
  Vec2 point = Vec2::Zero();
  std::string what;              // "init_pose", "goal 3"
  Subject owner;                 // without name for goals of the scenario
  std::optional<int> goal = {};  // goal number, if it is a global goal
};

/// Start and goals of one agent or robot, in order.
struct Itinerary {
  Subject who;
  Place start;
  std::vector<Place> goals;
  double radius = 0.0;
  bool planned = true;
};

class PlacementCheck {
 public:
  PlacementCheck(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report)
      : scenario_(scenario),
        grid_(surroundings.grid),
        obstacles_(surroundings.obstacles),
        layers_(*surroundings.layers),
        report_(report) {
    openDoors(surroundings.firstDoorPart);
  }

  void check() {
    checkDoors();
    std::vector<Itinerary> itineraries;
    const auto add = [&](const auto& body) { itineraries.push_back(itineraryOf(body)); };
    forEachListed(scenario_.humans, add);
    forEachListed(scenario_.robots, add);
    std::vector<Vec2> points;
    for (const Itinerary& itinerary : itineraries) {
      points.push_back(itinerary.start.point);
      for (const Place& goal : itinerary.goals) {
        points.push_back(goal.point);
      }
    }
    if (grid_.isEmpty() && (hasNoObstacles() || isTooWide(points))) {
      return;
    }
    layer_ = layers_.of(grid_, obstacles_, points);
    for (const Itinerary& itinerary : itineraries) {
      checkItinerary(itinerary);
    }
  }

 private:
  /// Doors that will open do not block paths.
  void openDoors(int part) {
    forEachListed(scenario_.doors, [&](const Door& door) {
      if (!door.toggles.empty() && part < obstacles_.partCount()) {  // no outlines
        obstacles_.setEnabled(part, false);
      }
      ++part;
    });
  }

  /// A door does not open the walls of the map.
  void checkDoors() {
    forEachListed(scenario_.doors, [&](const Door& door) {
      constexpr int kSamples = 20;
      int walled = 0;
      for (int k = 1; k < kSamples && !grid_.isEmpty(); ++k) {
        const Vec2 place = door.from + (static_cast<double>(k) / kSamples) * (door.to - door.from);
        walled += grid_.isWall(grid_.worldToCell(place)) ? 1 : 0;
      }
      if (2 * walled > kSamples) {
        report_.warning(door, "places.door-in-wall");
      }
    });
  }

  bool hasNoObstacles() const {
    for (int part = 0; part < obstacles_.partCount(); ++part) {
      if (obstacles_.isEnabled(part) && !obstacles_.outlines(part).empty()) {
        return false;
      }
    }
    return true;
  }

  /// Without a map the planning grid covers everything: at most 40 million cells of 0.1 m.
  bool isTooWide(const std::vector<Vec2>& points) {
    Vec2 low = Vec2::Constant(1e9);
    Vec2 high = Vec2::Constant(-1e9);
    const auto include = [&](const Vec2& point) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    };
    std::for_each(points.begin(), points.end(), include);
    for (int part = 0; part < obstacles_.partCount(); ++part) {
      for (const Outline& outline : obstacles_.outlines(part)) {
        std::for_each(outline.points.begin(), outline.points.end(), include);
      }
    }
    const Vec2 size = high - low;
    if (size.x() * size.y() <= 4e5) {
      return false;
    }
    report_.warning(EntityId{base::EntityKind::Scenario, 0}, "places.too-wide");
    return true;
  }

  template <class Body, class Resolved>
  Itinerary itineraryOf(const Body& body, const Resolved& resolved, const char* start,
                        const std::vector<int>& goals) const {
    Itinerary itinerary{body, {resolved.start.position, start, body}, {}, resolved.radius};
    for (const int id : goals) {
      if (const GlobalGoal* goal = scenario_.goal(id)) {
        itinerary.goals.push_back({goal->position, "goal " + std::to_string(id), goal->key, id});
      }
    }
    return itinerary;
  }

  Itinerary itineraryOf(const Human& human) const {
    const ResolvedHuman resolved = resolveHuman(scenario_, human, 0);
    Itinerary itinerary = itineraryOf(human, resolved, "init_pose", human.goals);
    itinerary.planned = resolved.route == Route::Planned;
    return itinerary;
  }

  Itinerary itineraryOf(const Robot& robot) const {
    const std::optional<Vec2>& point = robot.goal.point;
    Itinerary itinerary = itineraryOf(robot, resolveRobot(scenario_, robot, -1), "start",
                                      point ? std::vector<int>() : robot.goal.goals);
    if (point) {
      itinerary.goals.push_back({*point, "goal", robot});
    }
    return itinerary;
  }

  /// Where the body will stand. Reports each position and radius once.
  std::optional<Vec2> fit(const Place& place, double radius) {
    std::optional<Vec2> taken =
        layer_->plannerFor(radius)->space().nearestFreePosition(place.point);
    if (!reported_.insert(std::make_tuple(place.owner.entity, place.what, radius)).second) {
      return taken;
    }
    const auto addProblem = [&](base::Severity severity, const char* code,
                                base::ProblemValues values) {
      values.insert(values.begin(), {place.what, base::pointText(place.point)});
      report_.add(severity, place.owner, code, std::move(values));
    };
    if (!taken) {
      addProblem(base::Severity::Error, "places.no-place", {radius});
    } else if (*taken != place.point) {
      addProblem(base::Severity::Warning, "places.moved", {radius, base::pointText(*taken)});
    } else if (!grid_.isEmpty() && grid_.isUnknown(grid_.worldToCell(place.point))) {
      addProblem(base::Severity::Warning, "places.unknown-ground", {});
    }
    return taken;
  }

  void checkItinerary(const Itinerary& itinerary) {
    const std::optional<Vec2> start = fit(itinerary.start, itinerary.radius);
    std::set<std::string> unreachable;
    const Place* from = &itinerary.start;
    std::string blocked;
    for (const Place& goal : itinerary.goals) {
      const std::optional<Vec2> point = fit(goal, itinerary.radius);
      if (start && point && itinerary.planned &&
          !layer_->plannerFor(itinerary.radius)->isReachable(*start, *point) &&
          unreachable.insert(goal.what).second) {
        reportUnreachable(itinerary, goal);
      }
      if (start && point && blocked.empty() && !obstacles_.isVisible(from->point, goal.point)) {
        blocked = nameOf(goal);
      }
      from = &goal;
    }
    reportBlocked(itinerary, blocked);
  }

  static std::string nameOf(const Place& place) {
    const std::string& owner = place.owner.where;
    return owner + (owner.empty() ? "" : ": ") + place.what;
  }

  void reportUnreachable(const Itinerary& itinerary, const Place& goal) {
    const std::string point = base::pointText(goal.point);
    if (goal.goal) {
      report_.warning(itinerary.who, "places.no-way", {*goal.goal, point});
    } else {
      report_.warning(itinerary.who, "places.no-way-to-point", {nameOf(goal), point});
    }
  }

  /// HuNavSim's agents walk in straight lines from goal to goal.
  void reportBlocked(const Itinerary& itinerary, const std::string& goal) {
    if (goal.empty() || itinerary.who.entity.kind != base::EntityKind::Human) {
      return;
    }
    if (itinerary.planned) {
      report_.add(base::Severity::Info, itinerary.who, "places.wall-on-planned-way", {goal});
    } else {
      report_.warning(itinerary.who, "places.wall-on-way", {goal});
    }
  }

  const Scenario& scenario_;
  const OccupancyGrid& grid_;
  Obstacles obstacles_;
  NavigationLayerCache& layers_;
  CheckReport& report_;
  std::shared_ptr<const NavigationLayer> layer_;
  std::set<std::tuple<EntityId, std::string, double>> reported_;
};

}  // namespace

void checkShapes(const Scenario& scenario, CheckReport& report) {
  forEachListed(scenario.obstacles, [&](const Obstacle& obstacle) {
    if (obstacle.kind == ObstacleKind::Polygon) {
      checkPolygon(obstacle.points, obstacle, report);
    }
  });
  forEachListed(scenario.areas, [&](const Area& area) { checkPolygon(area.points, area, report); });
  forEachListed(scenario.robots, [&](const Robot& robot) {
    checkPolygon(resolveRobot(scenario, robot, -1).footprint,
                 {robot.key, robot.name + ": footprint"}, report);
  });
  forEachListed(scenario.doors, [&](const Door& door) {
    if (door.from == door.to) {
      report.error(door, "shape.door-without-length");
    }
  });
}

bool checkCoordinates(const Scenario& scenario, CheckReport& report) {
  bool isGood = true;
  const auto points = [&](const std::vector<Vec2>& all, const Subject& subject) {
    isGood = checkPoints(all, subject, report) && isGood;
  };
  for (const GlobalGoal& goal : scenario.goals) {
    points({goal.position}, {goal.key, "goal " + std::to_string(goal.id)});
  }
  forEachListed(scenario.humans, [&](const Human& human) {
    isGood = checkPose(human.initPose, {human.key, human.name + ": init_pose"}, report) && isGood;
  });
  forEachListed(scenario.robots, [&](const Robot& robot) {
    isGood = checkPose(robot.start, {robot.key, robot.name + ": start"}, report) && isGood;
    points({robot.goal.point.value_or(Vec2::Zero())}, {robot.key, robot.name + ": goal"});
  });
  forEachListed(scenario.obstacles, [&](const Obstacle& obstacle) {
    points({obstacle.pose.position}, obstacle);
    points({{obstacle.length, obstacle.width}, {obstacle.radius, 0.0}},
           {obstacle.key, obstacle.name + ": size"});
    points(obstacle.points, obstacle);
  });
  forEachListed(scenario.doors, [&](const Door& door) { points({door.from, door.to}, door); });
  forEachListed(scenario.areas, [&](const Area& area) { points(area.points, area); });
  forEachListed(scenario.docks,
                [&](const Dock& dock) { isGood = checkPose(dock.pose, dock, report) && isGood; });
  return isGood;
}

void checkPlaces(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report) {
  PlacementCheck(scenario, surroundings, report).check();
}

}  // namespace sim2d
