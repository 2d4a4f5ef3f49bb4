#include <string>

#include <QtTest>

#include "tests/bt/ScriptedNavigator.h"

/// Nodes that ask for the localiser and for TF.
class RobotLocalizationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initialPoseReceived_afterTheFirstCorrection_succeeds();
  void transformAvailable_knownFrames_succeeds_data();
  void transformAvailable_knownFrames_succeeds();
  void transformAvailable_onceFound_isNotAskedForAgain();
  void reinitialize_withLocalizer_asksForIt();
  void frameNames_ofFiles_data();
  void frameNames_ofFiles();
};

namespace {

using base::NodeStatus;
using navigator::Played;
using navigator::tableOf;
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

void RobotLocalizationTest::initialPoseReceived_afterTheFirstCorrection_succeeds() {
  Played played(tableOf("<InitialPoseReceived/>"));
  played.host.hasPose = false;
  QCOMPARE(played.tick(), NodeStatus::Failure);
  played.host.hasPose = true;
  QCOMPARE(played.tick(), NodeStatus::Success);
}

void RobotLocalizationTest::transformAvailable_knownFrames_succeeds_data() {
  QTest::addColumn<std::string>("parent");
  QTest::addColumn<std::string>("child");
  QTest::addColumn<bool>("hasPose");
  QTest::addColumn<bool>("isThere");
  QTest::newRow("map") << std::string("map") << std::string("base_link") << true << true;
  QTest::newRow("slash") << std::string("/map") << std::string("/odom") << true << true;
  QTest::newRow("no pose yet") << std::string("map") << std::string("odom") << false << false;
  QTest::newRow("odom has one") << std::string("odom") << std::string("base_link") << false << true;
  QTest::newRow("the other way") << std::string("base_link") << std::string("odom") << false
                                 << true;
  QTest::newRow("itself") << std::string("map") << std::string("map") << false << true;
  QTest::newRow("sensor") << std::string("map") << std::string("laser") << true << true;
  QTest::newRow("unknown") << std::string("map") << std::string("camera_link") << true << false;
  QTest::newRow("unknown parent") << std::string("world") << std::string("map") << true << false;
  QTest::newRow("no name") << std::string("map") << std::string() << true << false;
}

void RobotLocalizationTest::transformAvailable_knownFrames_succeeds() {
  QFETCH(std::string, parent);
  QFETCH(std::string, child);
  QFETCH(bool, hasPose);
  QFETCH(bool, isThere);
  Played played(tableOf(transform(parent, child)));
  played.host.frames.onRobot = {"base_link", "laser"};
  played.host.hasPose = hasPose;
  QCOMPARE(played.tick(), isThere ? NodeStatus::Success : NodeStatus::Failure);
}

void RobotLocalizationTest::transformAvailable_onceFound_isNotAskedForAgain() {
  Played played(tableOf(transform("map", "odom")));
  QCOMPARE(played.tick(), NodeStatus::Success);
  played.host.hasPose = false;
  QCOMPARE(played.tick(), NodeStatus::Success);
}

void RobotLocalizationTest::reinitialize_withLocalizer_asksForIt() {
  Played played(tableOf("<ReinitializeGlobalLocalization/>"));
  QCOMPARE(played.tick(), NodeStatus::Success);
  QCOMPARE(played.host.text(), std::string("relocalize"));
  played.host.hasLocalizer = false;
  QCOMPARE(played.tick(), NodeStatus::Failure);
}

void RobotLocalizationTest::frameNames_ofFiles_data() {
  QTest::addColumn<std::string>("text");
  QTest::addColumn<std::string>("map");
  QTest::addColumn<std::string>("odom");
  QTest::addColumn<bool>("isLocalInOdom");
  const auto costmaps = [](const std::string& local, const std::string& global) {
    return node("local_costmap", local) + node("global_costmap", global);
  };
  QTest::newRow("usual") << costmaps("global_frame: odom", "global_frame: map")
                         << std::string("map") << std::string("odom") << true;
  QTest::newRow("both in the map") << costmaps("global_frame: map", "global_frame: map")
                                   << std::string("map") << std::string("odom") << false;
  QTest::newRow("Nav2's defaults")
      << costmaps("width: 3", "width: 3") << std::string("map") << std::string("odom") << false;
  QTest::newRow("other names") << costmaps("global_frame: /r1/odom", "global_frame: /world")
                               << std::string("world") << std::string("r1/odom") << true;
  QTest::newRow("of the behaviours")
      << costmaps("global_frame: map", "global_frame: map") +
             node("behavior_server", "local_frame: odom_combined, global_frame: map")
      << std::string("map") << std::string("odom_combined") << false;
  QTest::newRow("Humble's behaviours") << costmaps("global_frame: map", "global_frame: map") +
                                              node("behavior_server", "global_frame: wheels")
                                       << std::string("map") << std::string("wheels") << false;
}

void RobotLocalizationTest::frameNames_ofFiles() {
  QFETCH(std::string, text);
  QFETCH(std::string, map);
  QFETCH(std::string, odom);
  QFETCH(bool, isLocalInOdom);
  const FrameNames names =
      namesIn(text + node("amcl", "base_frame_id: base_foot, scan_topic: scan") +
              node("collision_monitor", "scan: {sensor_frame: /front_laser}"));
  QCOMPARE(names.map, map);
  QCOMPARE(names.odom, odom);
  QCOMPARE(names.isLocalInOdom, isLocalInOdom);
  QCOMPARE(names.onRobot,
           (std::vector<std::string>{"base_foot", "base_footprint", "base_link", "front_laser"}));
  QVERIFY(names.canTransform(map, "front_laser", true));
  QVERIFY(!names.canTransform(odom, "scan", true));
}

QTEST_APPLESS_MAIN(RobotLocalizationTest)
#include "tst_RobotLocalization.moc"
