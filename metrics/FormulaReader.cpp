#include "metrics/FormulaReader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <yaml-cpp/yaml.h>

#include "sim2d/base/Text.h"

namespace metrics {

base::Diagnostic placed(base::Diagnostic problem, const YAML::Node& node, const std::string& file) {
  const YAML::Mark mark = node.Mark();
  problem.file = file;
  problem.line = mark.is_null() ? 0 : mark.line + 1;
  problem.column = mark.is_null() ? 0 : mark.column + 1;
  return problem;
}

namespace {

bool isKey(const std::string& key) {
  const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !key.empty() && isLetter(key.front()) && std::all_of(key.begin(), key.end(), [&](char c) {
    return isLetter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

void FormulaReader::error(const YAML::Node& node, std::string_view code,
                          base::ProblemValues values) {
  problems_.push_back(placed(base::error(code, std::move(values)), node, name_));
}

void FormulaReader::readText(const YAML::Node& value, std::string& to) {
  if (value.IsScalar()) {
    to = value.Scalar();
  } else {
    error(value, "metrics.no-text");
  }
}

void FormulaReader::read(const YAML::Node& metrics, const YAML::Node& place) {
  if (!metrics.IsDefined() || !metrics.IsMap()) {
    error(place, "metrics.no-formulas");
    return;
  }
  for (const auto& entry : metrics) {
    const auto key = entry.first.as<std::string>("");
    const bool isTaken = registry_.find(key) != nullptr ||
                         std::any_of(own_.begin(), own_.end(), [&key](const MetricEntry& other) {
                           return other.info.key == key;
                         });
    if (isTaken) {
      error(entry.first, "metrics.name-taken", {key});
    } else if (!isKey(key)) {
      error(entry.first, "metrics.bad-key");
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
    error(place, "metrics.no-expression", {key});
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
      problems_.push_back(placed(
          base::warning("metrics.unknown-key",
                        {name, base::nearestName(name, {"expression", "name", "unit", "better"})}),
          entry.first, name_));
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
  error(value, "metrics.bad-better");
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
