#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/Scenario.h"

/// Declarative field tables: the keys of each kind of object in a scenario file. Reader, range
/// checks, writer, canonical order, omission of defaults, equality, `--set`, defaults, forms, `list
/// keys` and the tables of FORMAT.md are generated from them. Composite values (poses, points,
/// goals) have their own read and write functions.
namespace sim2d {

using base::ParameterSpec;
using base::ParameterType;
using base::ParameterValue;

/// The struct with the effective values of a T; monostate: none.
template <class T>
using Resolved = std::conditional_t<
    std::is_same_v<T, Robot> || std::is_same_v<T, LidarSettings> ||
        std::is_same_v<T, DetectorSettings> || std::is_same_v<T, OdometrySettings> ||
        std::is_same_v<T, LocalizationSettings> || std::is_same_v<T, BatterySettings>,
    ResolvedRobot,
    std::conditional_t<std::is_same_v<T, Human> || std::is_same_v<T, Behavior> ||
                           std::is_same_v<T, PersonExtension>,
                       ResolvedHuman, std::monostate>>;

/// One key of a T: its description and its member.
template <class T>
struct Field {
  ParameterSpec spec;
  bool required = false;
  bool is64Bit = false;  // 64-bit integer
  int digits = 1;        // minimum number of decimals in canonical files
  std::string group;     // title of the collapsible section in forms; empty: none

  std::function<ParameterValue(const T&, const ParameterSpec&)> get;
  std::function<void(T&, const ParameterValue&, const ParameterSpec&)> set;
  std::function<bool(const T&, const T&)> equal;
  std::function<void(const T&, Resolved<T>&, const ParameterSpec&)> resolve;
  // The effective value; null: a run does not use it.
  std::function<ParameterValue(const Resolved<T>&, const ParameterSpec&)> resolved;

  // Exceptions; null: default behaviour.
  std::function<bool(const T&)> applies;  // whether a T has this key
  std::function<int(const T&)> digitsOf;
  std::function<ParameterValue(const T&, const DesktopSettings&)> fallbackOf;
  std::function<void(base::YamlMap&, T&)> read;
  std::function<void(base::YamlNode&, const T&)> write;

  /// Composite: no single value to get or set.
  bool isStructure() const { return !get; }
  bool belongsTo(const T& of) const { return !applies || applies(of); }
  /// As written; monostate: absent or an empty list.
  ParameterValue value(const T& of) const { return get(of, spec); }
  /// monostate removes the value; a member that is not optional becomes 0.
  void assign(T& of, const ParameterValue& value) const { set(of, value, spec); }
  /// The default in this context; monostate: none.
  ParameterValue fallback(const T& of, const DesktopSettings& desktop) const {
    return fallbackOf ? fallbackOf(of, desktop) : spec.fallback;
  }
};

template <class T>
using Fields = std::vector<Field<T>>;

/// One table per kind of object, in canonical order.
struct FieldTables
    : std::tuple<Fields<ScenarioSettings>, Fields<Human>, Fields<Behavior>, Fields<PersonExtension>,
                 Fields<Robot>, Fields<LidarSettings>, Fields<DetectorSettings>,
                 Fields<OdometrySettings>, Fields<LocalizationSettings>, Fields<BatterySettings>,
                 Fields<Obstacle>, Fields<Door>, Fields<Area>, Fields<Dock>,
                 Fields<DesktopSettings>, Fields<ScenarioCard>, Fields<VariationSettings>,
                 Fields<MetricsSettings>> {
  using tuple::tuple;
};
const FieldTables& fieldTables();

template <class T>
const Fields<T>& fieldsOf(const FieldTables& tables = fieldTables()) {
  return std::get<Fields<T>>(tables);
}

/// nullptr: unknown key.
template <class T>
const Field<T>* fieldOf(std::string_view key, const FieldTables& tables = fieldTables()) {
  return base::findIf(fieldsOf<T>(tables),
                      [key](const auto& each) { return each.spec.key == key; });
}

/// Removes values that equal their default.
template <class T>
void dropDefaults(T& from, const DesktopSettings& desktop,
                  const FieldTables& tables = fieldTables()) {
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    if (field.isStructure() || field.required) {
      continue;
    }
    const ParameterValue value = field.value(from);
    if (value != ParameterValue() && value == field.fallback(from, desktop)) {
      field.assign(from, {});
    }
  }
}

/// Copies the given values to the effective ones.
template <class T>
void resolveFields(const T& from, Resolved<T>& to) {
  for (const Field<T>& field : fieldsOf<T>()) {
    if (field.resolve) {
      field.resolve(from, to, field.spec);
    }
  }
}

/// Sets these keys to the effective values: where they are absent, or all.
template <class T>
void fillFields(T& to, const Resolved<T>& counts, const std::vector<std::string_view>& keys,
                bool overwrite = false) {
  for (const std::string_view key : keys) {
    const Field<T>& field = *fieldOf<T>(key);
    if (overwrite || field.value(to) == ParameterValue()) {
      field.assign(to, field.resolved(counts, field.spec));
    }
  }
}

// The keys for documentation: `list keys` and FORMAT.md.
struct KeyRow {
  std::string key;
  std::string values;    // "> 0", "planned, direct", "text" …
  std::string unit;      // may be empty
  std::string fallback;  // default; "required"; empty: none
  std::string help;
};
struct KeyTable {
  std::string title;  // "A robot"
  std::string path;   // prefix of the key in `--set`: "ROBOT."
  std::vector<KeyRow> rows;
};

std::vector<KeyTable> keyTables(const FieldTables& tables = fieldTables());
std::string keysMarkdown(const FieldTables& tables = fieldTables());

}  // namespace sim2d
