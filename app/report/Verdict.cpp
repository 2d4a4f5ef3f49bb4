#include "app/report/Verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

#include "app/report/Tables.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

/// The names of the options with this standing, without the leaders.
std::vector<std::string> namesOf(const Study& study, const MetricComparison& comparison,
                                 RelativeToBest standing) {
  std::vector<std::string> names;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (!comparison.isBestOrTied(option) && comparison.relativeToBest[option] == standing) {
      names.push_back(study.options[option]);
    }
  }
  return names;
}

std::string namesText(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNames = 6;
  return names.size() > kMostNames ? std::to_string(names.size()) + " others"
                                   : escaped(base::join(names, ", "));
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words) {
  if (words.size() < 2) {
    return base::join(words, "");
  }
  const std::vector<std::string> first(words.begin(), words.end() - 1);
  return base::join(first, ", ") + " and " + words.back();
}

std::string bold(const std::string& name) {
  return element("b", "", escaped(name));
}

/// The difference of a pair as a positive number: "by 1.24 s (95 % CI 0.91 to 1.53)"; empty if it
/// is 0 or undefined.
std::string amountText(const Study& study, const Metric& metric, const PairTest& pair) {
  if (std::isnan(pair.shift) || pair.shift == 0.0) {
    return {};
  }
  const double scale = (metric.isRate ? 100.0 : 1.0) * (pair.shift < 0.0 ? -1.0 : 1.0);
  Interval interval{scale * pair.shiftInterval.low, scale * pair.shiftInterval.high};
  if (scale < 0.0) {
    std::swap(interval.low, interval.high);
  }
  const double size = scale * pair.shift;
  const int decimals = metric.isRate ? 0 : decimalsFor(size, interval);
  const bool isShare = metric.isRate || metric.unit == "%";
  const std::string unit = isShare                                     ? " percentage points"
                           : metric.unit.empty() || metric.unit == "-" ? ""
                                                                       : " " + metric.unit;
  std::string text = " by " + numberText(size, decimals) + unit;
  if (interval.isDefined()) {
    text += " (" + levelText(study.level) + " CI " + numberText(interval.low, decimals) + " to " +
            numberText(interval.high, decimals) + ")";
  }
  return text;
}

/// The results of one metric for the verdict.
struct Outcome {
  const MetricComparison* comparison = nullptr;
  std::size_t better = 0;                // option; only if `worse` is not empty
  std::vector<const PairResult*> worse;  // significant pairs of it, the smallest difference first
  bool isUnclear = false;                // the best mean is significantly worse in pairs
  int rank = 0;                          // of the metric: importanceOf()
  double size = 0.0;                     // largest difference, as a share of the larger mean
  bool isWin() const { return !worse.empty() && !isUnclear; }
  /// Significant, but hardly relevant. Success and contacts always matter.
  bool isSmall() const { return rank > kContactRank && size < kSmallShare; }

  static constexpr int kContactRank = 1;
  static constexpr double kSmallShare = 0.02;
};

bool isSuccess(const Metric& metric) {
  return metric.isRate && metric.sense > 0;
}

/// The place of a metric in the verdict: success, contacts, time to the goal, all others.
int importanceOf(const Metric& metric) {
  constexpr std::string_view kContacts[] = {"robot_on_person_collision",
                                            "person_on_robot_collision", "obstacle_collisions",
                                            "ended_by_contact"};
  const std::string own = metric.key.substr(metric.key.rfind('.') + 1);  // of any robot
  if (isSuccess(metric)) {
    return 0;
  }
  if (std::find(std::begin(kContacts), std::end(kContacts), own) != std::end(kContacts)) {
    return Outcome::kContactRank;
  }
  return Outcome::kContactRank + (own == "time_to_reach_goal" ? 1 : 2);
}

/// The mean difference of a pair as a share of the larger of both means.
double relativeSizeOf(const MetricComparison& comparison, const PairResult& pair) {
  const double larger = std::max(std::abs(comparison.estimates[pair.first].mean),
                                 std::abs(comparison.estimates[pair.second].mean));
  return larger > 0.0 ? std::abs(statistics::mean(pair.differences)) / larger : 0.0;
}

/// The option that is better in a significant pair; nothing: no difference could be shown.
std::optional<std::size_t> betterOf(const Metric& metric, const PairResult& pair) {
  if (!(pair.adjusted < kSignificance)) {
    return std::nullopt;
  }
  const double towards =
      pair.shift != 0.0 ? pair.shift : static_cast<double>(pair.higher - pair.lower);
  return towards * metric.sense > 0.0 ? pair.first : pair.second;
}

/// Whether the tests of a pair count: options that never succeed are only compared by success.
bool isRanked(const Metric& metric, const MetricComparison& comparison, const PairResult& pair) {
  return isSuccess(metric) || (comparison.succeeds[pair.first] && comparison.succeeds[pair.second]);
}

/// The significant pairs of an option.
void addPairs(const Metric& metric, std::size_t option, Outcome& outcome) {
  for (const PairResult& pair : outcome.comparison->pairs) {
    const bool isOfOption = pair.first == option || pair.second == option;
    const auto better = isOfOption && isRanked(metric, *outcome.comparison, pair)
                            ? betterOf(metric, pair)
                            : std::nullopt;
    if (better == option) {
      outcome.better = option;
      outcome.worse.push_back(&pair);
    } else if (better) {
      outcome.isUnclear = true;
    }
  }
}

/// Of two options, the better one; of several, the one with the best mean.
Outcome outcomeOf(const Study& study, const MetricComparison& comparison) {
  const Metric& metric = study.metrics[comparison.metric];
  Outcome outcome;
  outcome.comparison = &comparison;
  if (study.options.size() == 2) {
    addPairs(metric, 0, outcome);
    addPairs(metric, 1, outcome);
    outcome.isUnclear = false;
  } else if (comparison.best) {
    addPairs(metric, *comparison.best, outcome);
  }
  std::stable_sort(outcome.worse.begin(), outcome.worse.end(),
                   [](const PairResult* a, const PairResult* b) {
                     return std::abs(a->shift) < std::abs(b->shift);
                   });
  outcome.rank = importanceOf(metric);
  for (const PairResult* const pair : outcome.worse) {
    outcome.size = std::max(outcome.size, relativeSizeOf(comparison, *pair));
  }
  return outcome;
}

/// What matters most comes first: by metric, then by the size of the difference.
bool isMoreImportant(const Outcome& a, const Outcome& b) {
  return a.rank != b.rank ? a.rank < b.rank : a.rank > Outcome::kContactRank && a.size > b.size;
}

/// "Path length by 1.24 m (95 % CI 0.91 to 1.53)"; with several options also the one it is compared
/// with.
std::string winMarkup(const Study& study, const Outcome& outcome) {
  const Metric& metric = study.metrics[outcome.comparison->metric];
  const PairResult& nearest = *outcome.worse.front();
  std::string text = escaped(metric.name);
  if (study.options.size() > 2) {
    const std::size_t other = nearest.first == outcome.better ? nearest.second : nearest.first;
    text += ", better than " + escaped(study.options[other]);
  }
  text += escaped(amountText(study, metric, nearest));
  const std::size_t others = outcome.worse.size() - 1;
  text += others > 0 ? " and than " + counted(others, "other") : "";
  const std::vector<std::string> close =
      namesOf(study, *outcome.comparison, RelativeToBest::NotDifferent);
  return study.options.size() > 2 && !close.empty()
             ? text + ", not significantly different from " + namesText(close)
             : text;
}

/// Whether a pair was tested: not if no run has a value, or all runs have the same.
bool isTested(const MetricComparison& comparison) {
  return std::any_of(comparison.pairs.begin(), comparison.pairs.end(),
                     [](const PairResult& pair) { return !std::isnan(pair.p); });
}

/// "10 seeds", "10 seeds in each of 3 cases".
std::string sizeText(const Study& study) {
  std::set<long long> seeds;
  for (const Results::Run& run : study.results.runs) {
    seeds.insert(run.seed);
  }
  return counted(seeds.size(), "seed") +
         (study.cases.size() > 1 ? " in each of " + std::to_string(study.cases.size()) + " cases"
                                 : "");
}

/// The options that are better in an outcome of this kind, the most important first.
std::vector<std::size_t> winners(const std::vector<Outcome>& outcomes, bool isSmall) {
  std::vector<std::size_t> options;
  for (const Outcome& outcome : outcomes) {
    if (outcome.isWin() && outcome.isSmall() == isSmall &&
        std::find(options.begin(), options.end(), outcome.better) == options.end()) {
      options.push_back(outcome.better);
    }
  }
  return options;
}

/// The sentences about the metrics in which an option is better, one per option.
std::string winsMarkup(const Study& study, const std::vector<Outcome>& outcomes) {
  std::string text;
  for (const std::size_t option : winners(outcomes, false)) {
    std::vector<std::string> wins;
    for (const Outcome& outcome : outcomes) {
      if (outcome.isWin() && !outcome.isSmall() && outcome.better == option) {
        wins.push_back(winMarkup(study, outcome));
      }
    }
    const bool isPair = study.options.size() == 2;
    text +=
        bold(study.options[option]) +
        (isPair ? " is better than " + bold(study.options[1 - option]) + " in " : " is best in ") +
        base::join(wins, "; ") + ". ";
  }
  return text;
}

/// A sentence on significant differences that are too small to matter; empty without any.
std::string smallWinsMarkup(const Study& study, const std::vector<Outcome>& outcomes) {
  std::vector<std::string> texts;
  for (const std::size_t option : winners(outcomes, true)) {
    std::vector<std::string> names;
    for (const Outcome& outcome : outcomes) {
      if (outcome.isWin() && outcome.isSmall() && outcome.better == option) {
        names.push_back(escaped(study.metrics[outcome.comparison->metric].name));
      }
    }
    texts.push_back(bold(study.options[option]) + " in " + listed(names));
  }
  const int percent = static_cast<int>(std::lround(100.0 * Outcome::kSmallShare));
  return texts.empty() ? std::string()
                       : "Better by less than " + std::to_string(percent) +
                             " % of the mean: " + base::join(texts, "; ") + ". ";
}

/// Can at least two options be ranked by this metric?
bool isComparable(const Study& study, const MetricComparison& comparison) {
  const Metric& metric = study.metrics[comparison.metric];
  const auto ranked = std::count(comparison.succeeds.begin(), comparison.succeeds.end(), true);
  return metric.sense != 0 && !comparison.pairs.empty() && (isSuccess(metric) || ranked > 1);
}

/// A sentence on the options that never succeed; empty without any.
std::string neverSucceedingMarkup(const Study& study, const Comparisons& comparisons) {
  std::vector<std::string> never;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (!comparisons.front().succeeds[option]) {
      never.push_back(bold(study.options[option]));
    }
  }
  if (never.empty()) {
    return {};
  }
  const bool isOne = never.size() == 1;
  return listed(never) + (isOne ? " never succeeds" : " never succeed") +
         ", so only success is compared with " + (isOne ? "it" : "them") + ". ";
}

}  // namespace

std::string verdictMarkup(const Study& study, const Comparisons& comparisons) {
  if (isOneRunPerCell(study)) {
    return element("p", " class=\"verdict\"",
                   "All seeds gave the same values: there is only one distinct run per option" +
                       std::string(study.cases.size() > 1 ? " and case" : "") +
                       ", so no difference between options can be tested.") +
           "\n";
  }
  std::vector<Outcome> outcomes;
  for (const MetricComparison& comparison : comparisons) {
    if (isComparable(study, comparison)) {
      outcomes.push_back(outcomeOf(study, comparison));
    }
  }
  if (outcomes.empty()) {
    return {};
  }
  std::stable_sort(outcomes.begin(), outcomes.end(), isMoreImportant);
  std::vector<std::string> open;
  for (const Outcome& outcome : outcomes) {
    if (outcome.worse.empty() && !outcome.isUnclear && isTested(*outcome.comparison)) {
      open.push_back(escaped(study.metrics[outcome.comparison->metric].name));
    }
  }
  std::string text = winsMarkup(study, outcomes) + smallWinsMarkup(study, outcomes);
  if (!open.empty()) {
    const bool isNone = open.size() == outcomes.size() && open.size() > 1;
    text += "With " + sizeText(study) + ", no difference could be shown in " +
            (isNone ? "any metric" : listed(open)) + ". ";
  }
  text += neverSucceedingMarkup(study, comparisons) + "Paired tests" +
          (open.empty() ? " over " + sizeText(study) : std::string()) +
          ", p &lt; 0.05 after Holm&#39;s adjustment over " +
          counted(testCounts(comparisons).pairs, "test") + ".";
  return element("p", " class=\"verdict\"", text) + "\n";
}

std::string findingMarkup(const Study& study, const MetricComparison& comparison) {
  if (!comparison.best) {
    return {};
  }
  const Metric& metric = study.metrics[comparison.metric];
  const double best = comparison.estimates[*comparison.best].mean;
  std::vector<std::string> leaders;  // the best and those equal to it
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (comparison.isBestOrTied(option)) {
      leaders.push_back(study.options[option]);
    }
  }
  const std::vector<std::string> beaten = namesOf(study, comparison, RelativeToBest::Worse);
  const std::vector<std::string> close = namesOf(study, comparison, RelativeToBest::NotDifferent);
  const std::vector<std::string> ahead = namesOf(study, comparison, RelativeToBest::Better);
  const std::vector<std::string> pieces = namesOf(study, comparison, RelativeToBest::NeverSucceeds);
  const int decimals = decimalsFor(best, comparison.estimates[*comparison.best].interval);
  const std::string unit = metric.unit.empty() || metric.unit == "-" ? "" : " " + metric.unit;
  std::string words = element("b", "", escaped(metric.name)) +
                      (leaders.size() == 1 ? ": best is " : ": best are ") +
                      escaped(base::join(leaders, ", ")) + " (" +
                      escaped(estimateText(metric, best, decimals) + unit) + ")";
  const bool beatsAll = close.empty() && ahead.empty() && pieces.empty() && beaten.size() > 1;
  const char* between = ", ";
  const auto add = [&](const std::vector<std::string>& names, const std::string& more) {
    words += names.empty() ? "" : between + more;
    between = names.empty() ? between : "; ";
  };
  add(beaten, "better than " + (beatsAll ? "all others" : namesText(beaten)));
  add(close, "not significantly different from " + namesText(close));
  add(ahead, "but " + namesText(ahead) + (ahead.size() == 1 ? " is" : " are") +
                 " better on the same cases and seeds");
  add(pieces, namesText(pieces) +
                  (pieces.size() == 1 ? " never succeeds and is" : " never succeed and are") +
                  " excluded");
  return words + ".";
}

}  // namespace report
