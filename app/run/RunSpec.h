#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/run/MetricsSetup.h"
#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Result.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/Compatibility.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
class Validator;
}  // namespace CLI

namespace app {

/// Everything that determines a run. The places of its results and its observers are not part of
/// it.
struct RunSpec : MetricsOptions {
  std::string scenario;  // a file, or the name of a shipped scenario
  std::string map;       // instead of the scenario's; "none" = open plane; empty = the scenario's
  std::string trees;     // folder of behaviour trees; empty = the usual places
  std::optional<long long> seed;
  std::optional<double> duration, stuckAfter, dt;  // [s]
  std::optional<std::string> stopOnCollision, model, robot, robotStart, robotGoal, planner;
  std::vector<std::string> nav2Params;  // of the first robot: files, and single values NAME:=VALUE
  bool nav2Body = false;                // the first robot has the body of its Nav2 files
  std::optional<std::string> nav2Tree, nav2Distro;  // of the first robot
  int threads = 1;
  std::optional<int> recordEvery;  // [steps]
  std::vector<std::string> set;    // PATH=VALUE
  bool exact = false;
  std::string compat;
  bool allowCode = false;          // programs and libraries that the scenario names may start
  std::string from;                // RUN@SECONDS; empty: from the beginning
  std::vector<std::string> moves;  // "NAME X Y HEADING": people placed elsewhere at that moment
  bool counterfactual = false;     // run again with the same seed and without robots
  bool strict = false;             // substitutions are errors
};

/// An option of a run. The command line, experiments, branches and manifests read, check and write
/// options by these rows alone: a new option is a member of RunSpec and a row.
struct RunOption {
  using Member = std::variant<bool RunSpec::*, int RunSpec::*, std::string RunSpec::*,
                              std::vector<std::string> RunSpec::*, std::optional<int> RunSpec::*,
                              std::optional<long long> RunSpec::*, std::optional<double> RunSpec::*,
                              std::optional<std::string> RunSpec::*>;
  using Names = std::vector<std::string>;
  enum Use : unsigned {
    Always = 0,
    InExperiment = 1,   // a key of an experiment sets it for all runs
    AtBranch = 2,       // may change where a run branches
    OfCommand = 4,      // of the command `run` alone; the window has the others too
    FromBeginning = 8,  // refused where a run branches
  };

  const char* name;  // on the command line, without dashes; keys of files have _ instead of -
  Member member;
  const char* help;
  unsigned use = Always;
  const char* setting = nullptr;         // key of DesktopSettings that it sets; gives its range
  const char* robotSetting = nullptr;    // key of the first robot that it sets
  const char* problem = nullptr;         // code of a value out of range
  Names (*names)() = nullptr;            // that it takes; null: those of the setting, or any text
  base::Range range = base::kAnyNumber;  // where no setting gives it

  std::string key() const;  // "stuck_after"
  base::Range rangeOfValue() const;
  Names choices() const;  // empty: any text
  bool isGiven(const RunSpec& spec) const;
  /// Of a given option, as the command line writes it: no text for a flag; several for a list.
  std::vector<std::string> texts(const RunSpec& spec) const;
};

RunOption::Names knownModels();
RunOption::Names knownRobotTypes();
RunOption::Names knownPlanners();
RunOption::Names knownDistros();
RunOption::Names metricProfiles();

/// In the order of the help.
inline constexpr RunOption kRunOptions[] = {
    {"map", &RunSpec::map, "Map to use instead of the scenario's; none = open plane",
     RunOption::FromBeginning},
    {"trees", &RunSpec::trees, "Folder with the behaviour trees", RunOption::FromBeginning},
    {"seed", &RunSpec::seed, "Seed of all random numbers (default: the scenario's, otherwise 1)",
     RunOption::AtBranch, "seed", nullptr, "option.seed"},
    {"duration", &RunSpec::duration,
     "Duration of the run [s] (default: the scenario's, otherwise until the robot has arrived)",
     RunOption::InExperiment | RunOption::AtBranch, "duration", nullptr, "option.duration"},
    {"stop-on-collision", &RunSpec::stopOnCollision,
     "Stop at contacts of the robot with people or with anything (default: none)",
     RunOption::InExperiment | RunOption::AtBranch, "stop_on_collision"},
    {"stuck-after", &RunSpec::stuckAfter,
     "Stop if the robot makes no progress for this long [s]; 0 = never",
     RunOption::InExperiment | RunOption::AtBranch, "stuck_after", nullptr, "option.stuck-after"},
    {"dt", &RunSpec::dt, "Time step [s] (default: 0.05)",
     RunOption::InExperiment | RunOption::FromBeginning, "dt", nullptr, "option.dt"},
    {"model", &RunSpec::model, "Pedestrian model (hunavsim list models)",
     RunOption::InExperiment | RunOption::FromBeginning, "model", nullptr, nullptr, knownModels},
    {"robot", &RunSpec::robot, "Type of the robot (hunavsim list robots)",
     RunOption::InExperiment | RunOption::FromBeginning, nullptr, "type", nullptr, knownRobotTypes},
    {"robot-start", &RunSpec::robotStart, "Start pose of the robot [m, m, rad]",
     RunOption::FromBeginning},
    {"robot-goal", &RunSpec::robotGoal, "Goal of the robot [m]", RunOption::AtBranch},
    {"planner", &RunSpec::planner, "Planner of the robot (hunavsim list planners)",
     RunOption::InExperiment | RunOption::AtBranch, nullptr, "planner", nullptr, knownPlanners},
    {"nav2-params", &RunSpec::nav2Params,
     "With --planner nav2: a parameter file, the name of a shipped one, or a value in ROS 2 syntax "
     "(FollowPath.max_vel_x:=0.3, NODE:NAME:=VALUE); repeatable, later values override earlier "
     "ones",
     RunOption::AtBranch},
    {"nav2-body", &RunSpec::nav2Body,
     "With --planner nav2: use the robot radius or footprint from its parameter files",
     RunOption::AtBranch},
    {"nav2-tree", &RunSpec::nav2Tree,
     "With --planner nav2: behaviour tree file of the navigator, or the name of a shipped "
     "one",
     RunOption::AtBranch},
    {"nav2-distro", &RunSpec::nav2Distro,
     "With --planner nav2: version of Nav2 (default: guessed from the file)", RunOption::AtBranch,
     nullptr, "nav2_distro", nullptr, knownDistros},
    {"threads",
     &RunSpec::threads,
     "Number of threads (default: 1); does not change the results",
     RunOption::Always,
     nullptr,
     nullptr,
     "option.threads",
     nullptr,
     {1.0, 256.0}},
    {"metrics", &RunSpec::metrics, "Metrics: a metrics.yaml file, or comma-separated keys"},
    {"metrics-profile", &RunSpec::metricsProfile, "Definitions of the metrics (default: corrected)",
     RunOption::InExperiment, nullptr, nullptr, nullptr, metricProfiles},
    {"record-every", &RunSpec::recordEvery, "Record every N-th step (default: 1)",
     RunOption::FromBeginning, "record_every", nullptr, "option.record-every"},
    {"set", &RunSpec::set, "Set any value of the scenario (hunavsim list keys); repeatable",
     RunOption::AtBranch},
    {"exact", &RunSpec::exact, "Sum forces over all pairs in double precision",
     RunOption::FromBeginning},
    {"compat", &RunSpec::compat,
     "Reproduce quirks of HuNavSim 2.0: hunav2 (all), or a list: Q-13,Q-20",
     RunOption::FromBeginning},
    {"allow-code", &RunSpec::allowCode,
     "Allow the scenario to start external planner programs and libraries"},
    {"from", &RunSpec::from,
     "Repeat a recorded run up to this time, then continue with these options",
     RunOption::OfCommand},
    {"move", &RunSpec::moves, "With --from: new pose of a person at that time [m, m, rad]",
     RunOption::OfCommand | RunOption::AtBranch},
    {"counterfactual", &RunSpec::counterfactual,
     "Repeat the run without robots and report the effect of the robots on people",
     RunOption::OfCommand | RunOption::FromBeginning},
    {"strict", &RunSpec::strict,
     "Report an error instead of a warning where a value is replaced, ignored or set to a default",
     RunOption::OfCommand},
};

/// Settings of a run that are not part of the scenario.
struct RunSettings {
  sim2d::Compatibility compatibility;
  int threads = 1;
  bool exact = false;
  bool strict = false;  // input that is replaced, left out or set to a default is an error
  sim2d::ExternalCodePolicy code =
      sim2d::ExternalCodePolicy::Skipped;  // external code is reported, no world is created
};
/// Errors: invalid options (exit code 64).
base::Result<RunSettings> runSettingsOf(const RunSpec& spec);

/// "X Y HEADING": exactly `count` numbers separated by spaces or commas.
std::optional<std::vector<double>> parseNumbers(const std::string& text, std::size_t count);

/// Applies the options to the scenario: first `--set`, then the others, which take precedence.
base::Diagnostics applyOptions(sim2d::Scenario& scenario, const RunSpec& spec,
                               const sim2d::Compatibility& compatibility);

/// The command line of the run, without the program: `run`, the scenario and what is not at its
/// default; of the options those with one of these uses (0: all).
std::vector<std::string> commandLineOf(const RunSpec& spec, unsigned use = RunOption::Always);

/// For CLI::Option::check(): one of these words; else the nearest one is suggested.
CLI::Validator oneOf(const std::vector<std::string>& names);

/// Adds one option of a run, by its name.
void addRunOption(CLI::App& command, const char* name, RunSpec& spec);
/// Adds all options that the command `run` and the window have in common.
void addRunOptions(CLI::App& command, RunSpec& spec);
/// Adds the scenario and all options of the command `run` that determine the run.
void addRunArguments(CLI::App& command, RunSpec& spec);

/// The run that a command line describes, as a manifest keeps it, without the program's name.
/// Options that only write, show or pace the run are skipped. Error: it describes none.
base::Result<RunSpec> runSpecOfCommandLine(const std::vector<std::string>& words);
/// Names of the options that are skipped, with dashes: flags, and those with a value.
const std::vector<std::string>& skippedFlags();
const std::vector<std::string>& skippedOptions();

}  // namespace app
