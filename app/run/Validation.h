#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim2d/world/realism/RealismTest.h"

namespace app {

/// One quantity of one realism test with one model.
struct ValidationRow {
  std::string test, model;
  sim2d::Quantity quantity;
  double value = 0.0;
  std::string problem;         // why there is no value
  std::vector<double> values;  // one per seed
  bool passes() const { return problem.empty() && quantity.passes(value); }
};

struct ValidationJob {
  std::vector<const sim2d::RealismTest*> tests;
  std::vector<std::string> models;
  int seeds = 10;  // 1 to this, where draws count
  std::function<bool()> wantsStop;
  /// Runs done of all, and which is next.
  std::function<void(std::size_t done, std::size_t all, const std::string& next)> onProgress;
};

struct Validation {
  std::vector<ValidationRow> rows;
  bool isComplete = true;  // false: it was stopped
};
Validation runValidation(const ValidationJob& job);

std::string validationJson(const std::vector<ValidationRow>& rows);
/// validation.csv and validation.json; the folder is made.
base::Diagnostics writeValidation(const std::string& folder,
                                  const std::vector<ValidationRow>& rows);

}  // namespace app
