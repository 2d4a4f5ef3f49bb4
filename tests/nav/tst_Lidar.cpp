#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <QtTest>

#include "sim2d/base/Math.h"
#include "sim2d/nav/Lidar.h"
#include "tests/AllocationCount.h"

using namespace sim2d;

namespace {

constexpr double kExact = 1e-9;  // [m]

/// A floor of 20 x 20 m with solid things, people and robots.
struct Floor {
  Obstacles obstacles;
  std::vector<SensedBody> bodies;
  Obstacles polygons;  // the robots with corners, as solids
  Footprint wedge{0.0,
                  {{0.5, -0.3}, {0.6, 0.0}, {0.5, 0.3}, {-0.4, 0.25}, {-0.2, 0.0}, {-0.4, -0.25}}};
};

SensedBody personAt(int id, const Vec2& position, double heading = 0.0, double speed = 0.0) {
  SensedBody person;
  person.id = id;
  person.position = position;
  person.heading = heading;
  person.velocity = speed * base::directionOf(heading);
  person.radius = 0.3;
  return person;
}

Vec2 randomPlace(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  const double x = place(random);
  return {x, place(random)};
}

/// Boxes in three parts, of which the second is open, within a room.
void addSolids(Floor& floor, std::mt19937& random) {
  std::uniform_real_distribution<double> size(0.05, 2.0);
  std::uniform_real_distribution<double> angle(-3.2, 3.2);
  for (int part = 0; part < 3; ++part) {
    std::vector<Outline> outlines;
    outlines.reserve(8);
    for (int i = 0; i < 8; ++i) {
      const double length = size(random);
      const Pose2 centre{randomPlace(random), i % 3 == 0 ? 0.0 : angle(random)};
      outlines.push_back(i % 4 == 3 ? circleOutline(centre.position, 0.3 * length)
                                    : boxOutline(centre, length, 0.5 * size(random)));
    }
    floor.obstacles.add(outlines, part != 1);
  }
  floor.obstacles.add({Outline{{{-11.0, -11.0}, {-11.0, 11.0}, {11.0, 11.0}, {11.0, -11.0}}}});
  floor.obstacles.build();
}

void addBodies(Floor& floor, std::mt19937& random, int people, int robots) {
  std::uniform_real_distribution<double> angle(-3.2, 3.2);
  for (int i = 0; i < people; ++i) {
    const Vec2 place = randomPlace(random);
    floor.bodies.push_back(personAt(i + 1, place, angle(random), 0.1 * (i % 15)));
  }
  for (int i = 0; i < robots; ++i) {
    SensedBody robot = personAt(i + 1, randomPlace(random), angle(random));
    robot.kind = BodyKind::Robot;
    robot.footprint = i % 2 == 0 ? &floor.wedge : nullptr;
    floor.bodies.push_back(robot);
    if (i % 2 == 0) {
      Outline outline;
      outline.points.reserve(floor.wedge.corners.size());
      for (const Vec2& corner : floor.wedge.corners) {
        outline.points.push_back(robot.pose().toWorld(corner));
      }
      floor.polygons.add({outline});
    }
  }
  floor.polygons.build();
}

/// From outside; `range` when it is missed, 0 from inside.
double circleDistance(const Vec2& from, const Vec2& direction, const Vec2& centre, double radius,
                      double range) {
  const Vec2 offset = centre - from;
  if (offset.norm() <= radius) {
    return 0.0;
  }
  const double along = offset.dot(direction);
  const double aside = std::fabs(base::cross(direction, offset));
  if (along < 0.0 || aside > radius) {
    return range;
  }
  return std::min(range, along - std::sqrt((radius - aside) * (radius + aside)));
}

/// What a single beam meets, shape by shape.
double castAlone(const Floor& floor, const LidarParameters& lidar, const LegGait& gait,
                 const Vec2& from, const Vec2& direction) {
  double distance = std::min(floor.obstacles.raycast(from, direction, lidar.range),
                             floor.polygons.raycast(from, direction, lidar.range));
  const auto addCircle = [&](const Vec2& centre, double radius) {
    distance = std::min(distance, circleDistance(from, direction, centre, radius, lidar.range));
  };
  for (std::size_t i = 0; i < floor.bodies.size(); ++i) {
    const SensedBody& body = floor.bodies[i];
    if (body.kind == BodyKind::Person && lidar.legs) {
      const Legs legs = legsAt(body, gait.gaitPhase(i));
      addCircle(legs.left, legs.radius);
      addCircle(legs.right, legs.radius);
    } else if (body.footprint == nullptr) {
      addCircle(body.position, body.radius);
    }
  }
  return distance;
}

/// The greatest difference between a turn at the pose and beams cast alone; counts those that met
/// something.
double worstBeam(const Floor& floor, const LidarParameters& parameters, const Pose2& pose,
                 int& hits) {
  Lidar lidar(parameters, 5, 99);
  lidar.update({pose, pose, floor.obstacles, floor.bodies, 0.0});
  LegGait gait(5);
  gait.update(floor.bodies);
  const LaserScan& scan = *lidar.scan();
  double worst = static_cast<int>(scan.distances.size()) == parameters.beams ? 0.0 : 1e9;
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    const double angle =
        scan.sensor.heading + scan.angleMin + static_cast<double>(i) * scan.angleIncrement;
    const double expected =
        castAlone(floor, parameters, gait, scan.sensor.position, base::directionOf(angle));
    worst = std::max(worst, std::fabs(scan.distances[i] - expected));
    hits += expected < parameters.range ? 1 : 0;
  }
  return worst;
}

LidarParameters lidarOf(int beams, double angleMin = -base::kPi, double angleMax = base::kPi,
                        double range = 30.0) {
  LidarParameters parameters;
  parameters.beams = beams;
  parameters.angleMin = angleMin;
  parameters.angleMax = angleMax;
  parameters.range = range;
  parameters.legs = false;
  return parameters;
}

/// A room of 8 x 8 m about the origin.
Obstacles emptyRoom() {
  Obstacles room;
  room.add({Outline{{{-4.0, -4.0}, {-4.0, 4.0}, {4.0, 4.0}, {4.0, -4.0}}}});
  room.build();
  return room;
}

/// One turn at the origin.
LaserScan turnAt(const Pose2& pose, const LidarParameters& parameters, const Obstacles& obstacles,
                 const std::vector<SensedBody>& bodies) {
  Lidar lidar(parameters, 1, 1);
  lidar.update({pose, pose, obstacles, bodies, 0.0});
  return *lidar.scan();
}

bool areAll(const std::vector<double>& values, double value) {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == value; });
}

/// A lidar that is read at each turn, and one beside it that is read as it is said.
struct ReadAlwaysAndElse {
  /// `use`, by step, of the other; `check(step, isTurn, isTurnOfTheOther)` after each. Every second
  /// step is a turn.
  template <class Use, class Check>
  void walk(int steps, const Use& use, const Check& check) {
    std::mt19937 random(7);
    Floor floor;
    addSolids(floor, random);
    addBodies(floor, random, 40, 6);
    for (int step = 0; step < steps; ++step) {
      const Pose2 pose{{0.05 * step, 0.0}, 0.1 * step};
      const SensedWorld world{pose, pose, floor.obstacles, floor.bodies, 0.05 * step};
      const bool isTurn = always.update(world);
      check(step, isTurn, other.update(world, use(step)));
      for (SensedBody& body : floor.bodies) {
        body.position += 0.05 * body.velocity;
      }
    }
  }
  bool areScansEqual() const {
    return other.scan()->time == always.scan()->time &&
           other.scan()->distances == always.scan()->distances;
  }

  static LidarParameters noisy() {
    LidarParameters parameters;
    parameters.noise = 0.01;
    return parameters;
  }
  Lidar always{noisy(), 1, 99}, other{noisy(), 1, 99};
};

}  // namespace

class LidarTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void turn_randomScenes_equalBeamsCastAlone_data() {
    QTest::addColumn<int>("beams");
    QTest::addColumn<double>("angleMin");
    QTest::addColumn<double>("angleMax");
    QTest::addColumn<double>("range");
    QTest::addColumn<bool>("legs");
    const double pi = base::kPi;
    QTest::newRow("whole turn") << 360 << -pi << pi << 30.0 << false;
    QTest::newRow("whole turn, legs") << 1440 << -pi << pi << 30.0 << true;
    QTest::newRow("from 0, short range") << 1000 << 0.0 << 2.0 * pi << 4.0 << false;
    QTest::newRow("SICK TIM571") << 666 << -1.92 << 1.92 << 25.0 << true;
    QTest::newRow("narrow fan") << 50 << -0.05 << 0.05 << 30.0 << false;
    QTest::newRow("single beam") << 1 << 0.3 << 0.4 << 30.0 << false;
    QTest::newRow("four beams") << 4 << -pi << pi << 30.0 << false;
  }

  void turn_randomScenes_equalBeamsCastAlone() {
    QFETCH(int, beams);
    QFETCH(double, angleMin);
    QFETCH(double, angleMax);
    QFETCH(double, range);
    QFETCH(bool, legs);
    LidarParameters parameters = lidarOf(beams, angleMin, angleMax, range);
    parameters.legs = legs;
    int hits = 0;
    for (unsigned seed = 1; seed <= 15; ++seed) {
      std::mt19937 random(seed);
      Floor floor;
      addSolids(floor, random);
      addBodies(floor, random, 25, 6);
      for (int i = 0; i < 4; ++i) {
        const Pose2 pose{randomPlace(random), 1.7 * i - 3.0};
        const double worst = worstBeam(floor, parameters, pose, hits);
        QVERIFY2(worst <= kExact,
                 qPrintable(QStringLiteral("%1 m, scene %2").arg(worst).arg(seed)));
      }
    }
    QVERIFY(hits > 25 * beams);  // of 60 beams
  }

  void turn_closeToWallsAndInTheirLine_equalsBeamsCastAlone_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    // The box reaches from (-1, -0.5) to (1, 0.5).
    QTest::newRow("in line with a side") << 3.0 << 0.5;
    QTest::newRow("nearly in line") << 3.0 << 0.5 + 1e-6;
    QTest::newRow("in line from the other end") << -2.5 << -0.5;
    QTest::newRow("a micrometre from a side") << 0.2 << 0.5 + 1e-6;
    QTest::newRow("beside a corner") << 1.0 + 1e-7 << 0.5 + 1e-7;
    QTest::newRow("a millimetre from a corner") << 1.001 << 0.501;
  }

  void turn_closeToWallsAndInTheirLine_equalsBeamsCastAlone() {
    QFETCH(double, x);
    QFETCH(double, y);
    Floor floor;
    floor.obstacles.add({boxOutline({{0.0, 0.0}, 0.0}, 2.0, 1.0)});
    floor.obstacles.add({boxOutline({{4.0, 3.0}, 0.0}, 2.0, 5.0)});
    floor.obstacles.build();
    floor.polygons.build();
    int hits = 0;
    for (const double heading : {0.1, 0.7, 2.5, -1.3}) {
      const double worst = worstBeam(floor, lidarOf(721), {{x, y}, heading}, hits);
      QVERIFY2(worst <= kExact, qPrintable(QString::number(worst)));
    }
    QVERIFY(hits > 100);
  }

  /// No beam slips between two walls that meet: edges are a nanometre longer than they are.
  void turn_beamPastACorner_isWidenedAsRaysAre() {
    for (const double side : {-1.0, 1.0}) {
      for (const double gap : {5e-10, 5e-9}) {
        Obstacles box;  // its corner at (3, gap) or (3, -gap), beside the beam ahead
        box.add({boxOutline({{3.5, side * (gap + 0.5)}, 0.0}, 1.0, 1.0)});
        box.build();
        const double expected = gap < 1e-9 ? 3.0 : 30.0;
        QVERIFY(std::fabs(box.raycast({0.0, 0.0}, {1.0, 0.0}, 30.0) - expected) < kExact);
        const LaserScan scan = turnAt({}, lidarOf(4, 0.0, 2.0 * base::kPi), box, {});
        QVERIFY(std::fabs(scan.distances[0] - expected) < kExact);
      }
    }
  }

  void turn_discOnTheSeam_isSeenFromBothSides() {
    Obstacles none;
    none.build();
    const std::vector<SensedBody> bodies = {personAt(1, {-3.0, 0.0})};
    const LaserScan scan = turnAt({}, lidarOf(360), none, bodies);
    QVERIFY(std::fabs(scan.distances[0] - 2.7) < kExact);
    const double degree = base::kPi / 180.0;
    for (int i = 1; i <= 6; ++i) {
      // 3 sin 5° = 0.26 < 0.3 < 3 sin 6° = 0.31
      const double aside = 3.0 * std::sin(i * degree);
      const double expected =
          i <= 5 ? 3.0 * std::cos(i * degree) - std::sqrt(0.09 - aside * aside) : 30.0;
      QVERIFY(std::fabs(scan.distances[static_cast<std::size_t>(i)] - expected) < kExact);
      QVERIFY(std::fabs(scan.distances[static_cast<std::size_t>(360 - i)] - expected) < kExact);
    }
    QCOMPARE(static_cast<int>(std::count(scan.distances.begin(), scan.distances.end(), 30.0)), 349);
  }

  void turn_beamsOfFan_standFromEndToEnd() {
    const Obstacles room = emptyRoom();
    const double quarter = base::kPi / 4.0;
    const LaserScan fan = turnAt({}, lidarOf(3, -quarter, quarter), room, {});
    QCOMPARE(fan.angleMin, -quarter);
    QCOMPARE(fan.angleIncrement, quarter);
    QVERIFY(std::fabs(fan.distances[0] - 4.0 * std::sqrt(2.0)) < kExact);  // into the corner
    QVERIFY(std::fabs(fan.distances[1] - 4.0) < kExact);
    QVERIFY(std::fabs(fan.distances[2] - 4.0 * std::sqrt(2.0)) < kExact);
    const LaserScan around = turnAt({}, lidarOf(8), room, {});
    QCOMPARE(around.angleIncrement, quarter);  // the last beam is not the first one again
  }

  void turn_insideSomething_isZero() {
    Obstacles none;
    none.build();
    Obstacles box;
    box.add({boxOutline({{0.0, 0.0}, 0.3}, 2.0, 1.0)});
    box.build();
    QVERIFY(areAll(turnAt({}, lidarOf(90), box, {}).distances, 0.0));
    QVERIFY(areAll(turnAt({}, lidarOf(90), none, {personAt(1, {0.1, 0.2})}).distances, 0.0));
    const Footprint square{0.0, {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
    SensedBody robot = personAt(7, {0.9, 0.0}, 0.4);
    robot.kind = BodyKind::Robot;
    robot.footprint = &square;
    QVERIFY(areAll(turnAt({}, lidarOf(90), none, {robot}).distances, 0.0));
    // In the disc of a person, between the legs: they are what is seen.
    LidarParameters shin = lidarOf(4);
    shin.legs = true;
    const LaserScan between = turnAt({}, shin, none, {personAt(1, {0.0, 0.0})});
    QCOMPARE(between.distances[0], 30.0);                      // behind
    QVERIFY(std::fabs(between.distances[1] - 0.04) < kExact);  // to the right
    QCOMPARE(between.distances[2], 30.0);                      // ahead
    QVERIFY(std::fabs(between.distances[3] - 0.04) < kExact);  // to the left
  }

  void turn_nothingInRange_isTheRange() {
    Obstacles none;
    none.build();
    const LidarParameters parameters = lidarOf(77, -base::kPi, base::kPi, 3.7);
    QVERIFY(areAll(turnAt({}, parameters, none, {}).distances, 3.7));
    const std::vector<SensedBody> far = {personAt(1, {4.1, 0.0})};
    QVERIFY(areAll(turnAt({}, parameters, emptyRoom(), far).distances, 3.7));
    QVERIFY(
        !areAll(turnAt({}, parameters, emptyRoom(), {personAt(1, {-3.9, 0.0})}).distances, 3.7));
  }

  void turn_doorOpens_isSeenThrough() {
    Obstacles obstacles;
    obstacles.add({boxOutline({{6.0, 0.0}, 0.0}, 0.2, 20.0)});
    const int door = obstacles.add({boxOutline({{3.0, 0.0}, 0.0}, 0.2, 20.0)});
    obstacles.build();
    Lidar lidar(lidarOf(4), 1, 1);
    const std::vector<SensedBody> nobody;
    const auto ahead = [&](double time) {
      lidar.update({{}, {}, obstacles, nobody, time});
      return lidar.scan()->distances[2];
    };
    QVERIFY(std::fabs(ahead(0.0) - 2.9) < kExact);
    obstacles.setEnabled(door, false);
    QVERIFY(std::fabs(ahead(0.1) - 5.9) < kExact);
    obstacles.setEnabled(door, true);
    QVERIFY(std::fabs(ahead(0.2) - 2.9) < kExact);
  }

  void turn_longWay_seesTheWallsThatCome() {
    std::mt19937 random(3);
    Floor floor;
    addSolids(floor, random);
    floor.polygons.build();
    const LidarParameters parameters = lidarOf(180, -base::kPi, base::kPi, 3.0);
    Lidar lidar(parameters, 5, 99);
    const LegGait gait(5);
    int hits = 0;
    for (int step = 0; step < 200; ++step) {
      const Pose2 pose{{-9.5 + 0.1 * step, 0.05 * step - 5.0}, 0.1 * step};
      QVERIFY(lidar.update({pose, pose, floor.obstacles, floor.bodies, 0.1 * step}));
      for (std::size_t i = 0; i < 180; ++i) {
        const double angle =
            pose.heading - base::kPi + static_cast<double>(i) * lidar.scan()->angleIncrement;
        const double expected =
            castAlone(floor, parameters, gait, pose.position, base::directionOf(angle));
        QVERIFY(std::fabs(lidar.scan()->distances[i] - expected) <= kExact);
        hits += expected < 3.0 ? 1 : 0;
      }
    }
    QVERIFY(hits > 2000);
  }

  void turn_mountAndOdometry_areKept() {
    Obstacles wall;
    wall.add({boxOutline({{5.5, 0.0}, 0.0}, 1.0, 20.0)});
    wall.build();
    LidarParameters parameters = lidarOf(4);
    parameters.mount = {{0.2, 0.1}, -base::kPi / 2.0};
    Lidar lidar(parameters, 1, 1);
    const Pose2 pose{{1.0, 2.0}, base::kPi / 2.0};
    const Pose2 odometry{{11.0, 2.0}, 0.0};
    const std::vector<SensedBody> nobody;
    QVERIFY(lidar.scan() == nullptr);
    QVERIFY(lidar.update({pose, odometry, wall, nobody, 0.3}));
    // The sensor is at (0.9, 2.2) and looks along +x; it takes itself to be at (11.2, 2.1).
    QVERIFY(std::fabs(lidar.scan()->distances[2] - 4.1) < kExact);
    QVERIFY((lidar.scan()->sensor.position - Vec2(11.2, 2.1)).norm() < kExact);
    QCOMPARE(lidar.scan()->sensor.heading, -base::kPi / 2.0);
    QCOMPARE(lidar.scan()->time, 0.3);
  }

  void turn_ownBody_isLeftOut() {
    SensedBody self = personAt(1, {0.0, 0.0});
    self.kind = BodyKind::Robot;
    SensedBody other = self;
    other.id = 2;
    other.position = {2.0, 0.0};
    const LaserScan scan =
        turnAt({}, lidarOf(4), emptyRoom(), {personAt(1, {-2.0, 0.0}), self, other});
    QVERIFY(std::fabs(scan.distances[0] - 1.7) < kExact);  // the person of the same number
    QVERIFY(std::fabs(scan.distances[1] - 4.0) < kExact);
    QVERIFY(std::fabs(scan.distances[2] - 1.7) < kExact);
  }

  void update_rates_turnsAreDueWithoutDrift_data() {
    QTest::addColumn<double>("rate");
    QTest::newRow("each second step") << 10.0;
    QTest::newRow("not a multiple") << 7.0;
    QTest::newRow("a third") << 20.0 / 3.0;
    QTest::newRow("as the steps") << 20.0;
    QTest::newRow("faster than the steps") << 50.0;
  }

  void update_rates_turnsAreDueWithoutDrift() {
    QFETCH(double, rate);
    const Obstacles room = emptyRoom();
    const std::vector<SensedBody> nobody;
    LidarParameters parameters = lidarOf(4);
    parameters.rate = rate;
    Lidar lidar(parameters, 1, 1);
    // In whole 1/60000 s, so without rounding: a step is 3000, a turn 60000 / rate.
    const long turn = std::lround(60000.0 / rate);
    const bool isWhole = std::fabs(60000.0 / rate - static_cast<double>(turn)) < 1e-6;
    long before = -1;
    for (long step = 0; step <= 20000; ++step) {
      const double time = static_cast<double>(step) * 0.05;
      const long due = isWhole ? step * 3000 / turn : step * 7 / 20;  // turns begun by then
      QCOMPARE(lidar.update({{}, {}, room, nobody, time}), due > before);
      if (due > before) {
        QCOMPARE(lidar.scan()->time, time);
      }
      before = due;
    }
  }

  void noise_manyDraws_hasItsDeviation() {
    const Obstacles room = emptyRoom();
    const std::vector<SensedBody> nobody;
    LidarParameters parameters = lidarOf(360, -base::kPi, base::kPi, 5.5);  // corners are farther
    Lidar plain(parameters, 1, 1);
    plain.update({{}, {}, room, nobody, 0.0});
    parameters.noise = 0.02;
    Lidar noisy(parameters, 1, 1);
    double sum = 0.0;
    double squares = 0.0;
    double neighbours = 0.0;
    int count = 0;
    for (int turn = 0; turn < 40; ++turn) {
      noisy.update({{}, {}, room, nobody, 0.1 * turn});
      double last = 0.0;
      for (std::size_t i = 0; i < 360; ++i) {
        const double truth = plain.scan()->distances[i];
        if (truth == 5.5) {
          QCOMPARE(noisy.scan()->distances[i], 5.5);
        } else if (truth < 5.4) {  // not cut
          const double error = noisy.scan()->distances[i] - truth;
          sum += error;
          squares += error * error;
          neighbours += error * last;
          last = error;
          ++count;
        }
        QVERIFY(noisy.scan()->distances[i] <= 5.5);
      }
    }
    QVERIFY(count > 10000);
    // Four deviations of the mean, of the variance (chi-square), of the covariance of neighbours.
    const double n = count;
    const double variance = 0.02 * 0.02;
    QVERIFY(std::fabs(sum / n) < 4.0 * 0.02 / std::sqrt(n));
    QVERIFY(std::fabs(squares / n - variance) < 4.0 * variance * std::sqrt(2.0 / n));
    QVERIFY(std::fabs(neighbours / n) < 4.0 * variance / std::sqrt(n));
  }

  void noise_sameSeed_sameBytes() {
    std::mt19937 random(4);
    Floor floor;
    addSolids(floor, random);
    addBodies(floor, random, 20, 4);
    LidarParameters parameters;
    parameters.noise = 0.03;
    const auto turns = [&](std::uint64_t seed, int robot, int sensor) {
      Lidar lidar(parameters, seed, robot, sensor);
      std::vector<double> all;
      for (int step = 0; step < 20; ++step) {
        std::vector<SensedBody> bodies = floor.bodies;
        for (SensedBody& body : bodies) {
          body.position += 0.05 * step * body.velocity;
        }
        lidar.update({{}, {}, floor.obstacles, bodies, 0.05 * step});
        all.insert(all.end(), lidar.scan()->distances.begin(), lidar.scan()->distances.end());
      }
      return all;
    };
    const std::vector<double> first = turns(1, 90, 0);
    QVERIFY(!areAll(first, 0.0));
    QVERIFY(first == turns(1, 90, 0));
    QVERIFY(first != turns(2, 90, 0));
    QVERIFY(first != turns(1, 91, 0));
    QVERIFY(first != turns(1, 90, 1));
  }

  void legs_standing_areSideBySide() {
    Obstacles none;
    none.build();
    LidarParameters parameters = lidarOf(2, 0.0, std::atan2(0.1, 3.0));
    parameters.legs = true;
    // Looking our way: legs at (3, ±0.1); the beam ahead passes between.
    const LaserScan front = turnAt({}, parameters, none, {personAt(1, {3.0, 0.0}, base::kPi)});
    QCOMPARE(front.distances[0], 30.0);
    QVERIFY(std::fabs(front.distances[1] - (std::sqrt(9.01) - 0.06)) < kExact);
    // From the side: one behind the other.
    const LaserScan side = turnAt({}, parameters, none, {personAt(1, {3.0, 0.0}, base::kPi / 2.0)});
    QVERIFY(std::fabs(side.distances[0] - 2.84) < kExact);
    QCOMPARE(side.distances[1], 30.0);
  }

  void legs_anyStride_stayInTheDisc() {
    for (const double radius : {0.05, 0.12, 0.2, 0.3, 0.4, 0.6}) {
      double widest = 0.0;
      for (int i = 0; i < 100; ++i) {
        for (const double speed : {0.0, 0.5, 1.4, 3.0}) {
          SensedBody person = personAt(1, {5.0, -2.0}, 0.7, speed);
          person.radius = radius;
          const Legs legs = legsAt(person, 0.01 * i);
          for (const Vec2& leg : {legs.left, legs.right}) {
            QVERIFY((leg - person.position).norm() + legs.radius <= radius + 1e-12);
          }
          const Vec2 left = person.pose().toLocal(legs.left);
          QVERIFY(left.y() >= 0.0);
          QVERIFY((left + person.pose().toLocal(legs.right)).norm() < 1e-12);  // opposite
          QVERIFY(speed > 0.0 || left.x() == 0.0 || std::fabs(left.x()) < 1e-12);
          widest = std::max(widest, std::fabs(left.x()));
        }
      }
      QVERIFY(radius < 0.2 || widest > 0.09);  // they do swing
    }
  }

  void legs_walking_standOnTheGround() {
    // With room enough for the whole step, one leg or the other stands while the body goes on.
    std::vector<SensedBody> people = {personAt(4, {0.0, 0.0}, 0.0, 1.3)};
    people[0].radius = 1.0;
    LegGait gait(11);
    gait.update(people);
    Legs before = legsAt(people[0], gait.gaitPhase(0));
    int changes = 0;
    bool wasLeft = false;
    for (int step = 0; step < 2000; ++step) {
      people[0].position += Vec2(0.0065, 0.0);  // 5 ms
      gait.update(people);
      const Legs now = legsAt(people[0], gait.gaitPhase(0));
      const double left = (now.left - before.left).norm();
      const double right = (now.right - before.right).norm();
      const bool isLeft = left < right;
      QVERIFY(std::min(left, right) < 1e-9 ||
              std::fabs(left - right) < 0.013);  // stands, or changes
      changes += step > 0 && isLeft != wasLeft ? 1 : 0;
      wasLeft = isLeft;
      before = now;
    }
    // 13 m in steps of sqrt(0.39 * 1.3) = 0.712 m: 18.3 steps.
    QVERIFY(changes == 18 || changes == 19);
    // Standing still keeps them.
    const double stride = gait.gaitPhase(0);
    people[0].velocity = Vec2::Zero();
    gait.update(people);
    QCOMPARE(gait.gaitPhase(0), stride);
    // Others come and go without a change.
    people.insert(people.begin(), personAt(2, {3.0, 3.0}));
    gait.update(people);
    QCOMPARE(gait.gaitPhase(1), stride);
    people.erase(people.begin());
    gait.update(people);
    QCOMPARE(gait.gaitPhase(0), stride);
  }

  /// Grieve & Gear 1966 (Ergonomics 9): 64.8 V^0.57 strides a minute at V statures a second.
  void stepLength_walkingSpeeds_isThatOfGrieveAndGear() {
    for (const double speed : {0.6, 0.9, 1.2, 1.34, 1.6, 2.0}) {
      const double stature = 1.75;
      const double stridesPerSecond = 64.8 * std::pow(speed / stature, 0.57) / 60.0;
      const double expected = 0.5 * speed / stridesPerSecond;
      QVERIFY(std::fabs(stepLength(speed) - expected) < 0.07 * expected);
    }
    QCOMPARE(stepLength(0.0), 0.0);
  }

  void update_afterTheFirstTurn_allocatesNothing() {
    std::mt19937 random(6);
    Floor floor;
    addSolids(floor, random);
    addBodies(floor, random, 40, 6);
    LidarParameters parameters;
    parameters.noise = 0.01;
    Lidar lidar(parameters, 1, 99);
    const auto update = [&](int step) {
      const Pose2 pose{{0.005 * step, 0.0}, 0.1 * step};
      lidar.update({pose, pose, floor.obstacles, floor.bodies, 0.05 * step});
    };
    update(0);
    update(1);
    const long before = allocations;
    for (int step = 2; step < 100; ++step) {
      update(step);
    }
    QCOMPARE(static_cast<long>(allocations) - before, 0L);
  }

  /// Turns that nobody looked at leave nothing behind, in legs and errors neither.
  void update_readFromSomeTimeOn_isTheSame() {
    ReadAlwaysAndElse lidars;
    const auto use = [](int step) { return step >= 31 ? ScanDemand::Now : ScanDemand::None; };
    lidars.walk(60, use, [&](int step, bool isTurn, bool isTurnOfTheOther) {
      QCOMPARE(isTurn, step % 2 == 0);
      QCOMPARE(isTurnOfTheOther, isTurn && step >= 31);
      if (step < 32) {
        QVERIFY(lidars.other.scan() == nullptr);
      } else {
        QVERIFY(lidars.areScansEqual());
      }
    });
  }

  /// What was for later is there as soon as somebody looks, also between turns.
  void update_nowAfterLater_isTheLastTurn() {
    ReadAlwaysAndElse lidars;
    const auto isNow = [](int step) { return step == 3 || step == 7; };
    const auto use = [&](int step) { return isNow(step) ? ScanDemand::Now : ScanDemand::Later; };
    lidars.walk(8, use, [&](int step, bool /*isTurn*/, bool isTurnOfTheOther) {
      QVERIFY(!isTurnOfTheOther);
      QCOMPARE(lidars.other.deferredSnapshot() == nullptr, isNow(step));
      if (isNow(step)) {
        QVERIFY(lidars.areScansEqual());
      } else {
        QVERIFY(lidars.other.deferredSnapshot()->time == lidars.always.scan()->time);
      }
    });
  }
};

QTEST_GUILESS_MAIN(LidarTest)
#include "tst_Lidar.moc"
