#pragma once

#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace sim2d {

/// What reading gives. With errors among the diagnostics the scenario holds what could be read
/// (for an editor to show) and must not be run.
struct ScenarioReading {
  Scenario scenario;
  base::Diagnostics diagnostics;
  Dialect dialect = Dialect::C;
  int commentCount = 0;  // lost when saved over
  bool ok() const { return !base::hasErrors(diagnostics); }
};

ScenarioReading readScenario(const std::string& path);
ScenarioReading readScenarioText(const std::string& text, const std::string& fileName);

/// Canonical dialect C plus our block. `unit`: see FORMAT.md.
std::string writeScenario(const Scenario& scenario);
/// Dialect B for the older wrappers; what it cannot express is told in `losses`.
std::string writeScenarioB(const Scenario& scenario, base::Diagnostics& losses);

/// `--set PATH=VALUE` (FORMAT.md): dotted keys below ros__parameters; `*` = every listed person.
base::Diagnostics setValue(Scenario& scenario, const std::string& path, const std::string& value);

}  // namespace sim2d
