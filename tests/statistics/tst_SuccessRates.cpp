#include <QtTest>

#include "metrics/statistics/Summary.h"
#include "tests/statistics/Near.h"

using namespace statistics;

class SuccessRatesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
};

QTEST_APPLESS_MAIN(SuccessRatesTest)
#include "tst_SuccessRates.moc"
