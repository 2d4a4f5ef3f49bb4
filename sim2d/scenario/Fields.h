#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/Scenario.h"

/// The keys of each kind of thing in a scenario file, described once. Reader, range checks, writer,
/// canonical order, default-skipping, equality, `--set`, defaults, forms, `list keys` and the
/// tables of FORMAT.md come from these tables. What is made of parts (poses, points, goals) brings
/// a function to read and one to write it.
namespace sim2d {

using base::ParameterSpec;
using base::ParameterType;
using base::ParameterValue;

/// What counts in a run for a T whose keys may be absent.
struct NothingResolved {};
template <class T>
using Resolved = std::conditional_t<
    std::is_same_v<T, Robot> || std::is_same_v<T, LidarSettings> ||
        std::is_same_v<T, DetectorSettings> || std::is_same_v<T, OdometrySettings> ||
        std::is_same_v<T, LocalizationSettings> || std::is_same_v<T, BatterySettings>,
    ResolvedRobot,
    std::conditional_t<std::is_same_v<T, Human> || std::is_same_v<T, Behavior> ||
                           std::is_same_v<T, PersonExtension>,
                       ResolvedHuman, NothingResolved>>;

/// One key of a T: its description and its place in the plain struct.
template <class T>
struct Field {
  ParameterSpec spec;
  bool required = false;
  bool isWide = false;  // an integer of 64 bits
  int digits = 1;       // after the point, at least, in canonical files
  std::string group;    // forms fold the keys of a group under this title; empty: none

  std::function<ParameterValue(const T&, const ParameterSpec&)> get;
  std::function<void(T&, const ParameterValue&, const ParameterSpec&)> set;
  std::function<bool(const T&, const T&)> equal;
  std::function<void(const T&, Resolved<T>&, const ParameterSpec&)> resolve;
  // the value that counts in a run; null: a run has no member for it
  std::function<ParameterValue(const Resolved<T>&, const ParameterSpec&)> resolved;

  // What differs from field to field; null = as usual.
  std::function<bool(const T&)> applies;  // the key belongs to such a T
  std::function<int(const T&)> digitsOf;
  std::function<ParameterValue(const T&, const DesktopSettings&)> fallbackOf;
  std::function<void(base::YamlMap&, T&)> read;
  std::function<void(base::YamlNode&, const T&)> write;

  /// Made of parts: no single value to get or set.
  bool isStructure() const { return !get; }
  bool belongsTo(const T& of) const { return !applies || applies(of); }
  /// As written; monostate = absent, also for an empty list.
  ParameterValue value(const T& of) const { return get(of, spec); }
  /// monostate takes it away; where a number is always there it becomes 0.
  void assign(T& of, const ParameterValue& value) const { set(of, value, spec); }
  /// What counts in this place when the key is absent; monostate = nothing does.
  ParameterValue fallback(const T& of, const DesktopSettings& desktop) const {
    return fallbackOf ? fallbackOf(of, desktop) : spec.fallback;
  }
};

template <class T>
using Fields = std::vector<Field<T>>;

/// A table for each kind of thing, in canonical order.
struct FieldTables
    : std::tuple<Fields<ScenarioSettings>, Fields<Human>, Fields<Behavior>, Fields<PersonExtension>,
                 Fields<Robot>, Fields<LidarSettings>, Fields<DetectorSettings>,
                 Fields<OdometrySettings>, Fields<LocalizationSettings>, Fields<BatterySettings>,
                 Fields<Obstacle>, Fields<Door>, Fields<Area>, Fields<Dock>,
                 Fields<DesktopSettings>, Fields<VariationSettings>, Fields<MetricsSettings>> {
  using tuple::tuple;
};
const FieldTables& fieldTables();

template <class T>
const Fields<T>& fieldsOf(const FieldTables& tables = fieldTables()) {
  return std::get<Fields<T>>(tables);
}

/// nullptr = no such key.
template <class T>
const Field<T>* fieldOf(std::string_view key, const FieldTables& tables = fieldTables()) {
  const Fields<T>& all = fieldsOf<T>(tables);
  const auto found = std::find_if(all.begin(), all.end(),
                                  [key](const auto& each) { return each.spec.key == key; });
  return found == all.end() ? nullptr : &*found;
}

/// Takes away what stands at its default.
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

/// Puts the values that are there into what counts in a run.
template <class T>
void resolveFields(const T& from, Resolved<T>& to) {
  for (const Field<T>& field : fieldsOf<T>()) {
    if (field.resolve) {
      field.resolve(from, to, field.spec);
    }
  }
}

/// Fills these keys with the values that count: where they are absent, or everywhere.
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

// The keys as people read about them: `list keys` and FORMAT.md.
struct KeyRow {
  std::string key;
  std::string values;    // "> 0", "planned, direct", "text" …
  std::string unit;      // may be empty
  std::string fallback;  // what counts when it is absent; "required"; empty = nothing does
  std::string help;
};
struct KeyTable {
  std::string title;  // "A robot"
  std::string path;   // before the key in `--set`: "ROBOT."
  std::vector<KeyRow> rows;
};

std::vector<KeyTable> keyTables(const FieldTables& tables = fieldTables());
std::string keysMarkdown(const FieldTables& tables = fieldTables());

}  // namespace sim2d
