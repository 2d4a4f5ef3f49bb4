#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"
#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"

namespace sim2d::nav2 {

/// dwb_core::DWBLocalPlanner: samples velocities, simulates each trajectory and selects the one
/// with the lowest sum of critic scores.
class DwbController final : public Controller {
 public:
  struct NamedCritic {
    std::string name;  // as in the list `critics`
    std::unique_ptr<DwbCritic> critic;
  };
  struct Setup {
    DwbParameters parameters;
    std::vector<NamedCritic> critics;
    TrajectoryGenerator::Kind generator = TrajectoryGenerator::Kind::Standard;
    Distro distro = Distro::Jazzy;
    double frequency = 20.0;  // controller_frequency [Hz]
  };
  explicit DwbController(Setup setup);

  void setPlan(const Path& plan) override;
  ControlResult computeVelocityCommands(const ControlInput& input) override;
  void setSpeedLimit(double limit, bool isPercentage) override;

  const DwbParameters& parameters() const { return parameters_; }  // with the speed limit applied

 private:
  struct Best {
    float total = -1.0F;  // as in dwb_msgs/TrajectoryScore; negative: none yet
    DwbTrajectory trajectory;
  };
  void prepare(const ControlInput& input, const Path& plan, const Pose2& goal);
  bool canWin(const DwbTrajectory& trajectory) const;
  bool evaluate(const DwbTrajectory& trajectory, float best, float& total);
  void selectBest();
  void recordTrajectory(const DwbTrajectory& trajectory, float total, std::size_t evaluated,
                        const char* rejection);

  DwbParameters parameters_;
  DwbParameters fullParameters_;  // without a speed limit
  std::vector<NamedCritic> critics_;
  TrajectoryGenerator generator_;
  PathHandler handler_;
  Pose2 goal_;  // end of the complete path
  MapGrid pathGrid_, goalGrid_;
  std::vector<float> scales_;     // of the critics in this cycle
  std::vector<float> rawScores_;  // of the trajectory being evaluated
  Best best_;
  DwbTrajectory candidate_;
};

}  // namespace sim2d::nav2
