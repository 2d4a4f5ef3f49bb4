#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"
#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// DWB written down as it is told, without any thought of time: what the program's is held against.
namespace plain_dwb {

using namespace sim2d::nav2;
using sim2d::BodyTwist;
using sim2d::Cell;

/// A grid of distances: a map from distance to cells, whole.
class Grid {
 public:
  Grid(const Costmap& costmap, const std::vector<Cell>& seeds)
      : costmap_(costmap),
        values_(costmap.costs().size(), static_cast<double>(costmap.costs().size()) + 1.0),
        isSeen_(costmap.costs().size(), false) {
    for (const Cell cell : seeds) {
      enqueue(cell, cell);
    }
    while (!queue_.empty()) {
      const auto nearest = queue_.begin();
      const auto [cell, source] = nearest->second.back();
      nearest->second.pop_back();
      if (nearest->second.empty()) {
        queue_.erase(nearest);
      }
      values_[costmap_.indexOf(cell)] =
          std::abs(cell.column - source.column) + std::abs(cell.row - source.row);
      enqueue({cell.column - 1, cell.row}, source);
      enqueue({cell.column, cell.row - 1}, source);
      enqueue({cell.column + 1, cell.row}, source);
      enqueue({cell.column, cell.row + 1}, source);
    }
  }
  double at(Cell cell) const { return values_[costmap_.indexOf(cell)]; }

 private:
  void enqueue(Cell cell, Cell source) {
    if (!costmap_.contains(cell) || isSeen_[costmap_.indexOf(cell)]) {
      return;
    }
    isSeen_[costmap_.indexOf(cell)] = true;
    const int dx = cell.column - source.column, dy = cell.row - source.row;
    queue_[std::sqrt(static_cast<double>(dx * dx + dy * dy))].push_back({cell, source});
  }

  const Costmap& costmap_;
  std::vector<double> values_;
  std::vector<bool> isSeen_;
  std::map<double, std::vector<std::pair<Cell, Cell>>> queue_;
};

/// Cells of the path's first stretch on the map and known; the path's poses lie close together.
inline std::vector<Cell> seedsOf(const Path& path, const Costmap& costmap) {
  std::vector<Cell> seeds;
  for (const Pose2& pose : path) {
    const auto cell = costmap.worldToCell(pose.position);
    if (cell && costmap.at(*cell) != kNoInformation) {
      seeds.push_back(*cell);
    } else if (!seeds.empty()) {
      break;
    }
  }
  return seeds;
}

/// Start, poses, end once more.
inline std::vector<Pose2> rollOut(const DwbParameters& p, const Pose2& start, BodyTwist v,
                                  const BodyTwist& command) {
  const double speed =
      std::sqrt(command.linear * command.linear + command.lateral * command.lateral);
  const int count = std::max(
      1, static_cast<int>(
             std::ceil(std::max(speed * p.simTime / p.linearGranularity,
                                std::abs(command.angular) * p.simTime / p.angularGranularity))));
  const double dt = p.simTime / count;
  std::vector<Pose2> poses{start};
  Pose2 pose = start;
  for (int i = 0; i < count; ++i) {
    v.linear = projectVelocity(v.linear, p.accLimX, p.decelLimX, dt, command.linear);
    v.lateral = projectVelocity(v.lateral, p.accLimY, p.decelLimY, dt, command.lateral);
    v.angular = projectVelocity(v.angular, p.accLimTheta, p.decelLimTheta, dt, command.angular);
    const double c = base::cos(pose.heading), s = base::sin(pose.heading);
    pose.position += dt * base::Vec2(v.linear * c - v.lateral * s, v.linear * s + v.lateral * c);
    pose.heading += v.angular * dt;
    poses.push_back(pose);
  }
  poses.push_back(pose);
  return poses;
}

/// What is weighed with Humble's usual critics; far from the goal.
struct Weights {
  double obstacle = 0.02, goalAlign = 24.0, pathAlign = 32.0, pathDist = 32.0, goalDist = 24.0;
  double forwardPoint = 0.1;  // [m]
};
struct Best {
  BodyTwist command;
  float total = -1.0F;
  std::size_t illegal = 0;
};

/// Price of a trajectory, or nothing: illegal. Grids: of the path, its end, its end pushed on.
inline std::optional<float> totalOf(const std::vector<Pose2>& poses, const Costmap& costmap,
                                    const Grid& path, const Grid& goal, const Grid& pushed,
                                    const Weights& weights) {
  const double half = 0.5 * costmap.resolution();
  const auto add = [](float& total, double scale, double raw) {
    const auto weight = static_cast<double>(static_cast<float>(scale));
    total = static_cast<float>(static_cast<double>(total) + weight * raw);
  };
  for (const Pose2& pose : poses) {
    const auto cell = costmap.worldToCell(pose.position);
    if (!cell || costmap.at(*cell) >= kInscribed) {
      return std::nullopt;
    }
  }
  const auto last = costmap.worldToCell(poses.back().position);
  const auto ahead = costmap.worldToCell(poses.back().ahead(weights.forwardPoint));
  if (!ahead) {
    return std::nullopt;
  }
  float total = 0.0F;
  add(total, weights.obstacle, costmap.at(*last));
  add(total, half * weights.goalAlign, pushed.at(*ahead));
  add(total, half * weights.pathAlign, path.at(*ahead));
  add(total, half * weights.pathDist, path.at(*last));
  add(total, half * weights.goalDist, goal.at(*last));
  return total;
}

/// The cheapest command of a cycle.
inline Best choose(const DwbParameters& p, const Weights& weights, const Costmap& costmap,
                   const Path& path, const Pose2& robot, const BodyTwist& speed) {
  const std::vector<Cell> seeds = seedsOf(path, costmap);
  Path on = path;
  const base::Vec2 toGoal = path.back().position - robot.position;
  on.back().position += weights.forwardPoint * base::directionOf(base::headingOf(toGoal));
  const std::vector<Cell> onSeeds = seedsOf(on, costmap);
  const Grid pathGrid(costmap, seeds), goalGrid(costmap, {seeds.back()}),
      pushedGrid(costmap, {onSeeds.back()});
  std::vector<BodyTwist> commands;
  velocitySamples(p, speed, p.simTime, commands);
  Best best;
  for (const BodyTwist& command : commands) {
    const auto total = totalOf(rollOut(p, robot, speed, command), costmap, pathGrid, goalGrid,
                               pushedGrid, weights);
    best.illegal += total ? 0 : 1;
    if (total && (best.total < 0.0F || *total < best.total)) {
      best.command = command;
      best.total = *total;
    }
  }
  return best;
}

}  // namespace plain_dwb
