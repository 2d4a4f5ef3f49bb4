
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

constexpr double kLargestInteger = 2147483647.0;

/// For 64-bit integers the upper limit is not checked.
std::optional<long long> readInteger(YamlMap& view, const ParameterSpec& spec, bool is64Bit) {
  const auto low = static_cast<long long>(std::max(spec.range.low, -kLargestInteger));
  const auto high = static_cast<long long>(std::min(spec.range.high, kLargestInteger));
  return is64Bit ? view.integer(spec.key, low) : view.integer(spec.key, low, high);
}

template <class T>
std::set<std::string> keysWith(std::set<std::string> keys) {
  for (const Field<T>& field : fieldsOf<T>()) {
    keys.insert(field.spec.key);
  }
  return keys;
}

std::string rangeText(const Range& range) {
  const std::string low = base::formatDouble(range.low);
  const std::string high = base::formatDouble(range.high);
  if (range.high >= kLargestInteger) {  // not informative
    return std::isinf(range.low) ? "" : (range.excludesLow ? "> " : "≥ ") + low;
  }
  if (std::isinf(range.low)) {
    return "≤ " + high;
  }
  return (range.excludesLow ? "above " : "") + low + " to " + high;
}

std::string valuesText(const ParameterSpec& spec) {
  static constexpr std::array<const char*, 7> kTypes = {
      // in the order of ParameterType
      "true, false", "integer", "number", "text", "text", "numbers", "integers"};
  const std::string range = rangeText(spec.range);
  return !spec.choices.empty()
             ? base::join(spec.choices, ", ")
             : kTypes.at(static_cast<std::size_t>(spec.type)) + (range.empty() ? "" : " " + range);
}

std::string valueText(const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    return *text;
  }
  if (const auto* number = std::get_if<double>(&value)) {
    return base::formatDecimals(*number, 1);
  }
  if (const auto* integer = std::get_if<long long>(&value)) {
    return std::to_string(*integer);
  }
  const auto* flag = std::get_if<bool>(&value);
  return flag == nullptr ? "" : *flag ? "true" : "false";
}

template <class T>
KeyTable tableOf(std::string title, std::string path, const FieldTables& tables) {
  KeyTable table{std::move(title), std::move(path), {}};
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    const ParameterSpec& spec = field.spec;
    const bool isMap = field.isStructure() && spec.type == ParameterType::Number;
    table.rows.push_back({spec.key, isMap ? "map" : valuesText(spec), spec.unit,
                          field.required ? "required" : valueText(spec.fallback), spec.help});
  }
  return table;
}

}  // namespace

const FieldTables& fieldTables() {
  static const FieldTables kTables(
      scenarioFields(), humanFields(), behaviorFields(), personFields(), robotFields(),
      lidarFields(), detectorFields(), odometryFields(), localizationFields(), batteryFields(),
      obstacleFields(), doorFields(), areaFields(), dockFields(), settingsFields(), cardFields(),
      variationFields(), metricsFields());
  return kTables;
}

ParameterValue readValue(YamlMap& view, const ParameterSpec& spec, bool is64Bit) {
  switch (spec.type) {
    case ParameterType::Boolean:
      return valueFrom(view.boolean(spec.key), spec);
    case ParameterType::Integer:
      return valueFrom(readInteger(view, spec, is64Bit), spec);
    case ParameterType::Number:
      return valueFrom(view.number(spec.key, spec.range), spec);
    case ParameterType::Numbers:
      return valueFrom(view.numbers(spec.key, spec.range), spec);
    case ParameterType::Integers:
      return valueFrom(view.integers(spec.key), spec);
    case ParameterType::Choice:
    case ParameterType::Text:
      break;
  }
  const bool isText = spec.choices.empty();
  return valueFrom(isText ? view.text(spec.key) : view.choice(spec.key, spec.choices), spec);
}

void writeValue(YamlNode& tree, const ParameterSpec& spec, const ParameterValue& value,
                int digits) {
  if (const auto* flagged = std::get_if<bool>(&value)) {
    setChild(tree, spec.key, flag(*flagged));
  } else if (const auto* integer = std::get_if<long long>(&value)) {
    setChild(tree, spec.key, number(*integer));
  } else if (const auto* real = std::get_if<double>(&value)) {
    setChild(tree, spec.key, decimals(*real, digits));
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    setChild(tree, spec.key, stringNode(*text));
  } else if (const auto* reals = std::get_if<std::vector<double>>(&value)) {
    setChild(tree, spec.key, decimalList(*reals));
  } else if (const auto* integers = std::get_if<std::vector<int>>(&value)) {
    setChild(tree, spec.key, integerList(*integers));
  }
}

const std::set<std::string>& loaderKeys() {
  static const std::set<std::string> kKeys = keysWith<ScenarioSettings>({"global_goals", "agents"});
  return kKeys;
}

const std::set<std::string>& desktopKeys() {
  // "map": a menu of HuNavSim searches the whole text for that key
  static const std::set<std::string> kKeys = keysWith<DesktopSettings>(
      {"format", "map", "robots", "obstacles", "doors", "areas", "docks", "metrics"});
  return kKeys;
}

bool isEntityName(const std::string& name) {
  return !name.empty() && base::isLetter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [](char c) { return base::isLetter(c) || base::isDigit(c) || c == '_'; });
}

std::vector<KeyTable> keyTables(const FieldTables& tables) {
  return {
      tableOf<ScenarioSettings>("The scenario", "", tables),
      tableOf<Human>("A person", "PERSON.", tables),
      tableOf<Behavior>("The `behavior` of a person", "PERSON.behavior.", tables),
      tableOf<DesktopSettings>("The run", "", tables),
      tableOf<ScenarioCard>("`card`", "card.", tables),
      tableOf<VariationSettings>("`variation`", "variation.", tables),
      tableOf<MetricsSettings>("`metrics`", "metrics.", tables),
      tableOf<PersonExtension>("A person, keys of HuNavSim Desktop", "PERSON.", tables),
      tableOf<Robot>("A robot", "ROBOT.", tables),
      tableOf<LidarSettings>("The `lidar` of a robot", "ROBOT.lidar.", tables),
      tableOf<DetectorSettings>("The `detector` of a robot", "ROBOT.detector.", tables),
      tableOf<OdometrySettings>("The `odometry_noise` of a robot", "ROBOT.odometry_noise.", tables),
      tableOf<LocalizationSettings>("The `localization` of a robot", "ROBOT.localization.", tables),
      tableOf<BatterySettings>("The `battery` of a robot", "ROBOT.battery.", tables),
      tableOf<Obstacle>("An obstacle", "OBSTACLE.", tables),
      tableOf<Door>("A door", "DOOR.", tables),
      tableOf<Area>("An area", "AREA.", tables),
      tableOf<Dock>("A dock", "DOCK.", tables)};
}

std::string keysMarkdown(const FieldTables& tables) {
  std::string text;
  for (const KeyTable& table : keyTables(tables)) {
    text += "**" + table.title + "**\n\n| key | values | unit | default | meaning |\n" +
            "|---|---|---|---|---|\n";
    for (const KeyRow& row : table.rows) {
      text += "| `" + row.key + "` | " + row.values + " | " + row.unit + " | " + row.fallback +
              " | " + row.help + " |\n";
    }
    text += "\n";
  }
  return text;
}

}  // namespace sim2d
