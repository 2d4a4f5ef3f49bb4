#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/run/BundleReader.h"
#include "app/run/Experiment.h"

namespace app {

/// Checks the options of an experiment that set a planner, its parameters or its files, up to the
/// creation of the world of a run; nothing is executed. Each option is checked once in each folder
/// of scenarios, to which its relative paths refer, beside the texts that the first run has for
/// other values. One thread.
class OptionCheck {
 public:
  /// The experiment must outlive this.
  explicit OptionCheck(const Experiment& experiment);

  /// Errors of runs of this scenario with other options than the first run, located in the
  /// experiment; one per option. `usual`: the errors of the first run, which are not repeated.
  base::Diagnostics errorsIn(std::size_t scenario, const base::Diagnostics& usual,
                             BundleReader& reader);

 private:
  struct Option {
    std::size_t value, text;             // their numbers
    bool isWrong = false;                // an error has been reported
    std::set<std::string> folders = {};  // where it has been checked
  };
  base::Diagnostic atOption(const Option& option, const std::string& scenarioPath,
                            base::Diagnostic problem) const;

  const Experiment& experiment_;
  std::vector<Option> options_;
};

}  // namespace app
