#include <QtTest>

#include "metrics/statistics/Summary.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

/// Spatial test data A (Efron & Tibshirani 1993, table 14.1).
const Numbers& spatial() {
  static const Numbers values = {48, 36, 20, 29, 42, 42, 20, 42, 22, 41, 45, 14, 6,
                                 0,  33, 28, 34, 4,  32, 24, 47, 41, 24, 26, 30, 41};
  return values;
}

}  // namespace

class BootstrapTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
};

QTEST_APPLESS_MAIN(BootstrapTest)
#include "tst_Bootstrap.moc"
