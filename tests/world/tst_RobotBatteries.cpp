#include <cmath>

#include <QtTest>

#include "sim2d/world/RobotSensors.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Dock dockAtPlace(const Pose2& pose, DockKind kind = DockKind::Charging) {
  Dock dock;
  dock.name = "dock1";
  dock.pose = pose;
  dock.kind = kind;
  return dock;
}

/// 1 Wh, half full.
Robot& withBattery(Robot& robot) {
  robot.battery.capacity = 1.0;
  robot.battery.level = 0.5;
  return robot;
}

std::vector<std::string> textsOf(const std::vector<Recorded>& events) {
  std::vector<std::string> texts;
  for (const Recorded& recorded : ofKind(events, EventKind::Battery)) {
    texts.push_back(recorded.event.text);
  }
  return texts;
}

}  // namespace

/// Batteries of robots, and docks in the world.
class RobotBatteriesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void dock_holdsARobotOfEitherHeading() {
    const Dock dock = dockAtPlace({{1.0, 2.0}, 0.5});
    const std::vector<const Dock*> docks = {&dock};
    QCOMPARE(dockAt(docks, {{1.0, 2.0}, 0.5}), &dock);
    QCOMPARE(dockAt(docks, {{1.09, 2.0}, 0.5}), &dock);
    QCOMPARE(dockAt(docks, {{1.0, 2.0}, 0.5 - base::kPi}), &dock);  // backed in
    QVERIFY(dockAt(docks, {{1.11, 2.0}, 0.5}) == nullptr);
    QVERIFY(dockAt(docks, {{1.0, 2.0}, 0.9}) == nullptr);
    QVERIFY(dockAt(docks, {{1.0, 2.0}, 2.0}) == nullptr);
  }

  /// The robot is at (1, 1), heading 90 degrees, and takes itself to be at (0, 0), heading 0: what
  /// is 2 m ahead of it is at (2, 0) for it.
  void detector_seesDocksRelativeToTheRobot() {
    const Dock near = dockAtPlace({{1.0, 3.0}, base::kPi});
    const Dock far = dockAtPlace({{1.0, 4.1}, 0.0});
    const std::vector<DockPose> seen =
        detectedDocks({&near, &far}, {{1.0, 1.0}, 0.5 * base::kPi}, {{0.0, 0.0}, 0.0});
    QCOMPARE(seen.size(), std::size_t{1});
    QVERIFY((seen[0].pose.position - Vec2(2.0, 0.0)).norm() < 1e-12);
    QVERIFY(std::fabs(seen[0].pose.heading - 0.5 * base::kPi) < 1e-12);
  }

  /// At half of its top speed 20 + 30 W: 50 W for 0.05 s are 2.5 J of 3600 J.
  void driving_takesEnergy() {
    WorldModel model;
    ResolvedRobot robot;
    robot.battery.capacity = 1.0;
    model.robots = {robot};
    WorldState state;
    RobotState now;
    now.battery = 0.5;
    now.linear = 0.5;
    state.robots = {now};
    updateBatteries(model, state);
    QVERIFY(std::fabs(state.robots[0].battery - (0.5 - 2.5 / 3600.0)) < 1e-12);
    const auto battery = measuredBattery(robot, state.robots[0]);
    QVERIFY(battery && !battery->isCharging);
    QVERIFY(std::fabs(battery->current + 50.0 / battery->voltage) < 1e-12);
    QVERIFY(!measuredBattery(ResolvedRobot(), now));
  }

  /// 360 J: the first second, in which it accelerates to 1 m/s, takes 50 J, then 80 W are left for
  /// 3.875 s. Until then it has driven 0.5 m and 3.875 m.
  void emptyRobot_stands() {
    Scenario scenario;
    Robot& robot = withBattery(addRobot(scenario, Vec2(0.0, 0.0), Vec2(20.0, 0.0)));
    robot.battery.capacity = 0.2;
    const auto world = make(scenario);
    const std::vector<Recorded> events = ofKind(advance(*world, 400), EventKind::Battery);
    QCOMPARE(textsOf(events), std::vector<std::string>{"empty"});
    QVERIFY2(std::abs(static_cast<int>(events[0].step) - 97) <= 3,
             qPrintable(QString::number(events[0].step)));
    const Frame& frame = world->frame();
    QCOMPARE(frame.robots.vx[0], 0.0);
    QVERIFY2(std::fabs(robotPosition(frame).x() - 4.9) < 0.3,  // it brakes within 0.5 m
             qPrintable(QString::number(robotPosition(frame).x())));
  }

  /// 1800 J with 120 W: 15 s.
  void dockedRobot_isCharged() {
    Scenario scenario;
    Robot& robot = withBattery(addRobot(scenario, Vec2(1.0, 1.0), Vec2(2.0, 2.0)));
    robot.goal.point.reset();
    scenario.docks.push_back(dockAtPlace({{1.0, 1.0}, 0.0}));
    const auto world = make(scenario);
    const std::vector<Recorded> events = ofKind(advance(*world, 400), EventKind::Battery);
    QCOMPARE(textsOf(events), (std::vector<std::string>{"charging", "full"}));
    QCOMPARE(static_cast<int>(events[0].step), 1);
    QVERIFY(std::abs(static_cast<int>(events[1].step) - 300) <= 1);
  }

  void parkingDock_doesNotCharge() {
    Scenario scenario;
    Robot& robot = withBattery(addRobot(scenario, Vec2(1.0, 1.0), Vec2(2.0, 2.0)));
    robot.goal.point.reset();
    scenario.docks.push_back(dockAtPlace({{1.0, 1.0}, 0.0}, DockKind::Parking));
    const auto world = make(scenario);
    // 1800 J with 20 W: empty after 90 s.
    QCOMPARE(textsOf(advance(*world, 1750)), std::vector<std::string>());
    QCOMPARE(textsOf(advance(*world, 100)), std::vector<std::string>{"empty"});
  }
};

QTEST_GUILESS_MAIN(RobotBatteriesTest)
#include "tst_RobotBatteries.moc"
