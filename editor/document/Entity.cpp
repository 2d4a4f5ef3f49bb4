#include "editor/document/Entity.h"

#include <array>
#include <cmath>

#include "sim2d/map/Outlines.h"

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
  return QCoreApplication::translate("Entity", "Goal %1").arg(number);
}

QString displayName(const Entity& entity) {
  QString name = QString::fromStdString(nameOf(entity));
  switch (kindOf(entity)) {
    case EntityKind::Scenario:
      return QCoreApplication::translate("Entity", "Scenario");
    case EntityKind::Goal:
      return goalName(std::get<sim2d::GlobalGoal>(entity).id);
    default:
      return name;
  }
}

namespace {

/// One and several of a kind, in English.
struct KindWords {
  const char* one;
  const char* many;
};

const KindWords& wordsOf(EntityKind kind) {
  static constexpr KindWords kWords[] = {
      {"", ""},
      {QT_TRANSLATE_NOOP("Entity", "scenario"), QT_TRANSLATE_NOOP("Entity", "scenarios")},
      {QT_TRANSLATE_NOOP("Entity", "person"), QT_TRANSLATE_NOOP("Entity", "people")},
      {QT_TRANSLATE_NOOP("Entity", "robot"), QT_TRANSLATE_NOOP("Entity", "robots")},
      {QT_TRANSLATE_NOOP("Entity", "goal"), QT_TRANSLATE_NOOP("Entity", "goals")},
      {QT_TRANSLATE_NOOP("Entity", "obstacle"), QT_TRANSLATE_NOOP("Entity", "obstacles")},
      {QT_TRANSLATE_NOOP("Entity", "door"), QT_TRANSLATE_NOOP("Entity", "doors")},
      {QT_TRANSLATE_NOOP("Entity", "area"), QT_TRANSLATE_NOOP("Entity", "areas")},
      {QT_TRANSLATE_NOOP("Entity", "dock"), QT_TRANSLATE_NOOP("Entity", "docks")}};
  return kWords[static_cast<int>(kind)];
}

const char* obstacleKindWord(sim2d::ObstacleKind kind) {
  static constexpr const char* kWords[] = {
      QT_TRANSLATE_NOOP("Entity", "box"), QT_TRANSLATE_NOOP("Entity", "circle"),
      QT_TRANSLATE_NOOP("Entity", "polygon"), QT_TRANSLATE_NOOP("Entity", "wall")};
  return kWords[static_cast<int>(kind)];
}

const char* areaKindWord(sim2d::AreaKind kind) {
  static constexpr const char* kWords[] = {
      QT_TRANSLATE_NOOP("Entity", "source"), QT_TRANSLATE_NOOP("Entity", "sink"),
      QT_TRANSLATE_NOOP("Entity", "waiting"), QT_TRANSLATE_NOOP("Entity", "exit"),
      QT_TRANSLATE_NOOP("Entity", "speed")};
  return kWords[static_cast<int>(kind)];
}

/// The kind; of obstacles and areas the more exact one.
const char* kindWord(const Entity& entity) {
  if (const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity)) {
    return obstacleKindWord(obstacle->kind);
  }
  const auto* area = std::get_if<sim2d::Area>(&entity);
  return area != nullptr ? areaKindWord(area->kind) : wordsOf(kindOf(entity)).one;
}

QString translatedWord(const char* word) {
  return QCoreApplication::translate("Entity", word);
}

}  // namespace

QString kindName(EntityKind kind) {
  return translatedWord(wordsOf(kind).one);
}

QString kindName(const Entity& entity) {
  return translatedWord(kindWord(entity));
}

QString kindNamePlural(EntityKind kind) {
  return translatedWord(wordsOf(kind).many);
}

QString obstacleKindName(sim2d::ObstacleKind kind) {
  return translatedWord(obstacleKindWord(kind));
}

QString areaKindName(sim2d::AreaKind kind) {
  return translatedWord(areaKindWord(kind));
}

std::string nameStem(const Entity& entity) {
  return kindWord(entity);
}

std::string nameStem(EntityKind kind) {
  return wordsOf(kind).one;
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

namespace {

/// The points that span the area of an entity.
std::vector<Vec2> outlineOf(const Entity& entity) {
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  if (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Box) {
    return sim2d::boxOutline(obstacle->pose, obstacle->length, obstacle->width).points;
  }
  if (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Circle) {
    const Vec2 reach = Vec2::Constant(obstacle->radius);
    return {obstacle->pose.position - reach, obstacle->pose.position + reach};
  }
  return pointsOf(entity);
}

}  // namespace

std::vector<Vec2>* cornersOf(Entity& entity) {
  if (auto* area = std::get_if<sim2d::Area>(&entity)) {
    return &area->points;
  }
  auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  const bool isByCorners = obstacle != nullptr && (obstacle->kind == sim2d::ObstacleKind::Polygon ||
                                                   obstacle->kind == sim2d::ObstacleKind::Wall);
  return isByCorners ? &obstacle->points : nullptr;
}

const std::vector<Vec2>* cornersOf(const Entity& entity) {
  return cornersOf(const_cast<Entity&>(entity));
}

bool isOpenPolyline(const Entity& entity) {
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  return obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Wall;
}

std::size_t minimumCorners(const Entity& entity) {
  return isOpenPolyline(entity) ? 2 : 3;
}

std::optional<std::size_t> outlineEdgeAt(const Entity& entity, const Vec2& point, double reach) {
  const std::vector<Vec2>* corners = cornersOf(entity);
  if (corners == nullptr || corners->size() < 2) {
    return std::nullopt;
  }
  std::optional<std::size_t> found;
  const std::size_t count = isOpenPolyline(entity) ? corners->size() - 1 : corners->size();
  for (std::size_t i = 0; i < count; ++i) {
    const sim2d::Segment edge{(*corners)[i], (*corners)[(i + 1) % corners->size()]};
    const double distance = sim2d::distanceToSegment(edge, point);
    if (distance <= reach) {
      reach = distance;
      found = i;
    }
  }
  return found;
}

std::optional<Extent> extentOf(const std::vector<Vec2>& points) {
  if (points.empty()) {
    return std::nullopt;
  }
  Extent extent{points.front(), points.front()};
  for (const Vec2& point : points) {
    extent.low = extent.low.cwiseMin(point);
    extent.high = extent.high.cwiseMax(point);
  }
  return extent;
}

std::optional<Extent> extentOf(const Entity& entity) {
  return extentOf(outlineOf(entity));
}

double rounded(double metres) {
  constexpr double kPerMetre = 1e6;
  return std::round(metres * kPerMetre) / kPerMetre + 0.0;  // Avoids -0.
}

Vec2 rounded(const Vec2& point) {
  return {rounded(point.x()), rounded(point.y())};
}

namespace {

constexpr double kFrame = 1.25;  // Half side of a person's selection frame in body radii.
constexpr double kSmallest = 0.1, kLargestBody = 2.0;
constexpr std::array<std::array<double, 2>, 4> kCorners = {
    {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}};

Vec2 cornerSign(int index) {
  const auto& signs = kCorners[static_cast<std::size_t>(index)];
  return {signs[0], signs[1]};
}

double onCentimetres(double value, bool fine) {
  return fine ? value : std::round(100.0 * value) / 100.0;
}

void addCorners(std::vector<Handle>& handles, const Pose2& pose, const Vec2& half) {
  for (int i = 0; i < 4; ++i) {
    const Vec2 offset = cornerSign(i).cwiseProduct(half);
    handles.push_back({Handle::Kind::Size, i, pose.toWorld(offset)});
  }
}

/// The corner opposite to the dragged one stays fixed.
void resizeBox(sim2d::Obstacle& box, int corner, const Vec2& to, bool fine) {
  const Vec2 sign = cornerSign(corner);
  const Vec2 fixed = box.pose.toWorld(-0.5 * sign.cwiseProduct(Vec2(box.length, box.width)));
  const Vec2 diagonal = Pose2{fixed, box.pose.heading}.toLocal(to).cwiseProduct(sign);
  box.length = std::max(kSmallest, onCentimetres(diagonal.x(), fine));
  box.width = std::max(kSmallest, onCentimetres(diagonal.y(), fine));
  box.pose.position =
      Pose2{fixed, box.pose.heading}.toWorld(0.5 * sign.cwiseProduct(Vec2(box.length, box.width)));
}

/// Returns true if each point of the entity can be dragged and one handle above rotates the whole.
bool hasEditableVertices(const Entity& entity) {
  return cornersOf(entity) != nullptr || kindOf(entity) == EntityKind::Door;
}

void resize(Entity& entity, int corner, const Vec2& to, bool fine) {
  auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  if (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Box) {
    resizeBox(*obstacle, corner, to, fine);
    return;
  }
  const double reach = (to - *positionOf(entity)).cwiseAbs().maxCoeff();
  if (auto* human = std::get_if<sim2d::Human>(&entity)) {
    human->radius = std::clamp(onCentimetres(reach / kFrame, fine), kSmallest, kLargestBody);
  } else if (obstacle != nullptr) {
    obstacle->radius = std::max(kSmallest, onCentimetres(reach, fine));
  }
}

}  // namespace

std::vector<Handle> handlesOf(const Entity& entity, const HandleSizes& sizes) {
  std::vector<Handle> handles;
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    const double half = kFrame * sizes.bodyRadius;
    addCorners(handles, {human->initPose.position, 0.0}, {half, half});
  } else if (hasEditableVertices(entity)) {
    for (const Vec2& point : outlineOf(entity)) {
      handles.push_back({Handle::Kind::Vertex, static_cast<int>(handles.size()), point});
    }
  } else if (const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity)) {
    if (obstacle->kind == sim2d::ObstacleKind::Box) {
      addCorners(handles, obstacle->pose, {0.5 * obstacle->length, 0.5 * obstacle->width});
    } else {
      addCorners(handles, {obstacle->pose.position, 0.0}, {obstacle->radius, obstacle->radius});
    }
  } else if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    if (robot->goal.point) {
      handles.push_back({Handle::Kind::RobotGoal, 0, *robot->goal.point});
    }
  }
  if (const std::optional<double> heading = headingOf(entity)) {
    double distance = sizes.turnDistance;
    if (const auto* box = std::get_if<sim2d::Obstacle>(&entity)) {
      distance += 0.5 * box->length;
    }
    const Pose2 pose{*positionOf(entity), *heading};
    handles.push_back({Handle::Kind::Turn, 0, pose.ahead(distance)});
  } else if (const auto extent = extentOf(entity); extent && hasEditableVertices(entity)) {
    const Vec2 top(extent->centre().x(), extent->high.y() + sizes.turnDistance);
    handles.push_back({Handle::Kind::Turn, 0, top});
  }
  return handles;
}

Entity withHandleMoved(const Entity& entity, const Handle& handle, const Vec2& to, bool fine) {
  Entity result = entity;
  switch (handle.kind) {
    case Handle::Kind::Turn: {
      const Vec2 centre = *positionOf(entity);
      constexpr double kDegree = base::kPi / 180.0;
      const double exact = base::headingOf(to - centre);
      const double heading = fine ? exact : std::round(exact / kDegree) * kDegree;
      return headingOf(entity) ? withHeading(std::move(result), heading)
                               : rotated(std::move(result), centre, heading - 0.5 * base::kPi);
    }
    case Handle::Kind::Size:
      resize(result, handle.index, to, fine);
      break;
    case Handle::Kind::Vertex:
      if (const auto points = pointsIn(result); handle.index < static_cast<int>(points.size())) {
        *points[static_cast<std::size_t>(handle.index)] = to;
      }
      break;
    case Handle::Kind::RobotGoal:
      if (auto* robot = std::get_if<sim2d::Robot>(&result)) {
        robot->goal.point = to;
      }
      break;
    case Handle::Kind::None:
      break;
  }
  return result;
}

}  // namespace editor
