#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/NavfnPlanner.h"
#include "tests/nav/CostmapSketch.h"
#include "tests/nav/MetaTypes.h"

using namespace costs;
using namespace sim2d::nav2;

namespace {

PlanResult planned(const Costmap& costmap, const Pose2& start, const Pose2& goal,
                   const NavfnParameters& parameters = {}, Distro distro = Distro::Jazzy) {
  return makeGlobalPlanner(parameters, distro)->plan({costmap, start, goal});
}

std::size_t indexOf(int column, int row, int width) {
  const int index = row * width + column;
  return static_cast<std::size_t>(index);
}

/// Costs of NavFn between 50 and 251 with a few obstacles.
std::vector<std::uint8_t> roughCosts(int width, int height, bool isRough, std::uint64_t seed) {
  Numbers numbers(seed);
  std::vector<std::uint8_t> costs(static_cast<std::size_t>(width * height), 50);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double wave = 60.0 * (1.0 + std::sin(0.21 * column) * std::cos(0.17 * row));
      auto& cost = costs[indexOf(column, row, width)];
      cost = static_cast<std::uint8_t>(isRough ? 50.0 + wave : 50.0);
      if (numbers.next() < 0.04) {
        cost = 254;
      }
    }
  }
  return costs;
}

/// The upwind difference solution of |grad T| = cost, by sweeps until nothing changes.
std::vector<double> eikonal(int width, int height, const std::vector<std::uint8_t>& costs,
                            Cell seed) {
  constexpr double kNever = 1e10;
  std::vector<double> time(costs.size(), kNever);
  const auto at = [&](int column, int row) { return indexOf(column, row, width); };
  time[at(seed.column, seed.row)] = 0.0;
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (int turn = 0; turn < 4; ++turn) {
      for (int i = 1; i + 1 < height; ++i) {
        for (int k = 1; k + 1 < width; ++k) {
          const int row = turn < 2 ? i : height - 1 - i, column = turn % 2 == 0 ? k : width - 1 - k;
          const double cost = costs[at(column, row)];
          if (cost >= 254.0) {
            continue;
          }
          const double a = std::min(time[at(column - 1, row)], time[at(column + 1, row)]);
          const double b = std::min(time[at(column, row - 1)], time[at(column, row + 1)]);
          const double gap = std::fabs(a - b);
          const double found = gap >= cost
                                   ? std::min(a, b) + cost
                                   : 0.5 * (a + b + std::sqrt(2.0 * cost * cost - gap * gap));
          if (found < time[at(column, row)] - 1e-9) {
            time[at(column, row)] = found;
            isChanged = true;
          }
        }
      }
    }
  }
  return time;
}

/// A way of some 60 cells from (11, 1) to (5, 5).
Costmap snake() {
  return drawn({"#############", "#...........#", "#.#########.#", "#.........#.#", "#########.#.#",
                "#.......#.#.#", "#.#####.#.#.#", "#.#...#.#.#.#", "#.#.###.#.#.#", "#.#.....#.#.#",
                "#.#######.#.#", "#.........#.#", "#############"});
}

}  // namespace

class Nav2NavfnTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void costOf_costmapCosts_areNavfns() {
    QCOMPARE(int(NavfnWavefront::costOf(0, true)), 50);
    QCOMPARE(int(NavfnWavefront::costOf(1, true)), 50);  // 50.8
    QCOMPARE(int(NavfnWavefront::costOf(100, true)), 130);
    QCOMPARE(int(NavfnWavefront::costOf(128, true)), 152);
    QCOMPARE(int(NavfnWavefront::costOf(252, true)), 251);
    QCOMPARE(int(NavfnWavefront::costOf(253, true)), 254);
    QCOMPARE(int(NavfnWavefront::costOf(254, true)), 254);
    QCOMPARE(int(NavfnWavefront::costOf(255, true)), 253);
    QCOMPARE(int(NavfnWavefront::costOf(255, false)), 254);
  }

  void descend_threeByThree_isNavfns_data() {
    QTest::addColumn<int>("centre");
    QTest::addColumn<int>("row");  // of the target; the robot is in the opposite corner
    QTest::addColumn<std::vector<Vec2>>("expected");
    using Way = std::vector<Vec2>;
    QTest::newRow("free up") << 50 << 1 << Way{{1, 1}, {2, 2}, {2.35355, 2.35355}, {3, 3}};
    QTest::newRow("free down") << 50 << 3 << Way{{1, 3}, {2, 2}, {2.35355, 1.64645}, {3, 1}};
    QTest::newRow("obstacle up") << 254 << 1 << Way{{1, 1}, {2, 1}, {3, 2}, {3, 3}};
    QTest::newRow("obstacle down") << 254 << 3 << Way{{1, 3}, {1, 2}, {2, 1}, {3, 1}};
    QTest::newRow("radial up") << 100 << 1 << Way{{1, 1}, {2, 2}, {2.35355, 2.35355}, {3, 3}};
  }

  void descend_threeByThree_isNavfns() {
    QFETCH(int, centre);
    QFETCH(int, row);
    QFETCH(std::vector<Vec2>, expected);
    std::vector<std::uint8_t> costs(25, 50);
    costs[12] = static_cast<std::uint8_t>(centre);
    NavfnWavefront wave;
    wave.setCosts(5, 5, costs);
    wave.propagate({3, 4 - row}, {1, row}, true);
    const std::vector<Vec2> path = wave.descend({1, row}, 20);
    QCOMPARE(path.size(), expected.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
      QVERIFY2((path[i] - expected[i]).norm() < 1e-5, qPrintable(QString::number(i)));
    }
  }

  void descend_fewSteps_fails() {
    NavfnWavefront wave;
    wave.setCosts(Costmap(20, 20, 1.0, Vec2::Zero()), true);
    wave.propagate({2, 10}, {10, 10}, false);
    QVERIFY(wave.descend({10, 10}, 1).empty());
    const std::vector<Vec2> path = wave.descend({10, 10}, 80);
    QVERIFY(!path.empty());
    QCOMPARE(path.front(), Vec2(10, 10));
    QCOMPARE(path.back(), Vec2(2, 10));
  }

  void spread_freeSpace_ringsAsByHand() {
    NavfnWavefront wave;
    wave.setCosts(9, 9, std::vector<std::uint8_t>(81, 50));
    wave.propagate({4, 4}, {0, 0}, false);  // a target on the border is never reached
    QCOMPARE(wave.potential({4, 4}), 0.0F);
    for (const Cell ring : {Cell{3, 4}, Cell{5, 4}, Cell{4, 3}, Cell{4, 5}}) {
      QCOMPARE(wave.potential(ring), 50.0F);
    }
    for (const Cell corner : {Cell{3, 3}, Cell{5, 3}, Cell{3, 5}, Cell{5, 5}}) {
      QCOMPARE(wave.potential(corner), 85.2F);
    }
    QCOMPARE(wave.potential({6, 4}), 100.0F);
    // Between 100 beside and 85.2 below: d = 14.8/50, 85.2 + 50 (0.7040 + 0.5307 d - 0.2301 d^2)
    QVERIFY(std::fabs(wave.potential({6, 5}) - 127.2464) < 1e-3);
    QCOMPARE(wave.potential({0, 0}), NavfnWavefront::kUnreached);
  }

  void spread_everywhere_isNearTheEikonalSolution_data() {
    QTest::addColumn<bool>("isRough");
    QTest::newRow("even") << false;
    QTest::newRow("rough") << true;
  }

  void spread_everywhere_isNearTheEikonalSolution() {
    QFETCH(bool, isRough);
    constexpr int kWidth = 90, kHeight = 70;
    auto costs = roughCosts(kWidth, kHeight, isRough, 5);
    const Cell robot{11, 17};
    costs[17 * kWidth + 11] = 50;
    // Neighbours that would gain little are not looked at again, with A* even fewer: so it is
    // above.
    for (const bool useAstar : {false, true}) {
      NavfnWavefront wave;
      wave.setCosts(kWidth, kHeight, costs);
      wave.propagate(robot, {0, 0}, useAstar);
      const std::vector<double> exact = eikonal(kWidth, kHeight, costs, robot);
      int reached = 0;
      for (int row = 1; row + 1 < kHeight; ++row) {
        for (int column = 1; column + 1 < kWidth; ++column) {
          const double time = exact[indexOf(column, row, kWidth)];
          const double found = wave.potential({column, row});
          if ((found < 1e9) != (time < 1e9)) {
            QFAIL(qPrintable(QStringLiteral("%1 %2 is reached or not").arg(column).arg(row)));
          }
          if (time < 1e9) {
            ++reached;
            if (found < 0.995 * time - 1.0 || found > (useAstar ? 1.3 : 1.04) * time + 1.0) {
              QFAIL(qPrintable(
                  QStringLiteral("%1 %2: %3, not %4").arg(column).arg(row).arg(found).arg(time)));
            }
          }
        }
      }
      QVERIFY(reached > 5000);
    }
  }

  void spread_everywhere_isNotAboveFourNeighbours() {
    constexpr int kSide = 60;
    const auto costs = roughCosts(kSide, kSide, true, 9);
    NavfnWavefront wave;
    wave.setCosts(kSide, kSide, costs);
    wave.propagate({30, 30}, {0, 0}, false);
    const Costmap grid(kSide, kSide, 1.0, Vec2::Zero());
    const auto stepCost = [&](Cell to, double) {
      const bool isBorder =
          to.column == 0 || to.row == 0 || to.column == kSide - 1 || to.row == kSide - 1;
      const double cost = costs[grid.indexOf(to)];
      return isBorder || cost >= 254.0 ? std::numeric_limits<double>::infinity() : cost;
    };
    const std::vector<double> upper = cheapest(grid, {30, 30}, 4, stepCost);
    for (int row = 1; row + 1 < kSide; ++row) {
      for (int column = 1; column + 1 < kSide; ++column) {
        if (std::isfinite(upper[grid.indexOf({column, row})])) {
          QVERIFY(wave.potential({column, row}) <= upper[grid.indexOf({column, row})] + 0.1);
        }
      }
    }
  }

  void plan_clutter_isAsCheapAsEightNeighbours_data() {
    QTest::addColumn<bool>("useAstar");
    QTest::newRow("Dijkstra") << false;
    QTest::newRow("A*") << true;
  }

  void plan_clutter_isAsCheapAsEightNeighbours() {
    QFETCH(bool, useAstar);
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      const Costmap costmap = cluttered(80, seed);
      const Cell from{4, 4}, to{75, 74};
      const auto internal = [&](Cell cell) {
        const double cost = costmap.at(cell);
        return cost >= 253.0 ? std::numeric_limits<double>::infinity()
                             : 50.0 + std::floor(0.8 * cost);
      };
      const std::vector<double> best = cheapest(
          costmap, from, 8, [&](Cell cell, double length) { return length * internal(cell); });
      const Vec2 half = Vec2::Constant(0.5 * costmap.resolution());
      NavfnParameters parameters;
      parameters.useAstar = useAstar;
      parameters.tolerance = 0.0;
      const PlanResult result = planned(costmap, {costmap.cellToWorld(from) - half, 0.0},
                                        {costmap.cellToWorld(to) - half, 0.0}, parameters);
      QCOMPARE(result.error == PlanError::None, std::isfinite(best[costmap.indexOf(to)]));
      if (result.error != PlanError::None) {
        continue;
      }
      ++found;
      Path centred = result.path;
      double cost = 0.0;
      for (std::size_t i = 0; i < centred.size(); ++i) {
        centred[i].position += half;
        if (i > 0) {
          const double length = (centred[i].position - centred[i - 1].position).norm();
          const Vec2 middle = 0.5 * (centred[i].position + centred[i - 1].position);
          cost += length / costmap.resolution() * internal(*costmap.worldToCell(middle));
        }
      }
      QVERIFY(highestUnder(costmap, centred) < 254);
      QVERIFY2(
          cost <= (useAstar ? 1.15 : 1.06) * best[costmap.indexOf(to)],
          qPrintable(
              QStringLiteral("%1: %2, %3").arg(seed).arg(cost).arg(best[costmap.indexOf(to)])));
    }
    QVERIFY(found > 15);
  }

  void plan_straight_posesLieOnCornersOfCells() {
    const Costmap costmap(20, 20, 0.5, {1.0, 2.0});
    const PlanResult result = planned(costmap, pose(3.0, 5.0), pose(6.0, 5.0, 1.2));
    QVERIFY(result.error == PlanError::None);
    QCOMPARE(result.path.front(), pose(3.0, 5.0));  // the corner of cell (4, 6), not its centre
    QCOMPARE(result.path.back(), pose(6.0, 5.0, 1.2));
    for (std::size_t i = 0; i + 1 < result.path.size(); ++i) {
      QCOMPARE(result.path[i].heading, 0.0);
      QVERIFY(std::fabs(result.path[i].position.y() - 5.0) < 1e-6);
    }
    QVERIFY(std::fabs(lengthOf(result.path) - 3.0) < 1e-6);
  }

  void plan_mirroredMap_isMirroredPath() {
    const std::vector<std::string> rows = {
        "................", "......##........", "......##........", "......##..###...",
        "..........###...", "................", "....###.........", "................"};
    std::vector<std::string> mirrored(rows.rbegin(), rows.rend());
    const PlanResult one = planned(drawn(rows), pose(1.0, 4.0), pose(14.0, 4.0));
    const PlanResult other = planned(drawn(mirrored), pose(1.0, 3.0), pose(14.0, 3.0));
    QVERIFY(one.error == PlanError::None && other.error == PlanError::None);
    // Cells are mirrored at row 3.5; the descent looks up and right first, so only nearly the same.
    QVERIFY(std::fabs(lengthOf(one.path) - lengthOf(other.path)) < 0.3);
    for (const Pose2& each : other.path) {
      double nearest = 1e9;
      for (const Pose2& twin : one.path) {
        nearest = std::min(
            nearest, (Vec2(each.position.x(), 7.0 - each.position.y()) - twin.position).norm());
      }
      QVERIFY(nearest < 0.8);
    }
  }

  void plan_startIsGoal_isOnePose() {
    const Costmap costmap(10, 10, 1.0, Vec2::Zero());
    PlanResult result = planned(costmap, pose(3.3, 4.4, 0.5), pose(3.3, 4.4, -2.0));
    QCOMPARE(result.path, Path{pose(3.3, 4.4, -2.0)});
    NavfnParameters parameters;
    parameters.useFinalApproachOrientation = true;
    result = planned(costmap, pose(3.3, 4.4, 0.5), pose(3.3, 4.4, -2.0), parameters);
    QCOMPARE(result.path, Path{pose(3.3, 4.4, 0.5)});
  }

  void plan_startIsGoalInWall_isOccupied() {
    const PlanResult result = planned(drawn({"###", "###", "###"}), pose(1.5, 1.5), pose(1.5, 1.5));
    QVERIFY(result.error == PlanError::StartOccupied);
    QVERIFY(result.path.empty());
  }

  void plan_outside_saysWhich() {
    const Costmap costmap(10, 10, 1.0, Vec2::Zero());
    QVERIFY(planned(costmap, pose(-0.1, 4), pose(4, 4)).error == PlanError::StartOutsideMap);
    QVERIFY(planned(costmap, pose(4, 4), pose(4, 10.0)).error == PlanError::GoalOutsideMap);
    QVERIFY(planned(costmap, pose(4, 4), pose(std::nan(""), 4)).error == PlanError::GoalOutsideMap);
    // Rounded, 9.5 is cell 10, which is not there.
    QVERIFY(planned(costmap, pose(4, 4), pose(4, 9.6)).error == PlanError::GoalOutsideMap);
    QVERIFY(planned(Costmap(), pose(0, 0), pose(0, 0)).error == PlanError::StartOutsideMap);
  }

  void plan_closedGoal_endsNearest() {
    Costmap costmap(40, 40, 0.1, Vec2::Zero());
    fillWindow(costmap, {28, 18, 39, 23}, 254);
    NavfnParameters parameters;
    const PlanResult result = planned(costmap, pose(0.5, 2.0), pose(3.0, 2.0, 0.7), parameters);
    QVERIFY(result.error == PlanError::None);
    // Columns 28 on are closed: 2.7 is the nearest free corner; rows 17 and 23 are 0.3 off as well,
    // and the scan comes to row 17 first.
    const Vec2 end = result.path.back().position;
    QVERIFY(std::fabs((end - Vec2(3.0, 2.0)).norm() - 0.3) < 1e-9);
    QVERIFY((end - Vec2(3.0, 1.7)).norm() < 1e-9);
    QCOMPARE(result.path.back().heading, 0.7);
  }

  void plan_closedGoalBeyondTolerance_isNoPath() {
    Costmap costmap(40, 40, 0.1, Vec2::Zero());
    fillWindow(costmap, {24, 14, 37, 27}, 254);
    NavfnParameters parameters;
    QVERIFY(planned(costmap, pose(0.5, 2.0), pose(3.0, 2.0)).error == PlanError::NoValidPath);
    parameters.tolerance = 0.75;
    QVERIFY(planned(costmap, pose(0.5, 2.0), pose(3.0, 2.0), parameters).error == PlanError::None);
  }

  void plan_lethalGoalWithoutTolerance_dependsOnDistro() {
    Costmap costmap(20, 20, 1.0, Vec2::Zero());
    costmap.set({12, 12}, 254);
    NavfnParameters parameters;
    parameters.tolerance = 0.0;
    const Pose2 start = pose(3, 3), goal = pose(12.0, 12.0);
    QVERIFY(planned(costmap, start, goal, parameters, Distro::Main).error ==
            PlanError::GoalOccupied);
    QVERIFY(planned(costmap, start, goal, parameters, Distro::Jazzy).error ==
            PlanError::NoValidPath);
    parameters.tolerance = 1.0;
    QVERIFY(planned(costmap, start, goal, parameters, Distro::Main).error == PlanError::None);
  }

  void plan_unknown_asAllowed() {
    const Costmap costmap = drawn({"########", "#..??..#", "#..??..#", "#..??..#", "########"});
    NavfnParameters parameters;
    parameters.tolerance = 0.0;
    QVERIFY(planned(costmap, pose(1, 2), pose(6, 2), parameters).error == PlanError::None);
    parameters.allowUnknown = false;
    QVERIFY(planned(costmap, pose(1, 2), pose(6, 2), parameters).error == PlanError::NoValidPath);
  }

  void plan_startInObstacle_isFreed() {
    Costmap costmap(20, 20, 1.0, Vec2::Zero());
    costmap.set({5, 5}, 254);
    QVERIFY(planned(costmap, pose(5, 5), pose(15, 5)).error == PlanError::None);
    QCOMPARE(int(costmap.at({5, 5})), 254);  // the caller's map stays
  }

  void plan_wallBetween_isNoPath() {
    const Costmap costmap = drawn({".....#.....", ".....#.....", ".....#.....", ".....#....."});
    const PlanResult result = planned(costmap, pose(2, 2), pose(8, 2));
    QVERIFY(result.error == PlanError::NoValidPath);
    QVERIFY(result.path.empty());
  }

  void plan_lastPose_goalOrBehindIt() {
    const Costmap costmap(30, 30, 1.0, Vec2::Zero());
    // The last pose of the descent is the corner (20, 15), half a step behind (19.5, 15). A goal
    // before it takes its place, one behind it is added.
    const PlanResult before = planned(costmap, pose(5, 15), pose(19.8, 15.0));
    const PlanResult behind = planned(costmap, pose(5, 15), pose(20.3, 15.0));
    QCOMPARE(behind.path.size(), before.path.size() + 1);
    QCOMPARE(before.path.back().position, Vec2(19.8, 15.0));
    QCOMPARE(behind.path.back().position, Vec2(20.3, 15.0));
    QVERIFY((behind.path[behind.path.size() - 2].position - Vec2(20.0, 15.0)).norm() < 1e-6);
    // On the corner itself: Humble has it twice, later ones do not.
    const auto exact = [&](Distro distro) {
      return planned(costmap, pose(5, 15), pose(20.0, 15.0), {}, distro).path;
    };
    QCOMPARE(exact(Distro::Humble).size(), before.path.size() + 1);
    QCOMPARE(exact(Distro::Jazzy).size(), before.path.size());
    QCOMPARE(exact(Distro::Main).size(), before.path.size());
  }

  void plan_approachOrientation_isAlongThePath() {
    const Costmap costmap(30, 30, 1.0, Vec2::Zero());
    NavfnParameters parameters;
    parameters.useFinalApproachOrientation = true;
    const auto last = [&](const Pose2& goal, Distro distro) {
      return planned(costmap, pose(5, 15), goal, parameters, distro).path.back().heading;
    };
    QVERIFY(std::fabs(last(pose(20.3, 15.0, 2.0), Distro::Jazzy)) < 1e-6);
    QVERIFY(std::fabs(last(pose(20.0, 15.0, 2.0), Distro::Humble)) < 1e-6);  // two equal poses
    QVERIFY(std::fabs(last(pose(5.0, 25.3, 2.0), Distro::Jazzy) - 0.5 * base::kPi) < 1e-6);
  }

  void plan_maxCyclesFactor_countsInMainOnly() {
    const Costmap small = snake();
    Costmap costmap(40, 40, 1.0, Vec2::Zero());  // the wave has 80 blocks
    for (int row = 0; row < small.height(); ++row) {
      for (int column = 0; column < small.width(); ++column) {
        costmap.set({column, row}, small.at({column, row}));
      }
    }
    const auto found = [&](int factor, Distro distro) {
      NavfnParameters parameters;
      parameters.tolerance = 0.0;
      parameters.maxCyclesFactor = factor;
      return planned(costmap, pose(11, 1), pose(5, 5), parameters, distro);
    };
    QVERIFY(lengthOf(found(4, Distro::Main).path) > 55.0);
    QVERIFY(found(1, Distro::Main).error == PlanError::NoValidPath);  // 40 steps, a cell each
    QCOMPARE(found(1, Distro::Jazzy).path, found(4, Distro::Main).path);
    QVERIFY(found(1, Distro::Humble).error == PlanError::None);
  }

  void plan_longWayInSmallMap_givesUp() {
    // The wave ends after max(13 * 13 / 20, 13 + 13) blocks, each about one cell here.
    NavfnParameters parameters;
    parameters.tolerance = 0.0;
    const PlanResult result = planned(snake(), pose(11, 1), pose(5, 5), parameters);
    QVERIFY(result.error == PlanError::NoValidPath);
    QVERIFY(result.iterations <= 2 * 26);
  }
};

QTEST_APPLESS_MAIN(Nav2NavfnTest)
#include "tst_Nav2Navfn.moc"
