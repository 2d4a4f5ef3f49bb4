#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/trace/Trace.h"
#include "tests/support/Columns.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

constexpr double kStep = 0.05;  // [s]

/// It stands.
Robot& addWatcher(Scenario& scenario, const Vec2& place) {
  Robot& robot = addRobot(scenario, place, place);
  robot.goal.point.reset();
  return robot;
}

std::unique_ptr<World> watched(const Scenario& scenario) {
  std::unique_ptr<World> world = make(scenario);
  world->publishSensors(true);
  return world;
}

const RobotTelemetry& sensesOf(const Frame& frame, std::size_t robot = 0) {
  return frame.senses->at(robot);
}

/// Of the state that is seen in the next step.
struct Seen {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
};
Seen personOf(const Frame& frame) {
  return {positionOf(frame, 0), Vec2(frame.humans.vx[0], frame.humans.vy[0])};
}

/// Trajectory and scans of a drive among people with faulty sensors.
std::string noisyRun(int seed, int threads) {
  Scenario scenario;
  scenario.desktop.seed = seed;
  addGoal(scenario, 1, -3.0, 0.4);
  addGoal(scenario, 2, 12.0, -0.4);
  for (int i = 0; i < 6; ++i) {
    addPerson(scenario, i + 1, Vec2(2.0 + 1.2 * i, i % 2 == 0 ? 0.8 : -0.9), {1 + i % 2});
  }
  Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2(9.0, 0.0));
  robot.planner = "dwa";
  robot.lidar.record = true;
  robot.lidar.noise = 0.02;
  robot.detector.noise = 0.08;
  robot.detector.misses = 0.2;
  robot.detector.swaps = 0.1;
  robot.detector.rate = 12.0;
  robot.detector.latency = 0.1;
  robot.odometryNoise.alpha1 = robot.odometryNoise.alpha2 = 0.002;
  robot.odometryNoise.alpha3 = robot.odometryNoise.alpha4 = 0.002;
  WorldSetup setup = setupOf(scenario);
  setup.threads = threads;
  auto world = make(std::move(setup));
  std::string text;
  for (int i = 0; i < 120 && world->step(); ++i) {
    appendTrajectoryRows(text, world->frame());
    for (const RecordedScan& scan : world->frame().scans) {
      appendScanRow(text, scan);
    }
  }
  return text;
}

/// Drives ahead; notes what time its scan was of, call by call.
class ScanReader : public Planner {
 public:
  explicit ScanReader(std::vector<double>& times) : times_(times) {}
  base::Result<BodyTwist> command(const Observation& observation) override {
    times_.push_back(observation.scan != nullptr ? observation.scan->time : -1.0);
    return BodyTwist{0.5, 0.0};
  }

 private:
  std::vector<double>& times_;
};

/// Drives ahead; notes whether it was ever given a number that is not finite.
class FiniteReader : public Planner {
 public:
  explicit FiniteReader(bool& isFinite) : isFinite_(isFinite) {}
  base::Result<BodyTwist> command(const Observation& observation) override {
    const Pose2& pose = observation.pose;
    const BodyTwist& motion = observation.motion;
    isFinite_ = isFinite_ && pose.position.allFinite() && std::isfinite(pose.heading) &&
                std::isfinite(motion.linear) && std::isfinite(motion.angular);
    for (const TrackedBody& body : observation.bodies) {
      isFinite_ = isFinite_ && body.position.allFinite() && body.velocity.allFinite();
    }
    return BodyTwist{0.5, 0.0};
  }

 private:
  bool& isFinite_;
};

}  // namespace

/// What robots of a running world know.
class RobotSensesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void person_behindAWall_isUnknownUntilHeComesOut() {
    // From the origin the wall's end hides what is below y = 1 / 1.9 * 4 = 2.1 at x = 4; its corner
    // is at most half a thickness higher, then it is 2.32.
    Scenario scenario;
    addWall(scenario, {{2.0, -3.0}, {2.0, 1.0}});
    addGoal(scenario, 1, 4.0, 5.0);
    addPerson(scenario, 1, Vec2(4.0, 0.0), {1});
    addWatcher(scenario, Vec2::Zero());
    const auto world = watched(scenario);
    int hidden = 0;
    int seen = 0;
    Seen before = personOf(world->frame());
    advance(*world, 60, [&](const Frame& frame) {
      const std::vector<RobotTelemetry::Body>& bodies = sensesOf(frame).bodies;
      if (before.position.y() < 2.05) {
        QVERIFY(bodies.empty());
        ++hidden;
      } else if (before.position.y() > 2.35) {
        QCOMPARE(bodies.size(), std::size_t{1});
        QCOMPARE(bodies[0].id, 1);
        QVERIFY(!bodies[0].isRobot);
        QVERIFY(bodies[0].position == before.position && bodies[0].velocity == before.velocity);
        QCOMPARE(bodies[0].radius, 0.4);
        ++seen;
      }
      before = personOf(frame);
    });
    QVERIFY(hidden > 10 && seen > 10);
  }

  void person_outOfRange_isUnknown() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(9.9, 0.0));
    addPerson(scenario, 2, Vec2(0.0, 10.1));
    addWatcher(scenario, Vec2::Zero());
    const auto world = watched(scenario);
    advance(*world, 1);
    QCOMPARE(sensesOf(world->frame()).bodies.size(), std::size_t{1});
    QCOMPARE(sensesOf(world->frame()).bodies[0].id, 1);
    scenario.robots[0].detector.range = 9.0;
    const auto shorter = watched(scenario);
    advance(*shorter, 1);
    QVERIFY(sensesOf(shorter->frame()).bodies.empty());
  }

  void person_lateDetector_isToldWhereHeWas() {
    constexpr std::size_t kLate = 6;  // steps
    Scenario scenario;
    addGoal(scenario, 1, 4.0, 5.0);
    addPerson(scenario, 1, Vec2(4.0, -4.0), {1});
    addWatcher(scenario, Vec2::Zero()).detector.latency = kLate * kStep;
    const auto world = watched(scenario);
    std::vector<Seen> truth = {personOf(world->frame())};
    advance(*world, 60, [&](const Frame& frame) {
      const std::vector<RobotTelemetry::Body>& bodies = sensesOf(frame).bodies;
      const std::size_t now = truth.size() - 1;  // the state that the step began with
      QCOMPARE(bodies.size(), std::size_t{now < kLate ? 0U : 1U});
      if (now >= kLate) {
        QVERIFY(bodies[0].position == truth[now - kLate].position);
        QVERIFY(bodies[0].velocity == truth[now - kLate].velocity);
      }
      truth.push_back(personOf(frame));
    });
    QVERIFY((truth.back().position - truth.front().position).norm() > 2.0);
  }

  void person_missedNowAndThen_isKnownFromBefore() {
    Scenario scenario;
    addGoal(scenario, 1, 4.0, 5.0);
    addPerson(scenario, 1, Vec2(4.0, -4.0), {1});
    Robot& robot = addWatcher(scenario, Vec2::Zero());
    robot.detector.misses = 0.5;
    robot.detector.coastTime = 100.0;
    const auto world = watched(scenario);
    Seen before = personOf(world->frame());
    int exact = 0;
    int known = 0;
    advance(*world, 80, [&](const Frame& frame) {
      const std::vector<RobotTelemetry::Body>& bodies = sensesOf(frame).bodies;
      known += bodies.empty() ? 0 : 1;
      exact += !bodies.empty() && bodies[0].position == before.position ? 1 : 0;
      before = personOf(frame);
    });
    QVERIFY(known > 70);                // from the first sight on
    QVERIFY(exact > 15 && exact < 65);  // four deviations of 80 draws of one half: 40 +- 18
  }

  void groundTruth_wallsAndDistance_isTheState() {
    Scenario scenario;
    addWall(scenario, {{2.0, -30.0}, {2.0, 30.0}});
    addGoal(scenario, 1, 4.0, 5.0);
    addPerson(scenario, 1, Vec2(4.0, 0.0), {1});
    addPerson(scenario, 2, Vec2(40.0, 0.0), {1});
    addWatcher(scenario, Vec2::Zero()).detector.kind = DetectorKind::GroundTruth;
    addRobot(scenario, Vec2(-20.0, -20.0), Vec2(-10.0, -20.0));
    const auto world = watched(scenario);
    Frame before = world->frame();
    advance(*world, 40, [&](const Frame& frame) {
      const std::vector<RobotTelemetry::Body>& bodies = sensesOf(frame).bodies;
      QCOMPARE(bodies.size(), std::size_t{3});
      for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(bodies[i].id, before.humans.id[i]);
        QVERIFY(bodies[i].position == positionOf(before, i));
        QVERIFY(bodies[i].velocity == Vec2(before.humans.vx[i], before.humans.vy[i]));
      }
      QVERIFY(bodies[2].isRobot && bodies[2].id == -2);
      QVERIFY(bodies[2].position == robotPosition(before, 1));
      before = frame;
    });
  }

  void robots_faceToFace_knowEachOther() {
    Scenario scenario;
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(6.0, 0.0));
    Robot& other = addRobot(scenario, Vec2(6.0, 0.3), Vec2(0.0, 0.3));
    other.type = "jackal";
    other.start.heading = base::kPi;
    const auto world = watched(scenario);
    Frame before = world->frame();
    std::vector<double> between = {6.0};  // along x, by step
    advance(*world, 20, [&](const Frame& frame) {
      for (std::size_t i = 0; i < 2; ++i) {
        const std::vector<RobotTelemetry::Body>& bodies = sensesOf(frame, i).bodies;
        QCOMPARE(bodies.size(), std::size_t{1});
        QVERIFY(bodies[0].isRobot);
        QCOMPARE(bodies[0].id, i == 0 ? -2 : -1);
        QVERIFY(bodies[0].position == robotPosition(before, 1 - i));
      }
      between.push_back(frame.robots.x[1] - frame.robots.x[0]);
      before = frame;
    });
    // Of the Jackal, 0.508 x 0.4318 m: half its diagonal.
    QVERIFY(std::fabs(sensesOf(world->frame(), 0).bodies[0].radius - std::hypot(0.254, 0.2159)) <
            1e-12);
    // Its front, 0.254 m before its middle, is what the lidar met in its last turn.
    const RobotTelemetry::Scan& scan = *sensesOf(world->frame(), 0).scan;
    const double nearest = *std::min_element(scan.distances.begin(), scan.distances.end());
    const auto turn = static_cast<std::size_t>(std::lround(scan.time / kStep));
    QVERIFY(std::fabs(nearest - (between.at(turn) - 0.254)) < 0.06);
  }

  void odometry_exact_isThePoseToTheBit() {
    Scenario scenario;
    Robot& robot = addRobot(scenario, Vec2(0.1, 0.2), Vec2(-3.0, 4.0));
    robot.start.heading = 0.3;
    const auto world = watched(scenario);
    Frame before = world->frame();
    advance(*world, 150, [&](const Frame& frame) {
      const base::Pose2& believed = sensesOf(frame).believed;
      QVERIFY(believed.position == robotPosition(before));
      QVERIFY(believed.heading == before.robots.heading[0]);
      before = frame;
    });
    QVERIFY((robotPosition(before) - Vec2(0.1, 0.2)).norm() > 3.0);
  }

  /// The error after a straight way d has the variance alpha3 d along it: 2 m, 0.02 m²/m.
  void odometry_noisy_leavesThePose() {
    double squares = 0.0;
    constexpr int kRuns = 60;
    for (int seed = 1; seed <= kRuns; ++seed) {
      Scenario scenario;
      scenario.desktop.seed = seed;
      addRobot(scenario, Vec2(0.0, 0.0), Vec2(20.0, 0.0)).odometryNoise.alpha3 = 0.02;
      const auto world = watched(scenario);
      double error = 0.0;
      for (double way = 0.0; way < 2.0;) {
        QVERIFY(world->step());
        error = sensesOf(world->frame()).believed.position.x() - way;
        way = world->frame().robots.x[0];
      }
      squares += error * error;
    }
    // The mean of 60 squares has a relative deviation of sqrt(2 / 60) = 0.18.
    QVERIFY2(std::fabs(squares / kRuns / 0.04 - 1.0) < 0.8, qPrintable(QString::number(squares)));
  }

  void lidar_inARoom_measuresItsWalls() {
    Scenario scenario;
    addRoom(scenario, Vec2(0.0, 0.0), Vec2(10.0, 8.0));  // of walls 0.2 m thick
    Robot& robot = addWatcher(scenario, Vec2(3.0, 2.0));
    robot.start.heading = 0.5;
    robot.lidar.beams = 90;
    robot.lidar.range = 30.0;
    robot.lidar.noise = 0.0;
    robot.lidar.x = 0.25;
    const auto world = watched(scenario);
    advance(*world, 1);
    const RobotTelemetry::Scan& scan = *sensesOf(world->frame()).scan;
    QCOMPARE(scan.distances.size(), std::size_t{90});
    const Vec2 eye(3.0 + 0.25 * std::cos(0.5), 2.0 + 0.25 * std::sin(0.5));
    QVERIFY((scan.sensor.position - eye).norm() < 1e-12);
    QVERIFY(std::fabs(scan.angleMin + M_PI) < 1e-12);  // all round, the first one backwards
    QVERIFY(std::fabs(scan.angleIncrement - 2.0 * M_PI / 90.0) < 1e-12);
    for (int i = 0; i < 90; ++i) {
      const double angle = 0.5 - M_PI + 2.0 * M_PI / 90.0 * i;
      const Vec2 along(std::cos(angle), std::sin(angle));
      const double toX =
          along.x() > 0.0 ? (9.9 - eye.x()) / along.x() : (0.1 - eye.x()) / along.x();
      const double toY =
          along.y() > 0.0 ? (7.9 - eye.y()) / along.y() : (0.1 - eye.y()) / along.y();
      QVERIFY(std::fabs(scan.distances[static_cast<std::size_t>(i)] - std::min(toX, toY)) < 1e-6);
    }
  }

  void lidar_ofTheType_isThere_data() {
    addColumns<QString, int, int>({"type", "own", "beams"});
    QTest::newRow("generic") << "generic" << -1 << 360;
    QTest::newRow("turtlebot4") << "turtlebot4" << -1 << 640;
    QTest::newRow("none") << "jetbot" << -1 << 0;
    QTest::newRow("taken away") << "generic" << 0 << 0;
    QTest::newRow("put on") << "jetbot" << 45 << 45;
  }

  void lidar_ofTheType_isThere() {
    QFETCH(QString, type);
    QFETCH(int, own);
    QFETCH(int, beams);
    Scenario scenario;
    Robot& robot = addWatcher(scenario, Vec2::Zero());
    robot.type = type.toStdString();
    if (own >= 0) {
      robot.lidar.beams = own;
    }
    const auto world = watched(scenario);
    advance(*world, 1);
    const std::optional<RobotTelemetry::Scan>& scan = sensesOf(world->frame()).scan;
    QCOMPARE(scan ? static_cast<int>(scan->distances.size()) : 0, beams);
  }

  /// At 10 Hz every other step of 0.05 s has a turn, from the start on.
  void lidar_recorded_isInTheFrames() {
    Scenario scenario;
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(6.0, 0.0)).lidar.record = true;
    addRobot(scenario, Vec2(0.0, 3.0), Vec2(6.0, 3.0));  // turns, but is not recorded
    const auto world = make(scenario);
    std::vector<std::int64_t> steps;
    Frame before = world->frame();
    QVERIFY(before.scans.empty());
    advance(*world, 9, [&](const Frame& frame) {
      for (const RecordedScan& turn : frame.scans) {
        steps.push_back(turn.step);
        QCOMPARE(turn.robot, -1);
        QCOMPARE(turn.step, frame.step - 1);
        QCOMPARE(turn.scan.time, before.time);
        QVERIFY(turn.scan.sensor.position == robotPosition(before));
        QCOMPARE(turn.scan.distances.size(), std::size_t{360});
      }
      before = frame;
    });
    QVERIFY(steps == (std::vector<std::int64_t>{0, 2, 4, 6, 8}));
  }

  void scansAlone_areThoseOfAllSenses() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(4.0, 0.0));
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(3.0, 3.0)).odometryNoise.alpha1 = 0.2;
    const auto all = watched(scenario);
    const auto world = make(scenario);
    world->enableScans(true);
    advance(*world, 5, [&](const Frame& frame) {
      QVERIFY(all->step());
      const RobotTelemetry& wanted = sensesOf(all->frame());
      const RobotTelemetry& told = sensesOf(frame);
      QVERIFY(told.believed == wanted.believed);
      QVERIFY(!told.scan && told.deferredScan && told.deferredScan->time == wanted.scan->time);
      QVERIFY(told.deferredScan->make().distances == wanted.scan->distances);
      QVERIFY(wanted.bodies.size() == 1 && told.bodies.empty());
      QVERIFY(frame.humanPaths == nullptr);
    });
    world->publishSensors(true);
    advance(*world, 1);
    QCOMPARE(sensesOf(world->frame()).bodies.size(), std::size_t{1});
    QVERIFY(sensesOf(world->frame()).scan && !sensesOf(world->frame()).deferredScan);
    world->publishSensors(false);  // scans are still wanted
    advance(*world, 2);            // one of them is a turn
    QVERIFY(sensesOf(world->frame()).deferredScan && sensesOf(world->frame()).bodies.empty());
    world->enableScans(false);
    advance(*world, 1);
    QVERIFY(world->frame().senses == nullptr);
  }

  /// Robots, one with corners, among people, a door that closes and opens, errors: looked at when
  /// the world is gone.
  void scansForLater_areThoseOfTheirInstant() {
    Scenario scenario;
    addGoal(scenario, 1, -4.0, 0.5);
    addGoal(scenario, 2, 2.0, -3.0);
    addPerson(scenario, 1, Vec2(4.0, 0.0), {1});
    addPerson(scenario, 2, Vec2(2.0, 3.0), {2});
    addDoor(scenario, {-2.0, 5.0}, {5.0, 5.0}, true, {1.0, 3.0});
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(6.0, 3.0)).lidar.noise = 0.03;
    Robot& other = addRobot(scenario, Vec2(6.0, 0.3), Vec2(0.0, 2.0));
    other.type = "jackal";
    other.lidar.range = 8.0;
    const auto all = watched(scenario);
    std::unique_ptr<World> world = make(scenario);
    world->enableScans(true);
    std::vector<RobotTelemetry::Scan> wanted;
    std::vector<RobotTelemetry::DeferredScan> later;
    advance(*world, 100, [&](const Frame& frame) {
      QVERIFY(all->step());
      for (std::size_t robot = 0; robot < 2; ++robot) {
        wanted.push_back(*sensesOf(all->frame(), robot).scan);
        later.push_back(*sensesOf(frame, robot).deferredScan);
      }
    });
    world.reset();
    QCOMPARE(later.size(), std::size_t{200});
    for (std::size_t k = later.size(); k-- > 0;) {  // in another order
      const RobotTelemetry::Scan made = later[k].make();
      QCOMPARE(made.time, wanted[k].time);
      QVERIFY(made.sensor == wanted[k].sensor && made.distances == wanted[k].distances);
    }
  }

  void run_noisySensors_dependsOnTheSeedAlone() {
    const std::string one = noisyRun(1, 1);
    QVERIFY(one.size() > 100000);
    QVERIFY(one == noisyRun(1, 1));
    QVERIFY(one == noisyRun(1, 2));
    QVERIFY(one != noisyRun(2, 1));
  }

  /// A robot that sees half a metre runs into who stands in its way; one with eyes stops.
  void planner_blindRobot_drivesOn() {
    for (const bool isBlind : {false, true}) {
      Scenario scenario;
      addPerson(scenario, 1, Vec2(5.0, 0.0));
      Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2(8.0, 0.0));
      if (isBlind) {
        robot.detector.range = 0.5;
      }
      const auto world = make(scenario, [](const WorldView&, Intents& intents) {
        intents.of(0).motion = Motion::Stand;
      });
      QCOMPARE(ofKind(advance(*world, 200), EventKind::Contact).empty(), !isBlind);
    }
  }

  void planner_blindDetector_avoidsWhatItsLidarMeets() {
    for (const bool hasLidar : {true, false}) {
      Scenario scenario;
      addPerson(scenario, 1, Vec2(4.0, 0.0));
      Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2(8.0, 0.0));
      robot.planner = "dwa";
      robot.detector.range = 0.1;
      robot.lidar.legs = false;
      if (!hasLidar) {
        robot.lidar.beams = 0;
      }
      const auto world = make(scenario, [](const WorldView&, Intents& intents) {
        intents.of(0).motion = Motion::Stand;
      });
      QCOMPARE(ofKind(advance(*world, 200), EventKind::Contact).empty(), hasLidar);
    }
  }

  /// Whether others hear its lidar or not. Turns are made in the steps from states 0, 2, 4 ….
  void planner_setsOffAgain_knowsTheLastTurn() {
    for (const bool isHeard : {false, true}) {
      std::vector<double> times;
      auto own = std::make_shared<Registries>(builtinRegistries());
      own->planners.add("scan_reader", {}, [&times](const PlannerSetup& /*setup*/) {
        return base::Result<std::shared_ptr<Planner>>(std::make_shared<ScanReader>(times));
      });
      Scenario scenario;
      addRobot(scenario, Vec2(0.0, 0.0), Vec2(0.1, 0.0)).planner = "scan_reader";
      WorldSetup setup = setupOf(scenario);
      setup.registries = own;
      auto world = make(std::move(setup));
      world->enableScans(isHeard);
      QCOMPARE(ofKind(advance(*world, 41), EventKind::Arrived).size(), std::size_t{1});
      times.clear();
      QVERIFY(world->step({placing(InputKind::Goal, -1, {8.0, 0.0})}));  // from state 41
      QVERIFY(world->step());
      QCOMPARE(times.size(), std::size_t{2});
      QVERIFY(std::fabs(times[0] - 40 * kStep) < 1e-9);
      QVERIFY(std::fabs(times[1] - 42 * kStep) < 1e-9);
    }
  }

  void step_valuesThatAreNotFinite_endTheRun_data() {
    addColumns<int>({"sensor"});
    QTest::newRow("detector") << 0;
    QTest::newRow("detector, filtered") << 1;
    QTest::newRow("position") << 2;
    QTest::newRow("heading") << 3;
    QTest::newRow("odometry") << 4;
  }

  /// Where they arise; the planner is not called with them. The ranges of scenario files exclude
  /// such settings.
  void step_valuesThatAreNotFinite_endTheRun() {
    QFETCH(int, sensor);
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    bool isFinite = true;
    auto own = std::make_shared<Registries>(builtinRegistries());
    own->planners.add("finite_reader", {}, [&isFinite](const PlannerSetup& /*setup*/) {
      return base::Result<std::shared_ptr<Planner>>(std::make_shared<FiniteReader>(isFinite));
    });
    Scenario scenario;
    addPerson(scenario, 1, Vec2(4.0, 1.0));
    Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2(8.0, 0.0));
    robot.planner = "finite_reader";
    if (sensor <= 1) {
      robot.detector.noise = kInfinite;
      robot.detector.velocities =
          sensor == 1 ? TrackVelocities::Filtered : TrackVelocities::Measured;
    } else if (sensor == 2) {
      robot.localization.stdX = kInfinite;
    } else if (sensor == 3) {
      robot.localization.stdYaw = kInfinite;
    } else {
      robot.odometryNoise.alpha3 = kInfinite;
    }
    WorldSetup setup = setupOf(scenario);
    setup.registries = own;
    const auto world = make(std::move(setup));
    int steps = 0;
    while (steps < 40 && world->step()) {
      ++steps;
    }
    QVERIFY(steps < 40);
    QVERIFY(isFinite);
    QCOMPARE(QString::fromStdString(world->failure()),
             QStringLiteral("robot 'robot1': its sensor values are not finite"));
  }

  void create_badSensors_isRefused_data() {
    addColumns<int, QString>({"fault", "text"});
    QTest::newRow("angles") << 0 << "angle_max must be above angle_min";
    QTest::newRow("more than a turn") << 1 << "angle_max must be above angle_min";
    QTest::newRow("too dense") << 2 << "beams at least 0.0001 rad apart";
    QTest::newRow("a car that cannot turn") << 3 << "turning_radius";
  }

  void create_badSensors_isRefused() {
    QFETCH(int, fault);
    QFETCH(QString, text);
    Scenario scenario;
    Robot& robot = addWatcher(scenario, Vec2::Zero());
    robot.key = {base::EntityKind::Robot, 7};
    if (fault == 0) {
      robot.lidar.angleMin = 1.0;
      robot.lidar.angleMax = 1.0;
    } else if (fault == 1) {
      robot.lidar.angleMin = 0.0;
      robot.lidar.angleMax = 6.3;
    } else if (fault == 2) {
      robot.lidar.beams = 20000;
      robot.lidar.angleMin = 0.0;
      robot.lidar.angleMax = 1.0;
    } else {
      robot.kinematics = Kinematics::Ackermann;
    }
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(!world);
    QCOMPARE(world.diagnostics().size(), std::size_t{1});
    QVERIFY(world.diagnostics()[0].entity == robot.key);
    const QString said = QString::fromStdString(world.diagnostics()[0].text());
    QVERIFY2(said.contains(text), qPrintable(said));
  }

  void create_keysWithoutEffect_warns() {
    Scenario scenario;
    Robot& robot = addWatcher(scenario, Vec2::Zero());
    robot.type = "jetbot";
    robot.lidar.range = 5.0;
    robot.detector.kind = DetectorKind::GroundTruth;
    robot.detector.noise = 0.1;
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QCOMPARE(world.diagnostics().size(), std::size_t{2});
    QVERIFY(world.diagnostics()[0].text().find("has no lidar") != std::string::npos);
    QVERIFY(world.diagnostics()[1].text().find("ground_truth") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(RobotSensesTest)
#include "tst_RobotSenses.moc"
