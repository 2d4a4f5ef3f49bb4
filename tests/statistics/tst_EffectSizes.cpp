#include <algorithm>

#include <QtTest>

#include "metrics/statistics/Ranks.h"
#include "tests/statistics/Near.h"

using namespace statistics;

class EffectSizesTest : public QObject {
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
};

QTEST_APPLESS_MAIN(EffectSizesTest)
#include "tst_EffectSizes.moc"
