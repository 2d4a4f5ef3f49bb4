#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/base/Registry.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotRoute.h"
#include "sim2d/nav/mppi/MppiGrids.h"
#include "sim2d/nav/mppi/MppiKernel.h"
#include "sim2d/nav/mppi/MppiScene.h"

namespace sim2d {

/// Parameters of the planners `mppi` and `social_mppi`; units and sources are in the tables.
struct MppiParameters {
  double samples = 2000.0;
  double steps = 56.0;
  double modelDt = 0.05;
  double temperature = 0.3;
  double gamma = 0.015;
  double linearNoise = 0.2;
  double angularNoise = 0.4;
  double lateralNoise = 0.2;
  double noiseTime = 0.3;
  double goal = 5.0;
  double end = 2.0;
  double heading = 3.0;
  double reverse = 15.0;
  double stop = 10.0;
  double wall = 8.0;
  double wallRange = 0.3;
  double person = 4.0;
  double personRange = 0.6;
  double personMargin = 0.1;
  double hit = 1000.0;
  double smoothness = 0.3;
};

base::ParameterTable<MppiParameters> mppiTable();

/// Weights of the comfort costs.
struct SocialMppiParameters {
  MppiParameters mppi;
  double prediction = 1.0;
  double intimate = 6.0;
  double personal = 4.0;
  double space = 3.0;
  double touchTime = 2.0;
  double fromTouchTime = 3.0;
  double relativeSpeed = 1.0;
  double strip = 3.0;
  double stripTime = 2.0;
  double group = 6.0;
  double legibility = 1.0;
  double patience = 40.0;
  double patienceTime = 15.0;
  double waitDistance = 1.2;
};

base::ParameterTable<SocialMppiParameters> socialMppiTable();

/// Model predictive path integral control. Each call shifts the last plan, adds noise to it many
/// times and some constant commands (Trevisan & Alonso-Mora 2024), makes all of them feasible for
/// the drive, evaluates the resulting trajectories, and averages them by MppiUpdate.h. The feasible
/// controls are averaged, not the raw ones: the feasible set of a differential or omnidirectional
/// drive is convex, so the mean is feasible as well. The mean of trajectories on both sides of a
/// person may lead through the middle; then the best sample is used instead.
class MppiPlanner : public Planner {
 public:
  MppiPlanner(const PlannerSetup& setup, const MppiParameters& parameters,
              std::optional<SocialMppiParameters> social,
              MppiSimdLevel path = fastestMppiSimdLevel());

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override;
  std::vector<Vec2> path() const override;
  std::vector<Candidate> candidates() const override;
  void reseed(std::uint64_t seed) override;
  bool takeReplanned() override { return route_.takeReplanned(); }

 private:
  static constexpr std::size_t kAxes = 3;  // linear, angular, lateral
  using Sequence = std::array<std::vector<float>, kAxes>;

  /// Controls of `count` samples, their costs and contacts.
  struct Columns {
    void resize(int samples, int steps);
    MppiSamples view();
    int count = 0;
    std::array<std::vector<float>, kAxes> controls;
    std::vector<float> costs, hits;
  };

  void setNoise(std::uint64_t seed);
  void setDrive();
  void setCosts();
  void setSocial();
  void reset();
  void updateSurroundings(const Observation& observation);
  std::vector<PredictedBody> predictedBodies(const Observation& observation) const;
  PredictedBody predictedRobot(const Observation& observation) const;
  void addWaitingZone(const Observation& observation, const std::vector<PredictedBody>& bodies);
  void setProblem(const Observation& observation);
  void fillProposals();
  void sample();
  void update();
  void choose(const Sequence& mean, const Sequence& smooth);
  void put(const Sequence& sequence, int lane, Columns& columns) const;
  void putConstant(const std::array<float, kAxes>& control, int lane, Columns& columns) const;
  Sequence take(const Columns& columns, int lane) const;
  BodyTwist storePlan(const Sequence& plan);
  std::vector<Vec2> trajectoryPoints(const Columns& columns, int lane) const;
  std::size_t stepCount() const { return static_cast<std::size_t>(problem_.steps); }

  const RobotBody body_;
  const MppiParameters parameters_;
  const std::optional<SocialMppiParameters> social_;
  const double reach_;  // [m]
  const std::vector<MppiDisc> discs_;
  const MppiKernel kernel_;

  RobotRoute route_;
  ClearanceGrid clearance_;
  CostToGoGrid toGo_;
  MppiScene scene_;
  MppiProblem problem_;
  Sequence plan_, controlCosts_;
  std::array<std::array<float, 4>, kAxes> lastCommands_{};  // last commands, oldest first
  Columns samples_, finalists_;
  std::vector<float> weights_;
  int chosen_ = 0;              // lane of the chosen finalist
  Pose2 start_;                 // at the last call
  double waitingSince_ = -1.0;  // [s]; < 0: not waiting
};

}  // namespace sim2d
