#include <cmath>
#include <limits>

#include <QtTest>

#include "metrics/statistics/PairedTests.h"
#include "metrics/statistics/Summary.h"
#include "sim2d/base/Rng.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Spatial test data A (Efron & Tibshirani 1993, table 14.1).
const Numbers& spatial() {
  static const Numbers values = {48, 36, 20, 29, 42, 42, 20, 42, 22, 41, 45, 14, 6,
                                 0,  33, 28, 34, 4,  32, 24, 47, 41, 24, 26, 30, 41};
  return values;
}

}  // namespace

class SummaryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mean_edgeCases_areAsSaid() {
    QVERIFY(std::isnan(mean({})));
    QCOMPARE(mean({4.0}), 4.0);
    QCOMPARE(mean({0.1, 0.1, 0.1, 0.1, 0.1, 0.1}), 0.1);  // exactly, although 6 * 0.1 / 6 is not
    QCOMPARE(mean({1.0, 2.0, 6.0}), 3.0);
  }

  void standardDeviation_handMade_dividesByOneLess() {
    QVERIFY(std::isnan(standardDeviation({})));
    QVERIFY(std::isnan(standardDeviation({3.0})));
    QCOMPARE(standardDeviation({0.1, 0.1, 0.1}), 0.0);
    VERIFY_NEAR(standardDeviation({2, 4, 4, 4, 5, 5, 7, 9}), std::sqrt(32.0 / 7.0), 1e-15);
  }

  void median_evenAndOdd_isTheMiddle() {
    QVERIFY(std::isnan(median({})));
    QCOMPARE(median({7.0}), 7.0);
    QCOMPARE(median({9.0, 1.0, 2.0}), 2.0);
    QCOMPARE(median({9.0, 1.0, 2.0, 4.0}), 3.0);
  }

  /// numpy 1.24: quantile([3, 1, 4, 1, 5, 9, 2, 6], [0, .1, .25, .5, .9, 1]).
  void quantiles_numpy_areEqual() {
    const Numbers found = quantiles({3, 1, 4, 1, 5, 9, 2, 6}, {0.0, 0.1, 0.25, 0.5, 0.9, 1.0});
    const Numbers wanted = {1.0, 1.0, 1.75, 3.5, 6.9, 9.0};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      VERIFY_NEAR(found[k], wanted[k], 1e-12);
    }
    QVERIFY(std::isnan(quantile({}, 0.5)));
    QCOMPARE(quantile({8.0}, 0.3), 8.0);
  }

  /// Extra hours of sleep (Student 1908; R's `sleep`, t.test of the first drug's differences):
  /// mean 1.58, sd 1.23, interval 0.70 to 2.46.
  void meanInterval_sleepData_isThatOfR() {
    const Numbers differences = {1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4};
    const Interval found = meanInterval(differences);
    VERIFY_NEAR(found.low, 0.7001142, 1e-6);
    VERIFY_NEAR(found.high, 2.4598858, 1e-6);
    QVERIFY(!meanInterval({1.0}).isDefined());
    QVERIFY(!meanInterval({}).isDefined());
    QCOMPARE(meanInterval({2.0, 2.0}).high, 2.0);
  }

  /// Order statistics of the sign test at 95 %: the usual tables (Conover 1999, A3: P(Y <= 1 | n =
  /// 10) = .0107, P(Y <= 5 | 20) = .0207, P(Y <= 0 | 6) = .0156, P(Y <= 0 | 5) = .0312).
  void medianInterval_tables_areTheOrderStatistics_data() {
    QTest::addColumn<int>("n");
    QTest::addColumn<int>("low");
    QTest::addColumn<int>("high");
    QTest::newRow("5") << 5 << 0 << 0;
    QTest::newRow("6") << 6 << 1 << 6;
    QTest::newRow("10") << 10 << 2 << 9;
    QTest::newRow("20") << 20 << 6 << 15;
  }
  void medianInterval_tables_areTheOrderStatistics() {
    QFETCH(int, n);
    QFETCH(int, low);
    QFETCH(int, high);
    Numbers values;
    for (int k = n; k > 0; --k) {
      values.push_back(k);
    }
    const Interval found = medianInterval(values);
    QCOMPARE(found.isDefined(), low > 0);
    if (low > 0) {
      QCOMPARE(found.low, static_cast<double>(low));
      QCOMPARE(found.high, static_cast<double>(high));
    }
  }

  void tails_tables_areEqual() {
    VERIFY_NEAR(normalQuantile(0.975), 1.959963984540054, 1e-12);
    VERIFY_NEAR(normalTail(6.0), 9.865876450377e-10, 1e-20);
    VERIFY_NEAR(studentQuantile(0.975, 9.0), 2.262157, 1e-6);  // usual tables: 2.262
    VERIFY_NEAR(chiSquaredTail(5.991465, 2.0), 0.05, 1e-7);    // 5.991
    VERIFY_NEAR(fisherTail(3.238872, 3.0, 16.0), 0.05, 1e-6);  // 3.24
    VERIFY_NEAR(binomialCdf(5.0, 20.0, 0.5), 0.020694732666, 1e-12);
    QCOMPARE(binomialCdf(-1.0, 20.0, 0.5), 0.0);
    QCOMPARE(binomialCdf(20.0, 20.0, 0.5), 1.0);
    QCOMPARE(fisherTail(kInf, 3.0, 16.0), 0.0);
  }

  /// Upper 5 % and 1 % points as printed (Pearson & Hartley, Biometrika Tables, 29), infinite
  /// freedom.
  void rangeQuantile_printedTable_isEqual() {
    VERIFY_NEAR(rangeQuantile(0.05, 3), 3.31, 0.0051);
    VERIFY_NEAR(rangeQuantile(0.05, 10), 4.47, 0.0051);
    VERIFY_NEAR(rangeQuantile(0.01, 3), 4.12, 0.0051);
  }

  /// scipy 1.10.1: studentized_range.sf(q, k, inf), and 2 groups by the normal distribution.
  void rangeTail_scipy_isEqual() {
    VERIFY_NEAR(rangeTail(3.0, 4), 0.14627148104765975, 1e-7);
    VERIFY_NEAR(rangeTail(3.0, 2), 2.0 * normalTail(3.0 / std::sqrt(2.0)), 1e-10);
    QCOMPARE(rangeTail(0.0, 3), 1.0);
    QVERIFY(rangeTail(40.0, 3) < 1e-12);
  }

  /// Newcombe 1998, table I, method 3 (Wilson score, no continuity correction), 95 %.
  void wilsonInterval_newcombe_isEqual_data() {
    QTest::addColumn<int>("successes");
    QTest::addColumn<int>("n");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::newRow("81/263") << 81 << 263 << 0.2553 << 0.3662;
    QTest::newRow("15/148") << 15 << 148 << 0.0624 << 0.1605;
    QTest::newRow("0/20") << 0 << 20 << 0.0000 << 0.1611;
    QTest::newRow("1/29") << 1 << 29 << 0.0061 << 0.1718;
    QTest::newRow("20/20, mirrored") << 20 << 20 << 1.0 - 0.1611 << 1.0;
  }
  void wilsonInterval_newcombe_isEqual() {
    QFETCH(int, successes);
    QFETCH(int, n);
    QFETCH(double, low);
    QFETCH(double, high);
    const Interval found = wilsonInterval(successes, n);
    VERIFY_NEAR(found.low, low, 0.00005);
    VERIFY_NEAR(found.high, high, 0.00005);
  }

  void wilsonInterval_nothingTried_isUndefined() {
    QVERIFY(!wilsonInterval(0, 0).isDefined());
    QCOMPARE(wilsonInterval(0, 3).low, 0.0);
    QCOMPARE(wilsonInterval(3, 3).high, 1.0);
  }

  /// Newcombe's method 10, evaluated in Python by its formulas.
  void pairedRateInterval_python_isEqual_data() {
    QTest::addColumn<int>("both");
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    QTest::addColumn<int>("neither");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::newRow("a margin is empty") << 36 << 12 << 2 << 0 << 0.0569296 << 0.3404276;
    QTest::newRow("correlated") << 20 << 12 << 2 << 16 << 0.0561564 << 0.3292070;
    QTest::newRow("negatively") << 1 << 1 << 7 << 6 << -0.6410053 << -0.0577271;
    QTest::newRow("nothing differs") << 54 << 0 << 0 << 0 << -0.0664136 << 0.0664136;
    QTest::newRow("all differ") << 0 << 6 << 0 << 0 << 0.4479840 << 1.0;
  }
  void pairedRateInterval_python_isEqual() {
    QFETCH(int, both);
    QFETCH(int, first);
    QFETCH(int, second);
    QFETCH(int, neither);
    QFETCH(double, low);
    QFETCH(double, high);
    const Interval found = pairedRateInterval({both, first, second, neither});
    VERIFY_NEAR(found.low, low, 1e-6);
    VERIFY_NEAR(found.high, high, 1e-6);
    const Interval turned = pairedRateInterval({both, second, first, neither});
    VERIFY_NEAR(turned.low, -found.high, 1e-12);
    VERIFY_NEAR(turned.high, -found.low, 1e-12);
    QVERIFY(!pairedRateInterval({}).isDefined());
  }

  /// By hand: 2 (1 + 8) / 2^8 and 2 (1 + 7 + 21) / 2^7.
  void mcNemarP_byHand_isEqual() {
    QCOMPARE(mcNemarP(1, 7), 18.0 / 256.0);
    QCOMPARE(mcNemarP(7, 1), 18.0 / 256.0);
    QCOMPARE(mcNemarP(5, 2), 58.0 / 128.0);
    QCOMPARE(mcNemarP(3, 3), 1.0);
    QCOMPARE(mcNemarP(0, 0), 1.0);
  }

  /// Treated mice (Efron & Tibshirani 1993, table 2.1); scipy 1.10.1, 100000
  /// resamples, three seeds: (46.3 to 47.0, 138.3).
  void bootstrapMeanInterval_mouseData_isThatOfScipy() {
    const Numbers treated = {94, 197, 16, 38, 99, 141, 23};
    BootstrapOptions options;
    options.resamples = 20000;
    const Interval found = bootstrapMeanInterval(treated, options);
    VERIFY_NEAR(found.low, 46.6, 1.0);
    VERIFY_NEAR(found.high, 138.3, 1.5);
  }

  /// Means that equal the estimate but for the order of their sums are equal to it. In Python, with
  /// whole sums, 40000 resamples: (-5, 3) / 15.
  void bootstrapMeanInterval_tiesByRounding_countAsHalf() {
    const Numbers differences = {1, 1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    BootstrapOptions options;
    options.resamples = 20000;
    const Interval found = bootstrapMeanInterval(differences, options);
    VERIFY_NEAR(found.low, -5.0 / 15.0, 1e-9);
    VERIFY_NEAR(found.high, 3.0 / 15.0, 1e-9);
  }

  void bootstrapMeanInterval_seed_decidesAlone() {
    BootstrapOptions options;
    const Interval one = bootstrapMeanInterval(spatial(), options);
    const Interval again = bootstrapMeanInterval(spatial(), options);
    QCOMPARE(one.low, again.low);
    QCOMPARE(one.high, again.high);
    options.seed = 2;
    QVERIFY(bootstrapMeanInterval(spatial(), options).low != one.low);
  }

  void bootstrapMeanInterval_smallAndEqual_areAsSaid() {
    QVERIFY(!bootstrapMeanInterval({}).isDefined());
    QVERIFY(!bootstrapMeanInterval({1.0}).isDefined());
    const Interval equal = bootstrapMeanInterval({0.1, 0.1, 0.1});
    QCOMPARE(equal.low, 0.1);
    QCOMPARE(equal.high, 0.1);
    const Interval two = bootstrapMeanInterval({0.0, 1.0});
    QVERIFY(two.low >= 0.0 && two.low < two.high && two.high <= 1.0);
  }

  /// By hand: (1.95996 √0.6 + 0.84162 √(0.6 - 0.36))² / 0.36 = 10.35;
  /// (1.95996 √0.4 + 0.84162 √(0.4 - 0.04))² / 0.04 = 76.09.
  void pairsForMcNemar_byHand_isEqual() {
    QCOMPARE(pairsForMcNemar(0.6, 0.0), 11.0);
    QCOMPARE(pairsForMcNemar(0.3, 0.1), 77.0);
    QCOMPARE(pairsForMcNemar(0.1, 0.3), 77.0);
  }

  /// With five pairs no p is below 2 / 2^5.
  void pairsForMcNemar_edgeCases_areAsSaid() {
    QCOMPARE(pairsForMcNemar(1.0, 0.0), 6.0);
    QCOMPARE(pairsForMcNemar(0.0, 1.0, {0.01, 0.8}), 8.0);
    QVERIFY(std::isnan(pairsForMcNemar(0.2, 0.2)));
    QVERIFY(std::isnan(pairsForMcNemar(kUndefined, 0.2)));
  }

  /// Solved for δ with Python, by bisection of Connor's formula.
  void detectableRateDifference_otherProgram_isEqual() {
    VERIFY_NEAR(detectableRateDifference(0.2, 100), 0.123819331484, 1e-8);
    VERIFY_NEAR(detectableRateDifference(0.4, 30), 0.310942918823, 1e-8);
    VERIFY_NEAR(detectableRateDifference(0.1, 400), 0.044166521985, 1e-8);
    VERIFY_NEAR(detectableRateDifference(0.0, 50), 0.149717150012, 1e-8);  // all in one direction
    QVERIFY(std::isnan(detectableRateDifference(0.2, 0)));
    QVERIFY(std::isnan(detectableRateDifference(0.2, 5)));  // the exact test cannot reach 5 %
  }

  /// Of normal differences with this shift, the test finds 80 %: 1000 samples, ± 4 %.
  void detectableShift_simulatedTests_findItWithThePower() {
    VERIFY_NEAR(detectableShift(1.0, 100), 0.28669369782831, 1e-12);
    QVERIFY(std::isnan(detectableShift(1.0, 5)));  // the exact test cannot reach 5 %
    QVERIFY(std::isnan(detectableShift(0.0, 100)));
    constexpr int kPairs = 40;
    const double shift = detectableShift(2.0, kPairs);
    int found = 0;
    for (int sample = 0; sample < 1000; ++sample) {
      Numbers differences;
      const base::AgentRng rng(3, 0, static_cast<std::uint64_t>(sample));
      for (std::uint32_t k = 0; k < kPairs; ++k) {
        differences.push_back(rng.normal(shift, 2.0, base::DrawPurpose::Test, k));
      }
      found += stratifiedSignedRank({differences}).p < 0.05 ? 1 : 0;
    }
    QVERIFY2(found >= 760 && found <= 840, qPrintable(QString::number(found)));
  }

  /// By hand: (1.95996 + 0.84162 √0.84)² / (3 * 0.2²) = 7.4601 / 0.12 = 62.2; power 90 %:
  /// (1.95996 + 1.28155 √0.84)² / 0.12 = 81.9.
  void pairsForSignedRank_byHand_isEqual() {
    QCOMPARE(pairsForSignedRank(0.7), 63.0);
    QCOMPARE(pairsForSignedRank(0.3), 63.0);
    QCOMPARE(pairsForSignedRank(0.7, {0.05, 0.9}), 82.0);
    QVERIFY(std::isnan(pairsForSignedRank(0.5)));
    QVERIFY(std::isnan(pairsForSignedRank(kUndefined)));
  }

  /// If all differences have one sign, the exact test has p = 2 / 2^n: 0.0625 for 5 pairs, 0.03125
  /// for 6.
  void pairsForSignedRank_oneSign_areThoseOfTheExactTest() {
    QCOMPARE(pairsForSignedRank(1.0), 6.0);
    QCOMPARE(pairsForSignedRank(0.0), 6.0);
    QCOMPARE(pairsForSignedRank(1.0, {0.01, 0.8}), 9.0);  // (2.57583)² / 0.75 = 8.8
    VERIFY_NEAR(stratifiedSignedRank({{1, 2, 3, 4, 5}}).p, 0.0625, 1e-12);
    VERIFY_NEAR(stratifiedSignedRank({{1, 2, 3, 4, 5, 6}}).p, 0.03125, 1e-12);
  }

  /// By hand: of 3 + -1, 3 + -3, -1 + -3 one is positive, one is zero.
  void chanceOfPositiveSum_byHand_isEqual() {
    QCOMPARE(chanceOfPositiveSum({3, -1, -3}), 0.5);
    QCOMPARE(chanceOfPositiveSum({1, 2, 3}), 1.0);
    QCOMPARE(chanceOfPositiveSum({0, 0}), 0.5);
    QVERIFY(std::isnan(chanceOfPositiveSum({1})));
  }
};

QTEST_APPLESS_MAIN(SummaryTest)
#include "tst_Summary.moc"
