#include <algorithm>
#include <cmath>
#include <limits>

#include <QtTest>

#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/SweptClearance.h"
#include "tests/nav/DriveWorld.h"

using drive::person;
using drive::robotBody;
using drive::wall;
using drive::World;
using namespace sim2d;

namespace {

constexpr double kFineStep = 0.01;  // [s], so that looks along the way are no part of the result

/// Straight ahead from the origin at a speed, for 3 s.
std::vector<Pose2> straight(double speed) {
  std::vector<Pose2> poses(301);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].position = Vec2(speed * kFineStep * static_cast<double>(i), 0.0);
  }
  return poses;
}

/// Whether a robot at the origin (radius 0.3 m, brakes at 1 m/s²) may drive ahead at this speed.
bool isAdmissible(World& world, double speed, double margin, double hold) {
  const RobotBody body = robotBody(Kinematics::Differential);
  SweptClearance clear(body, 0.6);
  clear.observe(world.observation(), margin, speed, 3.0);
  const std::vector<Pose2> poses = straight(speed);
  const SweptClearance::Trajectory way{poses, kFineStep, speed};
  return clear.canStop(way, clear.along(way), hold, stoppingTime(body, {speed, 0.0}));
}

/// The greatest speed that is admissible, to a millimetre per second.
double fastest(World& world, double margin, double hold) {
  double low = 0.0;
  double high = 3.0;
  while (high - low > 1e-3) {
    const double middle = 0.5 * (low + high);
    (isAdmissible(world, middle, margin, hold) ? low : high) = middle;
  }
  return low;
}

}  // namespace

class SweptClearanceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cache_anyPlace_isABoundAndATightOne() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(5.0, 0.0),
                {wall(1.0, -2.0, 1.2, 0.5), wall(-1.5, 0.7, 0.4, 0.9),
                 circleOutline(Vec2(0.2, -1.0), 0.3)});
    const std::vector<Vec2> points = {Vec2(-0.6, -0.4), Vec2(-0.7, 0.1)};
    ClearanceCache cache(0.1, 1.4);
    cache.update(world.observation(), points, 0.0);
    double loss = 0.0;
    double sum = 0.0;
    for (int i = 0; i < 4000; ++i) {
      const Vec2 place(2.0 * std::cos(0.7 * i), 2.0 * std::sin(0.413 * i));
      double exact = std::clamp(world.obstacles().clearance(place, 1.4), 0.0, 1.4);
      for (const Vec2& point : points) {
        exact = std::min(exact, (point - place).norm());
      }
      const double bound = cache.distanceAt(place);
      QVERIFY(bound <= exact + 1e-9);
      if (exact > 0.3) {
        loss = std::max(loss, exact - bound);
        sum += exact - bound;
      }
    }
    // Half a diagonal of the lattice at most, where two walls are equally near; a centimetre
    // usually.
    QVERIFY2(loss < 0.08, QByteArray::number(loss));
    QVERIFY2(sum / 4000.0 < 0.01, QByteArray::number(sum / 4000.0));
  }

  void cache_doorOpens_isNoticed() {
    Obstacles obstacles;
    const int door = obstacles.add({wall(1.0, -1.0, 1.2, 1.0)});
    obstacles.build();
    NavigationMap navigation(OccupancyGrid{}, obstacles, {Vec2::Zero(), Vec2(3.0, 0.0)});
    Observation observation;
    observation.obstacles = &obstacles;
    observation.navigation = &navigation;
    const std::vector<Vec2> none;
    ClearanceCache cache(0.1, 1.4);
    cache.update(observation, none, 0.0);
    QVERIFY(std::fabs(cache.distanceAt(Vec2(0.5, 0.0)) - 0.5) < 0.01);
    obstacles.setEnabled(door, false);
    navigation.update(OccupancyGrid{}, obstacles);
    cache.update(observation, none, 0.0);
    QVERIFY(cache.distanceAt(Vec2(0.5, 0.0)) > 1.3);
  }

  void along_wallAhead_isHitWhereItStands() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(0.0, 3.0),
                {wall(2.0, -2.0, 2.5, 2.0)});
    SweptClearance clear(robotBody(Kinematics::Differential), 0.6);
    clear.observe(world.observation(), 0.1, 1.0, 3.0);
    const std::vector<Pose2> poses = straight(1.0);
    const SweptClearance::Evaluation found = clear.along({poses, kFineStep, 1.0});
    // 2.0 - 0.3 - 0.1 = 1.6 m at 1 m/s.
    QVERIFY2(std::abs(found.wallStep - 160) <= 1, QByteArray::number(found.wallStep));
    QCOMPARE(found.bodyStep, 301);
    QVERIFY(std::fabs(found.gap - 0.1) < 0.015);
  }

  void along_personCrossing_isMetWhenAndWhere() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0));
    // Comes at 0.5 m/s: 3 - (1 + 0.5) t = 0.3 + 0.3 + 0.1 at t = 1.533 s.
    world.observation().bodies = {person(1, Vec2(3.0, 0.0), Vec2(-0.5, 0.0))};
    SweptClearance clear(robotBody(Kinematics::Differential), 0.6);
    clear.observe(world.observation(), 0.1, 1.0, 3.0);
    const std::vector<Pose2> poses = straight(1.0);
    SweptClearance::Evaluation found = clear.along({poses, kFineStep, 1.0});
    QCOMPARE(found.wallStep, 301);
    QCOMPARE(found.bodyStep, 154);
    // Passes behind: at distance 1.1 m, when the robot is 2 m ahead.
    world.observation().bodies = {person(1, Vec2(2.0, -0.9), Vec2(0.0, 1.0))};
    clear.observe(world.observation(), 0.1, 1.0, 3.0);
    found = clear.along({poses, kFineStep, 1.0});
    QCOMPARE(found.bodyStep, 301);
    // Relative motion (-1, 1) from (2, -0.9): passes at 1.1 / sqrt(2), with more room than the
    // margin.
    QVERIFY(std::fabs(found.gap - (1.1 / std::sqrt(2.0) - 0.6)) < 1e-3);
    QVERIFY(std::isinf(clear.gapAhead()) || clear.gapAhead() > 1.0);
  }

  void along_placeThatIsNoNumber_staysWithinTheWay_data() {
    QTest::addColumn<double>("x");
    QTest::newRow("no number") << std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("no end") << std::numeric_limits<double>::infinity();
    QTest::newRow("its square is none") << 1e200;
  }

  void along_placeThatIsNoNumber_staysWithinTheWay() {
    QFETCH(double, x);
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0));
    world.observation().bodies = {person(1, Vec2(x, 0.0)), person(2, Vec2(3.0, 0.0))};
    for (TrackedBody& body : world.observation().bodies) {
      body.velocity = Vec2(x, 0.0);
    }
    SweptClearance clear(robotBody(Kinematics::Differential), 0.6);
    clear.observe(world.observation(), 0.1, 1.0, 3.0);
    const std::vector<Pose2> poses = straight(1.0);
    const SweptClearance::Evaluation found = clear.along({poses, kFineStep, 1.0});
    QCOMPARE(found.wallStep, 301);
    QVERIFY(found.bodyStep >= 1 && found.bodyStep <= 301);
  }

  void canStop_wallAhead_isTheFormula() {
    for (const double room : {0.2, 0.5, 1.0, 1.5}) {
      const double face = 0.3 + 0.1 + room;
      World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(0.0, 3.0),
                  {wall(face, -2.0, face + 0.5, 2.0)});
      const double most = fastest(world, 0.1, 0.0);
      QVERIFY2(std::fabs(most - std::sqrt(2.0 * room * 1.0)) < 0.04, QByteArray::number(most));
      // With 0.25 s at that speed before: v 0.25 + v² / 2 = room.
      const double held = fastest(world, 0.1, 0.25);
      QVERIFY2(std::fabs(held - (std::sqrt(0.0625 + 2.0 * room) - 0.25)) < 0.04,
               QByteArray::number(held));
    }
  }

  void canStop_personComing_countsTheirWay() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0));
    // Room 1.2 m, 0.8 m/s: v² / 2 + 0.8 v = 1.2 at v = 0.9436 (they meet when the robot stands).
    world.observation().bodies = {person(1, Vec2(1.9, 0.0), Vec2(-0.8, 0.0))};
    const double most = fastest(world, 0.1, 0.0);
    QVERIFY2(std::fabs(most - 0.9436) < 0.03, QByteArray::number(most));
  }

  void canStop_personFromBehind_doesNotCount() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0));
    world.observation().bodies = {person(1, Vec2(-1.2, 0.0), Vec2(1.4, 0.0))};
    QVERIFY(isAdmissible(world, 0.5, 0.1, 0.1));
  }

  void along_polygon_looksAtItsCorners() {
    RobotBody body = robotBody(Kinematics::Differential);
    body.footprint.corners = {Vec2(-0.5, -0.2), Vec2(0.5, -0.2), Vec2(0.5, 0.2), Vec2(-0.5, 0.2)};
    World world(body, {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0), {wall(-1.0, 0.35, 4.0, 0.5)});
    SweptClearance clear(body, 0.6);
    clear.observe(world.observation(), 0.1, 1.0, 3.0);
    // Along the wall with 0.15 m of room ...
    const std::vector<Pose2> poses = straight(1.0);
    QCOMPARE(clear.along({poses, kFineStep, 1.0}).wallStep, 301);
    // ... but it cannot turn beside it: a corner comes to 0.25 m at the heading
    // asin(0.25 / 0.5385) - atan(0.2 / 0.5) = 0.1024 rad.
    std::vector<Pose2> turning(301);
    for (std::size_t i = 0; i < turning.size(); ++i) {
      turning[i].heading = 0.01 * static_cast<double>(i);
    }
    const int step = clear.along({turning, kFineStep, 0.0}).wallStep;
    QVERIFY2(step == 11, QByteArray::number(step));
  }

  void along_insideTheMargin_mayLeaveIt() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0),
                {wall(-0.6, -2.0, -0.35, 2.0)});  // 0.05 m behind the robot
    QVERIFY(isAdmissible(world, 0.5, 0.2, 0.1));
    World facing(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0),
                 {wall(0.35, -2.0, 0.6, 2.0)});
    QVERIFY(!isAdmissible(facing, 0.5, 0.2, 0.1));
  }

  void observe_scan_leavesOutWhatIsKnown() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(0.0, 3.0),
                {wall(2.0, -2.0, 2.5, 2.0)});
    world.observation().bodies = {person(1, Vec2(0.0, 1.3))};
    LaserScan scan;
    scan.angleIncrement = 0.5 * base::kPi;
    scan.range = 10.0;
    scan.distances = {2.0, 1.0, 1.5, 10.0};  // the wall, the person, something, nothing
    world.observation().scan = &scan;
    SweptClearance clear(robotBody(Kinematics::Differential), 0.6);
    clear.observe(world.observation(), 0.1, 1.0, 3.0);
    QCOMPARE(clear.points().size(), std::size_t{1});
    QVERIFY((clear.points().front() - Vec2(-1.5, 0.0)).norm() < 1e-9);
    world.observation().scan = nullptr;
    clear.observe(world.observation(), 0.1, 1.0, 3.0);
    QVERIFY(clear.points().empty());
  }
};

QTEST_GUILESS_MAIN(SweptClearanceTest)
#include "tst_SweptClearance.moc"
