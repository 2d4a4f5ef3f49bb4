#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/nav/Lidar.h"

using namespace sim2d;

/// A turn of a lidar among many walls and people, beside casting its beams one by one.
class LidarBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void turn_amongThousandPeople_data();
  void turn_amongThousandPeople();
};

namespace {

constexpr int kPlaces = 20;
constexpr int kRounds = 15;
constexpr double kSide = 45.0;  // [m]; a person on two square metres

/// Blocks of four edges each on the floor.
Obstacles blocks(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, kSide);
  std::uniform_real_distribution<double> size(0.1, 0.8);
  Obstacles obstacles;
  std::vector<Outline> outlines;
  outlines.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Pose2 centre{{place(random), place(random)}, place(random)};
    outlines.push_back(boxOutline(centre, size(random), size(random)));
  }
  obstacles.add(outlines);
  obstacles.build();
  return obstacles;
}

std::vector<SensedBody> crowd(int count) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(0.0, kSide);
  std::vector<SensedBody> people;
  people.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    SensedBody person;
    person.id = i + 1;
    person.position = {place(random), place(random)};
    person.heading = 0.1 * i;
    person.velocity = 1.2 * base::directionOf(person.heading);
    person.radius = 0.3;
    people.push_back(person);
  }
  return people;
}

std::vector<Pose2> freePlaces(const Obstacles& obstacles, const std::vector<SensedBody>& people) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(0.0, kSide);
  std::vector<Pose2> places;
  while (places.size() < kPlaces) {
    const Pose2 pose{{place(random), place(random)}, place(random)};
    bool isFree = obstacles.clearance(pose.position) > 0.2;
    for (const SensedBody& person : people) {
      isFree = isFree && (person.position - pose.position).norm() > 0.5;
    }
    if (isFree) {
      places.push_back(pose);
    }
  }
  return places;
}

double discDistance(const Vec2& from, const Vec2& direction, const SensedBody& body) {
  const Vec2 offset = body.position - from;
  const double aside = base::cross(direction, offset);
  const double inside = body.radius * body.radius - aside * aside;
  const double along = offset.dot(direction);
  return inside < 0.0 || along < 0.0 ? 1e9 : along - std::sqrt(inside);
}

double rayByRay(const Pose2& pose, const LidarParameters& lidar, const Obstacles& obstacles,
                const std::vector<SensedBody>& people) {
  double sum = 0.0;
  for (int i = 0; i < lidar.beams; ++i) {
    const double angle = pose.heading + lidar.angleMin + 2.0 * base::kPi / lidar.beams * i;
    const Vec2 direction = base::directionOf(angle);
    double distance = obstacles.raycast(pose.position, direction, lidar.range);
    for (const SensedBody& body : people) {
      distance = std::min(distance, discDistance(pose.position, direction, body));
    }
    sum += distance;
  }
  return sum;
}

}  // namespace

void LidarBench::turn_amongThousandPeople_data() {
  QTest::addColumn<double>("range");
  QTest::addColumn<bool>("legs");
  QTest::addColumn<double>("noise");
  QTest::newRow("10 m, discs") << 10.0 << false << 0.0;
  QTest::newRow("30 m, discs") << 30.0 << false << 0.0;
  QTest::newRow("30 m, legs") << 30.0 << true << 0.0;
  QTest::newRow("30 m, legs, noise") << 30.0 << true << 0.02;
}

void LidarBench::turn_amongThousandPeople() {
  QFETCH(double, range);
  QFETCH(bool, legs);
  QFETCH(double, noise);
  const Obstacles obstacles = blocks(500);
  const std::vector<SensedBody> people = crowd(1000);
  const std::vector<Pose2> places = freePlaces(obstacles, people);
  LidarParameters parameters;
  parameters.range = range;
  parameters.legs = legs;
  parameters.noise = noise;
  double sum = 0.0;
  double turn = 0.0;   // [µs]; the best of the rounds at each place, then the mean
  double first = 0.0;  // with the walls sought anew
  double rays = 0.0;
  for (const Pose2& pose : places) {
    Lidar lidar(parameters, 1, 1);
    double best = 1e18;
    for (int round = 0; round < kRounds; ++round) {
      QElapsedTimer timer;
      timer.start();
      QVERIFY(lidar.update({pose, pose, obstacles, people, 0.1 * round}));
      const double taken = 1e-3 * static_cast<double>(timer.nsecsElapsed());
      best = std::min(best, taken);
      first += round == 0 ? taken / kPlaces : 0.0;
    }
    turn += best / kPlaces;
    QElapsedTimer timer;
    timer.start();
    sum += rayByRay(pose, parameters, obstacles, people);
    rays += 1e-3 * static_cast<double>(timer.nsecsElapsed()) / kPlaces;
  }
  QVERIFY(sum > 0.0);
  qInfo("a turn %.1f us, the first %.1f us, ray by ray %.0f us, ratio %.0f", turn, first, rays,
        rays / turn);
  QTest::setBenchmarkResult(turn * 1e3, QTest::WalltimeNanoseconds);
}

QTEST_APPLESS_MAIN(LidarBench)
#include "bench_Lidar.moc"
