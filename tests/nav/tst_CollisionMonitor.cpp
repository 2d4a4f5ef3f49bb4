#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/servers/CollisionMonitor.h"

using namespace sim2d::nav2;
using sim2d::BodyTwist;
using sim2d::LaserScan;
using sim2d::Observation;

namespace {

constexpr const char* kSquare = "[[0.5, 0.5], [0.5, -0.5], [-0.5, -0.5], [-0.5, 0.5]]";

MonitorPolygon square(const char* action) {
  MonitorPolygon polygon;
  polygon.name = action;
  polygon.type = "polygon";
  polygon.points = kSquare;
  polygon.actionType = action;
  polygon.minPoints = 1;
  polygon.simulationTimeStep = 0.01;
  return polygon;
}

CollisionMonitorParameters monitorOf(const std::vector<MonitorPolygon>& shapes) {
  CollisionMonitorParameters parameters;
  parameters.shapes = shapes;
  parameters.sources = {MonitorSource{"scan"}};
  return parameters;
}

/// A scan that hits points about the robot, given by its place: one beam each, `count` times.
LaserScan scanTo(const Vec2& point, int count = 1) {
  LaserScan scan;
  scan.angleMin = base::atan2(point.y(), point.x());
  scan.angleIncrement = 1e-4;
  scan.distances.assign(static_cast<std::size_t>(count), point.norm());
  return scan;
}

MonitoredCommand filtered(const CollisionMonitorParameters& parameters, const BodyTwist& command,
                          const LaserScan& scan, Distro distro = Distro::Jazzy) {
  Observation observation;
  observation.scan = &scan;
  return CollisionMonitor(parameters, {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}, distro)
      .filter(command, observation);
}

/// Whether the polygon stops a robot that drives ahead.
bool stops(const MonitorPolygon& polygon, const LaserScan& scan, Distro distro = Distro::Jazzy) {
  return filtered(monitorOf({polygon}), {0.5, 0.0}, scan, distro).action == MonitorAction::Stop;
}

bool isNear(double a, double b, double within = 1e-9) {
  return std::fabs(a - b) < within;
}

}  // namespace

/// Vectors of nav2_collision_monitor: polygons_test.cpp; actions by hand.
class CollisionMonitorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Vector 77: the speed left is v t / T, T = 2 s; t within a step of 0.01 s.
  void filter_approach_scalesByTheTimeToCollision_data() {
    QTest::addColumn<double>("vx");
    QTest::addColumn<double>("vy");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("seconds");  // below 0: untouched
    QTest::newRow("backwards") << -0.5 << 0.0 << -0.7 << 0.01 << 0.4;
    QTest::newRow("sideways") << 0.0 << 0.5 << 0.01 << 0.6 << 0.2;
    QTest::newRow("inside") << 0.5 << 0.0 << 0.1 << 0.01 << 0.0;
    QTest::newRow("beyond the horizon") << 0.5 << 0.0 << 1.6 << 0.01 << -1.0;
    QTest::newRow("away") << -0.5 << 0.0 << 0.7 << 0.01 << -1.0;
  }

  void filter_approach_scalesByTheTimeToCollision() {
    QFETCH(double, vx);
    QFETCH(double, vy);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, seconds);
    const MonitoredCommand command =
        filtered(monitorOf({square("approach")}), {vx, 0.0, vy}, scanTo({x, y}));
    const double factor = seconds < 0.0 ? 1.0 : seconds / 2.0;
    QVERIFY(isNear(command.twist.linear, vx * factor, 0.5 * 0.0051));
    QVERIFY(isNear(command.twist.lateral, vy * factor, 0.5 * 0.0051));
    QVERIFY((command.action == MonitorAction::None) == (seconds < 0.0));
  }

  /// A bar of 2 m turns at 1 rad/s; a point a quarter turn away is met after pi / 2 - asin(0.1).
  void filter_approachTurning_sweepsTheArc() {
    MonitorPolygon bar = square("approach");
    bar.points = "[[1, 0.1], [1, -0.1], [-1, -0.1], [-1, 0.1]]";
    const MonitoredCommand command = filtered(monitorOf({bar}), {0.0, 1.0}, scanTo({0.0, 0.9}));
    const double time = base::kPi / 2.0 - std::asin(0.1 / 0.9);
    QVERIFY(isNear(command.twist.angular, time / 2.0, 0.0051));
    // With v = 0.5 m/s, omega = 1: the place ahead on the circle of radius 0.5 is (0.5, 0.5).
    MonitorPolygon dot = square("approach");
    dot.points = "[[0.05, 0.05], [0.05, -0.05], [-0.05, -0.05], [-0.05, 0.05]]";
    const MonitoredCommand arc = filtered(monitorOf({dot}), {0.5, 1.0}, scanTo({0.5, 0.5}));
    QVERIFY(isNear(arc.twist.linear, 0.5 * (base::kPi / 2.0 - 0.1) / 2.0, 0.01));
  }

  void isInPolygon_points_areInOrOut_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<bool>("isIn");
    QTest::newRow("left arm") << 0.5 << 2.5 << true;
    QTest::newRow("notch") << 1.5 << 2.5 << false;
    QTest::newRow("right arm") << 2.5 << 2.5 << true;
    QTest::newRow("floor") << 1.5 << 0.5 << true;
    QTest::newRow("left of it") << -0.5 << 0.5 << false;
    QTest::newRow("above") << 0.5 << 3.5 << false;
    QTest::newRow("level with a corner, outside") << 3.5 << 1.0 << false;
    QTest::newRow("level with a corner, inside") << 0.5 << 1.0 << true;
  }

  void isInPolygon_points_areInOrOut() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(bool, isIn);
    const Polygon cup = {{0.0, 0.0}, {3.0, 0.0}, {3.0, 3.0}, {2.0, 3.0},
                         {2.0, 1.0}, {1.0, 1.0}, {1.0, 3.0}, {0.0, 3.0}};
    QCOMPARE(isInPolygon({x, y}, cup), isIn);
    QCOMPARE(isInPolygon({x, y}, Polygon(cup.rbegin(), cup.rend())), isIn);
  }

  void filter_stop_isFinal() {
    MonitorPolygon slow = square("slowdown");
    const MonitoredCommand command =
        filtered(monitorOf({square("stop"), slow}), {0.5, 0.3}, scanTo({0.2, 0.1}));
    QVERIFY(command.twist == BodyTwist{});
    QVERIFY(command.action == MonitorAction::Stop);
    QCOMPARE(command.polygon, std::string("stop"));
  }

  void filter_slowdownAndLimit_keepTheSafest() {
    MonitorPolygon slow = square("slowdown");
    slow.slowdownRatio = 0.6;
    MonitorPolygon limit = square("limit");
    limit.linearLimit = 0.2;
    const LaserScan scan = scanTo({0.2, 0.1});
    for (const auto& shapes : {std::vector<MonitorPolygon>{slow, limit}, {limit, slow}}) {
      const MonitoredCommand command = filtered(monitorOf(shapes), {0.5, 0.0}, scan);
      QVERIFY(isNear(command.twist.linear, 0.2));
      QCOMPARE(command.polygon, std::string("limit"));
    }
    const MonitoredCommand slower = filtered(monitorOf({slow, limit}), {0.25, 0.0}, scan);
    QVERIFY(isNear(slower.twist.linear, 0.15));
    QVERIFY(slower.action == MonitorAction::Slowdown);
    const MonitoredCommand free =
        filtered(monitorOf({slow, limit}), {0.5, 0.0}, scanTo({2.0, 0.0}));
    QVERIFY(free.action == MonitorAction::None && free.twist.linear == 0.5);
  }

  void filter_limit_keepsTheArc() {
    MonitorPolygon limit = square("limit");
    limit.linearLimit = 0.3;
    limit.angularLimit = 0.2;
    const LaserScan scan = scanTo({0.2, 0.1});
    MonitoredCommand command = filtered(monitorOf({limit}), {0.6, 0.8}, scan);
    QVERIFY(isNear(command.twist.linear, 0.15) && isNear(command.twist.angular, 0.2));
    command = filtered(monitorOf({limit}), {0.3, 0.1, 0.4}, scan);  // speed 0.5
    QVERIFY(isNear(command.twist.linear, 0.18) && isNear(command.twist.lateral, 0.24));
    QVERIFY(isNear(command.twist.angular, 0.06));
    command = filtered(monitorOf({limit}), {0.1, 0.1}, scan);
    QVERIFY(isNear(command.twist.linear, 0.1) && command.action == MonitorAction::None);
  }

  void filter_minPoints_isTheLeastCount() {
    MonitorPolygon stop = square("stop");
    stop.minPoints = 4;
    const Vec2 place(0.2, 0.1);
    QVERIFY(!stops(stop, scanTo(place, 3)));
    QVERIFY(stops(stop, scanTo(place, 4)));
    stop.maxPoints = 5;  // of Humble: more than five
    QVERIFY(!stops(stop, scanTo(place, 5), Distro::Humble));
    QVERIFY(stops(stop, scanTo(place, 6), Distro::Humble));
    QVERIFY(stops(stop, scanTo(place, 4)));
  }

  void filter_circle_isByRadius() {
    MonitorPolygon circle = square("stop");
    circle.type = "circle";
    circle.radius = 0.5;
    QVERIFY(stops(circle, scanTo({0.3, 0.39})));
    QVERIFY(!stops(circle, scanTo({0.3, 0.41})));
  }

  void filter_noPoints_isTheFootprint() {
    MonitorPolygon stop = square("stop");
    stop.points.clear();
    QVERIFY(stops(stop, scanTo({0.19, 0.1})));
    QVERIFY(!stops(stop, scanTo({0.21, 0.1})));
  }

  void filter_humblePointList_isRead() {
    MonitorPolygon stop = square("stop");
    stop.points.clear();
    stop.pointList = {1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0, 1.0};
    QVERIFY(stops(stop, scanTo({0.9, 0.1})));
    QVERIFY(!stops(stop, scanTo({1.1, 0.1})));
  }

  void filter_velocityPolygon_goesByTheCommand() {
    MonitorPolygon shape = square("stop");
    shape.type = "velocity_polygon";
    VelocitySubPolygon ahead;
    ahead.points = "[[2, 1], [2, -1], [0, -1], [0, 1]]";
    ahead.linearMin = 0.0;
    ahead.linearMax = 1.0;
    ahead.thetaMin = -1.0;
    ahead.thetaMax = 1.0;
    VelocitySubPolygon behind = ahead;
    behind.points = "[[0, 1], [0, -1], [-2, -1], [-2, 1]]";
    behind.linearMin = -1.0;
    behind.linearMax = 0.0;
    shape.subPolygons = {ahead, behind};
    const CollisionMonitorParameters parameters = monitorOf({shape});
    const auto isStopped = [&parameters](const BodyTwist& command, const Vec2& point) {
      return filtered(parameters, command, scanTo(point)).action == MonitorAction::Stop;
    };
    QVERIFY(isStopped({0.5, 0.0}, {1.5, 0.1}));
    QVERIFY(!isStopped({-0.5, 0.0}, {1.5, 0.1}));
    QVERIFY(isStopped({-0.5, 0.0}, {-1.5, 0.1}));
    QVERIFY(!isStopped({3.0, 0.0}, {1.5, 0.1}));  // none is for it, none was before
    // The shape of the last command stays when none fits.
    Observation observation;
    const LaserScan scan = scanTo({1.5, 0.1});
    observation.scan = &scan;
    CollisionMonitor monitor(parameters, {}, Distro::Jazzy);
    QVERIFY(monitor.filter({0.5, 0.0}, observation).action == MonitorAction::Stop);
    QVERIFY(monitor.filter({3.0, 0.0}, observation).action == MonitorAction::Stop);

    shape.holonomic = true;
    shape.subPolygons = {ahead};
    shape.subPolygons[0].directionStartAngle = 3.0 * base::kPi / 4.0;  // over pi, to the left
    shape.subPolygons[0].directionEndAngle = -3.0 * base::kPi / 4.0;
    const CollisionMonitorParameters omni = monitorOf({shape});
    QVERIFY(filtered(omni, {-0.5, 0.0, 0.1}, scan).action == MonitorAction::Stop);
    QVERIFY(filtered(omni, {0.5, 0.0, 0.1}, scan).action == MonitorAction::None);
  }

  void filter_oldScan_stopsSinceJazzy() {
    CollisionMonitorParameters parameters = monitorOf({square("stop")});
    const LaserScan scan = scanTo({5.0, 0.0});
    Observation observation;
    observation.scan = &scan;
    const auto actionAt = [&](double time, Distro distro) {
      observation.time = time;
      return CollisionMonitor(parameters, {}, distro).filter({0.5, 0.0}, observation);
    };
    QVERIFY(actionAt(2.0, Distro::Jazzy).action == MonitorAction::None);
    QVERIFY(actionAt(2.05, Distro::Jazzy).action == MonitorAction::Stop);
    QCOMPARE(actionAt(2.05, Distro::Jazzy).polygon, std::string("invalid source"));
    QVERIFY(actionAt(2.05, Distro::Humble).action == MonitorAction::None);
    observation.scan = nullptr;
    QVERIFY(actionAt(0.0, Distro::Main).action == MonitorAction::Stop);
    parameters.sources[0].sourceTimeout = 0.0;
    QVERIFY(actionAt(9.0, Distro::Main).action == MonitorAction::None);
    parameters.sources[0].sourceTimeout = 2.0;
    parameters.sources[0].enabled = false;
    QVERIFY(actionAt(9.0, Distro::Main).action == MonitorAction::None);
  }

  void filter_emptyBeams_areNoPoints() {
    LaserScan scan = scanTo({0.2, 0.1}, 3);
    scan.range = scan.distances[0];
    QVERIFY(!stops(square("stop"), scan));
  }

  /// The robot has driven 1 m since the scan, and turned.
  void filter_scanBeforeMotion_isShifted() {
    const LaserScan scan = scanTo({1.3, 0.0});
    Observation observation;
    observation.scan = &scan;
    observation.pose = {{1.0, 0.0}, base::kPi};
    MonitorPolygon behind = square("stop");
    behind.points = "[[0, 0.2], [0, -0.2], [-0.5, -0.2], [-0.5, 0.2]]";
    CollisionMonitor monitor(monitorOf({behind}), {}, Distro::Jazzy);
    QVERIFY(monitor.filter({0.5, 0.0}, observation).action == MonitorAction::Stop);
  }

  void filter_disabled_isSkipped() {
    MonitorPolygon stop = square("stop");
    stop.enabled = false;
    QVERIFY(!stops(stop, scanTo({0.2, 0.1})));
  }

  /// Since Lyrical the node as a whole can be switched off.
  void filter_disabledNode_passesCommands() {
    CollisionMonitorParameters parameters = monitorOf({square("stop")});
    parameters.enabled = false;
    CollisionMonitor monitor(parameters, {}, Distro::Lyrical);
    const LaserScan scan = scanTo({0.2, 0.1});
    Observation observation;
    observation.scan = &scan;
    const MonitoredCommand left = monitor.filter({0.5, 0.0}, observation);
    QVERIFY(left.action == MonitorAction::None && left.twist == (BodyTwist{0.5, 0.0}));
  }

  void filter_exclusionZone_hidesItsPoints_data() {
    QTest::addColumn<int>("frame");      // ZoneFrame: robot, odom, map
    QTest::addColumn<double>("radius");  // above 0: a circle
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<bool>("enabled");
    QTest::addColumn<double>("x");  // of the point in the frame of the robot
    QTest::addColumn<bool>("stops");
    // The polygon is 1.2 to 1.4 m ahead of the origin of its frame.
    QTest::newRow("inside") << 0 << -1.0 << -1.0 << 1.0 << true << 1.3 << false;
    QTest::newRow("beside it") << 0 << -1.0 << -1.0 << 1.0 << true << 1.5 << true;
    QTest::newRow("disabled") << 0 << -1.0 << -1.0 << 1.0 << false << 1.3 << true;
    QTest::newRow("above the beams") << 0 << -1.0 << 0.3 << 1.0 << true << 1.3 << true;
    QTest::newRow("below the beams") << 0 << -1.0 << 0.0 << 0.1 << true << 1.3 << true;
    QTest::newRow("circle") << 0 << 1.31 << -1.0 << 1.0 << true << 1.3 << false;
    QTest::newRow("edge of the circle") << 0 << 1.29 << -1.0 << 1.0 << true << 1.3 << true;
    // The robot is at x = 0.4 in odom, whose origin is at x = -0.7 in the map.
    QTest::newRow("odom, inside") << 1 << -1.0 << -1.0 << 1.0 << true << 0.9 << false;
    QTest::newRow("odom, outside") << 1 << -1.0 << -1.0 << 1.0 << true << 1.3 << true;
    QTest::newRow("map, inside") << 2 << -1.0 << -1.0 << 1.0 << true << 1.6 << false;
    QTest::newRow("map, outside") << 2 << -1.0 << -1.0 << 1.0 << true << 0.9 << true;
  }

  /// Points inside an exclusion zone do not trigger the polygons.
  void filter_exclusionZone_hidesItsPoints() {
    QFETCH(int, frame);
    QFETCH(double, radius);
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(bool, enabled);
    QFETCH(double, x);
    QFETCH(bool, stops);
    MonitorPolygon ahead = square("stop");
    ahead.points = "[[2, 0.5], [2, -0.5], [0, -0.5], [0, 0.5]]";
    ExclusionZone zone;
    zone.enabled = enabled;
    zone.type = radius > 0.0 ? "circle" : "polygon";
    zone.radius = radius;
    zone.points = "[[1.4, 0.1], [1.4, -0.1], [1.2, -0.1], [1.2, 0.1]]";
    zone.minHeight = low;
    zone.maxHeight = high;
    zone.frame = static_cast<ZoneFrame>(frame);
    CollisionMonitorParameters parameters = monitorOf({ahead});
    parameters.zones = {zone};
    Observation observation;
    observation.pose = {{0.4, 0.0}, 0.0};
    observation.frame = {{-0.7, 0.0}, 0.0};
    const LaserScan scan = scanTo({0.4 + x, 0.0});
    observation.scan = &scan;
    const MonitoredCommand sent =
        CollisionMonitor(parameters, {}, Distro::Lyrical).filter({0.5, 0.0}, observation);
    QCOMPARE(sent.action == MonitorAction::Stop, stops);
  }

  void problemsOf_exclusionZones_areTold() {
    ExclusionZone off;  // without corners
    off.name = "off";
    ExclusionZone empty = off, ellipse = off, flat = off, good = off;
    empty.enabled = ellipse.enabled = flat.enabled = good.enabled = true;
    ellipse.type = "ellipse";
    flat.type = good.type = "circle";
    good.radius = 0.5;
    CollisionMonitorParameters parameters = monitorOf({square("stop")});
    parameters.zones = {off, good};
    QVERIFY(problemsOf(parameters).empty());
    parameters.zones = {off, empty, ellipse, flat, good};
    QCOMPARE(problemsOf(parameters).size(), std::size_t{3});
  }

  void problemsOf_shapes_areTold() {
    QVERIFY(problemsOf(monitorOf({square("stop"), square("approach"), square("none")})).empty());
    MonitorPolygon shape = square("brake");
    shape.type = "ellipse";
    shape.simulationTimeStep = 0.0;  // read for approach only
    MonitorPolygon approach = square("approach");
    approach.simulationTimeStep = 0.0;
    approach.timeBeforeCollision = 2.0;
    MonitorPolygon circle = square("stop");
    circle.type = "circle";
    MonitorPolygon torn = square("stop");
    torn.points = "[[1, 2";
    MonitorPolygon odd = square("stop");
    odd.pointList = {1.0, 2.0, 3.0};
    QCOMPARE(problemsOf(monitorOf({shape, approach, circle, torn, odd})).size(), std::size_t{6});
  }
};

QTEST_APPLESS_MAIN(CollisionMonitorTest)
#include "tst_CollisionMonitor.moc"
