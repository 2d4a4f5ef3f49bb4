#include <algorithm>
#include <cmath>

#include <QtTest>

#include "app/studies/Gate.h"
#include "metrics/statistics/PairedTests.h"
#include "sim2d/base/Rng.h"

using app::GateMetric;
using app::GatePair;
using app::GateVerdict;
using app::ResultRow;

namespace {

/// A run without undefined values.
ResultRow rowOf(bool success, double time, double intimate = 10.0, int contacts = 0) {
  ResultRow row;
  row.ok = true;
  row.fields = {{"success", success ? "True" : "False"},
                {"time_to_reach_goal", success ? std::to_string(time) : std::string()},
                {"intimate_space_intrusions", std::to_string(intimate)},
                {"robot_on_person_collision", std::to_string(contacts)}};
  return row;
}

/// Draws of a comparison, independent for each number.
class Draws {
 public:
  explicit Draws(int comparison) : comparison_(comparison) {}
  double uniform() { return rng().uniform01(base::DrawPurpose::Test, number_++); }
  double normal(double mean, double deviation) {
    return rng().normal(mean, deviation, base::DrawPurpose::Test, number_++);
  }

 private:
  base::AgentRng rng() const { return {7, 0, static_cast<std::uint64_t>(comparison_)}; }
  int comparison_;
  std::uint32_t number_ = 0;
};

/// How the runs of a candidate differ from those of the base.
struct Change {
  double failures = 0.0;  // added share
  double slower = 1.0;    // factor of the time
};

/// Runs of two options that are as good as each other except for the change.
GatePair drawnPair(Draws& draws, const Change& change) {
  const bool isEasy = draws.uniform() < 0.95;
  const double time = draws.normal(20.0, 3.0);
  const bool isSpoilt = draws.uniform() < change.failures / 0.95;
  GatePair pair;
  pair.base = rowOf(isEasy, time * draws.normal(1.0, 0.03), draws.normal(10.0, 1.0));
  pair.candidate = rowOf(isEasy && !isSpoilt, time * change.slower * draws.normal(1.0, 0.03),
                         draws.normal(10.0, 1.0));
  return pair;
}

struct Outcome {
  GateVerdict verdict = GateVerdict::Undecided;
  int pairs = 0;
};

Outcome simulatedGate(int comparison, const Change& change, int most) {
  Draws draws(comparison);
  app::GateTest test(app::defaultGateMetrics(), 0.05);
  Outcome outcome;
  while (outcome.pairs < most && test.verdict() == GateVerdict::Undecided) {
    test.addRound({drawnPair(draws, change)});
    ++outcome.pairs;
  }
  outcome.verdict = test.verdict();
  return outcome;
}

/// Comparisons with the verdict, and their median number of pairs.
struct Summary {
  int pass = 0, worse = 0, medianPairs = 0;
};

Summary summaryOf(int comparisons, const Change& change, int most) {
  Summary summary;
  std::vector<int> pairs;
  for (int k = 0; k < comparisons; ++k) {
    const Outcome outcome = simulatedGate(k, change, most);
    summary.pass += outcome.verdict == GateVerdict::Pass ? 1 : 0;
    summary.worse += outcome.verdict == GateVerdict::Worse ? 1 : 0;
    pairs.push_back(outcome.pairs);
  }
  std::sort(pairs.begin(), pairs.end());
  summary.medianPairs = pairs[pairs.size() / 2];
  qInfo("pass %d, worse %d, median of pairs %d", summary.pass, summary.worse, summary.medianPairs);
  return summary;
}

GateMetric metricOf(const char* text) {
  return *app::parseGateMetric(text);
}

std::string problemOf(const char* text) {
  const auto metric = app::parseGateMetric(text);
  return metric ? std::string() : std::string(metric.diagnostics().front().code);
}

}  // namespace

/// The sequential test of a gate, on runs that are drawn instead of simulated.
class GateDecisionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void metric_texts_giveScalesAndMargins() {
    const GateMetric success = metricOf("success:5%");
    QVERIFY(success.scale == GateMetric::Scale::Rate && success.margin == 0.05);
    QCOMPARE(success.sense, 1);
    const GateMetric time = metricOf("time_to_reach_goal:15%");
    QVERIFY(time.scale == GateMetric::Scale::Ratio && time.margin == 0.15);
    QCOMPARE(time.sense, -1);
    const GateMetric length = metricOf("path_length:0.5");
    QVERIFY(length.scale == GateMetric::Scale::Difference && length.margin == 0.5);
    const GateMetric contact = metricOf("robot_on_person_collision>0:0.02");
    QVERIFY(contact.scale == GateMetric::Scale::Rate && contact.threshold == 0.0);
    QCOMPARE(contact.label(), std::string("robot_on_person_collision>0"));
    QVERIFY(metricOf("robot2.success:0.1").scale == GateMetric::Scale::Rate);
  }

  void metric_wrongTexts_areRefused() {
    QCOMPARE(problemOf("sucess:5%"), std::string("metrics.unknown-metric"));
    QCOMPARE(problemOf("crowd_density:1"), std::string("gate.no-better"));
    for (const char* text : {"success", "success:", "success:0", "success:100%", "success:-1%",
                             "path_length:nan", "path_length>x:1%", "time_to_reach_goal:120%"}) {
      QCOMPARE(problemOf(text), std::string("gate.metric"));
    }
  }

  void gain_isPositiveWhereTheCandidateIsBetter() {
    const ResultRow good = rowOf(true, 20.0, 10.0);
    const ResultRow slow = rowOf(true, 22.0, 13.0, 1);
    const auto gain = [&](const char* metric) {
      return app::gainOf(metricOf(metric), good, slow).gain;
    };
    QCOMPARE(gain("success:5%"), 0.0);
    QVERIFY(std::abs(gain("time_to_reach_goal:5%") + std::log(1.1)) < 1e-9);
    QVERIFY(std::abs(gain("intimate_space_intrusions:2") + 3.0) < 1e-9);
    QVERIFY(std::abs(gain("intimate_space_intrusions:0.1") + 1.0) < 1e-9);  // ten margins
    QCOMPARE(gain("robot_on_person_collision>0:5%"), -1.0);
    QCOMPARE(app::gainOf(metricOf("robot_on_person_collision>0:5%"), slow, good).gain, 1.0);
  }

  /// A missing time of a failed run counts as the worst; of two failed runs, as no difference.
  void gain_missingValues_followSuccess() {
    const GateMetric time = metricOf("time_to_reach_goal:5%");
    const ResultRow good = rowOf(true, 20.0);
    const ResultRow failed = rowOf(false, 0.0);
    ResultRow unmeasured = good;
    unmeasured.fields[1].second.clear();
    ResultRow crashed;
    crashed.reason = "the process crashed";
    const double most = 10.0 * std::log(1.05);
    QCOMPARE(app::gainOf(time, good, failed).gain, -most);
    QCOMPARE(app::gainOf(time, failed, good).gain, most);
    QCOMPARE(app::gainOf(time, good, crashed).gain, -most);
    QCOMPARE(app::gainOf(time, failed, crashed).gain, 0.0);
    QCOMPARE(app::gainOf(time, good, unmeasured).gain, 0.0);
    QVERIFY(!app::gainOf(time, good, unmeasured).candidate);
  }

  /// With a margin of 5 points and no difference at all, the wealth against the margin grows by
  /// 1 + θ / 19 per pair for each stake θ.
  void verdict_equalRuns_passAfterTheComputedNumber() {
    int wanted = 0;
    double wealth = 1.0;
    while (wealth < 20.0) {
      ++wanted;
      wealth = 0.0;
      const std::pair<double, double> stakes[] = {
          {1.0, 0.6}, {0.6, 0.15}, {0.36, 0.1}, {0.2, 0.1}, {0.1, 0.05}};
      for (const auto& [share, weight] : stakes) {
        wealth += weight * std::pow(1.0 + share / 19.0, wanted);
      }
    }
    app::GateTest test({metricOf("success:5%"), metricOf("time_to_reach_goal:5%")}, 0.05);
    int pairs = 0;
    while (test.verdict() == GateVerdict::Undecided && pairs < 1000) {
      test.addRound({{0, 1, rowOf(true, 20.0), rowOf(true, 20.0)}});
      ++pairs;
    }
    QVERIFY(test.verdict() == GateVerdict::Pass);
    QCOMPARE(pairs, wanted);
    QVERIFY(test.metrics()[1].pairs < wanted);  // ten margins of range instead of twenty
  }

  void verdict_unmeasuredMetric_hasNoSayUnlessRequested() {
    ResultRow noPeople = rowOf(true, 20.0);
    noPeople.fields[2].second.clear();
    for (const bool isRequested : {false, true}) {
      std::vector<GateMetric> metrics = {metricOf("success:20%"),
                                         metricOf("intimate_space_intrusions:2")};
      metrics[1].isRequested = isRequested;
      app::GateTest test(metrics, 0.05);
      for (int k = 0; k < 60; ++k) {
        test.addRound({{0, k, noPeople, noPeople}});
      }
      QVERIFY(test.verdict() == (isRequested ? GateVerdict::Undecided : GateVerdict::Pass));
      QCOMPARE(test.metrics()[1].defined, 0);
    }
  }

  void verdict_equallyGoodCandidates_atMost5PercentFalseAlarms() {
    const Summary summary = summaryOf(200, {}, 120);
    QVERIFY(summary.worse <= 10);
    QVERIFY(summary.pass >= 150);
  }

  /// 10 points of success lost: found in at least 95 %, in the median with at most half the pairs
  /// of McNemar's test for the same error probabilities (Connor 1987).
  void verdict_tenPointsOfSuccessLost_isWorse() {
    const Summary summary = summaryOf(100, {0.1, 1.0}, 200);
    QVERIFY(summary.worse >= 95);
    const double fixed = statistics::pairsForMcNemar(0.1, 0.0, {2.0 * 0.05 / 4.0, 0.95});
    QVERIFY(summary.medianPairs <= 0.5 * fixed);
  }

  void verdict_15PercentSlower_isWorse() {
    const Summary summary = summaryOf(100, {0.0, 1.15}, 100);
    QVERIFY(summary.worse >= 95);
    QVERIFY(summary.medianPairs <= 40);
  }

  /// A candidate at the margin passes with a probability of at most 5 %.
  void verdict_candidateAtTheMargin_rarelyPasses() {
    QVERIFY(summaryOf(300, {0.05, 1.0}, 150).pass <= 15);
  }
};

QTEST_APPLESS_MAIN(GateDecisionTest)
#include "tst_Gate.moc"
