#include <cmath>

#include <QtTest>

#include "sim2d/nav/nav2/control/PathHandler.h"
#include "tests/nav/ControlScene.h"

using namespace control_scene;
using base::Vec2;

namespace {

Pose2 at(double x, double y, double heading = 0.0) {
  return {Vec2(x, y), heading};
}

PathHandler handlerOf(PathPruning::Rule rule) {
  PathPruning pruning;
  pruning.rule = rule;
  return PathHandler(pruning);
}

/// 4 m along x, then 3 m along y.
const Path kCorner = {{{0, 0}, 0}, {{2, 0}, 0}, {{4, 0}, 0}, {{4, 3}, 0}};

}  // namespace

class PathHandlerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lengths_byHand() {
    const Path path = {at(0, 0), at(3, 4), at(3, 5), at(3, 5), at(2, 5)};
    QCOMPARE(pathLength(path), 7.0);
    QCOMPARE(pathLength({}), 0.0);
    QCOMPARE(firstAfterDistance(path, 0, 4.9), std::size_t{1});
    QCOMPARE(firstAfterDistance(path, 0, 5.0), std::size_t{2});  // more than, not as much
    QCOMPARE(firstAfterDistance(path, 1, 1.0), std::size_t{4});
    QCOMPARE(firstAfterDistance(path, 0, 7.0), std::size_t{5});
    QCOMPARE(firstAfterInversion(path), path.size());
    QCOMPARE(firstAfterInversion({at(0, 0), at(1, 0), at(0.5, 0.1)}), std::size_t{2});
    QCOMPARE(firstAfterInversion({at(0, 0), at(1, 0), at(1, 1)}), std::size_t{3});  // right angle
    QVERIFY(isNear(halfExtent(map_), 1.4875));  // (59 + 0.5) * 0.05 / 2
  }

  void pursuit_farPoses_areCut() {
    PathHandler handler = handlerOf(PathPruning::Rule::Pursuit);
    handler.setPlan(straight(3.0, 0.1));
    const LocalPlan local = handler.localPlan(at(0.52, 0.3), map_);
    QVERIFY(local.problem == nullptr);
    QVERIFY(isNear(local.poses.front().position.x(), 0.5));
    // hypot(x - 0.52, 0.3) <= 1.4875: x up to 1.977
    QVERIFY(isNear(local.poses.back().position.x(), 1.9));
    QVERIFY(isNear(handler.plan().front().position.x(), 0.5));  // what is passed is erased
    QVERIFY(isNear(handler.localPlan(at(0.2, 0.0), map_).poses.front().position.x(), 0.5));
  }

  /// A path that comes by again: only its first half map is looked at.
  void pursuit_loop_searchIsBounded() {
    Path path = straight(2.0, 0.1);
    for (int i = 0; i <= 20; ++i) {
      path.push_back(at(2.0 - 0.1 * i, 0.1));
    }
    PathHandler bounded = handlerOf(PathPruning::Rule::Pursuit);
    bounded.setPlan(path);
    QCOMPARE(bounded.localPlan(at(0.0, 0.1), map_).poses.front(), path.front());
    PathPruning everywhere;
    everywhere.rule = PathPruning::Rule::Pursuit;
    everywhere.searchDistance = -1.0;
    PathHandler all(everywhere);
    all.setPlan(path);
    QCOMPARE(all.localPlan(at(0.0, 0.1), map_).poses.size(), std::size_t{1});  // the very last
    everywhere.searchDistance = 0.35;
    PathHandler little(everywhere);
    little.setPlan(path);
    QVERIFY(isNear(little.localPlan(at(1.0, 0.0), map_).poses.front().position.x(), 0.3));
  }

  void pursuit_atTheEnd_twoPosesSinceJazzy() {
    PathPruning pruning;
    pruning.rule = PathPruning::Rule::Pursuit;
    PathHandler humble(pruning);
    humble.setPlan(straight(0.5, 0.1));
    QCOMPARE(humble.localPlan(at(0.5, 0.0), map_).poses.size(), std::size_t{1});
    pruning.keepsLastTwo = true;
    PathHandler jazzy(pruning);
    jazzy.setPlan(straight(0.5, 0.1));
    QCOMPARE(jazzy.localPlan(at(0.5, 0.0), map_).poses.size(), std::size_t{2});
    QCOMPARE(jazzy.localPlan(at(0.5, 0.0), map_).poses.size(), std::size_t{2});
  }

  void dwb_beginsNear_endsByDistance() {
    PathPruning pruning;
    pruning.rule = PathPruning::Rule::Dwb;
    pruning.pruneDistance = 0.25;
    pruning.forwardPruneDistance = 1.0;
    PathHandler handler(pruning);
    handler.setPlan(straight(3.0, 0.1));
    LocalPlan local = handler.localPlan(at(0.52, 0.0), map_);
    QVERIFY(isNear(local.poses.front().position.x(), 0.3));  // the first nearer than 0.25
    QVERIFY(isNear(local.poses.back().position.x(), 1.5));   // the last not farther than 1
    QVERIFY(isNear(handler.plan().front().position.x(), 0.3));
    pruning.prunesPlan = false;  // then half the map counts: 60 * 0.05 / 2
    pruning.shortensPlan = false;
    PathHandler whole(pruning);
    whole.setPlan(straight(3.0, 0.1));
    local = whole.localPlan(at(0.52, 0.0), map_);
    QVERIFY(isNear(local.poses.front().position.x(), 0.0));
    QVERIFY(isNear(local.poses.back().position.x(), 2.0));
    QVERIFY(isNear(whole.plan().front().position.x(), 0.0));
    // Farther on than forward_prune_distance of way nothing is looked for.
    pruning.prunesPlan = true;
    PathHandler behind(pruning);
    behind.setPlan(straight(3.0, 0.1));
    local = behind.localPlan(at(2.0, 0.0), map_);
    QVERIFY(isNear(local.poses.front().position.x(), 1.1));
  }

  void way_endsByLengthOrMap() {
    PathPruning pruning;
    pruning.pruneDistance = 0.55;
    PathHandler handler(pruning);
    Path path = straight(0.5, 0.1);
    path.push_back(at(0.5, 0.1));
    path.push_back(at(0.4, 0.1));
    handler.setPlan(path);
    QVERIFY((handler.localPlan(at(0, 0), map_).poses.back().position - Vec2(0.5, 0.0)).norm() <
            1e-9);
    pruning.pruneDistance = 5.0;
    PathHandler far(pruning);
    far.setPlan(straight(3.0, 0.1));
    QVERIFY(isNear(far.localPlan(at(0.12, 0), map_).poses.back().position.x(),
                   1.4));  // map ends at 1.5
    QVERIFY(isNear(far.plan().front().position.x(), 0.1));
  }

  void way_inversion_isHeldUntilReached() {
    PathPruning pruning;
    pruning.enforcesInversion = true;
    PathHandler handler(pruning);
    Path path = straight(0.8, 0.1);
    const std::size_t ahead = path.size();
    for (int i = 1; i <= 6; ++i) {
      path.push_back(at(0.8 - 0.1 * i, 0.0));
    }
    handler.setPlan(path);
    QCOMPARE(handler.localPlan(at(0, 0), map_).poses.size(), ahead);
    QCOMPARE(handler.localPlan(at(0.75, 0, 0.5), map_).poses.back().position.x(),
             0.8);  // askew: 0.4
    QCOMPARE(handler.localPlan(at(0.65, 0, 0.1), map_).poses.back().position.x(),
             0.8);  // reached now
    const LocalPlan back = handler.localPlan(at(0.79, 0, 0.1), map_);
    QVERIFY(isNear(back.poses.back().position.x(), 0.2));
    QVERIFY(isNear(back.poses.front().position.x(), 0.7));
  }

  void way_rotation_isHeldUntilMade() {
    PathPruning pruning;
    pruning.enforcesRotation = true;
    PathHandler handler(pruning);
    Path path = straight(0.5, 0.1);
    path.push_back(at(0.5, 0.0, 0.5));
    path.push_back(at(0.5, 0.0, 1.0));  // 1 rad on the spot
    for (int i = 1; i <= 5; ++i) {
      path.push_back(at(0.5, 0.1 * i, 1.57));
    }
    handler.setPlan(path);
    QCOMPARE(handler.localPlan(at(0, 0), map_).poses.back(), at(0.5, 0.0, 1.0));
    handler.localPlan(at(0.45, 0.0, 0.5), map_);  // not turned yet
    QCOMPARE(handler.localPlan(at(0.45, 0.0, 0.9), map_).poses.back(), at(0.5, 0.0, 1.0));
    QVERIFY(isNear(handler.localPlan(at(0.45, 0.0, 0.9), map_).poses.back().position.y(), 0.5));
    pruning.minimumRotation = 1.1;
    PathHandler little(pruning);
    little.setPlan(path);
    QVERIFY(isNear(little.localPlan(at(0, 0), map_).poses.back().position.y(), 0.5));
  }

  /// The plan's frame lies at (0, 1) of the costmap's and is turned to the left by a right angle:
  /// the pose (x, 0) of the plan is (0, 1 + x) there. The robot, at (0.1, 0.52), is at (-0.48,
  /// -0.1) of the plan.
  void planFrame_turnedAndMoved_isThatOfTheResult_data() {
    QTest::addColumn<int>("rule");
    QTest::newRow("pursuit") << static_cast<int>(PathPruning::Rule::Pursuit);
    QTest::newRow("dwb") << static_cast<int>(PathPruning::Rule::Dwb);
    QTest::newRow("way") << static_cast<int>(PathPruning::Rule::AlongPath);
  }

  void planFrame_turnedAndMoved_isThatOfTheResult() {
    QFETCH(int, rule);
    PathHandler handler = handlerOf(static_cast<PathPruning::Rule>(rule));
    Path path;
    for (int i = -10; i <= 20; ++i) {
      path.push_back(at(0.1 * i, 0.0));
    }
    handler.setPlan(path);
    const Pose2 planFrame{Vec2(0.0, 1.0), base::kPi / 2.0};
    const LocalPlan local = handler.localPlan(at(0.1, 0.52), map_, planFrame);
    QVERIFY(local.problem == nullptr);
    for (const Pose2& pose : local.poses) {
      QVERIFY(isNear(pose.position.x(), 0.0) && isNear(pose.heading, base::kPi / 2.0));
    }
    // Dwb begins with the first pose within half the map (1.5 m), the others with the nearest one.
    const bool isDwb = rule == static_cast<int>(PathPruning::Rule::Dwb);
    QVERIFY(isNear(local.poses.front().position.y(), isDwb ? 0.0 : 0.5));
    // Way ends with the map at y = 1.5; the others by the distance: hypot(x + 0.48, 0.1) is at most
    // 1.4875 or 1.5 up to x = 1.004 and 1.016.
    const bool isWay = rule == static_cast<int>(PathPruning::Rule::AlongPath);
    QVERIFY2(isNear(local.poses.back().position.y(), isWay ? 1.4 : 2.0),
             qPrintable(QString::number(local.poses.back().position.y())));
  }

  void problems_inNav2sWords() {
    PathPruning pruning;
    pruning.rejectsUnitPath = true;
    PathHandler handler(pruning);
    QCOMPARE(handler.localPlan(at(0, 0), map_).problem, "Received plan with zero length");
    handler.setPlan({at(0, 0)});
    QCOMPARE(handler.localPlan(at(0, 0), map_).problem, "Received plan with length of one");
    handler.setPlan(straight(1.0));
    QCOMPARE(handler.localPlan(at(0, 0), Costmap(4, 4, 0.05, Vec2(9.0, 9.0))).problem,
             "Resulting plan has 0 poses in it.");
  }

  // How far a robot is off its path, by hand.
  void besideThePath_hasASide() {
    const TrackingFeedback left = trackingError(kCorner, {{1.0, 0.5}, 0.0}, 0, -1.0);
    QVERIFY(isNear(left.positionError, 0.5));
    QCOMPARE(left.index, std::size_t{0});
    QVERIFY(isNear(left.remaining, 6.0));
    QVERIFY(isNear(left.distanceToGoal, std::hypot(3.0, 2.5)));
    QVERIFY(isNear(trackingError(kCorner, {{1.0, -0.5}, 0.0}, 0, -1.0).positionError, -0.5));
    // East of the second leg, which leads north, is its right.
    const TrackingFeedback right = trackingError(kCorner, {{4.25, 2.0}, 0.0}, 0, -1.0);
    QVERIFY(isNear(right.positionError, -0.25));
    QCOMPARE(right.index, std::size_t{2});
    QVERIFY(isNear(right.remaining, 1.0));
  }

  void heading_isOfTheSegment() {
    QVERIFY(isNear(trackingError(kCorner, {{1.0, 0.1}, 0.3}, 0, -1.0).headingError, -0.3));
    QVERIFY(isNear(trackingError(kCorner, {{4.1, 2.0}, 0.3}, 0, -1.0).headingError,
                   0.5 * base::kPi - 0.3));
    const Path still = {{{1, 1}, 0.7}, {{1, 1}, 0.7}};
    QVERIFY(isNear(trackingError(still, {{0, 1}, 0.2}, 0, -1.0).headingError, 0.5));
  }

  void window_endsTheSearch() {
    const Pose2 robot{{4.0, 2.0}, 0.0};  // on the second leg
    QVERIFY(isNear(trackingError(kCorner, robot, 0, -1.0).positionError, 0.0));
    const TrackingFeedback near = trackingError(kCorner, robot, 0, 3.0);  // up to the corner
    QCOMPARE(near.index, std::size_t{1});
    QVERIFY(isNear(near.positionError, 2.0));
    QCOMPARE(trackingError(kCorner, {{0.0, 0.0}, 0.0}, 1, -1.0).index, std::size_t{1});
  }

  void shortPaths_haveAnAnswer() {
    QVERIFY(isNear(trackingError({}, {{1, 2}, 0.5}, 0, 2.0).positionError, 0.0));
    const TrackingFeedback one = trackingError({{{3, 4}, 1.0}}, {{0, 0}, 0.5}, 0, 2.0);
    QVERIFY(isNear(one.positionError, 5.0) && isNear(one.headingError, 0.5));
    QVERIFY(isNear(one.remaining, 0.0));
  }

 private:
  const Costmap map_{60, 60, 0.05, Vec2(-1.5, -1.5)};
};

QTEST_APPLESS_MAIN(PathHandlerTest)
#include "tst_PathHandler.moc"
