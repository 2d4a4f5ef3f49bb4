#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "metrics/Expression.h"

namespace YAML {
class Node;
}

namespace metrics {

/// Reads formulas of the user's from a metrics file.
class FormulaReader {
 public:
  FormulaReader(std::string file, const MetricRegistry& registry, std::vector<MetricEntry>& own,
                base::Diagnostics& problems)
      : name_(std::move(file)), registry_(registry), own_(own), problems_(problems) {}
  /// `place`: where a missing map is told.
  void read(const YAML::Node& metrics, const YAML::Node& place);

 private:
  void error(const YAML::Node& node, std::string_view code, base::ProblemValues values = {});
  void readText(const YAML::Node& value, std::string& to);
  void readFormula(const std::string& key, const YAML::Node& place, const YAML::Node& value);
  void readBetter(const YAML::Node& value, Better& better);
  void addFormula(const UserMetric& metric, const YAML::Node& text);

  std::string name_;
  const MetricRegistry& registry_;
  std::vector<MetricEntry>& own_;
  base::Diagnostics& problems_;
};

/// The problem with the place of the node.
base::Diagnostic placed(base::Diagnostic problem, const YAML::Node& node, const std::string& file);

}  // namespace metrics
