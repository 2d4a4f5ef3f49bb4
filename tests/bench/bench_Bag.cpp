#include <memory>

#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/bag/RunBagFolder.h"
#include "app/run/RunFolder.h"
#include "app/run/Session.h"
#include "app/run/Simulation.h"
#include "tests/bench/FastestOf.h"

/// What a bag beside the other files adds to the time of a run, 60 s of scenes with a robot, as it
/// passes on the wall: messages are made, compressed and written in a thread of their own. Wanted:
/// 5 % at most (with a second core).
class BagBench : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void run_data();
  void run();
};

namespace {

constexpr int kRounds = 5;

/// False: it did not work.
bool runInto(const std::string& folder, const app::Bundle& bundle, bool hasBag) {
  app::Verdict verdict = app::check(bundle);
  auto output = app::OutputFolder::open(folder, true);
  if (!verdict.world || !output) {
    return false;
  }
  app::RunWriter writer((*output)->staging(), *verdict.world, verdict.world->header(),
                        verdict.metrics.selection, verdict.metrics.parameters);
  std::unique_ptr<bridge::RunBagFolder> bag;
  if (hasBag) {
    verdict.world->tellScans(true);
    bag = std::make_unique<bridge::RunBagFolder>((*output)->staging(), *bundle.scenario,
                                                 *verdict.world);
    writer.setCompanion(bag.get());
  }
  app::Session session(sim2d::stopRuleOf(*bundle.scenario));
  const app::FinishedRun run =
      app::simulate(session, *verdict.world, verdict.scenarioMetrics, writer,
                    [](const sim2d::Frame& /*frame*/) { return false; });
  return app::errorsOf(app::writeRunFolder(**output, run, writer, bundle, {"hunavsim"})).empty();
}

}  // namespace

void BagBench::run_data() {
  QTest::addColumn<QString>("scenario");
  QTest::newRow("cafe, 8 people") << QStringLiteral("corner_cafe/corner_cafe_agents.yaml");
}

void BagBench::run() {
  QFETCH(const QString, scenario);
  QTemporaryDir folder;
  app::RunOptions options;
  options.scenario = SOURCE_DIR "/maps/" + scenario.toStdString();
  options.duration = 60.0;
  const app::Bundle bundle = app::readBundle(options, app::RunSettings{}, sim2d::ImageLoader());
  double times[2] = {1e18, 1e18};
  for (int round = 0; round < kRounds; ++round) {
    for (const bool hasBag : {false, true}) {
      const std::string into =
          folder.filePath(QString::number(2 * round + int(hasBag))).toStdString();
      bool isFine = false;
      times[hasBag ? 1 : 0] = std::min(
          times[hasBag ? 1 : 0], fastestOf(1, [&] { isFine = runInto(into, bundle, hasBag); }));
      QVERIFY(isFine);
    }
  }
  qInfo("%.0f ms without, %.0f ms with a bag: %+.1f %%", times[0], times[1],
        100.0 * (times[1] / times[0] - 1.0));
  QTest::setBenchmarkResult(times[1] - times[0], QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(BagBench)
#include "bench_Bag.moc"
