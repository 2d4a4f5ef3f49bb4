#include "editor/document/Entity.h"

#include "editor/document/Geometry.h"

namespace editor {

namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

/// Null if the entity has no heading.
double* headingIn(Entity& entity) {
  return std::visit(Overloaded{[](sim2d::Human& human) { return &human.initPose.heading; },
                               [](sim2d::Robot& robot) { return &robot.start.heading; },
                               [](sim2d::Obstacle& obstacle) {
                                 const bool isBox = obstacle.kind == sim2d::ObstacleKind::Box;
                                 return isBox ? &obstacle.pose.heading : nullptr;
                               },
                               [](sim2d::Dock& dock) { return &dock.pose.heading; },
                               [](auto&) { return static_cast<double*>(nullptr); }},
                    entity);
}

template <class Change>
void changePoints(Entity& entity, Change&& change) {
  for (Vec2* point : pointsIn(entity)) {
    *point = rounded(change(*point));
  }
  if (auto* human = std::get_if<sim2d::Human>(&entity)) {
    human->hasInitPose = true;
  }
}

}  // namespace

EntityKind kindOf(const Entity& entity) {
  static constexpr EntityKind kKinds[] = {
      EntityKind::Human, EntityKind::Robot, EntityKind::Goal, EntityKind::Obstacle,
      EntityKind::Door,  EntityKind::Area,  EntityKind::Dock, EntityKind::Scenario};
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

void setName(Entity& entity, const std::string& name) {
  std::visit(Overloaded{[](ScenarioSettings&) {}, [](sim2d::GlobalGoal&) {},
                        [&name](auto& value) { value.name = name; }},
             entity);
}

bool isListed(const Entity& entity) {
  return std::visit([](const auto& value) { return takesPart(value); }, entity);
}

void setListed(Entity& entity, bool listed) {
  std::visit(Overloaded{[](ScenarioSettings&) {}, [](sim2d::GlobalGoal&) {},
                        [listed](auto& value) { value.listed = listed; }},
             entity);
}

QString goalName(int number) {
  return QStringLiteral("Goal %1").arg(number);
}

QString displayName(const Entity& entity) {
  QString name = QString::fromStdString(nameOf(entity));
  switch (kindOf(entity)) {
    case EntityKind::Scenario:
      return QStringLiteral("Scenario");
    case EntityKind::Goal:
      return goalName(std::get<sim2d::GlobalGoal>(entity).id);
    default:
      return name;
  }
}

QString kindName(EntityKind kind) {
  static const char* const kWords[] = {"",         "scenario", "person", "robot", "goal",
                                       "obstacle", "door",     "area",   "dock"};
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

std::vector<Vec2*> pointsIn(Entity& entity) {
  using Points = std::vector<Vec2*>;
  if (std::vector<Vec2>* corners = cornersOf(entity)) {
    Points points;
    for (Vec2& corner : *corners) {
      points.push_back(&corner);
    }
    return points;
  }
  return std::visit(
      Overloaded{[](sim2d::Human& human) { return Points{&human.initPose.position}; },
                 [](sim2d::Robot& robot) { return Points{&robot.start.position}; },
                 [](sim2d::GlobalGoal& goal) { return Points{&goal.position}; },
                 [](sim2d::Obstacle& obstacle) { return Points{&obstacle.pose.position}; },
                 [](sim2d::Dock& dock) { return Points{&dock.pose.position}; },
                 [](sim2d::Door& door) {
                   return Points{&door.from, &door.to};
                 },
                 [](auto&) { return Points(); }},
      entity);
}

std::vector<Vec2> pointsOf(const Entity& entity) {
  std::vector<Vec2> points;
  for (const Vec2* point : pointsIn(const_cast<Entity&>(entity))) {
    points.push_back(*point);
  }
  return points;
}

std::optional<Vec2> positionOf(const Entity& entity) {
  if (kindOf(entity) == EntityKind::Scenario) {
    return std::nullopt;
  }
  const std::optional<Extent> extent = extentOf(pointsOf(entity));
  return extent ? extent->centre() : Vec2(Vec2::Zero());
}

std::optional<double> headingOf(const Entity& entity) {
  const double* heading = headingIn(const_cast<Entity&>(entity));
  return heading == nullptr ? std::nullopt : std::optional(*heading);
}

Entity moved(Entity entity, const Vec2& delta, bool withGoal) {
  changePoints(entity, [&delta](const Vec2& point) -> Vec2 { return point + delta; });
  auto* robot = std::get_if<sim2d::Robot>(&entity);
  if (robot != nullptr && withGoal && robot->goal.point) {
    *robot->goal.point = rounded(*robot->goal.point + delta);
  }
  return entity;
}

Entity withHeading(Entity entity, double heading) {
  if (double* own = headingIn(entity)) {
    *own = base::wrapToPi(heading);
  }
  return entity;
}

Entity rotated(Entity entity, const Vec2& centre, double angle) {
  const Pose2 turn{centre, angle};
  changePoints(entity, [&](const Vec2& point) { return turn.toWorld(point - centre); });
  const std::optional<double> heading = headingOf(entity);
  return heading ? withHeading(std::move(entity), *heading + angle) : entity;
}

}  // namespace editor
