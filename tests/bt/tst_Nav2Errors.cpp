#include <QtTest>

#include "bt/robot/Nav2Errors.h"

/// Names of Nav2's error codes, as its action definitions have them (nav2_msgs/action, Jazzy).
class Nav2ErrorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void reason_hasNameAndCode_data();
  void reason_hasNameAndCode();
  void reason_ofHumble_hasNoCode();
  void reason_ofWhatIsNotThere_isNamed();
  void throughPoses_haveCodesOfTheirOwn();
};

using bt::ActionFailure;
using bt::RobotAction;
using sim2d::nav2::Distro;

void Nav2ErrorsTest::reason_hasNameAndCode_data() {
  QTest::addColumn<int>("action");
  QTest::addColumn<int>("code");
  QTest::addColumn<QString>("reason");
  const auto row = [](RobotAction action, int code, const char* reason) {
    QTest::newRow(reason) << static_cast<int>(action) << code << reason;
  };
  row(RobotAction::FollowPath, 100, "controller UNKNOWN (100)");
  row(RobotAction::FollowPath, 101, "controller INVALID_CONTROLLER (101)");
  row(RobotAction::FollowPath, 103, "controller INVALID_PATH (103)");
  row(RobotAction::FollowPath, 104, "controller PATIENCE_EXCEEDED (104)");
  row(RobotAction::FollowPath, 105, "controller FAILED_TO_MAKE_PROGRESS (105)");
  row(RobotAction::FollowPath, 106, "controller NO_VALID_CONTROL (106)");
  row(RobotAction::FollowPath, 107, "controller CONTROLLER_TIMED_OUT (107)");
  row(RobotAction::ComputePath, 200, "planner UNKNOWN (200)");
  row(RobotAction::ComputePath, 201, "planner INVALID_PLANNER (201)");
  row(RobotAction::ComputePath, 203, "planner START_OUTSIDE_MAP (203)");
  row(RobotAction::ComputePath, 204, "planner GOAL_OUTSIDE_MAP (204)");
  row(RobotAction::ComputePath, 205, "planner START_OCCUPIED (205)");
  row(RobotAction::ComputePath, 206, "planner GOAL_OCCUPIED (206)");
  row(RobotAction::ComputePath, 207, "planner TIMEOUT (207)");
  row(RobotAction::ComputePath, 208, "planner NO_VALID_PATH (208)");
  row(RobotAction::ComputePathThroughPoses, 306, "planner GOAL_OCCUPIED (306)");
  row(RobotAction::ComputePathThroughPoses, 308, "planner NO_VALID_PATH (308)");
  row(RobotAction::ComputePathThroughPoses, 309, "planner NO_VIAPOINTS_GIVEN (309)");
  row(RobotAction::SmoothPath, 501, "smoother INVALID_SMOOTHER (501)");
  row(RobotAction::SmoothPath, 503, "smoother SMOOTHED_PATH_IN_COLLISION (503)");
  row(RobotAction::Spin, 701, "spin TIMEOUT (701)");
  row(RobotAction::Spin, 703, "spin COLLISION_AHEAD (703)");
  row(RobotAction::BackUp, 713, "backup INVALID_INPUT (713)");
  row(RobotAction::BackUp, 714, "backup COLLISION_AHEAD (714)");
  row(RobotAction::DriveOnHeading, 723, "drive_on_heading COLLISION_AHEAD (723)");
  row(RobotAction::DriveOnHeading, 724, "drive_on_heading INVALID_INPUT (724)");
  row(RobotAction::Wait, 741, "wait TIMEOUT (741)");
}

void Nav2ErrorsTest::reason_hasNameAndCode() {
  QFETCH(int, action);
  QFETCH(int, code);
  QFETCH(QString, reason);
  const ActionFailure failure{static_cast<RobotAction>(action), code};
  for (const Distro distro : {Distro::Jazzy, Distro::Kilted, Distro::Lyrical, Distro::Main}) {
    QCOMPARE(bt::failureReason(failure, distro), reason.toStdString());
  }
  QVERIFY(!bt::failureMessage(failure).empty());
}

/// Its actions have no error codes.
void Nav2ErrorsTest::reason_ofHumble_hasNoCode() {
  QCOMPARE(bt::failureReason({RobotAction::ComputePath, 208}, Distro::Humble),
           std::string("planner NO_VALID_PATH"));
}

void Nav2ErrorsTest::reason_ofWhatIsNotThere_isNamed() {
  QCOMPARE(bt::failureReason({RobotAction::Spin, 0}, Distro::Jazzy),
           std::string("spin NOT_AVAILABLE"));
}

void Nav2ErrorsTest::throughPoses_haveCodesOfTheirOwn() {
  QCOMPARE(bt::throughPosesCode(0), 0);
  QCOMPARE(bt::throughPosesCode(208), 308);
  QVERIFY(bt::isPlannerFailure({RobotAction::ComputePathThroughPoses, 308}));
  QVERIFY(!bt::isPlannerFailure({RobotAction::FollowPath, 105}));
}

QTEST_APPLESS_MAIN(Nav2ErrorsTest)
#include "tst_Nav2Errors.moc"
