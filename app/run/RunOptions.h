#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/run/MetricsSetup.h"
#include "sim2d/base/Result.h"
#include "sim2d/nav/external/CodePermission.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/Compatibility.h"

namespace app {

/// The words of the command line about the live view.
struct LiveWords {
  std::optional<int> port;  // none: there is no live view; 0: any that is free
  std::string address = "127.0.0.1";
  std::vector<std::string> origins;  // of pages that may connect beside the usual ones
};

/// The words about Groot2.
struct GrootWords {
  std::optional<int> port;  // none: it cannot watch; 0: any that is free
  std::string person;       // whose tree; empty: of the first
};

/// The options of `run`, as given; also of the window.
struct RunOptions {
  std::string scenario;
  std::string output;  // -o; empty: nothing is written
  std::string map, trees;
  std::optional<long long> seed;
  std::optional<double> duration, dt, stuckAfter;
  std::optional<std::string> stopOnCollision;  // none, people, any
  std::optional<std::string> model, robot, robotStart, robotGoal, planner;
  std::vector<std::string> nav2Params;  // of the first robot: files, and single values NAME:=VALUE
  std::optional<std::string> nav2Tree, nav2Distro;  // idem
  bool nav2Body = false;                            // idem: its body is that of its files
  int threads = 1;
  MetricsWords metrics;
  std::optional<int> recordEvery;
  std::vector<std::string> set;    // PATH=VALUE
  std::string from;                // RUN@SECONDS; empty: from the beginning
  std::vector<std::string> moves;  // NAME X Y HEADING, then
  std::vector<RunOptions> then;    // of runs that went on from this one, each over those before
  bool exact = false;
  bool counterfactual = false;  // the same seed again without robots
  std::string compat;
  std::string speed;  // simulated seconds per second, "max"; empty: as it is usual
  LiveWords live;
  GrootWords groot;
  bool allowCode = false;  // programs and libraries that the scenario names may start
  bool strict = false;     // substitutions are errors
  bool force = false;      // files of others in the output folder may be replaced
  std::string record;      // "mcap": a rosbag2 folder too; empty: nothing more
  bool totals = false;  // manifest.json and metrics.json alone, nothing per step or behaviour type
};

/// How a run is computed, beside what the scenario says.
struct RunSettings {
  sim2d::Compatibility compatibility;
  int threads = 1;
  bool exact = false;
  bool strict = false;  // what is replaced, left out or taken by default is an error
  sim2d::CodeUse code = sim2d::CodeUse::LeftOut;  // then there are problems, but no world to run
};
/// Errors: what is wrong with the words of the command line (exit code 64).
base::Result<RunSettings> runSettingsOf(const RunOptions& options);

/// "X Y HEADING": exactly `count` numbers between blanks (commas are taken too).
std::optional<std::vector<double>> parseNumbers(const std::string& text, std::size_t count);

/// Writes the options into the scenario: first `--set`, then the options of their own, which win.
base::Diagnostics applyOptions(sim2d::Scenario& scenario, const RunOptions& options,
                               const sim2d::Compatibility& compatibility);

}  // namespace app
