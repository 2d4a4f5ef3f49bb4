#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/Scenario.h"

namespace base {
class YamlMap;
struct YamlNode;
}  // namespace base

/// The keys of each kind of thing in a scenario file, described once. Reader, range checks, writer,
/// canonical order, default-skipping, equality, `--set`, defaults, forms, `list keys` and the
/// tables of FORMAT.md come from these tables. What is made of parts (poses, points, goals) brings
/// a function to read and one to write it.
namespace sim2d {

/// What counts in a run for a T whose keys may be absent.
template <class T>
struct Resolving {
  struct Type {};
};
template <>
struct Resolving<Robot> {
  using Type = ResolvedRobot;
};
template <>
struct Resolving<Human> {
  using Type = ResolvedHuman;
};
template <>
struct Resolving<Behavior> : Resolving<Human> {};
template <>
struct Resolving<PersonExtension> : Resolving<Human> {};

/// One key of a T: its description and its place in the plain struct.
template <class T>
struct Field {
  base::ParameterSpec spec;
  bool required = false;
  bool isWide = false;  // an integer of 64 bits
  int digits = 1;       // after the point, at least, in canonical files

  std::function<base::ParameterValue(const T&, const base::ParameterSpec&)> get;
  std::function<void(T&, const base::ParameterValue&, const base::ParameterSpec&)> set;
  std::function<bool(const T&, const T&)> equal;
  std::function<void(const T&, typename Resolving<T>::Type&, const base::ParameterSpec&)> resolve;
  // the value that counts in a run; null: a run has no member for it
  std::function<base::ParameterValue(const typename Resolving<T>::Type&,
                                     const base::ParameterSpec&)>
      resolved;

  // What differs from field to field; null = as usual.
  std::function<bool(const T&)> applies;  // the key belongs to such a T
  std::function<int(const T&)> digitsOf;
  std::function<base::ParameterValue(const T&, const DesktopSettings&)> fallbackOf;
  std::function<void(base::YamlMap&, T&)> read;
  std::function<void(base::YamlNode&, const T&)> write;

  /// Made of parts: no single value to get or set.
  bool isStructure() const { return !get; }
  bool belongsTo(const T& of) const { return !applies || applies(of); }
  /// As written; monostate = absent, also for an empty list.
  base::ParameterValue value(const T& of) const { return get(of, spec); }
  /// monostate takes it away; where a number is always there it becomes 0.
  void assign(T& of, const base::ParameterValue& value) const { set(of, value, spec); }
  /// What counts in this place when the key is absent; monostate = nothing does.
  base::ParameterValue fallback(const T& of, const DesktopSettings& desktop) const {
    return fallbackOf ? fallbackOf(of, desktop) : spec.fallback;
  }
};

template <class T>
using Fields = std::vector<Field<T>>;

/// A table for each kind of thing, in canonical order.
struct FieldTables
    : std::tuple<Fields<ScenarioSettings>, Fields<Human>, Fields<Behavior>, Fields<PersonExtension>,
                 Fields<Robot>, Fields<Obstacle>, Fields<Door>, Fields<Area>,
                 Fields<DesktopSettings>, Fields<MetricsSettings>> {
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

/// All keys have the same values in `a` and `b`.
template <class T>
bool haveSameValues(const T& a, const T& b) {
  const Fields<T>& all = fieldsOf<T>();
  return std::all_of(all.begin(), all.end(), [&](const auto& each) { return each.equal(a, b); });
}

/// Takes away what stands at its default.
template <class T>
void dropDefaults(T& from, const DesktopSettings& desktop,
                  const FieldTables& tables = fieldTables()) {
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    if (field.isStructure() || field.required) {
      continue;
    }
    const base::ParameterValue value = field.value(from);
    if (value != base::ParameterValue() && value == field.fallback(from, desktop)) {
      field.assign(from, {});
    }
  }
}

/// Puts the values that are there into what counts in a run.
template <class T>
void resolveFields(const T& from, typename Resolving<T>::Type& to) {
  for (const Field<T>& field : fieldsOf<T>()) {
    if (field.resolve) {
      field.resolve(from, to, field.spec);
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
