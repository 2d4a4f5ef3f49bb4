#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "metrics/Expression.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace metrics {

/// Reads formulas of the user's from a metrics file.
class FormulaReader {
 public:
  FormulaReader(std::string file, const MetricRegistry& registry, std::vector<MetricEntry>& own,
                base::Diagnostics& problems)
      : name_(std::move(file)), registry_(registry), own_(own), problems_(problems) {}
  /// `place`: where a missing map is told.
  void read(const base::YamlNode* metrics, const base::YamlNode& place);

 private:
  void error(const base::YamlNode& node, std::string_view code, base::ProblemValues values = {});
  void readText(const base::YamlNode& value, std::string& to);
  void readFormula(const std::string& key, const base::YamlNode& place,
                   const base::YamlNode& value);
  void readBetter(const base::YamlNode& value, Better& better);
  void addFormula(const UserMetric& metric, const base::YamlNode& text);

  std::string name_;
  const MetricRegistry& registry_;
  std::vector<MetricEntry>& own_;
  base::Diagnostics& problems_;
};

/// The problem with the place of the node.
base::Diagnostic placed(base::Diagnostic problem, const base::YamlNode& node,
                        const std::string& file);

}  // namespace metrics
