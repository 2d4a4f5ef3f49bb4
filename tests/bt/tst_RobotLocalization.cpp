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
  QTest::addColumn<QByteArray>("parent");
  QTest::addColumn<QByteArray>("child");
  QTest::addColumn<bool>("hasPose");
  QTest::addColumn<bool>("isThere");
  QTest::newRow("map") << QByteArray("map") << QByteArray("base_link") << true << true;
  QTest::newRow("slash") << QByteArray("/map") << QByteArray("/odom") << true << true;
  QTest::newRow("no pose yet") << QByteArray("map") << QByteArray("odom") << false << false;
  QTest::newRow("odom has one") << QByteArray("odom") << QByteArray("base_link") << false << true;
  QTest::newRow("the other way") << QByteArray("base_link") << QByteArray("odom") << false << true;
  QTest::newRow("itself") << QByteArray("map") << QByteArray("map") << false << true;
  QTest::newRow("sensor") << QByteArray("map") << QByteArray("laser") << true << true;
  QTest::newRow("unknown") << QByteArray("map") << QByteArray("camera_link") << true << false;
  QTest::newRow("unknown parent") << QByteArray("world") << QByteArray("map") << true << false;
  QTest::newRow("no name") << QByteArray("map") << QByteArray() << true << false;
}

void RobotLocalizationTest::transformAvailable_knownFrames_succeeds() {
  QFETCH(QByteArray, parent);
  QFETCH(QByteArray, child);
  QFETCH(bool, hasPose);
  QFETCH(bool, isThere);
  Played played(tableOf(transform(parent.toStdString(), child.toStdString())));
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
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("map");
  QTest::addColumn<QByteArray>("odom");
  QTest::addColumn<bool>("isLocalInOdom");
  const auto costmaps = [](const std::string& local, const std::string& global,
                           const std::string& more = {}) {
    return QByteArray::fromStdString(node("local_costmap", local) + node("global_costmap", global) +
                                     more);
  };
  QTest::newRow("usual") << costmaps("global_frame: odom", "global_frame: map") << QByteArray("map")
                         << QByteArray("odom") << true;
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
  QTest::newRow("Humble's behaviours") << costmaps("global_frame: map", "global_frame: map",
                                                   node("behavior_server", "global_frame: wheels"))
                                       << QByteArray("map") << QByteArray("wheels") << false;
}

void RobotLocalizationTest::frameNames_ofFiles() {
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

QTEST_APPLESS_MAIN(RobotLocalizationTest)
#include "tst_RobotLocalization.moc"
