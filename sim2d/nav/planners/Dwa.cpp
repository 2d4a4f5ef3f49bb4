#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/base/Registry.h"
#include "sim2d/nav/CostToGo.h"
#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/FootprintGap.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotRoute.h"
#include "sim2d/nav/SweptClearance.h"

namespace sim2d {
namespace {

constexpr double kRouteVisibility = 1.0;     // [m] ahead on the route that must be visible
constexpr double kArrivalFraction = 0.8;     // fraction of the goal radius that an arc must reach
constexpr double kDwaBrakingFraction = 0.8;  // fraction of the maximum deceleration
constexpr double kReverseCostFactor = 1.5;   // cost factor of driving backward
constexpr double kPlanningRadiusFactor =
    1.05;                               // factor on the minimum turning radius for planned paths
constexpr double kTurnCost = 0.3;       // [m/rad], weight of the remaining rotation
constexpr double kRecoverySpeed = 0.3;  // [m/s]
constexpr double kDwaStandstillSpeed = 0.02;   // [m/s]
constexpr double kMinTurningSpeedRatio = 0.1;  // fraction of the full speed
constexpr double kBrakingStartInterval =
    0.4;  // [s] between the tested moments of starting to brake
constexpr int kDisplayedArcs = 40;
constexpr double kNotAdmissible = std::numeric_limits<double>::infinity();

/// Parameters of the dynamic window planner.
struct DwaParameters {
  double linearSamples = 20.0;
  double angularSamples = 20.0;
  double window = 0.25;    // [s]
  double horizon = 2.0;    // [s]
  double step = 0.1;       // [s]
  double margin = 0.1;     // [m]
  double clearance = 0.6;  // [m]
  double goalWeight = 1.0;
  double headingWeight = 0.4;
  double clearanceWeight = 0.3;
  double velocityWeight = 0.1;
  double smoothnessWeight = 0.05;
  double slowDistance = 0.8;  // [m]
  double slowShare = 0.4;
  double standingSpeed = 0.25;   // [m/s]
  double patience = 4.0;         // [s]
  double reverseDistance = 0.4;  // [m]
};

base::ParameterTable<DwaParameters> dwaTable() {
  using P = DwaParameters;
  constexpr base::Range kCount{1.0, 200.0};
  constexpr base::Range kShare{0.0, 1.0};
  const char* const fox = "Fox, Burgard & Thrun 1997";
  base::ParameterTable<P> table;
  table
      .addCount(&P::linearSamples, "linear_samples", kCount,
                "Sampled speeds; omnidirectional: the total number of samples is distributed "
                "evenly.")
      .addCount(&P::angularSamples, "angular_samples", kCount, "Sampled turn rates for each speed.")
      .add(&P::window, "window", "s", {0.01, 2.0},
           "Time within which a sampled velocity must be reachable.", std::string(fox) + ", 0.25")
      .add(&P::horizon, "horizon", "s", {0.2, 10.0},
           "Time for which arcs are simulated; longer if braking takes longer.")
      .add(&P::step, "step", "s", {0.02, 0.5}, "Time between two checks along an arc.")
      .add(&P::margin, "margin", "m", base::kDistance, "Minimum distance to walls and people.")
      .add(&P::clearance, "clearance", "m", {0.01, 5.0},
           "Clearance above which more clearance does not improve the score of an arc.")
      .add(&P::goalWeight, "goal_weight", "", base::kWeight,
           "Weight of the remaining path length at the end of an arc.")
      .add(&P::headingWeight, "heading_weight", "", base::kWeight,
           "Weight of the remaining rotation at the position where the robot would stop if it "
           "braked.",
           fox)
      .add(&P::clearanceWeight, "clearance_weight", "", base::kWeight,
           "Weight of missing clearance along an arc.", fox)
      .add(&P::velocityWeight, "velocity_weight", "", base::kWeight,
           "Weight of the difference to the maximum speed.", fox)
      .add(&P::smoothnessWeight, "smoothness_weight", "", base::kWeight,
           "Weight of the difference from the last command.")
      .add(&P::slowDistance, "slow_distance", "m", base::kDistance,
           "Gap to a person ahead below which the robot slows down.")
      .add(&P::slowShare, "slow_share", "", kShare, "Share of the maximum speed close to a person.")
      .add(&P::standingSpeed, "standing_speed", "m/s", base::kSpeed,
           "People below this speed count as standing: the path leads around them.")
      .add(&P::patience, "patience", "s", base::kTimeSpan,
           "Time without progress after which the robot backs off and tries again.")
      .add(&P::reverseDistance, "reverse_distance", "m", base::kDistance,
           "Distance that it backs off.");
  return table;
}

bool isInWindow(const TwistWindow& window, const BodyTwist& twist) {
  return twist.linear >= window.lowLinear && twist.linear <= window.highLinear &&
         twist.angular >= window.lowAngular && twist.angular <= window.highAngular &&
         twist.lateral >= window.lowLateral && twist.lateral <= window.highLateral;
}

/// Speed of the centre [m/s].
double speedOf(const BodyTwist& twist) {
  return std::sqrt(twist.linear * twist.linear + twist.lateral * twist.lateral);
}

/// The dynamic window approach (Fox, Burgard & Thrun 1997). It samples the velocities that the
/// drive can reach in time, rejects those after which the robot could not stop before a collision,
/// and drives the best of the rest. Instead of the paper's smoothed objective it uses the remaining
/// path length at the end of an arc (CostToGo; for Ackermann by relaxed Dubins curves with the
/// turning radius) and a term for changes of the command; so the robot neither cuts corners nor
/// gets stuck in front of people who stand still.
///
/// People are assumed to keep their velocity over the length of the arcs and not to give way. If no
/// velocity is admissible, the robot brakes and turns in the direction of the path. Without
/// progress for a while it moves away a little and then accepts smaller gaps (StuckDetector).
class Dwa : public Planner {
 public:
  Dwa(const RobotBody& body, const DwaParameters& parameters)
      : parameters_(parameters),
        body_(body),
        reach_(circumscribedRadius(body.footprint)),
        clearance_(body, parameters.clearance),
        costToGo_(inscribedRadius(body.footprint), reach_, parameters.margin),
        stuckDetector_(parameters.patience, parameters.reverseDistance),
        sampler_(body, sampleCounts(body.kinematics,
                                    static_cast<int>(std::lround(parameters.linearSamples)),
                                    static_cast<int>(std::lround(parameters.angularSamples)))) {
    const auto most = static_cast<std::size_t>(
        std::lround(parameters.linearSamples) * std::lround(parameters.angularSamples) + 1);
    twists_.reserve(most);
    samples_.reserve(most);
  }

  base::Result<BodyTwist> command(const Observation& observation) override {
    const Vec2& position = observation.pose.position;
    samples_.clear();
    hasStartedRecovery_ = false;
    route_.update(observation, reach_, kRouteVisibility);
    if (route_.isEmpty() || (position - observation.goal).norm() <= observation.goalRadius) {
      last_ = {};
      return BodyTwist{};
    }
    costToGo_.update(observation, route_, parameters_.standingSpeed, clearance_.points());
    stuckDetector_.update(
        observation.time, position, observation.goal,
        remainingFrom(observation, observation.pose) + kTurnCost * remainingTurn(observation.pose));
    hasStartedRecovery_ = stuckDetector_.hasJustStarted();
    prepare(observation);
    last_ = best(observation);
    return last_;
  }

  std::vector<Vec2> path() const override { return route_.points(); }
  std::vector<Candidate> candidates() const override;
  bool takeReplanned() override {
    const bool isNew = route_.takeReplanned();
    return std::exchange(hasStartedRecovery_, false) || isNew;
  }

 private:
  struct Sample {
    BodyTwist twist;
    double cost = kNotAdmissible;
  };

  void prepare(const Observation& observation);
  TwistWindow windowNow(const Observation& observation) const;
  double speedLimit(const Observation& observation) const;
  BodyTwist best(const Observation& observation);
  BodyTwist brake(const Observation& observation) const;
  double costOf(const Observation& observation, const BodyTwist& twist, double bound);
  double costLowerBound(const Observation& observation, const BodyTwist& twist) const;
  double changeOf(const BodyTwist& twist) const;
  double slownessOf(const BodyTwist& twist) const;
  bool isDisplayed(std::size_t sample) const;
  std::size_t endIndex(const Observation& observation,
                       const SweptClearance::Evaluation& found) const;
  double remainingFrom(const Observation& observation, const Pose2& pose) const;
  double headingCost(const Observation& observation, const BodyTwist& twist, std::size_t end) const;
  bool isAdmissible(const SweptClearance::Trajectory& way, const SweptClearance::Evaluation& found,
                    const BodyTwist& twist) const;
  double recoveryCost(const BodyTwist& twist) const;
  double remainingTurn(const Pose2& pose) const;
  double signedRemainingTurn(const Pose2& pose) const;

  DwaParameters parameters_;
  RobotBody body_;
  double reach_;  // [m]
  RobotRoute route_;
  SweptClearance clearance_;
  CostToGo costToGo_;
  StuckDetector stuckDetector_;
  TwistSampler sampler_;
  std::vector<BodyTwist> twists_;
  std::vector<Sample> samples_;  // of the last call
  std::size_t chosen_ = 0;       // index into samples_; their number: none
  std::vector<Pose2> poses_;     // of the current arc
  Pose2 pose_;                   // at the last call, for display
  BodyTwist motion_, last_;
  bool hasStartedRecovery_ = false;
};

double Dwa::signedRemainingTurn(const Pose2& pose) const {
  const Vec2 way = costToGo_.direction(pose.position);
  if (way.isZero(0.0)) {
    return 0.0;
  }
  const Vec2 ahead = base::directionOf(pose.heading);
  return base::atan2(base::cross(ahead, way), ahead.dot(way));
}

/// Rotation needed to face along the path [rad]; a car may also drive backward.
double Dwa::remainingTurn(const Pose2& pose) const {
  const double turn = std::fabs(signedRemainingTurn(pose));
  return body_.kinematics == Kinematics::Ackermann ? std::min(turn, base::kPi - turn) : turn;
}

/// Maximum speed with respect to the goal, people ahead and the coming turn [m/s]; a robot that can
/// turn in place does so before it drives away.
double Dwa::speedLimit(const Observation& observation) const {
  double limit = body_.limits.maxVel;
  if (body_.kinematics == Kinematics::Differential) {
    limit *= std::max(kMinTurningSpeedRatio, base::cos(remainingTurn(observation.pose)));
  }
  if (clearance_.gapAhead() < parameters_.slowDistance) {
    const double room = std::max(clearance_.gapAhead(), 0.0) / parameters_.slowDistance;
    limit *= parameters_.slowShare + (1.0 - parameters_.slowShare) * room;
  }
  if (costToGo_.containsRouteEnd()) {
    const double rest = costToGo_.at(observation.pose.position);
    limit = std::min(limit, std::sqrt(2.0 * kDwaBrakingFraction * body_.limits.maxAcc * rest));
  }
  return limit;
}

TwistWindow Dwa::windowNow(const Observation& observation) const {
  TwistWindow window =
      dynamicWindow(body_, observation.motion, std::max(parameters_.window, observation.dt));
  const double limit = stuckDetector_.isRecovering() ? kRecoverySpeed : speedLimit(observation);
  window.highLinear = std::max(window.lowLinear, std::min(window.highLinear, limit));
  window.lowLinear = std::min(window.highLinear, std::max(window.lowLinear, -limit));
  window.highLateral = std::max(window.lowLateral, std::min(window.highLateral, limit));
  window.lowLateral = std::min(window.highLateral, std::max(window.lowLateral, -limit));
  const bool mayReverse =
      body_.kinematics != Kinematics::Differential || stuckDetector_.isRecovering();
  if (!mayReverse && window.highLinear >= 0.0) {
    window.lowLinear = std::max(window.lowLinear, 0.0);
  }
  return window;
}

void Dwa::prepare(const Observation& observation) {
  pose_ = observation.pose;
  motion_ = observation.motion;
  const DriveLimits& limits = body_.limits;
  const double fastest = std::max({limits.maxVel, limits.maxReverse, std::fabs(motion_.linear)});
  const double stop =
      stoppingTime(body_, {fastest, limits.maxOmega}) + parameters_.window + parameters_.step;
  const double time = std::max(parameters_.horizon, stop);
  poses_.resize(1 + static_cast<std::size_t>(std::ceil(time / parameters_.step)));
  clearance_.observe(observation, parameters_.margin * stuckDetector_.marginScale(),
                     std::sqrt(2.0) * fastest, time);
}

/// Index of the last relevant pose of the arc: before a collision, or at the goal.
std::size_t Dwa::endIndex(const Observation& observation,
                          const SweptClearance::Evaluation& found) const {
  const auto end = static_cast<std::size_t>(std::min(found.wallStep, found.bodyStep)) - 1;
  if (!costToGo_.containsRouteEnd()) {
    return end;
  }
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= end; ++i) {
    const double distance = (poses_[i].position - observation.goal).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  const double near = kArrivalFraction * observation.goalRadius;
  return least <= near * near ? nearest : end;
}

/// Remaining path length [m].
double Dwa::remainingFrom(const Observation& observation, const Pose2& pose) const {
  const double rest = costToGo_.at(pose.position);
  const bool isThere = (pose.position - observation.goal).norm() <= observation.goalRadius;
  if (body_.kinematics != Kinematics::Ackermann || isThere) {
    return rest;
  }
  const double radius = kPlanningRadiusFactor * std::max(body_.limits.turningRadius, 1e-3);
  const double turn = std::fabs(signedRemainingTurn(pose));
  return std::min(relaxedDubinsLength(rest, turn, radius),
                  kReverseCostFactor * relaxedDubinsLength(rest, base::kPi - turn, radius));
}

/// Remaining rotation at the pose where the robot would stop if it braked after this window.
double Dwa::headingCost(const Observation& observation, const BodyTwist& twist,
                        std::size_t end) const {
  const double stands = parameters_.window + 0.5 * stoppingTime(body_, twist);
  const auto at = std::min(end, static_cast<std::size_t>(std::lround(stands / parameters_.step)));
  const Pose2& pose = poses_[at];
  const bool isThere = (pose.position - observation.goal).norm() <= observation.goalRadius;
  return isThere ? 0.0 : remainingTurn(pose) / base::kPi;
}

/// Prefers driving backward; a car alternates between backward and forward.
double Dwa::recoveryCost(const BodyTwist& twist) const {
  const bool isForwards =
      body_.kinematics == Kinematics::Ackermann && stuckDetector_.tries() % 2 == 0;
  const double speed = isForwards ? twist.linear : -twist.linear;
  return 1.0 - std::clamp(speed / kRecoverySpeed, -1.0, 1.0);
}

/// True if the robot can stop after this window or, if a person passes behind it, later. The first
/// is the paper's condition; with walls only it is the weakest.
bool Dwa::isAdmissible(const SweptClearance::Trajectory& way,
                       const SweptClearance::Evaluation& found, const BodyTwist& twist) const {
  const double stopTime = stoppingTime(body_, twist);
  const double meets = std::min(found.wallStep, found.bodyStep) * way.step;
  double hold = parameters_.window;
  bool canStop = clearance_.canStop(way, found, hold, stopTime);
  while (!canStop && hold + kBrakingStartInterval + 0.5 * stopTime < meets) {
    hold += kBrakingStartInterval;
    canStop = clearance_.canStop(way, found, hold, stopTime);
  }
  return canStop;
}

/// Change of the command [fraction of the limits].
double Dwa::changeOf(const BodyTwist& twist) const {
  const DriveLimits& limits = body_.limits;
  return (std::fabs(twist.linear - last_.linear) + std::fabs(twist.lateral - last_.lateral)) /
             limits.maxVel +
         std::fabs(twist.angular - last_.angular) / limits.maxOmega;
}

/// Difference to the full speed [fraction of it].
double Dwa::slownessOf(const BodyTwist& twist) const {
  const bool isBackwards = body_.kinematics != Kinematics::Omnidirectional && twist.linear < 0.0;
  return isBackwards ? 1.0 : 1.0 - std::min(1.0, speedOf(twist) / body_.limits.maxVel);
}

/// Lower bound of the cost of this twist before its arc is computed, from the farthest position it
/// can reach.
double Dwa::costLowerBound(const Observation& observation, const BodyTwist& twist) const {
  if (stuckDetector_.isRecovering()) {
    return 0.0;
  }
  const BodyTwist change{twist.linear - motion_.linear, 0.0, twist.lateral - motion_.lateral};
  const double time = static_cast<double>(poses_.size() - 1) * parameters_.step;
  const double farthest = speedOf(twist) * time +
                          speedOf(change) * speedOf(change) / std::max(body_.limits.maxAcc, 1e-9);
  const DwaParameters& p = parameters_;
  return p.smoothnessWeight * changeOf(twist) + p.velocityWeight * slownessOf(twist) +
         p.goalWeight * costToGo_.minWithin(observation.pose.position, farthest) /
             (body_.limits.maxVel * p.horizon);
}

/// Infinite also if the cost exceeds `bound`.
double Dwa::costOf(const Observation& observation, const BodyTwist& twist, double bound) {
  rollOut(body_, observation.pose, observation.motion, twist, parameters_.step, poses_);
  const SweptClearance::Trajectory way{poses_, parameters_.step,
                                       std::max(speedOf(twist), speedOf(motion_))};
  const SweptClearance::Evaluation found = clearance_.along(way);
  const DwaParameters& p = parameters_;
  const std::size_t end = endIndex(observation, found);
  const double room = std::clamp(found.gap / p.clearance, 0.0, 1.0);
  const double nearness = p.clearanceWeight * (1.0 - room) + p.smoothnessWeight * changeOf(twist);
  const bool isRecovering = stuckDetector_.isRecovering();
  const double slowness = isRecovering ? recoveryCost(twist) : p.velocityWeight * slownessOf(twist);
  const double rest = isRecovering ? 0.0
                                   : p.goalWeight * remainingFrom(observation, poses_[end]) /
                                         (body_.limits.maxVel * p.horizon);
  if (nearness + slowness + rest > bound || !isAdmissible(way, found, twist)) {
    return kNotAdmissible;
  }
  return nearness + p.headingWeight * headingCost(observation, twist, end) + slowness + rest;
}

/// Whether the arc of this sample is displayed with its cost.
bool Dwa::isDisplayed(std::size_t sample) const {
  const std::size_t stride = std::max<std::size_t>(1, twists_.size() / kDisplayedArcs);
  return sample % stride == stride / 2;
}

/// Evaluates the last command first, then the fastest; most others are then rejected by their lower
/// bound.
BodyTwist Dwa::best(const Observation& observation) {
  constexpr double kRounding = 1e-9;
  const TwistWindow window = windowNow(observation);
  sampler_.sample(window, twists_);
  if (isInWindow(window, last_)) {  // the last command is among the samples, bit-identical
    twists_.push_back(last_);
  }
  double least = kNotAdmissible;
  chosen_ = twists_.size();
  samples_.resize(twists_.size());
  for (std::size_t i = twists_.size(); i-- > 0;) {
    const BodyTwist& twist = twists_[i];
    const double bound = isDisplayed(i) ? kNotAdmissible : least + kRounding;
    const bool canBeBest = costLowerBound(observation, twist) <= bound;
    samples_[i] = {twist, canBeBest ? costOf(observation, twist, bound) : kNotAdmissible};
    if (samples_[i].cost <= least && samples_[i].cost < kNotAdmissible) {
      least = samples_[i].cost;
      chosen_ = i;
    }
  }
  return chosen_ < twists_.size() ? twists_[chosen_] : brake(observation);
}

/// Zero velocity, or turning in place towards the path if that cannot cause a collision.
BodyTwist Dwa::brake(const Observation& observation) const {
  const bool stands = std::fabs(observation.motion.linear) < kDwaStandstillSpeed &&
                      std::fabs(observation.motion.lateral) < kDwaStandstillSpeed;
  if (!stands || !body_.footprint.isDisc() || body_.kinematics == Kinematics::Ackermann) {
    return {};
  }
  const double turn = signedRemainingTurn(observation.pose);
  const double rate =
      std::min(body_.limits.maxOmega, std::sqrt(body_.limits.maxAlpha * std::fabs(turn)));
  return {0.0, std::copysign(rate, turn)};
}

std::vector<Candidate> Dwa::candidates() const {
  std::vector<Candidate> shown;
  std::vector<Pose2> poses(poses_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const bool isChosen = i == chosen_;
    if (!isDisplayed(i) && !isChosen) {
      continue;
    }
    rollOut(body_, pose_, motion_, samples_[i].twist, parameters_.step, poses);
    Candidate arc;
    arc.cost = samples_[i].cost;
    arc.isChosen = isChosen;
    for (const Pose2& pose : poses) {
      arc.points.push_back(pose.position);
    }
    shown.push_back(std::move(arc));
  }
  return shown;
}

/// Maximum number of poses checked in one call: along each arc, and during braking from each tested
/// moment.
double poseCount(const DwaParameters& parameters, double stopTime) {
  const double samples = parameters.linearSamples * parameters.angularSamples;
  const double along = std::max(parameters.horizon, stopTime) / parameters.step;
  const double braking = stopTime / kBrakingStartInterval * stopTime / parameters.step;
  return samples * (along + braking);
}

base::Result<std::shared_ptr<Planner>> makeDwa(const PlannerSetup& setup) {
  constexpr double kMaxPoses = 5e7;
  DwaParameters parameters;
  dwaTable().set(parameters, setup.parameters);
  const DriveLimits& limits = setup.body.limits;
  const double fastest = std::max(limits.maxVel, limits.maxReverse);
  const double stopTime = stoppingTime(setup.body, {fastest, limits.maxOmega});
  const double poses = poseCount(parameters, stopTime);
  if (!(poses <= kMaxPoses)) {
    const double samples = parameters.linearSamples * parameters.angularSamples;
    return base::error("planner.too-much-work", {std::round(poses), kMaxPoses, std::round(stopTime),
                                                 parameters.step, samples});
  }
  return std::shared_ptr<Planner>(std::make_shared<Dwa>(setup.body, parameters));
}

}  // namespace

void addDwa(PlannerRegistry& to);
void addDwa(PlannerRegistry& to) {
  to.add("dwa", dwaTable().specs(), makeDwa,
         "Dynamic window approach (Fox, Burgard & Thrun 1997): scores the arcs that the robot can "
         "drive next.");
}

}  // namespace sim2d
