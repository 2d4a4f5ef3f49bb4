#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace report {

using Numbers = std::vector<double>;

/// results.csv of a batch.
struct Results {
  struct Run {
    long long number = 0;
    std::string scenario;
    long long seed = 0;
    std::vector<std::string> values;  // one per path
    bool ok = true;
    std::string reason;  // of a failure
  };

  std::vector<std::string> paths;  // of --set, the dimensions of the experiment
  std::vector<std::string> keys;   // of metrics
  std::vector<Run> runs;
  std::vector<Numbers> metrics;  // per key, per run; NaN = undefined; true = 1, false = 0
  std::vector<bool> isBoolean;   // per key: all of its values are True or False

  /// Place of a key, or keys.size().
  std::size_t keyAt(const std::string& key) const;
};

/// Every problem with its place: columns that are no results, rows of another width, fields that
/// are no numbers, a run that is there twice. `file` is named in the problems.
base::Result<Results> parseResults(const std::string& text, const std::string& file);

}  // namespace report
