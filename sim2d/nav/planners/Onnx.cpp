#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/onnx/PolicyNetwork.h"

namespace sim2d {

namespace {

/// The problems with the names of robot and file in their texts: their place is that of the robot
/// in the scenario.
base::Diagnostics problemsOfPolicy(const std::string& robot, base::Diagnostics problems) {
  for (base::Diagnostic& problem : problems) {
    if (!problem.file.empty()) {
      const std::string file = std::exchange(problem.file, {});
      problem = base::withContext(file, std::move(problem));
    }
  }
  return withRobotName(robot, std::move(problems));
}

/// Drives by the actions of a network. Each one is held for the same time as in training.
class OnnxPlanner : public Planner {
 public:
  OnnxPlanner(const PlannerSetup& setup, std::unique_ptr<PolicyNetwork> network)
      : robot_(setup.robot),
        limits_(setup.body.limits),
        network_(std::move(network)),
        seen_(network_->metadata().sizes) {}

  bool readsScan() const override { return network_->metadata().sizes.beams > 0; }

  base::Result<BodyTwist> command(const Observation& observation) override {
    if (stepsLeft_ == 0) {
      seen_.fill(observation);
      const base::Result<std::vector<float>> action = network_->action(seen_);
      if (!action) {
        return problemsOfPolicy(robot_, action.diagnostics());
      }
      twist_ = clipped(*action);
      stepsLeft_ = stepsPerDecision(observation.dt);
    }
    --stepsLeft_;
    return twist_;
  }

 private:
  /// `dt`: of this world [s].
  int stepsPerDecision(double dt) const {
    const PolicyMetadata& trained = network_->metadata();
    return std::max(1, static_cast<int>(std::lround(trained.repeat * trained.dt / dt)));
  }

  BodyTwist clipped(const std::vector<float>& action) const {
    const auto clip = [&](std::size_t i, double low, double high) {
      return i < action.size() ? std::clamp(static_cast<double>(action[i]), low, high) : 0.0;
    };
    return {clip(0, -limits_.maxReverse, limits_.maxVel),
            clip(1, -limits_.maxOmega, limits_.maxOmega), clip(2, -limits_.maxVel, limits_.maxVel)};
  }

  const std::string robot_;
  const DriveLimits limits_;
  const std::unique_ptr<PolicyNetwork> network_;
  PolicyObservation seen_;
  BodyTwist twist_;
  int stepsLeft_ = 0;
};

std::vector<base::ParameterSpec> onnxSpecs() {
  return {fileSpec(
      "ONNX file of a policy that was trained with hunavsim.env, with its options as metadata; "
      "relative to the scenario.")};
}

/// Whether the robot has what the policy observes and commands.
base::Diagnostics bodyProblems(const PlannerSetup& setup, const PolicyMetadata& metadata,
                               const std::string& file) {
  base::Diagnostics problems;
  if (metadata.sizes.beams > 0 && !setup.hasLidar) {
    problems.push_back(base::error("onnx.no-lidar", {file, metadata.sizes.beams}));
  }
  if (metadata.actions > 2 && setup.body.kinematics != Kinematics::Omnidirectional) {
    problems.push_back(
        base::error("onnx.not-omnidirectional", {file, kinematicsName(setup.body.kinematics)}));
  }
  return withRobotName(setup.robot, problems);
}

base::Result<std::shared_ptr<Planner>> makeOnnx(const PlannerSetup& setup) {
  const std::string file = fileParameter(setup, kFileParameter);
  if (file.empty()) {
    return withRobotName(setup.robot, {base::error("onnx.no-file")});
  }
  base::Result<std::unique_ptr<PolicyNetwork>> network = readPolicyNetwork(file);
  if (!network) {
    return problemsOfPolicy(setup.robot, network.diagnostics());
  }
  const base::Diagnostics problems = bodyProblems(setup, (*network)->metadata(), file);
  if (!problems.empty()) {
    return problems;
  }
  return std::shared_ptr<Planner>(std::make_shared<OnnxPlanner>(setup, *std::move(network)));
}

}  // namespace

void addOnnx(PlannerRegistry& to);
void addOnnx(PlannerRegistry& to) {
  to.add(kOnnxPlanner, onnxSpecs(), makeOnnx,
         "Learned policy in an ONNX file, computed on the CPU by OpenCV.");
}

}  // namespace sim2d
