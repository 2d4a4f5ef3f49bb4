#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/ResultRow.h"
#include "metrics/statistics/ConfidenceSequences.h"
#include "sim2d/base/Result.h"

namespace base {
struct YamlNode;
}  // namespace base

namespace app {

struct Experiment;

/// The key `until` of an experiment: when a batch needs no more seeds.
struct StoppingRule {
  std::string metric;
  std::optional<double> halfWidth;  // of the interval of each combination of values
  std::string ranking;              // path (or "scenario") whose values must be ranked
  statistics::Interval range;       // of the metric; values outside count as its ends
  double level = 0.95;
  std::string text() const;  // "the interval of success is at most ±0.05"
};

/// Reads the key: {metric: success, halfwidth: 0.05} or {metric: success, ranking: robot1.planner},
/// optionally with `range: [LOW, HIGH]` and `level`. `experiment`: its scenarios, seeds and values
/// are known. Problems have their locations, without the file.
base::Result<StoppingRule> readStoppingRule(const base::YamlNode& node,
                                            const Experiment& experiment);

/// Decides after which number of seeds a batch has enough, from its results in any order.
///
/// One observation per seed: the mean over scenarios (half-width), or the mean over all cases of
/// the difference of two options (ranking). Its confidence sequences hold at all numbers of seeds
/// together (statistics::MeanSequence), so frequent checks do not invalidate them. For a ranking,
/// the error probability is divided by the number of pairs of options (Bonferroni). Undefined
/// values are left out; a failed run counts as one without success.
class StoppingCheck {
 public:
  /// The experiment has a stopping rule and must outlive this.
  explicit StoppingCheck(const Experiment& experiment);

  void add(std::size_t run, const ResultRow& row);
  /// The numbers of seeds after which the rule is checked: equal for any number of processes.
  std::vector<std::size_t> looks() const;
  /// Whether the first `seeds` seeds are enough; all their runs were added. Call with increasing
  /// numbers.
  bool isEnough(std::size_t seeds);

 private:
  /// The runs of one seed whose values belong together: their places in it, by case.
  using Places = std::map<std::string, std::size_t>;

  void addSeed(std::size_t seed);
  double valueAt(std::size_t seed, std::size_t place) const;
  double meanOf(std::size_t seed, const Places& places) const;
  double meanDifference(std::size_t seed, const Places& first, const Places& second) const;
  bool isDecided(const statistics::MeanSequence& sequence) const;

  const Experiment& experiment_;
  std::size_t runsPerSeed_;
  std::map<std::size_t, double> values_;  // by run; undefined ones are left out
  std::vector<Places> options_;           // combinations of values, or values of the ranked path
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // of options; empty: half-width
  std::vector<statistics::MeanSequence> sequences_;         // per option or pair
  std::size_t seeds_ = 0;                                   // in the sequences
};

}  // namespace app
