#include "app/studies/Tune.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "app/studies/Tuner.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

/// Whether one score is at least as good as another in all objectives and better in one.
bool dominates(const TuneScore& a, const TuneScore& b) {
  bool isBetter = false;
  for (std::size_t k = 0; k < a.ratios.size(); ++k) {
    if (a.ratios[k] > b.ratios[k]) {
      return false;
    }
    isBetter = isBetter || a.ratios[k] < b.ratios[k];
  }
  return isBetter && a.failures <= b.failures;
}

}  // namespace

base::Result<TuneResult> Tuner::run() {
  base::Diagnostics problems = start();
  problems = problems.empty() ? probe() : problems;
  problems = problems.empty() ? search() : problems;
  problems = problems.empty() ? chooseBest() : problems;
  if (problems.empty() && result_.chosen) {
    problems = measureEffects();
    problems = problems.empty() ? evaluate() : problems;
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  listCandidates();
  return std::move(result_);
}

double Tuner::baseNumber(std::size_t parameter) const {
  return base::parseDouble(base_[parameter])
      .value_or(subject_.parameters()[parameter].presentNumber);
}

TuneRuns Tuner::newRuns(std::size_t count) {
  TuneRuns runs(count);
  std::iota(runs.begin(), runs.end(), nextRun_);
  nextRun_ += count;
  return runs;
}

void Tuner::show(const std::string& stage) const {
  if (showStage_) {
    showStage_(stage, options_.runs + 2 * heldOutRuns());
  }
}

base::Diagnostics Tuner::measure(const std::vector<TunedValues>& which, const TuneRuns& runs) {
  std::vector<RunRequest> requests;
  std::vector<TuneOutcome*> places;
  for (const TunedValues& values : which) {
    for (const std::size_t run : runs) {
      const auto [place, isNew] = outcomes_[values].try_emplace(run);
      if (isNew) {
        const long long seed =
            kSearchSeed + static_cast<long long>(run / options_.scenarios.size());
        requests.push_back(
            subject_.request(options_.scenarios[run % options_.scenarios.size()], seed, values));
        places.push_back(&place->second);
      }
    }
  }
  const base::Result<std::vector<ResultRow>> rows = pool_.run(requests);
  if (!rows) {
    return rows.diagnostics();
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    *places[k] = outcomeOf((*rows)[k], options_.objectives);
  }
  result_.searchRuns += requests.size();
  return {};
}

TuneOutcomes Tuner::outcomesOf(const TunedValues& values, const TuneRuns& runs) const {
  TuneOutcomes outcomes;
  for (const std::size_t run : runs) {
    outcomes.push_back(outcomes_.at(values).at(run));
  }
  return outcomes;
}

TuneRuns Tuner::commonRuns(const TunedValues& a, const TunedValues& b) const {
  const auto& others = outcomes_.at(b);
  TuneRuns runs;
  for (const auto& [run, outcome] : outcomes_.at(a)) {
    if (others.count(run) > 0) {
      runs.push_back(run);
    }
  }
  return runs;
}

TuneScore Tuner::scoreOf(const TunedValues& values, const TuneRuns& runs) const {
  return scoring_->score(outcomesOf(values, runs), outcomesOf(present_, runs));
}

TuneScore Tuner::searchScore(const TunedValues& values, const TuneRuns& runs) const {
  return baseScoring_->score(outcomesOf(values, runs), outcomesOf(base_, runs));
}

void Tuner::setBase(const TunedValues& values) {
  base_ = values;
  TuneOutcomes outcomes;
  for (const auto& [run, outcome] : outcomes_.at(values)) {
    outcomes.push_back(outcome);
  }
  baseScoring_.emplace(options_.objectives, options_.maxLoss, outcomes);
}

base::Diagnostics Tuner::start() {
  show("current values");
  firstRuns_ = newRuns(searchRuns());
  base::Diagnostics problems = measure({present_}, firstRuns_);
  if (problems.empty()) {
    setBase(present_);
    scoring_ = baseScoring_;
    tried_.emplace_back(present_, -1);
  }
  return problems;
}

void Tuner::listCandidates() {
  std::set<TunedValues> listed;
  if (result_.chosen) {
    tried_.emplace_back(*result_.chosen, -1);
  }
  for (const auto& [values, generation] : tried_) {
    const TuneRuns runs = commonRuns(values, present_);
    if (!runs.empty() && listed.insert(values).second) {
      result_.candidates.push_back(
          {values, generation, runs.size(), scoreOf(values, runs), isComplete(values), false});
    }
  }
  std::vector<TuneCandidate>& all = result_.candidates;
  for (TuneCandidate& candidate : all) {
    candidate.isOnFront = candidate.isComplete &&
                          candidate.score.failures <= candidate.score.failuresBefore &&
                          std::none_of(all.begin(), all.end(), [&](const TuneCandidate& other) {
                            return other.isComplete && dominates(other.score, candidate.score);
                          });
  }
}

base::Result<TuneResult> tune(const TuneOptions& options, const TuneSubject& subject, RunPool& pool,
                              const TuneProgress& showStage) {
  return Tuner(options, subject, pool, showStage).run();
}

}  // namespace app
