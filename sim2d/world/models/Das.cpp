#include <algorithm>

#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {
namespace {

constexpr double kBodyRadius = 0.20;   // [m]; in dense crowds people turn their shoulders
constexpr double kContactRange = 2.0;  // [m]; bodies farther away cannot be reached in a step

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

/// The density-dependent social force model.
class Das : public PedestrianModel {
 public:
  explicit Das(const ResolvedHuman& person) : parameters_(parametersOf(person)) {}

  ForceTerms forces(const Situation& situation) const override {
    const Pedestrian self{situation.self, situation.desired};
    situation.seen = visibleNeighbors(situation);
    const DensityForce force =
        densityForce(parameters_, self, neighborsWithin(situation, kDensityRange));
    ForceTerms terms;
    terms.social = force.social + force.lane;
    terms.obstacle = limitedObstacleForce(parameters_, self, situation.obstacles, force.activation);
    terms.group =
        groupForce(parameters_.social, situation.self, situation.desired.direction, situation.group)
            .sum();
    terms.goal =
        meanGoalForce(parameters_.social, situation.self.velocity, situation.desired.direction,
                      force.speedCap, terms.sum(), situation.forceTime);
    return terms;
  }

  Vec2 velocity(const Situation& situation, const ForceTerms& forces) const override {
    const Vec2 wanted =
        velocityAfterForces(situation, forces, situation.forceTime, kStandstillSpeed);
    return avoidContacts(parameters_, {situation.self, situation.desired},
                         neighborsWithin(situation, kContactRange), situation.obstacles, wanted,
                         situation.dt);
  }

  bool usesDesiredMotions() const override { return true; }
  bool spreadsAtCorners() const override { return true; }

  std::optional<double> bodyRadiusOverride(const ResolvedHuman& person) const override {
    return person.kind == PersonKind::Wheelchair ? std::nullopt : std::optional(kBodyRadius);
  }

  double range(double /*fastest*/, double /*ownSpeed*/) const override { return kDensityRange; }

 private:
  static bool isWithin(const Situation& situation, const Walker& other, double range) {
    return (other.position - situation.self.position).squaredNorm() < range * range;
  }

  /// Relevant people: within the maximum range and not behind a wall, sorted by id.
  static std::vector<std::size_t> visibleNeighbors(const Situation& situation) {
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
  static const std::vector<Pedestrian>& neighborsWithin(const Situation& situation, double range) {
    static_assert(kContactRange <= kDensityRange);
    if (!situation.seen) {
      situation.seen = visibleNeighbors(situation);
    }
    thread_local std::vector<Pedestrian> found;
    found.clear();
    found.reserve(situation.seen->size());
    for (const std::size_t i : *situation.seen) {
      if (isWithin(situation, situation.others[i], range)) {
        found.push_back({situation.others[i], situation.desiredMotions[i]});
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
      "Crowd model of this program: social forces whose density, flow and lanes are close to "
      "measurements.");
}

}  // namespace sim2d
