#pragma once

#include <algorithm>
#include <tuple>
#include <variant>

#include <QtWidgets>

#include "sim2d/scenario/Scenario.h"

namespace editor {

using base::EntityId;
using base::EntityKind;
using base::Pose2;
using base::Vec2;

/// The settings of the whole scenario are one entity that always exists.
using sim2d::ScenarioSettings;
constexpr EntityId kSettingsId{EntityKind::Scenario, 0};

/// Anything that can be edited; a value type compared by content.
using Entity = std::variant<sim2d::Human, sim2d::Robot, sim2d::GlobalGoal, sim2d::Obstacle,
                            sim2d::Door, sim2d::Area, sim2d::Dock, ScenarioSettings>;

/// A change of one entity, or of all (another file was opened). Receivers read the new value from
/// the document.
struct Change {
  enum class What { Added, Removed, Edited, Tree, Everything };
  What what = What::Everything;
  EntityId entity;
};

/// True for types that have a name and can be switched off. Goals have numbers and are always
/// active.
template <class T>
constexpr bool kIsNamed =
    !std::is_same_v<T, sim2d::GlobalGoal> && !std::is_same_v<T, ScenarioSettings>;

template <class T>
bool takesPart(const T& value) {
  if constexpr (kIsNamed<T>) {
    return value.listed;
  } else {
    return true;
  }
}

EntityKind kindOf(const Entity& entity);
EntityId idOf(const Entity& entity);
void setId(Entity& entity, EntityId id);
std::string nameOf(const Entity& entity);  // Goals: their number; settings: empty.
void setName(Entity& entity, const std::string& name);
bool isListed(const Entity& entity);  // False if switched off.
void setListed(Entity& entity, bool listed);
QString goalName(int number);                        // "Goal 3"
QString displayName(const Entity& entity);           // "Ana", "Goal 3", "Scenario"
QString kindName(EntityKind kind);                   // "person", "goal" …
QString kindName(const Entity& entity);              // "person", "wall", "waiting" …
QString kindNamePlural(EntityKind kind);             // "people", "goals" …
QString obstacleKindName(sim2d::ObstacleKind kind);  // "box" …
QString areaKindName(sim2d::AreaKind kind);          // "source", "waiting" …
/// The first part of names of new entities, "wall" or "person"; English in every language.
std::string nameStem(const Entity& entity);
std::string nameStem(EntityKind kind);
/// The points that define the position or the outline; empty for the settings. The goal point of a
/// robot is not included.
std::vector<Vec2*> pointsIn(Entity& entity);
std::vector<Vec2> pointsOf(const Entity& entity);
/// Position on the map (centre of its points); none for the settings.
std::optional<Vec2> positionOf(const Entity& entity);
std::optional<double> headingOf(const Entity& entity);  // For people, robots, boxes and docks.
/// Translated by `delta` [m]. The goal point of a robot moves along only if `withGoal`.
Entity moved(Entity entity, const Vec2& delta, bool withGoal = false);
/// With another heading [rad]; unchanged if the entity has none.
Entity withHeading(Entity entity, double heading);
/// Position, outline and heading rotated about a point by an angle [rad].
Entity rotated(Entity entity, const Vec2& centre, double angle);

/// Axis-aligned bounding box [m].
struct Extent {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  Vec2 centre() const { return 0.5 * (low + high); }
};

/// None if there are no points.
std::optional<Extent> extentOf(const std::vector<Vec2>& points);
/// Bounding box of the outline; for people and robots of the position alone. None for the settings.
std::optional<Extent> extentOf(const Entity& entity);
/// The corners of an obstacle or area, or the points of a wall; null for other entities.
std::vector<Vec2>* cornersOf(Entity& entity);
const std::vector<Vec2>* cornersOf(const Entity& entity);
/// Minimum number of corners of a shape: 2 for walls, else 3.
std::size_t minimumCorners(const Entity& entity);
/// The outline edge within `reach` of a point, as the index of its first corner.
std::optional<std::size_t> outlineEdgeAt(const Entity& entity, const Vec2& point, double reach);
bool isOpenPolyline(const Entity& entity);  // True for a wall, whose ends are not joined.

/// Rounded to micrometres; otherwise sums of steps are written as 12.629999999999999.
double rounded(double metres);
Vec2 rounded(const Vec2& point);

/// A draggable handle of a selected entity.
struct Handle {
  enum class Kind { None, Turn, Size, Vertex, RobotGoal };
  Kind kind = Kind::None;
  int index = 0;                 // Index of the corner or vertex.
  Vec2 position = Vec2::Zero();  // World frame [m].
};

/// Sizes that depend on the canvas, not on the entity.
struct HandleSizes {
  double bodyRadius = 0.35;   // Radius of a person as drawn [m].
  double turnDistance = 1.0;  // Distance of the rotation handle from the centre [m].
};

std::vector<Handle> handlesOf(const Entity& entity, const HandleSizes& sizes);
/// The entity after its handle is dragged to `to`. Angles and sizes are rounded to 1 degree and 1
/// cm unless `fine`.
Entity withHandleMoved(const Entity& entity, const Handle& handle, const Vec2& to, bool fine);

/// The list of a scenario that contains the entities of type T.
template <class T, class S>
auto& listOf(S& scenario) {
  using List = std::conditional_t<std::is_const_v<S>, const std::vector<T>, std::vector<T>>;
  return std::get<List&>(std::tie(scenario.humans, scenario.goals, scenario.robots,
                                  scenario.obstacles, scenario.doors, scenario.areas,
                                  scenario.docks));
}

/// Calls `visitor` with the list of that kind. Returns `otherwise` for kinds without a list.
template <class S, class Visitor,
          class R = std::invoke_result_t<Visitor, decltype((std::declval<S&>().humans))>>
R withList(S& scenario, EntityKind kind, Visitor&& visitor, R otherwise = R()) {
  forEachList(scenario, [&](EntityKind each, auto& list) {
    if (each == kind) {
      otherwise = visitor(list);
    }
  });
  return otherwise;
}

template <class List>
int positionIn(const List& list, EntityId id) {
  const auto found =
      std::find_if(list.begin(), list.end(), [id](const auto& value) { return value.key == id; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

/// Returns true if the scenario has no entities and names no map, as after reading an unreadable
/// file.
inline bool isBlank(const sim2d::Scenario& scenario) {
  bool isEmpty = true;
  forEachList(scenario,
              [&](EntityKind /*kind*/, const auto& list) { isEmpty = isEmpty && list.empty(); });
  return isEmpty && !scenario.map && !scenario.desktop.mapFile;
}

}  // namespace editor

Q_DECLARE_METATYPE(editor::Change)
