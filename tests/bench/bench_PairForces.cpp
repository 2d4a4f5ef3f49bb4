#include <cmath>
#include <vector>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/world/DensityForce.h"

using namespace sim2d;

/// What one neighbour costs in `das`, beside the plain sum of social forces; finding neighbours
/// does not count.
class PairForcesBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void densityForce_perNeighbour_data();
  void densityForce_perNeighbour();
};

namespace {

constexpr int kRounds = 7;
constexpr int kRepeats = 2000;

/// Evenly spread over the disc of the neighbours, half of them oncoming.
std::vector<Pedestrian> neighbours(int count) {
  std::vector<Pedestrian> found;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.39996323 * i;
    const double distance = kDensityRange * std::sqrt((i + 0.5) / count);
    const Vec2 way(i % 2 == 0 ? 1.0 : -1.0, 0.0);
    Pedestrian other;
    other.body = {i + 1, distance * Vec2(std::cos(angle), std::sin(angle)), 1.2 * way, 0.2};
    other.desired = {way, way, 1.3, -1, false};
    found.push_back(other);
  }
  return found;
}

template <typename Work>
double nanosecondsOf(const Work& work) {
  double best = 1e18;
  for (int round = 0; round < kRounds; ++round) {
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < kRepeats; ++i) {
      work();
    }
    best = std::min(best, static_cast<double>(timer.nsecsElapsed()) / kRepeats);
  }
  return best;
}

}  // namespace

void PairForcesBench::densityForce_perNeighbour_data() {
  QTest::addColumn<int>("count");
  for (const int count : {8, 40, 160}) {
    QTest::addRow("%d neighbours", count) << count;
  }
}

void PairForcesBench::densityForce_perNeighbour() {
  QFETCH(int, count);
  const std::vector<Pedestrian> others = neighbours(count);
  const DensityParameters parameters;
  Pedestrian self;
  self.body = {0, Vec2::Zero(), Vec2(1.2, 0.1), 0.2};
  self.desired = {Vec2(1.0, 0.0), Vec2(1.0, 0.0), 1.3, -1, false};
  Vec2 sum = Vec2::Zero();
  const double das =
      nanosecondsOf([&] { sum += densityForce(parameters, self, others).social; }) / count;
  const double sfm = nanosecondsOf([&] {
                       for (const Pedestrian& other : others) {
                         sum += socialForce(parameters.social, self.body, other.body);
                       }
                     }) /
                     count;
  QVERIFY(sum.allFinite());
  qInfo("das %.0f ns, sfm %.0f ns per neighbour, ratio %.2f", das, sfm, das / sfm);
  QTest::setBenchmarkResult(das, QTest::WalltimeNanoseconds);
}

QTEST_APPLESS_MAIN(PairForcesBench)
#include "bench_PairForces.moc"
