#include <algorithm>
#include <memory>
#include <vector>

#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/bag/RunBagWriter.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"
#include "app/run/Session.h"
#include "tests/bench/FastestOf.h"

/// What a bag beside the other files adds to the time of a run, 60 s of scenes with a robot, as it
/// passes on the wall: messages are made, compressed and written in a thread of their own. Wanted:
/// 5 % at most (with a second core), the median of runs side by side.
class BagBench : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void run_data();
  void run();
};

namespace {

constexpr int kRounds = 30;

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// False: it did not work.
bool runInto(const std::string& folder, const app::Bundle& bundle, bool hasBag) {
  app::Verdict verdict = app::check(bundle);
  auto output = app::OutputFolder::open(folder, true);
  if (!verdict.world || !output) {
    return false;
  }
  app::RunWriter writer((*output)->staging(), *verdict.world, verdict.world->header(),
                        verdict.metrics.selection, verdict.metrics.parameters);
  std::unique_ptr<bridge::BagFolderWriter> bag;
  if (hasBag) {
    verdict.world->enableScans(true);
    bag = std::make_unique<bridge::BagFolderWriter>((*output)->staging(), *bundle.scenario,
                                                    *verdict.world);
    writer.setAdditionalWriter(bag.get());
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
  app::RunSpec options;
  options.scenario = SOURCE_DIR "/maps/" + scenario.toStdString();
  options.duration = 60.0;
  const app::Bundle bundle = app::readBundle(options, app::RunSettings{}, sim2d::ImageLoader());
  std::vector<double> without, with, ratios;
  for (int round = 0; round < kRounds; ++round) {
    double times[2] = {};
    for (const bool hasBag : {round % 2 == 0, round % 2 == 1}) {  // who is first takes turns
      const std::string into =
          folder.filePath(QString::number(2 * round + int(hasBag))).toStdString();
      bool isFine = false;
      times[hasBag ? 1 : 0] = fastestOf(1, [&] { isFine = runInto(into, bundle, hasBag); });
      QVERIFY(isFine);
    }
    without.push_back(times[0]);
    with.push_back(times[1]);
    ratios.push_back(times[1] / times[0]);
  }
  qInfo("%.0f ms without, %.0f ms with a bag, a bag takes %+.1f %% (medians)", medianOf(without),
        medianOf(with), 100.0 * (medianOf(ratios) - 1.0));
  QTest::setBenchmarkResult(medianOf(with) - medianOf(without), QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(BagBench)
#include "bench_Bag.moc"
