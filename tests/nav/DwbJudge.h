#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"
#include "tests/nav/ControlScene.h"

/// One critic of DWB on trajectories made by hand.
namespace dwb_judge {

using namespace sim2d::nav2;
using control_scene::Scene;
using sim2d::BodyTwist;
using sim2d::Cell;

/// A critic in a scene: the grids are those of the path.
class Judge {
 public:
  explicit Judge(const std::string& name, const DwbCriticParameters& parameters = {},
                 Distro distro = Distro::Jazzy)
      : scene(distro),
        critic_(dwbCriticType(name, {"dwb_critics"})->make({parameters, DwbParameters(), distro})) {
  }

  DwbCritic& critic() { return *critic_; }
  void prepare(const Path& plan, const Pose2& goal) {
    pathGrid_.clear(scene.costmap.width(), scene.costmap.height());
    goalGrid_.clear(scene.costmap.width(), scene.costmap.height());
    const std::vector<Cell> seeds = pathSeeds(plan, scene.costmap);
    for (const Cell cell : seeds) {
      pathGrid_.seed(cell);
    }
    if (!seeds.empty()) {
      goalGrid_.seed(seeds.back());
    }
    const ControlInput input{scene.robot, scene.speed,    scene.costmap,
                             scene.shape, *scene.checker, scene.time};
    critic_->prepare({input, plan, goal, pathGrid_, goalGrid_});
  }
  void prepare(const Path& plan) { prepare(plan, plan.back()); }

  DwbScore score(const std::vector<Pose2>& poses, const BodyTwist& velocity = {}) {
    DwbTrajectory trajectory;
    trajectory.velocity = velocity;
    trajectory.poses = poses;
    trajectory.step = 0.1;
    for (const Pose2& pose : poses) {
      const auto cell = scene.costmap.worldToCell(pose.position);
      trajectory.cells.push_back(cell ? static_cast<int>(scene.costmap.indexOf(*cell)) : -1);
      const bool isFirst = trajectory.onMap + 1 == trajectory.cells.size();
      trajectory.onMap += cell && isFirst ? 1 : 0;
    }
    trajectory.endCell = trajectory.cells.back();
    trajectory.endDirection = poses.back().direction();
    const double least = critic_->leastScore(trajectory);
    const DwbScore exact = critic_->score(trajectory);
    if (exact.rejection == nullptr && least > exact.raw) {
      throw std::logic_error("the lower bound is above the score");
    }
    return exact;
  }
  DwbScore priceOf(const BodyTwist& velocity) { return score({scene.robot}, velocity); }

  Scene scene;

 private:
  std::unique_ptr<DwbCritic> critic_;
  MapGrid pathGrid_, goalGrid_;
};

}  // namespace dwb_judge
