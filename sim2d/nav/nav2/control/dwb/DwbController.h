#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"
#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"

namespace sim2d::nav2 {

/// dwb_core::DWBLocalPlanner: tries velocities, rolls each out and takes the cheapest by the sum of
/// its critics.
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
    double frequency = 20.0;  // of the controller server [Hz]
  };
  explicit DwbController(Setup setup);

  void setPlan(const Path& plan) override;
  Control computeVelocityCommands(const ControlInput& input) override;
  void setSpeedLimit(double limit, bool isPercentage) override;

  const DwbParameters& parameters() const { return parameters_; }  // with the speed limit

 private:
  struct Best {
    float total = -1.0F;  // as in dwb_msgs/TrajectoryScore; below 0: none yet
    DwbTrajectory trajectory;
  };
  void prepare(const ControlInput& input, const Path& plan, const Pose2& goal);
  bool weigh(const DwbTrajectory& trajectory, float best, float& total);
  void choose();
  void show(const DwbTrajectory& trajectory, float total, std::size_t asked, const char* refusal);

  DwbParameters parameters_;
  DwbParameters fullParameters_;  // without a speed limit
  std::vector<NamedCritic> critics_;
  TrajectoryGenerator generator_;
  PathHandler handler_;
  Pose2 goal_;  // end of the whole path
  MapGrid pathGrid_, goalGrid_;
  std::vector<float> scales_;  // of the critics in this cycle
  std::vector<float> raws_;    // of the trajectory that is weighed
  Best best_;
  DwbTrajectory tried_;
};

}  // namespace sim2d::nav2
