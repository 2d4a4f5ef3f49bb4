#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/base/Rng.h"
#include "tests/AllocationCount.h"
#include "tests/nav/DriveWorld.h"
#include "tests/nav/MetaTypes.h"
#include "tests/nav/PlannerFunctions.h"

using drive::person;
using drive::robotBody;
using drive::wall;
using drive::World;
using namespace sim2d;

namespace {

std::shared_ptr<Planner> dwaOf(const RobotBody& body,
                               std::vector<std::pair<std::string, double>> parameters = {}) {
  return drive::planner(addDwa, body, std::move(parameters));
}

/// Two walls along x with `width` between them, about y = 0.
std::vector<Outline> corridor(double length, double width) {
  return {wall(-2.0, 0.5 * width, length, 0.5 * width + 0.2),
          wall(-2.0, -0.5 * width - 0.2, length, -0.5 * width)};
}

/// Of a lidar in the robot's middle that sees discs alone.
LaserScan scanOf(const Pose2& pose, double time, const std::vector<Vec2>& centres, double radius) {
  LaserScan scan;
  scan.sensor = pose;
  scan.time = time;
  scan.angleMin = -base::kPi;
  scan.angleIncrement = base::kPi / 180.0;
  scan.range = 10.0;
  for (int i = 0; i < 360; ++i) {
    const double angle = pose.heading + scan.angleMin + i * scan.angleIncrement;
    const Vec2 way(std::cos(angle), std::sin(angle));
    double distance = scan.range;
    for (const Vec2& centre : centres) {
      const Vec2 to = centre - pose.position;
      const double along = way.dot(to);
      const double inside = radius * radius - (to.squaredNorm() - along * along);
      if (along > 0.0 && inside > 0.0) {
        distance = std::min(distance, along - std::sqrt(inside));
      }
    }
    scan.distances.push_back(distance);
  }
  return scan;
}

}  // namespace

class DwaTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_fromRestAndAtSpeed_liesInTheWindow() {
    const RobotBody body = robotBody(Kinematics::Differential);
    // 1 m/s² and 3 rad/s² for 0.25 s.
    World rest(body, {Vec2::Zero(), 0.0}, Vec2(20.0, 5.0));
    rest.step(*dwaOf(body));
    const BodyTwist first = rest.commands().front();
    QVERIFY(first.linear >= 0.0 && first.linear <= 0.25 + 1e-12);
    QVERIFY(std::fabs(first.angular) <= 0.75 + 1e-12);
    QVERIFY(first.angular > 0.0);  // the goal lies to the left
    World fast(body, {Vec2::Zero(), 0.0}, Vec2(-20.0, 0.0));
    fast.observation().motion = {0.8, 0.4};
    fast.step(*dwaOf(body));
    const BodyTwist second = fast.commands().front();
    QVERIFY(second.linear >= 0.55 - 1e-12 && second.linear <= 1.0 + 1e-12);
    QVERIFY(second.angular >= -0.35 - 1e-12 && second.angular <= 1.15 + 1e-12);
  }

  void command_twoNearlyStopped_isTheFastestStraightAhead() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(20.0, 0.0));
    world.step(*dwaOf(body));
    QVERIFY(std::fabs(world.commands().front().linear - 0.25) < 1e-12);
    QVERIFY(std::fabs(world.commands().front().angular) < 1e-12);
  }

  void drive_openPlane_arrivesAndStands_data() {
    QTest::addColumn<Kinematics>("kinematics");
    QTest::addColumn<QPointF>("goal");
    const std::pair<const char*, Kinematics> kinds[] = {
        {"differential", Kinematics::Differential},
        {"omnidirectional", Kinematics::Omnidirectional},
        {"ackermann", Kinematics::Ackermann}};
    const std::pair<const char*, QPointF> goals[] = {{"ahead", {5.0, 0.0}},
                                                     {"left", {1.0, 4.0}},
                                                     {"close beside", {0.0, 0.7}},
                                                     {"right behind", {-3.0, -1.0}},
                                                     {"behind", {-4.0, 0.0}}};
    for (const auto& [kind, kinematics] : kinds) {
      for (const auto& [place, goal] : goals) {
        QTest::addRow("%s, goal %s", kind, place) << kinematics << goal;
      }
    }
  }

  void drive_openPlane_arrivesAndStands() {
    QFETCH(Kinematics, kinematics);
    QFETCH(QPointF, goal);
    const RobotBody body = robotBody(kinematics);
    const Vec2 place(goal.x(), goal.y());
    World world(body, {Vec2::Zero(), 0.0}, place);
    QVERIFY(world.arrives(*dwaOf(body), 25.0));
    QVERIFY(world.isGood());
    // The way at full speed, getting fast and slow, a half turn; a car's turning circle beside.
    QVERIFY2(
        world.time() < place.norm() / 1.0 + 6.0 + (kinematics == Kinematics::Ackermann ? 9 : 0),
        QByteArray::number(world.time()));
    // And it stays there.
    for (int i = 0; i < 20; ++i) {
      world.step(*dwaOf(body));
    }
    QVERIFY(world.distanceLeft() <= world.observation().goalRadius);
  }

  void drive_goalBehind_turnsOnTheSpot() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(-4.0, 0.0));
    const std::shared_ptr<Planner> dwa = dwaOf(body);
    while (std::cos(world.observation().pose.heading) > 0.0) {  // until it no longer leads away
      QVERIFY2(world.time() < 3.0, "turns too slowly");
      world.step(*dwa);
    }
    const double away = world.observation().pose.position.norm();
    QVERIFY2(away < 0.15, QByteArray::number(away));  // half of its own radius
  }

  void drive_corridor_keepsOffTheWalls_data() {
    QTest::addColumn<Kinematics>("kinematics");
    QTest::newRow("differential") << Kinematics::Differential;
    QTest::newRow("omnidirectional") << Kinematics::Omnidirectional;
    QTest::newRow("ackermann") << Kinematics::Ackermann;
  }

  void drive_corridor_keepsOffTheWalls() {
    QFETCH(Kinematics, kinematics);
    const RobotBody body = robotBody(kinematics);
    World world(body, {Vec2(0.0, 0.1), 0.3}, Vec2(8.0, 0.0), corridor(10.0, 1.2));
    QVERIFY(world.arrives(*dwaOf(body), 25.0));
    QVERIFY(world.isGood());
    QVERIFY2(world.wallGap() > 0.05, QByteArray::number(world.wallGap()));
  }

  void drive_doorway_passes_data() { drive_corridor_keepsOffTheWalls_data(); }

  void drive_doorway_passes() {
    QFETCH(Kinematics, kinematics);
    const RobotBody body = robotBody(kinematics);
    const std::vector<Outline> walls = {wall(3.0, 0.45, 3.2, 5.0), wall(3.0, -5.0, 3.2, -0.45)};
    World world(body, {Vec2(0.0, 1.5), 0.0}, Vec2(6.0, -1.5), walls);
    QVERIFY(world.arrives(*dwaOf(body), 40.0));
    QVERIFY(world.isGood());
    QVERIFY2(world.wallGap() > 0.0, QByteArray::number(world.wallGap()));
  }

  void drive_polygonThroughDoorway_passes() {
    RobotBody body = robotBody(Kinematics::Differential);
    body.footprint.corners = {Vec2(-0.35, -0.22), Vec2(0.35, -0.22), Vec2(0.35, 0.22),
                              Vec2(-0.35, 0.22)};
    const std::vector<Outline> walls = {wall(3.0, 0.5, 3.2, 5.0), wall(3.0, -5.0, 3.2, -0.5)};
    World world(body, {Vec2(0.0, 1.0), 0.0}, Vec2(6.0, -1.0), walls);
    QVERIFY(world.arrives(*dwaOf(body), 40.0));
    QVERIFY2(world.wallGap() > 0.0, QByteArray::number(world.wallGap()));
  }

  void drive_personCrossing_isNotHit() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(8.0, 0.0));
    // Meets a robot at full speed after 4 s.
    world.observation().bodies = {person(1, Vec2(3.5, -4.8), Vec2(0.0, 1.2))};
    QVERIFY(world.arrives(*dwaOf(body), 25.0));
    QVERIFY2(world.personGap() > 0.0, QByteArray::number(world.personGap()));
    QVERIFY2(world.time() < 14.0, QByteArray::number(world.time()));
  }

  void drive_crowd_neverDrivesIntoAnybody_data() { drive_corridor_keepsOffTheWalls_data(); }

  void drive_crowd_neverDrivesIntoAnybody() {
    QFETCH(Kinematics, kinematics);
    const RobotBody body = robotBody(kinematics);
    int arrived = 0;
    for (int seed = 1; seed <= 8; ++seed) {
      const base::AgentRng random(static_cast<std::uint64_t>(seed), 0);
      World world(body, {Vec2::Zero(), 0.0}, Vec2(10.0, 0.0));
      for (int i = 0; i < 14; ++i) {
        const auto draw = static_cast<std::uint32_t>(4 * i);
        const double angle = random.uniform(-base::kPi, base::kPi, base::DrawPurpose::Test, draw);
        const double speed = random.uniform(0.3, 1.4, base::DrawPurpose::Test, draw + 1);
        const Vec2 place(random.uniform(2.0, 12.0, base::DrawPurpose::Test, draw + 2),
                         random.uniform(-5.0, 5.0, base::DrawPurpose::Test, draw + 3));
        world.observation().bodies.push_back(
            person(i + 1, place, speed * Vec2(std::cos(angle), std::sin(angle))));
      }
      arrived += world.arrives(*dwaOf(body), 40.0) ? 1 : 0;
      QVERIFY(world.isGood());
      QVERIFY2(world.personGap() > 0.0,
               qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(world.personGap())));
    }
    QCOMPARE(arrived, 8);
  }

  void drive_personStandsOnTheRoute_goesRound_data() { drive_corridor_keepsOffTheWalls_data(); }

  void drive_personStandsOnTheRoute_goesRound() {
    QFETCH(Kinematics, kinematics);
    const RobotBody body = robotBody(kinematics);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(7.0, 0.0), corridor(9.0, 3.0));
    world.observation().bodies = {person(1, Vec2(3.0, 0.0)), person(2, Vec2(3.0, 0.6)),
                                  person(3, Vec2(5.0, -0.6))};
    QVERIFY(world.arrives(*dwaOf(body), 40.0));
    QVERIFY2(world.personGap() > 0.0, QByteArray::number(world.personGap()));
    QVERIFY2(world.wallGap() > 0.0, QByteArray::number(world.wallGap()));
  }

  /// Five people stand in a half circle before the robot, too close to each other for it.
  void drive_cupOfPeople_turnsAndGoesRound() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(6.0, 0.0));
    for (int i = 0; i < 5; ++i) {
      const double angle = (i - 2) * base::kPi / 4.0;  // 1.22 m apart on a circle of 1.6 m
      world.observation().bodies.push_back(
          person(i + 1, 1.6 * Vec2(std::cos(angle), std::sin(angle))));
    }
    QVERIFY(world.arrives(*dwaOf(body), 60.0));
    QVERIFY2(world.personGap() > 0.0, QByteArray::number(world.personGap()));
  }

  void drive_ringWithoutGap_triesAndHitsNobody() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(6.0, 0.0));
    for (int i = 0; i < 12; ++i) {
      const double angle = i * base::kPi / 6.0;
      world.observation().bodies.push_back(
          person(i + 1, 1.6 * Vec2(std::cos(angle), std::sin(angle))));
    }
    const std::shared_ptr<Planner> dwa = dwaOf(body);
    int replans = 0;
    QVERIFY(!world.arrives(*dwa, 5.0));
    for (int i = 0; i < 500; ++i) {
      world.step(*dwa);
      replans += dwa->takeReplanned() ? 1 : 0;
    }
    QVERIFY(replans >= 2);
    QVERIFY2(world.personGap() > 0.0, QByteArray::number(world.personGap()));
    world.observation().bodies.erase(world.observation().bodies.begin());  // the one ahead goes
    QVERIFY(world.arrives(*dwa, 30.0));
    QVERIFY2(world.personGap() > 0.0, QByteArray::number(world.personGap()));
  }

  void drive_unknownThingInTheScan_isAvoided() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(7.0, 0.0));
    const std::shared_ptr<Planner> dwa = dwaOf(body);
    const std::vector<Vec2> posts = {Vec2(3.0, 0.1), Vec2(4.5, -0.5)};
    LaserScan scan;
    double least = 1e9;
    while (world.distanceLeft() > 0.2) {
      QVERIFY2(world.time() < 25.0, QByteArray::number(world.distanceLeft()));
      scan = scanOf(world.observation().pose, world.time(), posts, 0.2);
      world.observation().scan = &scan;
      world.step(*dwa);
      for (const Vec2& post : posts) {
        least = std::min(least, (post - world.observation().pose.position).norm() - 0.5);
      }
    }
    QVERIFY2(least > 0.0, QByteArray::number(least));
  }

  void command_noWay_stands() {
    const RobotBody body = robotBody(Kinematics::Differential);
    const std::vector<Outline> walls = {wall(4.0, -1.0, 4.2, 1.0), wall(6.0, -1.0, 6.2, 1.0),
                                        wall(4.0, 1.0, 6.2, 1.2), wall(4.0, -1.2, 6.2, -1.0)};
    World world(body, {Vec2::Zero(), 0.0}, Vec2(5.0, 0.0), walls);
    world.step(*dwaOf(body));
    QVERIFY(world.commands().front() == BodyTwist{});
  }

  void command_insideTheGoal_brakes() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2(4.9, 0.0), 0.0}, Vec2(5.0, 0.0));
    world.observation().motion = {0.4, 0.2};
    world.step(*dwaOf(body));
    QVERIFY(world.commands().front() == BodyTwist{});
  }

  void command_equalObservations_equalBits() {
    const RobotBody body = robotBody(Kinematics::Differential);
    std::vector<std::vector<BodyTwist>> runs;
    for (int run = 0; run < 2; ++run) {
      World world(body, {Vec2::Zero(), 0.4}, Vec2(7.0, 1.0), corridor(9.0, 3.0));
      world.observation().bodies = {person(1, Vec2(3.0, 0.1)),
                                    person(2, Vec2(5.0, -1.0), Vec2(-0.5, 0.2))};
      world.arrives(*dwaOf(body), 25.0);
      runs.push_back(world.commands());
    }
    QVERIFY(runs[0].size() > 50 && runs[0] == runs[1]);
  }

  void candidates_areASampleWithTheChosenAsBest() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(7.0, 1.0));
    world.observation().motion = {0.9, 0.0};
    world.observation().bodies = {person(1, Vec2(1.9, 0.0))};
    const std::shared_ptr<Planner> dwa = dwaOf(body);
    QVERIFY(dwa->candidates().empty());
    world.step(*dwa);
    const std::vector<Candidate> arcs = dwa->candidates();
    QVERIFY(arcs.size() >= 30 && arcs.size() <= 60);
    QCOMPARE(std::count_if(arcs.begin(), arcs.end(), [](const Candidate& a) { return a.isChosen; }),
             std::ptrdiff_t{1});
    const auto chosen =
        std::find_if(arcs.begin(), arcs.end(), [](const Candidate& a) { return a.isChosen; });
    bool isBlocked = false;
    for (const Candidate& arc : arcs) {
      QVERIFY(arc.points.front().isZero(0.0) && arc.points.size() >= 20);
      QVERIFY(arc.cost >= chosen->cost);
      isBlocked = isBlocked || std::isinf(arc.cost);
    }
    // Braking from 0.9 m/s takes 0.4 m, there is 1.3 m of room less 0.1 m: all can stop, but for...
    QVERIFY(std::isfinite(chosen->cost));
    QVERIFY(!isBlocked);
    // ... somebody nearer: 0.35 m less 0.1 m of margin.
    world.observation().pose = {Vec2::Zero(), 0.0};
    world.observation().motion = {0.9, 0.0};
    world.observation().bodies = {person(1, Vec2(0.95, 0.0))};
    world.step(*dwa);
    const std::vector<Candidate> late = dwa->candidates();
    QVERIFY(std::all_of(late.begin(), late.end(),
                        [](const Candidate& a) { return std::isinf(a.cost); }));
    QVERIFY(world.commands().back() == BodyTwist{});
  }

  void command_amongManyPeople_isTheBestOfTheShown() {
    // Shown arcs are weighed to the end, most others only until they cannot be the best any more.
    for (const Kinematics kinematics :
         {Kinematics::Differential, Kinematics::Omnidirectional, Kinematics::Ackermann}) {
      const RobotBody body = robotBody(kinematics);
      World world(body, {Vec2::Zero(), 0.0}, Vec2(9.0, 1.0), corridor(12.0, 4.0));
      const std::shared_ptr<Planner> dwa = dwaOf(body);
      int finite = 0;
      for (int i = 0; i < 120; ++i) {
        world.observation().bodies = {person(1, Vec2(2.5, 0.5), Vec2(0.3, -0.2)),
                                      person(2, Vec2(4.0, -0.8), Vec2(-0.6, 0.3)),
                                      person(3, Vec2(5.0, 1.0)), person(4, Vec2(0.4, -1.2))};
        world.step(*dwa);
        const std::vector<Candidate> arcs = dwa->candidates();
        const auto chosen =
            std::find_if(arcs.begin(), arcs.end(), [](const Candidate& a) { return a.isChosen; });
        for (const Candidate& arc : arcs) {
          QVERIFY(std::isinf(arc.cost) || (chosen != arcs.end() && arc.cost >= chosen->cost));
          finite += std::isinf(arc.cost) ? 0 : 1;
        }
      }
      QVERIFY2(finite > 1000, QByteArray::number(finite));
    }
  }

  void command_afterTheFirst_allocatesNothing() {
    const RobotBody body = robotBody(Kinematics::Differential);
    World world(body, {Vec2::Zero(), 0.0}, Vec2(7.0, 0.0), corridor(9.0, 3.0));
    world.observation().bodies = {person(1, Vec2(4.0, 0.2)), person(2, Vec2(2.0, -1.0)),
                                  person(3, Vec2(6.0, 1.0), Vec2(-1.0, 0.0))};
    const std::shared_ptr<Planner> dwa = dwaOf(body);
    world.step(*dwa);
    long most = 0;
    for (int i = 0; i < 40; ++i) {
      world.observation().time += 0.05;
      world.observation().pose.position.x() += 0.02;
      const long before = allocations.load();
      const bool isGood = static_cast<bool>(dwa->command(world.observation()));
      most = std::max(most, allocations.load() - before);
      QVERIFY(isGood);
    }
    QCOMPARE(most, 0L);
  }
};

QTEST_GUILESS_MAIN(DwaTest)
#include "tst_Dwa.moc"
