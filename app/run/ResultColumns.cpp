#include "app/run/ResultColumns.h"

#include <nlohmann/json.hpp>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

std::string fieldOf(const Json& value) {
  if (value.is_null()) {
    return {};
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? "True" : "False";
  }
  if (value.is_number_float()) {
    return base::formatDouble(value.get<double>());
  }
  return base::jsonText(value, -1);
}

void addFields(const Json& of, const std::string& prefix, ResultValues& to) {
  const auto metrics = of.is_object() ? of.find("metrics") : of.end();
  if (metrics == of.end() || !metrics->is_object()) {
    return;
  }
  for (const auto& [key, entry] : metrics->items()) {
    to.fields[prefix + key] = fieldOf(entry.is_object() ? entry.value("value", Json()) : Json());
  }
}

}  // namespace

ResultValues resultValues(const std::string& metricsJson) {
  const Json json = Json::parse(metricsJson, nullptr, false);
  ResultValues values;
  addFields(json, "", values);
  const auto robots = json.is_object() ? json.find("robots") : json.end();
  if (robots != json.end() && robots->is_object()) {
    for (const auto& [name, of] : robots->items()) {
      values.robots.push_back(name);
      addFields(of, name + ".", values);
    }
  }
  return values;
}

std::vector<std::string> resultColumns(const std::set<std::string>& present,
                                       const std::vector<std::string>& robots) {
  std::vector<std::string> prefixes = {""};
  for (const std::string& robot : robots) {
    prefixes.push_back(robot + ".");
  }
  std::vector<std::string> columns;
  for (const std::string& prefix : prefixes) {
    for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
      if (present.count(prefix + entry.info.key) != 0) {
        columns.push_back(prefix + entry.info.key);
      }
    }
  }
  return columns;
}

}  // namespace app
