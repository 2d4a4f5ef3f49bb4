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
  const std::shared_ptr<Planner> planner = driven::plannerOf(addOrcaPlanner, body,
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
  void planes_pairOfTheCircle_byHand();
  void command_pairOfTheCircle_partsSymmetrically();
  void command_pair_robotTakesAll();
  void drive_trials_data() { trials::addRows(all_); }
  void drive_trials();
  void drive_personComesFromAllSides_neverDrivesIntoIt_data();
  void drive_personComesFromAllSides_neverDrivesIntoIt();
  void drive_twoRobotsHeadOn_passEachOther_data();
  void drive_twoRobotsHeadOn_passEachOther();
  void drive_twice_isTheSame();
  void drive_goal_standsInside();
  void command_enclosed_stands();
  void parameters_areDescribed();
  void command_twentyPeople_isRepeatable();

 private:
  const std::vector<Kinematics> all_ = {Kinematics::Differential, Kinematics::Omnidirectional,
                                        Kinematics::Ackermann};
};

/// Reach 3 m of 10 m: the legs of the cone have the sine 0.3; relative velocity 2 m/s along its
/// axis lies 0.6 m/s from the right leg, of which each takes half.
void OrcaPlannerTest::planes_pairOfTheCircle_byHand() {
  const Walker first(1, Vec2(-5.0, 0.0), Vec2(1.0, 0.0), 1.5);
  const Walker second(2, Vec2(5.0, 0.0), Vec2(-1.0, 0.0), 1.5);
  const double cosine = std::sqrt(0.91);
  const HalfPlane plane = bodyHalfPlane(first, second, 10.0, 0.25);
  QVERIFY(isNear(plane.point, Vec2(1.0 - 0.3 * 0.3, -0.3 * cosine)));
  QVERIFY(isNear(plane.direction, Vec2(-cosine, 0.3)));
  const HalfPlane mirrored = bodyHalfPlane(second, first, 10.0, 0.25);
  QVERIFY(isNear(mirrored.point, -plane.point) && isNear(mirrored.direction, -plane.direction));
}

void OrcaPlannerTest::command_pairOfTheCircle_partsSymmetrically() {
  const Vec2 first = velocityOfPair(-1.0, 0.5);
  QVERIFY(isNear(first, Vec2(0.91, -0.3 * std::sqrt(0.91))));
  QVERIFY(isNear(velocityOfPair(1.0, 0.5), -first));
  // The two miss each other barely.
  const Vec2 relative = 2.0 * first;
  const Vec2 apart(10.0, 0.0);
  const Vec2 closest = apart - apart.dot(relative) / relative.squaredNorm() * relative;
  QVERIFY(std::fabs(closest.norm() - 3.0) < 1e-9);
}

void OrcaPlannerTest::command_pair_robotTakesAll() {
  const double sine = 0.3;
  const Vec2 change = 2.0 * sine * Vec2(-sine, -std::sqrt(0.91));
  const Vec2 expected = Vec2(1.0, 0.0) + change;
  QVERIFY(expected.norm() <= 1.0 + 1e-9);  // as fast as it can
  QVERIFY(isNear(velocityOfPair(-1.0, 1.0), expected));
}

void OrcaPlannerTest::drive_trials() {
  QFETCH(int, kinematics);
  QFETCH(int, trial);
  const trials::Drive drive =
      trials::driveTrial(addOrcaPlanner, static_cast<Kinematics>(kinematics), trial);
  trials::check(drive, trials::allTrials()[static_cast<std::size_t>(trial)].mostTurns);
}

void OrcaPlannerTest::drive_personComesFromAllSides_neverDrivesIntoIt_data() {
  QTest::addColumn<int>("kinematics");
  for (const Kinematics kinematics : all_) {
    QTest::newRow(kinematicsName(kinematics)) << static_cast<int>(kinematics);
  }
}

/// All cross the robot's way 3 s after the start, at different places.
void OrcaPlannerTest::drive_personComesFromAllSides_neverDrivesIntoIt() {
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
    const std::shared_ptr<Planner> planner = driven::plannerOf(addOrcaPlanner, body);
    const driven::Drive drive = robot.driveFor(*planner, 40.0);
    QVERIFY2(!drive.droveInto, qPrintable(QStringLiteral("%1: %2").arg(i).arg(drive.leastGap)));
    QVERIFY2(drive.hasArrived, qPrintable(QString::number(i)));
  }
}

void OrcaPlannerTest::drive_twoRobotsHeadOn_passEachOther_data() {
  drive_personComesFromAllSides_neverDrivesIntoIt_data();
}

void OrcaPlannerTest::drive_twoRobotsHeadOn_passEachOther() {
  QFETCH(int, kinematics);
  const driven::Place open;
  const RobotBody body = driven::bodyOf(static_cast<Kinematics>(kinematics));
  driven::Robot west(open, body, {Vec2(-4.0, 0.0), 0.0}, Vec2(4.0, 0.0));
  driven::Robot east(open, body, {Vec2(4.0, 0.0), base::kPi}, Vec2(-4.0, 0.0));
  const std::shared_ptr<Planner> first = driven::plannerOf(addOrcaPlanner, body);
  const std::shared_ptr<Planner> second = driven::plannerOf(addOrcaPlanner, body);
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

void OrcaPlannerTest::drive_twice_isTheSame() {
  const auto poses = [] {
    return trials::driveTrial(addOrcaPlanner, Kinematics::Differential, 11).poses;
  };
  const std::vector<Pose2> once = poses();
  QVERIFY(once.size() > 100 && once == poses());
}

void OrcaPlannerTest::drive_goal_standsInside() {
  for (const Kinematics kinematics : all_) {
    const driven::Place open;
    const RobotBody body = driven::bodyOf(kinematics);
    driven::Robot robot(open, body, {Vec2::Zero(), 0.0}, Vec2(3.0, 0.0));
    const std::shared_ptr<Planner> planner = driven::plannerOf(addOrcaPlanner, body);
    driven::Drive drive;
    for (int i = 0; i < 400; ++i) {
      robot.step(*planner, drive);
    }
    QVERIFY((robot.seen().pose.position - Vec2(3.0, 0.0)).norm() < robot.seen().goalRadius);
    QVERIFY(robot.seen().motion == BodyTwist{});
    QVERIFY(drive.poses[60].position.x() > 1.2);  // it does not creep
  }
}

/// A ring of people who stand: no way out, nobody is touched.
void OrcaPlannerTest::command_enclosed_stands() {
  for (const Kinematics kinematics : all_) {
    const driven::Place open;
    const RobotBody body = driven::bodyOf(kinematics);
    driven::Robot robot(open, body, {Vec2::Zero(), 0.0}, Vec2(5.0, 0.0));
    for (int i = 0; i < 12; ++i) {
      robot.seen().bodies.push_back(driven::person(
          i, 1.3 * base::directionOf(base::wrapToPi(base::kPi / 6.0 * i)), Vec2::Zero()));
    }
    const std::shared_ptr<Planner> planner = driven::plannerOf(addOrcaPlanner, body);
    const driven::Drive drive = robot.driveFor(*planner, 30.0);
    QVERIFY(!drive.hasArrived && drive.leastGap > 0.0);
  }
}

void OrcaPlannerTest::parameters_areDescribed() {
  PlannerRegistry registry;
  addOrcaPlanner(registry);
  const auto* const entry = registry.find("orca");
  QVERIFY(entry != nullptr);
  QCOMPARE(entry->parameters.size(), std::size_t{10});
  for (const base::ParameterSpec& spec : entry->parameters) {
    QVERIFY(!spec.help.empty());
    QVERIFY(spec.range.contains(std::get<double>(spec.fallback)));
  }
}

void OrcaPlannerTest::command_twentyPeople_isRepeatable() {
  const driven::Place room(
      {{Vec2(-8.0, 4.0), Vec2(8.0, 4.3)}, {Vec2(-8.0, -4.3), Vec2(8.0, -4.0)}});
  const RobotBody body = driven::bodyOf(Kinematics::Differential);
  driven::Robot robot(room, body, {Vec2(-5.0, 0.0), 0.0}, Vec2(5.0, 0.0));
  robot.seen().motion.linear = 1.0;
  for (int i = 0; i < 20; ++i) {
    const Vec2 place(-4.0 + 0.45 * i, i % 2 == 0 ? 1.2 : -1.2);
    robot.seen().bodies.push_back(driven::person(i, place, Vec2(-0.8, i % 2 == 0 ? -0.2 : 0.2)));
  }
  const std::shared_ptr<Planner> planner = driven::plannerOf(addOrcaPlanner, body);
  QVERIFY(*planner->command(robot.seen()) == *planner->command(robot.seen()));
}

QTEST_GUILESS_MAIN(OrcaPlannerTest)
#include "tst_OrcaPlanner.moc"
