#include "sim2d/nav/mppi/MppiPlanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/nav/mppi/MppiUpdate.h"

namespace sim2d {
namespace {

// Lanes of the finalists; the remaining lanes also brake.
constexpr int kSmoothLane = 0, kMeanLane = 1, kBestLane = 2, kLastPlanLane = 3, kBrakeLane = 4;
static_assert(kMppiDraw == static_cast<std::uint32_t>(base::DrawPurpose::Mppi) << 24U);
constexpr int kShownSamples = 40;
constexpr int kShownStride = 4;  // steps between displayed points of a trajectory

}  // namespace

void MppiPlanner::Columns::resize(int samples, int steps) {
  count = samples;
  for (std::vector<float>& column : controls) {
    column.assign(static_cast<std::size_t>(samples) * static_cast<std::size_t>(steps), 0.0F);
  }
  costs.assign(static_cast<std::size_t>(samples), 0.0F);
  hits.assign(static_cast<std::size_t>(samples), 0.0F);
}

MppiSamples MppiPlanner::Columns::view() {
  MppiSamples samples;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    samples.controls[axis] = controls[axis].data();
  }
  samples.stride = count;
  samples.costs = costs.data();
  samples.hits = hits.data();
  return samples;
}

MppiPlanner::MppiPlanner(const PlannerSetup& setup, const MppiParameters& parameters,
                         std::optional<SocialMppiParameters> social, MppiSimdLevel path)
    : body_(setup.body),
      parameters_(parameters),
      social_(social),
      reach_(circumscribedRadius(setup.body.footprint)),
      discs_(discsCovering(setup.body.footprint)),
      kernel_(mppiKernelFor(path)) {
  problem_.steps = static_cast<int>(
      std::clamp(std::round(parameters_.steps), 2.0, static_cast<double>(kMaxMppiSteps)));
  problem_.dt = static_cast<float>(parameters_.modelDt);
  setNoise(setup.seed);
  problem_.noise.robot = static_cast<std::uint32_t>(setup.robotId);
  const double registers =
      std::ceil(std::max(parameters_.samples, 2.0 * kMppiColumns) / kMppiColumns);
  samples_.resize(static_cast<int>(registers) * kMppiColumns, problem_.steps);
  finalists_.resize(kMppiColumns, problem_.steps);
  weights_.resize(samples_.costs.size());
  scene_.firstPerson.resize(stepCount() + 1);
  setDrive();
  setCosts();
  setSocial();
  reset();
}

void MppiPlanner::setNoise(std::uint64_t seed) {
  problem_.noise.key[0] = static_cast<std::uint32_t>(seed);
  problem_.noise.key[1] = static_cast<std::uint32_t>(seed >> 32U);
}

void MppiPlanner::reseed(std::uint64_t seed) {
  setNoise(seed);
}

void MppiPlanner::reset() {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    plan_[axis].assign(stepCount(), 0.0F);
    lastCommands_[axis].fill(0.0F);
  }
  waitingSince_ = -1.0;
}

base::Result<BodyTwist> MppiPlanner::command(const Observation& observation) {
  start_ = observation.pose;
  // A long robot fits where its discs fit, because it aligns with the route first.
  route_.update(observation, static_cast<double>(discs_.front().radius), 1.0);
  if (route_.isEmpty()) {
    reset();
    samples_.hits.assign(samples_.hits.size(), 0.0F);
    return BodyTwist{};
  }
  for (std::vector<float>& axis : plan_) {
    axis = shifted(axis, observation.dt / parameters_.modelDt);
  }
  updateSurroundings(observation);
  setProblem(observation);
  fillProposals();
  sample();
  update();
  ++problem_.noise.call;
  return storePlan(take(finalists_, chosen_));
}

void MppiPlanner::setProblem(const Observation& observation) {
  const Vec2& origin = observation.pose.position;
  problem_.start.cosine = static_cast<float>(base::cos(observation.pose.heading));
  problem_.start.sine = static_cast<float>(base::sin(observation.pose.heading));
  problem_.start.linear = static_cast<float>(observation.motion.linear);
  problem_.start.angular = static_cast<float>(observation.motion.angular);
  problem_.start.lateral = static_cast<float>(observation.motion.lateral);
  problem_.costs.goalRadius = static_cast<float>(observation.goalRadius);
  problem_.clearance = clearance_.view(origin);
  problem_.distance = toGo_.view(origin);
  problem_.discs = discs_.data();
  problem_.discCount = static_cast<int>(discs_.size());
  problem_.people = scene_.people.data();
  problem_.firstPerson = scene_.firstPerson.data();
  problem_.zones = scene_.zones.data();
  problem_.zoneCount = static_cast<int>(scene_.zones.size());
  const std::array<double, kAxes> deviations = {static_cast<double>(problem_.noise.linear),
                                                static_cast<double>(problem_.noise.angular),
                                                static_cast<double>(problem_.noise.lateral)};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    mppiControlCost(plan_[axis], parameters_.gamma, deviations[axis],
                    static_cast<double>(problem_.noise.keep), controlCosts_[axis]);
    problem_.mean[axis] = plan_[axis].data();
    problem_.pull[axis] = controlCosts_[axis].data();
  }
}

/// Fills the first register of samples: the last plan, braking, and constant commands (arcs; for
/// omnidirectional robots directions).
void MppiPlanner::fillProposals() {
  put(plan_, 0, samples_);
  putConstant({0.0F, 0.0F, 0.0F}, 1, samples_);
  const auto fastest = static_cast<float>(body_.limits.maxVel);
  const float turning = problem_.drive.highAngular;
  int lane = 2;
  if (problem_.drive.isOmnidirectional) {
    for (; lane < kMppiColumns; ++lane) {
      const Vec2 way = base::directionOf(2.0 * base::kPi * (lane - 2) / (kMppiColumns - 2));
      putConstant(
          {fastest * static_cast<float>(way.x()), 0.0F, fastest * static_cast<float>(way.y())},
          lane, samples_);
    }
    return;
  }
  // A standing robot can turn in place; a car reverses instead.
  const float slowest = problem_.drive.isAckermann ? 0.5F * problem_.drive.lowLinear : 0.0F;
  for (const float speed : {slowest, 0.5F * fastest, fastest}) {
    for (const float share : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) {
      const bool isBraking = speed == slowest && share == 0.0F;
      if (!isBraking) {
        putConstant({speed, share * turning, 0.0F}, lane, samples_);
        ++lane;
      }
    }
  }
}

void MppiPlanner::sample() {
  const MppiSamples columns = samples_.view();
  kernel_.weigh(problem_, columns, 0, kMppiColumns);
  kernel_.draw(problem_, columns, kMppiColumns, samples_.count);
}

void MppiPlanner::update() {
  mppiWeights(samples_.costs.data(), samples_.count, parameters_.temperature, weights_.data());
  Sequence mean;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    mean[axis].resize(stepCount());
    for (std::size_t step = 0; step < stepCount(); ++step) {
      const std::size_t at = step * static_cast<std::size_t>(samples_.count);
      mean[axis][step] =
          kernel_.sum(weights_.data(), samples_.controls[axis].data() + at, samples_.count);
    }
  }
  Sequence smooth;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    smooth[axis] = savitzkyGolay(mean[axis], lastCommands_[axis]);
  }
  choose(mean, smooth);
}

/// The smoothed mean, unless another finalist is cheaper by more than the temperature.
void MppiPlanner::choose(const Sequence& mean, const Sequence& smooth) {
  const auto least = std::min_element(samples_.costs.begin(), samples_.costs.end());
  const auto best = static_cast<int>(least - samples_.costs.begin());
  put(smooth, kSmoothLane, finalists_);
  put(mean, kMeanLane, finalists_);
  put(take(samples_, best), kBestLane, finalists_);
  put(plan_, kLastPlanLane, finalists_);
  for (int lane = kBrakeLane; lane < kMppiColumns; ++lane) {
    putConstant({0.0F, 0.0F, 0.0F}, lane, finalists_);
  }
  kernel_.weigh(problem_, finalists_.view(), 0, kMppiColumns);
  chosen_ = kSmoothLane;
  auto cost = finalists_.costs[kSmoothLane] - static_cast<float>(parameters_.temperature);
  for (int lane = kMeanLane; lane <= kBrakeLane; ++lane) {
    if (finalists_.costs[static_cast<std::size_t>(lane)] < cost) {
      cost = finalists_.costs[static_cast<std::size_t>(lane)];
      chosen_ = lane;
    }
  }
}

void MppiPlanner::put(const Sequence& sequence, int lane, Columns& columns) const {
  const std::size_t axes = problem_.drive.isOmnidirectional ? kAxes : kAxes - 1;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (std::size_t step = 0; step < stepCount(); ++step) {
      columns.controls[axis][step * static_cast<std::size_t>(columns.count) +
                             static_cast<std::size_t>(lane)] = sequence[axis][step];
    }
  }
}

void MppiPlanner::putConstant(const std::array<float, kAxes>& control, int lane,
                              Columns& columns) const {
  Sequence sequence;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    sequence[axis].assign(stepCount(), control[axis]);
  }
  put(sequence, lane, columns);
}

MppiPlanner::Sequence MppiPlanner::take(const Columns& columns, int lane) const {
  Sequence sequence;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    sequence[axis].reserve(stepCount());
    for (std::size_t step = 0; step < stepCount(); ++step) {
      sequence[axis].push_back(
          columns.controls[axis][step * static_cast<std::size_t>(columns.count) +
                                 static_cast<std::size_t>(lane)]);
    }
  }
  return sequence;
}

BodyTwist MppiPlanner::storePlan(const Sequence& plan) {
  plan_ = plan;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    std::rotate(lastCommands_[axis].begin(), lastCommands_[axis].begin() + 1,
                lastCommands_[axis].end());
    lastCommands_[axis].back() = plan[axis].front();
  }
  return {static_cast<double>(plan[0].front()), static_cast<double>(plan[1].front()),
          static_cast<double>(plan[2].front())};
}

std::vector<Vec2> MppiPlanner::trajectoryPoints(const Columns& columns, int lane) const {
  const Sequence sequence = take(columns, lane);
  Pose2 pose = start_;
  std::vector<Vec2> points;
  points.reserve(stepCount() / kShownStride + 2);
  points.push_back(pose.position);
  for (std::size_t step = 0; step < stepCount(); ++step) {
    const double half = 0.5 * parameters_.modelDt * static_cast<double>(sequence[1][step]);
    const Vec2 way = parameters_.modelDt * Vec2(static_cast<double>(sequence[0][step]),
                                                static_cast<double>(sequence[2][step]));
    pose.heading = base::wrapToPi(pose.heading + half);
    pose.position = pose.toWorld(way);
    pose.heading = base::wrapToPi(pose.heading + half);
    if (step % kShownStride == kShownStride - 1 || step + 1 == stepCount()) {
      points.push_back(pose.position);
    }
  }
  return points;
}

std::vector<Vec2> MppiPlanner::path() const {
  return route_.isEmpty() ? std::vector<Vec2>{} : trajectoryPoints(finalists_, chosen_);
}

std::vector<Candidate> MppiPlanner::candidates() const {
  std::vector<Candidate> shown;
  if (route_.isEmpty()) {
    return shown;
  }
  const auto add = [&](const Columns& columns, int lane, bool isChosen) {
    const auto at = static_cast<std::size_t>(lane);
    const double cost = columns.hits[at] > 0.0F ? std::numeric_limits<double>::infinity()
                                                : static_cast<double>(columns.costs[at]);
    shown.push_back({trajectoryPoints(columns, lane), cost, isChosen});
  };
  shown.reserve(kShownSamples + 1);
  const int stride = std::max(1, samples_.count / kShownSamples);
  for (int lane = 0; lane < samples_.count && shown.size() < kShownSamples; lane += stride) {
    add(samples_, lane, false);
  }
  add(finalists_, chosen_, true);
  return shown;
}

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
