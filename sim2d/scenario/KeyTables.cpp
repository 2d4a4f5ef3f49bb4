#include <array>
#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/Fields.h"

namespace sim2d {
namespace {

std::string rangeText(const base::Range& range) {
  constexpr double largestInt = 2147483647.0;  // says nothing to people
  const std::string low = base::formatDouble(range.low);
  const std::string high = base::formatDouble(range.high);
  if (range.high >= largestInt) {
    return std::isinf(range.low) ? "" : (range.above ? "> " : "≥ ") + low;
  }
  return (range.above ? "above " : "") + low + " to " + high;
}

std::string valuesText(const base::ParameterSpec& spec) {
  static constexpr std::array<const char*, 7> kTypes = {
      // in the order of ParameterType
      "true, false", "integer", "number", "text", "text", "numbers", "integers"};
  const std::string range = rangeText(spec.range);
  return !spec.choices.empty()
             ? base::join(spec.choices, ", ")
             : kTypes.at(static_cast<std::size_t>(spec.type)) + (range.empty() ? "" : " " + range);
}

std::string valueText(const base::ParameterValue& value) {
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
    const base::ParameterSpec& spec = field.spec;
    const bool isMap = field.isStructure() && spec.type == base::ParameterType::Number;
    table.rows.push_back({spec.key, isMap ? "map" : valuesText(spec), spec.unit,
                          field.required ? "required" : valueText(spec.fallback), spec.help});
  }
  return table;
}

}  // namespace

std::vector<KeyTable> keyTables(const FieldTables& tables) {
  return {tableOf<Environment>("The scenario", "", tables),
          tableOf<Human>("A person", "PERSON.", tables),
          tableOf<Behavior>("The `behavior` of a person", "PERSON.behavior.", tables),
          tableOf<DesktopSettings>("The run", "", tables),
          tableOf<MetricsSettings>("`metrics`", "metrics.", tables),
          tableOf<PersonExtension>("A person, keys of ours", "PERSON.", tables),
          tableOf<Robot>("A robot", "ROBOT.", tables),
          tableOf<Obstacle>("An obstacle", "OBSTACLE.", tables),
          tableOf<Door>("A door", "DOOR.", tables),
          tableOf<Area>("An area", "AREA.", tables)};
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
