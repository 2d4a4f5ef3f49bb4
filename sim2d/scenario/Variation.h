#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sim2d/base/Rng.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/Scenario.h"

/// People who differ from seed to seed: the key `variation` of a scenario. A draw is a function of
/// (seed, person, quantity) alone, so all robots, planners and models of one seed meet the same
/// people.
namespace sim2d {

/// What one quantity is and may be: what is drawn is added to what is written, or is a factor.
struct VariedQuantity {
  const char* key;     // "start_time"
  const char* label;   // for people: "Start time"
  const char* unit;    // of sd, half_width, min and max; empty: a factor or a count
  bool isFactor;       // of what is written; else added to it
  double least, most;  // limits where the file gives none
};
const VariedQuantity& variedQuantity(Varied quantity);

/// How one quantity is drawn, in its unit: about 0 (added), or about 1 (a factor).
struct Spread {
  SpreadKind kind = SpreadKind::None;
  double centre = 0.0;
  double sd = 0.0;         // normal
  double halfWidth = 0.0;  // uniform; infinite: all goals of a list alike
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// The preset's; of a quantity with keys of its own these count, where one is absent the preset's
/// kind and width (with `none` those of `light`) and the limits of the quantity.
Spread spreadOf(const VariationSettings& settings, Varied quantity);
/// Anything is drawn at all.
bool isVaried(const VariationSettings& settings);

/// One draw: normal, truncated at both limits (not moved to them), or uniform in what they leave of
/// the range. `index` tells draws of one person and quantity apart.
double drawFrom(const Spread& spread, Varied quantity, const base::AgentRng& rng,
                std::uint32_t index = 0);

/// The draws of one person. People of one group come at one time and begin at the same goal.
class PersonVariation {
 public:
  /// `group`: -1 = alone. `settings` must outlive it.
  PersonVariation(const VariationSettings& settings, long long seed, int id, int group);

  /// Start time, heading, speed and reaction time.
  void apply(ResolvedHuman& person) const;
  /// Index of the goal to begin at, of a cyclic list of so many.
  std::size_t firstGoal(std::size_t count) const;
  bool movesStart() const;
  /// From the written start [m]; another one for each trial.
  Vec2 startOffset(std::uint32_t trial) const;

 private:
  double draw(Varied quantity, std::uint32_t index = 0) const;
  double drawTogether(Varied quantity) const;

  const VariationSettings& settings_;
  base::AgentRng own_, shared_;
  std::uint32_t sharedIndex_;
};

/// The goals of a person, and the waits at them, from the drawn one on.
struct FirstGoal {
  int index = 0;  // in the written list
  std::vector<int> goals;
  std::vector<double> wait;
};
/// Routes that do not repeat stay as they are.
FirstGoal firstGoalOf(const VariationSettings& settings, const Human& human, long long seed);

/// Whether people, or where robots take them to be, differ from seed to seed; else many seeds are
/// one run, but for the noise of lidars and of planners that draw.
bool dependsOnSeed(const Scenario& scenario);

}  // namespace sim2d
