#include <limits>

#include <QtTest>

#include "metrics/statistics/Distributions.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {
constexpr double kInf = std::numeric_limits<double>::infinity();
}

class DistributionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
};

QTEST_APPLESS_MAIN(DistributionsTest)
#include "tst_Distributions.moc"
