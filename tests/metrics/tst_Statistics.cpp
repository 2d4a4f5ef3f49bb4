#include <QtTest>

#include "metrics/Statistics.h"

using namespace metrics;

namespace {

bool isNear(double actual, double expected, double tolerance = 5e-4) {
  return std::fabs(actual - expected) <= tolerance;
}

}  // namespace

class StatisticsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void studentQuantile_published_data();
  void studentQuantile_published();
  void statisticsOf_fiveValues_byHand();
  void statisticsOf_nothingDefined_isEmpty();
  void statisticsOf_booleans_giveWilson();
  void pairedDifference_ofPairs_skipsUndefined();
  void comparisonTable_twoTags_areColumns();
  void comparisonTable_badFile_isRefused();
  void meanSeries_differentGrids_areInterpolated();
  void meanSeries_counts_areHeld();
};

void StatisticsTest::studentQuantile_published_data() {
  QTest::addColumn<int>("degrees");
  QTest::addColumn<double>("quantile");
  QTest::newRow("1") << 1 << 12.706;  // tables of the distribution
  QTest::newRow("2") << 2 << 4.303;
  QTest::newRow("4") << 4 << 2.776;
  QTest::newRow("9") << 9 << 2.262;
  QTest::newRow("30") << 30 << 2.042;
  QTest::newRow("many") << 1000000 << 1.960;
}

void StatisticsTest::studentQuantile_published() {
  QFETCH(int, degrees);
  QFETCH(double, quantile);
  QVERIFY(isNear(studentQuantile(degrees), quantile));
}

void StatisticsTest::statisticsOf_fiveValues_byHand() {
  const Statistics made = statisticsOf({2.0, 4.0, std::nullopt, 4.0, 6.0, 9.0, HUGE_VAL});
  QCOMPARE(made.runs, std::size_t{7});
  QCOMPARE(made.defined, std::size_t{5});
  QCOMPARE(*made.mean, 5.0);
  QCOMPARE(*made.deviation, std::sqrt(7.0));  // (9 + 1 + 1 + 1 + 16) / 4
  QCOMPARE(*made.median, 4.0);
  QCOMPARE(*made.minimum, 2.0);
  QCOMPARE(*made.maximum, 9.0);
  const double half = 2.776 * std::sqrt(7.0 / 5.0);
  QVERIFY(isNear(made.confidence->low, 5.0 - half, 2e-3));
  QVERIFY(isNear(made.confidence->high, 5.0 + half, 2e-3));
}

void StatisticsTest::statisticsOf_nothingDefined_isEmpty() {
  const Statistics made = statisticsOf({std::nullopt, HUGE_VAL});
  QCOMPARE(made.runs, std::size_t{2});
  QVERIFY(!made.mean && !made.deviation && !made.confidence);
  const Statistics one = statisticsOf({3.0});
  QVERIFY(one.mean && !one.deviation && !one.confidence);
}

void StatisticsTest::statisticsOf_booleans_giveWilson() {
  const Statistics made =
      statisticsOf({1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0}, Kind::Boolean);
  QCOMPARE(*made.mean, 0.7);
  QVERIFY(isNear(made.confidence->low, 0.3968));  // 7 of 10, published tables
  QVERIFY(isNear(made.confidence->high, 0.8922));
}

void StatisticsTest::pairedDifference_ofPairs_skipsUndefined() {
  const Statistics made = pairedDifference({1.0, 2.0, std::nullopt}, {1.5, 3.5, 7.0});
  QCOMPARE(made.defined, std::size_t{2});
  QCOMPARE(*made.mean, 1.0);
}

void StatisticsTest::comparisonTable_twoTags_areColumns() {
  const auto table = comparisonTable(
      {{"a.csv",
        "experiment_tag,run_id,completed,path_length\nx,0,True,1.0\nx,1,False,2.0\ny,0,True,\n"}});
  QVERIFY(table);
  QCOMPARE(QByteArray::fromStdString(*table),
           QByteArray(",a.csv_x,a.csv_y\ncompleted,0.5000 ± 0.7071,1.0000\n"
                      "path_length,1.5000 ± 0.7071,\n"));
}

void StatisticsTest::comparisonTable_badFile_isRefused() {
  QVERIFY(!comparisonTable({{"a.csv", "x,y\n1,2\n"}}));
  QVERIFY(!comparisonTable({{"a.csv", "experiment_tag,run_id,k\nx,0\n"}}));
  QVERIFY(!comparisonTable({{"a.csv", "experiment_tag,run_id,k\nx,0,z\n"}}));
}

void StatisticsTest::meanSeries_differentGrids_areInterpolated() {
  const TimedSeries first{{0.0, 1.0, 2.0}, {{0.0, 2.0, 4.0}, Kind::Number}};
  const TimedSeries second{{0.0, 0.5}, {{1.0, 2.0}, Kind::Number}};
  const TimedSeries mean = meanSeries({first, second}, 0.5);
  QCOMPARE(mean.times.size(), std::size_t{5});
  QCOMPARE(mean.series.values[0], 0.5);
  QCOMPARE(mean.series.values[1], 1.5);  // 1 and 2
  QCOMPARE(mean.series.values[3], 3.0);  // the longer run alone
}

void StatisticsTest::meanSeries_counts_areHeld() {
  const TimedSeries run{{0.0, 1.0}, {{0.0, 1.0}, Kind::Count}};
  const TimedSeries mean = meanSeries({run}, 0.75);
  QCOMPARE(mean.series.values[1], 0.0);
}

QTEST_APPLESS_MAIN(StatisticsTest)
#include "tst_Statistics.moc"
