#include <array>
#include <cmath>

#include <QtTest>

#include "metrics/statistics/Sensitivity.h"
#include "sim2d/base/Rng.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Ishigami & Homma 1990 with a = 7, b = 0.1; coordinates in [0, 1].
double ishigami(const Numbers& at) {
  const double x = kPi * (2.0 * at[0] - 1.0), y = kPi * (2.0 * at[1] - 1.0);
  const double z = kPi * (2.0 * at[2] - 1.0);
  return std::sin(x) + 7.0 * std::sin(y) * std::sin(y) + 0.1 * std::pow(z, 4) * std::sin(x);
}

/// Rows at random points.
template <class Function>
std::vector<SaltelliRow> rowsOf(Function function, std::size_t factors, std::size_t count,
                                std::uint64_t seed) {
  std::vector<SaltelliRow> rows;
  for (std::size_t k = 0; k < count; ++k) {
    Numbers a(factors), b(factors);
    for (std::size_t f = 0; f < factors; ++f) {
      const auto at = static_cast<std::uint32_t>(2 * f);
      const base::AgentRng rng(seed, 0, k);
      a[f] = rng.uniform01(base::DrawPurpose::Test, at);
      b[f] = rng.uniform01(base::DrawPurpose::Test, at + 1);
    }
    SaltelliRow row{function(a), function(b), {}};
    for (std::size_t f = 0; f < factors; ++f) {
      Numbers mixed = a;
      mixed[f] = b[f];
      row.mixed.push_back(function(mixed));
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

class SensitivityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// y = 3 u - 2 v + 1: effects are the coefficients, whatever the steps.
  void elementaryEffects_linear_areTheCoefficients() {
    const std::vector<Numbers> points = {{0.0, 0.0},  {0.5, 0.0}, {0.5, 0.25},
                                         {1.0, 0.75}, {1.0, 0.0}, {0.25, 0.0}};
    Numbers outputs;
    for (const Numbers& at : points) {
      outputs.push_back(3.0 * at[0] - 2.0 * at[1] + 1.0);
    }
    const std::vector<Numbers> effects = elementaryEffects(points, outputs);
    QCOMPARE(effects.size(), std::size_t{2});
    for (const Numbers& each : effects) {
      VERIFY_NEAR(each[0], 3.0, 1e-14);
      VERIFY_NEAR(each[1], -2.0, 1e-14);
    }
  }

  void elementaryEffects_undefinedOutput_leavesOutItsEffectsOnly() {
    const std::vector<Numbers> points = {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.25}};
    const std::vector<Numbers> effects = elementaryEffects(points, {kUndefined, 1.0, 2.0});
    QVERIFY(std::isnan(effects[0][0]));
    QCOMPARE(effects[0][1], 4.0);
  }

  /// By hand: effects 1, -3, 5 and 2, 2 (one undefined).
  void morris_handMade_isAsCalculated() {
    const MorrisIndices found =
        morrisIndices({{1.0, 2.0}, {-3.0, kUndefined}, {5.0, 2.0}}, {0.95, 500, 1});
    const MorrisFactor &mixed = found.factors[0], &constant = found.factors[1];
    QCOMPARE(mixed.count, 3);
    QCOMPARE(mixed.mean, 1.0);
    QCOMPARE(mixed.meanSize, 3.0);
    QCOMPARE(mixed.deviation, 4.0);
    QVERIFY(mixed.meanSizeInterval.low < 3.0 && mixed.meanSizeInterval.high > 3.0);
    QCOMPARE(constant.count, 2);
    QCOMPARE(constant.meanSize, 2.0);
    QCOMPARE(constant.deviation, 0.0);
    QCOMPARE(constant.meanSizeInterval.low, 2.0);
    QCOMPARE(found.ranking.order, (std::vector<std::size_t>{0, 1}));
    // Of the 27 resamples, 4 have a sum of sizes below 6 (1 1 1; 1 1 3 in three orders); in one the
    // second factor has no effect (3 3 3), which counts half.
    VERIFY_NEAR(found.ranking.orderShares[0], 22.5 / 27.0, 0.05);
  }

  void morris_fewEffects_areUndefined() {
    QVERIFY(morrisIndices({}).factors.empty());
    const MorrisIndices one = morrisIndices({{2.0, kUndefined}});
    QCOMPARE(one.factors[0].meanSize, 2.0);
    QVERIFY(std::isnan(one.factors[0].deviation));
    QVERIFY(!one.factors[0].meanSizeInterval.isDefined());
    QVERIFY(std::isnan(one.factors[1].meanSize));
    QCOMPARE(one.ranking.order, (std::vector<std::size_t>{0, 1}));
  }

  /// Exact values from the variances (Saltelli et al. 2008, Global Sensitivity Analysis, 4.3):
  /// V1 = (1 + b π⁴ / 5)² / 2, V2 = a² / 8, V13 = 8 b² π⁸ / 225.
  void sobol_ishigami_intervalsContainTheExactValues() {
    const double first = 0.5 * std::pow(1.0 + 0.1 * std::pow(kPi, 4) / 5.0, 2);
    const double second = 49.0 / 8.0, mixed = 0.08 * std::pow(kPi, 8) / 225.0;
    const double all = first + second + mixed;
    const std::array<double, 3> exactFirst = {first / all, second / all, 0.0};
    const std::array<double, 3> exactTotal = {(first + mixed) / all, second / all, mixed / all};
    constexpr int kTrials = 80;
    std::array<int, 6> covered{};
    for (int trial = 1; trial <= kTrials; ++trial) {
      const auto seed = static_cast<std::uint64_t>(trial);
      const SobolIndices found = sobolIndices(rowsOf(ishigami, 3, 256, seed), {0.95, 300, seed});
      for (std::size_t f = 0; f < 3; ++f) {
        const Interval& alone = found.factors[f].firstInterval;
        const Interval& whole = found.factors[f].totalInterval;
        covered[f] += alone.low <= exactFirst[f] && exactFirst[f] <= alone.high ? 1 : 0;
        covered[f + 3] += whole.low <= exactTotal[f] && exactTotal[f] <= whole.high ? 1 : 0;
      }
    }
    for (const int count : covered) {  // 76 expected, deviation 1.95
      QVERIFY2(count >= 68, qPrintable(QString::number(count)));
    }
  }

  void sobol_ishigami_ranksByTotal() {
    const SobolIndices found = sobolIndices(rowsOf(ishigami, 3, 4096, 2), {0.95, 200, 1});
    QCOMPARE(found.rows, 4096);
    QCOMPARE(found.ranking.order, (std::vector<std::size_t>{0, 1, 2}));  // 0.558, 0.442, 0.244
    QVERIFY(found.ranking.orderShares[0] > 0.95 && found.ranking.orderShares[1] > 0.95);
    VERIFY_NEAR(found.variance, 13.8446, 0.5);
  }

  /// An offset of the output does not change the indices.
  void sobol_offset_changesNothing() {
    const auto rows = rowsOf(ishigami, 3, 64, 2);
    auto shifted = rows;
    for (SaltelliRow& row : shifted) {
      row.a += 1000.0;
      row.b += 1000.0;
      for (double& mixed : row.mixed) {
        mixed += 1000.0;
      }
    }
    const SobolIndices one = sobolIndices(rows), other = sobolIndices(shifted);
    for (std::size_t f = 0; f < 3; ++f) {
      VERIFY_NEAR(one.factors[f].first, other.factors[f].first, 1e-9);
      VERIFY_NEAR(one.factors[f].total, other.factors[f].total, 1e-9);
    }
  }

  /// y = u: by hand for the rows (a, b) = (0, 1), (1, 0): V = 1/4; first = mean of b (b - a) minus
  /// mean of b times mean of (b - a) over V = 1/2 / (1/4) = 2; total = 1/2 / (1/4) = 2.
  void sobol_twoRows_isAsCalculated() {
    const SobolIndices found =
        sobolIndices({{0.0, 1.0, {1.0, 0.0}}, {1.0, 0.0, {0.0, 1.0}}}, {0.95, 100, 1});
    QCOMPARE(found.variance, 0.25);
    QCOMPARE(found.factors[0].first, 2.0);
    QCOMPARE(found.factors[0].total, 2.0);
    QCOMPARE(found.factors[1].first, 0.0);
    QCOMPARE(found.factors[1].total, 0.0);
  }

  void sobol_constantOrFewRows_areUndefined() {
    QVERIFY(sobolIndices({}).factors.empty());
    const SaltelliRow row{0.1, 0.1, {0.1, 0.1}};
    for (const auto& rows : {std::vector<SaltelliRow>{row}, std::vector<SaltelliRow>(7, row)}) {
      const SobolIndices found = sobolIndices(rows);
      QCOMPARE(found.factors.size(), std::size_t{2});
      QVERIFY(std::isnan(found.factors[0].first) && std::isnan(found.factors[1].total));
      QCOMPARE(found.ranking.order, (std::vector<std::size_t>{0, 1}));
    }
  }
};

QTEST_APPLESS_MAIN(SensitivityTest)
#include "tst_Sensitivity.moc"
