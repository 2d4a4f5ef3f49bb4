#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/docking/DockingServer.h"
#include "sim2d/nav/nav2/docking/FollowingServer.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"

namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using sim2d::BatteryState;
using sim2d::BodyTwist;
using sim2d::DockPose;
using Words = std::vector<std::string>;

constexpr double kDt = 0.05;  // [s]

/// A room of 10 x 10 m round the origin.
Costmap emptyRoom() {
  return {200, 200, 0.05, {-5.0, -5.0}};
}

CostmapFootprint squareFootprint() {
  return costmapFootprint(0.0, {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}, 0.0);
}

/// A robot that does what it is commanded to, and a charger at a place.
struct Robot {
  Pose2 pose;
  BodyTwist motion;
  std::optional<Vec2> charger;
  bool hasBattery = true;
  Costmap room = emptyRoom();
  CostmapFootprint footprint = squareFootprint();
  std::vector<DockPose> seen;
  double time = 0.0;

  Pose2 costmapFrame;

  /// A wall across the x axis.
  void putWall(double x) {
    for (double y = -1.0; y < 1.0; y += 0.05) {
      room.set(*room.worldToCell({x, y}), kLethal);
    }
  }
  DockControllerInput view() const { return {pose, motion, room, footprint, costmapFrame}; }
  std::optional<BatteryState> battery() const {
    const bool isThere = charger && (pose.position - *charger).norm() <= 0.1;
    return hasBattery ? std::optional(BatteryState{0.5, 24.0, isThere ? 5.0 : -1.0, isThere})
                      : std::nullopt;
  }
  void drive(const std::optional<BodyTwist>& twist) {
    motion = twist.value_or(motion);
    pose.position += motion.linear * kDt * Vec2(std::cos(pose.heading), std::sin(pose.heading));
    pose.heading = base::wrapToPi(pose.heading + motion.angular * kDt);
    time += kDt;
  }
};

struct Course {
  ServerStatus status = ServerStatus::Idle;
  std::vector<std::string> events;
  double lowest = 0.0, highest = 0.0;  // speeds along the heading [m/s]
  bool staged = false;
};

/// Until the action ends, 200 s at most. `staging`: what becomes of a drive to the staging pose.
Course run(DockingServer& server, Robot& robot, StagingDrive staging = StagingDrive::Arrived) {
  Course course;
  while (server.isRunning() && robot.time < 200.0) {
    const DockingStep step =
        server.update({robot.time, kDt, robot.view(), robot.seen, robot.battery(),
                       course.staged ? staging : StagingDrive::None});
    course.status = step.status;
    if (!step.event.empty()) {
      course.events.push_back(step.event);
    }
    if (step.staging) {
      course.staged = true;
      if (staging == StagingDrive::Arrived) {
        robot.pose = *step.staging;
      }
    }
    robot.drive(step.twist);
    course.lowest = std::min(course.lowest, robot.motion.linear);
    course.highest = std::max(course.highest, robot.motion.linear);
  }
  return course;
}

const Pose2 kDockPose{{2.0, 0.0}, 0.0};

std::vector<DockPose> home() {
  return {{"home", kDockPose, true}};
}

DockGoal toDock(const std::string& id) {
  DockGoal goal;
  goal.dockId = id;
  return goal;
}

DockPluginParameters simplePlugin() {
  DockPluginParameters plugin;
  plugin.name = "simple";
  return plugin;
}

DockingServer serverOf(const DockPluginParameters& plugin, Distro distro,
                       DockingServerParameters parameters = {}) {
  parameters.plugins = {plugin};
  return DockingServer(parameters, distro, home());
}

bool isNear(const Pose2& a, const Pose2& b, double distance, double angle) {
  return (a.position - b.position).norm() < distance &&
         std::fabs(base::wrapToPi(a.heading - b.heading)) < angle;
}

Nav2ReadResult readingOf(const std::string& text, Distro distro = Distro::Jazzy,
                         const std::string& file = "p.yaml") {
  const auto parsed = ParameterFile::parse(text, file);
  return parsed ? readNav2Parameters(*parsed, {distro, {}, false}) : Nav2ReadResult();
}

}  // namespace

// ---- following
// -----------------------------------------------------------------------------------
namespace {

FollowingStep followFor(FollowingServer& server, Robot& robot, double seconds,
                        const std::function<std::optional<Pose2>(double)>& object) {
  FollowingStep step;
  const double end = robot.time + seconds;
  while (robot.time < end && server.isRunning()) {
    step = server.update({robot.time, kDt, robot.view(), object(robot.time)});
    robot.drive(step.twist);
  }
  return step;
}

}  // namespace

/// docking_server and following_server: formulas against numbers of a calculation apart from the
/// program, and the courses of actions with a robot that drives as it is commanded.
class Nav2DockingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // ---- formulas
  // ------------------------------------------------------------------------------------
  /// (2, 3) and 90 degrees: 0.7 m behind is (2, 2.3).
  void staging_liesBehindTheDock() {
    DockPluginParameters plugin;
    Pose2 staging = DockingServer::stagingPose(plugin, {{2.0, 3.0}, 0.5 * base::kPi});
    QVERIFY(isNear(staging, {{2.0, 2.3}, 0.5 * base::kPi}, 1e-12, 1e-12));
    plugin.stagingXOffset = -1.0;
    plugin.stagingYawOffset = base::kPi;
    staging = DockingServer::stagingPose(plugin, {{2.0, 3.0}, 0.0});
    QVERIFY(isNear(staging, {{1.0, 3.0}, base::kPi}, 1e-12, 1e-12));
  }

  void detections_areFilteredByTheirWeight() {
    const Pose2 mean = DockingServer::filtered({{0.0, 0.0}, 0.0}, {{1.0, 2.0}, 0.5}, 0.1);
    QVERIFY(isNear(mean, {{0.1, 0.2}, 0.05}, 1e-12, 1e-12));
    // Over the back: from 3.1 to -3.1 are 2 pi - 6.2 = 0.0831853, a quarter of it 0.0207963.
    const Pose2 back = DockingServer::filtered({{0.0, 0.0}, 3.1}, {{0.0, 0.0}, -3.1}, 0.25);
    QVERIFY(std::fabs(back.heading - 3.1207963) < 1e-7);
  }

  void law_isThatOfTheGracefulController_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("heading");
    QTest::addColumn<bool>("isBackward");
    QTest::addColumn<double>("linear");
    QTest::addColumn<double>("angular");
    // By the formulas of the paper with docking_server's defaults, calculated apart from the
    // program.
    QTest::newRow("ahead") << 2.0 << 0.3 << 0.1 << false << 0.220347263134 << 0.127807466652;
    QTest::newRow("behind") << -1.5 << 0.2 << 0.1 << true << -0.154431139417 << -0.192085970548;
    QTest::newRow("near") << 0.2 << 0.0 << 0.0 << false << 0.2 << 0.0;
  }

  void law_isThatOfTheGracefulController() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, heading);
    QFETCH(bool, isBackward);
    QFETCH(double, linear);
    QFETCH(double, angular);
    const DockController controller(DockControllerParameters(), Distro::Jazzy);
    const Robot robot;
    const BodyTwist twist = controller.command(robot.view(), {{x, y}, heading}, isBackward);
    QVERIFY2(std::fabs(twist.linear - linear) < 1e-9, qPrintable(QString::number(twist.linear)));
    QVERIFY2(std::fabs(twist.angular - angular) < 1e-9, qPrintable(QString::number(twist.angular)));
  }

  void turn_canStopInTime_data() {
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("now");
    QTest::addColumn<double>("expected");
    // 3.2 rad/s2 in 0.05 s are 0.16 rad/s; the limit is 1 rad/s, and sqrt(2 * 3.2 * angle).
    QTest::newRow("starts") << 1.0 << 0.0 << 0.16;
    QTest::newRow("to the right") << -1.0 << 0.0 << -0.16;
    QTest::newRow("at its speed") << 2.0 << 1.0 << 1.0;
    QTest::newRow("too fast") << 2.0 << 1.5 << 1.34;
    QTest::newRow("brakes") << 0.02 << 0.9 << std::sqrt(0.128);
  }

  void turn_canStopInTime() {
    QFETCH(double, angle);
    QFETCH(double, now);
    QFETCH(double, expected);
    const DockController controller(DockControllerParameters(), Distro::Kilted);
    const BodyTwist twist = controller.rotation(angle, now, kDt);
    QCOMPARE(twist.linear, 0.0);
    QVERIFY(std::fabs(twist.angular - expected) < 1e-12);
  }

  /// A wall across the way to a target 2 m ahead: at 0.25 m/s 5 s reach 1.25 m, and the front of
  /// the robot 1.45 m. In a costmap whose frame lies 0.3 m ahead in the map a wall at 1.3 m is at
  /// 1.6 m. Within 0.3 m of the dock nothing is tested: the front of the robot reaches 0.5 m behind
  /// the place where the test ends.
  void obstacle_onTheWay_isFound_data() {
    QTest::addColumn<double>("x");      // of the wall, in the costmap's frame
    QTest::addColumn<double>("frame");  // x of the costmap's frame
    QTest::addColumn<double>("duration");
    QTest::addColumn<bool>("isFree");
    QTest::newRow("in reach") << 1.3 << 0.0 << 5.0 << false;
    QTest::newRow("farther") << 1.6 << 0.0 << 5.0 << true;
    QTest::newRow("frame ahead") << 1.3 << 0.3 << 5.0 << true;
    QTest::newRow("frame behind") << 1.3 << -0.3 << 5.0 << false;
    QTest::newRow("before the dock") << 1.7 << 0.0 << 20.0 << false;
    QTest::newRow("in the dock") << 2.1 << 0.0 << 20.0 << true;
  }

  void obstacle_onTheWay_isFound() {
    QFETCH(double, x);
    QFETCH(double, frame);
    QFETCH(double, duration);
    QFETCH(bool, isFree);
    DockControllerParameters parameters;
    parameters.projectionTime = duration;
    Robot robot;
    robot.costmapFrame = {{frame, 0.0}, 0.0};
    robot.putWall(x);
    const DockController controller(parameters, Distro::Jazzy);
    QCOMPARE(controller.isFree(robot.view(), kDockPose, true, false), isFree);
  }

  // ---- docking
  // -------------------------------------------------------------------------------------
  void dock_isReachedAndCharges() {
    DockingServer server({}, Distro::Jazzy, home());
    Robot robot;
    robot.pose = {{1.0, 0.1}, 0.2};
    robot.charger = kDockPose.position;
    server.dock(toDock("home"), robot.time);
    const Course docking = run(server, robot);
    QCOMPARE(docking.status, ServerStatus::Succeeded);
    QCOMPARE(docking.events, Words{"docked home"});
    QVERIFY(!docking.staged);  // it was within 0.5 m of the staging pose
    QVERIFY(isNear(robot.pose, kDockPose, 0.11, 0.2));
    QCOMPARE(docking.lowest, 0.0);
    QVERIFY(docking.highest <= 0.25);

    server.undock({}, robot.time);
    robot.time = 0.0;
    const Pose2 docked = robot.pose;
    const Course undocking = run(server, robot);
    QCOMPARE(undocking.status, ServerStatus::Succeeded);
    QCOMPARE(undocking.events, Words{"undocked home"});
    const Vec2 staging =
        docked.position - 0.7 * Vec2(std::cos(docked.heading), std::sin(docked.heading));
    QVERIFY(isNear(robot.pose, {staging, docked.heading}, 0.06, 0.06));
    QCOMPARE(undocking.highest, 0.0);
    QVERIFY(undocking.lowest >= -0.25 && undocking.lowest < -0.05);
  }

  void dock_backwards_isReachedWithTheTail_data() {
    QTest::addColumn<int>("distro");
    QTest::addColumn<bool>("server");
    QTest::newRow("key of the server, Jazzy") << static_cast<int>(Distro::Jazzy) << true;
    QTest::newRow("key of the server, Kilted") << static_cast<int>(Distro::Kilted) << true;
    QTest::newRow("key of the dock, Kilted") << static_cast<int>(Distro::Kilted) << false;
    QTest::newRow("key of the dock, main") << static_cast<int>(Distro::Main) << false;
  }

  void dock_backwards_isReachedWithTheTail() {
    QFETCH(int, distro);
    QFETCH(bool, server);
    DockingServerParameters parameters;
    DockPluginParameters plugin = simplePlugin();
    plugin.stagingYawOffset = base::kPi;
    plugin.direction = server ? "forward" : "backward";
    parameters.dockBackwards = parameters.hasDockBackwards = server;
    DockingServer docks = serverOf(plugin, static_cast<Distro>(distro), parameters);
    Robot robot;
    robot.pose = {{1.2, 0.05}, 3.0};
    robot.charger = kDockPose.position;
    docks.dock(toDock("home"), 0.0);
    const Course docking = run(docks, robot);
    QCOMPARE(docking.status, ServerStatus::Succeeded);
    QVERIFY(isNear(robot.pose, {{2.0, 0.0}, base::kPi}, 0.11, 0.25));
    QCOMPARE(docking.highest, 0.0);
    docks.undock({}, 0.0);
    robot.time = 0.0;
    const Course undocking = run(docks, robot);
    QCOMPARE(undocking.status, ServerStatus::Succeeded);
    QCOMPARE(undocking.lowest, 0.0);
    QVERIFY(std::fabs(robot.pose.position.x() - 1.3) < 0.17);
  }

  /// It faces the dock, turns round, backs in; it drives out and turns to the dock again.
  void dock_withRotation_isReachedWithTheTail() {
    DockPluginParameters plugin = simplePlugin();
    plugin.direction = "backward";
    plugin.rotatesToDock = true;
    DockingServer docks = serverOf(plugin, Distro::Kilted);
    Robot robot;
    robot.pose = {{1.3, 0.0}, 0.0};
    robot.charger = kDockPose.position;
    docks.dock(toDock("home"), 0.0);
    QCOMPARE(run(docks, robot).status, ServerStatus::Succeeded);
    QVERIFY(isNear(robot.pose, {{2.0, 0.0}, base::kPi}, 0.11, 0.1));
    docks.undock({}, 0.0);
    robot.time = 0.0;
    QCOMPARE(run(docks, robot).status, ServerStatus::Succeeded);
    QVERIFY(isNear(robot.pose, {{1.25, 0.0}, 0.0}, 0.15, 0.1));
  }

  void dock_farAway_asksForADriveToTheStagingPose() {
    DockingServer server({}, Distro::Jazzy, home());
    Robot robot;
    robot.pose = {{-3.0, 0.0}, 0.0};
    robot.charger = kDockPose.position;
    server.dock(toDock("home"), 0.0);
    const DockingStep first = server.update({0.0, kDt, robot.view(), robot.seen, robot.battery()});
    QVERIFY(first.staging && isNear(*first.staging, {{1.3, 0.0}, 0.0}, 1e-12, 1e-12));
    QVERIFY(!first.twist);
    server.dock(toDock("home"), 0.0);
    const Course course = run(server, robot);
    QVERIFY(course.staged);
    QCOMPARE(course.status, ServerStatus::Succeeded);
  }

  /// The robot takes itself to be 20 cm beside its place: only a detector leads it into the dock.
  void dock_ofADetector_isThatWhichIsSeen() {
    DockPluginParameters plugin = simplePlugin();
    plugin.usesDetection = true;
    plugin.usesBatteryStatus = false;
    DockingServer docks = serverOf(plugin, Distro::Jazzy);
    Robot robot;
    robot.pose = {{1.2, 0.2}, 0.0};
    robot.seen = {{"home", {{2.0, 0.2}, 0.0}, true}};
    docks.dock(toDock("home"), 0.0);
    QCOMPARE(run(docks, robot).status, ServerStatus::Succeeded);
    QVERIFY(isNear(robot.pose, {{2.0, 0.2}, 0.0}, 0.05, 0.1));
  }

  void docking_failsWithNav2sCodes_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("code");
    QTest::addColumn<double>("earliest");  // [s]
    QTest::newRow("unknown dock") << "id" << 901 << 0.0;
    QTest::newRow("unknown class") << "type" << 902 << 0.0;
    QTest::newRow("not staged") << "stage" << 903 << 0.0;
    QTest::newRow("not staged in time") << "late" << 903 << 20.0;
    QTest::newRow("not seen") << "blind" << 904 << 5.0;
    QTest::newRow("way blocked") << "wall" << 905 << 0.0;
  }

  void docking_failsWithNav2sCodes() {
    QFETCH(QString, what);
    QFETCH(int, code);
    QFETCH(double, earliest);
    DockPluginParameters plugin = simplePlugin();
    plugin.usesDetection = what == QLatin1String("blind");
    DockingServer docks = serverOf(plugin, Distro::Jazzy);
    Robot robot;
    const bool isFar = what == QLatin1String("stage") || what == QLatin1String("late");
    robot.pose = {{isFar ? -3.0 : 1.2, 0.0}, 0.0};
    robot.charger = kDockPose.position;
    if (what == QLatin1String("wall")) {
      robot.putWall(1.6);
    }
    DockGoal goal = toDock(what == QLatin1String("id") ? "nowhere" : "home");
    goal.maxStagingTime = 20.0;
    if (what == QLatin1String("type")) {
      goal.usesDockId = false;
      goal.type = "elaborate";
      goal.pose = kDockPose;
    }
    docks.dock(goal, 0.0);
    const Course course = run(
        docks, robot, what == QLatin1String("late") ? StagingDrive::Running : StagingDrive::Failed);
    QCOMPARE(course.status, ServerStatus::Failed);
    QCOMPARE(static_cast<int>(docks.code()), code);
    QVERIFY(!docks.message().empty());
    QVERIFY2(robot.time >= earliest, qPrintable(QString::number(robot.time)));
  }

  /// Three further attempts, each from the staging pose, each with 5 s for the charge.
  void docking_withoutCharge_isRepeated() {
    DockingServer server({}, Distro::Jazzy, home());
    Robot robot;
    robot.pose = {{1.2, 0.0}, 0.0};
    server.dock(toDock("home"), 0.0);
    const Course course = run(server, robot);
    QCOMPARE(course.status, ServerStatus::Failed);
    QCOMPARE(static_cast<int>(server.code()), 906);
    QCOMPARE(server.retries(), 4);
    QVERIFY(robot.time > 20.0);
    QVERIFY(course.lowest < -0.05);  // it drove back between
    Robot bare;                      // without a battery to ask a docked robot counts as charged
    bare.pose = {{1.2, 0.0}, 0.0};
    bare.hasBattery = false;
    server.dock(toDock("home"), 0.0);
    QCOMPARE(run(server, bare).status, ServerStatus::Succeeded);
    QVERIFY(isNear(bare.pose, kDockPose, 0.05, 0.1));
  }

  void undocking_outOfNoDock_isDone() {
    DockingServer server({}, Distro::Jazzy, home());
    Robot robot;
    server.undock({}, 0.0);
    const Course course = run(server, robot);
    QCOMPARE(course.status, ServerStatus::Succeeded);
    QVERIFY(course.events.empty());
    QVERIFY(isNear(robot.pose, Pose2(), 1e-12, 1e-12));
  }

  /// The object walks 3 m at 0.2 m/s and stands: the robot ends 1 m behind it.
  void object_isFollowedAtItsDistance() {
    FollowingServer server({}, Distro::Main);
    Robot robot;
    robot.pose = {{-4.0, -1.0}, 0.5};
    server.follow({0.0, false}, 0.0);
    const auto object = [](double time) {
      return std::optional(Pose2{{-2.0 + std::min(3.0, 0.2 * time), 0.5}, 0.0});
    };
    const FollowingStep step = followFor(server, robot, 60.0, object);
    QCOMPARE(step.status, ServerStatus::Running);
    const Vec2 line = Vec2(1.0, 0.5) - robot.pose.position;
    QVERIFY2(line.norm() > 0.99 && line.norm() < 1.16, qPrintable(QString::number(line.norm())));
    QVERIFY(std::fabs(base::wrapToPi(base::headingOf(line) - robot.pose.heading)) < 0.16);
    QCOMPARE(step.twist->linear, 0.0);
  }

  /// Detections move the estimate by a tenth: one that jumps 1 m aside for a moment turns the robot
  /// less than the frame of an object does.
  void object_isFilteredWhenDetected() {
    std::vector<double> turns;
    for (const bool isDetected : {false, true}) {
      FollowingServer server({}, Distro::Main);
      Robot robot;
      server.follow({0.0, isDetected}, 0.0);
      server.update({0.0, kDt, robot.view(), Pose2{{3.0, 0.0}, 0.0}});
      const FollowingStep step = server.update({kDt, kDt, robot.view(), Pose2{{3.0, 1.0}, 0.0}});
      turns.push_back(step.twist->angular);
    }
    QVERIFY(turns[0] > 5.0 * turns[1] && turns[1] > 0.0);
  }

  /// 2 s, and as often again as it may be lost.
  void object_thatIsLost_endsTheAction() {
    FollowingServer server({}, Distro::Main);
    Robot robot;
    server.follow({0.0, true}, 0.0);
    const FollowingStep step =
        followFor(server, robot, 30.0, [](double) { return std::optional<Pose2>(); });
    QCOMPARE(step.status, ServerStatus::Failed);
    QCOMPARE(server.code(), FollowError::FailedToDetectObject);
    QVERIFY2(robot.time > 8.0 && robot.time < 9.0, qPrintable(QString::number(robot.time)));
  }

  void object_thatIsLost_isSearchedFor() {
    FollowingServerParameters parameters;
    parameters.searchByRotating = true;
    FollowingServer server(parameters, Distro::Main);
    Robot robot;
    server.follow({0.0, true}, 0.0);
    double left = 0.0, right = 0.0;
    const auto object = [&](double time) {
      left = std::max(left, robot.pose.heading);
      right = std::min(right, robot.pose.heading);
      return time > 9.0 ? std::optional(Pose2{{3.0, 0.0}, 0.0}) : std::nullopt;
    };
    const FollowingStep step = followFor(server, robot, 30.0, object);
    // The search angle is 1.57; it turns back 0.15 before it and needs 0.15 to stop.
    QVERIFY2(left > 1.3 && left < 1.8, qPrintable(QString::number(left)));
    QVERIFY2(right < -1.3 && right > -1.8, qPrintable(QString::number(right)));
    QCOMPARE(step.status, ServerStatus::Running);
    QVERIFY(std::fabs((Vec2(3.0, 0.0) - robot.pose.position).norm() - 1.0) < 0.16);
  }

  void following_endsAfterItsDuration() {
    FollowingServer server({}, Distro::Main);
    Robot robot;
    server.follow({5.0, false}, 0.0);
    const FollowingStep step = followFor(server, robot, 30.0, [](double) {
      return std::optional(Pose2{{3.0, 0.0}, 0.0});
    });
    QCOMPARE(step.status, ServerStatus::Succeeded);
    QVERIFY(server.elapsedTime() > 5.0 && server.elapsedTime() < 5.11);
  }

  void following_endsWhenTheObjectStands() {
    FollowingServerParameters parameters;
    parameters.staticObjectTimeout = 4.0;
    FollowingServer server(parameters, Distro::Main);
    Robot robot;
    server.follow({0.0, false}, 0.0);
    const FollowingStep step = followFor(server, robot, 60.0, [](double) {
      return std::optional(Pose2{{2.0, 0.0}, 0.0});
    });
    QCOMPARE(step.status, ServerStatus::Succeeded);
    // 1 m less the tolerance of 0.15 m at 0.25 m/s takes 3.4 s.
    QVERIFY2(robot.time > 7.4 && robot.time < 8.2, qPrintable(QString::number(robot.time)));
  }

  // ---- files
  // ---------------------------------------------------------------------------------------
  void file_isReadWithItsDocks() {
    const Nav2ReadResult reading = readingOf(R"(controller_server:
  ros__parameters:
    FollowPath: {plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"}
docking_server:
  ros__parameters:
    controller_frequency: 20.0
    dock_backwards: false
    dock_plugins: ["simple", "shelf"]
    simple:
      plugin: "opennav_docking::SimpleChargingDock"
      staging_x_offset: -0.9
      external_detection_translation_x: -0.18
    shelf:
      plugin: "opennav_docking::SimpleNonChargingDock"
    docks: ["home", "rack"]
    home: {type: "simple", frame: "map", pose: [1.0, 2.0, 0.5]}
    rack: {type: "shelf", pose: [3.0, 4.0, -1.0]}
    controller: {k_phi: 2.5}
)");
    QVERIFY2(reading.ok(), reading.problems.empty() ? "" : reading.problems[0].text().c_str());
    const DockingServerParameters& docking = reading.parameters.dockingServer;
    QCOMPARE(docking.controllerFrequency, 20.0);
    QCOMPARE(docking.kPhi, 2.5);
    QCOMPARE(docking.plugins.size(), std::size_t{2});
    QCOMPARE(docking.plugins[0].stagingXOffset, -0.9);
    QVERIFY(docking.plugins[0].isCharger && !docking.plugins[1].isCharger);
    QCOMPARE(docking.instances.size(), std::size_t{2});
    QCOMPARE(docking.instances[0].name, std::string("home"));
    QVERIFY(isNear(docking.instances[1].pose, {{3.0, 4.0}, -1.0}, 1e-12, 1e-12));
    for (const KeyUsage& key : reading.parameters.notes.keys) {
      QVERIFY2(key.use != KeyUse::Unknown, key.path.c_str());
    }
  }

  void database_isReadBesideTheFile() {
    const std::string folder = std::string(TEST_OUTPUT_DIR) + "/tmp/";
    base::writeFileAtomically(folder + "docks.yaml",
                              "docks:\n  home:\n    type: simple\n    pose: [1.0, 2.0, 0.5]\n");
    const std::string head = R"(controller_server:
  ros__parameters:
    FollowPath: {plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"}
docking_server:
  ros__parameters:
    dock_plugins: ["simple"]
    simple: {plugin: "opennav_docking::SimpleChargingDock"}
    dock_database: )";
    const Nav2ReadResult reading =
        readingOf(head + "/home/robot/docks.yaml\n", Distro::Jazzy, folder + "p.yaml");
    QVERIFY2(reading.ok(), reading.problems.empty() ? "" : reading.problems[0].text().c_str());
    QCOMPARE(reading.parameters.dockingServer.instances.size(), std::size_t{1});
    QCOMPARE(reading.parameters.dockingServer.instances[0].name, std::string("home"));
    const Nav2ReadResult lost = readingOf(head + "lost.yaml\n", Distro::Jazzy, folder + "p.yaml");
    QVERIFY(lost.ok());  // the file is on the robot
    QVERIFY(std::any_of(lost.problems.begin(), lost.problems.end(),
                        [](const auto& problem) { return problem.code == "nav2.file-not-found"; }));
  }

  void wrongDock_isAnErrorAtItsLine() {
    const Nav2ReadResult reading = readingOf(R"(controller_server:
  ros__parameters:
    FollowPath: {plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"}
docking_server:
  ros__parameters:
    dock_plugins: ["simple"]
    simple: {plugin: "opennav_docking::SimpleChargingDock"}
    docks: ["home"]
    home: {type: "simple", pose: [1.0, 2.0]}
)");
    QCOMPARE(reading.problems.size(), std::size_t{1});
    QCOMPARE(reading.problems[0].line, 9);
  }
};

QTEST_GUILESS_MAIN(Nav2DockingTest)
#include "tst_Nav2Docking.moc"
