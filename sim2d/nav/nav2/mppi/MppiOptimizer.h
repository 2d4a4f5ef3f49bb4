#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/mppi/MppiCritics.h"
#include "sim2d/nav/nav2/mppi/MppiSequence.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"

namespace sim2d::nav2 {

/// Inputs of the optimizer apart from its parameters.
struct MppiOptimizerSetup {
  double period = 0.05;    // controller period [s]
  std::uint64_t seed = 1;  // of the noise
  int robotId = -1;        // selects the random stream, together with the seed
  MppiSimdLevel path = fastestMppiSimdLevel();
};

/// The optimizer of Nav2's MPPI (nav2_mppi_controller, optimizer.cpp): samples control sequences
/// around the last one, simulates their trajectories, scores them by the critics, and averages the
/// controls with weights exp(-cost / temperature). Noise is counter-based, so equal calls in the
/// same order give equal commands on every processor. Not thread-safe.
class MppiOptimizer {
 public:
  /// Preconditions: `mppi` was returned by `readMppi`; the period is not longer than model_dt.
  MppiOptimizer(const MppiConfiguration& mppi, const MppiOptimizerSetup& setup);

  /// The command in [m/s], [rad/s]; nullopt if every trajectory or the optimal one collides
  /// (NoValidControl).
  std::optional<BodyTwist> command(const MppiScene& scene);
  /// Clears the sequence and the command history, and regenerates the noise.
  void reset();
  void setSpeedLimit(double limit, bool isPercentage);

  const MppiSequence& sequence() const { return sequence_; }
  /// Results of the last call. The trajectory of the optimal sequence, beginning after the first
  /// step.
  const Path& optimal() const { return optimal_; }
  const TrajectoryBuffer& trajectories() const { return columns_; }
  const std::vector<float>& costs() const { return costs_; }      // by sample, with gamma
  const std::vector<float>& weights() const { return weights_; }  // by sample; sum 1
  const MppiCritics& critics() const { return critics_; }

 private:
  void setRollout();
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
  void recordSentCommand();
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
  RolloutProblem rollout_;
  TrajectoryBuffer columns_;
  std::vector<float> costs_, weights_;
  MppiSequence sequence_;
  std::array<MppiControl, 4> sentCommands_{};  // latest command last
  MppiControl lastCommand_{}, speed_{};
  Path optimal_;
};

}  // namespace sim2d::nav2
