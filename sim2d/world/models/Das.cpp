#include <algorithm>

#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {
namespace {

constexpr double kBodyRadius = 0.20;  // [m]; people in dense crowds turn their shoulders
constexpr double kGuardRange = 2.0;   // [m]; bodies farther away cannot be touched in a step

DensityParameters defaultParameters() {
  DensityParameters parameters;
  parameters.social.epsilon = 0.01;
  return parameters;
}

DensityParameters parametersOf(const ResolvedHuman& person) {
  DensityParameters parameters = defaultParameters();
  parameters.social.goalFactor = person.goalFactor;
  parameters.social.obstacleFactor = person.obstacleFactor;
  parameters.social.socialFactor = person.socialFactor;
  static const base::ParameterTable<DensityParameters> kTable = densityTable();
  kTable.set(parameters, person.modelParameters);
  parameters.social.relaxationTime *= person.reactionTime;
  return parameters;
}

/// The density-aware social force model.
class Das : public PedestrianModel {
 public:
  explicit Das(const ResolvedHuman& person) : parameters_(parametersOf(person)) {}

  ForceTerms forces(const Situation& situation) const override {
    const Pedestrian self{situation.self, situation.desired};
    situation.seen = seenBy(situation);
    const DensityForce force =
        densityForce(parameters_, self, neighborsOf(situation, kDensityRange));
    ForceTerms terms;
    terms.social = force.social + force.lane;
    terms.obstacle = limitedObstacleForce(parameters_, self, situation.obstacles, force.activation);
    terms.group =
        groupForce(parameters_.social, situation.self, situation.desired.direction, situation.group)
            .sum();
    terms.goal =
        meanGoalForce(parameters_.social, situation.self.velocity, situation.desired.direction,
                      force.speedCap, terms.sum(), situation.pushTime);
    return terms;
  }

  Vec2 velocity(const Situation& situation, const ForceTerms& forces) const override {
    const Vec2 wanted = velocityAfter(situation, forces, situation.pushTime, kStandingSpeed);
    return guardContacts(parameters_, {situation.self, situation.desired},
                         neighborsOf(situation, kGuardRange), situation.obstacles, wanted,
                         situation.dt);
  }

  bool looksAtDesires() const override { return true; }
  bool spreadsAtCorners() const override { return true; }

  std::optional<double> ownBodyRadius(const ResolvedHuman& person) const override {
    return person.kind == PersonKind::Wheelchair ? std::nullopt : std::optional(kBodyRadius);
  }

  double range(double /*fastest*/, double /*ownSpeed*/) const override { return kDensityRange; }

 private:
  static bool isWithin(const Situation& situation, const Walker& other, double range) {
    return (other.position - situation.self.position).squaredNorm() < range * range;
  }

  /// Who counts at all: within the longest range and not behind a wall, by id.
  static std::vector<std::size_t> seenBy(const Situation& situation) {
    const std::vector<Walker>& others = situation.others;
    std::vector<std::size_t> seen;
    seen.reserve(others.size());
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (isWithin(situation, others[i], kDensityRange) &&
          (*situation.isVisible)(situation.self.position, others[i].position)) {
        seen.push_back(i);
      }
    }
    std::sort(seen.begin(), seen.end(),
              [&others](std::size_t a, std::size_t b) { return others[a].id < others[b].id; });
    return seen;
  }

  /// Valid until the next call.
  static const std::vector<Pedestrian>& neighborsOf(const Situation& situation, double range) {
    static_assert(kGuardRange <= kDensityRange);
    if (!situation.seen) {
      situation.seen = seenBy(situation);
    }
    thread_local std::vector<Pedestrian> found;
    found.clear();
    found.reserve(situation.seen->size());
    for (const std::size_t i : *situation.seen) {
      if (isWithin(situation, situation.others[i], range)) {
        found.push_back({situation.others[i], situation.desires[i]});
      }
    }
    return found;
  }

  DensityParameters parameters_;
};

}  // namespace

void addDas(ModelRegistry& to);
void addDas(ModelRegistry& to) {
  to.add(
      "das", densityTable().specs(defaultParameters()),
      [](const ResolvedHuman& person) { return std::make_unique<Das>(person); },
      "Our model for crowds: social forces whose density, flow and lanes come near those "
      "measured.");
}

}  // namespace sim2d
