#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <QtTest>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/SmacPoseSearch.h"
#include "tests/nav/CostmapSketch.h"

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

namespace {

constexpr double kQuarter = base::kPi / 2.0;

LatticePrimitive primitiveOf(int start, int turn, double length, double arc) {
  LatticePrimitive primitive;
  primitive.startHeading = start;
  primitive.endHeading = (start + turn + 4) % 4;
  primitive.isLeftTurn = turn >= 0;
  primitive.length = length;
  primitive.arcLength = arc;
  const double from = start * kQuarter;
  const Pose2 frame{{0.0, 0.0}, from};
  for (int i = 0; i <= 8; ++i) {
    const double share = i / 8.0, angle = turn * kQuarter * share;
    Vec2 place(length * share, 0.0);
    if (arc > 0.0) {
      const double radius = 0.2;
      place = {radius * std::abs(std::sin(angle)), turn * radius * (1.0 - std::cos(angle))};
    }
    primitive.poses.push_back({frame.toWorld(place), base::wrapToPi(from + angle)});
  }
  return primitive;
}

std::shared_ptr<const Lattice> handMade(bool turnsOnTheSpot = true) {
  auto lattice = std::make_shared<Lattice>();
  lattice->turningRadius = 0.2;
  for (int i = 0; i < 4; ++i) {
    lattice->headings.push_back(base::wrapToPi(i * kQuarter));
    std::vector<LatticePrimitive> primitives = {primitiveOf(i, 0, 0.1, 0.0),
                                                primitiveOf(i, 1, 0.2 * kQuarter, 0.2 * kQuarter),
                                                primitiveOf(i, -1, 0.2 * kQuarter, 0.2 * kQuarter)};
    if (turnsOnTheSpot) {
      primitives.push_back(primitiveOf(i, 1, 0.0, 0.0));
      primitives.push_back(primitiveOf(i, -1, 0.0, 0.0));
    }
    lattice->primitives.push_back(primitives);
  }
  return lattice;
}

SmacLatticeParameters parametersOf(bool turnsOnTheSpot = true) {
  SmacLatticeParameters parameters;
  parameters.lattice = handMade(turnsOnTheSpot);
  parameters.smoothPath = false;
  return parameters;
}

PlanResult planned(const SmacLatticeParameters& parameters, const Costmap& costmap,
                   const Pose2& start, const Pose2& goal) {
  return makeGlobalPlanner(parameters, Distro::Jazzy)->plan(PlanRequest(costmap, start, goal));
}

bool goesBackward(const Path& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 way = path[i].position - path[i - 1].position;
    if (way.norm() > 0.01 && way.dot(path[i - 1].direction()) < -1e-6) {
      return true;
    }
  }
  return false;
}

}  // namespace

/// Smac Lattice over a lattice of four headings that is made by hand: straight on by 0.1 m, quarter
/// circles of 0.2 m, turns on the spot.
class Nav2LatticeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// In cells of 0.05 m: straight 2 cells, an arc 6.283. Reward 1 - 0.015, cost penalty 2.
  void cost_ofPrimitives_byHand() {
    const SmacLatticeParameters parameters = parametersOf();
    const auto cost = [&](const LatticePrimitive* before, const LatticePrimitive& primitive,
                          bool isBackward, double cellCost) {
      return latticeCost(parameters, Distro::Jazzy, 0.05, {before, primitive, isBackward},
                         cellCost);
    };
    const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    const auto& prims = parameters.lattice->primitives[0];
    const double arc = 0.2 * kQuarter / 0.05;
    QVERIFY(isNear(cost(nullptr, prims[1], false, 100.0), arc));  // the first is its length
    QVERIFY(isNear(cost(&prims[1], prims[0], false, 0.0), 2.0 * 0.985));
    QVERIFY(isNear(cost(&prims[1], prims[0], false, 126.0), 2.0 * (0.985 + 2.0 * 0.5)));
    QVERIFY(isNear(cost(&prims[1], prims[1], false, 0.0), arc * 0.985 * 1.05));
    QVERIFY(isNear(cost(&prims[1], prims[2], false, 0.0), arc * 0.985 * 1.10));
    QVERIFY(isNear(cost(&prims[1], prims[0], true, 0.0), 2.0 * 0.985 * 2.0));
    QVERIFY(isNear(cost(&prims[1], prims[3], false, 126.0), 5.0 * (1.0 + 2.0 * 0.5)));
  }

  void plan_freeMap_endsAtTheGoal() {
    const Costmap costmap(100, 100, 0.05, {0.0, 0.0});
    const Pose2 goal{{4.02, 3.02}, kQuarter};
    const PlanResult result = planned(parametersOf(), costmap, {{1.02, 1.02}, 0.0}, goal);
    QCOMPARE(int(result.error), int(PlanError::None));
    QVERIFY((result.path.front().position - Vec2(1.025, 1.025)).norm() < 1e-9);
    QVERIFY((result.path.back().position - Vec2(4.025, 3.025)).norm() < 1e-9);
    QVERIFY(std::abs(base::angleDiff(result.path.back().heading, kQuarter)) < 1e-9);
    const double least = (goal.position - Vec2(1.025, 1.025)).norm();
    const double length = costs::lengthOf(result.path);
    QVERIFY2(length > least && length < 1.45 * least, qPrintable(QString::number(length)));
    QVERIFY(!goesBackward(result.path));
  }

  void plan_wall_isGoneAround() {
    Costmap costmap(100, 100, 0.05, {0.0, 0.0});
    fillWindow(costmap, {50, 0, 51, 70}, kLethal);
    costs::inflate(costmap, 0.15, 0.5, 3.0);
    const PlanResult result =
        planned(parametersOf(), costmap, {{1.0, 1.0}, 0.0}, {{4.0, 1.0}, 0.0});
    QCOMPARE(int(result.error), int(PlanError::None));
    QVERIFY(costs::highestUnder(costmap, result.path) < 253);
    const auto highest = std::max_element(
        result.path.begin(), result.path.end(),
        [](const Pose2& a, const Pose2& b) { return a.position.y() < b.position.y(); });
    QVERIFY(highest->position.y() > 3.5);
  }

  /// A goal 0.5 m behind.
  void plan_backward_onlyWhereItIsAllowed() {
    const Costmap costmap(100, 100, 0.05, {0.0, 0.0});
    const Pose2 start{{2.5, 2.5}, 0.0}, goal{{2.0, 2.5}, 0.0};
    SmacLatticeParameters parameters = parametersOf(false);
    const PlanResult forward = planned(parameters, costmap, start, goal);
    QCOMPARE(int(forward.error), int(PlanError::None));
    QVERIFY(!goesBackward(forward.path));
    parameters.allowReverseExpansion = true;
    const PlanResult either = planned(parameters, costmap, start, goal);
    QVERIFY(goesBackward(either.path));
    QVERIFY(costs::lengthOf(either.path) < 0.7);
    QVERIFY(costs::lengthOf(forward.path) > 1.5);
  }

  /// A dead end of 0.3 m: no arc fits, the robot turns round where it stands.
  void plan_turnOnTheSpot_isUsedWhereNothingElseFits() {
    Costmap costmap(60, 20, 0.05, {0.0, 0.0}, kLethal);
    for (int column = 2; column < 58; ++column) {
      fillWindow(costmap, {column, 8, column + 1, 12}, kFreeSpace);
    }
    const Pose2 start{{0.5, 0.5}, base::kPi}, goal{{2.5, 0.5}, 0.0};
    const PlanResult turned = planned(parametersOf(true), costmap, start, goal);
    QCOMPARE(int(turned.error), int(PlanError::None));
    const PlanResult stuck = planned(parametersOf(false), costmap, start, goal);
    QCOMPARE(int(stuck.error), int(PlanError::NoValidPath));
  }

  /// A curve may exceed the maximum cost at its end: the same path as with the exception for short
  /// curves (1 m is less than a circle, 1.26 m), which would accept it anyway.
  void plan_goalAmongCosts_isReachedByACurve() {
    Costmap costmap(100, 100, 0.05, {0.0, 0.0});
    fillWindow(costmap, {56, 40, 66, 60}, 240);
    const Pose2 start{{2.02, 2.52}, 0.0}, goal{{3.02, 2.56}, 0.0};
    SmacLatticeParameters parameters = parametersOf();
    const Path path = planned(parameters, costmap, start, goal).path;
    parameters.analyticExpansionMaxCostOverride = true;
    QVERIFY(path.size() > 2);
    QCOMPARE(path, planned(parameters, costmap, start, goal).path);
  }

  void plan_failures() {
    Costmap costmap(100, 100, 0.05, {0.0, 0.0});
    const SmacLatticeParameters parameters = parametersOf();
    const Pose2 inside{{1.0, 1.0}, 0.0}, outside{{9.0, 1.0}, 0.0};
    QCOMPARE(int(planned(parameters, costmap, outside, inside).error),
             int(PlanError::StartOutsideMap));
    QCOMPARE(int(planned(parameters, costmap, inside, outside).error),
             int(PlanError::GoalOutsideMap));
    for (int row = 0; row < 100; ++row) {  // two cells: as in Nav2 a step may leap over one
      costmap.set({50, row}, kLethal);
      costmap.set({51, row}, kLethal);
    }
    QCOMPARE(int(planned(parameters, costmap, inside, {{4.0, 1.0}, 0.0}).error),
             int(PlanError::NoValidPath));
  }

  void lattice_withoutItsFile_isSmacHybrid() {
    SmacLatticeParameters parameters;
    parameters.tolerance = 0.4;
    parameters.allowReverseExpansion = true;
    parameters.smootherMaxIterations = 7;
    const SmacHybridParameters hybrid = hybridFallback(parameters, Distro::Jazzy);
    QCOMPARE(hybrid.tolerance, 0.4);
    QCOMPARE(hybrid.motionModelForSearch, std::string("REEDS_SHEPP"));
    QCOMPARE(hybrid.smootherMaxIterations, 7);
    const Costmap costmap(100, 100, 0.05, {0.0, 0.0});
    QCOMPARE(int(planned(parameters, costmap, {{1.0, 1.0}, 0.0}, {{4.0, 1.0}, 0.0}).error),
             int(PlanError::None));
  }
};

QTEST_APPLESS_MAIN(Nav2LatticeTest)
#include "tst_Nav2Lattice.moc"
