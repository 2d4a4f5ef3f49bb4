#include "editor/document/Entity.h"

#include <tuple>

#include "editor/document/Geometry.h"

namespace editor {

namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

Vec2 centreOf(const std::vector<Vec2>& points) {
  if (points.empty()) {
    return Vec2::Zero();
  }
  Vec2 low = points.front();
  Vec2 high = points.front();
  for (const Vec2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return 0.5 * (low + high);
}

void shift(std::vector<Vec2>& points, const Vec2& delta) {
  for (Vec2& point : points) {
    point = rounded(point + delta);
  }
}

bool hasPoints(sim2d::ObstacleKind kind) {
  return kind == sim2d::ObstacleKind::Polygon || kind == sim2d::ObstacleKind::Wall;
}

}  // namespace

bool operator==(const ScenarioSettings& a, const ScenarioSettings& b) {
  const auto all = [](const ScenarioSettings& v) {
    return std::tie(v.yamlBaseName, v.simulator, v.map, v.publishPeople, v.desktop);
  };
  return all(a) == all(b);
}

EntityKind kindOf(const Entity& entity) {
  static constexpr EntityKind kKinds[] = {EntityKind::Human,    EntityKind::Robot, EntityKind::Goal,
                                          EntityKind::Obstacle, EntityKind::Door,  EntityKind::Area,
                                          EntityKind::Scenario};
  return kKinds[entity.index()];
}

EntityId idOf(const Entity& entity) {
  return std::visit(Overloaded{[](const ScenarioSettings&) { return kSettingsId; },
                               [](const auto& value) { return value.key; }},
                    entity);
}

void setId(Entity& entity, EntityId id) {
  std::visit(Overloaded{[](ScenarioSettings&) {}, [id](auto& value) { value.key = id; }}, entity);
}

std::string nameOf(const Entity& entity) {
  return std::visit(
      Overloaded{[](const ScenarioSettings&) { return std::string(); },
                 [](const sim2d::GlobalGoal& goal) { return std::to_string(goal.id); },
                 [](const auto& value) { return value.name; }},
      entity);
}

QString displayName(const Entity& entity) {
  const QString name = QString::fromStdString(nameOf(entity));
  switch (kindOf(entity)) {
    case EntityKind::Scenario:
      return QStringLiteral("Scenario");
    case EntityKind::Goal:
      return QStringLiteral("Goal ") + name;
    default:
      return name;
  }
}

QString kindName(EntityKind kind) {
  static const char* const kWords[] = {"",     "scenario", "person", "robot",
                                       "goal", "obstacle", "door",   "area"};
  return QString::fromLatin1(kWords[static_cast<int>(kind)]);
}

QString obstacleKindName(sim2d::ObstacleKind kind) {
  static const char* const kWords[] = {"box", "circle", "polygon", "wall"};
  return QString::fromLatin1(kWords[static_cast<int>(kind)]);
}

QString areaKindName(sim2d::AreaKind kind) {
  static const char* const kWords[] = {"source", "sink", "waiting", "exit"};
  return QString::fromLatin1(kWords[static_cast<int>(kind)]);
}

std::optional<Vec2> positionOf(const Entity& entity) {
  using Position = std::optional<Vec2>;
  return std::visit(
      Overloaded{[](const sim2d::Human& human) { return Position(human.initPose.position); },
                 [](const sim2d::Robot& robot) { return Position(robot.start.position); },
                 [](const sim2d::GlobalGoal& goal) { return Position(goal.position); },
                 [](const sim2d::Obstacle& obstacle) {
                   return Position(hasPoints(obstacle.kind) ? centreOf(obstacle.points)
                                                            : obstacle.pose.position);
                 },
                 [](const sim2d::Door& door) { return Position(0.5 * (door.from + door.to)); },
                 [](const sim2d::Area& area) { return Position(centreOf(area.points)); },
                 [](const ScenarioSettings&) { return Position(); }},
      entity);
}

std::optional<double> headingOf(const Entity& entity) {
  using Heading = std::optional<double>;
  return std::visit(
      Overloaded{[](const sim2d::Human& human) { return Heading(human.initPose.heading); },
                 [](const sim2d::Robot& robot) { return Heading(robot.start.heading); },
                 [](const sim2d::Obstacle& obstacle) {
                   return obstacle.kind == sim2d::ObstacleKind::Box ? Heading(obstacle.pose.heading)
                                                                    : Heading();
                 },
                 [](const auto&) { return Heading(); }},
      entity);
}

Entity moved(Entity entity, const Vec2& delta, bool withGoal) {
  std::visit(
      Overloaded{[&](sim2d::Human& human) {
                   human.initPose.position = rounded(human.initPose.position + delta);
                   human.hasInitPose = true;
                 },
                 [&](sim2d::Robot& robot) {
                   robot.start.position = rounded(robot.start.position + delta);
                   if (withGoal && robot.goal.point) {
                     *robot.goal.point = rounded(*robot.goal.point + delta);
                   }
                 },
                 [&](sim2d::GlobalGoal& goal) { goal.position = rounded(goal.position + delta); },
                 [&](sim2d::Obstacle& obstacle) {
                   if (hasPoints(obstacle.kind)) {
                     shift(obstacle.points, delta);
                   } else {
                     obstacle.pose.position = rounded(obstacle.pose.position + delta);
                   }
                 },
                 [&](sim2d::Door& door) {
                   door.from = rounded(door.from + delta);
                   door.to = rounded(door.to + delta);
                 },
                 [&](sim2d::Area& area) { shift(area.points, delta); }, [](ScenarioSettings&) {}},
      entity);
  return entity;
}

Entity turned(Entity entity, double heading) {
  const double wrapped = base::wrapToPi(heading);
  std::visit(Overloaded{[&](sim2d::Human& human) { human.initPose.heading = wrapped; },
                        [&](sim2d::Robot& robot) { robot.start.heading = wrapped; },
                        [&](sim2d::Obstacle& obstacle) {
                          if (obstacle.kind == sim2d::ObstacleKind::Box) {
                            obstacle.pose.heading = wrapped;
                          }
                        },
                        [](auto&) {}},
             entity);
  return entity;
}

}  // namespace editor
