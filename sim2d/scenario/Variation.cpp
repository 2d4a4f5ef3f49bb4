#include "sim2d/scenario/Variation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kTries = 64;            // of a truncated draw; all fail once in 1e19
constexpr std::uint32_t kPerDraw = 2 * kTries;  // counter values per draw
constexpr std::uint32_t kPerQuantity = 1U << 20U;
constexpr std::uint32_t kGroupDrawOffset = 1U << 12U;  // draws; above those of single agents
constexpr double kNarrow = 2.5;                        // [sd], see truncatedNormal

constexpr std::array<VariationInfo, kVariedCount> kQuantities = {{
    {"start_time", "Start time", "s", false, 0.0, kInfinite},
    {"start", "Start", "m", false, -kInfinite, kInfinite},
    {"heading", "Heading", "rad", false, -base::kPi, base::kPi},
    {"speed", "Speed", "", true, 0.1, 10.0},
    {"reaction_time", "Reaction time", "", true, 0.1, 10.0},
    {"first_goal", "First goal", "", false, -kInfinite, kInfinite},
}};

using Kind = SpreadKind;
using Spreads = std::array<Spread, kVariedCount>;

// Strong speeds: 0.26 of 1.34 m/s (Weidmann 1993). The other widths are our assumptions.
constexpr Spreads kLight = {{{Kind::None, 0.0, 2.0, 5.0, 0.0, kInfinite},
                             {Kind::Normal, 0.0, 0.25, 0.5, -0.5, 0.5},
                             {Kind::Normal, 0.0, 0.2, 0.4, -0.5, 0.5},
                             {Kind::Normal, 1.0, 0.1, 0.2, 0.8, 1.2},
                             {Kind::Normal, 1.0, 0.1, 0.2, 0.8, 1.2},
                             {Kind::None, 0.0, 1.0, kInfinite, -kInfinite, kInfinite}}};
constexpr Spreads kStrong = {{{Kind::Uniform, 0.0, 2.0, 5.0, 0.0, kInfinite},
                              {Kind::Normal, 0.0, 0.75, 1.5, -1.5, 1.5},
                              {Kind::Uniform, 0.0, 0.8, base::kPi, -base::kPi, base::kPi},
                              {Kind::Normal, 1.0, 0.194, 0.4, 0.5, 1.5},
                              {Kind::Normal, 1.0, 0.3, 0.5, 0.5, 2.0},
                              {Kind::Uniform, 0.0, 1.0, kInfinite, -kInfinite, kInfinite}}};

std::size_t at(VariationQuantity quantity) {
  return static_cast<std::size_t>(quantity);
}

/// A truncated normal draw about 0 with low <= 0 <= high, by rejection (Robert 1995): proposals are
/// normal, or uniform if the range is narrow, so that at least about half of them are accepted.
double truncatedNormal(double sd, double low, double high, const base::AgentRng& rng,
                       std::uint32_t index) {
  if (sd <= 0.0) {
    return 0.0;
  }
  const double from = low / sd;
  const double to = high / sd;
  const bool isNarrow = to - from < kNarrow;
  for (std::uint32_t i = index; i < index + kPerDraw; i += 2) {
    const double tried = isNarrow ? rng.uniform(from, to, base::DrawPurpose::Variation, i)
                                  : rng.normal(0.0, 1.0, base::DrawPurpose::Variation, i);
    const bool isTaken = isNarrow ? rng.uniform01(base::DrawPurpose::Variation, i + 1) <
                                        base::exp(-tried * tried / 2.0)
                                  : tried >= from && tried <= to;
    if (isTaken) {
      return sd * tried;
    }
  }
  return 0.0;
}

std::uint32_t indexOf(VariationQuantity quantity, std::uint32_t index) {
  return static_cast<std::uint32_t>(at(quantity)) * kPerQuantity + index * kPerDraw;
}

bool hasKeys(const SpreadSettings& own) {
  return own.kind || own.sd || own.halfWidth || own.min || own.max;
}

}  // namespace

const VariationInfo& variationInfo(VariationQuantity quantity) {
  return kQuantities.at(at(quantity));
}

Spread spreadOf(const VariationSettings& settings, VariationQuantity quantity) {
  const VariationPreset preset = settings.preset.value_or(VariationPreset::None);
  Spread spread = (preset == VariationPreset::Strong ? kStrong : kLight).at(at(quantity));
  if (preset == VariationPreset::None) {
    spread.kind = SpreadKind::None;
  }
  const SpreadSettings& own = settings.of(quantity);
  if (hasKeys(own)) {
    const VariationInfo& limits = variationInfo(quantity);
    spread.kind = own.kind.value_or(spread.kind);
    spread.sd = own.sd.value_or(spread.sd);
    spread.halfWidth = own.halfWidth.value_or(spread.halfWidth);
    spread.least = own.min.value_or(limits.least);
    spread.most = own.max.value_or(limits.most);
  }
  return spread;
}

bool isVaried(const VariationSettings& settings) {
  for (std::size_t i = 0; i < kVariedCount; ++i) {
    if (spreadOf(settings, static_cast<VariationQuantity>(i)).kind != SpreadKind::None) {
      return true;
    }
  }
  return false;
}

double drawFrom(const Spread& spread, VariationQuantity quantity, const base::AgentRng& rng,
                std::uint32_t index) {
  const double low = spread.least - spread.centre;
  const double high = spread.most - spread.centre;
  const std::uint32_t first = indexOf(quantity, index);
  switch (spread.kind) {
    case SpreadKind::Normal:
      return spread.centre + truncatedNormal(spread.sd, low, high, rng, first);
    case SpreadKind::Uniform:
      return spread.centre + rng.uniform(std::max(low, -spread.halfWidth),
                                         std::min(high, spread.halfWidth),
                                         base::DrawPurpose::Variation, first);
    case SpreadKind::None:
      break;
  }
  return spread.centre;
}

PersonVariation::PersonVariation(const VariationSettings& settings, long long seed, int id,
                                 int group)
    : settings_(settings),
      own_(static_cast<std::uint64_t>(seed), id),
      shared_(static_cast<std::uint64_t>(seed), group >= 0 ? group : id),
      sharedIndex_(group >= 0 ? kGroupDrawOffset : 0) {}

double PersonVariation::draw(VariationQuantity quantity, std::uint32_t index) const {
  return drawFrom(spreadOf(settings_, quantity), quantity, own_, index);
}

double PersonVariation::drawForGroup(VariationQuantity quantity) const {
  return drawFrom(spreadOf(settings_, quantity), quantity, shared_, sharedIndex_);
}

void PersonVariation::apply(ResolvedHuman& person) const {
  person.startTime = std::max(0.0, person.startTime + drawForGroup(VariationQuantity::StartTime));
  person.start.heading = base::wrapToPi(person.start.heading + draw(VariationQuantity::Heading));
  person.desiredSpeed *= draw(VariationQuantity::Speed);
  person.reactionTime = draw(VariationQuantity::ReactionTime);
}

std::size_t PersonVariation::firstGoal(std::size_t count) const {
  const Spread spread = spreadOf(settings_, VariationQuantity::FirstGoal);
  if (count < 2 || spread.kind == SpreadKind::None) {
    return 0;
  }
  const auto all = static_cast<double>(count);
  double skipped = 0.0;
  if (spread.kind == SpreadKind::Normal) {
    skipped = std::round(drawForGroup(VariationQuantity::FirstGoal));
  } else {  // integers with equal probability
    double low = std::ceil(std::max(spread.least, -spread.halfWidth));
    double numbers = std::floor(std::min(spread.most, spread.halfWidth)) - low + 1.0;
    if (numbers >= all) {
      low = 0.0;
      numbers = all;
    }
    const std::uint32_t index = indexOf(VariationQuantity::FirstGoal, sharedIndex_);
    skipped = low + std::floor(numbers * shared_.uniform01(base::DrawPurpose::Variation, index));
  }
  const double index = skipped - all * std::floor(skipped / all);
  return static_cast<std::size_t>(index) % count;
}

Vec2 PersonVariation::startOffset(std::uint32_t trial) const {
  const double x = draw(VariationQuantity::Start, 2 * trial);
  return {x, draw(VariationQuantity::Start, 2 * trial + 1)};
}

FirstGoal firstGoalOf(const VariationSettings& settings, const Human& human, long long seed) {
  FirstGoal first{0, human.goals, human.ours.wait};
  const bool isCyclic = human.cyclicGoals.value_or(ResolvedHuman().cyclicGoals);
  const PersonVariation draws(settings, seed, human.id, human.groupId.value_or(-1));
  first.index = isCyclic ? static_cast<int>(draws.firstGoal(human.goals.size())) : 0;
  std::rotate(first.goals.begin(), first.goals.begin() + first.index, first.goals.end());
  if (first.wait.size() == first.goals.size()) {
    std::rotate(first.wait.begin(), first.wait.begin() + first.index, first.wait.end());
  }
  return first;
}

bool dependsOnSeed(const Scenario& scenario) {
  const auto isDrawnPerson = [](const Human& human) {
    return human.listed && isDrawn(human.behavior.configuration.value_or(Configuration::Default));
  };
  const auto isSource = [](const Area& area) {
    return area.listed && area.kind == AreaKind::Source && area.rate.value_or(0.0) > 0.0;
  };
  const auto hasNoise = [&scenario](const Robot& robot) {
    const ResolvedRobot resolved = resolveRobot(scenario, robot, -1);
    const DetectorParameters& detector = resolved.detector;
    return robot.listed && (detector.noise > 0.0 || detector.misses > 0.0 || detector.swaps > 0.0 ||
                            !resolved.odometry.isExact() || resolved.localization.isRandom());
  };
  return isVaried(scenario.desktop.variation) ||
         std::any_of(scenario.humans.begin(), scenario.humans.end(), isDrawnPerson) ||
         std::any_of(scenario.areas.begin(), scenario.areas.end(), isSource) ||
         std::any_of(scenario.robots.begin(), scenario.robots.end(), hasNoise);
}

}  // namespace sim2d
