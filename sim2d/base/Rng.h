#pragma once

#include <array>
#include <cstdint>

/// Random numbers by counter: a draw is a function of (seed, agent, step, purpose, index) and of
/// nothing else. Philox4x32-10 (Salmon et al. 2011).
namespace base {

std::array<std::uint32_t, 4> philox4x32(const std::array<std::uint32_t, 4>& counter,
                                        const std::array<std::uint32_t, 2>& key);

/// What a draw is for; part of the counter, so the numbers may not change once published.
enum class Draw : std::uint32_t {
  Parameter = 1,   // index = number of the parameter
  NodeChance = 2,  // index = node of the tree
  Source = 3,      // arrivals of an area
  Placement = 4,   // area fill, brush
  GoalChoice = 5,
  Sensor = 6,  // of no use any more: each sensor has its own
  Test = 7,
  Odometry = 8,
  Lidar = 9,  // index = sensor and pair of beams; of a person: where a stride begins
  Detector = 10,
  Mppi = 11,
  Variation = 12,     // of a scenario, between the runs of a batch
  Bootstrap = 13,     // step = resample, index = place in it
  Value = 14,         // of an experiment, between its seeds
  Localization = 15,  // step = correction
};

class AgentRng {
 public:
  AgentRng(std::uint64_t seed, int agentId, std::uint64_t step = 0)
      : seed_(seed), agentId_(agentId), step_(step) {}

  std::uint32_t bits(Draw purpose, std::uint32_t index = 0) const;
  double uniform01(Draw purpose, std::uint32_t index = 0) const;  // [0, 1), 53 bits
  double uniform(double low, double high, Draw purpose,
                 std::uint32_t index = 0) const;  // [low, high)
  double normal(double mean, double deviation, Draw purpose, std::uint32_t index = 0) const;
  /// Two independent draws of mean 0 and deviation 1 for little more than one; the first is that of
  /// `normal` with the same address.
  std::array<double, 2> normalPair(Draw purpose, std::uint32_t index = 0) const;

 private:
  struct Polar {
    double radius, angle;
  };
  std::array<std::uint32_t, 4> block(Draw purpose, std::uint32_t index) const;
  Polar normalInPlane(Draw purpose, std::uint32_t index) const;

  std::uint64_t seed_;
  int agentId_;
  std::uint64_t step_;
};

}  // namespace base
