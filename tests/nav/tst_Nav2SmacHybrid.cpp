#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"
#include "sim2d/nav/nav2/global/SmacPoseSearch.h"
#include "tests/nav/CostmapSketch.h"

using namespace costs;
using namespace sim2d::nav2;

namespace {

constexpr double kCell = 0.1;  // [m]

SmacHybridParameters car(const char* model = "DUBIN") {
  SmacHybridParameters parameters;
  parameters.motionModelForSearch = model;
  parameters.minimumTurningRadius = 0.5;
  parameters.smoothPath = false;
  parameters.maxIterations = 5000;
  return parameters;
}

PlanResult planned(const Costmap& costmap, const Pose2& start, const Pose2& goal,
                   const SmacHybridParameters& parameters = car(), Distro distro = Distro::Main) {
  return makeGlobalPlanner(parameters, distro)->plan({costmap, start, goal});
}

/// Whether each pose can be driven to from the one before: the shortest curve of circles a hair
/// smaller is about as long as a step; were it not possible, there would be a loop of over 2 m.
bool isDrivable(const Path& path, CarMotion motion) {
  constexpr double kLongestStep = 0.176;  // [m]: four bins of 5 degrees on the circle of 0.5 m
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double curve = shortestCurve(motion, path[i - 1], path[i], 0.499).length();
    const double turn = std::fabs(base::angleDiff(path[i].heading, path[i - 1].heading));
    if (curve > kLongestStep || 0.5 * turn > curve + 1e-3) {
      return false;
    }
  }
  return true;
}

}  // namespace

class Nav2SmacHybridTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void steps_defaultCar_areByHand() {
    // R = 0.4 m at 0.05 m: 8 cells. 2 asin(sqrt 2 / 16) = 0.17701 rad are 2.03 bins of 5
    // degrees: 3.
    const HybridMotion motion(SmacHybridParameters(), 0.05, Distro::Jazzy);
    QCOMPARE(motion.turningRadius, 8.0);
    QCOMPARE(motion.steps.size(), std::size_t{3});
    const double angle = 15.0 * base::kPi / 180.0;
    const HybridStep& left = motion.steps[1];
    QCOMPARE(left.bins, 3);
    QVERIFY(std::fabs(left.dx - 8.0 * std::sin(angle)) < 1e-12);
    QVERIFY(std::fabs(left.dy - 8.0 * (1.0 - std::cos(angle))) < 1e-12);
    QVERIFY(std::fabs(left.length - 8.0 * angle) < 1e-12);
    const HybridStep& straight = motion.steps[0];
    QVERIFY(std::fabs(straight.dx - std::hypot(left.dx, left.dy)) < 1e-12);
    QCOMPARE(straight.bins, 0);
    QCOMPARE(motion.steps[2].bins, -3);
    QCOMPARE(motion.steps[2].dy, -left.dy);
    // Seen from a heading of 90 degrees (bin 18).
    QVERIFY((motion.offset(1, 18) - Vec2(-left.dy, left.dx)).norm() < 1e-12);
    QCOMPARE(motion.nearestBin(-0.01), 0);
    QCOMPARE(motion.nearestBin(-0.06), 71);
    QCOMPARE(motion.nearestBin(base::kPi), 36);
  }

  void steps_dependOnDistroAndModel() {
    SmacHybridParameters parameters;
    const HybridMotion humble(parameters, 0.05, Distro::Humble);
    QVERIFY(std::fabs(humble.steps[1].length - 2.0 * 8.0 * std::sin(7.5 * base::kPi / 180.0)) <
            1e-12);  // the chord
    parameters.motionModelForSearch = "REEDS_SHEPP";
    const HybridMotion both(parameters, 0.05, Distro::Jazzy);
    QCOMPARE(both.steps.size(), std::size_t{6});
    QVERIFY(both.steps[4].isBackward);
    QCOMPARE(both.steps[4].dx, -both.steps[1].dx);
    QCOMPARE(both.steps[4].dy, both.steps[1].dy);
    QCOMPARE(both.steps[4].bins, -3);  // backward on the left circle turns right
    parameters.minimumTurningRadius = 0.01;
    QCOMPARE(HybridMotion(parameters, 0.05, Distro::Jazzy).turningRadius, 1.0);
  }

  void steps_interpolated_fillTheBins() {
    SmacHybridParameters parameters;
    parameters.allowPrimitiveInterpolation = true;
    const HybridMotion motion(parameters, 0.05, Distro::Main);
    QCOMPARE(motion.steps.size(), std::size_t{7});
    std::vector<int> bins;
    const double chord = motion.steps[0].dx;
    for (const HybridStep& step : motion.steps) {
      bins.push_back(step.bins);
      QVERIFY(std::fabs(std::hypot(step.dx, step.dy) - chord) < 1e-12);
      // The direction of an arc's chord is half its turn.
      QVERIFY(std::fabs(std::atan2(step.dy, step.dx) - 0.5 * step.bins * motion.binSize) < 1e-12);
    }
    std::sort(bins.begin(), bins.end());
    QCOMPARE(bins, (std::vector<int>{-3, -2, -1, 0, 1, 2, 3}));
    QCOMPARE(HybridMotion(parameters, 0.05, Distro::Humble).steps.size(), std::size_t{3});
  }

  void cost_factors_areByHand() {
    SmacHybridParameters parameters = car("REEDS_SHEPP");
    parameters.changePenalty = 0.3;
    const HybridMotion motion(parameters, 0.05, Distro::Jazzy);
    const HybridStep &straight = motion.steps[0], &left = motion.steps[1], &right = motion.steps[2],
                     &back = motion.steps[3];
    const double free = 1.0 - 0.015, half = free + 2.0 * 126.0 / 252.0;
    const auto isNear = [](double found, double wanted) {
      return std::fabs(found - wanted) < 1e-12;
    };
    QVERIFY(isNear(motion.cost(nullptr, left, 0), left.length * free));
    QVERIFY(isNear(motion.cost(&straight, straight, 126), straight.length * half));
    QVERIFY(isNear(motion.cost(&left, left, 126), left.length * half * 1.2));
    QVERIFY(isNear(motion.cost(&left, right, 126), left.length * half * 1.5));
    QVERIFY(isNear(motion.cost(&straight, left, 0), left.length * free * 1.5));
    QVERIFY(isNear(motion.cost(&straight, back, 0), straight.length * free * 2.0));
    QVERIFY(isNear(motion.cost(&left, motion.steps[4], 0), left.length * free * 1.5 * 2.0));
    parameters.useQuadraticCostPenalty = true;
    const HybridMotion square(parameters, 0.05, Distro::Jazzy);
    QVERIFY(isNear(square.cost(nullptr, straight, 126), straight.length * (free + 2.0 * 0.25)));
    const HybridMotion humble(parameters, 0.05, Distro::Humble);
    QVERIFY(isNear(humble.cost(nullptr, straight, 126), straight.length * half));
  }

  void obstacleDistance_clutter_isDijkstra() {
    const Costmap costmap = cluttered(60, 4);
    const Cell goal{50, 51};
    ObstacleHeuristic distance;
    ObstacleHeuristic::Settings settings;
    settings.isDownsampled = false;
    distance.start(costmap, goal, settings, false);
    // From the goal outward; Dijkstra pays for the cell that it enters.
    const std::vector<double> best = cheapest(costmap, goal, 8, [&](Cell cell, double length) {
      const double cost = costmap.at(cell);
      return cost >= 253.0 ? std::numeric_limits<double>::infinity()
                           : length * (1.0 + 2.0 * cost / 252.0);
    });
    for (int i = 0; i < 3600; ++i) {  // here and there, so that it spreads bit by bit
      const int index = (i * 1237) % 3600;
      const double found = distance.from({index % 60, index / 60});
      const double wanted = best[static_cast<std::size_t>(index)];
      QVERIFY(std::isfinite(wanted) ? std::fabs(found - wanted) < 1e-9 : found == 0.0);
    }
  }

  void obstacleDistance_downsampled_isNotAbove() {
    const Costmap costmap = cluttered(60, 4);
    ObstacleHeuristic fine, coarse;
    ObstacleHeuristic::Settings settings;
    coarse.start(costmap, {50, 51}, settings, false);
    settings.isDownsampled = false;
    fine.start(costmap, {50, 51}, settings, false);
    int compared = 0;
    for (int i = 0; i < 3600; ++i) {
      const Cell cell{i % 60, i / 60};
      if (fine.from(cell) > 0.0) {
        ++compared;
        QVERIFY(coarse.from(cell) <= fine.from(cell) + 4.0);  // up to two cells at each end
      }
    }
    QVERIFY(compared > 1500);
    const Costmap open(40, 40, 1.0, Vec2::Zero());
    coarse.start(open, {4, 4}, {}, false);
    QCOMPARE(coarse.from({24, 5}), 20.0);  // ten coarse cells
  }

  void obstacleDistance_kept_onlyForTheSameGoal() {
    Costmap costmap(30, 30, 1.0, Vec2::Zero());
    ObstacleHeuristic distance;
    distance.start(costmap, {4, 4}, {}, true);
    QCOMPARE(distance.from({24, 4}), 20.0);
    for (int row = 0; row < 28; ++row) {
      costmap.set({14, row}, 254);
      costmap.set({15, row}, 254);
    }
    distance.start(costmap, {4, 4}, {}, true);
    QCOMPARE(distance.from({24, 4}), 20.0);
    distance.start(costmap, {4, 4}, {}, false);
    QVERIFY(distance.from({24, 4}) > 45.0);
    distance.start(costmap, {8, 4}, {}, true);
    QVERIFY(distance.from({24, 4}) > 40.0);
  }

  void curveDistance_isTheRoundedCurve() {
    DistanceHeuristic distance(CarMotion::Dubins, 5.0, 72, 41);
    const auto exact = [](double x, double y, int bin) {
      return shortestCurve(CarMotion::Dubins, pose(x, y, bin * base::kPi / 36.0), {}, 5.0).length();
    };
    QVERIFY(std::fabs(distance.from({7.2, 3.4}, 10) - exact(7, 3, 10)) < 1e-5);
    QVERIFY(std::fabs(distance.from({7.2, -3.4}, 10) - exact(7, -3, 10)) < 1e-5);
    QVERIFY(std::fabs(distance.from({-20.4, 20.4}, 71) - exact(-20, 20, 71)) < 1e-5);
    QCOMPARE(distance.from({20.6, 0.0}, 0), 0.0);  // beyond the square
    QCOMPARE(distance.from({0.0, 0.0}, 0), 0.0);
  }

  void plan_open_isNearTheShortestCurve_data() {
    QTest::addColumn<QString>("model");
    QTest::newRow("Dubins") << "DUBIN";
    QTest::newRow("Reeds and Shepp") << "REEDS_SHEPP";
  }

  void plan_open_isNearTheShortestCurve() {
    QFETCH(QString, model);
    const Costmap costmap(120, 120, kCell, {-6.0, -6.0});
    const SmacHybridParameters parameters = car(model.toLatin1().constData());
    const CarMotion motion =
        model == QLatin1String("DUBIN") ? CarMotion::Dubins : CarMotion::ReedsShepp;
    Numbers numbers(11);
    const auto planner = makeGlobalPlanner(parameters, Distro::Main);
    for (int i = 0; i < 15; ++i) {
      const auto random = [&] {  // headings in bins, so that none is rounded
        const int bin = static_cast<int>(numbers.between(-36, 36));
        return pose(numbers.between(-3, 3), numbers.between(-3, 3), bin * base::kPi / 36.0);
      };
      const Pose2 start = random(), goal = random();
      const PlanResult result = planner->plan({costmap, start, goal});
      QVERIFY(result.error == PlanError::None);
      QVERIFY((result.path.front().position - start.position).norm() < 1e-9);
      QVERIFY(isDrivable(result.path, motion));
      const double best = shortestCurve(motion, start, goal, 0.5).length();
      const Vec2 miss = result.path.back().position - goal.position;
      QVERIFY(miss.norm() < 0.25 + 1e-9);  // the tolerance
      QVERIFY2(
          lengthOf(result.path) < 1.35 * best + 0.5,
          qPrintable(QStringLiteral("%1: %2, %3").arg(i).arg(lengthOf(result.path)).arg(best)));
      QVERIFY(lengthOf(result.path) > 0.98 * (goal.position - start.position).norm() - 0.25);
    }
  }

  void plan_clutter_keepsTurningRadiusAndClear_data() { plan_open_isNearTheShortestCurve_data(); }

  void plan_clutter_keepsTurningRadiusAndClear() {
    QFETCH(QString, model);
    const CarMotion motion =
        model == QLatin1String("DUBIN") ? CarMotion::Dubins : CarMotion::ReedsShepp;
    int found = 0;
    for (std::uint64_t seed = 5; seed <= 12; ++seed) {
      const Costmap costmap = cluttered(90, seed);
      const Pose2 start{costmap.cellToWorld({4, 4}), 0.5}, goal{costmap.cellToWorld({82, 82}), 1.0};
      const PlanResult result =
          planned(costmap, start, goal, car(model.toLatin1().constData()), Distro::Main);
      if (result.error != PlanError::None) {  // some need a longer search, some have no way
        QVERIFY(result.error == PlanError::NoValidPath || result.error == PlanError::Timeout);
        continue;
      }
      ++found;
      QVERIFY(isDrivable(result.path, motion));
      QVERIFY(highestUnder(costmap, result.path) < 254);
      for (std::size_t i = 1; i < result.path.size(); ++i) {
        QVERIFY(costmap.at(*costmap.worldToCell(result.path[i].position)) < 253);
        if (motion == CarMotion::Dubins) {
          const Vec2 way = result.path[i].position - result.path[i - 1].position;
          QVERIFY(way.dot(result.path[i - 1].direction()) > 0.0);  // never backward
        }
      }
    }
    QVERIFY(found > 5);
  }

  void plan_smoothed_keepsEndsAndIsClear() {
    int found = 0;
    for (const char* model : {"DUBIN", "REEDS_SHEPP"}) {
      for (std::uint64_t seed = 8; seed <= 11; ++seed) {
        const Costmap costmap = cluttered(90, seed);
        const Pose2 start{costmap.cellToWorld({4, 4}), 0.5},
            goal{costmap.cellToWorld({82, 82}), 1.0};
        SmacHybridParameters parameters = car(model);
        const PlanResult raw = planned(costmap, start, goal, parameters);
        parameters.smoothPath = true;
        const PlanResult smooth = planned(costmap, start, goal, parameters);
        QCOMPARE(smooth.path.size(), raw.path.size());
        if (raw.path.empty()) {
          continue;
        }
        ++found;
        QVERIFY((smooth.path.front().position - raw.path.front().position).norm() < 1e-9);
        QVERIFY((smooth.path.back().position - raw.path.back().position).norm() < 1e-6);
        QVERIFY(std::fabs(base::angleDiff(smooth.path.front().heading, raw.path.front().heading)) <
                1e-6);
        QVERIFY(std::fabs(base::angleDiff(smooth.path.back().heading, raw.path.back().heading)) <
                1e-6);
        QVERIFY(lengthOf(smooth.path) < 1.01 * lengthOf(raw.path));
        for (const Pose2& each : smooth.path) {
          QVERIFY(costmap.at(*costmap.worldToCell(each.position)) < 253);
        }
      }
    }
    QVERIFY(found > 6);
  }

  void plan_smoothed_leavesAndArrivesAlongItsHeadings() {
    // The chord of an arc of length s lies s / (2 R) off the heading at its end; sweeps alone would
    // pull the path straight.
    const Costmap costmap(120, 120, kCell, {-6.0, -6.0});
    SmacHybridParameters parameters = car();
    parameters.smoothPath = true;
    for (const double heading : {0.5, 1.0, -0.75, 1.5}) {
      const Pose2 start = pose(-4.0, 0.0, heading * base::kPi),
                  goal = pose(4.0, 1.0, -heading * base::kPi);
      const Path path = planned(costmap, start, goal, parameters).path;
      QVERIFY(path.size() > 20);
      const auto offHeading = [](const Pose2& end, const Vec2& way) {
        return std::fabs(base::angleDiff(std::atan2(way.y(), way.x()), end.heading)) -
               way.norm() / (2.0 * 0.5);
      };
      QVERIFY(offHeading(path.front(), path[1].position - path[0].position) < 0.02);
      QVERIFY(offHeading(path.back(), path.back().position - path[path.size() - 2].position) <
              0.02);
    }
  }

  void plan_footprint_fitsWhereItsEdgesDo() {
    // A gap of 0.9 m in a wall, inflated by 0.3 m: a body of 0.6 m x 0.6 m fits, one of 1.2 m x 0.6
    // m fits lengthwise, one 1.0 m wide does not.
    Costmap costmap(80, 60, kCell, Vec2::Zero());
    for (int row = 0; row < 60; ++row) {
      if (row < 26 || row > 34) {
        costmap.set({40, row}, 254);
      }
    }
    inflate(costmap, 0.25, 0.8, 3.0);
    const auto plan = [&](double halfLength, double halfWidth) {
      PlanRequest request(costmap, pose(1.05, 1.55), pose(7.05, 3.05));
      request.footprint = {{halfLength, halfWidth},
                           {-halfLength, halfWidth},
                           {-halfLength, -halfWidth},
                           {halfLength, -halfWidth}};
      return makeGlobalPlanner(car(), Distro::Main)->plan(request);
    };
    QVERIFY(plan(0.3, 0.3).error == PlanError::None);
    const PlanResult lengthwise = plan(0.6, 0.3);
    QVERIFY(lengthwise.error == PlanError::None);
    const Polygon body = {{0.6, 0.3}, {-0.6, 0.3}, {-0.6, -0.3}, {0.6, -0.3}};
    for (const Pose2& each : lengthwise.path) {
      QVERIFY(footprintCost(costmap, body, each) < 254);
    }
    QVERIFY(plan(0.3, 0.5).error != PlanError::None);
  }

  void plan_goalModes_chooseTheHeading() {
    const Costmap costmap(100, 100, kCell, Vec2::Zero());
    const Pose2 start = pose(2.0, 5.0), goal = pose(7.0, 5.0, base::kPi);
    SmacHybridParameters parameters = car();
    const auto last = [&](const char* mode, Distro distro) {
      parameters.goalHeadingMode = mode;
      return planned(costmap, start, goal, parameters, distro).path.back().heading;
    };
    QVERIFY(std::fabs(std::fabs(last("DEFAULT", Distro::Main)) - base::kPi) < 1e-6);
    QVERIFY(std::fabs(last("BIDIRECTIONAL", Distro::Main)) < 1e-6);  // straight there
    QVERIFY(std::fabs(std::fabs(last("BIDIRECTIONAL", Distro::Jazzy)) - base::kPi) < 1e-6);
    parameters.coarseSearchResolution = 4;
    QVERIFY(std::fabs(last("ALL_DIRECTION", Distro::Main)) < 0.1);
  }

  void plan_closedGoal_nearOrToldOccupied() {
    Costmap costmap(60, 60, kCell, Vec2::Zero());
    costmap.set({40, 30}, 254);
    SmacHybridParameters parameters = car();
    parameters.maxOnApproachIterations = 200;
    const PlanResult near = planned(costmap, pose(1.0, 3.0), pose(4.05, 3.05), parameters);
    QVERIFY(near.error == PlanError::None);
    QVERIFY((near.path.back().position - Vec2(4.05, 3.05)).norm() < 0.26);
    parameters.tolerance = 0.0;
    QVERIFY(planned(costmap, pose(1.0, 3.0), pose(4.05, 3.05), parameters).error ==
            PlanError::GoalOccupied);
  }

  void plan_noWay_isTold() {
    Costmap costmap(40, 40, kCell, Vec2::Zero());
    for (int row = 0; row < 40; ++row) {
      costmap.set({20, row}, 253);
      costmap.set({21, row}, 253);
      costmap.set({22, row}, 253);
    }
    SmacHybridParameters parameters = car();
    parameters.maxIterations = 1000000;
    const PlanResult result = planned(costmap, pose(1.0, 2.0), pose(3.5, 2.0), parameters);
    QVERIFY(result.error == PlanError::NoValidPath);
    QVERIFY(result.path.empty());
  }

  void plan_iterations_areLimited() {
    const Costmap costmap(100, 100, kCell, Vec2::Zero());
    SmacHybridParameters parameters = car();
    parameters.maxIterations = 5;
    const PlanResult few = planned(costmap, pose(1, 1), pose(9, 9), parameters);
    QVERIFY(few.error == PlanError::Timeout);
    QCOMPARE(few.iterations, 5);
    parameters = car();
    parameters.maxPlanningTime = 7e-5;
    QCOMPARE(planned(costmap, pose(1, 1), pose(9, 9), parameters).iterations, 7);
  }

  void plan_startOccupied_dependsOnDistro() {
    Costmap costmap(60, 60, kCell, Vec2::Zero());
    costmap.set({10, 30}, 254);
    const Pose2 start = pose(1.05, 3.05), goal = pose(4.0, 3.0);
    QVERIFY(planned(costmap, start, goal, car(), Distro::Humble).error == PlanError::StartOccupied);
    QVERIFY(planned(costmap, start, goal, car(), Distro::Jazzy).error == PlanError::None);
  }

  void plan_samePose_isOnePose() {
    const Costmap costmap(60, 60, kCell, Vec2::Zero());
    const PlanResult result = planned(costmap, pose(1.02, 3.02, 0.5), pose(1.06, 3.04, 0.52));
    QVERIFY(result.error == PlanError::None);
    QCOMPARE(result.path.size(), std::size_t{1});
    QVERIFY((result.path[0].position - Vec2(1.02, 3.02)).norm() < 1e-9);
    QCOMPARE(result.path[0].heading, 0.52);
  }

  void plan_endsOfPath_areOnTheGridBeforeMain() {
    const Costmap costmap(60, 60, kCell, Vec2::Zero());
    const Pose2 start = pose(1.02, 3.02), goal = pose(4.08, 3.01);
    const Path jazzy = planned(costmap, start, goal, car(), Distro::Jazzy).path;
    QVERIFY((jazzy.front().position - Vec2(1.05, 3.05)).norm() < 1e-9);
    QVERIFY((jazzy.back().position - Vec2(4.05, 3.05)).norm() < 1e-9);
    const Path main = planned(costmap, start, goal, car(), Distro::Main).path;
    QVERIFY((main.front().position - start.position).norm() < 1e-9);
    QVERIFY((main.back().position - goal.position).norm() < 1e-9);
  }

  void plan_costlyShortcut_isRefusedSinceJazzy() {
    // Between start and goal a ridge of cost 240: Humble cuts straight over it, later ones search.
    Costmap costmap(60, 60, kCell, Vec2::Zero());
    fillWindow(costmap, {28, 22, 32, 39}, 240);
    const Pose2 start = pose(2.05, 3.05), goal = pose(4.05, 3.05);
    SmacHybridParameters parameters = car();
    parameters.costPenalty = 5.0;
    const Path humble = planned(costmap, start, goal, parameters, Distro::Humble).path;
    QCOMPARE(highestUnder(costmap, humble), 240);
    const Path jazzy = planned(costmap, start, goal, parameters, Distro::Jazzy).path;
    QCOMPARE(highestUnder(costmap, jazzy), 0);
    parameters.analyticExpansionMaxCostOverride = true;  // 2 m are less than a circle, 3.1 m
    QCOMPARE(planned(costmap, start, goal, parameters, Distro::Jazzy).path, humble);
  }

  void plan_unknown_asAllowed() {
    Costmap costmap(60, 60, kCell, Vec2::Zero());
    fillWindow(costmap, {28, 0, 33, 60}, 255);
    SmacHybridParameters parameters = car();
    parameters.analyticExpansionMaxCost = 255.0;
    QVERIFY(planned(costmap, pose(1, 3), pose(5, 3), parameters).error == PlanError::None);
    parameters.allowUnknown = false;
    parameters.maxIterations = 1000000;
    QVERIFY(planned(costmap, pose(1, 3), pose(5, 3), parameters).error == PlanError::NoValidPath);
  }

  void plan_outside_saysWhich() {
    const Costmap open(60, 60, kCell, Vec2::Zero());
    QVERIFY(planned(open, pose(1, 3, std::nan("")), pose(5, 3)).error == PlanError::Unknown);
    const Costmap costmap(10, 10, 1.0, Vec2::Zero());
    QVERIFY(planned(costmap, pose(-1, 1), pose(5, 5)).error == PlanError::StartOutsideMap);
    QVERIFY(planned(costmap, pose(1, 1), pose(5, 10)).error == PlanError::GoalOutsideMap);
  }
};

QTEST_APPLESS_MAIN(Nav2SmacHybridTest)
#include "tst_Nav2SmacHybrid.moc"
