#include <cmath>

#include <QtTest>

#include "sim2d/nav/nav2/control/GoalCheckers.h"

using namespace sim2d::nav2;
using base::Vec2;
using sim2d::BodyTwist;

namespace {

std::unique_ptr<GoalChecker> checkerOf(const char* plugin, const Nav2ParameterBlock& block = {},
                                       Distro distro = Distro::Jazzy) {
  return *makeGoalChecker(plugin, distro, block);
}

GoalQuery query(double dx, double dyaw, const BodyTwist& speed = {}, double length = 0.0) {
  return {{Vec2(1.0 + dx, 2.0), 0.3 + dyaw}, {Vec2(1.0, 2.0), 0.3}, speed, length};
}

constexpr char kSimple[] = "nav2_controller::SimpleGoalChecker";
constexpr char kStopped[] = "nav2_controller/StoppedGoalChecker";
constexpr char kAxis[] = "nav2_controller::AxisGoalChecker";
constexpr char kAdaptive[] = "nav2_controller::AdaptiveToleranceGoalChecker";
constexpr char kPosition[] = "nav2_controller::PositionGoalChecker";

}  // namespace

class GoalCheckerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void simple_tolerances() {  // vector 79
    const auto checker = checkerOf(kSimple, {{"stateful", false}});
    QVERIFY(checker->isGoalReached(query(0.24, 0.0)));
    QVERIFY(!checker->isGoalReached(query(0.26, 0.0)));
    QVERIFY(checker->isGoalReached(query(0.0, 0.24)));
    QVERIFY(!checker->isGoalReached(query(0.0, 0.26)));
    QVERIFY(checker->isGoalReached(query(0.0, 2.0 * base::kPi - 0.24)));
    QCOMPARE(checker->xyTolerance(), 0.25);
    QCOMPARE(checker->yawTolerance(), 0.25);
  }

  void simple_stateful_placeIsLatched() {  // vector 79
    const auto checker = checkerOf(kSimple);
    QVERIFY(!checker->isGoalReached(query(0.24, 1.0)));
    QVERIFY(checker->isGoalReached(query(0.9, 0.1)));  // has left the place since
    QVERIFY(checker->isXyReached(query(0.9, 1.0)));
    checker->reset();
    QVERIFY(!checker->isGoalReached(query(0.9, 0.1)));
    QVERIFY(!checker->isXyReached(query(0.9, 0.1)));
  }

  void simple_notStateful_placeIsNot() {
    const auto checker = checkerOf(kSimple, {{"stateful", false}});
    QVERIFY(checker->isXyReached(query(0.24, 1.0)));
    QVERIFY(!checker->isGoalReached(query(0.9, 0.1)));
  }

  void simple_symmetric_backwardsIsAsGood() {
    const auto checker = checkerOf(kSimple, {{"symmetric_yaw_tolerance", true}});
    QVERIFY(checker->isGoalReached(query(0.0, base::kPi - 0.2)));
    QVERIFY(checker->isGoalReached(query(0.0, 0.2)));
    QVERIFY(!checker->isGoalReached(query(0.0, base::kPi / 2)));
    const auto humble = checkerOf(kSimple, {{"symmetric_yaw_tolerance", true}}, Distro::Humble);
    QVERIFY(humble->isGoalReached(query(0.0, base::kPi)));
  }

  void simple_main_longPathIsNotReached() {
    const auto checker = checkerOf(kSimple, {}, Distro::Main);
    QVERIFY(!checker->isGoalReached(query(0.0, 0.0, {}, 1.1)));
    QVERIFY(checker->isGoalReached(query(0.0, 0.0, {}, 1.0)));
    QVERIFY(checkerOf(kSimple)->isGoalReached(query(0.0, 0.0, {}, 9.0)));
  }

  void stopped_wantsStandstill() {
    const auto checker = checkerOf(kStopped);
    QVERIFY(checker->isGoalReached(query(0.1, 0.1, {0.15, 0.25, 0.2})));  // 0.25 m/s
    QVERIFY(!checker->isGoalReached(query(0.1, 0.1, {0.2, 0.0, 0.2})));
    QVERIFY(!checker->isGoalReached(query(0.1, 0.1, {0.0, -0.26})));
    QVERIFY(!checker->isGoalReached(query(0.1, 0.3)));
  }

  void position_headingDoesNotMatter() {
    const auto checker = checkerOf(kPosition);
    QVERIFY(!checker->isGoalReached(query(0.26, 0.0)));
    QVERIFY(checker->isGoalReached(query(0.24, 3.0)));
    QVERIFY(checker->isGoalReached(query(0.9, 3.0)));  // stateful
  }

  /// A path along y to (1, 2): 0.2 m across and 0.3 m along it.
  void axis_splitsTheOffset() {
    const Path path = {{Vec2(1.0, 0.0), 0.0}, {Vec2(1.0, 1.5), 0.0}, {Vec2(1.0, 2.0), 0.3}};
    const auto reaches = [&](const Nav2ParameterBlock& block, double across, double along,
                             double length) {
      const auto checker = checkerOf(kAxis, block, Distro::Main);
      return checker->isGoalReached(
          {{Vec2(1.0 + across, 2.0 + along), 2.0}, {Vec2(1.0, 2.0), 0.3}, {}, length, &path});
    };
    const Nav2ParameterBlock narrow = {{"cross_track_tolerance", 0.1},
                                       {"along_path_tolerance", 0.4}};
    QVERIFY(reaches(narrow, 0.05, -0.35, 0.4));
    QVERIFY(!reaches(narrow, 0.15, -0.35, 0.4));
    QVERIFY(!reaches(narrow, -0.15, -0.35, 0.4));
    QVERIFY(!reaches(narrow, 0.05, -0.45, 0.4));
    QVERIFY(!reaches(narrow, 0.05, 0.45, 0.4));
    QVERIFY(!reaches(narrow, 0.05, -0.35, 1.1));  // the path is longer than 1 m
    Nav2ParameterBlock beyond = narrow;
    beyond["is_overshoot_valid"] = true;
    QVERIFY(reaches(beyond, 0.05, 5.0, 0.4));
    QVERIFY(!reaches(beyond, 0.05, -0.45, 0.4));
    QVERIFY(!reaches(beyond, 0.15, 5.0, 0.4));
  }

  /// The last step of 5 cm turns aside. Main looks 0.15 m back, Lyrical at the last pose but one.
  void axis_direction_isThatOfThePathsEnd() {
    const Path path = {{Vec2(0.0, 2.0), 0.0}, {Vec2(1.0, 1.95), 0.0}, {Vec2(1.0, 2.0), 0.0}};
    const Nav2ParameterBlock narrow = {{"cross_track_tolerance", 0.1},
                                       {"along_path_tolerance", 0.4}};
    const GoalQuery ahead{{Vec2(0.7, 2.0), 0.0}, {Vec2(1.0, 2.0), 0.0}, {}, 0.3, &path};
    QVERIFY(checkerOf(kAxis, narrow, Distro::Main)->isGoalReached(ahead));
    QVERIFY(!checkerOf(kAxis, narrow, Distro::Lyrical)->isGoalReached(ahead));
    const GoalQuery bare{{Vec2(0.7, 2.0), 0.0}, {Vec2(1.0, 2.0), 0.0}, {}, 0.3, nullptr};
    QVERIFY(checkerOf(kAxis, narrow, Distro::Lyrical)->isGoalReached(bare));  // by the heading
  }

  void adaptive_standing_widensTheTolerance() {
    const Nav2ParameterBlock block = {{"required_stagnation_cycles", 3}};
    const auto checker = checkerOf(kAdaptive, block, Distro::Main);
    QVERIFY(checker->isGoalReached(query(0.09, 0.0, {0.3, 0.0})));  // within the fine one
    checker->reset();
    const BodyTwist moving{0.11, 0.0}, standing{0.09, 0.09};
    QVERIFY(!checker->isGoalReached(query(0.2, 0.0, standing)));
    QVERIFY(!checker->isGoalReached(query(0.2, 0.0, standing)));
    QVERIFY(!checker->isGoalReached(query(0.2, 0.0, moving)));  // begins anew
    QVERIFY(!checker->isGoalReached(query(0.2, 0.0, standing)));
    QVERIFY(!checker->isGoalReached(query(0.2, 0.0, standing)));
    QVERIFY(!checker->isGoalReached(query(0.2, 0.5, standing)));  // the heading is wrong
    QVERIFY(checker->isGoalReached(query(0.9, 0.0, moving)));     // the place is latched
    checker->reset();
    for (int i = 0; i < 10; ++i) {
      QVERIFY(!checker->isGoalReached(query(0.26, 0.0, standing)));
    }
    QVERIFY(!checker->isGoalReached(query(0.05, 0.0, standing, 1.1)));
  }

  void make_problems() {
    const auto unknown = makeGoalChecker("nav2_controller::SimpelGoalChecker", Distro::Humble, {});
    QVERIFY(!unknown);
    QCOMPARE(unknown.diagnostics()[0].code, std::string_view("nav2.unknown-plugin"));
    QCOMPARE(unknown.diagnostics()[0].value("nearest"), std::string(kSimple));
    QVERIFY(makeGoalChecker(kPosition, Distro::Humble, {}));
    const auto wrong = makeGoalChecker(
        kSimple, Distro::Humble, {{"xy_goal_tolerance", 1}, {"stateful", std::string("yes")}});
    QVERIFY(!wrong);
    QCOMPARE(wrong.diagnostics().size(), std::size_t{2});
    QCOMPARE(wrong.diagnostics()[0].code, std::string_view("nav2.wrong-type"));
    QVERIFY(!makeProgressChecker("nav2_controller::Progress", Distro::Main, {}));
  }

  void progress_simple_failsAfterAllowance() {
    const auto checker = *makeProgressChecker("nav2_controller::SimpleProgressChecker",
                                              Distro::Humble, {{"movement_time_allowance", 2.0}});
    QVERIFY(checker->check({Vec2(0.0, 0.0), 0.0}, 10.0));
    QVERIFY(checker->check({Vec2(0.5, 0.0), 3.0}, 12.0));   // within the circle, in time
    QVERIFY(checker->check({Vec2(0.51, 0.0), 0.0}, 12.5));  // out of it: the clock restarts
    QVERIFY(checker->check({Vec2(0.6, 0.0), 0.0}, 14.5));
    QVERIFY(!checker->check({Vec2(0.6, 0.0), 3.0}, 14.6));
    checker->reset();
    QVERIFY(checker->check({Vec2(0.6, 0.0), 0.0}, 30.0));
  }

  void progress_pose_turningCounts() {
    const auto checker = *makeProgressChecker("nav2_controller::PoseProgressChecker", Distro::Jazzy,
                                              {{"movement_time_allowance", 2.0}});
    QVERIFY(checker->check({Vec2(0.0, 0.0), 3.0}, 0.0));
    QVERIFY(checker->check({Vec2(0.0, 0.0), -2.7}, 3.0));  // turned by 0.58 over pi
    QVERIFY(!checker->check({Vec2(0.0, 0.0), -2.3}, 5.1));
  }
};

QTEST_APPLESS_MAIN(GoalCheckerTest)
#include "tst_GoalChecker.moc"
