#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "sim2d/nav/PolicyObservation.h"
#include "sim2d/world/World.h"

/// Many copies of a scenario for reinforcement learning: robots receive velocity commands, and the
/// observations, rewards and ends of all copies are written into contiguous arrays.
namespace python {

/// Weights of the reward of one step; the reward is the sum of weight * term.
struct RewardWeights {
  double arrival = 10.0;     // 1 on arrival at the last goal
  double collision = -10.0;  // 1 on contact with a person, robot or obstacle
  double progress = 1.0;     // [m] by which the distance to the goal has decreased
  double closeness = -1.0;   // [m s] (personalDistance - gap) * dt for the nearest person
  double time = -0.05;       // [s] dt
  double jerk = 0.0;         // [m/s] absolute change of the commanded speed
};

struct EnvironmentOptions {
  std::size_t count = 1;            // copies of the scenario
  std::vector<std::string> robots;  // names of the robots that are driven; empty: the first one
  std::size_t people = 16;          // rows of the nearest people in an observation
  int beams = 180;                  // of the lidar; 0: none
  std::size_t gridCells = 0;        // side length of the occupancy grid in cells; 0: none
  double gridResolution = 0.1;      // [m]
  double duration = 60.0;           // of an episode [s]
  int repeat = 1;                   // steps of the world per action
  double personalDistance = 1.2;    // [m], see RewardWeights::closeness
  std::uint64_t seed = 1;
  RewardWeights weights;
};

constexpr std::size_t kPersonColumns = sim2d::kPolicyPersonColumns;
constexpr std::size_t kStateColumns = sim2d::kPolicyStateColumns;

/// Observations of all robots of all copies (PolicyObservation.h); robot r of copy c is row c *
/// robots + r.
struct Observations {
  std::vector<float> state;   // rows x kStateColumns
  std::vector<float> people;  // rows x people x kPersonColumns; nearest first, then zeros
  std::vector<float> lidar;   // rows x beams [m]
  std::vector<float> grid;    // rows x gridCells x gridCells: 1 occupied; x ahead, y left
};

enum class EpisodeEnd : std::uint8_t { None, Arrived, Collided, TimedOut };

/// One thread at a time. Equal options and actions give equal bytes.
class CrowdEnvironment {
 public:
  /// `bundle`: a scenario that can be run. Throws std::invalid_argument for an unknown robot.
  CrowdEnvironment(app::Bundle bundle, EnvironmentOptions options);
  ~CrowdEnvironment();
  CrowdEnvironment(const CrowdEnvironment&) = delete;
  CrowdEnvironment& operator=(const CrowdEnvironment&) = delete;
  CrowdEnvironment(CrowdEnvironment&&) = delete;
  CrowdEnvironment& operator=(CrowdEnvironment&&) = delete;

  /// Problems of the scenario; with errors there are no episodes.
  const base::Diagnostics& problems() const { return problems_; }
  std::size_t count() const { return options_.count; }
  std::size_t robots() const { return options_.robots.size(); }
  const EnvironmentOptions& options() const { return options_; }
  const sim2d::RobotBody& body(std::size_t robot) const { return bodies_[robot]; }
  double dt() const { return dt_; }

  /// Starts a new episode in all copies; episode e of copy c has a seed that depends on `seed`, c
  /// and e only.
  void reset(std::uint64_t seed);
  /// Applies one command per row: forward speed, turn rate and, for omnidirectional robots, lateral
  /// speed [m/s], [rad/s]; `columns` is 2 or 3. A copy whose episode has ended starts a new one
  /// instead, with reward 0.
  void step(const float* actions, std::size_t columns);

  const Observations& observations() const { return observations_; }
  const std::vector<double>& rewards() const { return rewards_; }  // per row
  const std::vector<EpisodeEnd>& ends() const { return ends_; }    // per row, of the last step
  const std::vector<std::int64_t>& episodes() const { return episodes_; }  // per copy, from 0

 private:
  struct Copy;
  void start(std::size_t copy);
  void advance(std::size_t copy, const float* actions, std::size_t columns);
  void observe(std::size_t copy);
  void observePeople(Copy& of, std::size_t robot, std::size_t row);
  void observeLidar(const Copy& of, std::size_t robot, std::size_t row);
  void observeGrid(const Copy& of, std::size_t robot, std::size_t row);
  double rewardOf(Copy& of, std::size_t robot, double speed);
  void noteEvents(Copy& of);
  std::uint64_t seedOf(std::size_t copy) const;

  app::Bundle bundle_;
  EnvironmentOptions options_;
  base::Diagnostics problems_;
  std::vector<std::size_t> indices_;  // of the driven robots among those of the frames
  std::vector<sim2d::RobotBody> bodies_;
  double dt_ = 0.05;  // [s]
  std::vector<std::unique_ptr<Copy>> copies_;
  Observations observations_;
  std::vector<double> rewards_;
  std::vector<EpisodeEnd> ends_;
  std::vector<std::int64_t> episodes_;
};

}  // namespace python
