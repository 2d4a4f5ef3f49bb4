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

  /// Upper 5 % and 1 % points as printed (Pearson & Hartley, Biometrika Tables, 29).
  void studentizedRangeQuantile_printedTable_isEqual_data() {
    QTest::addColumn<double>("tail");
    QTest::addColumn<int>("groups");
    QTest::addColumn<double>("freedom");
    QTest::addColumn<double>("q");
    const struct {
      double tail;
      int groups;
      double freedom, q;
    } rows[] = {{.05, 2, 5, 3.64},     {.05, 3, 10, 3.88},  {.05, 4, 12, 4.20},
                {.05, 5, 20, 4.23},    {.05, 10, 60, 4.65}, {.05, 3, kInf, 3.31},
                {.05, 10, kInf, 4.47}, {.01, 3, 10, 5.27},  {.01, 5, 20, 5.29},
                {.01, 3, kInf, 4.12}};
    for (const auto& row : rows) {
      QTest::addRow("%g %d %g", row.tail, row.groups, row.freedom)
          << row.tail << row.groups << row.freedom << row.q;
    }
  }
  void studentizedRangeQuantile_printedTable_isEqual() {
    QFETCH(double, tail);
    QFETCH(int, groups);
    QFETCH(double, freedom);
    QFETCH(double, q);
    VERIFY_NEAR(studentizedRangeQuantile(tail, groups, freedom), q, 0.0051);
  }

  /// scipy 1.10.1: studentized_range.sf(q, k, df), and 2 groups by the normal distribution.
  void studentizedRangeTail_scipy_isEqual() {
    VERIFY_NEAR(studentizedRangeTail(3.5, 3, 10.0), 0.07710331083841038, 1e-7);
    VERIFY_NEAR(studentizedRangeTail(4.0, 5, 20.0), 0.06958714392304588, 1e-7);
    VERIFY_NEAR(studentizedRangeTail(2.5, 10, 7.0), 0.7383545526141779, 1e-7);
    VERIFY_NEAR(studentizedRangeTail(5.0, 3, 2.0), 0.12742340267177144, 1e-5);
    VERIFY_NEAR(studentizedRangeTail(3.0, 4, kInf), 0.14627148104765975, 1e-7);
    VERIFY_NEAR(studentizedRangeTail(3.0, 2, kInf), 2.0 * normalTail(3.0 / std::sqrt(2.0)), 1e-10);
    QCOMPARE(studentizedRangeTail(0.0, 3, kInf), 1.0);
    QVERIFY(studentizedRangeTail(40.0, 3, kInf) < 1e-12);
  }
};

QTEST_APPLESS_MAIN(DistributionsTest)
#include "tst_Distributions.moc"
