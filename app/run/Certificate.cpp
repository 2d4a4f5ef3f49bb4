#include "app/run/Certificate.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "app/run/Batch.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "metrics/MetricRegistry.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/Runner.h"

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr double kLongestObservation = 120.0;  // [s] of a run without robots
constexpr std::size_t kObservedSeeds = 3;
constexpr double kLeastSeparation = 0.01;  // between intervals, relative to the larger mean

std::string nameOf(const std::string& path) {
  return fs::path(path).stem().string();
}

/// The scenario without its robots.
std::shared_ptr<const sim2d::Scenario> withoutRobots(const sim2d::Scenario& scenario) {
  auto people = std::make_shared<sim2d::Scenario>(scenario);
  for (sim2d::Robot& robot : people->robots) {
    robot.listed = false;
  }
  return people;
}

/// What happens in one run without robots.
base::Result<std::vector<ExpectationOutcome>> observe(Bundle bundle) {
  bundle.scenario = withoutRobots(*bundle.scenario);
  const Verdict verdict = check(bundle);
  if (!verdict.ok()) {
    return errorsOf(verdict.problems);
  }
  sim2d::World& world = *verdict.world;
  ExpectationMonitor monitor(*bundle.scenario);
  const double end = std::min(monitor.horizon(), kLongestObservation);
  monitor.add(world.frame());
  while (!monitor.isDecided() && world.frame().time < end && world.step()) {
    monitor.add(world.frame());
  }
  return monitor.outcomes();
}

/// Warnings and errors of loading, with those of creating the world.
std::vector<std::string> loadingProblems(const Bundle& bundle) {
  const Verdict verdict = check(bundle);
  base::Diagnostics all = verdict.problems;
  base::append(all, verdict.wrongOptions);
  base::append(all, verdict.worldRemarks);
  std::vector<std::string> texts;
  for (base::Diagnostic& problem : all) {
    if (problem.severity != base::Severity::Info) {
      problem.file = problem.file.empty() ? "" : fs::path(problem.file).filename().string();
      texts.push_back(problem.text());
    }
  }
  return texts;
}

/// The part that needs no planner: loading, and runs without robots.
Certificate certifyPeople(const std::string& path, const CertificationPlan& plan) {
  Certificate made;
  made.scenario = nameOf(path);
  made.seeds = plan.seeds;
  RunSpec spec;
  spec.scenario = path;
  const Bundle first = readBundle(spec, {}, plan.loader);
  for (const std::string& input : first.inputs) {
    made.inputs.push_back({fs::path(input).filename().string(), sha256OfFile(input).value_or("")});
  }
  made.problems = loadingProblems(first);
  if (first.scenario->robots.empty()) {
    made.problems.emplace_back("the scenario has no robot");
  }
  if (first.scenario->desktop.card.metrics.empty()) {
    made.problems.emplace_back("the card names no metric");
  }
  const std::size_t count = std::min(kObservedSeeds, plan.seeds.size());
  for (std::size_t k = 0; k < count && !first.scenario->desktop.card.expect.empty(); ++k) {
    spec.seed = plan.seeds[k];
    const base::Result<std::vector<ExpectationOutcome>> outcomes =
        observe(readBundle(spec, {}, plan.loader));
    if (!outcomes) {
      made.problems.push_back(outcomes.diagnostics().front().text());
      break;
    }
    for (const ExpectationOutcome& outcome : *outcomes) {
      if (!outcome.holds) {
        made.problems.push_back("seed " + std::to_string(plan.seeds[k]) +
                                ": expected, but not so: " + outcome.text);
      }
    }
    if (k == 0) {
      made.expectations = *outcomes;
    }
  }
  return made;
}

/// Numbers of runs: scenarios outermost, then arms, seeds innermost.
struct RunNumbers {
  std::size_t arms = 1, seeds = 1;

  std::size_t scenario(std::size_t run) const { return run / (arms * seeds); }
  std::size_t arm(std::size_t run) const { return run / seeds % arms; }
  std::size_t seed(std::size_t run) const { return run % seeds; }
  std::size_t of(std::size_t scenario, std::size_t arm, std::size_t seed) const {
    return (scenario * arms + arm) * seeds + seed;
  }
};

/// The experiment of one planner in all scenarios.
Experiment experimentOf(const std::vector<std::string>& paths, const std::string& planner,
                        const CertificationPlan& plan) {
  Experiment experiment;
  experiment.path = "certification";
  experiment.scenarios = experiment.scenarioPaths = paths;
  experiment.seeds = plan.seeds;
  experiment.common.planner = planner;
  return experiment;
}

CertifiedArm armOf(const std::string& planner, const std::string& key,
                   const std::vector<const ResultRow*>& rows) {
  statistics::Numbers values;
  for (const ResultRow* row : rows) {
    if (const auto value = numberOf(*row, key); value && std::isfinite(*value)) {
      values.push_back(*value);
    }
  }
  CertifiedArm arm;
  arm.planner = planner;
  arm.runs = static_cast<int>(values.size());
  arm.mean = statistics::mean(values);
  const auto successes = static_cast<int>(std::count(values.begin(), values.end(), 1.0));
  arm.interval = isSuccessKey(key) ? statistics::wilsonInterval(successes, arm.runs)
                                   : statistics::meanInterval(values);
  return arm;
}

/// The two arms with the widest gap between their intervals. Arms with a value in less than half of
/// the runs do not count, nor do gaps below 1 % of the larger mean: where the seed has no effect,
/// intervals have no width.
std::optional<std::pair<std::string, std::string>> separatedArms(
    const std::vector<CertifiedArm>& arms, std::size_t seeds) {
  std::optional<std::pair<std::string, std::string>> found;
  double widest = 0.0;
  const auto counts = [seeds](const CertifiedArm& arm) {
    return arm.interval.isDefined() && 2 * static_cast<std::size_t>(arm.runs) >= seeds;
  };
  for (const CertifiedArm& low : arms) {
    for (const CertifiedArm& high : arms) {
      const double gap = high.interval.low - low.interval.high;
      const double least = kLeastSeparation * std::max(std::fabs(low.mean), std::fabs(high.mean));
      if (counts(low) && counts(high) && gap > std::max(widest, least)) {
        widest = gap;
        found = {low.planner, high.planner};
      }
    }
  }
  return found;
}

/// Whether one of the planners is better than the baseline, with disjoint intervals.
bool isBaselineWorse(const CertifiedMetric& metric) {
  const metrics::MetricEntry* const entry = metrics::standardRegistry().find(metric.key);
  if (entry == nullptr || !metric.baseline.interval.isDefined()) {
    return false;
  }
  const statistics::Interval& of = metric.baseline.interval;
  return std::any_of(metric.arms.begin(), metric.arms.end(), [&](const CertifiedArm& arm) {
    return arm.interval.isDefined() &&
           ((entry->info.better == metrics::Better::Higher && arm.interval.low > of.high) ||
            (entry->info.better == metrics::Better::Lower && arm.interval.high < of.low));
  });
}

/// Adds what the runs with planners prove. `rows`: per planner, the baseline last.
void addPlanners(Certificate& to, const std::vector<std::string>& metrics,
                 const std::vector<std::string>& arms,
                 const std::vector<std::vector<const ResultRow*>>& rows) {
  const auto seeds = static_cast<int>(to.seeds.size());
  bool isSolved = false, isSolvedByBaseline = false;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const auto solved =
        static_cast<int>(std::count_if(rows[k].begin(), rows[k].end(),
                                       [](const ResultRow* row) { return !isUnsuccessful(*row); }));
    to.successes.emplace_back(arms[k], solved);
    const bool isBaseline = k + 1 == arms.size();
    isSolved = isSolved || (!isBaseline && 2 * solved >= seeds);
    isSolvedByBaseline = isBaseline && solved == seeds;
  }
  if (!isSolved) {
    to.problems.emplace_back("no planner solves the scenario with at least half of the seeds");
  }
  for (const std::string& key : metrics) {
    CertifiedMetric metric;
    metric.key = key;
    for (std::size_t k = 0; k + 1 < arms.size(); ++k) {
      metric.arms.push_back(armOf(arms[k], key, rows[k]));
    }
    metric.baseline = armOf(arms.back(), key, rows.back());
    metric.separated = separatedArms(metric.arms, to.seeds.size());
    isSolvedByBaseline = isSolvedByBaseline && !isBaselineWorse(metric);
    to.metrics.push_back(std::move(metric));
  }
  if (isSolvedByBaseline) {
    to.problems.emplace_back(
        "trivial: a robot that drives straight on solves the scenario with all seeds, and no "
        "planner is better in any metric of the card");
  }
}

std::vector<std::string> metricsOfCard(const std::string& path) {
  return sim2d::readScenario(path).scenario.desktop.card.metrics;
}

/// All runs with planners. Error: they could not be executed, or a stop was requested.
base::Result<std::vector<ResultRow>> runPlanners(const std::vector<std::string>& paths,
                                                 const std::vector<std::string>& arms,
                                                 const CertificationPlan& plan) {
  const RunNumbers numbers{arms.size(), plan.seeds.size()};
  std::vector<std::unique_ptr<Experiment>> experiments;
  std::vector<std::unique_ptr<ExperimentRunner>> runners;
  for (const std::string& arm : arms) {
    experiments.push_back(std::make_unique<Experiment>(experimentOf(paths, arm, plan)));
    runners.push_back(std::make_unique<ExperimentRunner>(*experiments.back(), "", plan.loader));
  }
  std::vector<ResultRow> rows(paths.size() * arms.size() * plan.seeds.size());
  std::size_t finished = 0;
  BatchJob job;
  for (std::size_t run = 0; run < rows.size(); ++run) {
    job.runs.push_back(run);
  }
  job.jobs = plan.jobs;
  job.execute = [&](std::size_t run, const BatchJob::ReportInputs& reportInputs) {
    const std::size_t index = numbers.scenario(run) * plan.seeds.size() + numbers.seed(run);
    return runners[numbers.arm(run)]->run(index, reportInputs);
  };
  job.storeRow = [&](std::size_t run, const ResultRow& row) {
    rows[run] = row;
    plan.showProgress(++finished, rows.size());
    return base::Diagnostics();
  };
  job.wantsStop = plan.wantsStop;
  base::Diagnostics problems = runBatch(job);
  if (!base::hasErrors(problems) && finished < rows.size()) {
    problems.push_back(base::error("certificate.stopped", {finished, rows.size()}));
  }
  return base::resultOf(std::move(rows), std::move(problems));
}

}  // namespace

std::string certificatePath(const std::string& scenarioPath) {
  return (fs::path(scenarioPath).parent_path() / (nameOf(scenarioPath) + ".certificate.json"))
      .string();
}

base::Result<std::vector<Certificate>> certify(const std::vector<std::string>& scenarioPaths,
                                               const CertificationPlan& plan) {
  std::vector<std::string> arms = plan.planners;
  arms.emplace_back(kBaselinePlanner);
  const base::Result<std::vector<ResultRow>> rows = runPlanners(scenarioPaths, arms, plan);
  if (!rows) {
    return rows.diagnostics();
  }
  const RunNumbers numbers{arms.size(), plan.seeds.size()};
  std::vector<Certificate> certificates;
  for (std::size_t k = 0; k < scenarioPaths.size(); ++k) {
    if (plan.wantsStop()) {
      return base::error("certificate.stopped", {k, scenarioPaths.size()});
    }
    Certificate made = certifyPeople(scenarioPaths[k], plan);
    std::vector<std::vector<const ResultRow*>> ofArms(arms.size());
    for (std::size_t arm = 0; arm < arms.size(); ++arm) {
      for (std::size_t seed = 0; seed < plan.seeds.size(); ++seed) {
        ofArms[arm].push_back(&(*rows)[numbers.of(k, arm, seed)]);
      }
    }
    addPlanners(made, metricsOfCard(scenarioPaths[k]), arms, ofArms);
    certificates.push_back(std::move(made));
  }
  return certificates;
}

}  // namespace app
