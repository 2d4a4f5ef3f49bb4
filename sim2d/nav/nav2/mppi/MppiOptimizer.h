#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/mppi/MppiCritics.h"
#include "sim2d/nav/nav2/mppi/MppiSequence.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"
#include "sim2d/nav/nav2/mppi/TrajectoryColumns.h"

namespace sim2d::nav2 {

/// What an optimiser needs beside its parameters.
struct MppiOptimizerSetup {
  double period = 0.05;    // of the controller [s]
  std::uint64_t seed = 1;  // of the noise
  int robotId = -1;        // with the seed: whose draws
  MppiPath path = fastestMppiPath();
};

/// The optimiser of Nav2's MPPI (nav2_mppi_controller, optimizer.cpp): adds noise to the last
/// sequence of controls many times, rolls the trajectories out, prices them by the critics, takes
/// the mean of the controls weighted by exp(-cost / temperature). Noise is drawn by counter, so
/// equal calls in the same order give equal commands on every processor. Thread: one at a time.
class MppiOptimizer {
 public:
  /// `mppi` is one that `readMppi` gave; the period is no longer than model_dt.
  MppiOptimizer(const MppiConfiguration& mppi, const MppiOptimizerSetup& setup);

  /// The command, in [m/s], [rad/s]; nothing: every trajectory collides, or the optimal one does
  /// (NoValidControl).
  std::optional<BodyTwist> command(const MppiScene& scene);
  /// Forgets the sequence, what was sent and the noise.
  void reset();
  void setSpeedLimit(double limit, bool isPercentage);

  bool isShifting() const { return isShifting_; }
  const MppiSequence& sequence() const { return sequence_; }
  /// Of the last call: where the optimal sequence leads, from the first step on.
  const Path& optimal() const { return optimal_; }
  const TrajectoryColumns& trajectories() const { return columns_; }
  const std::vector<float>& costs() const { return costs_; }      // by sample, with gamma's share
  const std::vector<float>& weights() const { return weights_; }  // by sample; sum 1
  const MppiCritics& critics() const { return critics_; }

 private:
  void setRoll();
  void drawNoise();
  void begin(const MppiScene& scene);
  bool findOptimal(const MppiScene& scene);
  MppiControl startSpeed(const MppiScene& scene) const;
  void optimize(const MppiScene& scene);
  void roll();
  void updateSequence();
  void limitUntilJazzy();
  void filterAndLimit();
  bool isOptimalValid(const MppiScene& scene) const;
  void keepSent();
  bool isHolonomic() const { return mppi_.motion == MppiMotion::Omni; }
  bool isMain() const { return mppi_.distro >= Distro::Lyrical; }
  std::size_t sentIndex() const { return isShifting_ ? 1 : 0; }
  float firstDt() const;

  const MppiConfiguration mppi_;
  const float dt_, period_;  // [s]
  const bool isShifting_;
  const TrajectoryKernel kernel_;
  const MppiLimits base_;
  MppiLimits limits_;
  MppiCritics critics_;
  MppiRetries retries_;
  MppiNoise noise_;
  RollProblem roll_;
  TrajectoryColumns columns_;
  std::vector<float> costs_, weights_;
  MppiSequence sequence_;
  std::array<MppiControl, 4> sent_{};  // latest last
  MppiControl lastCommand_{}, speed_{};
  Path optimal_;
};

}  // namespace sim2d::nav2
