#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/ClearanceAlong.h"
#include "sim2d/nav/CostToGo.h"
#include "sim2d/nav/DwaParameters.h"
#include "sim2d/nav/FootprintGap.h"
#include "sim2d/nav/Motion.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotRoute.h"
#include "sim2d/nav/Rollout.h"
#include "sim2d/nav/StuckWatch.h"

namespace sim2d {
namespace {

constexpr double kRouteSight = 1.0;       // [m] ahead on the route that has to be in view
constexpr double kArrivingShare = 0.8;    // of the goal's radius that an arc has to come within
constexpr double kDwaBrakeShare = 0.8;    // of the way to the goal on which the robot brakes
constexpr double kDwaReversePrice = 1.5;  // of a metre driven backwards
constexpr double kRadiusShare = 1.05;     // of the least turning radius, for ways to plan
constexpr double kTurnPrice = 0.3;        // [m/rad], of turns that are left, for "gets on"
constexpr double kMoveOffSpeed = 0.3;     // [m/s]
constexpr double kDwaStanding = 0.02;     // [m/s]
constexpr double kTurningShare = 0.1;     // of the full speed, while the way leads backwards
constexpr double kBetweenStops = 0.4;     // [s] between moments at which it could begin to brake
constexpr int kDwaShownArcs = 40;
constexpr double kNotAdmissible = std::numeric_limits<double>::infinity();

bool isInWindow(const TwistWindow& window, const BodyTwist& twist) {
  return twist.linear >= window.lowLinear && twist.linear <= window.highLinear &&
         twist.angular >= window.lowAngular && twist.angular <= window.highAngular &&
         twist.lateral >= window.lowLateral && twist.lateral <= window.highLateral;
}

/// Of the centre [m/s].
double speedOf(const BodyTwist& twist) {
  return std::sqrt(twist.linear * twist.linear + twist.lateral * twist.lateral);
}

/// The dynamic window approach (Fox, Burgard & Thrun 1997). Velocities that the drive reaches in
/// time are tried; those after which it could not stop before it hits something are dropped; the
/// best of the rest is driven. In the place of the paper's smoothed objective stand the length of
/// the way that is left at the end of an arc (CostToGo; Ackermann: with the turning circle, by
/// relaxed Dubins curves), and a term for changes of the command: neither rounds a corner too early
/// nor gets stuck before people who stand.
///
/// People go on at constant velocity, as far as the arcs reach; that they might give way is not
/// counted on. When nothing is admissible the robot brakes and turns to where the way goes. When
/// it does not get on for a while it moves off a little and then passes closer (StuckWatch).
class Dwa : public Planner {
 public:
  Dwa(const RobotBody& body, const DwaParameters& parameters)
      : parameters_(parameters),
        body_(body),
        reach_(reachOf(body.footprint)),
        clear_(body, parameters.clearance),
        toGo_(inscribedRadius(body.footprint), reach_, parameters.margin),
        watch_(parameters.patience, parameters.reverseDistance),
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
    hasBegunToMoveOff_ = false;
    route_.update(observation, reach_, kRouteSight);
    if (route_.isEmpty() || (position - observation.goal).norm() <= observation.goalRadius) {
      last_ = {};
      return BodyTwist{};
    }
    toGo_.update(observation, route_, parameters_.standingSpeed, clear_.points());
    watch_.update(
        observation.time, position, observation.goal,
        restFrom(observation, observation.pose) + kTurnPrice * turnLeft(observation.pose));
    hasBegunToMoveOff_ = watch_.hasJustBegun();
    prepare(observation);
    last_ = best(observation);
    return last_;
  }

  std::vector<Vec2> path() const override { return route_.points(); }
  std::vector<Candidate> candidates() const override;
  bool takeReplanned() override {
    const bool isNew = route_.takeReplanned();
    return std::exchange(hasBegunToMoveOff_, false) || isNew;
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
  double costAtLeast(const Observation& observation, const BodyTwist& twist) const;
  double changeOf(const BodyTwist& twist) const;
  double slownessOf(const BodyTwist& twist) const;
  bool isShown(std::size_t sample) const;
  std::size_t endOf(const Observation& observation, const ClearanceAlong::Found& found) const;
  double restFrom(const Observation& observation, const Pose2& pose) const;
  double headingCost(const Observation& observation, const BodyTwist& twist, std::size_t end) const;
  bool isAdmissible(const ClearanceAlong::Way& way, const ClearanceAlong::Found& found,
                    const BodyTwist& twist) const;
  double movingOffCost(const BodyTwist& twist) const;
  double turnLeft(const Pose2& pose) const;
  double signedTurnLeft(const Pose2& pose) const;

  DwaParameters parameters_;
  RobotBody body_;
  double reach_;  // [m]
  RobotRoute route_;
  ClearanceAlong clear_;
  CostToGo toGo_;
  StuckWatch watch_;
  TwistSampler sampler_;
  std::vector<BodyTwist> twists_;
  std::vector<Sample> samples_;  // of the last call
  std::size_t chosen_ = 0;       // of them; their number: none
  std::vector<Pose2> poses_;     // of the arc at hand
  Pose2 pose_;                   // of the last call, for display
  BodyTwist motion_, last_;
  bool hasBegunToMoveOff_ = false;
};

double Dwa::signedTurnLeft(const Pose2& pose) const {
  const Vec2 way = toGo_.direction(pose.position);
  if (way.isZero(0.0)) {
    return 0.0;
  }
  const Vec2 ahead = base::directionOf(pose.heading);
  return base::atan2(base::cross(ahead, way), ahead.dot(way));
}

/// How far the robot must turn to face where the way goes [rad]; a car may as well drive backwards.
double Dwa::turnLeft(const Pose2& pose) const {
  const double turn = std::fabs(signedTurnLeft(pose));
  return body_.kinematics == Kinematics::Ackermann ? std::min(turn, base::kPi - turn) : turn;
}

/// The fastest that the goal, people ahead and the turn to come allow [m/s]: who can turn on the
/// spot does not drive away first.
double Dwa::speedLimit(const Observation& observation) const {
  double limit = body_.limits.maxVel;
  if (body_.kinematics == Kinematics::Differential) {
    limit *= std::max(kTurningShare, base::cos(turnLeft(observation.pose)));
  }
  if (clear_.gapAhead() < parameters_.slowDistance) {
    const double room = std::max(clear_.gapAhead(), 0.0) / parameters_.slowDistance;
    limit *= parameters_.slowShare + (1.0 - parameters_.slowShare) * room;
  }
  if (toGo_.endsHere()) {
    const double rest = toGo_.at(observation.pose.position);
    limit = std::min(limit, std::sqrt(2.0 * kDwaBrakeShare * body_.limits.maxAcc * rest));
  }
  return limit;
}

TwistWindow Dwa::windowNow(const Observation& observation) const {
  TwistWindow window =
      windowOf(body_, observation.motion, std::max(parameters_.window, observation.dt));
  const double limit = watch_.isMovingOff() ? kMoveOffSpeed : speedLimit(observation);
  window.highLinear = std::max(window.lowLinear, std::min(window.highLinear, limit));
  window.lowLinear = std::min(window.highLinear, std::max(window.lowLinear, -limit));
  window.highLateral = std::max(window.lowLateral, std::min(window.highLateral, limit));
  window.lowLateral = std::min(window.highLateral, std::max(window.lowLateral, -limit));
  const bool mayReverse = body_.kinematics != Kinematics::Differential || watch_.isMovingOff();
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
      stopTimeOf(body_, {fastest, limits.maxOmega}) + parameters_.window + parameters_.step;
  const double time = std::max(parameters_.horizon, stop);
  poses_.resize(1 + static_cast<std::size_t>(std::ceil(time / parameters_.step)));
  clear_.observe(observation, parameters_.margin * watch_.shareOfMargin(), std::sqrt(2.0) * fastest,
                 time);
}

/// The last pose of the arc that counts: before it hits anything, or where it has arrived.
std::size_t Dwa::endOf(const Observation& observation, const ClearanceAlong::Found& found) const {
  const auto end = static_cast<std::size_t>(std::min(found.wallStep, found.bodyStep)) - 1;
  if (!toGo_.endsHere()) {
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
  const double near = kArrivingShare * observation.goalRadius;
  return least <= near * near ? nearest : end;
}

/// The way that is left [m].
double Dwa::restFrom(const Observation& observation, const Pose2& pose) const {
  const double rest = toGo_.at(pose.position);
  const bool isThere = (pose.position - observation.goal).norm() <= observation.goalRadius;
  if (body_.kinematics != Kinematics::Ackermann || isThere) {
    return rest;
  }
  const double radius = kRadiusShare * std::max(body_.limits.turningRadius, 1e-3);
  const double turn = std::fabs(signedTurnLeft(pose));
  return std::min(relaxedDubinsLength(rest, turn, radius),
                  kDwaReversePrice * relaxedDubinsLength(rest, base::kPi - turn, radius));
}

/// The turn that is left where the robot would stand if it braked after this window.
double Dwa::headingCost(const Observation& observation, const BodyTwist& twist,
                        std::size_t end) const {
  const double stands = parameters_.window + 0.5 * stopTimeOf(body_, twist);
  const auto at = std::min(end, static_cast<std::size_t>(std::lround(stands / parameters_.step)));
  const Pose2& pose = poses_[at];
  const bool isThere = (pose.position - observation.goal).norm() <= observation.goalRadius;
  return isThere ? 0.0 : turnLeft(pose) / base::kPi;
}

/// Backwards; a car that has tried that goes forwards the next time.
double Dwa::movingOffCost(const BodyTwist& twist) const {
  const bool isForwards = body_.kinematics == Kinematics::Ackermann && watch_.tries() % 2 == 0;
  const double speed = isForwards ? twist.linear : -twist.linear;
  return 1.0 - std::clamp(speed / kMoveOffSpeed, -1.0, 1.0);
}

/// It can stop after this window, or, where somebody passes behind it, later. The first is the
/// paper's condition; with walls alone it is the weakest.
bool Dwa::isAdmissible(const ClearanceAlong::Way& way, const ClearanceAlong::Found& found,
                       const BodyTwist& twist) const {
  const double stopTime = stopTimeOf(body_, twist);
  const double meets = std::min(found.wallStep, found.bodyStep) * way.step;
  double hold = parameters_.window;
  bool canStop = clear_.canStop(way, found, hold, stopTime);
  while (!canStop && hold + kBetweenStops + 0.5 * stopTime < meets) {
    hold += kBetweenStops;
    canStop = clear_.canStop(way, found, hold, stopTime);
  }
  return canStop;
}

/// Of the command [share of the limits].
double Dwa::changeOf(const BodyTwist& twist) const {
  const DriveLimits& limits = body_.limits;
  return (std::fabs(twist.linear - last_.linear) + std::fabs(twist.lateral - last_.lateral)) /
             limits.maxVel +
         std::fabs(twist.angular - last_.angular) / limits.maxOmega;
}

/// What is missing to the full speed [share of it].
double Dwa::slownessOf(const BodyTwist& twist) const {
  const bool isBackwards = body_.kinematics != Kinematics::Omnidirectional && twist.linear < 0.0;
  return isBackwards ? 1.0 : 1.0 - std::min(1.0, speedOf(twist) / body_.limits.maxVel);
}

/// What this twist costs at least, known before its arc is: from where it gets to at most.
double Dwa::costAtLeast(const Observation& observation, const BodyTwist& twist) const {
  if (watch_.isMovingOff()) {
    return 0.0;
  }
  const BodyTwist change{twist.linear - motion_.linear, 0.0, twist.lateral - motion_.lateral};
  const double time = static_cast<double>(poses_.size() - 1) * parameters_.step;
  const double farthest = speedOf(twist) * time +
                          speedOf(change) * speedOf(change) / std::max(body_.limits.maxAcc, 1e-9);
  const DwaParameters& p = parameters_;
  return p.smoothnessWeight * changeOf(twist) + p.velocityWeight * slownessOf(twist) +
         p.goalWeight * toGo_.leastWithin(observation.pose.position, farthest) /
             (body_.limits.maxVel * p.horizon);
}

/// Infinite as well when it is more than `bound`.
double Dwa::costOf(const Observation& observation, const BodyTwist& twist, double bound) {
  rollOut(body_, observation.pose, observation.motion, twist, parameters_.step, poses_);
  const ClearanceAlong::Way way{poses_, parameters_.step,
                                std::max(speedOf(twist), speedOf(motion_))};
  const ClearanceAlong::Found found = clear_.along(way);
  const DwaParameters& p = parameters_;
  const std::size_t end = endOf(observation, found);
  const double room = std::clamp(found.gap / p.clearance, 0.0, 1.0);
  const double nearness = p.clearanceWeight * (1.0 - room) + p.smoothnessWeight * changeOf(twist);
  const bool isMovingOff = watch_.isMovingOff();
  const double slowness = isMovingOff ? movingOffCost(twist) : p.velocityWeight * slownessOf(twist);
  const double rest = isMovingOff ? 0.0
                                  : p.goalWeight * restFrom(observation, poses_[end]) /
                                        (body_.limits.maxVel * p.horizon);
  if (nearness + slowness + rest > bound || !isAdmissible(way, found, twist)) {
    return kNotAdmissible;
  }
  return nearness + p.headingWeight * headingCost(observation, twist, end) + slowness + rest;
}

/// Whether its arc will be shown, with its cost.
bool Dwa::isShown(std::size_t sample) const {
  const std::size_t stride = std::max<std::size_t>(1, twists_.size() / kDwaShownArcs);
  return sample % stride == stride / 2;
}

/// The last command, then the fastest ones first: with what they cost most others need no look.
BodyTwist Dwa::best(const Observation& observation) {
  constexpr double kRounding = 1e-9;
  const TwistWindow window = windowNow(observation);
  sampler_.sample(window, twists_);
  if (isInWindow(window, last_)) {  // what was safe to go on with is among them, to the bit
    twists_.push_back(last_);
  }
  double least = kNotAdmissible;
  chosen_ = twists_.size();
  samples_.resize(twists_.size());
  for (std::size_t i = twists_.size(); i-- > 0;) {
    const BodyTwist& twist = twists_[i];
    const double bound = isShown(i) ? kNotAdmissible : least + kRounding;
    const bool canBeBest = costAtLeast(observation, twist) <= bound;
    samples_[i] = {twist, canBeBest ? costOf(observation, twist, bound) : kNotAdmissible};
    if (samples_[i].cost <= least && samples_[i].cost < kNotAdmissible) {
      least = samples_[i].cost;
      chosen_ = i;
    }
  }
  return chosen_ < twists_.size() ? twists_[chosen_] : brake(observation);
}

/// Standing, and, where nothing can be hit by that, turning to where the way goes.
BodyTwist Dwa::brake(const Observation& observation) const {
  const bool stands = std::fabs(observation.motion.linear) < kDwaStanding &&
                      std::fabs(observation.motion.lateral) < kDwaStanding;
  if (!stands || !body_.footprint.isDisc() || body_.kinematics == Kinematics::Ackermann) {
    return {};
  }
  const double turn = signedTurnLeft(observation.pose);
  const double rate =
      std::min(body_.limits.maxOmega, std::sqrt(body_.limits.maxAlpha * std::fabs(turn)));
  return {0.0, std::copysign(rate, turn)};
}

std::vector<Candidate> Dwa::candidates() const {
  std::vector<Candidate> shown;
  std::vector<Pose2> poses(poses_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const bool isChosen = i == chosen_;
    if (!isShown(i) && !isChosen) {
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

/// Largest number of poses that one decision checks: along each arc, and during braking from each
/// moment at which it could begin.
double posesOf(const DwaParameters& parameters, double stopTime) {
  const double samples = parameters.linearSamples * parameters.angularSamples;
  const double along = std::max(parameters.horizon, stopTime) / parameters.step;
  const double braking = stopTime / kBetweenStops * stopTime / parameters.step;
  return samples * (along + braking);
}

base::Result<std::shared_ptr<Planner>> makeDwa(const PlannerSetup& setup) {
  constexpr double kMostPoses = 5e7;
  DwaParameters parameters;
  dwaTable().set(parameters, setup.parameters);
  const DriveLimits& limits = setup.body.limits;
  const double fastest = std::max(limits.maxVel, limits.maxReverse);
  const double stopTime = stopTimeOf(setup.body, {fastest, limits.maxOmega});
  const double poses = posesOf(parameters, stopTime);
  if (!(poses <= kMostPoses)) {
    const double samples = parameters.linearSamples * parameters.angularSamples;
    return base::error("planner.too-much-work", {std::round(poses), kMostPoses,
                                                 std::round(stopTime), parameters.step, samples});
  }
  return std::shared_ptr<Planner>(std::make_shared<Dwa>(setup.body, parameters));
}

}  // namespace

void addDwa(PlannerRegistry& to);
void addDwa(PlannerRegistry& to) {
  to.add("dwa", dwaTable().specs(), makeDwa,
         "Dynamic window (Fox, Burgard & Thrun 1997): weighs arcs that it can drive next.");
}

}  // namespace sim2d
