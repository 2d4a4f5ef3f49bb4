#include <algorithm>
#include <memory>
#include <vector>

#include <QtTest>

#include "tests/world/TestWorld.h"

using namespace testworld;

/// The ways that people follow, in frames for whoever asks.
class HumanPathsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ways_nobodyAsks_areNone() {
    Scenario scenario;
    addGoal(scenario, 1, 4.0, 0.0);
    addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
    const auto world = make(scenario);
    QVERIFY(world->step());
    QVERIFY(world->frame().humanPaths == nullptr);
  }

  /// Round the upper end of a wall at (2, 1): by way points above it, then to the goal. The
  /// straight lines by that end are 2 sqrt(5) = 4.47 m long.
  void way_roundAWall_leadsByItsEnd() {
    Scenario scenario;
    addWall(scenario, {{2.0, -3.0}, {2.0, 1.0}});
    addGoal(scenario, 1, 4.0, 0.0);
    addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
    addPerson(scenario, 2, Vec2(-3.0, 0.0));  // stands
    const auto world = make(scenario);
    world->publishSensors(true);
    QVERIFY(world->step());
    const auto ways = world->frame().humanPaths;
    QVERIFY(ways != nullptr);
    QCOMPARE(ways->size(), std::size_t{2});
    QVERIFY(ways->at(1).empty());
    const std::vector<Vec2>& way = ways->at(0);
    QVERIFY(way.size() >= 2);
    QVERIFY((way.back() - Vec2(4.0, 0.0)).norm() < 1e-9);
    double length = 0.0;
    double highest = 0.0;
    Vec2 last(0.0, 0.0);
    for (const Vec2& point : way) {
      length += (point - last).norm();
      highest = std::max(highest, point.y());
      last = point;
    }
    QVERIFY(highest > 1.3 && highest < 2.0);  // by the radius of 0.4 m and a little
    QVERIFY(length > 4.47 && length < 5.6);
  }

  void way_whoArrived_isNone() {
    Scenario scenario;
    addWall(scenario, {{2.0, -3.0}, {2.0, 1.0}});
    addGoal(scenario, 1, 4.0, 0.0);
    addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
    const auto world = make(scenario);
    world->publishSensors(true);
    bool hasWalked = false;
    for (int k = 0; k < 400; ++k) {
      QVERIFY(world->step());
      hasWalked = hasWalked || !world->frame().humanPaths->at(0).empty();
    }
    QVERIFY(hasWalked);
    QVERIFY(world->frame().humanPaths->at(0).empty());
    world->publishSensors(false);
    QVERIFY(world->step());
    QVERIFY(world->frame().humanPaths == nullptr);
  }
};

QTEST_APPLESS_MAIN(HumanPathsTest)
#include "tst_HumanPaths.moc"
