#include "app/studies/Gate.h"

#include <algorithm>
#include <chrono>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/report/GateReport.h"
#include "app/run/Batch.h"
#include "app/studies/StudyFolder.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct GateWords {
  std::string base, candidate, output;
  std::vector<std::string> scenarios, metrics;
  RunSpec common;
  int jobs = processorCount();
  int seeds = 200;
  long long firstSeed = 1;
  double level = 0.95, timeLimit = 0.0;  // [s]; 0 = none
  bool allowCode = false, resume = false, force = false;
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

GateOptions gateOptionsOf(const GateWords& words) {
  GateOptions options;
  const base::Result<std::vector<GateMetric>> metrics = metricsOf(words.metrics);
  requireFine(metrics.diagnostics(), ExitWrongCommandLine);
  const base::Result<GateSide> base = gateSideOf(words.base);
  const base::Result<GateSide> candidate = gateSideOf(words.candidate);
  base::Diagnostics problems = base.diagnostics();
  base::append(problems, candidate.diagnostics());
  requireFine(problems);
  const base::Result<std::vector<GateScenario>> scenarios =
      gateScenarios(*base, *candidate, words.scenarios);
  requireFine(scenarios.diagnostics());
  options.base = *base;
  options.candidate = *candidate;
  options.scenarios = *scenarios;
  options.metrics = *metrics;
  options.common = words.common;
  options.common.allowCode = words.allowCode;  // for the commands that play runs
  options.level = 1.0 - words.level;
  options.maxSeeds = words.seeds;
  options.firstSeed = words.firstSeed;
  return options;
}

/// Shows runs, speed, the longest time left, and the metrics that are still open.
class GateProgress {
 public:
  GateProgress(bool quiet, std::size_t most) : progress_(quiet), most_(most) {}

  void showRuns(std::size_t finished) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    std::string text = std::to_string(finished) + " / at most " + std::to_string(most_) + " runs";
    if (finished > 0 && elapsed.count() > 0.0) {
      const double left =
          elapsed.count() * (static_cast<double>(most_) / static_cast<double>(finished) - 1.0);
      text += ", at most " + durationText(left) + " left";
    }
    progress_.show(text + (open_.empty() ? "" : ", open: " + open_));
  }
  void setOpen(const GateTest& test) {
    std::vector<std::string> names;
    for (const GateMetricResult& each : test.metrics()) {
      if (each.verdict == GateVerdict::Undecided) {
        names.push_back(each.metric.label());
      }
    }
    open_ = base::join(names, ", ");
  }

 private:
  Progress progress_;
  const std::size_t most_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string open_;
};

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
GateResult runInPool(const GateWords& words, const GateOptions& options, RunPool& pool,
                     GateProgress& progress) {
  const base::Diagnostics problems = pool.check(firstRequests(options));
  const bool isInFile = std::any_of(problems.begin(), problems.end(),
                                    [](const auto& each) { return !each.file.empty(); });
  requireFine(problems, isInFile ? ExitBadInput : ExitWrongCommandLine);
  catchInterrupts();
  base::Result<GateResult> result =
      runGate(options, pool, [&progress](const GateTest& test) { progress.setOpen(test); });
  const bool isStopped = wasInterrupted() && !result;
  if (isStopped && words.output.empty()) {
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
    printLine(report.headline);
  }
}

int gateCommand(const GateWords& words, const Invocation& given) {
  const GateOptions options = gateOptionsOf(words);
  std::unique_ptr<StudyFolder> folder;
  if (!words.output.empty()) {
    base::Result<std::unique_ptr<StudyFolder>> opened =
        StudyFolder::open(words.output, kGateFiles, existingStudy(words.resume, words.force));
    requireFine(opened.diagnostics());
    folder = *std::move(opened);
  }
  GateProgress progress(given.quiet || given.json,
                        2 * options.scenarios.size() * static_cast<std::size_t>(options.maxSeeds));
  RunPoolOptions poolOptions;
  poolOptions.jobs = words.jobs;
  poolOptions.timeLimit = words.timeLimit > 0.0 ? words.timeLimit : poolOptions.timeLimit;
  poolOptions.allowCode = words.allowCode;
  poolOptions.loader = loadMapImage;
  poolOptions.journal = folder ? folder->journal() : std::string();
  poolOptions.wantsStop = wasInterrupted;
  poolOptions.showProgress = [&progress](std::size_t finished, std::size_t /*requested*/) {
    progress.showRuns(finished);
  };
  base::Result<std::unique_ptr<RunPool>> pool = RunPool::open(std::move(poolOptions));
  requireFine(pool.diagnostics());
  const GateResult result = runInPool(words, options, **pool, progress);
  const report::GateReport report =
      report::makeGateReport(options, result, given.wordsForResults(), (*pool)->inputs());
  if (folder) {
    requireFine(folder->finish({{"gate.html", report.html},
                                {"gate.md", report.markdown},
                                {"gate.xml", report.junit},
                                {"gate.json", report.json}},
                               base::jsonText(nlohmann::ordered_json{{"kind", "gate"}})));
  }
  printGate(report, result, given);
  return exitCodeOf(result.verdict);
}

void addGateRunOptions(CLI::App& command, GateWords& words) {
  command.add_option("--seeds", words.seeds, "Largest number of seeds per scenario (default: 200)")
      ->check(CLI::Range(1, 100000));
  command
      .add_option("--first-seed", words.firstSeed,
                  "First seed; each pair of runs has the next one (default: 1)")
      ->check(CLI::NonNegativeNumber);
  for (const char* name :
       {"duration", "stop-on-collision", "stuck-after", "model", "robot", "planner", "nav2-params",
        "nav2-tree", "nav2-distro", "set", "metrics-profile"}) {
    addRunOption(command, name, words.common);
  }
  addJobs(command, words.jobs);
  addTimeLimit(command, words.timeLimit);
  addAllowCode(command, words.allowCode);
}

}  // namespace

void addGate(CommandRegistry& commands) {
  const auto [command, words] = commands.add(
      "gate", "Test whether a candidate is not worse than a base, for build servers", gateCommand);
  const char* const kSides =
      ": parameter file, tree, planner, program, PATH=VALUE, scenario or folder of scenarios";
  command.add_option("base", words.base, std::string("What is compared with") + kSides)->required();
  command.add_option("candidate", words.candidate, std::string("What is tested") + kSides)
      ->required();
  command.add_option("--scenarios", words.scenarios,
                     "Scenario files, or names from list scenarios (of compared folders: names in "
                     "them; default: all)");
  command
      .add_option("--metric", words.metrics,
                  "KEY:MARGIN or KEY>NUMBER:MARGIN (share of runs above the number); margins with "
                  "% are points of a rate, otherwise relative; repeatable (default: success:5%, "
                  "time_to_reach_goal:5%, intimate_space_intrusions:2, "
                  "robot_on_person_collision>0:5%)")
      ->allow_extra_args(false);
  command
      .add_option("--level", words.level,
                  "One minus the probability of a wrong pass, and of a false alarm (default: 0.95)")
      ->check(CLI::Range(0.5, 0.999));
  addGateRunOptions(command, words);
  addOutputFolder(command, words.output,
                  "Folder for gate.html, gate.md, gate.xml (JUnit), gate.json and the journal");
  CLI::Option* const resume = command.add_flag(
      "--resume", words.resume, "Use the runs in the journal of an earlier gate in the folder");
  command
      .add_flag("--force", words.force,
                "Start again after an interruption; overwrite files that hunavsim did not create")
      ->excludes(resume);
  commands.addExamples(
      command,
      {{"hunavsim gate dwa mppi --scenarios crossing_agents doorway_agents --metric "
        "time_to_reach_goal:10% -o gate",
        "Is mppi at most 10 % slower than dwa in two scenes?", "some minutes"},
       {"hunavsim gate main.yaml changed.yaml --scenarios crossing_agents -o gate",
        "Compare two parameter files of Nav2", "your files"},
       {"hunavsim gate mppi \"python3 planner.py\" --allow-code --scenarios crossing_agents",
        "Compare a planner of your own with a built-in one", "your program"}});
}

}  // namespace app
