#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {
namespace {

constexpr double kNegligible = 1e-4;     // of k_s: smaller terms of a crowd are left out
constexpr double kUnfelt = 1e-6;         // [m/s²]; smaller forces of one body never count
constexpr std::size_t kSmallCrowd = 64;  // up to here every pair is summed
constexpr double kMateTurnWidth = 0.1;   // [rad]; mates in step do not circle round each other

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

/// The social force model of HuNavSim, with its numerical faults mended or as it was: no side
/// preference, forces through walls, one explicit step, and who brakes never quite stands.
class Sfm : public PedestrianModel {
 public:
  Sfm(const ResolvedHuman& person, bool isOriginal)
      : parameters_(parametersOf(person, isOriginal)), isOriginal_(isOriginal) {}

  ForceTerms forces(const Situation& situation) const override {
    ForceTerms terms;
    terms.social = socialTerm(situation) + changeByMates(situation);
    terms.obstacle = obstacleForce(parameters_, situation.self, situation.obstacles);
    terms.group =
        groupForce(parameters_, situation.self, situation.desired.direction, situation.group).sum();
    terms.goal =
        isOriginal_
            ? goalForce(parameters_, situation.self.velocity, situation.desired.direction,
                        situation.desired.desiredSpeed)
            : meanGoalForce(parameters_, situation.self.velocity, situation.desired.direction,
                            situation.desired.desiredSpeed, terms.sum(), situation.pushTime);
    return terms;
  }

  Vec2 velocity(const Situation& situation, const ForceTerms& forces) const override {
    return velocityAfter(situation, forces, isOriginal_ ? situation.dt : situation.pushTime,
                         isOriginal_ ? 0.0 : kStandingSpeed);
  }

  SocialLaw socialLaw() const override { return {&parameters_, isOriginal_}; }

  bool givesWayToRobots() const override { return !isOriginal_; }

  double range(double fastest, double ownSpeed) const override {
    return socialRange(parameters_, ownSpeed, fastest, cutOff_);
  }

 private:
  Vec2 socialTerm(const Situation& situation) const {
    const bool sumsAll =
        situation.exact || (!situation.ofCrowd && situation.others.size() <= kSmallCrowd);
    Vec2 sum = situation.ofCrowd.value_or(Vec2::Zero());
    for (const Walker& other : situation.others) {
      if (!sumsAll && isNegligible(parameters_, situation.self, other, cutOff_)) {
        continue;
      }
      const Vec2 force = socialForce(parameters_, situation.self, other);
      if (!situation.exact && force.norm() < kUnfelt) {
        continue;  // not worth a look for walls
      }
      if (!force.isZero(0.0) &&
          (isOriginal_ || (*situation.isVisible)(situation.self.position, other.position))) {
        sum += force;
      }
    }
    return sum;
  }

  /// Mates in step are right at the jump of the turning force, which would throw them from side to
  /// side: for them it is a ramp.
  Vec2 changeByMates(const Situation& situation) const {
    Vec2 change = Vec2::Zero();
    if (situation.group.empty()) {
      return change;
    }
    ForceParameters forMates = parameters_;
    forMates.turnWidth = isOriginal_ ? 0.0 : kMateTurnWidth;
    for (const Walker& mate : situation.group) {
      const Vec2 turnsLess = socialForce(forMates, situation.self, mate) -
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
};

}  // namespace

void addSfm(ModelRegistry& to);
void addSfm(ModelRegistry& to) {
  ForceParameters original;
  original.epsilon = 0.0;
  to.add(
      "sfm", forceTable().specs(),
      [](const ResolvedHuman& person) { return std::make_unique<Sfm>(person, false); },
      "The social forces of HuNavSim (Moussaïd et al. 2009, 2010) without its mistakes.");
  to.add(
      "sfm-hunav2", forceTable().specs(original),
      [](const ResolvedHuman& person) { return std::make_unique<Sfm>(person, true); },
      "The social forces of HuNavSim 2.0 as they are, to compare with its numbers.");
}

}  // namespace sim2d
