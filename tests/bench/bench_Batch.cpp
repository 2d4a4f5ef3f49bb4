#include <QTemporaryDir>
#include <QtTest>

#include "app/run/ExperimentRunner.h"
#include "sim2d/base/Text.h"
#include "tests/bench/FastestOf.h"

/// What a further run of a batch takes in a worker, in processor time: 60 s of the café with 8
/// people and a robot by `pursuit`, all metrics, no files. Limit: 40 ms. A process of its own for
/// each run, as it was before, took 192 ms.
class BatchBench : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void episode_data();
  void episode();
};

void BatchBench::episode_data() {
  QTest::addColumn<QString>("values");
  QTest::newRow("seeds") << QString();
  QTest::newRow("seeds, drawn speeds, planner set") << QStringLiteral(
      "values:\n  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n"
      "  robot1.planner: [pursuit]\n");
}

void BatchBench::episode() {
  QFETCH(QString, values);
  constexpr std::size_t kRuns = 40;
  QTemporaryDir folder;
  const std::string file = folder.filePath(QStringLiteral("e.yaml")).toStdString();
  const std::string text = "hunavsim_experiment: 1\nscenarios: [" SOURCE_DIR
                           "/maps/corner_cafe/corner_cafe_agents.yaml]\nduration: 60.0\nseeds: " +
                           std::to_string(kRuns + 1) + "\n" + values.toStdString();
  QVERIFY(base::writeFileAtomically(file, text).empty());
  const app::Experiment experiment = *app::readExperiment(file);
  app::ExperimentRunner runner(experiment, folder.path().toStdString() + "/runs", {});
  QVERIFY(runner.check().empty());
  QVERIFY(runner.run(0)->ok);  // reads what all have in common
  const double start = processorMs();
  for (std::size_t run = 1; run <= kRuns; ++run) {
    QVERIFY(runner.run(run)->ok);
  }
  const double each = (processorMs() - start) / static_cast<double>(kRuns);
  QTest::setBenchmarkResult(each, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(BatchBench)
#include "bench_Batch.moc"
