#include <string>

#include <QtTest>

#include "tests/bt/ScriptedNavigator.h"

/// Nodes for docking, following, teleoperation and batteries: ports, errors, halts.
class DockingNodesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void dock_asksWithItsPorts();
  void dock_withoutAPose_failsAtOnce();
  void dock_fails_tellsTheCode();
  void dock_halted_isCancelled();
  void undock_asksWithItsPorts();
  void follow_asksWithItsPorts();
  void cancelNodes_endTheirActions();
  void teleop_countsAsARecovery();
  void battery_isLowAtItsLimit();
  void battery_ofARobotWithout_isNeitherLowNorCharging();
};

namespace {

using base::NodeStatus;
using navigator::Answer;
using navigator::Distro;
using navigator::Played;
using navigator::RobotAction;
using navigator::State;
using navigator::tableOf;

constexpr auto kSuccess = NodeStatus::Success;
constexpr auto kFailure = NodeStatus::Failure;
constexpr auto kRunning = NodeStatus::Running;

}  // namespace

void DockingNodesTest::dock_asksWithItsPorts() {
  Played tree(tableOf(R"(<DockRobot dock_id="home" dock_type="simple" max_staging_time="30.0"
    navigate_to_staging_pose="false"/>)"),
              Distro::Jazzy);
  QCOMPARE(tree.tick(), kRunning);
  QCOMPARE(tree.host.text(), std::string("dock"));
  QVERIFY(tree.host.last.dock.usesDockId);
  QCOMPARE(tree.host.last.dock.dockId, std::string("home"));
  QCOMPARE(tree.host.last.dock.type, std::string("simple"));
  QCOMPARE(tree.host.last.dock.maxStagingTime, 30.0);
  QVERIFY(!tree.host.last.dock.navigatesToStaging);
  QCOMPARE(tree.tick(), kSuccess);

  Played usual(tableOf(R"(<DockRobot dock_id="home"/>)"), Distro::Jazzy);
  usual.tick();
  QCOMPARE(usual.host.last.dock.maxStagingTime, 1000.0);
  QVERIFY(usual.host.last.dock.navigatesToStaging);
}

void DockingNodesTest::dock_withoutAPose_failsAtOnce() {
  Played tree(tableOf(R"(<DockRobot use_dock_id="false" dock_pose="{pose}"/>)"), Distro::Jazzy);
  QCOMPARE(tree.tick(), kFailure);
  QVERIFY(tree.host.log.empty());
  Played posed(tableOf(R"(<DockRobot use_dock_id="false" dock_pose="{goal}" dock_type="a"/>)"),
               Distro::Jazzy);
  QCOMPARE(posed.tick(), kRunning);
  QCOMPARE(posed.host.last.path, posed.host.goal);
  QVERIFY(!posed.host.last.dock.usesDockId);
}

void DockingNodesTest::dock_fails_tellsTheCode() {
  for (const int code : {904, 905}) {
    Played tree(tableOf(R"(<Fallback><DockRobot dock_id="home" error_code_id="{code}"/>
      <AreErrorCodesPresent error_code="{code}" error_codes_to_check="905"/></Fallback>)"),
                Distro::Jazzy);
    tree.host.script[RobotAction::DockRobot] = {{State::Failed, code, 1}};
    QCOMPARE(tree.play(10), code == 905 ? kSuccess : kFailure);
  }
}

void DockingNodesTest::dock_halted_isCancelled() {
  Played tree(tableOf(R"(<Timeout msec="200"><DockRobot dock_id="home"/></Timeout>)"),
              Distro::Jazzy);
  tree.host.script[RobotAction::DockRobot] = {{State::Succeeded, 0, 0}};
  QCOMPARE(tree.play(20), kFailure);
  QCOMPARE(tree.host.text(), std::string("dock cancel"));
}

void DockingNodesTest::undock_asksWithItsPorts() {
  Played tree(tableOf(R"(<UndockRobot dock_type="simple" max_undocking_time="12.0"/>)"),
              Distro::Jazzy);
  QCOMPARE(tree.tick(), kRunning);
  QCOMPARE(tree.host.text(), std::string("undock"));
  QCOMPARE(tree.host.last.dock.type, std::string("simple"));
  QCOMPARE(tree.host.last.timeAllowance, 12.0);
  QCOMPARE(tree.tick(), kSuccess);
}

void DockingNodesTest::follow_asksWithItsPorts() {
  Played tree(tableOf(R"(<FollowObject tracked_frame="anna" max_duration="7.0"/>)"), Distro::Main);
  QCOMPARE(tree.tick(), kRunning);
  QCOMPARE(tree.host.text(), std::string("object"));
  QCOMPARE(tree.host.last.object.frame, std::string("anna"));
  QCOMPARE(tree.host.last.object.topic, std::string("dynamic_pose"));
  QCOMPARE(tree.host.last.timeAllowance, 7.0);
  QCOMPARE(tree.tick(), kSuccess);
}

void DockingNodesTest::cancelNodes_endTheirActions() {
  for (const char* const id : {"CancelFollowObject", "CancelAssistedTeleop"}) {
    Played tree(tableOf("<" + std::string(id) + "/>"), Distro::Main);
    QCOMPARE(tree.tick(), kSuccess);
    QCOMPARE(tree.host.text(), std::string("cancel"));
  }
}

void DockingNodesTest::teleop_countsAsARecovery() {
  for (const bool isRecovery : {true, false}) {
    Played tree(tableOf(std::string("<AssistedTeleop time_allowance=\"5.0\" is_recovery=\"") +
                        (isRecovery ? "true" : "false") + "\"/>"),
                Distro::Humble);
    QCOMPARE(tree.tick(), kRunning);
    QCOMPARE(tree.host.text(), std::string("teleop"));
    QCOMPARE(tree.host.last.timeAllowance, 5.0);
    QCOMPARE(tree.host.recoveries, isRecovery ? 1 : 0);
  }
}

void DockingNodesTest::battery_isLowAtItsLimit() {
  for (const double level : {0.31, 0.3, 0.2}) {
    Played tree(tableOf(R"(<IsBatteryLow min_battery="0.3" battery_topic="/b"/>)"));
    tree.host.charge = sim2d::BatteryState{level, 25.0, -1.0, false};
    QCOMPARE(tree.tick(), level <= 0.3 ? kSuccess : kFailure);
  }
  for (const double voltage : {23.1, 22.9}) {
    Played tree(
        tableOf(R"(<IsBatteryLow min_battery="23.0" is_voltage="true" battery_topic="/b"/>)"));
    tree.host.charge = sim2d::BatteryState{0.9, voltage, -1.0, false};
    QCOMPARE(tree.tick(), voltage < 23.0 ? kSuccess : kFailure);
  }
  for (const bool isCharging : {true, false}) {
    Played tree(tableOf(R"(<IsBatteryCharging battery_topic="/b"/>)"));
    tree.host.charge = sim2d::BatteryState{0.5, 24.0, 3.0, isCharging};
    QCOMPARE(tree.tick(), isCharging ? kSuccess : kFailure);
  }
}

void DockingNodesTest::battery_ofARobotWithout_isNeitherLowNorCharging() {
  for (const char* const id : {"IsBatteryLow", "IsBatteryCharging"}) {
    Played tree(tableOf("<" + std::string(id) + " battery_topic=\"/b\"/>"));
    QCOMPARE(tree.tick(), kFailure);
  }
}

QTEST_GUILESS_MAIN(DockingNodesTest)
#include "tst_DockingNodes.moc"
