#include <algorithm>

#include <QtTest>

#include "metrics/statistics/Ranks.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

/// Ranks of C4.5, C4.5+m, C4.5+cf, C4.5+m+cf on 14 data sets (Demšar 2006, table 6).
const std::vector<Numbers>& demsarRanks() {
  static const std::vector<Numbers> ranks = {
      {4, 3, 2, 1},     {1, 2, 3, 4}, {4, 1, 2, 3},     {4, 1, 3, 2}, {4, 2, 3, 1},
      {1, 2.5, 4, 2.5}, {3, 2, 4, 1}, {2.5, 2.5, 4, 1}, {4, 3, 2, 1}, {2.5, 2.5, 2.5, 2.5},
      {4, 2.5, 1, 2.5}, {3, 2, 4, 1}, {4, 1, 2, 3},     {3, 1, 4, 2}};
  return ranks;
}

/// Seconds to the first base of 22 players, three ways (Hollander & Wolfe 1999, table 7.1; R's
/// ?friedman.test).
const std::vector<Numbers>& rounding() {
  static const std::vector<Numbers> seconds = {
      {5.40, 5.50, 5.55}, {5.85, 5.70, 5.75}, {5.20, 5.60, 5.50}, {5.55, 5.50, 5.40},
      {5.90, 5.85, 5.70}, {5.45, 5.55, 5.60}, {5.40, 5.40, 5.35}, {5.45, 5.50, 5.35},
      {5.25, 5.15, 5.00}, {5.85, 5.80, 5.70}, {5.25, 5.20, 5.10}, {5.65, 5.55, 5.45},
      {5.60, 5.35, 5.45}, {5.05, 5.00, 4.95}, {5.50, 5.50, 5.40}, {5.45, 5.55, 5.50},
      {5.55, 5.55, 5.35}, {5.45, 5.50, 5.55}, {5.50, 5.45, 5.25}, {5.65, 5.60, 5.40},
      {5.70, 5.65, 5.55}, {6.30, 6.30, 6.25}};
  return seconds;
}

}  // namespace

class ComparisonsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// By hand: of 9 pairs 1 is larger, 6 are smaller, 2 tie.
  void cliffsDelta_byHand_isEqual() {
    VERIFY_NEAR(cliffsDelta({1, 2, 3}, {2, 3, 4}), -5.0 / 9.0, 1e-15);
    QCOMPARE(cliffsDelta({5, 6}, {1, 2}), 1.0);
    QCOMPARE(cliffsDelta({1, 1}, {1, 1, 1}), 0.0);
    QVERIFY(std::isnan(cliffsDelta({}, {1})));
  }

  /// Largest U that is significant at 5 % two-sided: the usual table (Mann & Whitney).
  void rankSumCdf_criticalValues_areThoseOfTheTable() {
    const int rows[][3] = {{5, 5, 2}, {8, 10, 17}, {10, 10, 23}, {15, 12, 49}, {20, 20, 127}};
    for (const auto& row : rows) {
      const Numbers cdf = rankSumCdf(row[0], row[1]);
      const auto at = static_cast<std::size_t>(row[2]);
      QVERIFY2(cdf[at] <= 0.025 && cdf[at + 1] > 0.025, qPrintable(QString::number(row[0])));
      VERIFY_NEAR(cdf.back(), 1.0, 1e-12);
    }
  }

  /// Permeability of membranes (Hollander & Wolfe 1999, examples 4.1, 4.3, 4.4; R's
  /// ?wilcox.test): estimate .305, interval (-.15, .76).
  void shift_membranes_isThatOfTheBook() {
    const Numbers term = {.80, .83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, .73, 1.46};
    const Numbers early = {1.15, .88, .90, .74, 1.21};
    VERIFY_NEAR(shift(term, early), 0.305, 1e-9);
    const Interval found = shiftInterval(term, early);
    VERIFY_NEAR(found.low, -0.15, 1e-9);
    VERIFY_NEAR(found.high, 0.76, 1e-9);
  }

  void shift_edgeCases_areAsSaid() {
    QVERIFY(std::isnan(shift({}, {1})));
    QCOMPARE(shift({4.0}, {1.0}), 3.0);
    QCOMPARE(shift({2, 2, 2}, {2, 2}), 0.0);
    QVERIFY(!shiftInterval({1, 2, 3}, {1, 2, 3}).isDefined());  // 2 / 20 > 5 %
    QVERIFY(!shiftInterval({}, {1}).isDefined());
  }

  /// The differences of larger samples listed and sorted; places by hand: 40 * 30 / 2 = 600,
  /// √(1200 * 71 / 12) = 84.26, 600 - 1.95996 * 84.26 - 0.5 = 434.4.
  void shiftInterval_largeSamples_isTheOneOfTheList() {
    Numbers first;
    Numbers second;
    first.reserve(40);
    second.reserve(30);
    for (int k = 0; k < 40; ++k) {
      first.push_back((k * 37) % 41 / 7.0);
    }
    for (int k = 0; k < 30; ++k) {
      second.push_back((k * 17) % 31 / 5.0);
    }
    Numbers all;
    for (const double a : first) {
      for (const double b : second) {
        all.push_back(a - b);
      }
    }
    std::sort(all.begin(), all.end());
    const Interval found = shiftInterval(first, second);
    QCOMPARE(found.low, all[434]);
    QCOMPARE(found.high, all[1200 - 435]);
    QCOMPARE(shift(first, second), 0.5 * (all[599] + all[600]));
  }

  /// By hand: .005 * 4, .01 * 3, .03 * 2, and .04 not below the one before.
  void holm_byHand_isEqual() {
    const Numbers found = holm({0.01, 0.04, 0.03, 0.005});
    const Numbers wanted = {0.03, 0.06, 0.06, 0.02};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      VERIFY_NEAR(found[k], wanted[k], 1e-15);
    }
    QCOMPARE(holm({}), Numbers());
    QCOMPARE(holm({0.4}), Numbers({0.4}));
    QCOMPARE(holm({0.6, 0.7}), Numbers({1.0, 1.0}));
    const Numbers without = holm({0.01, kUndefined, 0.02});  // as if it were two
    QVERIFY(without[0] == 0.02 && without[2] == 0.02 && std::isnan(without[1]));
  }

  void friedman_demsar_ranksAreThoseOfThePaper() {
    const Friedman found = friedman(demsarRanks());
    const Numbers wanted = {3.143, 2.000, 2.893, 1.964};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      VERIFY_NEAR(found.meanRanks[k], wanted[k], 0.0005);
    }
    // scipy 1.10.1: friedmanchisquare, corrected for ties; the paper's 9.28 is not: over
    // 1 - 78 / 840 it is the same.
    VERIFY_NEAR(found.chiSquared, 10.228346456692925, 1e-9);
    VERIFY_NEAR(found.chiSquared * (1.0 - 78.0 / 840.0), 9.28, 0.005);
    VERIFY_NEAR(found.p, 0.016721580328441323, 1e-9);
    VERIFY_NEAR(found.f, 4.1851301115241695, 1e-9);
    VERIFY_NEAR(found.fP, 0.011620659515310954, 1e-9);
  }

  /// R and H & W: S' = 11.143, p .003805; scipy 1.10.1: f.sf(7.1217, 2, 42).
  void friedman_rounding_isThatOfR() {
    const Friedman found = friedman(rounding());
    VERIFY_NEAR(found.chiSquared, 11.142857142857132, 1e-9);
    VERIFY_NEAR(found.p, 0.003805040775511383, 1e-9);
    VERIFY_NEAR(found.fP, 0.0021712983876075393, 1e-9);
  }

  void friedman_edgeCases_areAsSaid() {
    QCOMPARE(friedman({}).p, 1.0);
    QCOMPARE(friedman({{1, 2, 3}}).p, 1.0);
    QCOMPARE(friedman({{1, 1}, {2, 2}, {3, 3}}).p, 1.0);
    const Friedman agreed = friedman({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
    VERIFY_NEAR(agreed.chiSquared, 6.0, 1e-12);  // N (k - 1)
    QVERIFY(std::isinf(agreed.f));
    VERIFY_NEAR(agreed.fP, 1.0 / 36.0, 1e-15);  // both others in the first's order, of six
    VERIFY_NEAR(friedman({{1, 1, 2}, {3, 3, 4}}).fP, 1.0 / 3.0, 1e-15);  // of three
  }

  /// Demšar 2006, table 5 (a): q at 5 % and 10 %.
  void nemenyiDifference_demsarTable_isEqual_data() {
    QTest::addColumn<int>("options");
    QTest::addColumn<double>("q05");
    QTest::addColumn<double>("q10");
    const double rows[][2] = {{1.960, 1.645}, {2.343, 2.052}, {2.569, 2.291},
                              {2.728, 2.459}, {2.850, 2.589}, {2.949, 2.693},
                              {3.031, 2.780}, {3.102, 2.855}, {3.164, 2.920}};
    int options = 2;
    for (const auto& row : rows) {
      QTest::addRow("%d", options) << options << row[0] << row[1];
      ++options;
    }
  }
  void nemenyiDifference_demsarTable_isEqual() {
    QFETCH(int, options);
    QFETCH(double, q05);
    QFETCH(double, q10);
    const int blocks = 14;
    const double error = std::sqrt(options * (options + 1.0) / (6.0 * blocks));
    VERIFY_NEAR(nemenyiDifference(options, blocks, 0.95) / error, q05, 0.00101);
    VERIFY_NEAR(nemenyiDifference(options, blocks, 0.90) / error, q10, 0.00101);
  }

  /// Demšar 2006, 3.2.4: 1.25 at 5 % and 1.12 at 10 %, with these 14 data sets.
  void nemenyiDifference_demsar_isThatOfThePaper() {
    VERIFY_NEAR(nemenyiDifference(4, 14, 0.95), 1.25, 0.005);
    VERIFY_NEAR(nemenyiDifference(4, 14, 0.90), 1.12, 0.005);
  }

  /// By hand: time (less is better) against distance kept (more is better).
  void paretoFront_byHand_isEqual() {
    const Numbers time = {10, 12, 11, 14, 10};
    const Numbers distance = {0.5, 0.9, 0.4, 0.9, 0.5};
    QCOMPARE(paretoFront(time, Sense::Lower, distance, Sense::Higher),
             std::vector<bool>({true, true, false, false, true}));
    QCOMPARE(paretoFront(time, Sense::Lower, distance, Sense::Lower),
             std::vector<bool>({true, false, true, false, true}));
    QCOMPARE(paretoFront({1, kUndefined}, Sense::Lower, {1, 0}, Sense::Lower),
             std::vector<bool>({true, false}));
    QVERIFY(paretoFront({}, Sense::Lower, {}, Sense::Lower).empty());
  }

  /// By hand: times 10, 15, 20 -> 1, 0.5, 0; distances 0.2, 0.6, 0.4 -> 0, 1, 0.5; weights 1, 3.
  void composite_byHand_isEqual() {
    const Numbers found =
        composite({{{10, 15, 20}, Sense::Lower, 1.0}, {{0.2, 0.6, 0.4}, Sense::Higher, 3.0}});
    const Numbers wanted = {0.25, 3.5 / 4.0, 1.5 / 4.0};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      VERIFY_NEAR(found[k], wanted[k], 1e-12);
    }
  }

  void composite_edgeCases_areAsSaid() {
    QVERIFY(composite({}).empty());
    QCOMPARE(composite({{{5, 5}, Sense::Lower, 1.0}}), Numbers({1.0, 1.0}));
    QVERIFY(std::isnan(composite({{{5, 6}, Sense::Lower, 0.0}})[0]));
    const Numbers gap = composite({{{5, kUndefined, 6}, Sense::Lower, 1.0}});
    QCOMPARE(gap[0], 1.0);
    QVERIFY(std::isnan(gap[1]));
    QCOMPARE(gap[2], 0.0);
  }
};

QTEST_APPLESS_MAIN(ComparisonsTest)
#include "tst_Comparisons.moc"
