#include "sim2d/nav/nav2/mppi/MppiOptimizer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim2d/nav/mppi/MppiUpdate.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

MppiControl controlOf(const BodyTwist& twist) {
  return {toFloat(twist.linear), toFloat(twist.angular), toFloat(twist.lateral)};
}

/// The random stream of a robot.
MppiNoise noiseOf(const MppiOptimizerSetup& setup) {
  MppiNoise noise;
  noise.key[0] = static_cast<std::uint32_t>(setup.seed);
  noise.key[1] = static_cast<std::uint32_t>(setup.seed >> 32U);
  noise.robot = static_cast<std::uint32_t>(setup.robotId);
  return noise;
}

}  // namespace

MppiOptimizer::MppiOptimizer(const MppiConfiguration& mppi, const MppiOptimizerSetup& setup)
    : mppi_(mppi),
      dt_(toFloat(mppi.settings.modelDt)),
      period_(toFloat(setup.period)),
      isShifting_(mppiShiftOf(setup.period, mppi.settings.modelDt) == MppiShift::Shifts),
      kernel_(trajectoryKernelOf(setup.path)),
      base_(mppiLimitsOf(mppi.settings)),
      limits_(base_),
      critics_(mppi, kernel_),
      retries_(mppi.settings.retryAttemptLimit),
      noise_(noiseOf(setup)),
      columns_(mppi.settings.batchSize, mppi.settings.timeSteps) {
  weights_.assign(columns_.length.size(), 0.0F);
  setRollout();
  reset();
}

void MppiOptimizer::setRollout() {
  const MppiSettings& settings = mppi_.settings;
  const MppiControl deviations = {toFloat(settings.vxStd), toFloat(settings.wzStd),
                                  toFloat(settings.vyStd)};
  rollout_.dt = dt_;
  rollout_.isHolonomic = isHolonomic();
  rollout_.isLimited = mppi_.distro != Distro::Humble;
  rollout_.writesLimitedControls =
      includesDistro(kJazzy | kKilted, mppi_.distro) || (isMain() && settings.clampsRawControls);
  for (std::size_t axis = 0; axis < kTrajectoryAxes; ++axis) {
    const float variance = deviations[axis] * deviations[axis];
    rollout_.least[axis] = dt_ * base_.least[axis];
    rollout_.most[axis] = dt_ * base_.most[axis];
    rollout_.controlCost[axis] = variance > 0.0F ? toFloat(settings.gamma) / variance : 0.0F;
  }
  if (isMain()) {
    const double delays[] = {settings.vxDelay, settings.wzDelay, settings.vyDelay};
    for (std::size_t axis = 0; axis < kTrajectoryAxes; ++axis) {
      const double steps = std::round(delays[axis] / settings.modelDt);
      rollout_.delay[axis] = static_cast<int>(std::min<double>(steps, settings.timeSteps));
    }
  }
}

void MppiOptimizer::drawNoise() {
  const MppiControl deviations = {toFloat(mppi_.settings.vxStd), toFloat(mppi_.settings.wzStd),
                                  toFloat(mppi_.settings.vyStd)};
  kernel_.draw(noise_, deviations.data(), isHolonomic() ? 3 : 2, columns_.view());
  ++noise_.call;
}

void MppiOptimizer::reset() {
  for (std::vector<float>& controls : sequence_) {
    controls.assign(static_cast<std::size_t>(columns_.steps()), 0.0F);
  }
  sentCommands_ = {};
  lastCommand_ = {};
  costs_.assign(columns_.length.size(), 0.0F);
  if (mppi_.distro == Distro::Humble) {
    limits_ = base_;
  }
  if (!mppi_.settings.regeneratesNoises) {
    drawNoise();
  }
}

void MppiOptimizer::setSpeedLimit(double limit, bool isPercentage) {
  limits_ = withSpeedLimit(base_, limit, isPercentage);
}

std::optional<BodyTwist> MppiOptimizer::command(const MppiScene& scene) {
  begin(scene);
  if (!findOptimal(scene)) {
    optimal_.clear();
    return std::nullopt;
  }
  if (!isMain()) {
    if (filterSequence(sequence_, sentCommands_, 2)) {
      recordSentCommand();
    }
    optimal_ = integratePath(scene.robot, sequence_, mppi_.settings.modelDt);
  }
  const std::size_t at = sentIndex();
  lastCommand_ = {sequence_[0][at], sequence_[1][at], sequence_[2][at]};
  if (isShifting_) {
    shiftByOne(sequence_);
  }
  return BodyTwist{static_cast<double>(lastCommand_[0]), static_cast<double>(lastCommand_[1]),
                   static_cast<double>(lastCommand_[2])};
}

/// When every trajectory collides, Nav2 retries with the failure flag still set, so that critics
/// are skipped and the retries fail too. These retries are omitted here.
bool MppiOptimizer::findOptimal(const MppiScene& scene) {
  auto next = MppiRetries::Next::Retry;
  while (next == MppiRetries::Next::Retry) {
    optimize(scene);
    const bool isWeighed = std::isfinite(weights_.front());  // false if the costs overflow a float
    if (critics_.hasFailed() || !isWeighed) {
      retries_ = MppiRetries(mppi_.settings.retryAttemptLimit);
      reset();
      return false;
    }
    bool isValid = true;
    if (isMain()) {
      optimal_ = integratePath(scene.robot, sequence_, mppi_.settings.modelDt);
      isValid = isOptimalValid(scene);
    }
    next = retries_.after(!isValid);
    if (!isValid) {
      reset();
    }
  }
  return next == MppiRetries::Next::Done;
}

/// Resets the costs, the failure flag and the path state, which all iterations of a cycle share.
void MppiOptimizer::begin(const MppiScene& scene) {
  speed_ = startSpeed(scene);
  if (!isHolonomic()) {
    speed_[2] = 0.0F;
  }
  rollout_.x = toFloat(scene.robot.position.x());
  rollout_.y = toFloat(scene.robot.position.y());
  rollout_.yaw = toFloat(scene.robot.heading);
  std::copy(speed_.begin(), speed_.end(), rollout_.speed);
  std::fill(costs_.begin(), costs_.end(), 0.0F);
  critics_.begin(scene);
}

/// Main: the last command, limited to what the robot can have reached.
MppiControl MppiOptimizer::startSpeed(const MppiScene& scene) const {
  const MppiControl measured = controlOf(scene.speed);
  if (mppi_.settings.isOpenLoop && mppi_.distro != Distro::Humble) {
    return lastCommand_;
  }
  if (!isMain()) {
    return measured;
  }
  MppiControl speed{};
  for (std::size_t axis = 0; axis < speed.size(); ++axis) {
    speed[axis] =
        reachable(lastCommand_[axis], measured[axis], base_.least[axis], base_.most[axis], period_);
  }
  return speed;
}

void MppiOptimizer::optimize(const MppiScene& scene) {
  for (int iteration = 0; iteration < mppi_.settings.iterationCount; ++iteration) {
    roll();
    critics_.score(scene, columns_, costs_);
    updateSequence();
  }
}

float MppiOptimizer::firstDt() const {
  return isShifting_ ? 0.0F : period_;
}

void MppiOptimizer::roll() {
  if (mppi_.settings.regeneratesNoises) {
    drawNoise();
  }
  if (isMain()) {
    limitFirstToSpeed(sequence_, limits_, speed_, firstDt());
  }
  for (std::size_t axis = 0; axis < kTrajectoryAxes; ++axis) {
    rollout_.mean[axis] = sequence_[axis].data();
  }
  kernel_.roll(rollout_, columns_.view());
}

void MppiOptimizer::updateSequence() {
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    costs_[i] += columns_.controlCost[i];
  }
  mppiWeights(costs_.data(), columns_.count(), mppi_.settings.temperature, weights_.data());
  const int axes = isHolonomic() ? 3 : 2;
  for (int axis = 0; axis < axes; ++axis) {
    kernel_.mean(columns_.view(), weights_.data(), axis,
                 sequence_[static_cast<std::size_t>(axis)].data());
  }
  if (isMain()) {
    filterAndLimit();
  } else {
    limitUntilJazzy();
  }
}

void MppiOptimizer::limitUntilJazzy() {
  limitChanges(sequence_, limits_, dt_, mppi_.distro != Distro::Humble);
  if (mppi_.motion == MppiMotion::Ackermann) {
    limitTurningRadius(sequence_, limits_.turningRadius);
  }
}

void MppiOptimizer::filterAndLimit() {
  const bool isAckermann = mppi_.motion == MppiMotion::Ackermann;
  if (filterSequence(sequence_, sentCommands_, mppi_.settings.sgfOrder)) {
    recordSentCommand();
  }
  if (isAckermann) {
    limitTurningRadius(sequence_, limits_.turningRadius);
  }
  limitChangesFromSpeed(sequence_, limits_, speed_, firstDt(), dt_);
  if (isAckermann) {
    limitTurningRadius(sequence_, limits_.turningRadius);
  }
}

void MppiOptimizer::recordSentCommand() {
  const std::size_t at = sentIndex();
  std::rotate(sentCommands_.begin(), sentCommands_.begin() + 1, sentCommands_.end());
  sentCommands_.back() = {sequence_[0][at], sequence_[1][at], sequence_[2][at]};
}

/// Main's validator: checks the first poses of the optimal trajectory; poses off the map are valid.
bool MppiOptimizer::isOptimalValid(const MppiScene& scene) const {
  const MppiSettings& settings = mppi_.settings;
  const double steps = std::floor(settings.collisionLookahead / settings.modelDt + 1e-9);
  const auto count = static_cast<std::size_t>(std::min<double>(steps, settings.timeSteps));
  return std::none_of(optimal_.begin(), optimal_.begin() + static_cast<std::ptrdiff_t>(count),
                      [&](const Pose2& pose) {
                        const auto cell = scene.costmap.worldToCell(pose.position);
                        if (!cell) {
                          return false;
                        }
                        if (settings.validatesFootprint) {
                          return footprintCost(scene.costmap, scene.shape.vertices, pose) ==
                                 kLethal;
                        }
                        const std::uint8_t cost = scene.costmap.at(*cell);
                        return cost == kInscribed || cost == kLethal;
                      });
}

}  // namespace sim2d::nav2
