#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {

const std::vector<DwbCriticType>& dwbCriticTypes() {
  static const std::vector<DwbCriticType> kTypes = [] {
    std::vector<DwbCriticType> types;
    for (const auto& part : {obstacleCriticTypes(), mapGridCriticTypes(), motionCriticTypes()}) {
      types.insert(types.end(), part.begin(), part.end());
    }
    return types;
  }();
  return kTypes;
}

const DwbCriticType* dwbCriticType(const std::string& name,
                                   const std::vector<std::string>& namespaces) {
  const auto find = [](const std::string& plugin) -> const DwbCriticType* {
    const auto& types = dwbCriticTypes();
    const auto found = std::find_if(types.begin(), types.end(), [&](const DwbCriticType& type) {
      return plugin == type.plugin;
    });
    return found == types.end() ? nullptr : &*found;
  };
  std::string plugin = normalizedPluginClass(name);
  if (plugin.find("Critic") == std::string::npos) {
    plugin += "Critic";
  }
  if (plugin.find("::") != std::string::npos) {
    return find(plugin);
  }
  for (const std::string& space : namespaces) {
    if (const DwbCriticType* type = find(base::join({space, plugin}, "::"))) {
      return type;
    }
  }
  return nullptr;
}

namespace {

constexpr char kObstacleRejection[] = "Trajectory Hits Obstacle.";

/// Cost of the last pose's cell, or sum of all; the cell of each centre must be free of obstacles.
class BaseObstacleCritic final : public DwbCritic {
 public:
  explicit BaseObstacleCritic(const DwbCriticParameters& parameters) : parameters_(parameters) {}

  void prepare(const DwbScene& scene) override { costs_ = scene.input.costmap.costs().data(); }
  DwbScore score(const DwbTrajectory& trajectory) override {
    double sum = 0.0;
    std::uint8_t last = 0;
    for (std::size_t i = 0; i < trajectory.onMap; ++i) {
      last = costs_[trajectory.cells[i]];
      if (last >= kInscribed) {
        return kObstacleRejection;
      }
      sum += last;
    }
    if (trajectory.onMap < trajectory.poses.size()) {
      return kOffGridRejection;
    }
    return parameters_.sumsScores ? sum : static_cast<double>(last);
  }
  double leastScore(const DwbTrajectory& trajectory) override {
    const bool isOff = trajectory.endCell < 0;
    const std::uint8_t cost = isOff ? kInscribed : costs_[trajectory.endCell];
    if (cost >= kInscribed) {
      return kInfinity;
    }
    return cost;
  }
  double scale(double /*resolution*/) const override { return parameters_.scale; }

 private:
  DwbCriticParameters parameters_;
  const std::uint8_t* costs_ = nullptr;
};

/// For each cell of a row or column: are all cells at most `radius` away in it there and set?
/// `lines` of them begin `lineStep` apart, their `length` cells are `step` apart.
std::vector<char> eroded(const std::vector<char>& cells, int lines, int lineStep, int length,
                         int step, int radius) {
  std::vector<char> result(cells.size());
  for (int line = 0; line < lines; ++line) {
    int run = 0;  // set cells in a row
    for (int i = 0; i < length; ++i) {
      const int at = line * lineStep + i * step;
      run = cells[static_cast<std::size_t>(at)] != 0 ? run + 1 : 0;
      if (run > 2 * radius) {
        result[static_cast<std::size_t>(at - radius * step)] = 1;
      }
    }
  }
  return result;
}

/// For each cell of a costmap: are all cells at most `radius` columns and rows away on the map,
/// known and not lethal?
std::vector<char> farFromObstacles(const Costmap& costmap, int radius) {
  const int width = costmap.width(), height = costmap.height();
  std::vector<char> isFree(costmap.costs().size());
  std::transform(costmap.costs().begin(), costmap.costs().end(), isFree.begin(),
                 [](std::uint8_t cost) { return static_cast<char>(cost < kLethal); });
  return eroded(eroded(isFree, height, width, width, 1, radius), width, 1, height, width, radius);
}

/// The same for the footprint's edges, where 253 is allowed.
class ObstacleFootprintCritic final : public DwbCritic {
 public:
  explicit ObstacleFootprintCritic(const DwbCriticParameters& parameters)
      : parameters_(parameters) {}

  void prepare(const DwbScene& scene) override {
    costmap_ = &scene.input.costmap;
    corners_ = &scene.input.shape.vertices;
    double farthest = 0.0;  // corner [m]
    for (const Vec2& corner : *corners_) {
      farthest = std::max(farthest, corner.norm());
    }
    constexpr double kMostCells = 1e6;
    const double cells = std::min(farthest / costmap_->resolution(), kMostCells);
    isFar_ = farFromObstacles(*costmap_, static_cast<int>(cells) + 2);
  }
  DwbScore score(const DwbTrajectory& trajectory) override {
    double sum = 0.0, last = 0.0;
    for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
      if (trajectory.cells[i] < 0) {
        return kOffGridRejection;
      }
      const bool isLast = i + 1 == trajectory.poses.size();
      const bool isSafe = isFar_[static_cast<std::size_t>(trajectory.cells[i])] != 0;
      if (isSafe && !isLast && !parameters_.sumsScores) {
        continue;
      }
      const DwbScore pose = poseCost(trajectory.poses[i]);
      if (pose.rejection != nullptr) {
        return pose;
      }
      last = pose.raw;
      sum += last;
    }
    return parameters_.sumsScores ? sum : last;
  }
  double leastScore(const DwbTrajectory& /*trajectory*/) override { return 0.0; }
  double scale(double resolution) const override { return resolution * parameters_.scale; }

 private:
  DwbScore poseCost(const Pose2& pose) {
    placed_.clear();
    const Vec2 axis = pose.direction();
    for (const Vec2& corner : *corners_) {
      const Vec2 offset(axis.x() * corner.x() - axis.y() * corner.y(),
                        axis.y() * corner.x() + axis.x() * corner.y());
      placed_.push_back(pose.position + offset);
    }
    double most = 0.0;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const auto from = costmap_->worldToCell(placed_[i]);
      const auto to = costmap_->worldToCell(placed_[i + 1 < placed_.size() ? i + 1 : 0]);
      if (!from || !to) {
        return "Footprint Goes Off Grid.";
      }
      const DwbScore edge = edgeCost(*from, *to);
      if (edge.rejection != nullptr) {
        return edge;
      }
      most = std::max(most, edge.raw);
    }
    return most;
  }
  DwbScore edgeCost(Cell from, Cell to) const {
    std::uint8_t most = 0;
    visitLine(from, to, [&](Cell cell) {
      const std::uint8_t cost = costmap_->at(cell);
      most = std::max(most, cost);
      return cost != kLethal && cost != kNoInformation;
    });
    if (most == kLethal) {
      return kObstacleRejection;
    }
    return most == kNoInformation ? DwbScore("Trajectory Hits Unknown Region.")
                                  : DwbScore(static_cast<double>(most));
  }

  DwbCriticParameters parameters_;
  const Costmap* costmap_ = nullptr;
  const std::vector<Vec2>* corners_ = nullptr;
  std::vector<Vec2> placed_;
  std::vector<char> isFar_;  // by cell: an outline round it meets no obstacle
};

template <class Critic>
std::unique_ptr<DwbCritic> makeObstacleCritic(const DwbCriticSetup& setup) {
  return std::make_unique<Critic>(setup.parameters);
}

}  // namespace

std::vector<DwbCriticType> obstacleCriticTypes() {
  using P = DwbCriticParameters;
  const Nav2Key<P> scale{"scale", &P::scale, "", "weight"};
  const Nav2Key<P> sum{"sum_scores", &P::sumsScores, "",
                       "all poses are scored, not only the last one"};
  return {{"dwb_critics::BaseObstacleCritic", {scale, sum}, makeObstacleCritic<BaseObstacleCritic>},
          {"dwb_critics::ObstacleFootprintCritic",
           {scale, sum},
           makeObstacleCritic<ObstacleFootprintCritic>}};
}

namespace {

/// Scores a trajectory by a distance grid.
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

  DwbScore score(const DwbTrajectory& trajectory) override {
    const std::size_t count = trajectory.poses.size();
    if (testsEachPose_ && !grid_->hasSeeds()) {
      return trajectory.onMap == 0 ? kOffGridRejection : "Trajectory Hits Unreachable Area.";
    }
    if (testsEachPose_ && trajectory.onMap < count) {
      return kOffGridRejection;  // a grid with a seed reaches all cells of the map
    }
    double score = aggregation_ == Aggregation::Product ? 1.0 : 0.0;
    for (std::size_t i = aggregation_ == Aggregation::Last ? count - 1 : 0; i < count; ++i) {
      const int cell = cellOf(trajectory, i);
      if (cell < 0) {
        return kOffGridRejection;
      }
      add(grid_->at(cell), score);
    }
    return score;
  }
  double leastScore(const DwbTrajectory& trajectory) override {
    if (aggregation_ == Aggregation::Product) {
      return 0.0;
    }
    const int cell = cellOf(trajectory, trajectory.poses.size() - 1);
    if (cell < 0) {
      return kInfinity;
    }
    return grid_->at(cell);
  }
  double scale(double resolution) const override { return 0.5 * resolution * parameters_.scale; }

 protected:
  const DwbCriticParameters& parameters() const { return parameters_; }
  void setGrid(MapGrid& grid, const Costmap& costmap) {
    grid_ = &grid;
    costmap_ = &costmap;
  }
  const Costmap& costmap() const { return *costmap_; }
  /// Index of the cell that scores a pose, -1: off the map.
  virtual int cellOf(const DwbTrajectory& trajectory, std::size_t pose) const {
    return pose + 1 == trajectory.poses.size() ? trajectory.endCell : trajectory.cells[pose];
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

/// Scores a point ahead of each pose.
class AlignCritic : public MapGridCritic {
 public:
  explicit AlignCritic(const DwbCriticParameters& p) : MapGridCritic(p, false) {}

 protected:
  int cellOf(const DwbTrajectory& trajectory, std::size_t pose) const override {
    const bool isEnd = pose + 1 == trajectory.poses.size();
    const Pose2& from = trajectory.poses[pose];
    const Vec2 direction = isEnd ? trajectory.endDirection : from.direction();
    const Vec2 ahead = from.position + parameters().forwardPointDistance * direction;
    const auto cell = costmap().worldToCell(ahead);
    return cell ? static_cast<int>(costmap().indexOf(*cell)) : -1;
  }
};

class PathAlignCritic final : public AlignCritic {
 public:
  using AlignCritic::AlignCritic;
  void prepare(const DwbScene& scene) override {
    // Near the goal, aligning with the path would cause oscillations.
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
                               "which poses are scored: last, sum or product"};
  const Nav2Key<P> ahead{"forward_point_distance", &P::forwardPointDistance, "m",
                         "distance of the scored point in front of the robot's centre"};
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
