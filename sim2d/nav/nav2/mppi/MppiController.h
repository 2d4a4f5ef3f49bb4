#pragma once

#include <optional>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/mppi/MppiOptimizer.h"

namespace sim2d::nav2 {

/// nav2_mppi_controller::MPPIController: prunes the path and calls the optimizer.
class MppiController final : public Controller {
 public:
  MppiController(const MppiConfiguration& mppi, const MppiOptimizerSetup& setup);

  void setPlan(const Path& plan) override;
  ControlResult computeVelocityCommands(const ControlInput& input) override;
  void setSpeedLimit(double limit, bool isPercentage) override;
  void reset() override;

 private:
  LocalPlan localPlan(const ControlInput& input);
  void resetWhenLate(double time);
  void showTrajectories();
  EvaluatedTrajectory shownTrajectory(int sample) const;
  EvaluatedTrajectory shownOptimal() const;

  const MppiConfiguration mppi_;
  MppiOptimizer optimizer_;
  PathHandler handler_;  // until Jazzy
  Pose2 goal_;
  std::optional<double> lastTime_;  // [s]
};

}  // namespace sim2d::nav2
