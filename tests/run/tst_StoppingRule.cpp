#include <cmath>

#include <QtTest>

#include "app/run/Experiment.h"

using app::Experiment;
using app::ResultRow;
using app::StoppingCheck;

namespace {

const std::string kScene = SOURCE_DIR "/maps/planners/crossing_agents.yaml";
const std::string kOther = SOURCE_DIR "/maps/planners/doorway_agents.yaml";

std::string textWith(const std::string& until, const std::string& scenarios = kScene) {
  return "hunavsim_experiment: 1\nscenarios: [" + scenarios +
         "]\nseeds: 100\nvalues:\n  robot1.planner: [pursuit, dwa]\nuntil: " + until + "\n";
}

Experiment experimentWith(const std::string& until, const std::string& scenarios = kScene) {
  const auto experiment = app::parseExperiment(textWith(until, scenarios), "test.yaml");
  return experiment ? *experiment : Experiment();
}

ResultRow rowWith(const char* key, const std::string& value) {
  ResultRow row;
  row.ok = true;
  row.fields = {{key, value}};
  return row;
}

/// The smallest look at which the check is content, with values by run; 0: none.
std::size_t enoughAfter(const Experiment& experiment,
                        const std::function<ResultRow(const Experiment::Run&)>& rowOf) {
  StoppingCheck check(experiment);
  for (std::size_t run = 0; run < experiment.runCount(); ++run) {
    check.add(run, rowOf(experiment.run(run)));
  }
  for (const std::size_t look : check.looks()) {
    if (check.isEnough(look)) {
      return look;
    }
  }
  return 0;
}

/// The smallest number of equal factors 1 + θ gain with which the wealth reaches 2 pairs / 0.05.
int seedsFor(double gain, double pairs = 1.0) {
  int seeds = 0;
  for (double wealth = 1.0; wealth < 40.0 * pairs;) {
    ++seeds;
    wealth = 0.0;
    const std::pair<double, double> stakes[] = {
        {1.0, 0.3}, {0.6, 0.2}, {0.36, 0.2}, {0.2, 0.2}, {0.1, 0.1}};
    for (const auto& [share, weight] : stakes) {
      wealth += weight * std::pow(1.0 + share * gain, seeds);
    }
  }
  return seeds;
}

std::size_t nextLook(int seeds, int step) {
  return static_cast<std::size_t>((seeds + step - 1) / step * step);
}

}  // namespace

/// The key `until` of experiments.
class StoppingRuleTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void read_rules_haveRangesOfTheirMetrics() {
    const Experiment success = experimentWith("{metric: success, halfwidth: 0.05}");
    QVERIFY(success.until && success.until->halfWidth == 0.05);
    QVERIFY(success.until->range.low == 0.0 && success.until->range.high == 1.0);
    QCOMPARE(success.until->text(), std::string("the interval of success is at most ±0.05"));
    const Experiment share =
        experimentWith("{metric: intimate_space_intrusions, ranking: robot1.planner, level: 0.9}");
    QVERIFY(share.until->range.high == 100.0 && share.until->level == 0.9);
    const Experiment time =
        experimentWith("{metric: time_to_reach_goal, range: [0, 60], ranking: robot1.planner}");
    QVERIFY(time.until->range.high == 60.0);
  }

  void read_wrongRules_areErrorsAtTheirPlaces_data() {
    QTest::addColumn<QString>("until");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* until, const char* code) {
      QTest::newRow(until) << QString::fromUtf8(until) << QString::fromUtf8(code);
    };
    row("yes", "experiment.until-form");
    row("{metric: success}", "experiment.until-form");
    row("{halfwidth: 0.1}", "experiment.until-form");
    row("{metric: success, halfwidth: 0.1, ranking: robot1.planner}", "experiment.until-form");
    row("{metric: success, halfwidth: 0.1, seeds: 3}", "experiment.until-form");
    row("{metric: sucess, halfwidth: 0.1}", "experiment.until-metric");
    row("{metric: success, halfwidth: 0}", "experiment.until-number");
    row("{metric: success, halfwidth: 0.1, level: 95}", "experiment.until-number");
    row("{metric: time_to_reach_goal, halfwidth: 1}", "experiment.until-range");
    row("{metric: success, halfwidth: 0.1, range: [1, 0]}", "experiment.until-ends");
    row("{metric: success, ranking: robot1.max_vel}", "experiment.until-ranking");
    row("{metric: success, ranking: scenario}", "experiment.until-ranking");
  }
  void read_wrongRules_areErrorsAtTheirPlaces() {
    QFETCH(QString, until);
    QFETCH(QString, code);
    const auto experiment = app::parseExperiment(textWith(until.toStdString()), "test.yaml");
    QVERIFY(!experiment);
    QCOMPARE(std::string(experiment.diagnostics().front().code), code.toStdString());
    QCOMPARE(experiment.diagnostics().front().line, 6);
  }

  void read_fewSeeds_areAnError() {
    const auto experiment =
        app::parseExperiment("hunavsim_experiment: 1\nscenarios: [" + kScene +
                                 "]\nseeds: 4\nuntil: {metric: success, halfwidth: 0.1}\n",
                             "test.yaml");
    QVERIFY(!experiment);
    QVERIFY(experiment.diagnostics().front().code == "experiment.until-seeds");
  }

  /// Successes alone: the interval ends at 1, and begins at m where the factors are
  /// 1 - θ + θ / m. Two combinations make at least 8 seeds per look.
  void halfWidth_successesAlone_needTheComputedNumber() {
    for (const double halfWidth : {0.2, 0.05}) {
      const Experiment experiment =
          experimentWith("{metric: success, halfwidth: " + std::to_string(halfWidth) + "}");
      const double gain = 1.0 / (1.0 - 2.0 * halfWidth) - 1.0;
      QCOMPARE(enoughAfter(experiment, [](const auto&) { return rowWith("success", "True"); }),
               nextLook(seedsFor(gain), 8));
    }
  }

  /// A failed run counts as one without success; all options must have narrow intervals.
  void halfWidth_mixedOutcomes_needMore() {
    const Experiment experiment = experimentWith("{metric: success, halfwidth: 0.2}");
    const auto mixed = [](const Experiment::Run& run) {
      ResultRow row = rowWith("success", "True");
      row.ok = run.values[0] == "pursuit" || run.seed % 2 == 0;
      return row;
    };
    QVERIFY(enoughAfter(experiment, mixed) > 30);
  }

  void ranking_constantDifference_needsTheComputedNumber() {
    const Experiment experiment =
        experimentWith("{metric: time_to_reach_goal, ranking: robot1.planner, range: [0, 30]}",
                       kScene + ", " + kOther);
    const auto times = [](const Experiment::Run& run) {
      const double slower = run.values[0] == "dwa" ? 10.0 : 0.0;
      return rowWith("time_to_reach_goal",
                     std::to_string(10.0 + static_cast<double>(run.scenario) + slower));
    };
    QCOMPARE(enoughAfter(experiment, times), nextLook(seedsFor(10.0 / 30.0), 5));
  }

  void ranking_equalOptions_isNeverCertain() {
    const Experiment experiment = experimentWith("{metric: success, ranking: robot1.planner}");
    const auto equal = [](const Experiment::Run& run) {
      return rowWith("success", run.seed % 3 == 0 ? "False" : "True");
    };
    QCOMPARE(enoughAfter(experiment, equal), std::size_t{0});
  }

  void undefinedValues_areLeftOut() {
    const Experiment experiment =
        experimentWith("{metric: time_to_reach_goal, halfwidth: 12, range: [0, 30]}");
    QCOMPARE(enoughAfter(experiment, [](const auto&) { return rowWith("time_to_reach_goal", ""); }),
             std::size_t{0});
  }
};

QTEST_APPLESS_MAIN(StoppingRuleTest)
#include "tst_StoppingRule.moc"
