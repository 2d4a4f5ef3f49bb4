#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace report {

using Numbers = std::vector<double>;

/// The contents of results.csv of a batch.
struct Results {
  struct Run {
    long long number = 0;
    std::string scenario;
    long long seed = 0;
    std::vector<std::string> values;  // one per path
    bool ok = true;
    std::string reason;  // failure reason
  };

  std::vector<std::string> paths;  // dimensions of the experiment (--set paths)
  std::vector<std::string> keys;   // metric keys
  std::vector<Run> runs;
  std::vector<Numbers> metrics;  // per key and run; NaN: undefined; true: 1, false: 0
  std::vector<bool> isBoolean;   // per key: all values are True or False

  /// The index of a key, or keys.size().
  std::size_t keyAt(const std::string& key) const;
};

/// Parses results.csv. Reports every problem with its position: missing columns, rows of a
/// different width, invalid numbers, duplicate runs. `file` is used in the messages.
base::Result<Results> parseResults(const std::string& text, const std::string& file);

}  // namespace report
