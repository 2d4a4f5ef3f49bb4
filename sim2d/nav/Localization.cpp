#include "sim2d/nav/Localization.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/nav/SensedWorld.h"

namespace sim2d {
namespace {

// Indices of the draws of one correction.
constexpr std::uint32_t kPlace = 0;
constexpr std::uint32_t kYaw = 1;
constexpr std::uint32_t kJumpAge = 2;
constexpr std::uint32_t kJumpDirection = 3;
constexpr std::uint32_t kJumpSide = 4;
constexpr std::uint32_t kGlobalPlace = 5;
constexpr std::uint32_t kGlobalYaw = 6;

double cut(double deviations) {
  return std::clamp(deviations, -kMostDeviations, kMostDeviations);
}

/// exp(-time / tau); without a correlation nothing is left after any time.
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

/// z' = a z + sqrt(1 - a²) n with a = exp(-T / tau) and n of deviation 1.
void LocalizationError::step() {
  const LocalizationParameters& p = parameters_;
  const base::AgentRng random(seed_, robotId_, static_cast<std::uint64_t>(number_));
  const std::array<double, 2> place = random.normalPair(base::Draw::Localization, kPlace);
  const std::array<double, 3> noise{place[0], place[1],
                                    random.normal(0.0, 1.0, base::Draw::Localization, kYaw)};
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
    jumpWithin(interval);
  }
  if (isRelocalizing_) {
    drawGlobal();
    isRelocalizing_ = false;
  }
  value_ = {p.stdX * cut(process_[0]) + jump_.x + transient_.x,
            p.stdY * cut(process_[1]) + jump_.y + transient_.y,
            p.stdYaw * cut(process_[2]) + jump_.yaw + transient_.yaw};
}

void LocalizationError::decayBy(double factor) {
  for (Value* const each : {&jump_, &transient_}) {
    *each = {factor * each->x, factor * each->y, factor * each->yaw};
  }
}

/// The time since the last event of a Poisson process has the distribution 1 - exp(-rate t).
void LocalizationError::jumpWithin(double interval) {
  const LocalizationParameters& p = parameters_;
  if (!(p.jumpRate > 0.0)) {
    return;
  }
  const base::AgentRng random(seed_, robotId_, static_cast<std::uint64_t>(number_));
  const double share = random.uniform01(base::Draw::Localization, kJumpAge);
  const double age = -base::log(1.0 - share) / p.jumpRate;
  if (age >= interval) {
    return;
  }
  const double direction =
      random.uniform(-base::kPi, base::kPi, base::Draw::Localization, kJumpDirection);
  const bool isLeft = random.uniform01(base::Draw::Localization, kJumpSide) < 0.5;
  const double left = decay(age, p.correlationTime);
  const Vec2 jump = left * p.jumpDistance * base::directionOf(direction);
  jump_ = {jump.x(), jump.y(), isLeft ? left * p.jumpYaw : -left * p.jumpYaw};
}

void LocalizationError::drawGlobal() {
  const base::AgentRng random(seed_, robotId_, static_cast<std::uint64_t>(number_));
  const std::array<double, 2> place = random.normalPair(base::Draw::Localization, kGlobalPlace);
  const double yaw = random.normal(0.0, 1.0, base::Draw::Localization, kGlobalYaw);
  transient_ = {parameters_.globalStd * cut(place[0]), parameters_.globalStd * cut(place[1]),
                parameters_.globalStdYaw * cut(yaw)};
}

void Localizer::update(const Pose2& truth, const Pose2& odometry, double time) {
  constexpr double kRounding = 1e-6;  // [s]
  const double since = time - parameters_.initialPoseTime;
  if (since < -kRounding) {
    return;
  }
  const std::int64_t number = std::max<std::int64_t>(eventAt(since, parameters_.rate), 0);
  if (number <= error_.number() && !mustCorrect_) {
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
  mustCorrect_ = false;
}

void Localizer::relocalize() {
  if (canRelocalize()) {
    error_.relocalize();
  }
}

}  // namespace sim2d
