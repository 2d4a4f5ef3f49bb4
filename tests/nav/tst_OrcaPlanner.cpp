#include <cmath>

#include <QtTest>

#include "sim2d/nav/ReciprocalVelocity.h"
#include "tests/nav/PlannerFunctions.h"
#include "tests/nav/PlannerTrials.h"

using namespace sim2d;

namespace {

bool isNear(const Vec2& a, const Vec2& b, double tolerance = 1e-9) {
  return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

/// Two omnidirectional robots of the example "Circle" of RVO2 (radius 1.5 m, horizon 10 s), 10 m
/// from each other and with 1 m/s; what limits their drives does not count.
RobotBody circleBody() {
  RobotBody body = driven::bodyOf(Kinematics::Omnidirectional);
  body.footprint.radius = 1.5;
  body.limits.maxAcc = 1000.0;
  return body;
}

Vec2 velocityOfPair(double side, double share) {
  const driven::Place open;
  const RobotBody body = circleBody();
  const double heading = side > 0.0 ? base::kPi : 0.0;
  driven::Robot robot(open, body, {Vec2(5.0 * side, 0.0), heading}, Vec2(-50.0 * side, 0.0));
  robot.seen().motion.linear = 1.0;
  TrackedBody other = driven::person(2, Vec2(-5.0 * side, 0.0), Vec2(side, 0.0));
  other.kind = BodyKind::Robot;
  other.radius = 1.5;
  robot.seen().bodies = {other};
  const std::shared_ptr<Planner> planner = drive::planner(addOrcaPlanner, body,
                                                          {{"horizon", 10.0},
                                                           {"range", 15.0},
                                                           {"margin", 0.0},
                                                           {"side_preference", 0.0},
                                                           {"robot_share", share}});
  const BodyTwist twist = *planner->command(robot.seen());
  return Vec2(twist.linear, twist.lateral) * (side > 0.0 ? -1.0 : 1.0);  // in world frame
}

}  // namespace

class OrcaPlannerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Reach 3 m of 10 m: the legs of the cone have the sine 0.3; relative velocity 2 m/s along its
  /// axis lies 0.6 m/s from the right leg, of which each takes half.
  void planes_pairOfTheCircle_byHand() {
    const Walker first(1, Vec2(-5.0, 0.0), Vec2(1.0, 0.0), 1.5);
    const Walker second(2, Vec2(5.0, 0.0), Vec2(-1.0, 0.0), 1.5);
    const double cosine = std::sqrt(0.91);
    const HalfPlane plane = bodyHalfPlane(first, second, 10.0, 0.25);
    QVERIFY(isNear(plane.point, Vec2(1.0 - 0.3 * 0.3, -0.3 * cosine)));
    QVERIFY(isNear(plane.direction, Vec2(-cosine, 0.3)));
    const HalfPlane mirrored = bodyHalfPlane(second, first, 10.0, 0.25);
    QVERIFY(isNear(mirrored.point, -plane.point) && isNear(mirrored.direction, -plane.direction));
  }

  void command_pairOfTheCircle_partsSymmetrically() {
    const Vec2 first = velocityOfPair(-1.0, 0.5);
    QVERIFY(isNear(first, Vec2(0.91, -0.3 * std::sqrt(0.91))));
    QVERIFY(isNear(velocityOfPair(1.0, 0.5), -first));
    // The two miss each other barely.
    const Vec2 relative = 2.0 * first;
    const Vec2 apart(10.0, 0.0);
    const Vec2 closest = apart - apart.dot(relative) / relative.squaredNorm() * relative;
    QVERIFY(std::fabs(closest.norm() - 3.0) < 1e-9);
  }

  void command_pair_robotTakesAll() {
    const double sine = 0.3;
    const Vec2 change = 2.0 * sine * Vec2(-sine, -std::sqrt(0.91));
    const Vec2 expected = Vec2(1.0, 0.0) + change;
    QVERIFY(expected.norm() <= 1.0 + 1e-9);  // as fast as it can
    QVERIFY(isNear(velocityOfPair(-1.0, 1.0), expected));
  }
  void drive_trials_data() { trials::addRows(); }

  void drive_trials() {
    QFETCH(int, kinematics);
    QFETCH(int, trial);
    const trials::Drive drive =
        trials::driveTrial(addOrcaPlanner, static_cast<Kinematics>(kinematics), trial);
    trials::check(drive, trials::allTrials()[static_cast<std::size_t>(trial)].mostTurns);
  }

  void drive_personComesFromAllSides_neverDrivesIntoIt_data() { trials::addKinematics(); }

  /// All cross the robot's way 3 s after the start, at different places.
  void drive_personComesFromAllSides_neverDrivesIntoIt() {
    QFETCH(int, kinematics);
    const driven::Place open;
    const RobotBody body = driven::bodyOf(static_cast<Kinematics>(kinematics));
    for (int i = 0; i < 24; ++i) {
      const double angle = 2.0 * base::kPi / 24.0 * i;
      const double speed = 0.4 + 0.1 * (i % 12);
      const Vec2 velocity = speed * base::directionOf(base::wrapToPi(angle));
      const Vec2 meeting(-2.8 + 0.1 * (i % 7), 0.05 * (i % 5));
      driven::Robot robot(open, body, {Vec2(-5.0, 0.0), 0.0}, Vec2(5.0, 0.0));
      robot.seen().bodies = {driven::person(1, meeting - 3.0 * velocity, velocity)};
      const std::shared_ptr<Planner> planner = drive::planner(addOrcaPlanner, body);
      const driven::Drive drive = robot.driveFor(*planner, 40.0);
      QVERIFY2(!drive.droveInto, qPrintable(QStringLiteral("%1: %2").arg(i).arg(drive.leastGap)));
      QVERIFY2(drive.hasArrived, qPrintable(QString::number(i)));
    }
  }

  void drive_twoRobotsHeadOn_passEachOther_data() { trials::addKinematics(); }

  void drive_twoRobotsHeadOn_passEachOther() {
    QFETCH(int, kinematics);
    const driven::Place open;
    const RobotBody body = driven::bodyOf(static_cast<Kinematics>(kinematics));
    driven::Robot west(open, body, {Vec2(-4.0, 0.0), 0.0}, Vec2(4.0, 0.0));
    driven::Robot east(open, body, {Vec2(4.0, 0.0), base::kPi}, Vec2(-4.0, 0.0));
    const std::shared_ptr<Planner> first = drive::planner(addOrcaPlanner, body);
    const std::shared_ptr<Planner> second = drive::planner(addOrcaPlanner, body);
    const auto bodyAt = [](int id, const Observation& seen) {
      const BodyTwist& motion = seen.motion;
      const Vec2 velocity =
          Pose2{Vec2::Zero(), seen.pose.heading}.toWorld(Vec2(motion.linear, motion.lateral));
      TrackedBody other = driven::person(id, seen.pose.position, velocity);
      other.kind = BodyKind::Robot;
      return other;
    };
    driven::Drive ofWest;
    driven::Drive ofEast;
    double greatestDifference = 0.0;
    for (int i = 0; i < 400; ++i) {
      const TrackedBody inWest = bodyAt(1, west.seen());
      const TrackedBody inEast = bodyAt(2, east.seen());
      west.seen().bodies = {inEast};
      east.seen().bodies = {inWest};
      west.step(*first, ofWest);
      east.step(*second, ofEast);
      const Vec2 sum = west.seen().pose.position + east.seen().pose.position;
      greatestDifference = std::max(greatestDifference, sum.norm());
    }
    QVERIFY2(ofWest.leastGap > 0.0, qPrintable(QString::number(ofWest.leastGap)));
    QVERIFY2(greatestDifference < 1e-6, qPrintable(QString::number(greatestDifference)));
    QVERIFY((west.seen().pose.position - Vec2(4.0, 0.0)).norm() < 0.3);
    QVERIFY2(ofWest.turns <= 6, qPrintable(QString::number(ofWest.turns)));
  }

  void drive_twice_isTheSame() { trials::checkTwice(addOrcaPlanner); }

  void drive_goal_standsInside() { trials::checkGoal(addOrcaPlanner, 1.2); }

  /// A ring of people who stand: no way out, nobody is touched.
  void command_enclosed_stands() {
    for (const Kinematics kinematics : trials::kAllKinematics) {
      const driven::Place open;
      const RobotBody body = driven::bodyOf(kinematics);
      driven::Robot robot(open, body, {Vec2::Zero(), 0.0}, Vec2(5.0, 0.0));
      for (int i = 0; i < 12; ++i) {
        robot.seen().bodies.push_back(driven::person(
            i, 1.3 * base::directionOf(base::wrapToPi(base::kPi / 6.0 * i)), Vec2::Zero()));
      }
      const std::shared_ptr<Planner> planner = drive::planner(addOrcaPlanner, body);
      const driven::Drive drive = robot.driveFor(*planner, 30.0);
      QVERIFY(!drive.hasArrived && drive.leastGap > 0.0);
    }
  }

  void parameters_areDescribed() { trials::checkParameters(addOrcaPlanner, "orca", 10); }

  void command_twentyPeople_isRepeatable() {
    const driven::Place room(
        {{Vec2(-8.0, 4.0), Vec2(8.0, 4.3)}, {Vec2(-8.0, -4.3), Vec2(8.0, -4.0)}});
    const RobotBody body = driven::bodyOf(Kinematics::Differential);
    driven::Robot robot = trials::amongTwenty(room, body);
    const std::shared_ptr<Planner> planner = drive::planner(addOrcaPlanner, body);
    QVERIFY(*planner->command(robot.seen()) == *planner->command(robot.seen()));
  }
};

QTEST_GUILESS_MAIN(OrcaPlannerTest)
#include "tst_OrcaPlanner.moc"
