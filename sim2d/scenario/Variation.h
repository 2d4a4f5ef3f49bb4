#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sim2d/base/Rng.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/Scenario.h"

/// Variation of agents between seeds: the key `variation` of a scenario. A draw depends only on
/// (seed, agent, quantity), so all robots, planners and models meet the same agents for one seed.
namespace sim2d {

/// Description of a quantity; a draw is added to the given value, or multiplied by it.
struct VariationInfo {
  const char* key;     // "start_time"
  const char* label;   // for users: "Start time"
  const char* unit;    // of sd, half_width, min and max; empty: a factor or a count
  bool isFactor;       // multiplied by the given value; else added
  double least, most;  // default limits
};
const VariationInfo& variationInfo(VariationQuantity quantity);

/// Distribution of one quantity, in its unit: centred at 0 (added) or 1 (factor).
struct Spread {
  SpreadKind kind = SpreadKind::None;
  double centre = 0.0;
  double sd = 0.0;         // normal
  double halfWidth = 0.0;  // uniform; infinite: all goals of a list are equally likely
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// The distribution from the preset. A quantity with its own keys uses them; absent ones default to
/// the preset's kind and width (with `none` the width of `light`) and to the quantity's limits.
Spread spreadOf(const VariationSettings& settings, VariationQuantity quantity);
/// Whether any quantity is drawn.
bool isVaried(const VariationSettings& settings);

/// One draw: normal, truncated (not clamped) to the limits, or uniform in the range between them.
/// `index` distinguishes draws of one agent and quantity.
double drawFrom(const Spread& spread, VariationQuantity quantity, const base::AgentRng& rng,
                std::uint32_t index = 0);

/// The draws of one agent. Agents of a group share the start time and the first goal.
class PersonVariation {
 public:
  /// `group`: -1 = none. `settings` must outlive it.
  PersonVariation(const VariationSettings& settings, long long seed, int id, int group);

  /// Applies start time, heading, speed and reaction time.
  void apply(ResolvedHuman& person) const;
  /// Index of the first goal in a cyclic list of `count` goals.
  std::size_t firstGoal(std::size_t count) const;
  /// Offset from the given start [m], different for each trial.
  Vec2 startOffset(std::uint32_t trial) const;

 private:
  double draw(VariationQuantity quantity, std::uint32_t index = 0) const;
  double drawForGroup(VariationQuantity quantity) const;

  const VariationSettings& settings_;
  base::AgentRng own_, shared_;
  std::uint32_t sharedIndex_;
};

/// The goals of an agent and its waiting times, beginning with the drawn first goal.
struct FirstGoal {
  int index = 0;  // in the original list
  std::vector<int> goals;
  std::vector<double> wait;
};
/// Routes that are not cyclic are unchanged.
FirstGoal firstGoalOf(const VariationSettings& settings, const Human& human, long long seed);

/// Whether agents, or the pose estimates of robots, differ between seeds. Otherwise runs differ
/// only by the noise of lidars and by planners that draw.
bool dependsOnSeed(const Scenario& scenario);

}  // namespace sim2d
