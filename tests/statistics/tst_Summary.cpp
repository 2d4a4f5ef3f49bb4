#include <QtTest>

#include "metrics/statistics/Summary.h"
#include "tests/statistics/Near.h"

using namespace statistics;

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
};

QTEST_APPLESS_MAIN(SummaryTest)
#include "tst_Summary.moc"
