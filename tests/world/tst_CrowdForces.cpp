#include <algorithm>
#include <cmath>
#include <cstring>

#include <QtTest>

#include "sim2d/world/crowd/CrowdForces.h"
#include "tests/support/Columns.h"

Q_DECLARE_METATYPE(base::Vec2)

using namespace sim2d;

namespace {

/// Numbers that look random, the same on every machine.
class Draws {
 public:
  explicit Draws(std::uint32_t seed) : state_(seed) {}
  double between(double low, double high) {
    state_ = state_ * 1664525U + 1013904223U;
    return low + (high - low) * (state_ >> 8U) / 16777216.0;
  }

 private:
  std::uint32_t state_;
};

/// Two opposing streams on a square, half a person per square metre, from a jittered grid.
struct Crowd {
  std::vector<Walker> walkers;
  std::vector<char> present;
  std::vector<ForceParameters> parameters;
  std::vector<CrowdForceModel> forceModels;
  std::vector<double> room;
  double size = 0.0;  // of the square [m]

  explicit Crowd(int count) : size(std::sqrt(count / 0.5)) {
    Draws draws(3);
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    const double gap = size / side;
    for (int i = 0; i < count; ++i) {
      Walker walker;
      walker.id = i;
      const int row = i / side;
      // One after the other: compilers differ in the order of arguments.
      const double y = draws.between(0.25, 0.75);
      const double x = draws.between(0.25, 0.75);
      walker.position = Vec2((i % side + x) * gap, (row + y) * gap);
      const double sideways = draws.between(-0.2, 0.2);
      walker.velocity = Vec2(draws.between(0.0, 1.0) < 0.5 ? 1.3 : -1.3, sideways);
      walkers.push_back(walker);
    }
    present.assign(walkers.size(), 1);
    parameters.resize(walkers.size());
    room.assign(walkers.size(), 1e9);
    connect();
  }
  void connect() {
    forceModels.resize(walkers.size());
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      forceModels[i].parameters = &parameters[i];
    }
  }
};

bool seesAll(std::size_t /*self*/, std::size_t /*other*/) {
  return true;
}

using Sight = std::function<bool(std::size_t, std::size_t)>;

std::vector<Vec2> fastForces(const Crowd& crowd, const Sight& isVisible = seesAll,
                             SimdLevel path = fastestSimdLevel(), int threads = 1) {
  CrowdForces forces(path);
  WorkerPool workers(threads);
  forces.compute({crowd.walkers, crowd.present, crowd.forceModels, crowd.room, isVisible}, workers);
  return forces.forces();
}

/// The sum as written in SocialForce.h over every pair.
std::vector<Vec2> exactForces(const Crowd& crowd, const Sight& isVisible = seesAll) {
  std::vector<Vec2> sums(crowd.walkers.size(), Vec2::Zero());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      if (i != k && crowd.present[i] != 0 && crowd.present[k] != 0 &&
          crowd.forceModels[i].parameters != nullptr &&
          (crowd.forceModels[i].goesThroughWalls || isVisible(i, k))) {
        sums[i] +=
            socialForce(*crowd.forceModels[i].parameters, crowd.walkers[i], crowd.walkers[k]);
      }
    }
  }
  return sums;
}

double rms(const std::vector<Vec2>& values) {
  double sum = 0.0;
  for (const Vec2& value : values) {
    sum += value.squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// RMS of the difference over the RMS of the exact forces.
double errorOf(const std::vector<Vec2>& found, const std::vector<Vec2>& exact) {
  std::vector<Vec2> difference;
  for (std::size_t i = 0; i < found.size(); ++i) {
    difference.push_back(found[i] - exact[i]);
  }
  return rms(difference) / rms(exact);
}

bool areSameBits(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec2)) == 0;
}

/// One step of the streams: towards their side at 1.3 m/s, which is also the fastest; who leaves
/// on one side comes in on the other.
void move(Crowd& crowd, const std::vector<Vec2>& social, const std::vector<double>& wantedSpeed) {
  constexpr double kStep = 0.05;
  for (std::size_t i = 0; i < crowd.walkers.size(); ++i) {
    Walker& walker = crowd.walkers[i];
    const Vec2 wanted(wantedSpeed[i], 0.0);
    walker.velocity += (2.0 * (wanted - walker.velocity) / 0.5 + social[i]) * kStep;
    const double speed = walker.velocity.norm();
    if (speed > 1.3) {
      walker.velocity *= 1.3 / speed;
    }
    walker.position += walker.velocity * kStep;
    if (walker.position.x() < 0.0) {
      walker.position.x() += crowd.size;
    } else if (walker.position.x() >= crowd.size) {
      walker.position.x() -= crowd.size;
    }
    walker.position.y() = std::clamp(walker.position.y(), -0.3, crowd.size + 0.3);
  }
}

std::vector<double> speedsOf(const Crowd& crowd) {
  std::vector<double> speeds;
  for (const Walker& walker : crowd.walkers) {
    speeds.push_back(walker.velocity.x() > 0.0 ? 1.3 : -1.3);
  }
  return speeds;
}

/// Streams as they are after ten seconds.
Crowd developedCrowd(int count) {
  Crowd crowd(count);
  const std::vector<double> speeds = speedsOf(crowd);
  for (int step = 0; step < 200; ++step) {
    move(crowd, fastForces(crowd), speeds);
  }
  return crowd;
}

/// Forces are opposite in a pair of equals, so each is computed once; left out is what is below
/// 1e-8 of k_s.
std::vector<Vec2> pairwiseForces(const Crowd& crowd) {
  const double farAway = cutOff(1e-8);
  std::vector<Vec2> sums(crowd.walkers.size(), Vec2::Zero());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    for (std::size_t k = i + 1; k < sums.size(); ++k) {
      const ForceParameters& parameters = crowd.parameters[i];
      if (!isNegligible(parameters, crowd.walkers[i], crowd.walkers[k], farAway)) {
        const Vec2 force = socialForce(parameters, crowd.walkers[i], crowd.walkers[k]);
        sums[i] += force;
        sums[k] -= force;
      }
    }
  }
  return sums;
}

}  // namespace

class CrowdForcesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void compute_developedStreams_withinAQuarterPercent() {
    const Crowd crowd = developedCrowd(1000);
    const double error = errorOf(fastForces(crowd), exactForces(crowd));
    QVERIFY2(error <= 0.0025, qPrintable(QString::number(error)));
  }

  void compute_farFromTheOrigin_withinAQuarterPercent() {
    Crowd crowd = developedCrowd(400);
    for (Walker& walker : crowd.walkers) {
      walker.position += Vec2(4e6, -5e5);
    }
    const double error = errorOf(fastForces(crowd), exactForces(crowd));
    QVERIFY2(error <= 0.0025, qPrintable(QString::number(error)));
  }

  void compute_mixedPeople_withinAQuarterPercent() {
    Crowd crowd = developedCrowd(500);
    Draws draws(3);
    for (std::size_t i = 0; i < crowd.walkers.size(); ++i) {
      crowd.parameters[i].socialFactor = draws.between(3.0, 20.0);
      crowd.parameters[i].gamma = draws.between(0.2, 0.5);
      crowd.parameters[i].lambda = draws.between(1.0, 3.0);
      crowd.walkers[i].velocity *= draws.between(0.0, 1.6);
      crowd.present[i] = i % 9 == 0 ? 0 : 1;
      if (i % 7 == 0) {
        crowd.forceModels[i].parameters = nullptr;
      }
    }
    const std::vector<Vec2> found = fastForces(crowd);
    const double error = errorOf(found, exactForces(crowd));
    QVERIFY2(error <= 0.0025, qPrintable(QString::number(error)));
    QCOMPARE(found[0], Vec2(Vec2::Zero()));
    QCOMPARE(found[7], Vec2(Vec2::Zero()));
  }

  void compute_wallBetween_cutsTheForce() {
    Crowd crowd = developedCrowd(500);
    const double middle = crowd.size / 2.0;
    for (std::size_t i = 0; i < crowd.walkers.size(); ++i) {
      crowd.room[i] = std::fabs(crowd.walkers[i].position.x() - middle);
      crowd.forceModels[i].goesThroughWalls = i % 5 == 0;
    }
    const Sight isOnTheSameSide = [&](std::size_t self, std::size_t other) {
      return (crowd.walkers[self].position.x() < middle) ==
             (crowd.walkers[other].position.x() < middle);
    };
    const std::vector<Vec2> exact = exactForces(crowd, isOnTheSameSide);
    const double error = errorOf(fastForces(crowd, isOnTheSameSide), exact);
    QVERIFY2(error <= 0.0025, qPrintable(QString::number(error)));
    QVERIFY(errorOf(fastForces(crowd), exact) > 0.05);
  }

  /// From this start no two meet so exactly that a hair decides the side on which they pass; where
  /// it does, single people end up elsewhere however small the error.
  void compute_thirtySeconds_positionsWithinACentimetre() {
    Crowd fast(1000);
    for (ForceParameters& parameters : fast.parameters) {
      parameters.socialFactor = 2.1;
      parameters.epsilon = 0.0;
    }
    Crowd exact(1000);
    exact.parameters = fast.parameters;
    exact.connect();
    const std::vector<double> speeds = speedsOf(fast);
    for (int step = 0; step < 600; ++step) {
      move(fast, fastForces(fast), speeds);
      move(exact, pairwiseForces(exact), speeds);
    }
    std::vector<Vec2> apart;
    for (std::size_t i = 0; i < fast.walkers.size(); ++i) {
      Vec2 difference = fast.walkers[i].position - exact.walkers[i].position;
      difference.x() = std::remainder(difference.x(), fast.size);
      apart.push_back(difference);
    }
    QVERIFY2(rms(apart) <= 0.01, qPrintable(QString::number(rms(apart))));
  }

  void compute_everyPath_givesTheSameBits_data() {
    QTest::addColumn<int>("path");
    for (const SimdLevel path : {SimdLevel::Avx2, SimdLevel::Avx512}) {
      QTest::newRow(simdLevelName(path)) << static_cast<int>(path);
    }
  }

  void compute_everyPath_givesTheSameBits() {
    QFETCH(int, path);
    const auto other = static_cast<SimdLevel>(path);
    if (!isSimdLevelSupported(other)) {
      QSKIP("This processor has no such instructions.");
    }
    Crowd crowd = developedCrowd(700);
    for (std::size_t i = 0; i < crowd.walkers.size(); ++i) {
      crowd.room[i] = i % 3 == 0 ? 2.0 : 0.5;
      crowd.parameters[i].socialFactor = 3.0 + static_cast<double>(i % 11);
    }
    const Sight seesSome = [](std::size_t self, std::size_t with) {
      return (self + with) % 4 != 0;
    };
    QVERIFY(areSameBits(fastForces(crowd, seesSome, SimdLevel::Sse2),
                        fastForces(crowd, seesSome, other)));
  }

  void compute_everyThreadCount_givesTheSameBits() {
    const Crowd crowd = developedCrowd(700);
    const std::vector<Vec2> one = fastForces(crowd);
    QVERIFY(areSameBits(one, fastForces(crowd, seesAll, fastestSimdLevel(), 2)));
    QVERIFY(areSameBits(one, fastForces(crowd, seesAll, fastestSimdLevel(), 8)));
  }

  /// What earlier steps left behind only says where nobody needs to be looked for.
  void compute_afterOtherSpeeds_givesTheSameBits() {
    const Crowd start = developedCrowd(900);
    CrowdForces forces;
    WorkerPool workers(2);
    const Sight isVisible = seesAll;
    for (int step = 0; step < 160; ++step) {
      Crowd crowd = start;
      const double faster = step < 10 ? 0.1 * step : step < 120 ? 0.7 : 1.2;
      for (Walker& walker : crowd.walkers) {
        walker.velocity *= faster;
      }
      forces.compute({crowd.walkers, crowd.present, crowd.forceModels, crowd.room, isVisible},
                     workers);
      if (step % 8 == 7) {
        QVERIFY2(areSameBits(forces.forces(), fastForces(crowd)),
                 qPrintable(QString::number(step)));
      }
    }
  }

  void speedBound_steps_followsTheFastest() {
    SpeedBound bound;
    QVERIFY(bound.update(1.0, 1000));
    QVERIFY(bound.value() > 1.0);
    QVERIFY(!bound.update(1.1, 1000));  // there is some room
    const double wide = bound.value();
    int changes = 0;
    for (int step = 0; step < 200; ++step) {
      const double fastest = step % 2 == 0 ? 0.9 : 1.0;
      changes += bound.update(fastest, 1000) ? 1 : 0;
      QVERIFY(bound.value() >= fastest);
    }
    QVERIFY(changes >= 1 && changes <= 2);  // becomes narrow and stays so
    QVERIFY(bound.value() < std::min(wide, 1.1));
    QVERIFY(bound.update(1.3, 1000));
    QVERIFY(bound.value() >= 1.3);
  }

  void compute_twoInOnePlace_partsThemAsOne() {
    Crowd crowd(2);
    crowd.walkers[1].position = crowd.walkers[0].position;
    crowd.walkers[0].velocity = crowd.walkers[1].velocity = Vec2::Zero();
    const std::vector<Vec2> found = fastForces(crowd);
    const std::vector<Vec2> exact = exactForces(crowd);
    QCOMPARE(found[0], exact[0]);
    QCOMPARE(found[1], exact[1]);
    QVERIFY(found[0].norm() > 1.0);
  }

  void compute_fewOrNobody_isFine() {
    QVERIFY(fastForces(Crowd(0)).empty());
    QCOMPARE(fastForces(Crowd(1)).front(), Vec2(Vec2::Zero()));
    Crowd absent(3);
    absent.present.assign(3, 0);
    QCOMPARE(fastForces(absent).back(), Vec2(Vec2::Zero()));
  }

  void compute_oneNeighbour_equalsThePair_data() {
    addColumns<Vec2, Vec2>({"apart", "velocity"});
    QTest::newRow("ahead, towards") << Vec2(2.0, 0.1) << Vec2(-1.3, 0.0);
    QTest::newRow("exactly head on") << Vec2(3.0, 0.0) << Vec2(-1.3, 0.0);
    QTest::newRow("beside") << Vec2(0.0, 0.8) << Vec2(1.3, 0.0);
    QTest::newRow("behind, faster") << Vec2(-1.0, 0.3) << Vec2(1.9, 0.0);
    QTest::newRow("behind, slower") << Vec2(-0.6, -0.2) << Vec2(0.4, 0.1);
    QTest::newRow("interaction vanishes") << Vec2(1.0, 0.0) << Vec2(1.8, 0.0);
    QTest::newRow("below") << Vec2(-0.3, -0.9) << Vec2(-0.2, 1.0);
  }

  /// Every direction of approach has its place in the formulae; each must come out as in double.
  void compute_oneNeighbour_equalsThePair() {
    QFETCH(Vec2, apart);
    QFETCH(Vec2, velocity);
    Crowd crowd(2);
    crowd.walkers[0].velocity = Vec2(1.3, 0.0);
    crowd.walkers[1].position = crowd.walkers[0].position + apart;
    crowd.walkers[1].velocity = velocity;
    for (const SimdLevel path : {SimdLevel::Sse2, SimdLevel::Avx2, SimdLevel::Avx512}) {
      if (isSimdLevelSupported(path)) {
        const std::vector<Vec2> found = fastForces(crowd, seesAll, path);
        const std::vector<Vec2> exact = exactForces(crowd);
        // Below the bound a pair may be left out: 5e-5 of k_s = 5.
        QVERIFY((found[0] - exact[0]).norm() < 1e-5 || exact[0].norm() < 5e-4);
        QVERIFY((found[1] - exact[1]).norm() < 1e-5 || exact[1].norm() < 5e-4);
      }
    }
  }
};

QTEST_APPLESS_MAIN(CrowdForcesTest)
#include "tst_CrowdForces.moc"
