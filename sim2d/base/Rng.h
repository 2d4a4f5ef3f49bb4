#pragma once

#include <array>
#include <cstdint>

/// Counter-based random numbers: a draw depends only on (seed, agent, step, purpose, index).
/// Philox4x32-10 (Salmon et al. 2011).
namespace base {

std::array<std::uint32_t, 4> philox4x32(const std::array<std::uint32_t, 4>& counter,
                                        const std::array<std::uint32_t, 2>& key);

/// Purpose of a draw. It is part of the counter, so published numbers must not change.
enum class DrawPurpose : std::uint32_t {
  Parameter = 1,   // index = number of the parameter
  NodeChance = 2,  // index = node of the tree
  Source = 3,      // arrivals of an area
  Placement = 4,   // area fill, brush
  GoalChoice = 5,
  Sensor = 6,  // unused: each sensor has its own purpose
  Test = 7,
  Odometry = 8,
  Lidar = 9,  // index = sensor and pair of beams; of a person: phase of the stride
  Detector = 10,
  Mppi = 11,
  Variation = 12,     // of a scenario, between the runs of a batch
  Bootstrap = 13,     // step = resample, index = position in it
  Value = 14,         // of an experiment, between its seeds
  Localization = 15,  // step = correction
  Design = 16,        // step = point of a design, agent = dimension
  DesignOrder = 17,   // agent = dimension, index = place in the permutation
  Optimizer = 18,     // of CMA-ES: agent = run, step = generation, index = point and coordinate
  Restart = 19,       // of CMA-ES: agent = run, index = coordinate of its first mean
  Search = 20,        // of a search for failures: step = number of the draw
  Audit = 21,         // of runs that are repeated, index = place in the sample
};

class AgentRng {
 public:
  AgentRng(std::uint64_t seed, int agentId, std::uint64_t step = 0)
      : seed_(seed), agentId_(agentId), step_(step) {}

  std::uint32_t bits(DrawPurpose purpose, std::uint32_t index = 0) const;
  double uniform01(DrawPurpose purpose, std::uint32_t index = 0) const;  // [0, 1), 53 bits
  double uniform(double low, double high, DrawPurpose purpose,
                 std::uint32_t index = 0) const;  // [low, high)
  double normal(double mean, double deviation, DrawPurpose purpose, std::uint32_t index = 0) const;
  /// Two independent standard normal draws at little more than the cost of one. The first equals
  /// `normal(0.0, 1.0, purpose, index)`.
  std::array<double, 2> normalPair(DrawPurpose purpose, std::uint32_t index = 0) const;

 private:
  struct Polar {
    double radius, angle;
  };
  std::array<std::uint32_t, 4> block(DrawPurpose purpose, std::uint32_t index) const;
  Polar normalInPlane(DrawPurpose purpose, std::uint32_t index) const;

  std::uint64_t seed_;
  int agentId_;
  std::uint64_t step_;
};

}  // namespace base
