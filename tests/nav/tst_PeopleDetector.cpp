#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include <QtTest>

#include "sim2d/base/Rng.h"
#include "sim2d/nav/PeopleDetector.h"

using namespace sim2d;

namespace {

/// No walls.
const Obstacles& openGround() {
  static const Obstacles kNone = [] {
    Obstacles none;
    none.build();
    return none;
  }();
  return kNone;
}

SensedBody bodyAt(int id, const Vec2& position, const Vec2& velocity = Vec2::Zero(),
                  double radius = 0.3) {
  SensedBody body;
  body.id = id;
  body.position = position;
  body.velocity = velocity;
  body.heading = base::headingOf(velocity);
  body.radius = radius;
  return body;
}

SensedBody robotAt(int id, const Vec2& position) {
  SensedBody robot = bodyAt(id, position);
  robot.kind = BodyKind::Robot;
  return robot;
}

/// Everything perfect but for what the test changes; a cycle at each step.
DetectorParameters perfect() {
  return groundTruthDetector();
}

/// Perfect but for the filter.
DetectorParameters filtered() {
  DetectorParameters parameters = groundTruthDetector();
  parameters.measuresVelocity = false;
  return parameters;
}

/// Perfect but for occlusion.
DetectorParameters occluded() {
  DetectorParameters parameters = groundTruthDetector();
  parameters.isOccluded = true;
  return parameters;
}

std::vector<int> idsOf(const std::vector<TrackedBody>& bodies) {
  std::vector<int> ids;
  ids.reserve(bodies.size());
  for (const TrackedBody& body : bodies) {
    ids.push_back(body.id);
  }
  return ids;
}

/// Ids of what a robot at the pose sees at once.
std::vector<int> seenFrom(const Pose2& pose, const DetectorParameters& parameters,
                          const std::vector<SensedBody>& bodies,
                          const Obstacles& obstacles = openGround()) {
  PeopleDetector detector(parameters, 1, 100);
  detector.update({pose, pose, obstacles, bodies, 0.0});
  return idsOf(detector.bodies());
}

using Ids = std::vector<int>;

bool isSame(const TrackedBody& a, const TrackedBody& b) {
  return a.id == b.id && a.kind == b.kind && a.position == b.position && a.velocity == b.velocity &&
         a.heading == b.heading && a.radius == b.radius;
}

/// A hundred people on a grid of 2 m.
std::vector<SensedBody> squad() {
  std::vector<SensedBody> people;
  people.reserve(100);
  for (int i = 0; i < 100; ++i) {
    const int row = i / 10;
    people.push_back(bodyAt(i + 1, {2.0 * (i % 10), 2.0 * row + 1.0}));
  }
  return people;
}

/// The share lies within four deviations of the binomial distribution of n draws.
bool isShare(int count, int n, double probability) {
  const double deviation = std::sqrt(probability * (1.0 - probability) / n);
  return std::fabs(static_cast<double>(count) / n - probability) < 4.0 * deviation;
}

}  // namespace

class PeopleDetectorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void groundTruth_movingBodies_isExact() {
    PeopleDetector detector(groundTruthDetector(), 1, 0);
    for (int step = 0; step < 50; ++step) {
      const double t = 0.05 * step;
      const std::vector<SensedBody> bodies = {
          bodyAt(3, {std::cos(t), 7.0 * t}, {-std::sin(t), 7.0}),
          bodyAt(8, {1e3 + t * t, 0.1}, {2.0 * t, 0.0}, 0.2), robotAt(5, {0.3, t})};
      detector.update({{{1.0, 2.0}, t}, {{1.0, 2.0}, t}, openGround(), bodies, t});
      QCOMPARE(detector.bodies().size(), bodies.size());
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const SensedBody& body = bodies[i];
        const TrackedBody expected{body.id,       body.kind,    body.position,
                                   body.velocity, body.heading, body.radius};
        QVERIFY(isSame(detector.bodies()[i], expected));
      }
    }
    // Who leaves the world is not told any more.
    detector.update({{}, {}, openGround(), {}, 3.0});
    QVERIFY(detector.bodies().empty());
  }

  void bodies_peopleAndRobots_areInOrderWithoutItself() {
    const std::vector<SensedBody> bodies = {bodyAt(2, {5.0, 0.0}), bodyAt(100, {4.0, 1.0}),
                                            robotAt(1, {3.0, 3.0}), robotAt(100, {0.0, 0.0})};
    PeopleDetector detector(perfect(), 1, 100);
    detector.update({{}, {}, openGround(), bodies, 0.0});
    QVERIFY(idsOf(detector.bodies()) == (Ids{2, 100, 1}));
    QVERIFY(detector.bodies()[1].kind == BodyKind::Person);
    QVERIFY(detector.bodies()[2].kind == BodyKind::Robot);
  }

  void sight_rangeAndField_areKept() {
    DetectorParameters parameters = perfect();
    parameters.range = 5.0;
    QVERIFY(seenFrom({}, parameters, {bodyAt(1, {4.99, 0.0}), bodyAt(2, {0.0, 5.01})}) == (Ids{1}));
    parameters.field = base::kPi / 2.0;
    const std::vector<SensedBody> around = {bodyAt(1, {2.0, 1.99}), bodyAt(2, {2.0, 2.01}),
                                            bodyAt(3, {2.0, -1.99}), bodyAt(4, {-2.0, 0.0})};
    QVERIFY(seenFrom({}, parameters, around) == (Ids{1, 3}));
    QVERIFY(seenFrom({{0.0, 0.0}, base::kPi}, parameters, around) == (Ids{4}));
  }

  void sight_walls_hide() {
    Obstacles wall;
    const int part = wall.add({boxOutline({{2.0, 0.0}, 0.0}, 0.2, 2.0)});
    wall.build();
    // From the origin its corner at (1.9, 1) hides what lies below the slope 1/1.9.
    const std::vector<SensedBody> bodies = {bodyAt(1, {4.0, 0.0}), bodyAt(2, {4.0, 2.0}),
                                            bodyAt(3, {4.0, 2.2}), bodyAt(4, {-4.0, 0.0})};
    DetectorParameters parameters = occluded();
    parameters.maxOcclusion = 1.0;
    QVERIFY(seenFrom({}, parameters, bodies, wall) == (Ids{3, 4}));
    QVERIFY(seenFrom({}, perfect(), bodies, wall) == (Ids{1, 2, 3, 4}));
    wall.setEnabled(part, false);
    QVERIFY(seenFrom({}, parameters, bodies, wall) == (Ids{1, 2, 3, 4}));
  }

  void sight_oneBodyBefore_hidesByAngle_data() {
    QTest::addColumn<double>("heading");  // of all, so that the seam is met as well
    QTest::newRow("ahead") << 0.0;
    QTest::newRow("to the left") << base::kPi / 2.0;
    QTest::newRow("across the seam") << base::kPi;
    QTest::newRow("on the seam's other side") << -base::kPi + 0.1;
  }

  void sight_oneBodyBefore_hidesByAngle() {
    QFETCH(double, heading);
    // Half angles: asin(0.3 / 2) = 0.150568 before, asin(0.3 / 4) = 0.075070 behind. The share that
    // is hidden when the bearings differ by d: (0.150568 + 0.075070 - d) / 0.150141.
    const auto seen = [&](double share, double threshold, double side) {
      const double bearing = side * (0.225638 - share * 0.150141);
      DetectorParameters parameters = occluded();
      parameters.maxOcclusion = threshold;
      return seenFrom({{0.0, 0.0}, heading}, parameters,
                      {bodyAt(1, 4.0 * base::directionOf(heading + bearing)),
                       bodyAt(2, 2.0 * base::directionOf(heading))});
    };
    for (const double side : {-1.0, 1.0}) {
      for (const double threshold : {0.1, 0.5, 0.9}) {
        QVERIFY(seen(threshold - 0.001, threshold, side) == (Ids{1, 2}));
        QVERIFY(seen(threshold + 0.001, threshold, side) == (Ids{2}));
      }
    }
  }

  void sight_twoBodiesBefore_areCountedOnce() {
    // At 2 m each hides 0.301 rad. Both hide the same 40 % of number 1: still seen. To either side
    // of it, each hides 30 %: together 60 %.
    const double half = std::asin(0.075);
    const double wide = std::asin(0.15);
    const auto at = [](double distance, double bearing) {
      return Vec2(distance * base::directionOf(bearing));
    };
    const double forty = wide + half - 0.4 * 2.0 * half;
    const double thirty = wide + half - 0.3 * 2.0 * half;
    const SensedBody far = bodyAt(1, at(4.0, 0.0));
    const double closer = std::asin(0.15) - std::asin(0.1);  // of a disc of 0.3 m at 3 m
    QVERIFY(seenFrom({}, occluded(),
                     {far, bodyAt(2, at(2.0, forty)), bodyAt(3, at(3.0, forty - closer))}) ==
            (Ids{1, 2}));  // 3 is behind 2, and hides up to the same bearing
    QVERIFY(
        seenFrom({}, occluded(), {far, bodyAt(2, at(2.0, thirty)), bodyAt(3, at(2.0, -thirty))}) ==
        (Ids{2, 3}));
  }

  void sight_polygonBefore_hides() {
    const Footprint plank{0.0, {{-0.1, -1.0}, {0.1, -1.0}, {0.1, 1.0}, {-0.1, 1.0}}};
    SensedBody robot = robotAt(7, {2.0, 0.0});
    robot.footprint = &plank;
    // Its corner (1.9, 1) is at the bearing 0.4845; the person at 0.47 is hidden to more than half,
    // at 0.50 to less.
    for (const double side : {-1.0, 1.0}) {
      const auto ids = [&](double bearing) {
        return seenFrom({}, occluded(),
                        {bodyAt(1, 4.0 * base::directionOf(side * bearing)), robot});
      };
      QVERIFY(ids(0.47) == (Ids{7}));
      QVERIFY(ids(0.50) == (Ids{1, 7}));
    }
    robot.heading = base::kPi / 2.0;  // end on
    QVERIFY(seenFrom({}, occluded(), {bodyAt(1, 4.0 * base::directionOf(0.47)), robot}) ==
            (Ids{1, 7}));
  }

  void odometry_wrongPose_movesWhatIsSeen() {
    const std::vector<SensedBody> bodies = {bodyAt(1, {3.0, 1.0}, {1.0, 0.0})};
    PeopleDetector detector(perfect(), 1, 100);
    detector.update({{{1.0, 1.0}, 0.0}, {{5.0, 5.0}, base::kPi / 2.0}, openGround(), bodies, 0.0});
    // Two metres ahead of (5, 5), which is +y there.
    QVERIFY((detector.bodies()[0].position - Vec2(5.0, 7.0)).norm() < 1e-12);
    QVERIFY((detector.bodies()[0].velocity - Vec2(0.0, 1.0)).norm() < 1e-12);
    QVERIFY(std::fabs(detector.bodies()[0].heading - base::kPi / 2.0) < 1e-12);
  }

  void misses_manyDraws_haveTheirShare() {
    DetectorParameters parameters = perfect();
    parameters.misses = 0.13;
    const std::vector<SensedBody> people = squad();
    PeopleDetector detector(parameters, 3, 0);
    int missed = 0;
    int again = 0;  // missed in this cycle and in the last one
    std::vector<int> before;
    for (int cycle = 0; cycle < 200; ++cycle) {
      detector.update({{}, {}, openGround(), people, 0.05 * cycle});
      std::vector<int> ids = idsOf(detector.bodies());
      missed += 100 - static_cast<int>(ids.size());
      for (int id = 1; cycle > 0 && id <= 100; ++id) {
        again += !std::binary_search(ids.begin(), ids.end(), id) &&
                         !std::binary_search(before.begin(), before.end(), id)
                     ? 1
                     : 0;
      }
      before = std::move(ids);
    }
    QVERIFY(isShare(missed, 20000, 0.13));
    QVERIFY(isShare(again, 19900, 0.13 * 0.13));
  }

  void noise_manyDraws_hasItsDeviation() {
    DetectorParameters parameters = perfect();
    parameters.noise = 0.05;
    const std::vector<SensedBody> people = squad();
    PeopleDetector detector(parameters, 4, 0);
    Vec2 sum = Vec2::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    constexpr int kDraws = 20000;
    for (int cycle = 0; cycle < kDraws / 100; ++cycle) {
      detector.update({{}, {}, openGround(), people, 0.05 * cycle});
      for (std::size_t i = 0; i < people.size(); ++i) {
        const Vec2 error = detector.bodies()[i].position - people[i].position;
        sum += error;
        squares += error * error.transpose();
      }
    }
    // Four deviations of a mean, of a variance (chi-square), of a covariance.
    const double n = kDraws;
    const double variance = 0.05 * 0.05;
    for (int axis = 0; axis < 2; ++axis) {
      QVERIFY(std::fabs(sum[axis] / n) < 4.0 * 0.05 / std::sqrt(n));
      QVERIFY(std::fabs(squares(axis, axis) / n - variance) < 4.0 * variance * std::sqrt(2.0 / n));
    }
    QVERIFY(std::fabs(squares(0, 1) / n) < 4.0 * variance / std::sqrt(n));
  }

  void swaps_closePair_haveTheirShare() {
    DetectorParameters parameters = perfect();
    parameters.swaps = 0.07;
    parameters.swapDistance = 0.8;
    std::vector<SensedBody> people;
    people.reserve(20);
    for (int pair = 0; pair < 10; ++pair) {  // 0.7 m apart, the pairs 5 m
      people.push_back(bodyAt(2 * pair + 1, {5.0 * pair, 0.0}));
      people.push_back(bodyAt(2 * pair + 2, {5.0 * pair + 0.5, 0.49}));
    }
    PeopleDetector detector(parameters, 5, 0);
    std::vector<double> places(20, 0.0);  // x by track
    int swaps = 0;
    constexpr int kCycles = 2000;
    for (int cycle = 0; cycle <= kCycles; ++cycle) {
      detector.update({{}, {}, openGround(), people, 0.05 * cycle});
      QCOMPARE(detector.bodies().size(), people.size());
      for (std::size_t i = 0; i < 20; ++i) {
        const double x = detector.bodies()[i].position.x();
        QCOMPARE(detector.bodies()[i].id, static_cast<int>(i) + 1);
        swaps += cycle > 0 && i % 2 == 0 && x != places[i] ? 1 : 0;
        places[i] = x;
      }
    }
    QVERIFY(isShare(swaps, 10 * kCycles, 0.07));
  }

  void swaps_apart_areNone() {
    DetectorParameters parameters = perfect();
    parameters.swaps = 1.0;
    parameters.swapDistance = 0.8;
    // Apart, or a person and a robot.
    const std::vector<SensedBody> bodies = {bodyAt(1, {0.0, 0.0}), bodyAt(2, {0.6, 0.6}),
                                            robotAt(3, {0.1, 0.0})};
    PeopleDetector detector(parameters, 6, 0);
    for (int cycle = 0; cycle < 100; ++cycle) {
      detector.update({{}, {}, openGround(), bodies, 0.05 * cycle});
      for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(detector.bodies()[i].position == bodies[i].position);
      }
    }
    // Of two who touch, one that is missed swaps nothing.
    parameters.misses = 1.0;
    PeopleDetector blind(parameters, 6, 0);
    blind.update({{}, {}, openGround(), {bodyAt(1, {0.0, 0.0}), bodyAt(2, {0.1, 0.0})}, 0.0});
    QVERIFY(blind.bodies().empty());
  }

  void latency_movingPerson_isToldLater_data() {
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("latency");
    QTest::addColumn<int>("stepsPerCycle");
    QTest::addColumn<int>("stepsLate");
    QTest::newRow("10 Hz, 0.3 s") << 10.0 << 0.3 << 2 << 6;
    QTest::newRow("10 Hz, 0.05 s") << 10.0 << 0.05 << 2 << 1;
    QTest::newRow("4 Hz, 0.25 s") << 4.0 << 0.25 << 5 << 5;
    QTest::newRow("between two steps") << 10.0 << 0.12 << 2 << 3;
    QTest::newRow("at once") << 20.0 << 0.0 << 1 << 0;
  }

  void latency_movingPerson_isToldLater() {
    QFETCH(double, rate);
    QFETCH(double, latency);
    QFETCH(int, stepsPerCycle);
    QFETCH(int, stepsLate);
    DetectorParameters parameters = perfect();
    parameters.rate = rate;
    parameters.latency = latency;
    PeopleDetector detector(parameters, 1, 0);
    for (int step = 0; step < 2000; ++step) {
      const double t = step * 0.05;
      detector.update({{}, {}, openGround(), {bodyAt(1, {0.01 * step, 2.0}, {0.2, 0.0})}, t});
      const int seenAt = step < stepsLate ? -1 : (step - stepsLate) / stepsPerCycle * stepsPerCycle;
      QCOMPARE(detector.bodies().size(), static_cast<std::size_t>(seenAt < 0 ? 0 : 1));
      if (seenAt >= 0) {
        QCOMPARE(detector.bodies()[0].position.x(), 0.01 * seenAt);
      }
    }
  }

  /// The textbook's matrices for both axes at once, against what the detector gives.
  void velocity_filtered_equalsAMatrixFilter() {
    DetectorParameters parameters = filtered();
    parameters.rate = 10.0;
    parameters.noise = 0.08;
    parameters.accelerationPower = 0.7;
    PeopleDetector detector(parameters, 9, 0);
    DetectorParameters seen = parameters;
    seen.measuresVelocity = true;  // the same places without a filter
    PeopleDetector places(seen, 9, 0);

    const double T = 0.1;
    Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
    F(0, 2) = F(1, 3) = T;
    Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
    Q.topLeftCorner<2, 2>().diagonal().setConstant(0.7 * T * T * T / 3.0);
    Q.topRightCorner<2, 2>().diagonal().setConstant(0.7 * T * T / 2.0);
    Q.bottomLeftCorner<2, 2>().diagonal().setConstant(0.7 * T * T / 2.0);
    Q.bottomRightCorner<2, 2>().diagonal().setConstant(0.7 * T);
    Eigen::Matrix<double, 2, 4> H = Eigen::Matrix<double, 2, 4>::Zero();
    H(0, 0) = H(1, 1) = 1.0;
    const Eigen::Matrix2d R = 0.0064 * Eigen::Matrix2d::Identity();
    Eigen::Vector4d x = Eigen::Vector4d::Zero();
    Eigen::Matrix4d P = Eigen::Matrix4d::Zero();
    for (int step = 0; step < 400; step += 2) {
      const double t = 0.05 * step;
      const std::vector<SensedBody> people = {
          bodyAt(1, {3.0 * std::cos(0.4 * t), 3.0 * std::sin(0.4 * t)})};
      detector.update({{}, {}, openGround(), people, t});
      places.update({{}, {}, openGround(), people, t});
      const Vec2 z = places.bodies()[0].position;
      if (step == 0) {
        x << z, Vec2::Zero();
        P = Eigen::Vector4d(0.0064, 0.0064, 1.0, 1.0).asDiagonal();
      } else {
        x = F * x;
        P = F * P * F.transpose() + Q;
        const Eigen::Matrix<double, 4, 2> K =
            P * H.transpose() * Eigen::Matrix2d(H * P * H.transpose() + R).inverse();
        x = Eigen::Vector4d(x + K * (z - H * x));
        P = Eigen::Matrix4d((Eigen::Matrix4d::Identity() - K * H) * P);
      }
      QVERIFY((detector.bodies()[0].position - x.head<2>()).norm() < 1e-9);
      QVERIFY((detector.bodies()[0].velocity - x.tail<2>()).norm() < 1e-9);
    }
  }

  /// Without errors of the places P settles at P_vv = q T / sqrt(12), which gives the gains 1 for
  /// the position and (3 - sqrt(3)) / T for the velocity.
  void velocity_steadyFilterWithoutErrors_hasTheGainsOfTheRiccatiEquation() {
    const double T = 0.1;
    ConstantVelocityFilter filter(0.0, 0.5);
    filter.start(Vec2::Zero());
    for (int i = 0; i < 100; ++i) {
      filter.predict(T);
      filter.correct(Vec2::Zero());
    }
    filter.predict(T);
    filter.correct({1.0, -2.0});
    const double gain = (3.0 - std::sqrt(3.0)) / T;
    QVERIFY((filter.position() - Vec2(1.0, -2.0)).norm() < 1e-9);
    QVERIFY((filter.velocity() - gain * Vec2(1.0, -2.0)).norm() < 1e-9);
  }

  void velocity_withoutNoise_isThatOfTheWay() {
    DetectorParameters parameters = filtered();
    parameters.rate = 20.0;
    PeopleDetector detector(parameters, 1, 0);
    for (int step = 0; step < 200; ++step) {
      const double t = 0.05 * step;
      // What it says its velocity is does not matter.
      detector.update({{}, {}, openGround(), {bodyAt(1, {1.2 * t, -0.5 * t}, {9.0, 9.0})}, t});
      QVERIFY((detector.bodies()[0].position - Vec2(1.2 * t, -0.5 * t)).norm() < 1e-12);
      QVERIFY(step > 0 || detector.bodies()[0].velocity.isZero(0.0));
    }
    QVERIFY((detector.bodies()[0].velocity - Vec2(1.2, -0.5)).norm() < 1e-6);
    QVERIFY(std::fabs(detector.bodies()[0].heading - std::atan2(-0.5, 1.2)) < 1e-6);
  }

  void heading_slowTrack_isKept() {
    PeopleDetector detector(filtered(), 1, 0);
    Vec2 place(0.0, 2.0);
    for (int step = 0; step < 200; ++step) {  // slows down to a halt in 5 s, then shuffles aside
      const Vec2 velocity = step < 100 ? Vec2(0.0, 1.0 - 0.01 * step) : Vec2(0.1, 0.0);
      place += 0.05 * velocity;
      detector.update({{}, {}, openGround(), {bodyAt(1, place)}, 0.05 * step});
    }
    QVERIFY((detector.bodies()[0].velocity - Vec2(0.1, 0.0)).norm() < 1e-6);
    QVERIFY(std::fabs(detector.bodies()[0].heading - base::kPi / 2.0) < 1e-6);
  }

  void coasting_hiddenPerson_goesOnAndEnds() {
    Obstacles wall;
    const int part = wall.add({boxOutline({{2.0, 0.0}, 0.0}, 0.2, 40.0)}, false);
    wall.build();
    DetectorParameters parameters = filtered();
    parameters.isOccluded = true;
    parameters.rate = 10.0;
    parameters.coastTime = 0.5;
    PeopleDetector detector(parameters, 1, 0);
    const auto update = [&](int step) {
      const double t = 0.05 * step;
      detector.update({{}, {}, wall, {bodyAt(1, {4.0, 1.5 * t})}, t});
    };
    for (int step = 0; step <= 100; ++step) {
      update(step);
    }
    wall.setEnabled(part, true);  // last seen at 5.0 s
    for (int step = 101; step <= 110; ++step) {
      update(step);
      QCOMPARE(detector.bodies().size(), std::size_t{1});
      const int turn = step / 2;
      const double cycle = 0.1 * turn;
      QVERIFY((detector.bodies()[0].position - Vec2(4.0, 1.5 * cycle)).norm() < 1e-6);
    }
    update(111);
    QCOMPARE(detector.bodies().size(), std::size_t{1});
    update(112);  // 5.6 s
    QVERIFY(detector.bodies().empty());
    wall.setEnabled(part, false);
    update(114);
    QVERIFY(idsOf(detector.bodies()) == (Ids{1}));
  }

  void update_sameSeed_sameBytes() {
    const auto run = [](std::uint64_t seed, int robot) {
      DetectorParameters parameters;
      parameters.range = 15.0;
      parameters.swaps = 0.2;
      PeopleDetector detector(parameters, seed, robot);
      std::vector<TrackedBody> all;
      for (int step = 0; step < 200; ++step) {
        std::vector<SensedBody> bodies;
        bodies.reserve(40);
        for (int i = 0; i < 40; ++i) {
          const base::AgentRng rng(1, i);
          const Vec2 start(rng.uniform(-12.0, 12.0, base::DrawPurpose::Test, 0),
                           rng.uniform(-12.0, 12.0, base::DrawPurpose::Test, 1));
          const Vec2 velocity(rng.uniform(-1.0, 1.0, base::DrawPurpose::Test, 2), 0.5);
          bodies.push_back(bodyAt(i, start + 0.05 * step * velocity, velocity));
        }
        detector.update({{}, {}, openGround(), bodies, 0.05 * step});
        all.insert(all.end(), detector.bodies().begin(), detector.bodies().end());
      }
      return all;
    };
    const auto areSame = [](const std::vector<TrackedBody>& a, const std::vector<TrackedBody>& b) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(), isSame);
    };
    const std::vector<TrackedBody> first = run(1, 7);
    QVERIFY(first.size() > 2000);
    QVERIFY(areSame(first, run(1, 7)));
    QVERIFY(!areSame(first, run(2, 7)));
    QVERIFY(!areSame(first, run(1, 8)));
  }

  /// Against marks on a fine scale; the ends of the intervals lie between the marks.
  void angularCover_randomIntervals_equalsSampling() {
    constexpr int kMarks = 720;
    const double perMark = 2.0 * base::kPi / kMarks;
    for (int round = 0; round < 200; ++round) {
      const base::AgentRng rng(77, round);
      AngularIntervalSet cover;
      std::vector<char> isHidden(kMarks, 0);
      std::uint32_t index = 0;
      const auto interval = [&] {
        const int first =
            static_cast<int>(rng.uniform(0.0, kMarks, base::DrawPurpose::Test, index++));
        const double most = round % 10 == 0 ? kMarks : 150.0;
        const int count =
            static_cast<int>(rng.uniform(0.0, most, base::DrawPurpose::Test, index++));
        return std::pair<int, int>(first, count);
      };
      for (int i = 0; i < round % 12; ++i) {
        const auto [first, count] = interval();
        cover.add(first * perMark - 5.0, count * perMark);  // any turn of the angle
        for (int mark = first; mark < first + count; ++mark) {
          isHidden[static_cast<std::size_t>(mark % kMarks)] = 1;
        }
      }
      for (int i = 0; i < 10; ++i) {
        const auto [first, count] = interval();
        int expected = 0;
        for (int mark = first; mark < first + count; ++mark) {
          expected += isHidden[static_cast<std::size_t>(mark % kMarks)];
        }
        QVERIFY(std::fabs(cover.covered(first * perMark - 5.0, count * perMark) -
                          expected * perMark) < 1e-9);
      }
    }
    AngularIntervalSet whole;
    whole.add(0.3, 2.0 * base::kPi);
    QVERIFY(std::fabs(whole.covered(-2.0, 4.0) - 4.0) < 1e-12);
  }
};

QTEST_GUILESS_MAIN(PeopleDetectorTest)
#include "tst_PeopleDetector.moc"
