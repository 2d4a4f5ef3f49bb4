#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {
namespace {

constexpr double kNegligible = 1e-4;  // of k_s; smaller terms are skipped in a crowd
constexpr double kMinForce = 1e-6;    // [m/s²]; smaller forces of one body are always ignored
constexpr std::size_t kAllPairsCrowd = 64;  // crowds up to this size sum all pairs
constexpr double kGroupTurnWidth = 0.1;     // [rad]; prevents members side by side from circling

ForceParameters parametersOf(const ResolvedHuman& person, bool isOriginal) {
  ForceParameters parameters;
  parameters.epsilon = isOriginal ? 0.0 : parameters.epsilon;
  parameters.goalFactor = person.goalFactor;
  parameters.obstacleFactor = person.obstacleFactor;
  parameters.socialFactor = person.socialFactor;
  static const base::ParameterTable<ForceParameters> kTable = forceTable();
  kTable.set(parameters, person.modelParameters);
  parameters.relaxationTime *= person.reactionTime;
  return parameters;
}

/// The social force model of HuNavSim, with corrected numerics or as in the original: no side
/// preference, forces through walls, one explicit step, and braking that never reaches zero.
class Sfm : public PedestrianModel {
 public:
  Sfm(const ResolvedHuman& person, bool isOriginal)
      : parameters_(parametersOf(person, isOriginal)), isOriginal_(isOriginal) {}

  ForceTerms forces(const Situation& situation) const override {
    ForceTerms terms;
    terms.social = socialTerm(situation) + groupTurnChange(situation);
    terms.obstacle = obstacleForce(parameters_, situation.self, situation.obstacles);
    terms.group =
        groupForce(parameters_, situation.self, situation.desired.direction, situation.group).sum();
    terms.goal =
        isOriginal_
            ? goalForce(parameters_, situation.self.velocity, situation.desired.direction,
                        situation.desired.desiredSpeed)
            : meanGoalForce(parameters_, situation.self.velocity, situation.desired.direction,
                            situation.desired.desiredSpeed, terms.sum(), situation.forceTime);
    return terms;
  }

  Vec2 velocity(const Situation& situation, const ForceTerms& forces) const override {
    return velocityAfterForces(situation, forces, isOriginal_ ? situation.dt : situation.forceTime,
                               isOriginal_ ? 0.0 : kStandstillSpeed);
  }

  CrowdForceModel crowdForceModel() const override { return {&parameters_, isOriginal_}; }

  bool yieldsToRobots() const override { return !isOriginal_; }

  double range(double fastest, double ownSpeed) const override {
    return socialRange(parameters_, ownSpeed, fastest, cutOff_);
  }

 private:
  Vec2 socialTerm(const Situation& situation) const {
    const bool sumsAll =
        situation.exact || (!situation.crowdForce && situation.others.size() <= kAllPairsCrowd);
    Vec2 sum = situation.crowdForce.value_or(Vec2::Zero());
    for (const Walker& other : situation.others) {
      if (!sumsAll && isNegligible(parameters_, situation.self, other, cutOff_)) {
        continue;
      }
      if (!situation.exact && isWeaker(parameters_, situation.self, other, cutOffOfMin_)) {
        continue;
      }
      const Vec2 force = socialForce(parameters_, situation.self, other);
      if (!situation.exact && force.norm() < kMinForce) {
        continue;  // too small for a wall test
      }
      if (!force.isZero(0.0) &&
          (isOriginal_ || (*situation.isVisible)(situation.self.position, other.position))) {
        sum += force;
      }
    }
    return sum;
  }

  /// Members side by side are at the discontinuity of the turning force, which would make them
  /// oscillate: for them it is a ramp.
  Vec2 groupTurnChange(const Situation& situation) const {
    Vec2 change = Vec2::Zero();
    if (situation.group.empty()) {
      return change;
    }
    ForceParameters forGroup = parameters_;
    forGroup.turnWidth = isOriginal_ ? 0.0 : kGroupTurnWidth;
    for (const Walker& mate : situation.group) {
      const Vec2 turnsLess = socialForce(forGroup, situation.self, mate) -
                             socialForce(parameters_, situation.self, mate);
      if (!turnsLess.isZero(0.0) &&
          (*situation.isVisible)(situation.self.position, mate.position)) {
        change += turnsLess;
      }
    }
    return change;
  }

  ForceParameters parameters_;
  bool isOriginal_;
  double cutOff_ = cutOff(kNegligible);
  double cutOffOfMin_ = cutOffOfForce(parameters_, kMinForce);
};

}  // namespace

void addSfm(ModelRegistry& to);
void addSfm(ModelRegistry& to) {
  ForceParameters original;
  original.epsilon = 0.0;
  to.add(
      "sfm", forceTable().specs(),
      [](const ResolvedHuman& person) { return std::make_unique<Sfm>(person, false); },
      "The social force model of HuNavSim (Moussaïd et al. 2009, 2010) with its errors corrected.");
  to.add(
      "sfm-hunav2", forceTable().specs(original),
      [](const ResolvedHuman& person) { return std::make_unique<Sfm>(person, true); },
      "The social force model of HuNavSim 2.0 unchanged, for comparison with its results.");
}

}  // namespace sim2d
