#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QString>

#include "editor/document/ScenarioDocument.h"
#include "sim2d/scenario/Fields.h"

namespace editor {

/// A property of entities: a key of the tables, or specific to a page.
struct EntityField {
  base::ParameterSpec spec;
  std::function<base::ParameterValue(const Entity&)> get;  // monostate: not set.
  std::function<void(Entity&, const base::ParameterValue&)> set;
  std::function<base::ParameterValue(const Entity&)> fallback{};  // Effective value if not set.
  std::function<bool(const Entity&)> belongs{};                   // Null: applies to all.
  bool is64Bit = false;                                           // A 64-bit integer.
};

std::optional<double> numberIn(const base::ParameterValue& value);

// Properties that are not plain fields of a table.
EntityField numberField(const QString& label, const QString& unit,
                        std::function<std::optional<double>(const Entity&)> get,
                        std::function<void(Entity&, std::optional<double>)> set);
EntityField textField(const QString& label, const QString& help,
                      std::function<QString(const Entity&)> get,
                      std::function<void(Entity&, const QString&)> set);
/// Position on the map and heading, for all kinds that have them.
EntityField positionField(const QString& label, int axis);
EntityField headingField();

/// A selectable implementation with its own parameters: the planner of a robot, or the pedestrian
/// model.
struct ParameterOwner {
  std::map<std::string, std::vector<base::ParameterSpec>> known;  // By name.
  std::function<std::string(const Entity&)> name;                 // Of the effective one.
  std::function<sim2d::ParameterTexts(const Entity&)> given;      // Its parameter values.
  std::function<void(Entity&, sim2d::ParameterTexts)> give;       // None: parameters are not set.
};
/// A parameter declared by the implementation `name`, a number or a text, in the notation of the
/// file.
EntityField parameterField(const ParameterOwner& owner, const std::string& name,
                           const base::ParameterSpec& spec);
/// Parameters of the file without a row: undeclared names, and values that are not numbers.
sim2d::ParameterTexts otherParameters(const ParameterOwner& owner, const Entity& entity);
EntityField otherParametersField(const ParameterOwner& owner, const QString& help);

// Lists as editable text.
/// "lookahead=0.6, stop_distance=0.5"
QString pairsText(const std::vector<std::pair<std::string, std::string>>& pairs);
/// None if a part has no name or no value.
std::optional<std::vector<std::pair<std::string, std::string>>> pairsFromText(const QString& text);
/// "0.3 0.2; -0.3 0.2; -0.3 -0.2"
QString pointsText(const std::vector<Vec2>& points);
/// None if a point is not two numbers.
std::optional<std::vector<Vec2>> pointsFromText(const QString& text);

/// Times or numbers of a list as text: "2.0, 7.5".
QString listText(const std::vector<double>& values);
/// None if a part is not a number.
std::optional<std::vector<double>> listFromText(const QString& text);

/// The part of an entity that contains the keys of T.
template <class T, class AnyEntity>
decltype(auto) partOf(AnyEntity& entity) {
  if constexpr (std::is_same_v<T, sim2d::Behavior>) {
    return (std::get<sim2d::Human>(entity).behavior);
  } else if constexpr (std::is_same_v<T, sim2d::PersonExtension>) {
    return (std::get<sim2d::Human>(entity).ours);
  } else if constexpr (std::is_same_v<T, sim2d::LidarSettings>) {
    return (std::get<sim2d::Robot>(entity).lidar);
  } else if constexpr (std::is_same_v<T, sim2d::DetectorSettings>) {
    return (std::get<sim2d::Robot>(entity).detector);
  } else if constexpr (std::is_same_v<T, sim2d::OdometrySettings>) {
    return (std::get<sim2d::Robot>(entity).odometryNoise);
  } else if constexpr (std::is_same_v<T, sim2d::LocalizationSettings>) {
    return (std::get<sim2d::Robot>(entity).localization);
  } else if constexpr (std::is_same_v<T, sim2d::BatterySettings>) {
    return (std::get<sim2d::Robot>(entity).battery);
  } else if constexpr (std::is_same_v<T, sim2d::DesktopSettings>) {
    return (std::get<ScenarioSettings>(entity).desktop);
  } else if constexpr (std::is_same_v<T, sim2d::ScenarioCard>) {
    return (std::get<ScenarioSettings>(entity).desktop.card);
  } else if constexpr (std::is_same_v<T, sim2d::VariationSettings>) {
    return (std::get<ScenarioSettings>(entity).desktop.variation);
  } else if constexpr (std::is_same_v<T, sim2d::MetricsSettings>) {
    return (std::get<ScenarioSettings>(entity).desktop.metrics);
  } else {
    return (std::get<T>(entity));
  }
}

/// The name of the widget for a key. Keys of maps within an entity get a prefix because they may be
/// equal.
template <class T>
std::string rowName(const std::string& key) {
  if constexpr (std::is_same_v<T, sim2d::LidarSettings>) {
    return "lidar." + key;
  } else if constexpr (std::is_same_v<T, sim2d::ScenarioCard>) {
    return "card." + key;
  } else if constexpr (std::is_same_v<T, sim2d::DetectorSettings>) {
    return "detector." + key;
  } else if constexpr (std::is_same_v<T, sim2d::OdometrySettings>) {
    return "odometry_noise." + key;
  } else if constexpr (std::is_same_v<T, sim2d::LocalizationSettings>) {
    return "localization." + key;
  } else if constexpr (std::is_same_v<T, sim2d::BatterySettings>) {
    return "battery." + key;
  } else {
    return key;
  }
}

/// `seed` returns the seed for sampled values.
template <class T>
EntityField entityField(const sim2d::Field<T>& field, const ScenarioDocument& document,
                        std::function<long long()> seed) {
  using Resolved = sim2d::Resolved<T>;
  EntityField result;
  result.spec = field.spec;
  result.is64Bit = field.is64Bit;
  result.get = [&field](const Entity& entity) { return field.value(partOf<T>(entity)); };
  result.set = [&field](Entity& entity, const base::ParameterValue& value) {
    field.assign(partOf<T>(entity), value);
  };
  result.belongs = [&field](const Entity& entity) { return field.belongsTo(partOf<T>(entity)); };
  result.fallback = [&field, &document, seed = std::move(seed)](const Entity& entity) {
    if constexpr (std::is_same_v<Resolved, sim2d::ResolvedHuman>) {
      if (field.resolved) {
        const auto& person = std::get<sim2d::Human>(entity);
        return field.resolved(sim2d::resolveHuman(document.scenario(), person, seed()), field.spec);
      }
    } else if constexpr (std::is_same_v<Resolved, sim2d::ResolvedRobot>) {
      if (field.resolved) {
        return field.resolved(sim2d::resolveRobot({}, std::get<sim2d::Robot>(entity), -1),
                              field.spec);
      }
    }
    return field.fallback(partOf<T>(entity), document.scenario().desktop);
  };
  return result;
}

}  // namespace editor
