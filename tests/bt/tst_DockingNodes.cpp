#include <string>

#include <QtTest>

#include "tests/bt/ScriptedNavigator.h"

namespace {

using namespace navigator;

using sim2d::nav2::FrameNames;
using sim2d::nav2::ParameterFile;

std::string transform(const std::string& parent, const std::string& child) {
  return "<TransformAvailable parent=\"" + parent + "\" child=\"" + child + "\"/>";
}

FrameNames namesIn(const std::string& text) {
  const auto file = ParameterFile::parse(text, "nav2.yaml");
  return file ? sim2d::nav2::frameNamesOf(*file, "") : FrameNames();
}

std::string node(const std::string& name, const std::string& keys) {
  return name + ":\n  ros__parameters: {" + keys + "}\n";
}

}  // namespace

/// Nodes for docking, following, teleoperation and batteries: ports, errors, halts.
class DockingNodesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void dock_asksWithItsPorts() {
    Played tree(R"(<DockRobot dock_id="home" dock_type="simple" max_staging_time="30.0"
    navigate_to_staging_pose="false"/>)",
                Distro::Jazzy);
    QCOMPARE(tree.tick(), kRunning);
    QCOMPARE(tree.host.text(), std::string("dock"));
    QVERIFY(tree.host.last.dock.usesDockId);
    QCOMPARE(tree.host.last.dock.dockId, std::string("home"));
    QCOMPARE(tree.host.last.dock.type, std::string("simple"));
    QCOMPARE(tree.host.last.dock.maxStagingTime, 30.0);
    QVERIFY(!tree.host.last.dock.navigatesToStaging);
    QCOMPARE(tree.tick(), kSuccess);

    Played usual(R"(<DockRobot dock_id="home"/>)", Distro::Jazzy);
    usual.tick();
    QCOMPARE(usual.host.last.dock.maxStagingTime, 1000.0);
    QVERIFY(usual.host.last.dock.navigatesToStaging);
  }

  void dock_withoutAPose_failsAtOnce() {
    Played tree(R"(<DockRobot use_dock_id="false" dock_pose="{pose}"/>)", Distro::Jazzy);
    QCOMPARE(tree.tick(), kFailure);
    QVERIFY(tree.host.log.empty());
    Played posed(R"(<DockRobot use_dock_id="false" dock_pose="{goal}" dock_type="a"/>)",
                 Distro::Jazzy);
    QCOMPARE(posed.tick(), kRunning);
    QCOMPARE(posed.host.last.path, posed.host.goal);
    QVERIFY(!posed.host.last.dock.usesDockId);
  }

  void dock_fails_tellsTheCode() {
    for (const int code : {904, 905}) {
      Played tree(R"(<Fallback><DockRobot dock_id="home" error_code_id="{code}"/>
      <AreErrorCodesPresent error_code="{code}" error_codes_to_check="905"/></Fallback>)",
                  Distro::Jazzy);
      tree.host.script[RobotAction::DockRobot] = {{State::Failed, code, 1}};
      QCOMPARE(tree.play(10), code == 905 ? kSuccess : kFailure);
    }
  }

  void dock_halted_isCancelled() {
    Played tree(R"(<Timeout msec="200"><DockRobot dock_id="home"/></Timeout>)", Distro::Jazzy);
    tree.host.script[RobotAction::DockRobot] = {{State::Succeeded, 0, 0}};
    QCOMPARE(tree.play(20), kFailure);
    QCOMPARE(tree.host.text(), std::string("dock cancel"));
  }

  void undock_asksWithItsPorts() {
    Played tree(R"(<UndockRobot dock_type="simple" max_undocking_time="12.0"/>)", Distro::Jazzy);
    QCOMPARE(tree.tick(), kRunning);
    QCOMPARE(tree.host.text(), std::string("undock"));
    QCOMPARE(tree.host.last.dock.type, std::string("simple"));
    QCOMPARE(tree.host.last.timeAllowance, 12.0);
    QCOMPARE(tree.tick(), kSuccess);
  }

  void follow_asksWithItsPorts() {
    Played tree(R"(<FollowObject tracked_frame="anna" max_duration="7.0"/>)", Distro::Main);
    QCOMPARE(tree.tick(), kRunning);
    QCOMPARE(tree.host.text(), std::string("object"));
    QCOMPARE(tree.host.last.object.frame, std::string("anna"));
    QCOMPARE(tree.host.last.object.topic, std::string("dynamic_pose"));
    QCOMPARE(tree.host.last.timeAllowance, 7.0);
    QCOMPARE(tree.tick(), kSuccess);
  }

  void cancelNodes_endTheirActions() {
    for (const char* const id : {"CancelFollowObject", "CancelAssistedTeleop"}) {
      Played tree("<" + std::string(id) + "/>", Distro::Main);
      QCOMPARE(tree.tick(), kSuccess);
      QCOMPARE(tree.host.text(), std::string("cancel"));
    }
  }

  void teleop_countsAsARecovery() {
    for (const bool isRecovery : {true, false}) {
      Played tree(std::string("<AssistedTeleop time_allowance=\"5.0\" is_recovery=\"") +
                      (isRecovery ? "true" : "false") + "\"/>",
                  Distro::Humble);
      QCOMPARE(tree.tick(), kRunning);
      QCOMPARE(tree.host.text(), std::string("teleop"));
      QCOMPARE(tree.host.last.timeAllowance, 5.0);
      QCOMPARE(tree.host.recoveries, isRecovery ? 1 : 0);
    }
  }

  void battery_isLowAtItsLimit() {
    for (const double level : {0.31, 0.3, 0.2}) {
      Played tree(R"(<IsBatteryLow min_battery="0.3" battery_topic="/b"/>)");
      tree.host.charge = sim2d::BatteryState{level, 25.0, -1.0, false};
      QCOMPARE(tree.tick(), level <= 0.3 ? kSuccess : kFailure);
    }
    for (const double voltage : {23.1, 22.9}) {
      Played tree(R"(<IsBatteryLow min_battery="23.0" is_voltage="true" battery_topic="/b"/>)");
      tree.host.charge = sim2d::BatteryState{0.9, voltage, -1.0, false};
      QCOMPARE(tree.tick(), voltage < 23.0 ? kSuccess : kFailure);
    }
    for (const bool isCharging : {true, false}) {
      Played tree(R"(<IsBatteryCharging battery_topic="/b"/>)");
      tree.host.charge = sim2d::BatteryState{0.5, 24.0, 3.0, isCharging};
      QCOMPARE(tree.tick(), isCharging ? kSuccess : kFailure);
    }
  }

  void battery_ofARobotWithout_isNeitherLowNorCharging() {
    for (const char* const id : {"IsBatteryLow", "IsBatteryCharging"}) {
      Played tree("<" + std::string(id) + " battery_topic=\"/b\"/>");
      QCOMPARE(tree.tick(), kFailure);
    }
  }

  // Nodes that ask for the localiser and for TF.

  void initialPoseReceived_afterTheFirstCorrection_succeeds() {
    Played played("<InitialPoseReceived/>");
    played.host.hasPose = false;
    QCOMPARE(played.tick(), NodeStatus::Failure);
    played.host.hasPose = true;
    QCOMPARE(played.tick(), NodeStatus::Success);
  }

  void transformAvailable_knownFrames_succeeds_data() {
    QTest::addColumn<QByteArray>("parent");
    QTest::addColumn<QByteArray>("child");
    QTest::addColumn<bool>("hasPose");
    QTest::addColumn<bool>("isThere");
    QTest::newRow("map") << QByteArray("map") << QByteArray("base_link") << true << true;
    QTest::newRow("slash") << QByteArray("/map") << QByteArray("/odom") << true << true;
    QTest::newRow("no pose yet") << QByteArray("map") << QByteArray("odom") << false << false;
    QTest::newRow("odom has one") << QByteArray("odom") << QByteArray("base_link") << false << true;
    QTest::newRow("the other way")
        << QByteArray("base_link") << QByteArray("odom") << false << true;
    QTest::newRow("itself") << QByteArray("map") << QByteArray("map") << false << true;
    QTest::newRow("sensor") << QByteArray("map") << QByteArray("laser") << true << true;
    QTest::newRow("unknown") << QByteArray("map") << QByteArray("camera_link") << true << false;
    QTest::newRow("unknown parent") << QByteArray("world") << QByteArray("map") << true << false;
    QTest::newRow("no name") << QByteArray("map") << QByteArray() << true << false;
  }

  void transformAvailable_knownFrames_succeeds() {
    QFETCH(QByteArray, parent);
    QFETCH(QByteArray, child);
    QFETCH(bool, hasPose);
    QFETCH(bool, isThere);
    Played played(transform(parent.toStdString(), child.toStdString()));
    played.host.frames.onRobot = {"base_link", "laser"};
    played.host.hasPose = hasPose;
    QCOMPARE(played.tick(), isThere ? NodeStatus::Success : NodeStatus::Failure);
  }

  void transformAvailable_onceFound_isNotAskedForAgain() {
    Played played(transform("map", "odom"));
    QCOMPARE(played.tick(), NodeStatus::Success);
    played.host.hasPose = false;
    QCOMPARE(played.tick(), NodeStatus::Success);
  }

  void reinitialize_withLocalizer_asksForIt() {
    Played played("<ReinitializeGlobalLocalization/>");
    QCOMPARE(played.tick(), NodeStatus::Success);
    QCOMPARE(played.host.text(), std::string("relocalize"));
    played.host.hasLocalizer = false;
    QCOMPARE(played.tick(), NodeStatus::Failure);
  }

  void frameNames_ofFiles_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("map");
    QTest::addColumn<QByteArray>("odom");
    QTest::addColumn<bool>("isLocalInOdom");
    const auto costmaps = [](const std::string& local, const std::string& global,
                             const std::string& more = {}) {
      return QByteArray::fromStdString(node("local_costmap", local) +
                                       node("global_costmap", global) + more);
    };
    QTest::newRow("usual") << costmaps("global_frame: odom", "global_frame: map")
                           << QByteArray("map") << QByteArray("odom") << true;
    QTest::newRow("both in the map") << costmaps("global_frame: map", "global_frame: map")
                                     << QByteArray("map") << QByteArray("odom") << false;
    QTest::newRow("Nav2's defaults")
        << costmaps("width: 3", "width: 3") << QByteArray("map") << QByteArray("odom") << false;
    QTest::newRow("other names") << costmaps("global_frame: /r1/odom", "global_frame: /world")
                                 << QByteArray("world") << QByteArray("r1/odom") << true;
    QTest::newRow("of the behaviours")
        << costmaps("global_frame: map", "global_frame: map",
                    node("behavior_server", "local_frame: odom_combined, global_frame: map"))
        << QByteArray("map") << QByteArray("odom_combined") << false;
    QTest::newRow("Humble's behaviours")
        << costmaps("global_frame: map", "global_frame: map",
                    node("behavior_server", "global_frame: wheels"))
        << QByteArray("map") << QByteArray("wheels") << false;
  }

  void frameNames_ofFiles() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, map);
    QFETCH(QByteArray, odom);
    QFETCH(bool, isLocalInOdom);
    const FrameNames names =
        namesIn(text.toStdString() + node("amcl", "base_frame_id: base_foot, scan_topic: scan") +
                node("collision_monitor", "scan: {sensor_frame: /front_laser}"));
    QCOMPARE(names.map, map.toStdString());
    QCOMPARE(names.odom, odom.toStdString());
    QCOMPARE(names.isLocalInOdom, isLocalInOdom);
    QCOMPARE(names.onRobot,
             (std::vector<std::string>{"base_foot", "base_footprint", "base_link", "front_laser"}));
    QVERIFY(names.canTransform(names.map, "front_laser", true));
    QVERIFY(!names.canTransform(names.odom, "scan", true));
  }
};

QTEST_GUILESS_MAIN(DockingNodesTest)
#include "tst_DockingNodes.moc"
