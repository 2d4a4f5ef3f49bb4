#pragma once

#include <cstddef>

#include "sim2d/nav/mppi/MppiLanes.h"
#include "sim2d/nav/nav2/mppi/TrajectoryCritics.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

/// Critics that use the costmap. Include once in the source file of each instruction set.
namespace sim2d::nav2 {
namespace {

struct CellCost {
  Lanes cost;  // 255 off the map
  LaneMask isOnMap;
};

inline CellCost cellCostAt(const CostCells& cells, Lanes x, Lanes y) {
  const Lanes none = fill(0.0F);
  const Lanes column = (x - fill(cells.x)) / fill(cells.resolution);
  const Lanes row = (y - fill(cells.y)) / fill(cells.resolution);
  const LaneMask isOnMap = (none <= column) & (none <= row) &
                           (column < fill(static_cast<float>(cells.columns))) &
                           (row < fill(static_cast<float>(cells.rows)));
  const LaneInts left = xsimd::to_int(select(isOnMap, column, none));
  const LaneInts below = xsimd::to_int(select(isOnMap, row, none));
  const LaneInts at = below * LaneInts(cells.columns) + left;
  return {select(isOnMap, Lanes::gather(cells.costs, at), fill(255.0F)), isOnMap};
}

/// Edge costs where `isAsked`; `otherwise` elsewhere.
inline Lanes edgeCostsAt(const FootprintCostCallback& footprintCost, LaneMask isAsked,
                         Lanes otherwise, Lanes x, Lanes y, Lanes yaw) {
  float asked[kLaneCount];
  float costs[kLaneCount];
  float places[3][kLaneCount];
  store(asked, select(isAsked, fill(1.0F), fill(0.0F)));
  store(costs, otherwise);
  store(places[0], x);
  store(places[1], y);
  store(places[2], yaw);
  for (int lane = 0; lane < kLaneCount; ++lane) {
    if (asked[lane] > 0.0F) {
      costs[lane] = footprintCost.cost(footprintCost.scene, places[0][lane], places[1][lane],
                                       places[2][lane]);
    }
  }
  return load(costs);
}

/// Costs of a register of poses.
struct PoseCost {
  Lanes centre;
  Lanes counted;       // decides about a collision: cost of the centre or of the edges
  LaneMask isOfEdges;  // `counted` is an edge cost
  LaneMask isCollision;
};

/// `isOpen`: samples that have not collided yet; the edges of others are not evaluated.
/// `asksOffMap`: evaluates edges where the centre is off the map.
inline PoseCost poseCostAt(const CollisionProblem& problem, const TrajectoryBatch& batch,
                           std::size_t at, LaneMask isOpen, bool asksOffMap) {
  const Lanes x = load(batch.x + at);
  const Lanes y = load(batch.y + at);
  const CellCost cell = cellCostAt(problem.cells, x, y);
  const LaneMask isUnknown = cell.cost == fill(255.0F);
  const LaneMask isAny = fill(1.0F) <= cell.cost;
  if (!problem.considersFootprint) {
    const LaneMask isHigh = fill(253.0F) <= cell.cost;
    const LaneMask collides = problem.tracksUnknown ? isHigh & ~isUnknown : isHigh;
    return {cell.cost, cell.cost, isHigh & ~isHigh, collides};
  }
  LaneMask isAsked = isOpen & isAny;
  if (problem.possible >= 1.0F) {
    isAsked = isAsked & (fill(problem.possible) <= cell.cost);
  }
  if (!asksOffMap) {
    isAsked = isAsked & cell.isOnMap;
  }
  Lanes counted = cell.cost;
  if (xsimd::any(isAsked)) {
    counted = edgeCostsAt(problem.footprintCost, isAsked, cell.cost, x, y, load(batch.yaw + at));
  }
  const LaneMask isLethal = counted == fill(254.0F);
  const LaneMask collides = problem.tracksUnknown ? isLethal : isLethal | (counted == fill(255.0F));
  return {cell.cost, counted, isAsked, collides};
}

inline Lanes costOf(const CostProblem& problem, const TrajectoryBatch& batch, std::size_t start,
                    LaneMask& isHit) {
  const Lanes none = fill(0.0F);
  const Lanes one = fill(1.0F);
  Lanes sum = none;
  isHit = one < none;
  for (int point = 0; point < problem.points; ++point) {
    const std::size_t at = start + stepOffset(point * problem.pointStep);
    const PoseCost pose = poseCostAt(problem.collision, batch, at, ~isHit, true);
    const LaneMask isOpen = ~isHit & (one <= pose.centre);
    isHit = isHit | (isOpen & pose.isCollision);
    const Lanes far = problem.isNearGoal ? none : pose.centre;
    const Lanes price =
        select(fill(problem.nearCollisionCost) <= pose.centre, fill(problem.criticalCost), far);
    sum = sum + select(isOpen & ~pose.isCollision, price, none);
    if (xsimd::all(isHit)) {
      break;
    }
  }
  return select(isHit, fill(problem.collisionCost), sum);
}

inline void scoreCost(const CostProblem& problem, const TrajectoryBatch& batch,
                      const ScoreSink& sink) {
  const Lanes points = fill(static_cast<float>(problem.points));
  forEachRegister(batch, [&](int sample, std::size_t start) {
    LaneMask isHit = fill(1.0F) < fill(0.0F);
    const Lanes cost = costOf(problem, batch, start, isHit);
    store(problem.collision.hits + sample, select(isHit, fill(1.0F), fill(0.0F)));
    addScore(sink, sample, cost / points);
  });
}

inline Lanes distanceOf(const ObstaclesProblem& problem, const PoseCost& pose) {
  const LaneInts cost = xsimd::to_int(pose.counted);
  const Lanes centre = Lanes::gather(problem.centreDistances, cost);
  if (!problem.collision.considersFootprint) {
    return centre;
  }
  return select(pose.isOfEdges, Lanes::gather(problem.edgeDistances, cost), centre);
}

inline void scoreObstacles(const ObstaclesProblem& problem, const TrajectoryBatch& batch) {
  const Lanes none = fill(0.0F);
  const Lanes one = fill(1.0F);
  forEachRegister(batch, [&](int sample, std::size_t start) {
    Lanes margin = none;
    Lanes repulsion = none;
    LaneMask isHit = one < none;
    for (int step = 0; step < batch.steps && !xsimd::all(isHit); ++step) {
      const PoseCost pose =
          poseCostAt(problem.collision, batch, start + stepOffset(step), ~isHit, false);
      const LaneMask isNear = ~isHit & (one <= pose.counted);
      isHit = isHit | (isNear & pose.isCollision);
      const LaneMask isPriced = isNear & ~pose.isCollision;
      if (!problem.hasInflation || !xsimd::any(isPriced)) {
        continue;
      }
      const Lanes distance = distanceOf(problem, pose);
      const Lanes depth = fill(problem.margin) - distance;
      margin = margin + select(isPriced, positivePart(depth), none);
      if (!problem.isNearGoal) {
        const LaneMask isRepelled =
            problem.repelsOutsideOnly ? isPriced & (depth <= none) : isPriced;
        repulsion = repulsion + select(isRepelled, fill(problem.inflationRadius) - distance, none);
      }
    }
    store(problem.collision.hits + sample, select(isHit, one, none));
    store(problem.margins + sample, select(isHit, fill(problem.collisionCost), margin));
    store(problem.repulsions + sample, repulsion);
  });
}

}  // namespace
}  // namespace sim2d::nav2
