#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/Body.h"

namespace bt {

std::vector<base::Vec2> pointsOf(const sim2d::nav2::Path& path) {
  std::vector<base::Vec2> points;
  points.reserve(path.size());
  for (const base::Pose2& pose : path) {
    points.push_back(pose.position);
  }
  return points;
}

sim2d::Candidate toCandidate(const sim2d::nav2::EvaluatedTrajectory& trajectory) {
  sim2d::Candidate way;
  way.points = pointsOf(trajectory.poses);
  way.cost =
      trajectory.rejection.empty() ? trajectory.total : std::numeric_limits<double>::infinity();
  way.isChosen = trajectory.isChosen;
  for (const sim2d::nav2::CriticScore& score : trajectory.scores) {
    if (score.scale != 0.0) {
      way.scores.emplace_back(score.critic, score.scale * score.raw);
    }
  }
  return way;
}

sim2d::CostGridPtr CostmapSnapshot::of(const sim2d::nav2::LayeredCostmap& costmap) {
  if (copy_ == nullptr || updates_ != costmap.updates()) {
    const sim2d::nav2::Costmap& now = costmap.costmap();
    auto grid = std::make_shared<sim2d::CostGrid>();
    grid->columns = now.width();
    grid->rows = now.height();
    grid->resolution = now.resolution();
    grid->origin = now.origin();
    grid->costs = now.costs();
    copy_ = std::move(grid);
    updates_ = costmap.updates();
  }
  return copy_;
}

namespace {

using base::Pose2;
using base::Vec2;
using sim2d::CostGrid;
using sim2d::CostGridPtr;
using sim2d::MaskGrid;

Vec2 turned(const Vec2& vector, const Vec2& axis) {
  return {axis.dot(vector), base::cross(axis, vector)};
}

/// Axis-parallel grid in the map that covers a grid of a rotated frame; all 0.
std::shared_ptr<CostGrid> emptyCover(const Pose2& frame, const CostGrid& grid) {
  const Vec2 size = grid.resolution * Vec2(grid.columns, grid.rows);
  Vec2 low = frame.toWorld(grid.origin), high = low;
  for (const Vec2& corner : {Vec2(size.x(), 0.0), size, Vec2(0.0, size.y())}) {
    const Vec2 inMap = frame.toWorld(grid.origin + corner);
    low = low.cwiseMin(inMap);
    high = high.cwiseMax(inMap);
  }
  auto cover = std::make_shared<CostGrid>();
  cover->resolution = grid.resolution;
  cover->origin = low;
  cover->columns = static_cast<int>(std::ceil((high.x() - low.x()) / grid.resolution));
  cover->rows = static_cast<int>(std::ceil((high.y() - low.y()) / grid.resolution));
  const auto cells =
      static_cast<std::size_t>(cover->columns) * static_cast<std::size_t>(cover->rows);
  cover->costs.assign(cells, 0);
  return cover;
}

}  // namespace

const sim2d::Observation& OdomObservation::of(const sim2d::Observation& inMap) {
  const bool isScanEqual = inMap.scan == nullptr || sim2d::isIdentity(inMap.scan->mapToOdom);
  if (sim2d::isIdentity(inMap.mapToOdom) && isScanEqual) {
    return inMap;
  }
  const Pose2& frame = inMap.mapToOdom;
  const Vec2 axis = frame.direction();
  converted_ = inMap;
  converted_.frame = frame;
  converted_.pose = sim2d::toFrame(frame, inMap.pose);
  converted_.goal = frame.toLocal(inMap.goal);
  for (Vec2& goal : converted_.remainingGoals) {
    goal = frame.toLocal(goal);
  }
  for (sim2d::TrackedBody& body : converted_.bodies) {
    body.position = frame.toLocal(body.position);
    body.velocity = turned(body.velocity, axis);
    body.heading = base::angleDiff(body.heading, frame.heading);
  }
  if (inMap.scan != nullptr) {
    if (scan_.distances.empty() || scan_.time != inMap.scan->time) {
      scan_ = *inMap.scan;
      scan_.sensor = sim2d::toFrame(inMap.scan->mapToOdom, inMap.scan->sensor);
    }
    converted_.scan = &scan_;
  }
  return converted_;
}

void moveToMap(const Pose2& frame, std::vector<Vec2>& points) {
  if (sim2d::isIdentity(frame)) {
    return;
  }
  for (Vec2& point : points) {
    point = frame.toWorld(point);
  }
}

sim2d::CostGridPtr costsInMap(const Pose2& frame, sim2d::CostGridPtr grid) {
  if (sim2d::isIdentity(frame) || grid == nullptr) {
    return grid;
  }
  const std::shared_ptr<CostGrid> cover = emptyCover(frame, *grid);
  std::size_t to = 0;
  for (int row = 0; row < cover->rows; ++row) {
    for (int column = 0; column < cover->columns; ++column, ++to) {
      const Vec2 centre = cover->origin + cover->resolution * Vec2(column + 0.5, row + 0.5);
      const Vec2 cell = (frame.toLocal(centre) - grid->origin) / grid->resolution;
      if (cell.x() >= 0.0 && cell.y() >= 0.0 && cell.x() < grid->columns && cell.y() < grid->rows) {
        const auto at =
            static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(grid->columns) +
            static_cast<std::size_t>(cell.x());
        cover->costs[to] = grid->costs[at];
      }
    }
  }
  return cover;
}

namespace {

/// The effect of mask values by filter, in percent.
struct MaskEffect {
  const sim2d::nav2::FilterMask& mask;
  double topSpeed;  // [m/s]

  double operator()(const sim2d::nav2::KeepoutFilterParameters& /*filter*/, double value) const {
    return value;
  }
  double operator()(const sim2d::nav2::SpeedFilterParameters& /*filter*/, double value) const {
    if (value == 0.0) {
      return 0.0;
    }
    const double limit = mask.base + mask.multiplier * value;
    if (!(limit > 0.0) || (mask.isPercentage && limit > 100.0)) {
      return 0.0;  // no limit, as in SpeedFilter
    }
    return mask.isPercentage ? limit : 100.0 * limit / topSpeed;
  }
  double operator()(const sim2d::nav2::BinaryFilterParameters& filter, double value) const {
    return mask.base + mask.multiplier * value > filter.flipThreshold ? 100.0 : 0.0;
  }
  template <class Layer>
  double operator()(const Layer& /*layer*/, double /*value*/) const {
    return 0.0;
  }
};

/// The kind of mask of a filter; none: another layer, or disabled.
std::optional<MaskGrid::Kind> maskKindOf(const sim2d::nav2::LayerParameters& parameters) {
  using namespace sim2d::nav2;
  const auto kind = [](const auto* filter, MaskGrid::Kind wanted) {
    return filter->enabled ? std::optional<MaskGrid::Kind>(wanted) : std::nullopt;
  };
  if (const auto* keepout = std::get_if<KeepoutFilterParameters>(&parameters)) {
    return kind(keepout, MaskGrid::Kind::Keepout);
  }
  if (const auto* speed = std::get_if<SpeedFilterParameters>(&parameters)) {
    return kind(speed, MaskGrid::Kind::Speed);
  }
  const auto* binary = std::get_if<BinaryFilterParameters>(&parameters);
  return binary != nullptr ? kind(binary, MaskGrid::Kind::Switch) : std::nullopt;
}

CostGridPtr maskGridOf(const sim2d::nav2::LayerParameters& parameters,
                       const sim2d::nav2::FilterMask& mask, double topSpeed) {
  const sim2d::OccupancyGrid& cells = mask.grid;
  auto grid = std::make_shared<CostGrid>();
  grid->columns = cells.width();
  grid->rows = cells.height();
  grid->resolution = cells.resolution();
  grid->costs.reserve(cells.cells().size());
  for (int row = 0; row < grid->rows; ++row) {
    for (int column = 0; column < grid->columns; ++column) {
      const sim2d::Cell cell{column, row};
      double percent = 0.0;
      if (!cells.isUnknown(cell)) {
        const double value = cells.valueAt(cell);
        percent = std::visit(
            [&](const auto& filter) {
              return MaskEffect{mask, topSpeed}(filter, value);
            },
            parameters);
      }
      grid->costs.push_back(
          static_cast<std::uint8_t>(std::lround(std::clamp(percent, 0.0, 100.0))));
    }
  }
  if (cells.origin().heading == 0.0) {
    grid->origin = cells.origin().position;
    return grid;
  }
  return costsInMap(cells.origin(), std::move(grid));
}

}  // namespace

std::vector<MaskGrid> maskGrids(const sim2d::nav2::CostmapSettings& costmap,
                                const sim2d::nav2::FilterMasks& masks, double topSpeed) {
  std::vector<MaskGrid> grids;
  for (const sim2d::nav2::CostmapPlugin& filter : costmap.filters) {
    const auto mask = masks.find(filter.name);
    const std::optional<MaskGrid::Kind> kind = maskKindOf(filter.parameters);
    if (kind && mask != masks.end() && !mask->second.grid.isEmpty()) {
      grids.push_back({*kind, maskGridOf(filter.parameters, mask->second, topSpeed)});
    }
  }
  return grids;
}

}  // namespace bt
