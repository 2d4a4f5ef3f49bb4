#include <filesystem>
#include <iterator>

#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/bag/RunBagWriter.h"
#include "app/run/Bundle.h"
#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"
#include "sim2d/base/Text.h"
#include "tests/support/FullDisk.h"

using namespace bridge;

namespace {

app::Bundle cafe(int recordEvery) {
  app::RunSpec options;
  options.scenario = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";
  options.recordEvery = recordEvery;
  return app::readBundle(options, app::RunSettings{}, sim2d::ImageLoader());
}

sim2d::StepInputs orderAndNewcomer(int step) {
  sim2d::Input order;
  order.kind = sim2d::InputKind::Goal;
  order.id = -1;
  order.pose.position = {7.8, 0.9};
  sim2d::Input newcomer;
  newcomer.kind = sim2d::InputKind::Add;
  newcomer.name = "Ben";
  newcomer.id = 100 + step;
  newcomer.pose.position = {3.0 + 0.02 * step, 4.5};
  return step < 100 ? sim2d::StepInputs{order, newcomer} : sim2d::StepInputs{order};
}

std::string bytesOf(const std::string& file) {
  const base::Result<std::string> text = base::readTextFile(file);
  return text ? *text : std::string();
}

}  // namespace

/// The bag that a thread of its own makes beside a run.
class RunBagFolderTest : public QObject {
  Q_OBJECT

 private:
  std::string path(const std::string& name) const {
    return folder_.filePath(QString::fromStdString(name)).toStdString();
  }

  QTemporaryDir folder_;

 private Q_SLOTS:
  /// What goes through the thread beside what is written at once, of so many steps: none, less than
  /// what is handed over together, just that, one more, often, more than may wait. Every third
  /// state is recorded, or each; orders come between them, and somebody enters.
  void anySteps_isTheBagMadeAtOnce_data() {
    QTest::addColumn<int>("steps");
    QTest::addColumn<int>("recordEvery");
    for (const int steps : {0, 5, 16, 17, 48, 49, 300}) {
      QTest::addRow("%d", steps) << steps << 3;
    }
    QTest::newRow("1000, all recorded") << 1000 << 1;
  }
  void anySteps_isTheBagMadeAtOnce() {
    QFETCH(const int, steps);
    QFETCH(const int, recordEvery);
    const app::Bundle bundle = cafe(recordEvery);
    const app::Verdict verdict = app::check(bundle);
    QVERIFY(verdict.world);
    sim2d::World& world = *verdict.world;
    world.enableScans(true);
    auto output = app::OutputFolder::open(path("thread") + std::to_string(steps), false);
    QVERIFY(static_cast<bool>(output));
    BagFolderWriter folder((*output)->staging(), *bundle.scenario, world);
    const std::string atOnce = path("at-once.mcap");
    RunBagWriter bag(atOnce, world.header(), lidarsOf(*bundle.scenario));
    for (int step = 0; step < steps; ++step) {
      QVERIFY(world.step(step % 7 == 4 ? orderAndNewcomer(step) : sim2d::StepInputs{}));
      QVERIFY(world.refused().empty());
      folder.append(world.frame());
      bag.setHeader(world.header());
      bag.append(world.frame());
    }
    folder.conclude(world.header());
    QVERIFY(folder.finish(**output).empty());
    QVERIFY(bag.finish(world.header()).empty());
    QVERIFY(!folder.hasFailed());
    const std::string made = bytesOf((*output)->staging() + "/" + kBagFiles[0]);
    QVERIFY(made.size() > 1000 && made == bytesOf(atOnce));
    QVERIFY((*output)->commit("{}", app::OutputFolder::EarlierFiles::Removed).empty());
    const auto manifest = nlohmann::json::parse(bytesOf((*output)->path() + "/manifest.json"));
    QCOMPARE(manifest["outputs"].size(), std::size(kBagFiles));
    for (const nlohmann::json& file : manifest["outputs"]) {
      const std::string place = (*output)->path() + "/" + file["path"].get<std::string>();
      QVERIFY(app::sha256OfFile(place) == file["sha256"].get<std::string>());
    }
  }

  void fullDisk_isToldAndEnds() {
    const app::Bundle bundle = cafe(1);
    const app::Verdict verdict = app::check(bundle);
    auto output = app::OutputFolder::open(path("full"), false);
    QVERIFY(verdict.world && output);
    {
      const support::FullDisk disk(4096);
      BagFolderWriter folder((*output)->staging(), *bundle.scenario, *verdict.world);
      for (int step = 0; step < 2000 && !folder.hasFailed(); ++step) {
        QVERIFY(verdict.world->step());
        folder.append(verdict.world->frame());
      }
      QVERIFY(folder.hasFailed());
      folder.conclude(verdict.world->header());
      QVERIFY(base::hasErrors(folder.finish(**output)));
    }
    QVERIFY(!std::filesystem::exists((*output)->staging() + "/" + kBagFiles[0]));
  }

  /// The run came to nothing, before or after its end.
  void leftEarly_leavesNothingBehind() {
    const app::Bundle bundle = cafe(1);
    const app::Verdict verdict = app::check(bundle);
    for (const bool isConcluded : {false, true}) {
      const std::string name = path("left") + (isConcluded ? "1" : "0");
      {
        auto output = app::OutputFolder::open(name, false);
        QVERIFY(verdict.world && output);
        BagFolderWriter folder((*output)->staging(), *bundle.scenario, *verdict.world);
        for (int step = 0; step < 20; ++step) {
          QVERIFY(verdict.world->step());
          folder.append(verdict.world->frame());
        }
        if (isConcluded) {
          folder.conclude(verdict.world->header());
        }
      }
      QVERIFY(!std::filesystem::exists(name));
    }
  }
};

QTEST_APPLESS_MAIN(RunBagFolderTest)
#include "tst_BagFolderWriter.moc"
