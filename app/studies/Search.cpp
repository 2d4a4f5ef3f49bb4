#include "app/studies/Search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kEarly = 30.0;  // [s] failures at this time have half of the bonus
constexpr double kUndefinedFitness = -std::numeric_limits<double>::infinity();

class Searcher {
 public:
  Searcher(const SearchSpace& space, const SearchPlan& plan, const RunMany& run)
      : space_(space),
        plan_(plan),
        run_(run),
        emitters_(space, plan.seed),
        result_(plan.descriptors) {}

  base::Result<SearchResult> run() {
    base::Diagnostics problems = take(emitters_.first(firstCount(), plan_.covers), false);
    while (!base::hasErrors(problems) && !isOver()) {
      std::vector<Candidate> batch =
          emitters_.next(plan_.covers ? result_.coveringRuns() : result_.archive.runs(), rated_);
      if (batch.empty()) {
        break;  // everything has run
      }
      const std::size_t left = plan_.runs - result_.runs.size();
      const bool isComplete = batch.size() <= left;
      batch.resize(std::min(batch.size(), left));
      problems = take(batch, isComplete);
    }
    if (base::hasErrors(problems)) {
      return problems;
    }
    return std::move(result_);
  }

 private:
  /// A quarter of the runs at most, ten per dimension if that is less; as many as the largest
  /// category has options if they must all occur.
  std::size_t firstCount() const {
    const std::size_t wanted = std::min(10 * (space_.dimensions() + 1), plan_.runs / 4 + 1);
    const std::vector<std::size_t>& options = space_.optionCounts();
    const std::size_t most = *std::max_element(options.begin(), options.end());
    return std::min(plan_.covers ? std::max(wanted, most) : wanted, plan_.runs);
  }

  bool hasAllFailures() const {
    return plan_.worst.empty() && !plan_.covers && result_.failures.size() >= plan_.failures;
  }
  bool isOver() const {
    return result_.runs.size() >= plan_.runs || hasAllFailures() || result_.coverage.isComplete();
  }

  base::Diagnostics take(const std::vector<Candidate>& batch, bool tellsEmitters) {
    std::vector<RunRequest> requests;
    std::transform(batch.begin(), batch.end(), std::back_inserter(requests),
                   [this](const Candidate& each) {
                     RunRequest request = space_.requestOf(each);
                     request.spec.metrics = searchedMetrics(plan_);
                     return request;
                   });
    const base::Result<std::vector<ResultRow>> rows = run_(requests);
    if (!rows) {
      return rows.diagnostics();
    }
    const std::size_t first = result_.runs.size();
    for (std::size_t k = 0; k < batch.size(); ++k) {
      base::Diagnostics problems = add(batch[k], requests[k], (*rows)[k]);
      if (base::hasErrors(problems)) {
        return problems;
      }
    }
    rateByCoverage();
    std::vector<double> fitness;
    std::vector<std::optional<EliteArchive::Change>> changes;
    for (std::size_t run = first; run < result_.runs.size(); ++run) {
      fitness.push_back(rated_[run].fitness);
      changes.push_back(plan_.covers ? coverageChange(run) : addToArchive(run));
    }
    if (tellsEmitters) {
      emitters_.tell(fitness, changes);
    }
    return {};
  }

  base::Diagnostics add(const Candidate& candidate, const RunRequest& request,
                        const ResultRow& row) {
    SearchedRun run;
    run.candidate = candidate;
    run.wasSimulated = wasSimulated(row);
    run.reason = row.reason;
    run.simulated = row.simulated;
    run.value = plan_.worst.empty() ? std::numeric_limits<double>::quiet_NaN()
                                    : fieldNumber(row, plan_.worst);
    run.fitness = fitnessOf(row, plan_);
    run.kind = failureKindOf(row);
    for (std::size_t k = 0; k < run.descriptors.size(); ++k) {
      run.descriptors[k] = fieldNumber(row, plan_.descriptors[k].key);
    }
    if (!run.wasSimulated && ++result_.notSimulated == 1) {
      result_.firstProblem = row.reason;
    }
    const std::size_t number = result_.runs.size();
    if (plan_.covers) {
      const std::string& scenario = space_.scenarioName(candidate);
      run.newNodes = result_.coverage.add(number, scenario, row.trees);
    }
    if (!plan_.worst.empty() && std::isfinite(run.fitness) &&
        (!result_.worst || run.fitness > result_.runs[result_.worst->run].fitness)) {
      result_.worst = FoundFailure{number, run.kind.value_or(FailureKind()), request, row};
    }
    base::Diagnostics problems;
    if (run.kind && isWanted(*run.kind)) {
      problems = addFailure({number, *run.kind, request, row}, run);
    }
    rated_.push_back({candidate, run.fitness});
    result_.runs.push_back(std::move(run));
    return problems;
  }

  bool isWanted(const FailureKind& kind) const {
    return !plan_.covers && !hasAllFailures() &&
           std::none_of(result_.failures.begin(), result_.failures.end(),
                        [&](const FoundFailure& found) { return found.kind == kind; });
  }

  base::Diagnostics addFailure(FoundFailure failure, SearchedRun& run) {
    const base::Result<bool> counts =
        countsAsFailure(failure.kind, failure.request, plan_.countsAgainstRobot);
    if (!counts) {
      return counts.diagnostics();
    }
    run.isUnavoidable = !*counts;
    if (*counts) {
      result_.failures.push_back(std::move(failure));
    }
    return {};
  }

  /// The nodes of a run become less rare with each later run that executes them.
  void rateByCoverage() {
    if (!plan_.covers) {
      return;
    }
    const std::vector<double> rarities = result_.coverage.rarities();
    for (std::size_t k = 0; k < result_.runs.size(); ++k) {
      SearchedRun& run = result_.runs[k];
      run.fitness = kUndefinedFitness;
      if (run.wasSimulated) {
        run.fitness = rarities[k];
      }
      rated_[k].fitness = run.fitness;
    }
  }

  std::optional<EliteArchive::Change> coverageChange(std::size_t number) const {
    const std::size_t found = result_.runs[number].newNodes;
    return found > 0 ? std::optional(EliteArchive::Change{true, static_cast<double>(found)})
                     : std::nullopt;
  }

  std::optional<EliteArchive::Change> addToArchive(std::size_t number) {
    const SearchedRun& run = result_.runs[number];
    if (!run.wasSimulated || std::isinf(run.fitness)) {
      return std::nullopt;
    }
    return result_.archive.add({number, run.fitness, run.descriptors});
  }

  const SearchSpace& space_;
  const SearchPlan& plan_;
  const RunMany& run_;
  SearchEmitters emitters_;
  SearchResult result_;
  std::vector<RatedCandidate> rated_;
};

}  // namespace

std::array<Descriptor, 2> SearchPlan::defaultDescriptors() {
  return {Descriptor{"final_bearing_to_person", -base::kPi, base::kPi, 8},
          Descriptor{"final_people_near", 0.0, 8.0, 8}};
}

std::vector<std::size_t> SearchResult::coveringRuns() const {
  std::vector<std::size_t> covering;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].newNodes > 0) {
      covering.push_back(k);
    }
  }
  return covering;
}

int worseDirection(const std::string& metric) {
  for (const EndColumn& column : endColumns()) {
    if (metric == column.key) {
      return -column.sense;
    }
  }
  const metrics::MetricEntry* const entry = metrics::standardRegistry().find(metric);
  if (entry == nullptr || entry->info.better == metrics::Better::Neutral) {
    return 0;
  }
  return entry->info.better == metrics::Better::Lower ? 1 : -1;
}

std::string searchedMetrics(const SearchPlan& plan) {
  std::vector<std::string> keys = {"success",
                                   "completed",
                                   "total_time",
                                   "time_not_moving",
                                   "minimum_distance_to_people",
                                   "robot_on_person_collision",
                                   "person_on_robot_collision",
                                   "obstacle_collisions",
                                   "final_bearing_to_person",
                                   "final_distance_to_person",
                                   "final_person_speed",
                                   "final_people_near"};
  for (const std::string& key : {plan.worst, plan.descriptors[0].key, plan.descriptors[1].key}) {
    const bool isMetric = metrics::standardRegistry().find(key) != nullptr;  // or a column
    if (isMetric && std::find(keys.begin(), keys.end(), key) == keys.end()) {
      keys.push_back(key);
    }
  }
  return base::join(keys, ",");
}

double fitnessOf(const ResultRow& row, const SearchPlan& plan) {
  if (!wasSimulated(row)) {
    return kUndefinedFitness;
  }
  if (!plan.worst.empty()) {
    const double value = fieldNumber(row, plan.worst) * worseDirection(plan.worst);
    if (std::isnan(value)) {
      return kUndefinedFitness;
    }
    return value;
  }
  if (failureKindOf(row)) {
    const double end = base::parseDouble(row.simulated).value_or(0.0);
    return 1.0 + 1.0 / (1.0 + end / kEarly);
  }
  const double gap = fieldNumber(row, "minimum_distance_to_people");
  const double standing = fieldNumber(row, "time_not_moving") / fieldNumber(row, "total_time");
  const double near = std::isfinite(gap) ? 1.0 / (1.0 + std::max(gap, 0.0)) : 0.0;
  return std::max(near, std::isfinite(standing) ? std::min(standing, 1.0) : 0.0);
}

base::Result<SearchResult> search(const SearchSpace& space, const SearchPlan& plan,
                                  const RunMany& run) {
  return Searcher(space, plan, run).run();
}

}  // namespace app
