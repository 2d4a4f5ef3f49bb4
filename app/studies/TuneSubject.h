#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/RunPool.h"
#include "app/studies/TuneParameters.h"

namespace app {

/// The value of each tuned parameter as text, in the order of the parameters.
using TunedValues = std::vector<std::string>;

/// What is tuned: a parameter file of Nav2, or the planner of a scenario's first robot.
class TuneSubject {
 public:
  /// `path`: the file. `scenarios`: paths of all scenarios that are run. `spec`: options of all
  /// runs. Errors: the files cannot be read, no parameter is listed for the controller or planner.
  /// Warnings: listed parameters that the file cannot have.
  static base::Result<TuneSubject> open(const std::string& path, const TuningList& list,
                                        const std::vector<std::string>& scenarios, RunSpec spec);

  bool isNav2() const { return isNav2_; }
  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }              // of the file
  const std::string& controller() const { return controller_; }  // plugin, or planner
  const std::vector<TunedParameter>& parameters() const { return parameters_; }
  TunedValues present() const;  // the values before tuning

  RunRequest request(const std::string& scenario, long long seed, const TunedValues& values) const;
  /// The text of the file with the values that differ from the current ones. Everything else keeps
  /// its bytes. Nothing: a value cannot be written.
  std::optional<std::string> textWith(const TunedValues& values) const;

 private:
  base::Diagnostics openNav2(const TuningList& list, const std::string& scenario);
  base::Diagnostics openPlanner(const TuningList& list);
  std::optional<std::string> textWith(std::size_t parameter, const std::string& text,
                                      const std::string& value) const;

  std::string path_, text_, controller_;
  bool isNav2_ = false;
  std::string robot_;  // of the scenario whose planner is tuned
  std::vector<std::pair<std::string, std::string>> fixed_;  // other parameters of its planner
  std::map<std::string, std::string> robots_;               // first robot by scenario
  RunSpec spec_;
  std::vector<TunedParameter> parameters_;
};

}  // namespace app
