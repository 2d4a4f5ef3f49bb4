#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

namespace app {

/// What `batch` runs: scenarios x values x seeds.
struct Experiment {
  enum class Record { Metrics, Failed, All };

  std::string path;
  std::vector<std::string> scenarios;      // as written: relative files or names of shipped ones
  std::vector<std::string> scenarioPaths;  // where they lie
  std::vector<long long> seeds;
  std::map<std::string, std::string> options;  // of `run`: "--dt" -> "0.05"
  std::vector<std::pair<std::string, std::vector<std::string>>> values;  // --set path -> texts
  Record record = Record::Metrics;
  bool allowCode = false;  // said by who starts the batch, never in the file

  /// Run `index`: scenarios outermost, then values in their order, seeds innermost.
  struct Run {
    std::size_t scenario = 0;
    long long seed = 1;
    std::vector<std::string> values;  // one per path
  };
  std::size_t runCount() const;
  Run run(std::size_t index) const;
};

/// Every problem with file:line:column; unknown keys are errors.
base::Result<Experiment> readExperiment(const std::string& path);

}  // namespace app
