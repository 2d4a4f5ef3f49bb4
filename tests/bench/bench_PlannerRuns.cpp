#include <QTemporaryDir>
#include <QtTest>

#include "app/run/ExperimentRunner.h"
#include "sim2d/base/Text.h"
#include "tests/bench/FastestOf.h"

/// Whole runs of `crossing_agents` with files of Nav2 beside `pursuit`: simulated time per
/// processor time, with all metrics and without files. Goals on an idle core: MPPI (turtlebot4) 60,
/// DWB (turtlebot3) 150, Regulated Pure Pursuit 300.
class PlannerRunsBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void run_inTheCrossing_data();
  void run_inTheCrossing();
};

void PlannerRunsBench::run_inTheCrossing_data() {
  QTest::addColumn<QString>("values");
  QTest::newRow("pursuit") << QStringLiteral("[pursuit]");
  for (const char* file :
       {"resources/nav2_params/turtlebot4", "resources/nav2_params/turtlebot3",
        "maps/planners/nav2_mppi", "maps/planners/nav2_dwb", "maps/planners/nav2_rpp"}) {
    QTest::newRow(file)
        << QStringLiteral(
               "[nav2]\n"
               "  robot1.nav2_params: [" SOURCE_DIR
               "/%1.yaml]\n"
               "  robot1.nav2_tree: [" SOURCE_DIR
               "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml]")
               .arg(QLatin1String(file));
  }
}

void PlannerRunsBench::run_inTheCrossing() {
  QFETCH(const QString, values);
  constexpr std::size_t kRuns = 30;
  QTemporaryDir folder;
  const std::string file = folder.filePath(QStringLiteral("e.yaml")).toStdString();
  const std::string text = "hunavsim_experiment: 1\nscenarios: [" SOURCE_DIR
                           "/maps/planners/crossing_agents.yaml]\nseeds: " +
                           std::to_string(kRuns + 1) +
                           "\nvalues:\n  robot1.planner: " + values.toStdString() + "\n";
  QVERIFY(base::writeFileAtomically(file, text).empty());
  const auto experiment = app::readExperiment(file);
  QVERIFY(experiment);
  app::ExperimentRunner runner(*experiment, folder.path().toStdString() + "/runs", {});
  const auto problems = runner.check();
  QVERIFY2(!base::hasErrors(problems), problems.empty() ? "" : problems.front().text().c_str());
  QVERIFY(runner.run(0)->ok);  // reads what all have in common
  double simulated = 0.0;      // of all runs [s]
  const double start = processorMs();
  for (std::size_t run = 1; run <= kRuns; ++run) {
    simulated += base::parseDouble(runner.run(run)->simulated).value_or(0.0);
  }
  const double taken = processorMs() - start;
  QVERIFY(simulated > 10.0 * kRuns);
  qInfo("%.0f times real time (%.0f s)", 1e3 * simulated / taken, simulated);
  QTest::setBenchmarkResult(taken / simulated, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(PlannerRunsBench)
#include "bench_PlannerRuns.moc"
