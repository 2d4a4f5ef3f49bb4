#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"
#include "sim2d/nav/nav2/costmap/FootprintCost.h"

namespace sim2d::nav2 {
namespace {

constexpr char kRefusalObstacle[] = "Trajectory Hits Obstacle.";

/// Cost of the last pose's cell, or of all; each must be free of obstacles for the centre.
class BaseObstacleCritic final : public DwbCritic {
 public:
  explicit BaseObstacleCritic(const DwbCriticParameters& parameters) : parameters_(parameters) {}

  void prepare(const DwbScene& scene) override { costs_ = scene.input.costmap.costs().data(); }
  DwbPrice price(const DwbTrajectory& trajectory) override {
    double sum = 0.0;
    std::uint8_t last = 0;
    for (std::size_t i = 0; i < trajectory.onMap; ++i) {
      last = costs_[trajectory.cells[i]];
      if (last >= kInscribed) {
        return kRefusalObstacle;
      }
      sum += last;
    }
    if (trajectory.onMap < trajectory.poses.size()) {
      return kRefusalOffGrid;
    }
    return parameters_.sumsScores ? sum : static_cast<double>(last);
  }
  double scale(double /*resolution*/) const override { return parameters_.scale; }

 private:
  DwbCriticParameters parameters_;
  const std::uint8_t* costs_ = nullptr;
};

/// The same of the footprint's edges, where 253 is allowed.
class ObstacleFootprintCritic final : public DwbCritic {
 public:
  explicit ObstacleFootprintCritic(const DwbCriticParameters& parameters)
      : parameters_(parameters) {}

  void prepare(const DwbScene& scene) override {
    costmap_ = &scene.input.costmap;
    corners_ = &scene.input.shape.vertices;
  }
  DwbPrice price(const DwbTrajectory& trajectory) override {
    double sum = 0.0, last = 0.0;
    for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
      if (trajectory.cells[i] < 0) {
        return kRefusalOffGrid;
      }
      const DwbPrice pose = poseCost(trajectory.poses[i]);
      if (pose.refusal != nullptr) {
        return pose;
      }
      last = pose.raw;
      sum += last;
    }
    return parameters_.sumsScores ? sum : last;
  }
  double scale(double resolution) const override { return resolution * parameters_.scale; }

 private:
  DwbPrice poseCost(const Pose2& pose) {
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
      const DwbPrice edge = edgeCost(*from, *to);
      if (edge.refusal != nullptr) {
        return edge;
      }
      most = std::max(most, edge.raw);
    }
    return most;
  }
  DwbPrice edgeCost(Cell from, Cell to) const {
    std::uint8_t most = 0;
    visitLine(from, to, [&](Cell cell) {
      const std::uint8_t cost = costmap_->at(cell);
      most = std::max(most, cost);
      return cost != kLethal && cost != kNoInformation;
    });
    if (most == kLethal) {
      return kRefusalObstacle;
    }
    return most == kNoInformation ? DwbPrice("Trajectory Hits Unknown Region.")
                                  : DwbPrice(static_cast<double>(most));
  }

  DwbCriticParameters parameters_;
  const Costmap* costmap_ = nullptr;
  const std::vector<Vec2>* corners_ = nullptr;
  std::vector<Vec2> placed_;
};

template <class Critic>
std::unique_ptr<DwbCritic> makeObstacleCritic(const DwbCriticSetup& setup) {
  return std::make_unique<Critic>(setup.parameters);
}

}  // namespace

std::vector<DwbCriticType> obstacleCriticTypes() {
  using P = DwbCriticParameters;
  const Nav2Key<P> scale{"scale", &P::scale, "", "weight"};
  const Nav2Key<P> sum{"sum_scores", &P::sumsScores, "", "all poses count, not the last alone"};
  return {{"dwb_critics::BaseObstacleCritic", {scale, sum}, makeObstacleCritic<BaseObstacleCritic>},
          {"dwb_critics::ObstacleFootprintCritic",
           {scale, sum},
           makeObstacleCritic<ObstacleFootprintCritic>}};
}

}  // namespace sim2d::nav2
