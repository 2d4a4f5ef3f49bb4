#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/nav/Lidar.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/world/NeighborGrid.h"
#include "sim2d/world/Physics.h"
#include "sim2d/world/WorldInternal.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Obstacles withBox() {
  Obstacles obstacles;
  obstacles.add({boxOutline({Vec2(5.0, 0.0), 0.0}, 2.0, 2.0)});
  obstacles.build();
  return obstacles;
}

MovingDisc disc(const Vec2& position, const Vec2& velocity) {
  MovingDisc result;
  result.position = position;
  result.velocity = velocity;
  result.radius = 0.4;
  return result;
}

}  // namespace

class WorldPartsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void neighborGrid_anyPlace_findsWhomAFullSearchFinds() {
    std::vector<Vec2> points;
    std::vector<char> present;
    for (int i = 0; i < 300; ++i) {
      points.emplace_back(20.0 * std::sin(1.7 * i), 9.0 * std::cos(2.9 * i));
      present.push_back(i % 7 == 0 ? 0 : 1);
    }
    NeighborGrid grid;
    grid.rebuild(points, present);
    for (int i = 0; i < 60; ++i) {
      const Vec2 centre(25.0 * std::sin(0.9 * i), 15.0 * std::cos(1.1 * i));
      const double range = 0.5 + 0.3 * i;
      std::vector<int> found;
      grid.forEachNear(centre, range, [&](int index) { found.push_back(index); });
      std::sort(found.begin(), found.end());
      std::vector<int> expected;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (present[k] != 0 && (points[k] - centre).norm() <= range) {
          expected.push_back(static_cast<int>(k));
        }
      }
      QVERIFY(found == expected);
    }
  }

  void neighborGrid_nobody_findsNobody() {
    NeighborGrid grid;
    grid.rebuild({Vec2(1.0, 1.0)}, {0});
    grid.forEachNear(Vec2(1.0, 1.0), 10.0, [](int) { QFAIL("somebody"); });
  }

  void keepApart_headOn_leavesTheGap() {
    std::vector<MovingDisc> discs = {disc({0.0, 0.0}, {1.5, 0.0}), disc({0.9, 0.0}, {-1.5, 0.0})};
    discs[1].mass = 160.0;
    keepApart(discs, {{0, 1}}, 0.05);
    const double closing = discs[0].velocity.x() - discs[1].velocity.x();
    QVERIFY(std::fabs(closing * 0.05 - 0.0995) < 1e-6);  // of the gap of 0.1 half a mm is left
    // What the pair did together stays as it was.
    QVERIFY(std::fabs(80.0 * discs[0].velocity.x() + 160.0 * discs[1].velocity.x() + 120.0) < 1e-9);
  }

  void keepApart_chainAtAWall_stopsAll() {
    std::vector<MovingDisc> discs;
    discs.reserve(3);
    for (int i = 0; i < 3; ++i) {
      discs.push_back(disc({0.8 * i, 0.0}, {1.5, 0.0}));
    }
    Obstacles::Point wall;
    wall.position = Vec2(2.0, 0.0);
    wall.distance = 0.4;
    const std::vector<Obstacles::Point> walls = {wall};
    discs[2].walls = &walls;
    keepApart(discs, {{0, 1}, {1, 2}}, 0.05);
    for (const MovingDisc& each : discs) {
      QVERIFY(each.velocity.x() < 0.25);
    }
  }

  void keepApart_slidingAlong_losesNothing() {
    std::vector<MovingDisc> discs = {disc({0.0, 0.0}, {0.0, 1.0}), disc({0.8, 0.0}, {0.0, -1.0})};
    keepApart(discs, {{0, 1}}, 0.05);
    QVERIFY(discs[0].velocity == Vec2(0.0, 1.0) && discs[1].velocity == Vec2(0.0, -1.0));
  }

  void physics_untouched_movesInDouble() {
    Physics physics(Vec2(100.0, -50.0));
    const int body = physics.addBody({{Vec2(101.1, -50.3), 0.0}, 0.4, 80.0, {}, true});
    Vec2 exact(101.1, -50.3);
    for (int i = 0; i < 1000; ++i) {
      const Vec2 velocity(1.3 * std::cos(0.01 * i), 1.3 * std::sin(0.01 * i));
      physics.setVelocity(body, velocity, 0.0);
      physics.step(0.05);
      exact += velocity * 0.05;
    }
    QVERIFY((physics.pose(body).position - exact).norm() < 2e-3);
    QVERIFY(physics.velocity(body).norm() > 1.2999);
  }

  void physics_pressedIntoAWall_staysOutside() {
    Physics physics(Vec2::Zero());
    physics.addPart({boxOutline({Vec2(2.0, 0.0), 0.0}, 1.0, 6.0)}, true);
    const int body = physics.addBody({{Vec2(0.5, 0.0), 0.0}, 0.4, 80.0, {}, true});
    for (int i = 0; i < 200; ++i) {
      physics.setVelocity(body, Vec2(1.0, 0.5), 0.0);
      physics.step(0.02);
      QVERIFY(physics.pose(body).position.x() <= 1.1 + 0.03);
    }
    QVERIFY(physics.pose(body).position.y() > 1.0);  // slides along
  }

  void physics_touches_beginAndLast() {
    Physics physics(Vec2::Zero());
    physics.addPart({boxOutline({Vec2(2.0, 0.0), 0.0}, 1.0, 6.0)}, true);
    const int body = physics.addBody({{Vec2(0.9, 0.0), 0.0}, 0.4, 80.0, {}, true});
    std::vector<Contact> none;
    std::vector<Contact> currentContacts;
    physics.setVelocity(body, Vec2(1.0, 0.0), 0.0);
    physics.step(0.1);
    physics.currentContacts(none, currentContacts);
    physics.step(0.1);
    physics.currentContacts(none, currentContacts);
    physics.step(0.1);
    physics.currentContacts(none, currentContacts);
    QCOMPARE(currentContacts.size(), std::size_t{1});
    QCOMPARE(currentContacts[0].part, 0);
    QVERIFY((currentContacts[0].normal - Vec2(1.0, 0.0)).norm() < 1e-6);
    physics.setPartEnabled(0, false);
    for (int i = 0; i < 20; ++i) {
      physics.setVelocity(body, Vec2(1.0, 0.0), 0.0);
      physics.step(0.1);
    }
    QVERIFY(physics.pose(body).position.x() > 2.0);
  }

  void convexPieces_polygon_coverItsArea() {
    std::vector<Vec2> star;
    star.reserve(20);
    for (int i = 0; i < 20; ++i) {
      star.push_back((i % 2 == 0 ? 1.0 : 0.5) *
                     base::directionOf(base::wrapToPi(i * 0.1 * base::kPi)));
    }
    double area = 0.0;
    for (const std::vector<Vec2>& piece : convexPieces(star, 8)) {
      QVERIFY(piece.size() <= 8);
      area += signedArea(piece);
    }
    QVERIFY(std::fabs(area - signedArea(star)) < 1e-9);
    QCOMPARE(convexPieces({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, 8).size(),
             std::size_t{1});
  }

  void isInView_behindOrHidden_isFalse() {
    const Obstacles obstacles = withBox();
    constexpr double kHalfAngle = base::kPi / 2.0 + 0.17;
    const Pose2 eye{Vec2::Zero(), 0.0};
    QVERIFY(isInView(eye, Vec2(3.0, 1.0), 5.0, kHalfAngle, obstacles));
    QVERIFY(!isInView(eye, Vec2(7.0, 0.0), 10.0, kHalfAngle, obstacles));   // behind the box
    QVERIFY(!isInView(eye, Vec2(-3.0, 0.0), 10.0, kHalfAngle, obstacles));  // behind the back
    QVERIFY(!isInView(eye, Vec2(3.0, 1.0), 3.0, kHalfAngle, obstacles));    // too far
  }

  void scan_wallsAndBodies_givesDistances() {
    std::vector<SensedBody> bodies(1);
    bodies[0].position = Vec2(0.0, 3.0);
    bodies[0].radius = 0.5;
    LidarParameters parameters;
    parameters.beams = 4;
    parameters.range = 10.0;
    parameters.angleMin = 0.0;
    parameters.angleMax = 2.0 * base::kPi;
    parameters.legs = false;
    const Obstacles obstacles = withBox();
    Lidar lidar(parameters, 1, -1);
    QVERIFY(lidar.update({Pose2{}, Pose2{}, obstacles, bodies, 0.0}));
    const LaserScan& result = *lidar.scan();
    QCOMPARE(result.distances.size(), std::size_t{4});
    QVERIFY(std::fabs(result.distances[0] - 4.0) < 1e-9);
    QVERIFY(std::fabs(result.distances[1] - 2.5) < 1e-9);
    QCOMPARE(result.distances[2], 10.0);
    QCOMPARE(result.distances[3], 10.0);
  }

  void compatibility_parse_knowsWhatCanBeSwitched() {
    const base::Result<Compatibility> some = Compatibility::parse("Q-13, q-20");
    QVERIFY(some && (*some).has(13) && (*some).has(20) && !(*some).has(34) && !(*some).hunav2());
    QVERIFY((*some).names() == (std::vector<std::string>{"Q-13", "Q-20"}));
    const base::Result<Compatibility> all = Compatibility::parse("hunav2");
    QVERIFY(all && (*all).hunav2() && (*all).has(34) && !(*all).has(1));
    QVERIFY((*all).names().front() == "hunav2");
    QVERIFY(!Compatibility::parse("Q-01"));  // a crash
    QVERIFY(!Compatibility::parse("Q-77"));
    QVERIFY(!Compatibility::parse("hunav3"));
  }

  void names_forLists_areThere() {
    const auto has = [](const std::vector<std::string>& names, const char* name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const char* name : {"das", "orca", "sfm", "sfm-hunav2"}) {
      QVERIFY2(has(builtinRegistries().models.names(), name), name);
    }
    QVERIFY(has(builtinRegistries().planners.names(), "pursuit"));
    QVERIFY(has(builtinRegistries().robotTypes.names(), "generic"));
  }
};

QTEST_APPLESS_MAIN(WorldPartsTest)
#include "tst_WorldParts.moc"
