#include "sim2d/nav/Localization.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/nav/Observation.h"

namespace sim2d {
namespace {

// Draw indices of one correction.
constexpr std::uint32_t kPlace = 0;
constexpr std::uint32_t kYaw = 1;
constexpr std::uint32_t kJumpAge = 2;
constexpr std::uint32_t kJumpDirection = 3;
constexpr std::uint32_t kJumpSide = 4;
constexpr std::uint32_t kGlobalPlace = 5;
constexpr std::uint32_t kGlobalYaw = 6;

double clampDeviations(double deviations) {
  return std::clamp(deviations, -kMaxDeviations, kMaxDeviations);
}

/// exp(-time / tau); with tau = 0 the result is 0 for any time > 0.
double decay(double time, double tau) {
  if (tau > 0.0) {
    return base::exp(-time / tau);
  }
  return time > 0.0 ? 0.0 : 1.0;
}

}  // namespace

bool LocalizationParameters::isRandom() const {
  const bool hasJumps = jumpRate > 0.0 && (jumpDistance > 0.0 || jumpYaw > 0.0);
  return stdX > 0.0 || stdY > 0.0 || stdYaw > 0.0 || hasJumps;
}

bool LocalizationParameters::isExact() const {
  return !isRandom() && startX == 0.0 && startY == 0.0 && startYaw == 0.0;
}

void LocalizationError::advanceTo(std::int64_t number) {
  while (number_ < number) {
    ++number_;
    step();
  }
}

/// z' = a z + sqrt(1 - a²) n with a = exp(-T / tau) and n of standard deviation 1.
void LocalizationError::step() {
  const LocalizationParameters& p = parameters_;
  const base::AgentRng random(seed_, robotId_, static_cast<std::uint64_t>(number_));
  const std::array<double, 2> place = random.normalPair(base::DrawPurpose::Localization, kPlace);
  const std::array<double, 3> noise{place[0], place[1],
                                    random.normal(0.0, 1.0, base::DrawPurpose::Localization, kYaw)};
  if (number_ == 0) {
    process_ = noise;
    transient_ = {p.startX, p.startY, p.startYaw};
  } else {
    const double interval = 1.0 / p.rate;
    const double kept = decay(interval, p.correlationTime);
    const double fresh = std::sqrt((1.0 - kept) * (1.0 + kept));
    for (std::size_t i = 0; i < process_.size(); ++i) {
      process_[i] = kept * process_[i] + fresh * noise[i];
    }
    decayBy(kept);
    sampleJump(interval);
  }
  if (isRelocalizing_) {
    drawGlobalPose();
    isRelocalizing_ = false;
  }
  value_ = {p.stdX * clampDeviations(process_[0]) + jump_.x + transient_.x,
            p.stdY * clampDeviations(process_[1]) + jump_.y + transient_.y,
            p.stdYaw * clampDeviations(process_[2]) + jump_.yaw + transient_.yaw};
}

void LocalizationError::decayBy(double factor) {
  for (Value* const each : {&jump_, &transient_}) {
    *each = {factor * each->x, factor * each->y, factor * each->yaw};
  }
}

/// The time since the last event of a Poisson process has the distribution 1 - exp(-rate t).
void LocalizationError::sampleJump(double interval) {
  const LocalizationParameters& p = parameters_;
  if (!(p.jumpRate > 0.0)) {
    return;
  }
  const base::AgentRng random(seed_, robotId_, static_cast<std::uint64_t>(number_));
  const double share = random.uniform01(base::DrawPurpose::Localization, kJumpAge);
  const double age = -base::log(1.0 - share) / p.jumpRate;
  if (age >= interval) {
    return;
  }
  const double direction =
      random.uniform(-base::kPi, base::kPi, base::DrawPurpose::Localization, kJumpDirection);
  const bool isLeft = random.uniform01(base::DrawPurpose::Localization, kJumpSide) < 0.5;
  const double left = decay(age, p.correlationTime);
  const Vec2 jump = left * p.jumpDistance * base::directionOf(direction);
  jump_ = {jump.x(), jump.y(), isLeft ? left * p.jumpYaw : -left * p.jumpYaw};
}

void LocalizationError::drawGlobalPose() {
  const base::AgentRng random(seed_, robotId_, static_cast<std::uint64_t>(number_));
  const std::array<double, 2> place =
      random.normalPair(base::DrawPurpose::Localization, kGlobalPlace);
  const double yaw = random.normal(0.0, 1.0, base::DrawPurpose::Localization, kGlobalYaw);
  transient_ = {parameters_.globalStd * clampDeviations(place[0]),
                parameters_.globalStd * clampDeviations(place[1]),
                parameters_.globalStdYaw * clampDeviations(yaw)};
}

void Localizer::update(const Pose2& truth, const Pose2& odometry, double time) {
  constexpr double kRounding = 1e-6;  // [s]
  const double since = time - parameters_.initialPoseTime;
  if (since < -kRounding) {
    return;
  }
  const std::int64_t number = std::max<std::int64_t>(eventIndexAt(since, parameters_.rate), 0);
  if (number <= error_.number() && !needsCorrection_) {
    return;
  }
  error_.advanceTo(number);
  const LocalizationError::Value& error = error_.value();
  Pose2 estimate = truth;
  if (error.x != 0.0 || error.y != 0.0 || error.yaw != 0.0) {
    estimate.position += Vec2(error.x, error.y);
    estimate.heading = base::wrapToPi(truth.heading + error.yaw);
  }
  mapToOdom_ = frameBetween(estimate, odometry);
  isLocalized_ = true;
  needsCorrection_ = false;
}

void Localizer::relocalize() {
  if (canRelocalize()) {
    error_.relocalize();
  }
}

Odometry::Odometry(const OdometryParameters& parameters, std::uint64_t seed, int robotId,
                   const Pose2& start)
    : parameters_(parameters), seed_(seed), robotId_(robotId), truth_(start), pose_(start) {}

void Odometry::reset(const Pose2& truth) {
  truth_ = truth;
  pose_ = truth;
  motion_ = {};
}

/// `turn` [rad] of the step, `way` [m] in the frame rotated by half of it, in which an arc leads
/// straight ahead. So rot1 and rot2 are half of the turn each. Unlike the book's version, which
/// takes the direction of translation for the heading, this also holds for backward and sideways
/// motion.
Odometry::Error Odometry::sampledError(double turn, const Vec2& way, std::uint64_t step) const {
  const double rot = 0.5 * std::fabs(turn);
  const double trans = way.norm();
  const double rotDeviation = std::sqrt(parameters_.alpha1 * rot + parameters_.alpha2 * trans);
  const double transDeviation =
      std::sqrt(parameters_.alpha3 * trans + parameters_.alpha4 * 2.0 * rot);
  const double drift = 0.5 * parameters_.headingDrift * way.x();
  const base::AgentRng random(seed_, robotId_, step);
  Error error;
  error.rot1 = random.normal(drift, rotDeviation, base::DrawPurpose::Odometry, 0);
  error.trans = random.normal(0.0, transDeviation, base::DrawPurpose::Odometry, 1);
  error.rot2 = random.normal(drift, rotDeviation, base::DrawPurpose::Odometry, 2);
  return error;
}

void Odometry::advance(const Pose2& truth, const BodyTwist& motion, double dt, std::uint64_t step) {
  assert(dt > 0.0);
  const Pose2 before = truth_;
  truth_ = truth;
  if (parameters_.isExact()) {
    pose_ = truth;
    motion_ = motion;
    return;
  }
  const double turn = base::angleDiff(truth.heading, before.heading);
  const Pose2 middle{before.position, before.heading + 0.5 * turn};
  const Vec2 way = middle.toLocal(truth.position);
  const Error error = sampledError(turn, way, step);
  const double length = way.norm();
  const Vec2 along = length > 0.0 ? Vec2(way / length) : Vec2(1.0, 0.0);
  const Vec2 wayError = error.trans * along;
  const double rot1 = 0.5 * turn + error.rot1;
  const double rot2 = 0.5 * turn + error.rot2;
  pose_.position = Pose2{pose_.position, pose_.heading + rot1}.toWorld(way + wayError);
  pose_.heading = base::wrapToPi(pose_.heading + rot1 + rot2);
  motion_.linear = motion.linear + wayError.x() / dt;
  motion_.lateral = motion.lateral + wayError.y() / dt;
  motion_.angular = motion.angular + (error.rot1 + error.rot2) / dt;
}

}  // namespace sim2d
