#include "app/studies/Gate.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/StudyRuns.h"
#include "app/report/GateReport.h"
#include "app/studies/StudyFolder.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct GateArguments {
  std::string base, candidate, output;
  std::vector<std::string> scenarios, metrics;
  RunSpec common;
  StudyRunOptions runs;
  int seeds = 200;
  long long firstSeed = 1;
  double level = 0.95;
};

const std::vector<std::string> kGateFiles = {"gate.html", "gate.md", "gate.xml", "gate.json"};

base::Result<std::vector<GateMetric>> metricsOf(const std::vector<std::string>& texts) {
  if (texts.empty()) {
    return defaultGateMetrics();
  }
  std::vector<GateMetric> metrics;
  base::Diagnostics problems;
  for (const std::string& text : texts) {
    const base::Result<GateMetric> metric = parseGateMetric(text);
    base::append(problems, metric.diagnostics());
    if (metric) {
      metrics.push_back(*metric);
    }
  }
  return base::resultOf(std::move(metrics), std::move(problems));
}

GateOptions gateOptionsOf(const GateArguments& arguments) {
  GateOptions options;
  const base::Result<std::vector<GateMetric>> metrics = metricsOf(arguments.metrics);
  requireFine(metrics.diagnostics(), ExitWrongCommandLine);
  const base::Result<GateSide> base = gateSideOf(arguments.base);
  const base::Result<GateSide> candidate = gateSideOf(arguments.candidate);
  base::Diagnostics problems = base.diagnostics();
  base::append(problems, candidate.diagnostics());
  requireFine(problems);
  const base::Result<std::vector<GateScenario>> scenarios =
      gateScenarios(*base, *candidate, arguments.scenarios);
  requireFine(scenarios.diagnostics());
  options.base = *base;
  options.candidate = *candidate;
  options.scenarios = *scenarios;
  options.metrics = *metrics;
  options.common = arguments.common;
  options.common.allowCode = arguments.runs.allowCode;  // for the commands that play runs
  options.level = 1.0 - arguments.level;
  options.maxSeeds = arguments.seeds;
  options.firstSeed = arguments.firstSeed;
  return options;
}

/// The metrics that are not decided, for the progress line.
std::string openMetricsText(const GateTest& test) {
  std::vector<std::string> names;
  for (const GateMetricResult& each : test.metrics()) {
    if (each.verdict == GateVerdict::Undecided) {
      names.push_back(each.metric.label());
    }
  }
  return names.empty() ? std::string() : "open: " + base::join(names, ", ");
}

/// All runs of the first seed, to find what would prevent the gate.
std::vector<RunRequest> firstRequests(const GateOptions& options) {
  std::vector<RunRequest> requests;
  for (std::size_t scenario = 0; scenario < options.scenarios.size(); ++scenario) {
    for (const bool candidate : {false, true}) {
      requests.push_back(gateRequest(options, scenario, options.firstSeed, candidate));
    }
  }
  return requests;
}

/// Also the exit code when a stop was requested.
GateResult runInPool(const GateArguments& arguments, const GateOptions& options, RunPool& pool,
                     RunProgress& progress) {
  const base::Diagnostics problems = pool.check(firstRequests(options));
  const bool isInFile = std::any_of(problems.begin(), problems.end(),
                                    [](const auto& each) { return !each.file.empty(); });
  requireFine(problems, isInFile ? ExitBadInput : ExitWrongCommandLine);
  catchInterrupts();
  base::Result<GateResult> result = runGate(options, pool, [&progress](const GateTest& test) {
    progress.setNote(openMetricsText(test));
  });
  progress.clear();
  const bool isStopped = wasInterrupted() && !result;
  if (isStopped && arguments.output.empty()) {
    requireFine({base::error("gate.stopped")}, ExitRunFailed);
  }
  requireFine(result.diagnostics(), isStopped ? ExitRunFailed : ExitBadInput);
  return *std::move(result);
}

int exitCodeOf(GateVerdict verdict) {
  return verdict == GateVerdict::Pass    ? ExitFine
         : verdict == GateVerdict::Worse ? ExitRunFailed
                                         : ExitUndecided;
}

void printGate(const report::GateReport& report, const GateResult& result,
               const Invocation& given) {
  if (given.json) {
    print(report.json);
  } else if (given.quiet) {
    printLine(report.headline);
  } else {
    printTable(report::gateRows(result));
    printLine(report::gateColumnsText());
    printLine(report.headline);
  }
}

int gateCommand(const GateArguments& arguments, const Invocation& given) {
  const GateOptions options = gateOptionsOf(arguments);
  std::unique_ptr<StudyFolder> folder;
  if (!arguments.output.empty()) {
    base::Result<std::unique_ptr<StudyFolder>> opened = StudyFolder::open(
        arguments.output, kGateFiles, existingStudy(arguments.runs.resume, arguments.runs.force));
    requireFine(opened.diagnostics());
    folder = *std::move(opened);
  }
  RunProgress progress(given.quiet || given.json,
                       2 * options.scenarios.size() * static_cast<std::size_t>(options.maxSeeds),
                       true);
  const std::unique_ptr<RunPool> pool =
      openStudyPool(arguments.runs, folder ? folder->journal() : std::string(), progress);
  const GateResult result = runInPool(arguments, options, *pool, progress);
  const report::GateReport report =
      report::makeGateReport(options, result, given.argumentsForResults(), pool->inputs());
  if (folder) {
    requireFine(folder->finish({{"gate.html", report.html},
                                {"gate.md", report.markdown},
                                {"gate.xml", report.junit},
                                {"gate.json", report.json}},
                               "gate"));
  }
  printGate(report, result, given);
  return exitCodeOf(result.verdict);
}

void addGateRunOptions(CLI::App& command, GateArguments& arguments) {
  command
      .add_option("--seeds", arguments.seeds, "Largest number of seeds per scenario (default: 200)")
      ->check(CLI::Range(1, 100000));
  command
      .add_option("--first-seed", arguments.firstSeed,
                  "First seed; each further pair of runs uses the next seed (default: 1)")
      ->check(CLI::NonNegativeNumber);
  for (const char* name :
       {"duration", "stop-on-collision", "stuck-after", "model", "robot", "planner", "nav2-params",
        "nav2-tree", "nav2-distro", "set", "metrics-profile"}) {
    addRunOption(command, name, arguments.common);
  }
  addStudyRunOptions(command, arguments.runs, "gate");
}

}  // namespace

void addGate(CommandRegistry& commands) {
  const auto [command, arguments] = commands.add(
      "gate", "Test whether a candidate is not worse than a base, for build servers", gateCommand);
  const char* const kSides =
      ": parameter file, tree, planner, program, PATH=VALUE, scenario or folder of scenarios";
  command.add_option("base", arguments.base, std::string("Baseline") + kSides)->required();
  command.add_option("candidate", arguments.candidate, std::string("Candidate to test") + kSides)
      ->required();
  command.add_option("--scenarios", arguments.scenarios,
                     "Scenario files, or names of shipped scenarios (hunavsim list scenarios); for "
                     "two folders: names of their scenarios (default: all)");
  command
      .add_option("--metric", arguments.metrics,
                  "KEY:MARGIN or KEY>NUMBER:MARGIN (share of runs above the number); margins with "
                  "% are points of a rate, otherwise relative; repeatable (default: success:5%, "
                  "time_to_reach_goal:5%, intimate_space_intrusions:2, "
                  "robot_on_person_collision>0:5%)")
      ->allow_extra_args(false);
  command
      .add_option("--level", arguments.level,
                  "Confidence level: one minus the probability of a wrong pass or false alarm "
                  "(default: 0.95)")
      ->check(CLI::Range(0.5, 0.999));
  addGateRunOptions(command, arguments);
  addOutputFolder(command, arguments.output,
                  "Folder for gate.html, gate.md, gate.xml (JUnit), gate.json and the journal");
  commands.addExamples(
      command,
      {{"hunavsim gate dwa mppi --scenarios crossing_agents doorway_agents --metric "
        "time_to_reach_goal:10% -o gate",
        "Test whether mppi is at most 10 % slower than dwa in two scenarios", "some minutes"},
       {"hunavsim gate main.yaml changed.yaml --scenarios crossing_agents -o gate",
        "Compare two parameter files of Nav2", "your files"},
       {"hunavsim gate mppi \"python3 planner.py\" --allow-code --scenarios crossing_agents",
        "Compare a planner of your own with a built-in one", "your program"}});
}

}  // namespace app
