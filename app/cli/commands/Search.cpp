#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/StudyRuns.h"
#include "app/report/CoveragePage.h"
#include "app/report/SearchPage.h"
#include "app/studies/SearchStudy.h"
#include "app/studies/StudyFolder.h"
#include "metrics/MetricRegistry.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct SearchOptions {
  std::string experiment, output, worst;
  std::vector<std::string> descriptors;
  std::size_t runs = 500, failures = 1, shrinkRuns = 400;
  std::uint64_t seed = 1;
  StudyRunOptions run;
  bool untilFailure = false, covers = false, allContacts = false;
};

/// The metrics that can become worse.
std::vector<std::string> directedMetrics() {
  std::vector<std::string> keys = metrics::standardRegistry().keys();
  keys.erase(std::remove_if(keys.begin(), keys.end(),
                            [](const std::string& key) { return worseDirection(key) == 0; }),
             keys.end());
  return keys;
}

std::string descriptorProblem(const std::string& text) {
  return parseDescriptor(text) ? std::string()
                               : "expected KEY:LOW:HIGH:CELLS with LOW < HIGH, not '" + text + "'";
}

/// Ends the command if the options are wrong.
SearchPlan searchPlanOf(const SearchOptions& options) {
  SearchPlan plan;
  base::Diagnostics problems;
  const int goals =
      (options.worst.empty() ? 0 : 1) + (options.untilFailure ? 1 : 0) + (options.covers ? 1 : 0);
  if (goals != 1) {
    problems.push_back(base::error("search.no-goal"));
  }
  if (!options.worst.empty() && worseDirection(options.worst) == 0) {
    problems.push_back(
        base::error("search.unknown-metric",
                    {options.worst, base::nearestName(options.worst, directedMetrics())}));
  }
  for (std::size_t k = 0; k < options.descriptors.size(); ++k) {
    plan.descriptors[k] = *parseDescriptor(options.descriptors[k]);
    const std::string& key = plan.descriptors[k].key;
    if (metrics::standardRegistry().find(key) == nullptr) {
      problems.push_back(
          base::error("search.unknown-descriptor",
                      {key, base::nearestName(key, metrics::standardRegistry().keys())}));
    }
  }
  requireFine(problems, ExitWrongCommandLine);
  plan.worst = options.worst;
  plan.covers = options.covers;
  plan.runs = options.runs;
  plan.failures = options.failures;
  plan.shrinkRuns = options.shrinkRuns;
  plan.seed = options.seed;
  if (!options.allContacts) {
    plan.countsAgainstRobot = avoidabilityJudge(loadMapImage, wasInterrupted);
  }
  return plan;
}

/// The first run of each scenario, to find what would prevent the search.
std::vector<RunRequest> firstSearchRequests(const Experiment& experiment,
                                            const SearchSpace& space) {
  std::vector<RunRequest> requests;
  Candidate candidate{std::vector<double>(space.dimensions(), 0.5),
                      std::vector<std::size_t>(space.optionCounts().size(), 0)};
  for (std::size_t k = 0; k < experiment.scenarios.size(); ++k) {
    candidate.choices[0] = k;
    requests.push_back(space.requestOf(candidate));
  }
  return requests;
}

std::vector<std::string> searchFileNames(const SearchPlan& plan) {
  std::vector<std::string> names = {"archive.json", "runs.csv", "report.html"};
  if (plan.covers) {
    names.insert(names.end(), {"coverage.csv", kTreeCoverageFile});
  }
  return names;
}

std::vector<base::FileContent> searchFiles(const SearchStudy& study, const SearchOptions& options,
                                           const Invocation& given) {
  if (study.plan.covers) {
    return {{"archive.json", coverageJson(study)},
            {"runs.csv", searchCsv(study)},
            {"coverage.csv", coverageCsv(study)},
            {kTreeCoverageFile, treeCoverageCsv(study.result.coverage.byScenario())},
            {"report.html", report::coveragePage(study, given.argumentsForResults())}};
  }
  std::vector<base::FileContent> files = {
      {"archive.json", searchJson(study)},
      {"runs.csv", searchCsv(study)},
      {"report.html", report::searchPage(study, options.output, given.argumentsForResults())}};
  for (const SavedFailure& failure : study.failures) {
    files.push_back({failure.file, failure.text});
  }
  if (study.worst) {
    files.push_back({study.worst->file, study.worst->text});
  }
  return files;
}

/// Trees, then the nodes that no run has reached.
void printCoverage(const SearchStudy& study, const SearchOptions& options) {
  std::vector<std::vector<std::string>> rows = {
      {"tree", "of", "runs", "nodes", "reached", "unreachable"}};
  std::vector<std::string> never;
  const std::vector<SearchedTree>& trees = study.result.coverage.trees();
  for (std::size_t k = 0; k < trees.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    rows.push_back({number, trees[k].counts.owners, std::to_string(trees[k].counts.runs),
                    std::to_string(trees[k].counts.nodes.size()),
                    std::to_string(trees[k].counts.executedNodes()),
                    std::to_string(trees[k].unreachable())});
    for (std::size_t node = 0; node < trees[k].firstRuns.size(); ++node) {
      if (trees[k].isMissing(node)) {
        never.push_back("never reached, tree " + number + ": " + trees[k].counts.nodes[node].path);
      }
    }
  }
  printTable(rows);
  for (const std::string& line : never) {
    printLine(line);
  }
  printLine(std::to_string(study.result.runs.size()) + " runs, " + std::to_string(never.size()) +
            (never.size() == 1 ? " node" : " nodes") + " never reached; " + options.output +
            "/report.html");
}

void printSearch(const SearchStudy& study, const SearchOptions& options, const Invocation& given) {
  if (given.json) {
    print(study.plan.covers ? coverageJson(study) : searchJson(study));
    return;
  }
  if (given.quiet) {
    return;
  }
  if (study.plan.covers) {
    printCoverage(study, options);
    return;
  }
  std::vector<std::vector<std::string>> rows;
  for (const SavedFailure& failure : study.failures) {
    rows.push_back({failure.file, failure.kind.text(),
                    std::to_string(failure.shrunk.people) + " of " +
                        std::to_string(failure.shrunk.peopleBefore) + " people",
                    "run " + std::to_string(failure.run)});
  }
  if (study.worst) {
    rows.push_back(
        {study.worst->file,
         study.plan.worst + " " + base::formatDouble(study.result.runs[study.worst->run].value), "",
         "run " + std::to_string(study.worst->run)});
  }
  printTable(rows);
  printLine(std::to_string(study.result.runs.size()) + " runs, " +
            std::to_string(study.failures.size()) +
            (study.failures.size() == 1 ? " kind of failure; " : " kinds of failures; ") +
            options.output + "/report.html");
}

/// Files that do not repeat their run, as errors.
base::Diagnostics repetitionProblems(const SearchStudy& study, const std::string& folder) {
  base::Diagnostics problems;
  std::vector<SavedFailure> saved = study.failures;
  if (study.worst) {
    saved.push_back(*study.worst);
  }
  for (const SavedFailure& failure : saved) {
    if (!failure.isRepeated) {
      problems.push_back(base::error("search.not-repeated", {}, folder + "/" + failure.file));
    }
  }
  return problems;
}

int searchCommand(const SearchOptions& options, const Invocation& given) {
  const SearchPlan plan = searchPlanOf(options);
  base::Result<Experiment> experiment = readExperiment(options.experiment);
  requireFine(experiment.diagnostics());
  experiment->allowCode = options.run.allowCode;
  const SearchSpace space(*experiment, plan.covers ? SearchSpace::RunsEnd::AsInScenario
                                                   : SearchSpace::RunsEnd::AtFailures);
  const base::Result<std::unique_ptr<StudyFolder>> folder = StudyFolder::open(
      options.output, searchFileNames(plan), existingStudy(options.run.resume, options.run.force));
  requireFine(folder.diagnostics());
  RunProgress progress(given.quiet || given.json, options.runs, true);
  const std::unique_ptr<RunPool> pool =
      openStudyPool(options.run, (*folder)->journal(), progress, plan.covers);
  requireFine(pool->check(firstSearchRequests(*experiment, space)));
  catchInterrupts();
  SearchStudyOptions study;
  study.plan = plan;
  study.folder = options.output;
  study.loader = loadMapImage;
  study.showPhase = [&progress](const std::string& phase) { progress.setStage(phase); };
  const base::Result<SearchStudy> made = runSearchStudy(
      *experiment, space, study,
      [&pool](const std::vector<RunRequest>& requests) { return pool->run(requests); });
  progress.clear();
  requireFine(made.diagnostics(), wasInterrupted() ? ExitRunFailed : ExitBadInput);
  requireFine((*folder)->finish(searchFiles(*made, options, given), "search"));
  printSearch(*made, options, given);
  if (plan.covers && made->result.coverage.trees().empty()) {
    printDiagnostics({base::warning("search.no-trees", {}, options.experiment)});
  }
  const base::Diagnostics problems = repetitionProblems(*made, options.output);
  printDiagnostics(problems);
  return problems.empty() ? ExitFine : ExitRunFailed;
}

/// Adds the options of which one is required. Result: --cover.
CLI::Option* addSearchGoals(CLI::App& command, SearchOptions& options) {
  CLI::Option* const worst = command.add_option(
      "--worst", options.worst, "Find the worst value of this metric (hunavsim list metrics)");
  CLI::Option* const untilFailure =
      command
          .add_flag(
              "--until-failure", options.untilFailure,
              "Find failures of the robot; stop at the first one, or when --failures are found")
          ->excludes(worst);
  return command
      .add_flag("--cover", options.covers,
                "Find runs that reach nodes of people's and Nav2's behaviour trees which no "
                "other run has reached; stop when all reachable nodes are covered")
      ->excludes(worst)
      ->excludes(untilFailure);
}

}  // namespace

void addSearch(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "search",
      "Find runs in which a robot fails, or which reach unreached nodes of behaviour trees",
      searchCommand);
  command.add_option("experiment", options.experiment, "Experiment file; its values are varied")
      ->required();
  CLI::Option* const cover = addSearchGoals(command, options);
  command.add_option("--runs", options.runs, "Largest number of runs (default: 500)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000'000}));
  command
      .add_option("--failures", options.failures,
                  "With --until-failure: number of failures that differ in kind (default: 1)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000}));
  command
      .add_option("--shrink-runs", options.shrinkRuns,
                  "Largest number of runs to shrink one failure (default: 400)")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1'000'000}));
  command
      .add_option("--descriptor", options.descriptors,
                  "KEY:LOW:HIGH:CELLS: keep the best run in each cell over two metrics; give two "
                  "(default: final_bearing_to_person in 8 sectors and final_people_near)")
      ->expected(2)
      ->check(descriptorProblem)
      ->excludes(cover);
  command.add_option("--search-seed", options.seed, "Seed of the search itself (default: 1)")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--all-contacts", options.allContacts,
                   "Also count contacts that the robot could not have avoided after it first "
                   "detected the person");
  addStudyRunOptions(command, options.run, "search");
  addOutputFolder(command, options.output, "Output folder").required();
  commands.addExamples(
      command, {{"hunavsim search study.yaml --until-failure -o found",
                 "Search for a failure and shrink it to a small scenario", "your experiment"},
                {"hunavsim search study.yaml --until-failure --failures 5 --runs 2000 -o found",
                 "Collect five kinds of failures", "your experiment"},
                {"hunavsim search study.yaml --worst minimum_distance_to_people -o worst",
                 "Find the run in which the robot comes closest to a person", "your experiment"},
                {"hunavsim search study.yaml --cover -o covered",
                 "Reach as many nodes of the behaviour trees as possible", "your experiment"}});
}

}  // namespace app
