#include "app/studies/SearchSpace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

using ValueKind = ExperimentValue::Kind;

constexpr std::size_t kMostCombinations = 1'000'000'000;
constexpr double kStuckAfter = 20.0;       // [s]
constexpr std::size_t kFirstCategory = 2;  // after scenarios and seeds

bool isContinuous(const ExperimentValue& value) {
  return value.kind == ValueKind::Between || value.kind == ValueKind::Normal ||
         value.kind == ValueKind::Uniform || (value.isRange && value.texts.size() > 1);
}

/// Rounded to a ten-thousandth of the power of ten at or below the range.
double rounded(double value, double range) {
  const int decimals = 4 - static_cast<int>(std::floor(std::log10(range)));
  if (decimals < 0) {
    return value;
  }
  const double scale = std::pow(10.0, std::min(decimals, 15));
  return std::round(value * scale) / scale;
}

}  // namespace

double SearchRandom::uniform() {
  return base::AgentRng(seed_, 0, drawn_++).uniform01(base::DrawPurpose::Search);
}

std::size_t SearchRandom::below(std::size_t count) {
  const auto index = static_cast<std::size_t>(uniform() * static_cast<double>(count));
  return std::min(index, count - 1);
}

SearchSpace::SearchSpace(const Experiment& experiment, RunsEnd runsEnd)
    : experiment_(experiment),
      runsEnd_(runsEnd),
      optionCounts_{experiment.scenarios.size(), experiment.seeds.size()} {
  for (std::size_t k = 0; k < experiment.values.size(); ++k) {
    if (isContinuous(experiment.values[k])) {
      continuous_.push_back(k);
    } else {
      categories_.push_back(k);
      optionCounts_.push_back(experiment.values[k].texts.size());
    }
  }
  for (const std::string& path : experiment.scenarioPaths) {  // problems are reported by the runs
    setsStuckAfter_.push_back(sim2d::readScenario(path).scenario.desktop.stuckAfter.has_value());
  }
}

std::size_t SearchSpace::combinations() const {
  std::size_t count = 1;
  for (const std::size_t options : optionCounts_) {
    count = options > kMostCombinations / count ? kMostCombinations : count * options;
  }
  return count;
}

std::string SearchSpace::textOf(const ExperimentValue& value, double place) const {
  if (value.kind == ValueKind::Grid) {  // the steps of a range
    const auto steps = static_cast<double>(value.texts.size());
    const double step = std::clamp(std::floor(place * steps), 0.0, steps - 1.0);
    return value.texts[static_cast<std::size_t>(step)];
  }
  const bool isNormal = value.kind == ValueKind::Normal;
  const double low = value.numbers[isNormal ? 2 : 0], high = value.numbers[isNormal ? 3 : 1];
  const double exact = low + place * (high - low);
  return base::formatDouble(std::clamp(rounded(exact, high - low), low, high));
}

std::vector<std::string> SearchSpace::textsOf(const Candidate& candidate) const {
  std::vector<std::string> texts(experiment_.values.size());
  for (std::size_t k = 0; k < continuous_.size(); ++k) {
    texts[continuous_[k]] = textOf(experiment_.values[continuous_[k]], candidate.point[k]);
  }
  for (std::size_t k = 0; k < categories_.size(); ++k) {
    const ExperimentValue& value = experiment_.values[categories_[k]];
    texts[categories_[k]] = value.texts[candidate.choices[kFirstCategory + k]];
  }
  return texts;
}

long long SearchSpace::seedOf(const Candidate& candidate) const {
  return experiment_.seeds[candidate.choices[1]];
}

RunRequest SearchSpace::requestOf(const Candidate& candidate) const {
  RunRequest request;
  request.scenario = experiment_.scenarioPaths[scenarioOf(candidate)];
  request.seed = seedOf(candidate);
  request.spec = experiment_.common;
  request.spec.allowCode = experiment_.allowCode;
  const bool endsEarly = runsEnd_ == RunsEnd::AtFailures;
  if (endsEarly && !request.spec.stopOnCollision) {
    request.spec.stopOnCollision = "any";
  }
  if (endsEarly && !request.spec.stuckAfter && !setsStuckAfter_[scenarioOf(candidate)]) {
    request.spec.stuckAfter = kStuckAfter;
  }
  const std::vector<std::string> texts = textsOf(candidate);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    request.spec.set.push_back(experiment_.values[k].path + "=" + texts[k]);
  }
  return request;
}

std::vector<std::size_t> SearchSpace::randomChoices(SearchRandom& random) const {
  std::vector<std::size_t> choices;
  for (const std::size_t options : optionCounts_) {
    choices.push_back(random.below(options));
  }
  return choices;
}

std::vector<std::vector<std::size_t>> SearchSpace::balancedChoices(std::size_t count,
                                                                   SearchRandom& random) const {
  std::vector<std::vector<std::size_t>> all(count);
  for (const std::size_t options : optionCounts_) {
    std::vector<std::size_t> left;  // of the current permutation
    for (std::vector<std::size_t>& choices : all) {
      if (left.empty()) {
        left.resize(options);
        std::iota(left.begin(), left.end(), std::size_t{0});
      }
      const std::size_t which = random.below(left.size());
      choices.push_back(left[which]);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(which));
    }
  }
  return all;
}

void SearchSpace::mutate(std::vector<std::size_t>& choices, SearchRandom& random) const {
  std::vector<std::size_t> several;
  for (std::size_t k = 0; k < optionCounts_.size(); ++k) {
    if (optionCounts_[k] > 1) {
      several.push_back(k);
    }
  }
  if (several.empty()) {
    return;
  }
  const std::size_t which = several[random.below(several.size())];
  const std::size_t other = random.below(optionCounts_[which] - 1);
  choices[which] = other >= choices[which] ? other + 1 : other;
}

}  // namespace app
