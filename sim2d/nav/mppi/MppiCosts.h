#pragma once

#include "sim2d/nav/mppi/MppiKernel.h"
#include "sim2d/nav/mppi/MppiLanes.h"

/// Cost of one register of samples at one step. Include exactly once per instruction-set file.
namespace sim2d {
namespace {

constexpr int kComfortStride = 2;  // comfort costs are evaluated at every second step

struct GridValue {
  Lanes value, slopeX, slopeY;  // slopes per metre
};

inline GridValue valueAt(const MppiGrid& grid, Lanes x, Lanes y) {
  const Lanes perMetre = fill(grid.perMetre);
  const Lanes none = fill(0.0F);
  const Lanes column =
      clamped((x - fill(grid.x)) * perMetre, none, fill(static_cast<float>(grid.columns) - 1.01F));
  const Lanes row =
      clamped((y - fill(grid.y)) * perMetre, none, fill(static_cast<float>(grid.rows) - 1.01F));
  const Lanes left = xsimd::to_float(xsimd::to_int(column));
  const Lanes below = xsimd::to_float(xsimd::to_int(row));
  const LaneInts at = xsimd::to_int(below * fill(static_cast<float>(grid.columns)) + left);
  const Lanes a = Lanes::gather(grid.values, at);
  const Lanes b = Lanes::gather(grid.values + 1, at);
  const Lanes c = Lanes::gather(grid.values + grid.columns, at);
  const Lanes d = Lanes::gather(grid.values + grid.columns + 1, at);
  const Lanes shareX = column - left;
  const Lanes shareY = row - below;
  const Lanes low = a + shareX * (b - a);
  const Lanes high = c + shareX * (d - c);
  const Lanes slopeX = (b - a) + shareY * ((d - c) - (b - a));
  return {low + shareY * (high - low), slopeX * perMetre, (high - low) * perMetre};
}

/// Poses and velocities of the samples.
struct RolloutState {
  Lanes x, y, cosine, sine;
  Lanes linear, angular, lateral;
};

/// Accumulated over the steps.
struct RolloutSums {
  Lanes cost = fill(0.0F);
  Lanes hits = fill(0.0F);
  Lanes toGo = fill(0.0F);  // at the last step
};

inline void addPathCosts(const MppiProblem& problem, const RolloutState& at, RolloutSums& sums) {
  const MppiCosts& costs = problem.costs;
  const Lanes none = fill(0.0F);
  const Lanes one = fill(1.0F);
  const GridValue toGo = valueAt(problem.distance, at.x, at.y);
  const Lanes steep2 = toGo.slopeX * toGo.slopeX + toGo.slopeY * toGo.slopeY;
  sums.toGo = toGo.value;
  const Lanes uphill = (at.cosine * toGo.slopeX + at.sine * toGo.slopeY) / sqrt(max(one, steep2));
  const Lanes isFar = min(one, fill(2.0F) * toGo.value);  // at the goal the heading does not count
  const Lanes away = fill(0.5F * costs.heading) * (one + uphill) * isFar;
  const Lanes speed2 = at.linear * at.linear + at.lateral * at.lateral;
  const Lanes moving = select(toGo.value < fill(costs.goalRadius), speed2, none);
  sums.cost = sums.cost + fill(costs.goal) * toGo.value + away +
              fill(costs.reverse) * positivePart(none - at.linear) + fill(costs.stop) * moving;
}

inline void addWallCosts(const MppiProblem& problem, const MppiDisc& disc, Lanes x, Lanes y,
                         RolloutSums& sums) {
  const Lanes none = fill(0.0F);
  const Lanes one = fill(1.0F);
  const Lanes gap = valueAt(problem.clearance, x, y).value - fill(disc.radius);
  const Lanes near = positivePart(one - gap * fill(problem.costs.perWallRange));
  const Lanes depth = fill(problem.costs.wallMargin) - gap;
  sums.cost = sums.cost + fill(problem.costs.wall) * (near * near);
  sums.hits = sums.hits + select(none < depth, one + fill(10.0F) * depth, none);
}

inline void addPeopleCosts(const MppiProblem& problem, int step, Lanes x, Lanes y,
                           RolloutSums& sums) {
  const Lanes none = fill(0.0F);
  const Lanes one = fill(1.0F);
  Lanes closeness = none;
  for (int i = problem.firstPerson[step]; i < problem.firstPerson[step + 1]; ++i) {
    const MppiPerson& person = problem.people[i];
    const Lanes dx = x - fill(person.x);
    const Lanes dy = y - fill(person.y);
    const Lanes near =  // 1 at contact
        positivePart((fill(person.far2) - (dx * dx + dy * dy)) * fill(person.perBand));
    closeness = closeness + near * near;
    sums.hits = sums.hits + select(one < near, fill(10.0F) * near - fill(9.0F), none);
  }
  sums.cost = sums.cost + fill(problem.costs.person) * closeness;
}

inline void addZoneCosts(const MppiProblem& problem, const RolloutState& at, RolloutSums& sums) {
  for (int i = 0; i < problem.zoneCount; ++i) {
    const MppiZone& zone = problem.zones[i];
    const Lanes dx = at.x - fill(zone.x);
    const Lanes dy = at.y - fill(zone.y);
    const Lanes inside = positivePart(fill(1.0F) - (dx * dx + dy * dy) * fill(zone.perRadius2));
    sums.cost = sums.cost + fill(zone.weight) * inside;
  }
}

/// Discomfort of one person; the terms are documented in SocialMppi's parameter table.
inline Lanes discomfortCost(const MppiSocial& social, const MppiPerson& person,
                            const RolloutState& at, Lanes vx, Lanes vy, Lanes early) {
  const Lanes none = fill(0.0F);
  const Lanes one = fill(1.0F);
  const Lanes dx = at.x - fill(person.x);
  const Lanes dy = at.y - fill(person.y);
  const Lanes wx = vx - fill(person.vx);
  const Lanes wy = vy - fill(person.vy);
  const Lanes d = sqrt(max(dx * dx + dy * dy, fill(1e-6F)));
  const Lanes gap = d - fill(person.touch);
  const Lanes intimate = positivePart(one - gap * fill(social.perIntimate));
  const Lanes personal = positivePart(one - gap * fill(social.perPersonal));

  const Lanes ahead = dx * fill(person.hx) + dy * fill(person.hy);  // in the person's frame
  const Lanes left = dy * fill(person.hx) - dx * fill(person.hy);
  const Lanes along = select(none < ahead, fill(person.front), fill(person.rear));
  const Lanes space = powerOfTwo(none - (ahead * ahead * along + left * left * fill(person.side)));
  const Lanes onStrip =
      select(none < ahead, positivePart(one - ahead * fill(person.perStrip)), none) *
      positivePart(one - abs(left) * fill(social.perStripWidth));

  const Lanes w2 = wx * wx + wy * wy;
  const Lanes closing = positivePart(none - (dx * wx + dy * wy));  // multiplied by d
  const Lanes hurry =
      min(fill(2.0F),
          positivePart(fill(social.fromTouchTime) * closing / (d * max(gap, fill(0.1F))) - one));
  const Lanes cross = dx * wy - dy * wx;
  const Lanes miss = abs(cross) / sqrt(max(w2, fill(0.04F)));  // [m], closest approach
  const Lanes unclear = positivePart(one - (miss - fill(person.touch)) * fill(social.perPass));
  const Lanes matters = positivePart(one - gap * fill(social.perLegible));
  const Lanes illegible =
      select(none < closing, min(one, unclear) * matters * early, none) * fill(person.walks);

  return fill(social.intimate) * intimate + fill(social.personal) * (personal * personal) +
         fill(social.space) * space + fill(social.strip * person.walks) * onStrip +
         fill(social.touchTime) * (hurry * hurry) * personal +
         fill(social.relativeSpeed) * w2 * personal + fill(social.legible) * illegible;
}

inline void addComfortCosts(const MppiProblem& problem, int step, const RolloutState& at,
                            RolloutSums& sums) {
  const Lanes vx = at.linear * at.cosine - at.lateral * at.sine;
  const Lanes vy = at.linear * at.sine + at.lateral * at.cosine;
  const Lanes early =
      fill(2.0F - 2.0F * static_cast<float>(step) / static_cast<float>(problem.steps));
  Lanes sum = fill(0.0F);
  for (int i = problem.firstPerson[step]; i < problem.firstPerson[step + 1]; ++i) {
    const MppiPerson& person = problem.people[i];
    const Lanes discomfort = discomfortCost(problem.social, person, at, vx, vy, early);
    sum = sum + fill(person.comfort * kComfortStride) * discomfort;
  }
  sums.cost = sums.cost + sum;
}

}  // namespace
}  // namespace sim2d
