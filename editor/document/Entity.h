#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <QMetaType>
#include <QString>

#include "sim2d/scenario/Scenario.h"

namespace editor {

using base::EntityId;
using base::EntityKind;
using base::Pose2;
using base::Vec2;

/// What belongs to the scenario as a whole is one thing to edit, which is always there.
using sim2d::ScenarioSettings;
constexpr EntityId kSettingsId{EntityKind::Scenario, 0};

/// Anything that can be edited: a value, compared by content.
using Entity = std::variant<sim2d::Human, sim2d::Robot, sim2d::GlobalGoal, sim2d::Obstacle,
                            sim2d::Door, sim2d::Area, sim2d::Dock, ScenarioSettings>;

/// What happened to one entity, or to all of them (another file). Receivers read the new value from
/// the document.
struct Change {
  enum class What { Added, Removed, Edited, Tree, Everything };
  What what = What::Everything;
  EntityId entity;
};

/// Has a name and can be switched off; goals have numbers and always take part.
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
std::string nameOf(const Entity& entity);  // goals: their number; settings: empty
void setName(Entity& entity, const std::string& name);
bool isListed(const Entity& entity);  // takes part
void setListed(Entity& entity, bool listed);
QString goalName(int number);                        // "Goal 3", everywhere by its number
QString displayName(const Entity& entity);           // "Ana", "Goal 3", "Scenario"
QString kindName(EntityKind kind);                   // "person", "goal" …
QString obstacleKindName(sim2d::ObstacleKind kind);  // "box" …
QString areaKindName(sim2d::AreaKind kind);          // "source", "waiting" …
/// The points that say where it is, or what its outline runs through; none for the settings. A
/// robot's own goal point is not among them.
std::vector<Vec2*> pointsIn(Entity& entity);
std::vector<Vec2> pointsOf(const Entity& entity);
/// Where it is on the map (centre of its points); nothing for the settings.
std::optional<Vec2> positionOf(const Entity& entity);
std::optional<double> headingOf(const Entity& entity);  // people, robots, boxes, docks
/// Shifted by `delta` [m]; a robot takes its own goal point along only when `withGoal`.
Entity moved(Entity entity, const Vec2& delta, bool withGoal = false);
/// With another heading [rad]; unchanged when it has none.
Entity turned(Entity entity, double heading);
/// Turned about a point by an angle [rad]: place, outline and heading.
Entity rotated(Entity entity, const Vec2& centre, double angle);

}  // namespace editor

Q_DECLARE_METATYPE(editor::Change)
