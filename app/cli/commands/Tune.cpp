#include "app/studies/Tune.h"

#include <filesystem>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/StudyRuns.h"
#include "app/report/TuneReport.h"
#include "app/run/DataPaths.h"
#include "app/studies/StudyFolder.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace app {

namespace {

struct TuneArguments {
  std::string params, output, parameters;
  std::vector<std::string> scenarios, heldOut, objectives;
  RunSpec common;
  TuneOptions numbers;   // counts, seeds and limits
  double maxLoss = 5.0;  // [%]
  StudyRunOptions runs;
};

std::vector<std::string> pathsOf(const std::vector<std::string>& names) {
  base::Result<std::vector<std::string>> paths = scenarioFiles(names);
  requireFine(paths.diagnostics());
  return *std::move(paths);
}

std::vector<TuneObjective> objectivesOf(const std::vector<std::string>& texts) {
  static const std::vector<std::string> kUsual = {"time_to_reach_goal",
                                                  "intimate_space_intrusions"};
  std::vector<TuneObjective> objectives;
  base::Diagnostics problems;
  for (const std::string& text : texts.empty() ? kUsual : texts) {
    const base::Result<TuneObjective> objective = tuneObjective(text);
    base::append(problems, objective.diagnostics());
    if (objective) {
      objectives.push_back(*objective);
    }
  }
  requireFine(problems, ExitWrongCommandLine);
  return objectives;
}

TuneOptions tuneOptionsOf(const TuneArguments& arguments) {
  TuneOptions options = arguments.numbers;
  options.objectives = objectivesOf(arguments.objectives);
  options.maxLoss = arguments.maxLoss / 100.0;
  const base::Result<std::string> text = base::readTextFile(scenarioFile(arguments.params));
  if (arguments.scenarios.empty() && text && sim2d::nav2::looksLikeNav2(*text)) {
    requireFine({base::error("tune.no-scenarios", {}, arguments.params)}, ExitWrongCommandLine);
  }
  options.scenarios =
      pathsOf(arguments.scenarios.empty() ? std::vector<std::string>{arguments.params}
                                          : arguments.scenarios);
  options.heldOut = arguments.heldOut.empty() ? options.scenarios : pathsOf(arguments.heldOut);
  return options;
}

TuneSubject subjectOf(const TuneArguments& arguments, const TuneOptions& options) {
  const base::Result<TuningList> list =
      readTuningList(arguments.parameters.empty() ? shippedTuningList() : arguments.parameters);
  requireFine(list.diagnostics());
  RunSpec spec = arguments.common;
  spec.allowCode = arguments.runs.allowCode;
  std::vector<std::string> keys(std::begin(kSuccessKeys), std::end(kSuccessKeys));
  for (const TuneObjective& objective : options.objectives) {
    keys.push_back(objective.key);
  }
  keys.emplace_back(kRemainingKey);
  spec.metrics = base::join(keys, ",");  // computing the others takes longer
  std::vector<std::string> scenarios = options.scenarios;
  scenarios.insert(scenarios.end(), options.heldOut.begin(), options.heldOut.end());
  base::Result<TuneSubject> subject =
      TuneSubject::open(scenarioFile(arguments.params), *list, scenarios, spec);
  requireFine(subject.diagnostics());
  return *std::move(subject);
}

/// One run per scenario, to find what would prevent the search.
std::vector<RunRequest> firstRunsOf(const TuneOptions& options, const TuneSubject& subject) {
  std::vector<RunRequest> requests;
  for (const std::vector<std::string>* scenarios : {&options.scenarios, &options.heldOut}) {
    for (const std::string& scenario : *scenarios) {
      requests.push_back(subject.request(scenario, kSearchSeed, subject.present()));
    }
  }
  return requests;
}

void printTune(const report::TuneReport& made, const Invocation& given) {
  if (given.json) {
    print(made.json);
    return;
  }
  if (!given.quiet && !made.diff.empty()) {
    print(made.diff);
  }
  printLine(made.headline);
}

int tuneCommand(const TuneArguments& arguments, const Invocation& given) {
  const TuneOptions options = tuneOptionsOf(arguments);
  const TuneSubject subject = subjectOf(arguments, options);
  const std::string tunedName = subject.isNav2()
                                    ? "nav2_params.yaml"
                                    : std::filesystem::path(subject.path()).filename().string();
  const base::Result<std::unique_ptr<StudyFolder>> folder =
      StudyFolder::open(arguments.output, {tunedName, "changes.diff", "report.html", "tune.json"},
                        existingStudy(arguments.runs.resume, arguments.runs.force));
  requireFine(folder.diagnostics());
  RunProgress progress(given.quiet || given.json, options.runs, true);
  const std::unique_ptr<RunPool> pool =
      openStudyPool(arguments.runs, (*folder)->journal(), progress);
  requireFine(pool->check(firstRunsOf(options, subject)));
  catchInterrupts();
  const base::Result<TuneResult> result =
      tune(options, subject, *pool, [&progress](const std::string& stage, std::size_t planned) {
        progress.setStage(stage);
        progress.setTotal(planned);
      });
  progress.clear();
  requireFine(result.diagnostics(), wasInterrupted() ? ExitRunFailed : ExitBadInput);
  const report::TuneReport made = report::makeTuneReport(
      options, subject, *result, {tunedName, given.argumentsForResults(), pool->inputs()});
  std::vector<base::FileContent> files = {{tunedName, made.tuned},
                                          {"changes.diff", made.diff},
                                          {"report.html", made.html},
                                          {"tune.json", made.json}};
  for (const report::Table& table : made.tables) {
    files.push_back({"tables/" + table.name + ".csv", report::tableCsv(table)});
  }
  for (const report::Figure& figure : made.figures) {
    files.push_back({"figures/" + figure.name() + ".svg", figure.standalone()});
  }
  requireFine((*folder)->finish(files, "tune"));
  printTune(made, given);
  return ExitFine;
}

void addTuneSearchOptions(CLI::App& command, TuneArguments& arguments) {
  TuneOptions& numbers = arguments.numbers;
  command
      .add_option("--runs", numbers.runs,
                  "Limit of the runs of the search, without the evaluation (default: " +
                      std::to_string(numbers.runs) + ")")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000'000}));
  command
      .add_option("--seeds", numbers.seeds,
                  "Seeds per scenario and generation of the search, from 10001 on (default: " +
                      std::to_string(numbers.seeds) + ")")
      ->check(CLI::Range(1, 10000));
  command
      .add_option("--held-out-seeds", numbers.heldOutSeeds,
                  "Seeds per scenario in the evaluation, from 1001 on (default: " +
                      std::to_string(numbers.heldOutSeeds) + ")")
      ->check(CLI::Range(2, 9000));
  command
      .add_option("--max-changes", numbers.maxChanges,
                  "Largest number of changed parameters (default: 8)")
      ->check(CLI::Range(1, 1000));
  command
      .add_option("--max-loss", arguments.maxLoss,
                  "Accepted loss of the other objective [%] (default: 5)")
      ->check(CLI::Range(0.0, 100.0));
  command
      .add_option("--population", numbers.population,
                  "Candidates per generation (default: 4 + 3 ln of the number of parameters)")
      ->check(CLI::Range(2, 10000));
  command
      .add_option("--search-seed", numbers.searchSeed,
                  "Seed of the random numbers of the search (default: 1)")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000'000}));
}

void addTuneRunOptions(CLI::App& command, TuneArguments& arguments) {
  for (const char* name :
       {"duration", "stop-on-collision", "stuck-after", "model", "robot", "planner", "nav2-body",
        "nav2-tree", "nav2-distro", "set", "metrics-profile"}) {
    addRunOption(command, name, arguments.common);
  }
  addStudyRunOptions(command, arguments.runs, "search");
}

}  // namespace

void addTune(CommandRegistry& commands) {
  const auto [command, arguments] =
      commands.add("tune", "Search for better parameters of a Nav2 file or planner", tuneCommand);
  command
      .add_option("params", arguments.params,
                  "Parameter file of Nav2; or a scenario, to tune the planner of its first robot")
      ->required();
  command.add_option("--scenarios", arguments.scenarios,
                     "Scenario files, or names of shipped scenarios (hunavsim list scenarios); "
                     "default when tuning a scenario: that scenario");
  command.add_option("--held-out", arguments.heldOut,
                     "Scenarios of the evaluation (default: those of the search, with other "
                     "seeds)");
  command
      .add_option("--objective", arguments.objectives,
                  "KEY or KEY=WEIGHT of a metric (hunavsim list metrics); repeatable (default: "
                  "time_to_reach_goal and intimate_space_intrusions). Success is a constraint")
      ->allow_extra_args(false);
  command.add_option("--parameters", arguments.parameters,
                     "List of the parameters with their ranges (default: resources/tuning/"
                     "parameters.yaml)");
  addTuneSearchOptions(command, arguments);
  addTuneRunOptions(command, arguments);
  addOutputFolder(command, arguments.output,
                  "Folder for the tuned file, changes.diff, report.html, tune.json and the journal")
      .required();
  commands.addExamples(
      command,
      {{"hunavsim tune nav2_params.yaml --scenarios crossing_agents doorway_agents -o tuned",
        "Tune a parameter file of Nav2 in two scenarios", "your file, some minutes"},
       {"hunavsim tune nav2_params.yaml --scenarios crossing_agents --held-out corner_cafe_agents "
        "--objective intimate_space_intrusions --runs 1000 -o tuned",
        "Reduce only intrusions into the intimate space; evaluate in another scenario",
        "your file, some minutes"},
       {"hunavsim tune crossing_agents --planner pursuit --seeds 1 --runs 60 --held-out-seeds 3 -o "
        "tuned",
        "Tune a planner of this program, with few runs"}});
}

}  // namespace app
