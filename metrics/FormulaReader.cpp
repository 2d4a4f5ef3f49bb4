#include "metrics/FormulaReader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"

namespace metrics {

base::Diagnostic placed(base::Diagnostic problem, const base::YamlNode& node,
                        const std::string& file) {
  problem.file = file;
  problem.line = node.line;
  problem.column = node.column;
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

void FormulaReader::error(const base::YamlNode& node, std::string_view code,
                          base::ProblemValues values) {
  problems_.push_back(placed(base::error(code, std::move(values)), node, name_));
}

void FormulaReader::readText(const base::YamlNode& value, std::string& to) {
  if (value.isScalar()) {
    to = value.text;
  } else {
    error(value, "metrics.no-text");
  }
}

void FormulaReader::read(const base::YamlNode* metrics, const base::YamlNode& place) {
  if (metrics == nullptr || !metrics->isMap()) {
    error(place, "metrics.no-formulas");
    return;
  }
  for (const base::YamlNode& entry : metrics->items) {
    const std::string& key = entry.key;
    const bool isTaken = registry_.find(key) != nullptr ||
                         std::any_of(own_.begin(), own_.end(), [&key](const MetricEntry& other) {
                           return other.info.key == key;
                         });
    if (isTaken) {
      error(keyNode(entry), "metrics.name-taken", {key});
    } else if (!isKey(key)) {
      error(keyNode(entry), "metrics.bad-key");
    } else {
      readFormula(key, keyNode(entry), entry);
    }
  }
}

void FormulaReader::readFormula(const std::string& key, const base::YamlNode& place,
                                const base::YamlNode& value) {
  UserMetric metric;
  metric.key = key;
  const base::YamlNode* expression = value.find("expression");
  if (expression == nullptr || !expression->isScalar()) {
    error(place, "metrics.no-expression", {key});
    return;
  }
  for (const base::YamlNode& entry : value.items) {
    const std::string& name = entry.key;
    if (name == "expression") {
      metric.expression = entry.text;
    } else if (name == "name") {
      readText(entry, metric.name);
    } else if (name == "unit") {
      readText(entry, metric.unit);
    } else if (name == "better") {
      readBetter(entry, metric.better);
    } else {
      problems_.push_back(placed(
          base::warning("metrics.unknown-key",
                        {name, base::nearestName(name, {"expression", "name", "unit", "better"})}),
          keyNode(entry), name_));
    }
  }
  addFormula(metric, *expression);
}

void FormulaReader::readBetter(const base::YamlNode& value, Better& better) {
  for (const Better candidate : {Better::Lower, Better::Higher, Better::Neutral}) {
    if (value.isScalar() && value.text == betterName(candidate)) {
      better = candidate;
      return;
    }
  }
  error(value, "metrics.bad-better");
}

/// Problems get the place in this file: formulas stand on one line, in quotes or not.
void FormulaReader::addFormula(const UserMetric& metric, const base::YamlNode& text) {
  const base::Result<MetricEntry> entry = entryOf(metric);
  if (entry) {
    own_.push_back(*entry);
  }
  const int quote = text.quoted && text.tag.empty() ? 1 : 0;
  for (base::Diagnostic problem : entry.diagnostics()) {
    problem.file = name_;
    problem.line = text.line;
    problem.column += text.column - 1 + quote;
    problems_.push_back(problem);
  }
}

}  // namespace metrics
