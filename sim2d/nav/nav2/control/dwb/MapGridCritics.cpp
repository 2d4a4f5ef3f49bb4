#include <cstddef>
#include <memory>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"

namespace sim2d::nav2 {
namespace {

/// Price of a trajectory by a grid of distances.
class MapGridCritic : public DwbCritic {
 public:
  enum class Aggregation { Last, Sum, Product };
  MapGridCritic(const DwbCriticParameters& parameters, bool testsEachPose)
      : parameters_(parameters), testsEachPose_(testsEachPose) {
    if (parameters.aggregation == "sum") {
      aggregation_ = Aggregation::Sum;
    } else if (parameters.aggregation == "product") {
      aggregation_ = Aggregation::Product;
    }
  }

  DwbPrice price(const DwbTrajectory& trajectory) override {
    const std::size_t count = trajectory.poses.size();
    if (testsEachPose_ && !grid_->hasSeeds()) {
      return trajectory.onMap == 0 ? kRefusalOffGrid : "Trajectory Hits Unreachable Area.";
    }
    if (testsEachPose_ && trajectory.onMap < count) {
      return kRefusalOffGrid;  // a grid with a seed is reached whole: there is nothing else to test
    }
    double score = aggregation_ == Aggregation::Product ? 1.0 : 0.0;
    for (std::size_t i = aggregation_ == Aggregation::Last ? count - 1 : 0; i < count; ++i) {
      const int cell = cellOf(trajectory, i);
      if (cell < 0) {
        return kRefusalOffGrid;
      }
      add(grid_->at(cell), score);
    }
    return score;
  }
  double scale(double resolution) const override { return 0.5 * resolution * parameters_.scale; }

 protected:
  const DwbCriticParameters& parameters() const { return parameters_; }
  void setGrid(MapGrid& grid, const Costmap& costmap) {
    grid_ = &grid;
    costmap_ = &costmap;
  }
  const Costmap& costmap() const { return *costmap_; }
  /// Index of the cell that a pose is priced by, -1: off the map.
  virtual int cellOf(const DwbTrajectory& trajectory, std::size_t pose) const {
    return trajectory.cells[pose];
  }

 private:
  void add(double value, double& score) const {
    switch (aggregation_) {
      case Aggregation::Last:
        score = value;
        break;
      case Aggregation::Sum:
        score += value;
        break;
      case Aggregation::Product:
        score = score > 0.0 ? score * value : score;
        break;
    }
  }

  DwbCriticParameters parameters_;
  bool testsEachPose_;
  Aggregation aggregation_ = Aggregation::Last;
  MapGrid* grid_ = nullptr;
  const Costmap* costmap_ = nullptr;
};

class PathDistCritic final : public MapGridCritic {
 public:
  explicit PathDistCritic(const DwbCriticParameters& p) : MapGridCritic(p, true) {}
  void prepare(const DwbScene& scene) override { setGrid(scene.pathGrid, scene.input.costmap); }
};

class GoalDistCritic final : public MapGridCritic {
 public:
  explicit GoalDistCritic(const DwbCriticParameters& p) : MapGridCritic(p, true) {}
  void prepare(const DwbScene& scene) override { setGrid(scene.goalGrid, scene.input.costmap); }
};

/// By a point ahead of each pose.
class AlignCritic : public MapGridCritic {
 public:
  explicit AlignCritic(const DwbCriticParameters& p) : MapGridCritic(p, false) {}

 protected:
  int cellOf(const DwbTrajectory& trajectory, std::size_t pose) const override {
    const Vec2 ahead = trajectory.poses[pose].ahead(parameters().forwardPointDistance);
    const auto cell = costmap().worldToCell(ahead);
    return cell ? static_cast<int>(costmap().indexOf(*cell)) : -1;
  }
};

class PathAlignCritic final : public AlignCritic {
 public:
  using AlignCritic::AlignCritic;
  void prepare(const DwbScene& scene) override {
    // Near the goal, keeping the nose close to the path makes it restless.
    const double most = parameters().forwardPointDistance;
    isNear_ = (scene.input.robot.position - scene.goal.position).squaredNorm() <= most * most;
    setGrid(scene.pathGrid, scene.input.costmap);
  }
  double scale(double resolution) const override {
    return isNear_ ? 0.0 : MapGridCritic::scale(resolution);
  }

 private:
  bool isNear_ = false;
};

class GoalAlignCritic final : public AlignCritic {
 public:
  using AlignCritic::AlignCritic;
  void prepare(const DwbScene& scene) override {
    const Vec2 toGoal = scene.goal.position - scene.input.robot.position;
    const Vec2 direction = base::directionOf(base::headingOf(toGoal));
    plan_ = scene.plan;
    plan_.back().position += parameters().forwardPointDistance * direction;
    const Costmap& map = scene.input.costmap;
    grid_.clear(map.width(), map.height());
    const std::vector<Cell> seeds = pathSeeds(plan_, map);
    if (!seeds.empty()) {
      grid_.seed(seeds.back());
    }
    setGrid(grid_, map);
  }

 private:
  MapGrid grid_;
  Path plan_;
};

template <class Critic>
std::unique_ptr<DwbCritic> makeMapGridCritic(const DwbCriticSetup& setup) {
  return std::make_unique<Critic>(setup.parameters);
}

}  // namespace

std::vector<DwbCriticType> mapGridCriticTypes() {
  using P = DwbCriticParameters;
  const Nav2Key<P> scale{"scale", &P::scale, "", "weight"};
  const Nav2Key<P> aggregation{"aggregation_type", &P::aggregation, "",
                               "which poses count: last, sum or product"};
  const Nav2Key<P> ahead{"forward_point_distance", &P::forwardPointDistance, "m",
                         "how far before the robot's centre is looked"};
  return {
      {"dwb_critics::PathDistCritic", {scale, aggregation}, makeMapGridCritic<PathDistCritic>},
      {"dwb_critics::GoalDistCritic", {scale, aggregation}, makeMapGridCritic<GoalDistCritic>},
      {"dwb_critics::PathAlignCritic",
       {scale, aggregation, ahead},
       makeMapGridCritic<PathAlignCritic>},
      {"dwb_critics::GoalAlignCritic",
       {scale, aggregation, ahead},
       makeMapGridCritic<GoalAlignCritic>},
  };
}

}  // namespace sim2d::nav2
