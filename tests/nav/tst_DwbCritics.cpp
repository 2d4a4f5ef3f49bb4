#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"
#include "tests/nav/ControlScene.h"
#include "tests/nav/DwbJudge.h"

using namespace control_scene;
using base::Vec2;
using dwb_judge::Judge;
using sim2d::BodyTwist;
using sim2d::Cell;

namespace {

Pose2 at(double x, double y, double heading = 0.0) {
  return {Vec2(x, y), heading};
}

/// Along the x axis, off the borders of cells.
Path row(double length) {
  Path path = straight(length);
  for (Pose2& pose : path) {
    pose.position += Vec2(0.02, 0.02);
  }
  return path;
}

std::string rejection(const DwbScore& score) {
  return score.rejection == nullptr ? std::string() : std::string(score.rejection);
}

DwbCriticParameters with(double DwbCriticParameters::*member, double value) {
  DwbCriticParameters parameters;
  parameters.*member = value;
  return parameters;
}

}  // namespace

class DwbCriticsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void names_asNav2LooksForThem();
  void baseObstacle_vectors();
  void baseObstacle_sum_countsEachPose();
  void obstacleFootprint_edgesCount();
  void pathDist_cellsToPath();
  void pathDist_aggregations();
  void pathDist_noPathOnMap_isUnreachable();
  void goalDist_cellsToEndOfPath();
  void pathAlign_pointAhead_andScaleNearGoal();
  void goalAlign_endIsPushedOn();
  void align_onlyTheLastPoseCounts();
  void rotateToGoal_outside_isFree();
  void rotateToGoal_moving_mustSlowDown();
  void rotateToGoal_stopped_turnsOnly();
  void rotateToGoal_latchesUntilNewPath();
  void rotateToGoal_main_longPathIsNoWindow();
  void rotateToGoal_lookaheadTime_takesItsHeading();
  void oscillation_flip_forbidsOldSign();
  void oscillation_turnsAreNotedWhenSlow();
  void oscillation_getsOn_isForgotten();
  void preferForward_vectors();
  void twirling_vectors();
  void forwardPoint_vectors();
  void scales_ofResolution();
};

void DwbCriticsTest::names_asNav2LooksForThem() {
  const std::vector<std::string> spaces = {"dwb_critics"};
  for (const char* name :
       {"PathDist", "PathDistCritic", "dwb_critics::PathDist", "dwb_critics/PathDistCritic"}) {
    const DwbCriticType* type = dwbCriticType(name, spaces);
    QVERIFY2(type != nullptr, name);
    QCOMPARE(std::string(type->plugin), std::string("dwb_critics::PathDistCritic"));
  }
  QVERIFY(dwbCriticType("PathDist", {"mine"}) == nullptr);
  QVERIFY(dwbCriticType("PathDis", spaces) == nullptr);
  QCOMPARE(dwbCriticTypes().size(), std::size_t{10});
}

void DwbCriticsTest::baseObstacle_vectors() {  // 37
  Judge judge("BaseObstacle");
  judge.scene.block(0.5, 0.0, 0.55, 0.05, 254);
  judge.scene.block(0.6, 0.0, 0.65, 0.05, 255);
  judge.scene.block(0.7, 0.0, 0.75, 0.05, 128);
  judge.scene.block(0.8, 0.0, 0.85, 0.05, 253);
  judge.scene.block(0.9, 0.0, 0.95, 0.05, 252);
  judge.prepare(row(1.0));
  QCOMPARE(rejection(judge.score({at(0.52, 0.02)})), std::string("Trajectory Hits Obstacle."));
  QCOMPARE(rejection(judge.score({at(0.62, 0.02)})), std::string("Trajectory Hits Obstacle."));
  QCOMPARE(judge.score({at(0.72, 0.02)}).raw, 128.0);
  QCOMPARE(rejection(judge.score({at(0.82, 0.02)})), std::string("Trajectory Hits Obstacle."));
  QCOMPARE(judge.score({at(0.92, 0.02)}).raw, 252.0);
  QCOMPARE(rejection(judge.score({at(1.6, 0.02)})), std::string("Trajectory Goes Off Grid."));
  QCOMPARE(judge.score({at(0.72, 0.02), at(0.2, 0.0)}).raw, 0.0);  // of the last
  QCOMPARE(rejection(judge.score({at(0.52, 0.02), at(0.2, 0.0)})),
           std::string("Trajectory Hits Obstacle."));
  QCOMPARE(rejection(judge.score({at(0.52, 0.02), at(1.6, 0.0)})),
           std::string("Trajectory Hits Obstacle."));  // whichever comes first
  QCOMPARE(rejection(judge.score({at(1.6, 0.02), at(0.52, 0.02)})),
           std::string("Trajectory Goes Off Grid."));
}

void DwbCriticsTest::baseObstacle_sum_countsEachPose() {
  DwbCriticParameters parameters;
  parameters.sumsScores = true;
  Judge judge("BaseObstacle", parameters);
  judge.scene.block(0.5, 0.0, 0.55, 0.05, 100);
  judge.prepare(row(1.0));
  QCOMPARE(judge.score({at(0.52, 0.02), at(0.53, 0.03), at(0.2, 0.0)}).raw, 200.0);
}

void DwbCriticsTest::obstacleFootprint_edgesCount() {
  Judge judge("ObstacleFootprint");
  judge.scene.shape.vertices = {{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}};
  judge.scene.block(0.4, 0.0, 0.45, 0.05, 253);
  judge.scene.block(-0.45, 0.0, -0.4, 0.05, 254);
  judge.scene.block(0.0, 0.4, 0.05, 0.45, 255);
  judge.scene.block(0.0, -0.1, 0.05, -0.05, 77);
  judge.prepare(row(1.0));
  QCOMPARE(judge.score({at(0.22, 0.0)}).raw, 253.0);  // an edge may
  QCOMPARE(judge.score({at(0.42, 0.0)}).raw, 0.0);    // inside nobody looks
  QCOMPARE(rejection(judge.score({at(-0.22, 0.0)})), std::string("Trajectory Hits Obstacle."));
  QCOMPARE(rejection(judge.score({at(0.0, 0.32)})), std::string("Trajectory Hits Unknown Region."));
  QCOMPARE(judge.score({at(0.0, 0.32, base::kPi / 2.0)}).raw, 0.0);  // turned it reaches beyond
  QCOMPARE(judge.score({at(0.0, 0.01)}).raw, 77.0);
  QCOMPARE(rejection(judge.score({at(1.4, 0.0)})), std::string("Footprint Goes Off Grid."));
  QCOMPARE(rejection(judge.score({at(1.6, 0.0)})), std::string("Trajectory Goes Off Grid."));
}

/// The path runs in the row of y = 0: 0.32 m to its left are 6 cells.
void DwbCriticsTest::pathDist_cellsToPath() {
  Judge judge("PathDist");
  judge.scene.block(0.5, 0.1, 0.6, 0.2);  // obstacles are no hindrance for the grid
  judge.prepare(row(1.0));
  QCOMPARE(judge.score({at(0.5, 0.02)}).raw, 0.0);
  QCOMPARE(judge.score({at(0.5, 0.02), at(0.52, 0.32)}).raw, 6.0);
  QCOMPARE(judge.score({at(1.22, 0.12)}).raw, 4.0 + 2.0);  // beyond the end at 1.0, steps add up
  QCOMPARE(rejection(judge.score({at(0.5, 0.0), at(0.5, 1.6), at(0.5, 0.0)})),
           std::string("Trajectory Goes Off Grid."));
}

void DwbCriticsTest::pathDist_aggregations() {
  const std::vector<Pose2> poses = {at(0.5, 0.12), at(0.5, 0.17), at(0.5, 0.22)};  // 2, 3, 4 cells
  for (const auto& [way, raw] : {std::pair{"last", 4.0}, {"sum", 9.0}, {"product", 24.0}}) {
    DwbCriticParameters parameters;
    parameters.aggregation = way;
    Judge judge("PathDist", parameters);
    judge.prepare(row(1.0));
    QCOMPARE(judge.score(poses).raw, raw);
  }
}

void DwbCriticsTest::pathDist_noPathOnMap_isUnreachable() {
  for (const char* name : {"PathDist", "GoalDist"}) {
    Judge judge(name);
    judge.prepare({at(8.0, 0.0), at(9.0, 0.0)});
    QCOMPARE(rejection(judge.score({at(0.0, 0.0)})),
             std::string("Trajectory Hits Unreachable Area."));
    QCOMPARE(rejection(judge.score({at(5.0, 0.0)})), std::string("Trajectory Goes Off Grid."));
  }
  Judge align("PathAlign");
  align.prepare({at(8.0, 0.0), at(9.0, 0.0)});
  QCOMPARE(align.score({at(0.0, 0.0)}).raw, 3601.0);  // size of the grid + 1, no refusal
}

void DwbCriticsTest::goalDist_cellsToEndOfPath() {
  Judge judge("GoalDist");
  judge.prepare(row(1.0));
  QCOMPARE(judge.score({at(0.02, 0.02)}).raw, 20.0);
  QCOMPARE(judge.score({at(0.52, -0.22)}).raw, 10.0 + 5.0);
  judge.prepare(row(4.0));  // the last cell on the map is that of 1.45
  QCOMPARE(judge.score({at(0.02, 0.02)}).raw, 29.0);
}

void DwbCriticsTest::pathAlign_pointAhead_andScaleNearGoal() {
  Judge judge("PathAlign", with(&DwbCriticParameters::forwardPointDistance, 0.3));
  judge.prepare(row(1.0));
  QCOMPARE(judge.score({at(0.52, 0.02)}).raw, 0.0);
  QCOMPARE(judge.score({at(0.52, 0.02, base::kPi / 2.0)}).raw, 6.0);  // 0.32
  QCOMPARE(rejection(judge.score({at(1.4, 0.0)})), std::string("Trajectory Goes Off Grid."));
  QVERIFY(judge.critic().scale(0.05) > 0.0);
  judge.prepare(row(1.0), at(0.3, 0.0));
  QCOMPARE(judge.critic().scale(0.05), 0.0);  // as near as that
  judge.prepare(row(1.0), at(0.31, 0.0));
  QVERIFY(judge.critic().scale(0.05) > 0.0);
}

/// From the robot at the origin to the goal at (0.5, 0.5): 0.3 m on is (0.712, 0.712), cell 14 from
/// that of the origin in both directions.
void DwbCriticsTest::goalAlign_endIsPushedOn() {
  Judge judge("GoalAlign", with(&DwbCriticParameters::forwardPointDistance, 0.3));
  judge.prepare({at(0.02, 0.02), at(0.25, 0.25), at(0.5, 0.5)});
  QCOMPARE(judge.score({at(0.02, 0.02)}).raw, 8.0 + 14.0);  // the point ahead: (0.32, 0.02)
  QCOMPARE(judge.score({at(0.42, 0.72)}).raw, 0.0);
}

void DwbCriticsTest::align_onlyTheLastPoseCounts() {
  for (const char* name : {"PathAlign", "GoalAlign"}) {
    Judge judge(name);
    judge.prepare(row(1.0));
    QVERIFY(judge.score({at(1.45, 0.0), at(3.0, 0.0), at(0.5, 0.0)}).rejection == nullptr);
  }
}

void DwbCriticsTest::rotateToGoal_outside_isFree() {
  Judge judge("RotateToGoal");
  judge.prepare(row(1.0), at(0.26, 0.0, 1.0));
  QCOMPARE(judge.priceOf({0.3, 1.0}).raw, 0.0);
}

/// At 0.5 m/s in the window: slower, squared times 5, and the turn that is left.
void DwbCriticsTest::rotateToGoal_moving_mustSlowDown() {
  Judge judge("RotateToGoal");
  judge.scene.speed = {0.3, 0.0, 0.4};
  judge.prepare(row(1.0), at(0.2, 0.0, 1.0));
  QCOMPARE(rejection(judge.priceOf({0.5, 0.0})), std::string("Not slowing down near goal."));
  QVERIFY(isNear(judge.score({at(0, 0), at(0, 0, 0.25)}, {0.3, 0.1}).raw, 0.09 * 5.0 + 0.75));
}

void DwbCriticsTest::rotateToGoal_stopped_turnsOnly() {
  Judge judge("RotateToGoal");
  judge.scene.speed = {0.25, 0.0};  // counts as standing
  judge.prepare(row(1.0), at(0.2, 0.0, -3.0));
  QCOMPARE(rejection(judge.priceOf({0.1, 0.5})), std::string("Nonrotation command near goal."));
  QCOMPARE(rejection(judge.priceOf({0.0, 0.5, 0.1})),
           std::string("Nonrotation command near goal."));
  QVERIFY(isNear(judge.score({at(0, 0, 3.0)}, {0.0, 0.5}).raw, 2.0 * base::kPi - 6.0));
}

void DwbCriticsTest::rotateToGoal_latchesUntilNewPath() {
  Judge judge("RotateToGoal");
  judge.prepare(row(1.0), at(0.2, 0.0, 1.0));
  judge.scene.speed = {0.5, 0.0};
  judge.prepare(row(1.0), at(0.9, 0.0, 1.0));  // pushed away: still only turning
  QCOMPARE(rejection(judge.priceOf({0.1, 0.0})), std::string("Nonrotation command near goal."));
  judge.critic().reset();
  judge.prepare(row(1.0), at(0.9, 0.0, 1.0));
  QCOMPARE(judge.priceOf({0.1, 0.0}).raw, 0.0);
}

void DwbCriticsTest::rotateToGoal_main_longPathIsNoWindow() {
  for (const Distro distro : {Distro::Jazzy, Distro::Main}) {
    Judge judge("RotateToGoal", {}, distro);
    judge.prepare(row(1.1), at(0.2, 0.0, 1.0));
    QCOMPARE(judge.priceOf({0.1, 0.0}).rejection == nullptr, distro == Distro::Main);
    judge.prepare(row(0.9), at(0.2, 0.0, 1.0));
    QVERIFY(judge.priceOf({0.1, 0.0}).rejection != nullptr);
  }
}

void DwbCriticsTest::rotateToGoal_lookaheadTime_takesItsHeading() {
  Judge judge("RotateToGoal", with(&DwbCriticParameters::lookaheadTime, 0.15));
  judge.prepare(row(1.0), at(0.2, 0.0, 1.0));
  // Steps of 0.1 s: half way between 0.2 and 0.4 rad
  const std::vector<Pose2> poses = {at(0, 0, 0.0), at(0, 0, 0.2), at(0, 0, 0.4), at(0, 0, 0.6)};
  QVERIFY(isNear(judge.score(poses, {0.0, 2.0}).raw, 0.7));
}

void DwbCriticsTest::oscillation_flip_forbidsOldSign() {
  Judge judge("Oscillation");
  const auto chose = [&judge](const BodyTwist& twist) {
    judge.prepare(row(1.0));
    judge.critic().debrief(twist);
  };
  chose({0.2, 0.0});
  QCOMPARE(judge.priceOf({-0.1, 0.0}).raw, 0.0);  // nothing forbidden yet
  chose({0.0, 0.0});                              // 0 is no sign
  chose({-0.1, 0.0});
  QCOMPARE(rejection(judge.priceOf({0.1, 0.0})), std::string("Trajectory is oscillating."));
  QVERIFY(judge.priceOf({-0.1, 0.0}).rejection == nullptr);
  QVERIFY(judge.priceOf({0.0, 0.5}).rejection == nullptr);
  judge.critic().reset();
  QVERIFY(judge.priceOf({0.1, 0.0}).rejection == nullptr);
}

void DwbCriticsTest::oscillation_turnsAreNotedWhenSlow() {
  Judge judge("Oscillation");
  judge.prepare(row(1.0));
  judge.critic().debrief({0.2, 1.0});  // too fast ahead: not noted
  judge.critic().debrief({0.2, -1.0});
  QVERIFY(judge.priceOf({0.2, 1.0}).rejection == nullptr);
  judge.critic().debrief({0.05, 1.0, 0.1});
  judge.critic().debrief({0.05, -1.0, 0.1});
  QVERIFY(judge.priceOf({0.2, 1.0}).rejection != nullptr);  // tested at any speed
  QVERIFY(judge.priceOf({0.2, -1.0}).rejection == nullptr);
  judge.critic().debrief({0.05, -1.0, -0.1});
  QVERIFY(judge.priceOf({0.2, -1.0, 0.1}).rejection != nullptr);
}

void DwbCriticsTest::oscillation_getsOn_isForgotten() {
  DwbCriticParameters parameters;
  parameters.resetTime = 2.0;
  Judge judge("Oscillation", parameters);
  const auto flip = [&judge](double time) {
    judge.critic().reset();
    judge.scene.robot = Pose2();
    judge.scene.time = time;
    judge.prepare(row(1.0));
    judge.critic().debrief({0.2, 0.0});
    judge.critic().debrief({-0.2, 0.0});
  };
  const auto forbidsAfter = [&judge](const Pose2& robot, double time) {
    judge.scene.robot = robot;
    judge.scene.time = time;
    judge.prepare(row(1.0));
    judge.critic().debrief({-0.2, 0.0});
    return judge.priceOf({0.2, 0.0}).rejection != nullptr;
  };
  flip(10.0);
  QVERIFY(forbidsAfter(at(0.04, 0.0, 0.19), 12.0));
  QVERIFY(!forbidsAfter(at(0.06, 0.0), 10.1));  // moved
  flip(20.0);
  QVERIFY(!forbidsAfter(at(0.0, 0.0, 0.21), 20.1));  // turned
  flip(30.0);
  QVERIFY(!forbidsAfter(at(0.0, 0.0), 32.1));  // waited
}

void DwbCriticsTest::preferForward_vectors() {  // 33, 34
  Judge judge("PreferForward");
  QCOMPARE(judge.priceOf({-1.0, 0.0}).raw, 1.0);
  QCOMPARE(judge.priceOf({-1e-5, 0.0}).raw, 1.0);
  QCOMPARE(judge.priceOf({0.05, -0.1}).raw, 1.0);
  QCOMPARE(judge.priceOf({0.0999999, 0.19}).raw, 1.0);
  QCOMPARE(judge.priceOf({0.2, 0.1}).raw, 1.0);
  QCOMPARE(judge.priceOf({0.2, -0.1}).raw, 1.0);
  QCOMPARE(judge.priceOf({0.2, 0.2}).raw, 2.0);
  QCOMPARE(judge.priceOf({0.2, 1.5}).raw, 15.0);
  QCOMPARE(judge.priceOf({0.05, 0.3}).raw, 3.0);  // turns: no creeping
}

void DwbCriticsTest::twirling_vectors() {  // 35
  Judge judge("Twirling");
  QCOMPARE(judge.priceOf({0.3, 1.0}).raw, 1.0);
  QCOMPARE(judge.priceOf({0.3, -1.0}).raw, 1.0);
  QCOMPARE(judge.critic().scale(0.05), 1.0);  // not 0, as a comment in Nav2 has it
}

void DwbCriticsTest::forwardPoint_vectors() {  // 36
  QVERIFY((at(1.0, -1.0).ahead(1.0) - Vec2(2.0, -1.0)).norm() < 1e-9);
  QVERIFY((at(2.0, -10.0, 0.54).ahead(1.0) - Vec2(2.8577, -9.4858)).norm() < 1e-4);
}

void DwbCriticsTest::scales_ofResolution() {
  const auto scaleOf = [](const char* name) {
    Judge judge(name, with(&DwbCriticParameters::scale, 8.0));
    return judge.critic().scale(0.05);
  };
  for (const char* name : {"PathDist", "GoalDist", "PathAlign", "GoalAlign"}) {
    QVERIFY(isNear(scaleOf(name), 0.2));
  }
  QVERIFY(isNear(scaleOf("ObstacleFootprint"), 0.4));
  for (const char* name :
       {"BaseObstacle", "RotateToGoal", "Oscillation", "PreferForward", "Twirling"}) {
    QCOMPARE(scaleOf(name), 8.0);
  }
}

QTEST_APPLESS_MAIN(DwbCriticsTest)
#include "tst_DwbCritics.moc"
