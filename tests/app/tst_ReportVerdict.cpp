#include <cmath>
#include <vector>

#include <QtTest>

#include "app/report/Comparison.h"
#include "app/report/Tables.h"
#include "app/report/Verdict.h"

using namespace report;

namespace {

/// Two options on eight seeds of one case, one metric per list of differences first - second.
Study studyOf(const std::vector<std::vector<double>>& differences) {
  Study study;
  study.options = {"alpha", "beta"};
  study.cases = {"hall"};
  study.compared = "robot1.planner";
  for (std::size_t metric = 0; metric < differences.size(); ++metric) {
    const std::string name = std::string("Metric ") + static_cast<char>('A' + metric);
    study.results.keys.push_back(name);
    study.results.isBoolean.push_back(false);
    study.metrics.push_back({name, name, "m", false, -1});
    study.results.metrics.emplace_back();
    for (const double difference : differences[metric]) {
      study.results.metrics[metric].push_back(100.0 + difference);
      study.results.metrics[metric].push_back(100.0);
    }
  }
  for (std::size_t seed = 0; seed < differences.front().size(); ++seed) {
    for (std::size_t option = 0; option < 2; ++option) {
      Results::Run run;
      run.seed = static_cast<long long>(seed) + 1;
      study.results.runs.push_back(run);
      study.optionOf.push_back(option);
      study.caseOf.push_back(0);
    }
  }
  return study;
}

Comparisons comparedAll(const Study& study) {
  const auto blocks = blocksOf(study);
  Comparisons all;
  for (std::size_t metric = 0; metric < study.metrics.size(); ++metric) {
    all.push_back(compare(study, metric, blocks));
  }
  adjustTogether(study, all);
  return all;
}

/// The text without its elements.
QString plain(const std::string& markup) {
  QString text = QString::fromStdString(markup).trimmed();
  text.remove(QRegularExpression(QStringLiteral("<[^>]*>")));
  return text.replace(QStringLiteral("&lt;"), QStringLiteral("<"))
      .replace(QStringLiteral("&#39;"), QStringLiteral("'"));
}

// Ranks 1 to 8: of the 256 signs one has no negative rank, two have at most the rank 1, and 25 have
// a negative sum of at most 8 (1 + 1 + 1 + 2 + 2 + 3 + 4 + 5 + 6 subsets of 0 … 8).
const std::vector<double> kAllLower = {-1, -2, -3, -4, -5, -6, -7, -8};  // p = 2 / 256
const std::vector<double> kMostHigher = {-1, 2, 3, 4, 5, 6, 7, 8};       // p = 4 / 256
const std::vector<double> kUnclear = {1, 2, 3, 4, 5, 6, 7, -8};          // p = 50 / 256

}  // namespace

/// The sentences on top of a report, the adjustment of its p values and the digits of its numbers.
class ReportVerdictTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void decimals_followTheInterval_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<int>("decimals");
    const double none = std::nan("");
    QTest::newRow("three digits") << 12.345 << none << none << 1;
    QTest::newRow("small") << 0.00123 << none << none << 5;
    QTest::newRow("large") << 1234.5 << none << none << 0;
    QTest::newRow("zero") << 0.0 << none << none << 0;
    QTest::newRow("wide interval") << 12.345 << 3.0 << 40.0 << 0;
    QTest::newRow("wide beside a small mean") << 0.05 << 0.0 << 0.2 << 2;
    QTest::newRow("narrow interval") << 30.05 << 30.02 << 30.08 << 2;
    QTest::newRow("usual interval") << 12.345 << 11.8 << 12.9 << 1;
    QTest::newRow("very narrow") << 0.991367 << 0.991357 << 0.991380 << 5;
    QTest::newRow("zero width") << 12.345 << 12.345 << 12.345 << 1;
  }
  void decimals_followTheInterval() {
    QFETCH(double, value);
    QFETCH(double, low);
    QFETCH(double, high);
    QTEST(decimalsFor(value, {low, high}), "decimals");
  }

  /// Holm by hand: 3 × 2 / 256, then 2 × 4 / 256, then 50 / 256.
  void holm_coversAllTestsOfTheTable() {
    const Study study = studyOf({kAllLower, kMostHigher, kUnclear});
    const Comparisons all = comparedAll(study);
    QCOMPARE(all[0].pairs[0].p, 2.0 / 256.0);
    QCOMPARE(all[0].pairs[0].adjusted, 6.0 / 256.0);
    QCOMPARE(all[1].pairs[0].adjusted, 8.0 / 256.0);
    QCOMPARE(all[2].pairs[0].adjusted, 50.0 / 256.0);
    QCOMPARE(all[0].pairs[0].cases[0].adjusted, 6.0 / 256.0);
    QCOMPARE(testCounts(all).pairs, std::size_t{3});
    const std::string caption = pairsTable(study, all, true).caption;
    QVERIFY2(caption.find("adjusted over all 3 tests") != std::string::npos, caption.c_str());
    QVERIFY(resultsTable(study, all, {}).caption.find("over all 3 tests") != std::string::npos);
  }

  /// Ten metrics with 2 / 256 each: none is significant any more, 20 / 256 > 0.05.
  void holm_manyMetrics_areNoFindings() {
    const Study study = studyOf(std::vector<std::vector<double>>(10, kAllLower));
    const Comparisons all = comparedAll(study);
    QCOMPARE(all[9].pairs[0].adjusted, 20.0 / 256.0);
    QVERIFY(all[0].relativeToBest[1] == RelativeToBest::NotDifferent);
    QCOMPARE(plain(verdictMarkup(study, all)),
             QStringLiteral("With 8 seeds, no difference could be shown in any metric. Paired "
                            "tests, p < 0.05 after Holm's adjustment over 10 tests."));
  }

  /// Of the 36 means of pairs of 1 … 8 the median is 4.5, the fourth from each end 2 and 7; with -1
  /// instead of 1 they are 4.5, 1.5 and 7 (Hollander & Wolfe 1999, table A.4: P(T <= 3) = 0.0195).
  void verdict_saysWhoIsBetterByHowMuch() {
    const Study study = studyOf({kAllLower, kMostHigher, kUnclear});
    QCOMPARE(plain(verdictMarkup(study, comparedAll(study))),
             QStringLiteral("alpha is better than beta in Metric A by 4.5 m (95 % CI 2.0 to 7.0). "
                            "beta is better than alpha in Metric B by 4.5 m (95 % CI 1.5 to 7.0). "
                            "With 8 seeds, no difference could be shown in Metric C. Paired tests, "
                            "p < 0.05 after Holm's adjustment over 3 tests."));
  }

  /// Metric A differs by 4.5 % of the mean, Metric B by 45 %: 4.5 of 10. Contacts, although they
  /// differ by less than 2 %, and the time are named before.
  void verdict_leadsWithWhatMatters() {
    Study study = studyOf({kAllLower, kAllLower, kAllLower, kAllLower});
    for (double& value : study.results.metrics[1]) {
      value -= 90.0;
    }
    study.metrics[2].key = "time_to_reach_goal";
    study.metrics[3].key = "robot2.obstacle_collisions";
    for (double& value : study.results.metrics[3]) {
      value += 900.0;
    }
    const QString verdict = plain(verdictMarkup(study, comparedAll(study)));
    const QString number = QStringLiteral(" by [^;]*");
    const QRegularExpression order(QStringLiteral("^alpha is better than beta in Metric D") +
                                   number + QStringLiteral("; Metric C") + number +
                                   QStringLiteral("; Metric B") + number +
                                   QStringLiteral("; Metric A by "));
    QVERIFY2(order.match(verdict).hasMatch(), qPrintable(verdict));
  }

  /// 4.5 of 1000 is significant, and too little to matter.
  void verdict_smallDifferences_areOnlyNamed() {
    Study study = studyOf({kAllLower, kMostHigher});
    for (double& value : study.results.metrics[0]) {
      value += 900.0;
    }
    const QString verdict = plain(verdictMarkup(study, comparedAll(study)));
    QVERIFY2(verdict.startsWith(QStringLiteral("beta is better than alpha in Metric B by 4.5 m")),
             qPrintable(verdict));
    QVERIFY2(verdict.contains(
                 QStringLiteral("Better by less than 2 % of the mean: alpha in Metric A. ")),
             qPrintable(verdict));
    QVERIFY2(!verdict.contains(QStringLiteral("Metric A by")), qPrintable(verdict));
  }

  /// All eight against none of eight: McNemar 2 / 256. An option that never succeeds is compared by
  /// success alone.
  void verdict_optionThatNeverSucceeds_isComparedBySuccessAlone() {
    Study study = studyOf({kAllLower, kAllLower});
    study.results.keys[0] = "success";
    study.metrics[0] = {"success", "Success", "-", true, 1};
    for (std::size_t run = 0; run < study.runCount(); ++run) {
      study.results.metrics[0][run] = study.optionOf[run] == 0 ? 1.0 : 0.0;
    }
    const QString verdict = plain(verdictMarkup(study, comparedAll(study)));
    QVERIFY2(verdict.startsWith(QStringLiteral(
                 "alpha is better than beta in Success by 100 percentage points (95 % CI ")),
             qPrintable(verdict));
    QVERIFY2(verdict.contains(QStringLiteral("beta never succeeds, so only success is compared")),
             qPrintable(verdict));
    QVERIFY2(!verdict.contains(QStringLiteral("Metric B")), qPrintable(verdict));
  }

  /// Eight times the same run of each option is one run of each: no test, and no "better".
  void verdict_allSeedsAlike_claimsNothing() {
    const Study same = studyOf({std::vector<double>(8, -1.0), std::vector<double>(8, 2.0)});
    QVERIFY(isOneRunPerCell(same));
    QCOMPARE(plain(verdictMarkup(same, comparedAll(same))),
             QStringLiteral("All seeds gave the same values: there is only one distinct run per "
                            "option, so no difference between options can be tested."));
    // One option that depends on the seed is enough for pairs that differ.
    QVERIFY(!isOneRunPerCell(studyOf({kAllLower})));
  }

  /// The number of tests is that of the metrics named.
  void verdict_metricWithoutATest_isNotNamed() {
    Study study = studyOf({kAllLower, kUnclear, kUnclear});
    std::fill(study.results.metrics[2].begin(), study.results.metrics[2].end(), std::nan(""));
    const Comparisons all = comparedAll(study);
    const QString verdict = plain(verdictMarkup(study, all));
    QVERIFY2(verdict.contains(QStringLiteral("no difference could be shown in Metric B.")),
             qPrintable(verdict));
    QVERIFY2(!verdict.contains(QStringLiteral("Metric C")), qPrintable(verdict));
    QVERIFY2(verdict.contains(QStringLiteral("over 2 tests")), qPrintable(verdict));
  }

  void verdict_neutralOrSingleOption_isEmpty() {
    Study study = studyOf({kAllLower});
    study.metrics[0].sense = 0;
    QCOMPARE(verdictMarkup(study, comparedAll(study)), std::string());
    study.metrics[0].sense = -1;
    study.options = {"alpha"};
    std::fill(study.optionOf.begin(), study.optionOf.end(), 0);
    QCOMPARE(verdictMarkup(study, comparedAll(study)), std::string());
  }

  /// The third option is 20 above the second, whose mean is lower than that of the first by 2.5.
  void verdict_threeOptions_namesTheNearest() {
    Study study = studyOf({kUnclear});
    study.options.emplace_back("gamma");
    for (long long seed = 1; seed <= 8; ++seed) {
      Results::Run run;
      run.seed = seed;
      study.results.runs.push_back(run);
      study.results.metrics[0].push_back(120.0);
      study.optionOf.push_back(2);
      study.caseOf.push_back(0);
    }
    const QString verdict = plain(verdictMarkup(study, comparedAll(study)));
    QVERIFY2(
        verdict.startsWith(QStringLiteral("beta is best in Metric A, better than gamma by 20.0 m, "
                                          "not significantly different from alpha. ")),
        qPrintable(verdict));
  }

  void captions_sayWhatIsDrawn() {
    Study study = studyOf({kAllLower, kMostHigher});
    const auto captionOf = [&study] {
      const Comparisons all = comparedAll(study);
      return paretoFigure(study, all[0], all[1])->caption;
    };
    QVERIFY2(captionOf().find("the dashed line connects the Pareto-optimal") != std::string::npos,
             captionOf().c_str());
    study.results.metrics[1] = study.results.metrics[0];  // alpha is better in both
    QVERIFY2(captionOf().find("alpha is the only Pareto-optimal option.") != std::string::npos,
             captionOf().c_str());
    study = studyOf({{1, 2, 3}});  // three pairs have no interval of 95 %
    const std::string few = differencesFigure(study, comparedAll(study))->caption;
    QVERIFY2(few.find("too few pairs for an interval") != std::string::npos, few.c_str());
    study = studyOf({kAllLower});
    const std::string enough = differencesFigure(study, comparedAll(study))->caption;
    QVERIFY2(enough.find("too few pairs") == std::string::npos, enough.c_str());
  }
};

QTEST_APPLESS_MAIN(ReportVerdictTest)
#include "tst_ReportVerdict.moc"
