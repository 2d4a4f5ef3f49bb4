#include "metrics/FormulaReader.h"

#include <algorithm>
#include <optional>

#include <yaml-cpp/yaml.h>

#include "sim2d/base/Text.h"

namespace metrics {

std::string nearestHint(const std::string& key, const std::vector<std::string>& known) {
  const std::optional<std::string> nearest = base::nearestName(key, known);
  return nearest ? " (did you mean '" + *nearest + "'?)" : "";
}

base::Diagnostic diagnosticAt(const YAML::Node& node, base::Severity severity,
                              const std::string& file, const std::string& message) {
  const YAML::Mark mark = node.Mark();
  return {severity, file, mark.is_null() ? 0 : mark.line + 1, mark.is_null() ? 0 : mark.column + 1,
          message,  {}};
}

namespace {

bool isKey(const std::string& key) {
  const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !key.empty() && isLetter(key.front()) && std::all_of(key.begin(), key.end(), [&](char c) {
    return isLetter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

void FormulaReader::error(const YAML::Node& node, const std::string& message) {
  problems_.push_back(diagnosticAt(node, base::Severity::Error, name_, message));
}

void FormulaReader::readText(const YAML::Node& value, std::string& to) {
  if (value.IsScalar()) {
    to = value.Scalar();
  } else {
    error(value, "must be a text");
  }
}

void FormulaReader::read(const YAML::Node& metrics, const YAML::Node& place) {
  if (!metrics.IsDefined() || !metrics.IsMap()) {
    error(place, "no map of formulas (hunavsim_metrics: ros__parameters: <key>: ...)");
    return;
  }
  for (const auto& entry : metrics) {
    const auto key = entry.first.as<std::string>("");
    const bool isTaken = registry_.find(key) != nullptr ||
                         std::any_of(own_.begin(), own_.end(), [&key](const MetricEntry& other) {
                           return other.info.key == key;
                         });
    if (isTaken) {
      error(entry.first, "there is a metric '" + key + "' already");
    } else if (!isKey(key)) {
      error(entry.first, "a key is made of a-z, 0-9 and _, and begins with a letter");
    } else {
      readFormula(key, entry.first, entry.second);
    }
  }
}

void FormulaReader::readFormula(const std::string& key, const YAML::Node& place,
                                const YAML::Node& value) {
  UserMetric metric;
  metric.key = key;
  if (!value.IsMap() || !value["expression"] || !value["expression"].IsScalar()) {
    error(place, "'" + key + "' needs an expression");
    return;
  }
  for (const auto& entry : value) {
    const auto name = entry.first.as<std::string>("");
    if (name == "expression") {
      metric.expression = entry.second.Scalar();
    } else if (name == "name") {
      readText(entry.second, metric.name);
    } else if (name == "unit") {
      readText(entry.second, metric.unit);
    } else if (name == "better") {
      readBetter(entry.second, metric.better);
    } else {
      problems_.push_back(
          diagnosticAt(entry.first, base::Severity::Warning, name_,
                       "unknown key '" + name + "'" +
                           nearestHint(name, {"expression", "name", "unit", "better"})));
    }
  }
  addFormula(metric, value["expression"]);
}

void FormulaReader::readBetter(const YAML::Node& value, Better& better) {
  for (const Better candidate : {Better::Lower, Better::Higher, Better::Neutral}) {
    if (value.IsScalar() && value.Scalar() == betterName(candidate)) {
      better = candidate;
      return;
    }
  }
  error(value, "better is lower, higher or neutral");
}

/// Problems get the place in this file: formulas stand on one line, in quotes or not.
void FormulaReader::addFormula(const UserMetric& metric, const YAML::Node& text) {
  const base::Result<MetricEntry> entry = entryOf(metric);
  if (entry) {
    own_.push_back(*entry);
  }
  const YAML::Mark mark = text.Mark();
  const int quote = text.Tag() == "!" ? 1 : 0;
  for (base::Diagnostic problem : entry.diagnostics()) {
    problem.file = name_;
    problem.line = mark.line + 1;
    problem.column += mark.column + quote;
    problems_.push_back(problem);
  }
}

}  // namespace metrics
