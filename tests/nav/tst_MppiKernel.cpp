#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <QtTest>

#include "sim2d/nav/mppi/MppiUpdate.h"
#include "tests/nav/MppiHandMade.h"
#include "tests/nav/MppiReference.h"

using namespace sim2d;

namespace {

constexpr int kSamples = 256;

void setDriveOf(MppiDrive& drive, int kind) {
  drive.isOmnidirectional = kind == 1;
  drive.isAckermann = kind == 2;
  drive.lateralStep = kind == 1 ? 0.05F : 0.0F;
  drive.highLateral = kind == 1 ? 1.0F : 0.0F;
  drive.mostCurvature = 1.25F;
}

/// A plan that stands still at the origin, looking along +x; nothing costs anything.
void clearCosts(mppitest::HandMade& scene) {
  scene.problem.start = {};
  scene.problem.costs = {};
  scene.problem.costs.goal = 0.0F;
  scene.problem.social = {};
  scene.problem.zoneCount = 0;
}

}  // namespace

/// The vector code of MPPI against plain loops in double precision (MppiReference.h), and its
/// instruction sets against each other.
class MppiKernelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void draw_anyDrive_agreesWithReference_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<bool>("isSocial");
    QTest::newRow("differential") << 0 << false;
    QTest::newRow("omnidirectional") << 1 << false;
    QTest::newRow("ackermann") << 2 << false;
    QTest::newRow("differential, comfort") << 0 << true;
    QTest::newRow("omnidirectional, comfort") << 1 << true;
  }

  void draw_anyDrive_agreesWithReference() {
    QFETCH(int, kind);
    QFETCH(bool, isSocial);
    mppitest::HandMade scene(7, isSocial);
    scene.discs = {{0.2F, 0.1F, 0.3F}, {-0.2F, 0.0F, 0.3F}};
    scene.problem.discs = scene.discs.data();
    scene.problem.discCount = 2;
    setDriveOf(scene.problem.drive, kind);
    mppitest::Columns columns(kSamples, scene.problem.steps);
    mppiKernelFor(fastestMppiSimdLevel()).draw(scene.problem, columns.view(), 0, kSamples);
    const auto expected = reference::rollAll(scene.problem, 0, kSamples);
    int differ = 0;
    for (int i = 0; i < kSamples; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double cost = static_cast<double>(columns.costs[at]);
      differ += std::fabs(cost - expected[at].cost) > 1e-3 * (1.0 + expected[at].cost) ? 1 : 0;
      for (int step = 0; step < scene.problem.steps; ++step) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto place =
              static_cast<std::size_t>(step) * static_cast<std::size_t>(kSamples) + at;
          const float value = columns.controls[axis][place];
          const double wanted = expected[at].controls[static_cast<std::size_t>(step)][axis];
          QVERIFY2(std::fabs(static_cast<double>(value) - wanted) < 2e-5,
                   qPrintable(QStringLiteral("%1 %2 %3: %4, not %5")
                                  .arg(i)
                                  .arg(step)
                                  .arg(axis)
                                  .arg(value)
                                  .arg(wanted)));
        }
      }
    }
    // A place beside a threshold (contact, inside the goal) may fall to the other side by rounding.
    QVERIFY2(differ <= kSamples / 50, qPrintable(QString::number(differ)));
  }

  void update_weightedMean_agreesWithReference() {
    mppitest::HandMade scene(4, false);
    scene.problem.costs.hit = 0.0F;  // its steps would make rounding visible
    scene.problem.costs.stop = 0.0F;
    mppitest::Columns columns(kSamples, scene.problem.steps);
    const MppiKernel kernel = mppiKernelFor(fastestMppiSimdLevel());
    kernel.draw(scene.problem, columns.view(), 0, kSamples);
    std::vector<float> weights(kSamples);
    mppiWeights(columns.costs.data(), kSamples, 0.3, weights.data());
    const auto expected = reference::meanOf(reference::rollAll(scene.problem, 0, kSamples), 0.3);
    double most = 0.0;
    for (std::size_t step = 0; step < expected.size(); ++step) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const float mean =
            kernel.sum(weights.data(), columns.controls[axis].data() + step * kSamples, kSamples);
        most = std::max(most, std::fabs(static_cast<double>(mean) - expected[step][axis]));
      }
    }
    QVERIFY2(most < 1e-4, qPrintable(QString::number(most)));
  }

  void draw_everyInstructionSet_hasEqualBits() {
    for (int kind = 0; kind < 3; ++kind) {
      mppitest::HandMade scene(6, true);
      setDriveOf(scene.problem.drive, kind);
      mppitest::Columns first(kSamples, scene.problem.steps);
      mppiKernelFor(MppiSimdLevel::Sse2).draw(scene.problem, first.view(), 0, kSamples);
      std::vector<float> weights(kSamples);
      mppiWeights(first.costs.data(), kSamples, 0.3, weights.data());
      const float mean = mppiKernelFor(MppiSimdLevel::Sse2)
                             .sum(weights.data(), first.controls[0].data(), kSamples);
      QVERIFY(*std::max_element(first.costs.begin(), first.costs.end()) > 0.0F);
      for (const MppiSimdLevel path : {MppiSimdLevel::Avx2, MppiSimdLevel::Avx512}) {
        if (!isMppiSimdLevelSupported(path)) {
          continue;
        }
        mppitest::Columns other(kSamples, scene.problem.steps);
        const MppiKernel kernel = mppiKernelFor(path);
        kernel.draw(scene.problem, other.view(), 0, kSamples);
        QVERIFY(other.costs == first.costs);
        QVERIFY(other.hits == first.hits);
        for (int axis = 0; axis < 3; ++axis) {
          QVERIFY(other.controls[axis] == first.controls[axis]);
        }
        QCOMPARE(kernel.sum(weights.data(), other.controls[0].data(), kSamples), mean);
      }
      double sum = 0.0;  // the same on every processor
      for (const float cost : first.costs) {
        sum += static_cast<double>(cost);
      }
      qInfo("kind %d: sum of costs %.9g, mean %.9g", kind, sum, static_cast<double>(mean));
    }
  }

  /// A drive without limits from a mean of zero: the controls are the noise.
  void draw_noise_hasTheMomentsOfItsLaw() {
    constexpr int kMany = 4096;
    mppitest::HandMade scene(0, false);
    MppiProblem& problem = scene.problem;
    problem.start.linear = problem.start.angular = 0.0F;
    problem.drive = {-100.0F, 100.0F, 100.0F, 0.0F, 100.0F, 100.0F, 0.0F, false, false, 0.0F};
    for (std::vector<float>& axis : scene.mean) {
      std::fill(axis.begin(), axis.end(), 0.0F);
    }
    mppitest::Columns columns(kMany, problem.steps);
    mppiKernelFor(fastestMppiSimdLevel()).draw(problem, columns.view(), 0, kMany);
    const double sigma[2] = {0.2, 0.4};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double sum = 0.0;
      double second = 0.0;
      double fourth = 0.0;
      double next = 0.0;
      const std::size_t count = columns.controls[axis].size() - kMany;
      for (std::size_t i = 0; i < count; ++i) {
        const double now = static_cast<double>(columns.controls[axis][i]) / sigma[axis];
        sum += now;
        second += now * now;
        fourth += now * now * now * now;
        next += now * static_cast<double>(columns.controls[axis][i + kMany]) / sigma[axis];
      }
      const auto n = static_cast<double>(count);
      // Deviations of the estimates: 56 steps with a correlation of 0.8 hold 6 to 12 free ones.
      QVERIFY(std::fabs(sum / n) < 0.025);
      QVERIFY(std::fabs(second / n - 1.0) < 0.03);
      QVERIFY(std::fabs(fourth / n - 3.0) < 0.25);
      QVERIFY(std::fabs(next / n - 0.8) < 0.03);
    }
  }

  void weigh_feasibleControls_keepsThem() {
    mppitest::HandMade scene(3, false);
    mppitest::Columns columns(kMppiColumns, scene.problem.steps);
    const MppiKernel kernel = mppiKernelFor(fastestMppiSimdLevel());
    kernel.draw(scene.problem, columns.view(), 0, kMppiColumns);
    mppitest::Columns again = columns;
    kernel.weigh(scene.problem, again.view(), 0, kMppiColumns);
    QVERIFY(again.controls[0] == columns.controls[0]);
    QVERIFY(again.controls[1] == columns.controls[1]);
  }

  /// Stands 1.2 m before the wall with a disc of 1 m: 0.2 m of 1/3 m are left, (1 - 0.6)² = 0.16;
  /// and 4.031 m from the goal.
  void weigh_straightAlongAWall_costsByHand() {
    mppitest::HandMade scene(0, false);
    clearCosts(scene);
    scene.discs = {{0.0F, 0.0F, 1.0F}};
    scene.problem.discs = scene.discs.data();
    scene.problem.costs.wall = 4.0F;
    scene.problem.costs.perWallRange = 3.0F;
    scene.problem.costs.goal = 5.0F;
    scene.problem.costs.end = 2.0F;
    mppitest::Columns columns(kMppiColumns, scene.problem.steps);
    mppiKernelFor(fastestMppiSimdLevel()).weigh(scene.problem, columns.view(), 0, kMppiColumns);
    const double expected = 4.0 * 0.16 + 7.0 * std::sqrt(16.25);
    QVERIFY(std::fabs(static_cast<double>(columns.costs[0]) - expected) < 2e-3);
    QCOMPARE(columns.hits[0], 0.0F);
  }

  void weigh_onePerson_costsByHand_data() {
    QTest::addColumn<QString>("term");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("vx");
    QTest::addColumn<double>("expected");
    // Touch at 0.6 m; weights 1; the robot stands at the origin, the person on the x axis.
    QTest::newRow("intimate, gap 0.225") << "intimate" << 0.825 << 0.0 << 0.5;
    QTest::newRow("intimate, gap 0.5") << "intimate" << 1.1 << 0.0 << 0.0;
    QTest::newRow("personal, gap 0.3") << "personal" << 0.9 << 0.0 << 0.5625;
    QTest::newRow("ahead of who walks here") << "space" << 1.0 << -1.0 << std::exp(-0.25);
    QTest::newRow("behind who walks away") << "space" << 1.0 << 1.0 << std::exp(-1.0);
    QTest::newRow("closing, 0.8 m at 1 m/s") << "touch" << 1.4 << -1.0 << 4.0 * (1.0 - 0.8 / 1.2);
    QTest::newRow("closing slowly") << "touch" << 1.4 << -0.2 << 0.0;
    QTest::newRow("going away") << "touch" << 1.4 << 1.0 << 0.0;
    QTest::newRow("relative speed") << "speed" << 0.9 << 0.5 << 0.25 * 0.75;
    QTest::newRow("on the strip") << "strip" << 1.0 << -1.0 << 0.6;
    QTest::newRow("behind the strip") << "strip" << 1.0 << 1.0 << 0.0;
    QTest::newRow("head on, gap 0.9") << "legible" << 1.5 << -1.0 << (1.0 - 0.9 * 0.2);
  }

  void weigh_onePerson_costsByHand() {
    QFETCH(QString, term);
    QFETCH(double, x);
    QFETCH(double, vx);
    QFETCH(double, expected);
    mppitest::HandMade scene(1, true);
    clearCosts(scene);
    for (MppiPerson& person : scene.people) {
      person.x = static_cast<float>(x);
      person.y = 0.0F;
      person.vx = static_cast<float>(vx);
      person.vy = 0.0F;
      person.hx = vx < 0.0 ? -1.0F : 1.0F;
      person.hy = 0.0F;
      person.front = 0.25F * 1.44269504F;  // variance 2 m²
      person.rear = 1.44269504F;           // variance 0.5 m²
    }
    MppiSocial& social = scene.problem.social;
    social.perPersonal = static_cast<float>(1.0 / 1.2);
    social.perIntimate = static_cast<float>(1.0 / 0.45);
    social.fromTouchTime = 3.0F;
    social.intimate = term == QStringLiteral("intimate") ? 1.0F : 0.0F;
    social.personal = term == QStringLiteral("personal") ? 1.0F : 0.0F;
    social.space = term == QStringLiteral("space") ? 1.0F : 0.0F;
    social.touchTime = term == QStringLiteral("touch") ? 1.0F : 0.0F;
    social.relativeSpeed = term == QStringLiteral("speed") ? 1.0F : 0.0F;
    social.strip = term == QStringLiteral("strip") ? 1.0F : 0.0F;
    social.legible = term == QStringLiteral("legible") ? 1.0F : 0.0F;
    mppitest::Columns columns(kMppiColumns, scene.problem.steps);
    mppiKernelFor(fastestMppiSimdLevel()).weigh(scene.problem, columns.view(), 0, kMppiColumns);
    // Legibility counts early steps more; over the even steps of 56 the mean weight is 2 - 54 / 56.
    const double early = term == QStringLiteral("legible") ? 2.0 - 54.0 / 56.0 : 1.0;
    QVERIFY2(std::fabs(static_cast<double>(columns.costs[0]) - expected * early) < 1e-4,
             qPrintable(QString::number(static_cast<double>(columns.costs[0]))));
  }

  void weights_twoCosts_haveTheRatioOfTheLaw() {
    const std::vector<float> costs = {5.0F, 5.3F, 500.0F};
    std::vector<float> weights(3);
    mppiWeights(costs.data(), 3, 0.3, weights.data());
    // e^0 : e^-1 : nothing
    QVERIFY(std::fabs(static_cast<double>(weights[0]) - 1.0 / (1.0 + std::exp(-1.0))) < 1e-6);
    QVERIFY(std::fabs(static_cast<double>(weights[1] / weights[0]) - std::exp(-1.0)) < 1e-6);
    QCOMPARE(weights[2], 0.0F);
  }

  /// u' Sigma^-1 epsilon with the covariance keep^|i - j| written out for three steps: its inverse
  /// is tridiagonal, [1, -k, 0; -k, 1 + k², -k; 0, -k, 1] / (1 - k²).
  void pull_whiteAndCorrelated_matchesTheInverseCovariance() {
    const double k = 0.6;
    const double fresh = 0.8;
    const std::array<double, 3> u = {0.5, 0.7, -0.2};
    const std::array<double, 3> n = {1.1, -0.4, 0.3};
    const std::array<double, 3> drift = {n[0], k * n[0] + fresh * n[1],
                                         k * (k * n[0] + fresh * n[1]) + fresh * n[2]};
    const double scale = 1.0 / (1.0 - k * k);
    const double expected =
        scale * (u[0] * (drift[0] - k * drift[1]) +
                 u[1] * (-k * drift[0] + (1.0 + k * k) * drift[1] - k * drift[2]) +
                 u[2] * (-k * drift[1] + drift[2]));
    std::vector<float> pull;
    mppiControlCost({0.5F, 0.7F, -0.2F}, 0.015, 0.2, k, pull);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += static_cast<double>(pull[i]) * n[i];
    }
    QVERIFY(std::fabs(sum - 0.015 / 0.2 * expected) < 1e-6);
    mppiControlCost({0.5F, 0.7F, -0.2F}, 0.015, 0.2, 0.0,
                    pull);  // white: Nav2's gamma / sigma² u epsilon
    QVERIFY(std::fabs(static_cast<double>(pull[1]) - 0.015 / 0.2 * 0.7) < 1e-6);
  }

  void savitzkyGolay_polynomials_areKept() {
    std::vector<float> sequence;
    sequence.reserve(30);
    for (int i = 0; i < 30; ++i) {
      sequence.push_back(static_cast<float>(0.3 + 0.02 * i - 0.001 * i * i));
    }
    const auto before = [](int i) { return static_cast<float>(0.3 + 0.02 * i - 0.001 * i * i); };
    const std::vector<float> smooth =
        savitzkyGolay(sequence, {before(-4), before(-3), before(-2), before(-1)});
    for (std::size_t i = 0; i + 4 < sequence.size(); ++i) {
      QVERIFY(std::fabs(smooth[i] - sequence[i]) < 1e-6F);
    }
  }

  void savitzkyGolay_oneSpike_isSpreadByTheTaps() {
    std::vector<float> sequence(30, 0.0F);
    sequence[10] = 231.0F;
    const std::vector<float> smooth = savitzkyGolay(sequence, {});
    QVERIFY(std::fabs(smooth[10] - 59.0F) < 1e-4F);
    QVERIFY(std::fabs(smooth[6] + 21.0F) < 1e-4F);
    QVERIFY(std::fabs(smooth[12] - 39.0F) < 1e-4F);
    QCOMPARE(smooth[15], 0.0F);
  }

  void shifted_wholeAndPartSteps_interpolates() {
    const std::vector<float> sequence = {0.0F, 1.0F, 4.0F};
    QVERIFY(shifted(sequence, 1.0) == (std::vector<float>{1.0F, 4.0F, 4.0F}));
    QVERIFY(shifted(sequence, 0.5) == (std::vector<float>{0.5F, 2.5F, 4.0F}));
  }
};

QTEST_GUILESS_MAIN(MppiKernelTest)
#include "tst_MppiKernel.moc"
