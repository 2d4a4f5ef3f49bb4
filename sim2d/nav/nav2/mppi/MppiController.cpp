#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/mppi/MppiOptimizer.h"

namespace sim2d::nav2 {
namespace {

constexpr int kShownTrajectories = 40;
constexpr int kPoseStride = 4;  // steps between poses of a displayed trajectory

PathPruning mppiPruning(const MppiConfiguration& mppi) {
  PathPruning pruning;
  pruning.rule = PathPruning::Rule::AlongPath;
  pruning.searchDistance = mppi.settings.searchDistance;
  pruning.pruneDistance = mppi.settings.pruneDistance;
  pruning.keepsLastTwo = includesDistro(kJazzy | kKilted, mppi.distro);
  pruning.enforcesInversion = mppi.settings.enforcesInversion;
  pruning.inversionXyTolerance = mppi.settings.inversionXyTolerance;
  pruning.inversionYawTolerance = mppi.settings.inversionYawTolerance;
  return pruning;
}

bool isListed(const MppiConfiguration& mppi, const std::string& critic) {
  const auto& critics = mppi.settings.critics;
  return std::find(critics.begin(), critics.end(), critic) != critics.end();
}

bool usesFootprint(const MppiConfiguration& mppi) {
  const MppiCriticSettings& critics = mppi.critics;
  return (critics.cost.considersFootprint && isListed(mppi, "CostCritic")) ||
         (critics.obstacles.considersFootprint && isListed(mppi, "ObstaclesCritic"));
}

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

base::Result<std::unique_ptr<Controller>> makeMppiController(const ControllerSetup& setup) {
  auto mppi = readMppi(setup.block, setup.distro);
  if (!mppi) {
    return mppi.diagnostics();
  }
  base::Diagnostics problems = mppi.diagnostics();
  const double period = 1.0 / setup.frequency;
  const double modelDt = mppi->settings.modelDt;
  switch (mppiShiftOf(period, modelDt)) {
    case MppiShift::Refused:
      return base::error("nav2.mppi-period", {period, "model_dt", modelDt});
    case MppiShift::Keeps:
      problems.push_back(base::warning("nav2.mppi-no-shift", {period, "model_dt", modelDt}));
      break;
    case MppiShift::Shifts:
      break;
  }
  MppiOptimizerSetup optimizer;
  optimizer.period = period;
  optimizer.seed = setup.seed;
  optimizer.robotId = setup.robotId;
  return {std::make_unique<MppiController>(*mppi, optimizer), std::move(problems)};
}

}  // namespace

MppiController::MppiController(const MppiConfiguration& mppi, const MppiOptimizerSetup& setup)
    : mppi_(mppi), optimizer_(mppi, setup), handler_(mppiPruning(mppi)) {}

void MppiController::setPlan(const Path& plan) {
  handler_.setPlan(plan);
  if (!plan.empty()) {
    goal_ = plan.back();
  }
}

LocalPlan MppiController::localPlan(const ControlInput& input) {
  if (input.localPlan == nullptr) {
    return handler_.localPlan(input);
  }
  LocalPlan local;
  local.poses = *input.localPlan;
  if (local.poses.empty()) {
    local.problem = "Resulting plan has 0 poses in it.";
  }
  return local;
}

/// Humble resets after a period without calls.
void MppiController::resetWhenLate(double time) {
  const bool isLate = lastTime_ && time - *lastTime_ > mppi_.settings.resetPeriod;
  if (mppi_.distro == Distro::Humble && isLate) {
    optimizer_.reset();
  }
  lastTime_ = time;
}

ControlResult MppiController::computeVelocityCommands(const ControlInput& input) {
  resetWhenLate(input.time);
  view_ = {};
  if (input.shape.isRadius && usesFootprint(mppi_)) {  // Nav2 does not start
    return {ControllerError::InvalidController,
            "Considering footprint in collision checking but no robot footprint provided in the "
            "costmap."};
  }
  LocalPlan local = localPlan(input);
  if (local.problem != nullptr) {
    return {ControllerError::InvalidPath, local.problem};
  }
  view_.localPlan = std::move(local.poses);
  const Pose2 goal = input.fromPlan(goal_);
  const MppiScene scene{input.robot,
                        input.speed,
                        view_.localPlan,
                        goal,
                        input.costmap,
                        input.shape,
                        input.goalChecker.xyTolerance()};
  const auto command = optimizer_.command(scene);
  view_.predicted = optimizer_.optimal();
  if (const auto& furthest = optimizer_.critics().furthest()) {
    view_.lookahead = {view_.localPlan[static_cast<std::size_t>(*furthest)].position};
  }
  if (isWatched()) {
    showTrajectories();
  }
  if (!command) {
    return {ControllerError::NoValidControl, "Optimizer fail to compute path"};
  }
  return *command;
}

void MppiController::setSpeedLimit(double limit, bool isPercentage) {
  optimizer_.setSpeedLimit(limit, isPercentage);
}

void MppiController::reset() {
  if (mppi_.distro != Distro::Humble) {
    optimizer_.reset();
  }
}

void MppiController::showTrajectories() {
  const int count = optimizer_.trajectories().count();
  const int stride = std::max(1, count / kShownTrajectories);
  for (int i = 0; i < kShownTrajectories && i * stride < count; ++i) {
    view_.trajectories.push_back(shownTrajectory(i * stride));
  }
  if (!view_.predicted.empty()) {
    view_.trajectories.push_back(shownOptimal());
  }
}

EvaluatedTrajectory MppiController::shownTrajectory(int sample) const {
  const TrajectoryBuffer& columns = optimizer_.trajectories();
  const MppiCritics& critics = optimizer_.critics();
  const auto at = static_cast<std::size_t>(sample);
  EvaluatedTrajectory shown;
  for (int step = 0; step < columns.steps(); ++step) {
    const std::size_t place = columns.elementIndex(step, sample);
    if (step % kPoseStride == 0 || step + 1 == columns.steps()) {
      shown.poses.push_back(
          {Vec2(static_cast<double>(columns.x[place]), static_cast<double>(columns.y[place])),
           base::wrapToPi(static_cast<double>(columns.yaw[place]))});
    }
  }
  const std::size_t first = columns.elementIndex(0, sample);
  shown.twist = {static_cast<double>(columns.controls[0][first]),
                 static_cast<double>(columns.controls[1][first]),
                 static_cast<double>(columns.controls[2][first])};
  for (std::size_t i = 0; i < critics.names().size(); ++i) {
    const double score = static_cast<double>(critics.scores(i)[at]);
    shown.scores.push_back({critics.names()[i], score, critics.wasEvaluated(i) ? 1.0 : 0.0});
    shown.total += score;
  }
  if (critics.hits()[at] > 0.0F) {
    shown.rejection = "Trajectory collides";
  }
  return shown;
}

/// The optimal trajectory; its scores are the weighted means over all trajectories.
EvaluatedTrajectory MppiController::shownOptimal() const {
  const MppiCritics& critics = optimizer_.critics();
  const std::vector<float>& weights = optimizer_.weights();
  EvaluatedTrajectory shown;
  shown.isChosen = true;
  shown.poses = view_.predicted;
  for (std::size_t i = 0; i < critics.names().size(); ++i) {
    double mean = 0.0;
    for (std::size_t sample = 0; sample < weights.size(); ++sample) {
      mean += static_cast<double>(weights[sample]) * static_cast<double>(critics.scores(i)[sample]);
    }
    shown.scores.push_back({critics.names()[i], mean, critics.wasEvaluated(i) ? 1.0 : 0.0});
    shown.total += mean;
  }
  return shown;
}

ControllerType mppiController() {
  return {"nav2_mppi_controller::MPPIController", mppiKeysOf, makeMppiController};
}

}  // namespace sim2d::nav2
