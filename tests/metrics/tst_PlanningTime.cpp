#include <QtTest>

#include "metrics/RunResults.h"

using namespace metrics;

/// What the clock says, with times of our own.
class PlanningTimeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void results_fourTimes_byHand();
  void results_nothingMeasured_sayWhy();
  void results_oneTime_hasNoDeviation();
  void infos_areNoMetricsOfARecord();
};

void PlanningTimeTest::results_fourTimes_byHand() {
  PlanningTime time;
  for (const double seconds : {0.25, 0.5, 0.75, 1.5}) {
    time.add(seconds);
  }
  // Deviations -0.5, -0.25, 0, 0.75: squares sum up to 0.875.
  const std::vector<MetricResult> results = time.results();
  QCOMPARE(results.size(), std::size_t{2});
  QVERIFY(results[0].info.key == "planning_time_mean");
  QCOMPARE(*results[0].value.value, 0.75);
  QCOMPARE(*results[1].value.value, std::sqrt(0.875 / 3.0));
}

void PlanningTimeTest::results_nothingMeasured_sayWhy() {
  for (const MetricResult& result : PlanningTime().results()) {
    QVERIFY(!result.value.value && !result.value.why.empty());
  }
}

void PlanningTimeTest::results_oneTime_hasNoDeviation() {
  PlanningTime time;
  time.add(0.25);
  QCOMPARE(*time.results()[0].value.value, 0.25);
  QVERIFY(!time.results()[1].value.value);
}

/// Those of two equal runs are equal to the last digit.
void PlanningTimeTest::infos_areNoMetricsOfARecord() {
  for (const MetricInfo& info : planningTimeInfos()) {
    QVERIFY(standardRegistry().find(info.key) == nullptr);
    QVERIFY(metricsMarkdown().find('`' + info.key + '`') != std::string::npos);
  }
}

QTEST_APPLESS_MAIN(PlanningTimeTest)
#include "tst_PlanningTime.moc"
