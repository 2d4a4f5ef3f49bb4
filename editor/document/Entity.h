#pragma once

#include <optional>
#include <string>
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

/// What belongs to the scenario as a whole; there is always exactly one (`kSettingsId`).
struct ScenarioSettings {
  std::optional<std::string> yamlBaseName, simulator, map;
  std::optional<bool> publishPeople;
  sim2d::DesktopSettings desktop;
};
bool operator==(const ScenarioSettings& a, const ScenarioSettings& b);
constexpr EntityId kSettingsId{EntityKind::Scenario, 0};

/// Anything that can be edited: a value, compared by content.
using Entity = std::variant<sim2d::Human, sim2d::Robot, sim2d::GlobalGoal, sim2d::Obstacle,
                            sim2d::Door, sim2d::Area, ScenarioSettings>;

/// What happened to one entity, or to all of them (another file). Receivers read the new value from
/// the document.
struct Change {
  enum class What { Added, Removed, Edited, Tree, Everything };
  What what = What::Everything;
  EntityId entity;
};

EntityKind kindOf(const Entity& entity);
EntityId idOf(const Entity& entity);
void setId(Entity& entity, EntityId id);
std::string nameOf(const Entity& entity);            // goals: their number; settings: empty
QString displayName(const Entity& entity);           // "Ana", "Goal 3", "Scenario"
QString kindName(EntityKind kind);                   // "person", "goal" …
QString obstacleKindName(sim2d::ObstacleKind kind);  // "box" …
QString areaKindName(sim2d::AreaKind kind);          // "source", "waiting" …
/// Where it is on the map (centre of its points); nothing for the settings.
std::optional<Vec2> positionOf(const Entity& entity);
std::optional<double> headingOf(const Entity& entity);  // people, robots, boxes
/// Shifted by `delta` [m]; a robot takes its own goal point along only when `withGoal`.
Entity moved(Entity entity, const Vec2& delta, bool withGoal = false);
/// With another heading [rad]; unchanged when it has none.
Entity turned(Entity entity, double heading);

}  // namespace editor

Q_DECLARE_METATYPE(editor::Change)
