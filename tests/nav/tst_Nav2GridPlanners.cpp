#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"
#include "tests/nav/CostmapSketch.h"

using namespace costs;
using namespace sim2d::nav2;

namespace {

PlanResult theta(const Costmap& costmap, const Pose2& start, const Pose2& goal,
                 const ThetaStarParameters& parameters = {}, Distro distro = Distro::Jazzy) {
  return makeGlobalPlanner(parameters, distro)->plan({costmap, start, goal});
}

PlanResult smac(const Costmap& costmap, const Pose2& start, const Pose2& goal,
                const Smac2DParameters& parameters = {}, Distro distro = Distro::Jazzy) {
  return makeGlobalPlanner(parameters, distro)->plan({costmap, start, goal});
}

Smac2DParameters unsmoothed() {
  Smac2DParameters parameters;
  parameters.smootherMaxIterations = 0;
  return parameters;
}

double never() {
  return std::numeric_limits<double>::infinity();
}

/// What Theta* pays for the cells of a straight line, by its own walk along it.
double traversal(double cost) {
  const double weighed = 26.0 + 0.9 * cost;
  return 2.0 * weighed * weighed / (252.0 * 252.0);
}

}  // namespace

/// Theta* and Smac 2D.
class Nav2GridPlannersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theta_openField_isTheStraightLine() {
    const Costmap costmap(60, 40, 0.05, {-1.0, -1.0});
    const PlanResult result = theta(costmap, pose(-0.52, -0.61), pose(1.52, 0.43, 0.3));
    QVERIFY(result.error == PlanError::None);
    const Vec2 from = costmap.cellToWorld(*costmap.worldToCell({-0.52, -0.61}));
    const Vec2 to = costmap.cellToWorld(*costmap.worldToCell({1.52, 0.43}));
    QVERIFY((result.path.front().position - from).norm() < 1e-9);
    QVERIFY((result.path.back().position - to).norm() < 1e-9);
    QCOMPARE(result.path.back().heading, 0.3);
    // The last node is not moved to a parent further back: a cell may be left of the line.
    QVERIFY(lengthOf(result.path) < (to - from).norm() + 0.03);
    for (std::size_t i = 1; i + 2 < result.path.size(); ++i) {
      const double step = (result.path[i].position - result.path[i - 1].position).norm();
      QVERIFY(step < 0.1 - 1e-9);
      QCOMPARE(result.path[i].heading, 0.0);
    }
  }

  void theta_touchingCorners_areSteppedThrough() {
    const std::vector<std::string> rooms = {"###..", "###..", "...##", "...##", "...##"};
    for (const Distro distro : {Distro::Jazzy, Distro::Main}) {
      const PlanResult through = theta(drawn(rooms), pose(0.5, 0.5), pose(4.5, 4.5), {}, distro);
      QCOMPARE(through.path.size(), std::size_t{5});
      QCOMPARE(through.path[2].position, Vec2(2.5, 2.5));
    }
  }

  void theta_cellOf252_isEnteredButNotSeenThrough() {
    // c' = 252.8 of the two cells in the middle is above 252: they are entered, but no line crosses
    // them. Each costs 2.0 more than its length; the cells behind the start keep the queue filled.
    const auto through = [](const char* middle, Distro distro) {
      return theta(drawn({"........##...", middle, "........##..."}), pose(7.5, 1.5),
                   pose(12.5, 1.5), {}, distro);
    };
    for (const Distro distro : {Distro::Jazzy, Distro::Main}) {
      const PlanResult straight = through("........oo...", distro);
      QVERIFY(straight.error == PlanError::None);
      QVERIFY(std::fabs(lengthOf(straight.path) - 5.0) < 1e-9);
      QVERIFY(through("........oi...", distro).error == PlanError::NoValidPath);
    }
    // A slanted tunnel: crossed by lines it has poses off the centres of cells, with 252 it has
    // none.
    const auto isOffCentre = [](const Pose2& each) {
      const double x = each.position.x() - std::floor(each.position.x());
      const double y = each.position.y() - std::floor(each.position.y());
      return std::fabs(x - 0.5) > 1e-9 || std::fabs(y - 0.5) > 1e-9;
    };
    const auto slanted = [&](const char* middle) {
      return theta(drawn({"###########....", middle, "............###"}), pose(8.5, 0.5),
                   pose(14.5, 2.5), {}, Distro::Main)
          .path;
    };
    const Path seen = slanted("..............."), unseen = slanted("##########ooo##");
    QVERIFY(std::any_of(seen.begin(), seen.end(), isOffCentre));
    QVERIFY(!unseen.empty());
    QVERIFY(std::none_of(unseen.begin(), unseen.end(), isOffCentre));
  }

  void theta_clutter_isNoDearerThanEightNeighbours() {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      const Costmap costmap = cluttered(70, seed);
      const Cell from{3, 3}, to{66, 66};
      // Costs low enough that Theta* prefers short ways: only length counts here.
      ThetaStarParameters parameters;
      parameters.traversalCost = 0.0;
      const std::vector<double> best = cheapest(costmap, from, 8, [&](Cell cell, double length) {
        return costmap.at(cell) > 252 ? never() : length;
      });
      const PlanResult result = theta(costmap, {costmap.cellToWorld(from), 0.0},
                                      {costmap.cellToWorld(to), 0.0}, parameters);
      QCOMPARE(result.error == PlanError::None, std::isfinite(best[costmap.indexOf(to)]));
      if (result.error == PlanError::None) {
        ++found;
        const double cells = lengthOf(result.path) / costmap.resolution();
        QVERIFY(cells <= best[costmap.indexOf(to)] + 1e-9);
        QVERIFY(cells >= std::hypot(63.0, 63.0) - 1e-9);
        QVERIFY(highestUnder(costmap, result.path) < 254);
      }
    }
    QVERIFY(found > 12);
  }

  void theta_costs_areGoneRound() {
    // A band of cost 128: c' = 141.2 pays 0.628 a cell, free c' = 26 pays 0.0213. Straight through
    // ten cells of it 6.1 more than round; round is some 2.4 longer.
    QVERIFY(std::fabs(traversal(128) - 0.62791) < 1e-4);
    std::vector<std::string> rows(11, "...............");
    for (std::size_t row = 3; row <= 7; ++row) {
      rows[row] = "..mmmmmmmmmm...";
    }
    const PlanResult round = theta(drawn(rows), pose(0.5, 5.5), pose(14.5, 5.5));
    QVERIFY(lengthOf(round.path) > 16.2);
    QVERIFY((round.path[round.path.size() / 2].position - Vec2(7.5, 2.5)).norm() < 1e-9);
    ThetaStarParameters parameters;
    parameters.traversalCost = 0.1;
    const PlanResult straight = theta(drawn(rows), pose(0.5, 5.5), pose(14.5, 5.5), parameters);
    QVERIFY(std::fabs(lengthOf(straight.path) - 14.0) < 1e-9);
  }

  void theta_fourCorners_needNoDiagonals() {
    const Costmap touching = drawn({"##..", "##..", "..##", "..##"});
    ThetaStarParameters parameters;
    QVERIFY(theta(touching, pose(0.5, 0.5), pose(3.5, 3.5), parameters).error == PlanError::None);
    parameters.howManyCorners = 4;
    QVERIFY(theta(touching, pose(0.5, 0.5), pose(3.5, 3.5), parameters).error ==
            PlanError::NoValidPath);
  }

  void theta_unknown_asAllowed() {
    const Costmap costmap = drawn({"..?..", "..?..", "..?.."});
    ThetaStarParameters parameters;
    QVERIFY(theta(costmap, pose(0.5, 1.5), pose(4.5, 1.5), parameters).error == PlanError::None);
    QVERIFY(theta(costmap, pose(0.5, 1.5), pose(2.5, 1.5), parameters).error == PlanError::None);
    parameters.allowUnknown = false;
    QVERIFY(theta(costmap, pose(0.5, 1.5), pose(4.5, 1.5), parameters).error ==
            PlanError::NoValidPath);
    QVERIFY(theta(costmap, pose(0.5, 1.5), pose(2.5, 1.5), parameters).error ==
            PlanError::GoalOccupied);
  }

  void theta_goalOccupied_isTold() {
    const PlanResult result = theta(drawn({"...", ".i.", "..."}), pose(0.5, 0.5), pose(1.5, 1.5));
    QVERIFY(result.error == PlanError::GoalOccupied);
  }

  void theta_noWay_isTold() {
    const PlanResult result = theta(drawn({".#.", ".#.", ".#."}), pose(0.5, 0.5), pose(2.5, 1.5));
    QVERIFY(result.error == PlanError::NoValidPath);
    QVERIFY(result.path.empty());
    // The start twice, after which the cell above it is popped and leaves the queue empty.
    QCOMPARE(result.iterations, 2);
  }

  void theta_startInObstacle_isFreed() {
    const PlanResult result = theta(drawn({"...", "#..", "..."}), pose(0.5, 1.5), pose(2.5, 1.5));
    QVERIFY(result.error == PlanError::None);
  }

  void theta_sameCell_isOnePose() {
    QCOMPARE(theta(drawn({"..."}), pose(1.2, 0.5, 1.0), pose(1.7, 0.2, 2.0)).path,
             Path{pose(1.2, 0.5, 2.0)});
    QVERIFY(theta(drawn({".#."}), pose(1.2, 0.5), pose(1.7, 0.2)).error ==
            PlanError::StartOccupied);
  }

  void theta_approachOrientation_isAlongThePath() {
    ThetaStarParameters parameters;
    parameters.useFinalApproachOrientation = true;
    const Costmap costmap(9, 9, 1.0, Vec2::Zero());
    const PlanResult up = theta(costmap, pose(4.5, 1.5), pose(4.5, 7.5, -1.0), parameters);
    QVERIFY(std::fabs(up.path.back().heading - 0.5 * base::kPi) < 1e-9);
  }

  void smac2D_clutter_isTheCheapestWay() {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      const Costmap costmap = cluttered(70, seed);
      const Cell from{3, 3}, to{66, 66};
      const auto weight = [&](Cell cell) {
        return costmap.at(cell) >= 253 ? never() : 1.0 + costmap.at(cell) / 252.0;
      };
      const std::vector<double> best = cheapest(
          costmap, from, 8, [&](Cell cell, double length) { return length * weight(cell); });
      const PlanResult result = smac(costmap, {costmap.cellToWorld(from), 0.0},
                                     {costmap.cellToWorld(to), 0.0}, unsmoothed());
      QCOMPARE(result.error == PlanError::None, std::isfinite(best[costmap.indexOf(to)]));
      if (result.error != PlanError::None) {
        continue;
      }
      ++found;
      double cost = 0.0;
      for (std::size_t i = 1; i < result.path.size(); ++i) {
        const Vec2 step = result.path[i].position - result.path[i - 1].position;
        cost += step.norm() / costmap.resolution() *
                weight(*costmap.worldToCell(result.path[i].position));
      }
      QVERIFY(std::fabs(cost - best[costmap.indexOf(to)]) < 1e-3);
    }
    QVERIFY(found > 12);
  }

  void smac2D_threeCells_costsByHand() {
    // Past a cell of 128 or over it: 2 sqrt 2 = 2.83 round, 1 + 128/252 + 1 = 2.51 straight; with a
    // multiplier of 2, 3.02.
    const Costmap costmap = drawn({"...", ".m.", "..."});
    Smac2DParameters parameters = unsmoothed();
    QCOMPARE(smac(costmap, pose(0.5, 1.5), pose(2.5, 1.5), parameters).path[1].position,
             Vec2(1.5, 1.5));
    parameters.costTravelMultiplier = 2.0;
    const Path round = smac(costmap, pose(0.5, 1.5), pose(2.5, 1.5), parameters).path;
    QCOMPARE(round.size(), std::size_t{3});
    QCOMPARE(round[1].position, Vec2(1.5, 0.5));  // of the two equal ways the one below comes first
  }

  void smac2D_closedGoal_endsWithinTolerance() {
    Costmap costmap(40, 40, 0.1, Vec2::Zero());
    costmap.set({30, 20}, 254);
    Smac2DParameters parameters = unsmoothed();  // 0.125 m: 1.25 cells
    const PlanResult result = smac(costmap, pose(0.55, 2.05), pose(3.05, 2.05, 1.0), parameters);
    QVERIFY(result.error == PlanError::None);
    QVERIFY((result.path.back().position - Vec2(2.95, 2.05)).norm() < 1e-9);
    QCOMPARE(result.path.back().heading, 1.0);
  }

  void smac2D_closedGoalFarInside_isNoPath() {
    Costmap costmap(40, 40, 0.1, Vec2::Zero());
    fillWindow(costmap, {29, 19, 32, 22}, 254);
    Smac2DParameters parameters = unsmoothed();
    QVERIFY(smac(costmap, pose(0.55, 2.05), pose(3.05, 2.05), parameters).error ==
            PlanError::NoValidPath);
    parameters.tolerance = 0.21;
    QVERIFY(smac(costmap, pose(0.55, 2.05), pose(3.05, 2.05), parameters).error == PlanError::None);
  }

  void smac2D_noTolerance_isGoalOccupied() {
    Smac2DParameters parameters;
    parameters.tolerance = 0.0;
    const PlanResult result =
        smac(drawn({"...", "..i", "..."}), pose(0.5, 1.5), pose(2.5, 1.5), parameters);
    QVERIFY(result.error == PlanError::GoalOccupied);
  }

  void smac2D_maxIterations_isTimeout() {
    const Costmap costmap(40, 40, 0.1, Vec2::Zero());
    Smac2DParameters parameters;
    parameters.maxIterations = 10;
    const PlanResult result = smac(costmap, pose(0.5, 0.5), pose(3.5, 3.5), parameters);
    QVERIFY(result.error == PlanError::Timeout);
    QCOMPARE(result.iterations, 10);
    parameters.maxIterations = 0;  // no limit
    QVERIFY(smac(costmap, pose(0.5, 0.5), pose(3.5, 3.5), parameters).error == PlanError::None);
  }

  void smac2D_planningTime_isIterations() {
    const Costmap costmap(40, 40, 0.1, Vec2::Zero());
    Smac2DParameters parameters;
    parameters.maxPlanningTime = 12e-6;
    const PlanResult result = smac(costmap, pose(0.5, 0.5), pose(3.5, 3.5), parameters);
    QVERIFY(result.error == PlanError::Timeout);
    QCOMPARE(result.iterations, 12);
  }

  void smac2D_onApproach_stopsEarly() {
    // A goal that cannot be reached, but neared: the search goes on for so many iterations.
    Costmap costmap(40, 40, 0.1, Vec2::Zero());
    costmap.set({30, 20}, 254);
    Smac2DParameters parameters = unsmoothed();
    const auto iterations = [&](int most) {
      parameters.maxOnApproachIterations = most;
      return smac(costmap, pose(0.55, 2.05), pose(3.05, 2.05), parameters).iterations;
    };
    QCOMPARE(iterations(30) - iterations(10), 20);
    QCOMPARE(iterations(0), 40 * 40 - 1);  // no limit: every cell but the closed one
  }

  void smac2D_startOccupied_dependsOnDistro() {
    const Costmap costmap = drawn({"...", "#..", "..."});
    QVERIFY(smac(costmap, pose(0.5, 1.5), pose(2.5, 1.5), {}, Distro::Humble).error ==
            PlanError::StartOccupied);
    QVERIFY(smac(costmap, pose(0.5, 1.5), pose(2.5, 1.5), {}, Distro::Jazzy).error ==
            PlanError::None);
  }

  void smac2D_unknown_asAllowed() {
    const Costmap costmap = drawn({"..?..", "..?..", "..?.."});
    Smac2DParameters parameters;
    QVERIFY(smac(costmap, pose(0.5, 1.5), pose(4.5, 1.5), parameters).error == PlanError::None);
    parameters.allowUnknown = false;
    QVERIFY(smac(costmap, pose(0.5, 1.5), pose(4.5, 1.5), parameters).error ==
            PlanError::NoValidPath);
  }

  void smac2D_smoothed_isShorterAndFree() {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      const Costmap costmap = cluttered(70, seed);
      const Pose2 from{costmap.cellToWorld({3, 3}), 0.0}, to{costmap.cellToWorld({66, 66}), 0.4};
      const PlanResult raw = smac(costmap, from, to, unsmoothed());
      const PlanResult smooth = smac(costmap, from, to);
      QCOMPARE(smooth.error, raw.error);
      if (raw.error != PlanError::None) {
        continue;
      }
      ++found;
      QCOMPARE(smooth.path.size(), raw.path.size());
      QCOMPARE(smooth.path.front().position, raw.path.front().position);
      QCOMPARE(smooth.path.back(), Pose2({raw.path.back().position, 0.4}));
      QVERIFY(lengthOf(smooth.path) < lengthOf(raw.path));
      for (const Pose2& each : smooth.path) {
        QVERIFY(costmap.at(*costmap.worldToCell(each.position)) < 253);
      }
    }
    QVERIFY(found > 7);
  }

  void smac2D_downsampled_plansOnCoarserCells() {
    Costmap costmap(40, 40, 0.1, Vec2::Zero());
    Smac2DParameters parameters = unsmoothed();
    parameters.downsampleCostmap = true;
    parameters.downsamplingFactor = 4;
    const Path path = smac(costmap, pose(0.55, 2.05), pose(3.05, 2.05), parameters).path;
    QCOMPARE(path.size(), std::size_t{7});  // columns 1 to 7
    QVERIFY((path.front().position - Vec2(0.6, 2.2)).norm() < 1e-9);
    QVERIFY((path.back().position - Vec2(3.0, 2.2)).norm() < 1e-9);
  }

  void downsampled_costs_areHighestOrLeast() {
    const Costmap fine = drawn({"...m?", "..o..", "#...."}, 0.5);
    const Costmap highest = downsampled(fine, 2, false), least = downsampled(fine, 2, true);
    QCOMPARE(highest.width(), 3);
    QCOMPARE(highest.height(), 2);
    QCOMPARE(highest.resolution(), 1.0);
    QCOMPARE(highest.costs(), (std::vector<std::uint8_t>{254, 252, 0, 0, 128, 255}));
    QCOMPARE(least.costs(), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 255}));
  }

  void both_outside_saysWhich() {
    const Costmap costmap(10, 10, 1.0, Vec2::Zero());
    QVERIFY(theta(costmap, pose(-1, 1), pose(5, 5)).error == PlanError::StartOutsideMap);
    QVERIFY(theta(costmap, pose(1, 1), pose(5, 10)).error == PlanError::GoalOutsideMap);
    QVERIFY(smac(costmap, pose(-1, 1), pose(5, 5)).error == PlanError::StartOutsideMap);
    QVERIFY(smac(costmap, pose(1, 1), pose(5, 10)).error == PlanError::GoalOutsideMap);
  }
};

QTEST_APPLESS_MAIN(Nav2GridPlannersTest)
#include "tst_Nav2GridPlanners.moc"
