#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim2d/base/Math.h"
#include "sim2d/nav/mppi/MppiPlanner.h"

/// The part of MppiPlanner that converts parameters, walls and people into the kernel's problem.
namespace sim2d {
namespace {

constexpr double kIntimateGap = 0.45, kPersonalGap = 1.2;  // gaps [m], Hall 1966
constexpr double kSocialRange = 3.6;                       // [m], end of Hall's social zone
constexpr double kStripHalfWidth = 0.8;                    // [m], beside a walking line
constexpr double kPassingGap = 0.6;                        // [m], gap needed for passing
constexpr double kPersonWidth = 0.7;                       // [m]
constexpr double kPassingClearance = 0.3;                  // [m], in a narrow place
constexpr double kAckermannReverseFactor = 0.2;  // factor on the reversing cost of car-like robots
constexpr double kWindowMargin = 0.5;            // [m]
constexpr double kMaxWindowHalfSize = 12.0;      // [m]

float squareOfInverse(double value) {
  return static_cast<float>(1.0 / (value * value));
}

}  // namespace

void MppiPlanner::setDrive() {
  const DriveLimits& limits = body_.limits;
  const double dt = parameters_.modelDt;
  MppiDrive& drive = problem_.drive;
  drive.isOmnidirectional = body_.kinematics == Kinematics::Omnidirectional;
  drive.isAckermann = body_.kinematics == Kinematics::Ackermann;
  drive.lowLinear = static_cast<float>(-limits.maxReverse);
  drive.highLinear = static_cast<float>(limits.maxVel);
  drive.highAngular = static_cast<float>(limits.maxOmega);
  drive.highLateral = drive.isOmnidirectional ? static_cast<float>(limits.maxVel) : 0.0F;
  drive.linearStep = static_cast<float>(limits.maxAcc * dt);
  drive.angularStep = static_cast<float>(limits.maxAlpha * dt);
  drive.lateralStep = drive.isOmnidirectional ? drive.linearStep : 0.0F;
  drive.mostCurvature = static_cast<float>(1.0 / std::max(limits.turningRadius, 1e-3));
  MppiNoise& noise = problem_.noise;
  noise.linear = static_cast<float>(parameters_.linearNoise);
  noise.angular = static_cast<float>(parameters_.angularNoise);
  noise.lateral = static_cast<float>(parameters_.lateralNoise);
  const double keep = parameters_.noiseTime > 0.0 ? base::exp(-dt / parameters_.noiseTime) : 0.0;
  noise.keep = static_cast<float>(keep);
  noise.fresh = static_cast<float>(std::sqrt(1.0 - keep * keep));
}

void MppiPlanner::setCosts() {
  const MppiParameters& p = parameters_;
  const bool turnsToDrive = !problem_.drive.isOmnidirectional;
  MppiCosts& costs = problem_.costs;
  costs.goal = static_cast<float>(p.goal);
  costs.end = static_cast<float>(p.end);
  costs.heading = turnsToDrive ? static_cast<float>(p.heading) : 0.0F;
  const double backs = problem_.drive.isAckermann ? kAckermannReverseFactor : 1.0;
  costs.reverse = turnsToDrive ? static_cast<float>(p.reverse * backs) : 0.0F;
  costs.stop = static_cast<float>(p.stop);
  costs.wall = static_cast<float>(p.wall);
  costs.perWallRange = static_cast<float>(1.0 / p.wallRange);
  costs.person = static_cast<float>(p.person);
  costs.hit = static_cast<float>(p.hit);
  const double dt = p.modelDt;
  const auto change = static_cast<float>(p.smoothness) * squareOfInverse(body_.limits.maxAcc * dt);
  costs.changeLinear = change;
  costs.changeLateral = problem_.drive.isOmnidirectional ? change : 0.0F;
  costs.changeAngular =
      static_cast<float>(p.smoothness) * squareOfInverse(body_.limits.maxAlpha * dt);
}

void MppiPlanner::setSocial() {
  problem_.isSocial = social_.has_value();
  if (!social_) {
    return;
  }
  MppiSocial& social = problem_.social;
  social.intimate = static_cast<float>(social_->intimate);
  social.perIntimate = static_cast<float>(1.0 / kIntimateGap);
  social.personal = static_cast<float>(social_->personal);
  social.perPersonal = static_cast<float>(1.0 / kPersonalGap);
  social.space = static_cast<float>(social_->space);
  social.touchTime = static_cast<float>(social_->touchTime);
  social.fromTouchTime = static_cast<float>(social_->fromTouchTime);
  social.relativeSpeed = static_cast<float>(social_->relativeSpeed);
  social.strip = static_cast<float>(social_->strip);
  social.perStripWidth = static_cast<float>(1.0 / kStripHalfWidth);
  social.legible = static_cast<float>(social_->legibility);
  social.perPass = static_cast<float>(1.0 / kPassingGap);
  social.perLegible = static_cast<float>(1.0 / kSocialRange);
}

void MppiPlanner::updateSurroundings(const Observation& observation) {
  const double fastest = std::max(body_.limits.maxVel, body_.limits.maxReverse) *
                         (problem_.drive.isOmnidirectional ? std::sqrt(2.0) : 1.0);
  const double travel = fastest * parameters_.modelDt * problem_.steps;
  const double half = std::min(travel + reach_ + kWindowMargin, kMaxWindowHalfSize);
  const auto discRadius = static_cast<double>(discs_.front().radius);
  clearance_.update(observation, half);
  scene_.people.clear();
  scene_.zones.clear();
  MppiRanges ranges;
  ranges.robotRadius = discRadius;
  ranges.reach = reach_;
  ranges.margin = parameters_.personMargin;
  ranges.range = parameters_.personRange;
  ranges.comfortRange = social_ ? kSocialRange : 0.0;
  ranges.stripTime = social_ ? social_->stripTime : 1.0;
  ranges.speed = fastest;
  const std::vector<PredictedBody> bodies = predictedBodies(observation);
  const double room = discRadius + (social_ ? kIntimateGap : parameters_.personMargin);
  std::vector<SlowDisc> discs = standingBodies(bodies, room);
  if (social_) {
    addGroups(bodies, observation.pose.position, social_->group, scene_.zones);
    for (const MppiZone& zone : scene_.zones) {
      const Vec2 centre(static_cast<double>(zone.x), static_cast<double>(zone.y));
      discs.push_back({centre + observation.pose.position,
                       1.0 / std::sqrt(static_cast<double>(zone.perRadius2))});
    }
    addWaitingZone(observation, bodies);
  }
  toGo_.update(observation, route_.points(), half, discRadius, clearance_, discs);
  addBodies(bodies, observation.pose.position, parameters_.modelDt, ranges, scene_);
}

std::vector<PredictedBody> MppiPlanner::predictedBodies(const Observation& observation) const {
  // Beyond this range no body can come near the robot within the plan.
  const double time = parameters_.modelDt * problem_.steps;
  const double range = (body_.limits.maxVel + 2.0) * time + reach_ + kSocialRange;
  std::vector<PredictedBody> bodies = bodiesNear(observation, range);
  if (social_ && social_->prediction > 0.5) {
    predictSocial(bodies, predictedRobot(observation), problem_.steps, parameters_.modelDt,
                  clearance_);
  } else {
    predictConstant(bodies, problem_.steps, parameters_.modelDt);
  }
  return bodies;
}

/// Motion of the robot along its last plan, for predicting the others.
PredictedBody MppiPlanner::predictedRobot(const Observation& observation) const {
  PredictedBody robot;
  robot.now.kind = BodyKind::Robot;
  robot.now.position = observation.pose.position;
  robot.now.radius = reach_;
  robot.now.velocity =
      observation.pose.toWorld(Vec2(observation.motion.linear, observation.motion.lateral)) -
      observation.pose.position;
  Pose2 pose = observation.pose;
  robot.positions.reserve(stepCount());
  robot.velocities.reserve(stepCount());
  for (std::size_t step = 0; step < stepCount(); ++step) {
    const Vec2 velocity(static_cast<double>(plan_[0][step]), static_cast<double>(plan_[2][step]));
    pose.heading =
        base::wrapToPi(pose.heading + parameters_.modelDt * static_cast<double>(plan_[1][step]));
    const Vec2 next = pose.toWorld(parameters_.modelDt * velocity);
    robot.velocities.emplace_back((next - pose.position) / parameters_.modelDt);
    robot.positions.push_back(next);
    pose.position = next;
  }
  return robot;
}

/// Adds a zone at a narrow place through which a person comes, until the patience time is over.
void MppiPlanner::addWaitingZone(const Observation& observation,
                                 const std::vector<PredictedBody>& bodies) {
  const Vec2& position = observation.pose.position;
  const double width = 2.0 * reach_ + kPersonWidth + kPassingClearance;
  const NarrowPlace place = narrowPlaceAhead(route_, position, *observation.obstacles, width);
  const bool isTaken =
      place.isFound && std::any_of(bodies.begin(), bodies.end(), [&](const PredictedBody& body) {
        return isComingThrough(body.now, place);
      });
  if (!isTaken) {
    waitingSince_ = -1.0;
    return;
  }
  if (waitingSince_ < 0.0) {
    waitingSince_ = observation.time;
  }
  if (observation.time - waitingSince_ < social_->patienceTime) {
    const Vec2 middle = place.position - position;
    scene_.zones.push_back({static_cast<float>(middle.x()), static_cast<float>(middle.y()),
                            squareOfInverse(social_->waitDistance),
                            static_cast<float>(social_->patience)});
  }
}

}  // namespace sim2d
