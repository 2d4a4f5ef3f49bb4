#pragma once

#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/scenario/Fields.h"

/// The tables, one function each, and reading and writing by them. Private to this folder.
namespace sim2d {

Fields<Environment> environmentFields();
Fields<Human> humanFields();
Fields<Behavior> behaviorFields();
Fields<PersonExtension> personFields();
Fields<Robot> robotFields();
Fields<Obstacle> obstacleFields();
Fields<Door> doorFields();
Fields<Area> areaFields();
Fields<DesktopSettings> settingsFields();
Fields<MetricsSettings> metricsFields();

/// The value of one key, checked by its type and range; what is wrong with it is reported.
base::ParameterValue readValue(base::YamlMap& view, const base::ParameterSpec& spec, bool isWide);
/// A required key that is missing is reported too.
base::ParameterValue readRequired(base::YamlMap& view, const base::ParameterSpec& spec,
                                  bool isWide);
/// Nothing is written for monostate.
void writeValue(base::YamlNode& tree, const base::ParameterSpec& spec,
                const base::ParameterValue& value, int digits);

template <class T>
void readFields(base::YamlMap& view, T& to, const FieldTables& tables) {
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    if (!field.belongsTo(to)) {
      continue;
    }
    if (field.read) {
      field.read(view, to);
    } else {
      field.assign(to, field.required ? readRequired(view, field.spec, field.isWide)
                                      : readValue(view, field.spec, field.isWide));
    }
  }
}

template <class T>
void writeFields(base::YamlNode& tree, const T& of, const FieldTables& tables) {
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    if (!field.belongsTo(of)) {
      continue;
    }
    if (field.write) {
      field.write(tree, of);
    } else {
      const int digits = field.digitsOf ? field.digitsOf(of) : field.digits;
      writeValue(tree, field.spec, field.value(of), digits);
    }
  }
}

}  // namespace sim2d
