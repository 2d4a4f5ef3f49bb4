#include <memory>
#include <string>

#include <QTemporaryDir>
#include <QtTest>

#include "app/run/BatchFolder.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Text.h"
#include "tests/support/StruckCalls.h"

using app::BatchFolder;
using app::ExistingBatch;

/// The folder of a batch, whatever ends the process that writes into it.
class BatchFolderTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> place_;

  std::string folder() const { return place_->path().toStdString() + "/out"; }
  std::string textOf(const char* name) const {
    const base::Result<std::string> text = base::readTextFile(folder() + "/" + name);
    return text ? *text : "";
  }
  /// Three runs that fail, which is told in the table.
  static app::Study study() {
    app::Study three;
    three.version = "1";
    three.experimentPath = "e.yaml";
    three.experiment = "hunavsim_experiment: 1\n";
    three.inputs = {{"e.yaml", "00"}};
    three.runs = 3;
    return three;
  }
  static app::StoredRun runOf(std::size_t number) {
    const std::string reason = "reason " + std::to_string(number);
    return {number, "scene", 1, {}, app::rowOf({base::error("batch.no-results", {}, reason)})};
  }
  /// Runs [first, end) and the end of the process that made them, as batch does it.
  bool work(std::size_t first, std::size_t end, ExistingBatch earlier) const {
    const auto batch = BatchFolder::open(folder(), study(), earlier);
    if (!batch) {
      return false;
    }
    for (std::size_t run = first; run < end; ++run) {
      if (!(*batch)->store().has(run) && base::hasErrors((*batch)->add(runOf(run)))) {
        return false;
      }
    }
    return (*batch)->finish().empty();
  }

 private Q_SLOTS:
  void init() { place_ = std::make_unique<QTemporaryDir>(); }

  void finish_killed_canBeResumed_data() {
    QTest::addColumn<bool>("isResumed");
    QTest::newRow("at its first end") << false;
    QTest::newRow("after it was resumed") << true;
  }

  /// Killed at each call that changes the folder.
  void finish_killed_canBeResumed() {
    QFETCH(bool, isResumed);
    QVERIFY(work(0, 3, ExistingBatch::Refuse));
    const std::string expected = textOf("results.csv");
    QCOMPARE(base::split(expected, '\n').size(), std::size_t{5});  // head, three rows, end
    int kills = 0;
    for (int code = 9; code == 9; ++kills) {
      init();
      QVERIFY(!isResumed || work(0, 1, ExistingBatch::Refuse));
      code = struck::elsewhere([&] {
        struck::callsLeft = kills;
        return work(isResumed ? 1 : 0, 3, ExistingBatch::Resume) ? 0 : 1;
      });
      QVERIFY(code == 0 || code == 9);
      const std::string where = "call " + std::to_string(kills);
      QVERIFY2(app::completeCommit(folder()).empty(), where.c_str());
      QVERIFY2(app::checkManifestFiles(folder(), {"results.csv"}).empty(), where.c_str());
      QVERIFY2(work(0, 3, ExistingBatch::Resume), where.c_str());
      QVERIFY2(textOf("results.csv") == expected, where.c_str());
      QVERIFY2(textOf("manifest.json").find("\"finished\": 3") != std::string::npos, where.c_str());
      const QStringList left =
          QDir(QString::fromStdString(folder()))
              .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
      QCOMPARE(left.join(QLatin1Char(' ')),
               QStringLiteral("manifest.json results.csv results.sqlite"));
    }
    QVERIFY2(kills >= 10, QByteArray::number(kills));
  }

  void open_changedTable_isRefusedUntilReplaced() {
    QVERIFY(work(0, 3, ExistingBatch::Refuse));
    const std::string path = folder() + "/results.csv";
    QVERIFY(base::writeFileAtomically(path, "my remarks\n").empty());
    for (const ExistingBatch earlier : {ExistingBatch::Refuse, ExistingBatch::Resume}) {
      const auto refused = BatchFolder::open(folder(), study(), earlier);
      QVERIFY(!refused);
      QCOMPARE(refused.diagnostics().front().file, path);
      QCOMPARE(textOf("results.csv"), std::string("my remarks\n"));
    }
    QVERIFY(work(0, 3, ExistingBatch::Replace));
  }

  /// The machine ended one of three failed runs: a resumed batch repeats that one, a retry repeats
  /// all of them.
  void resume_failedRuns_areMissing_data() {
    QTest::addColumn<int>("earlier");
    QTest::addColumn<QVector<int>>("missing");
    QTest::newRow("resume") << static_cast<int>(ExistingBatch::Resume) << QVector<int>{1};
    QTest::newRow("retry") << static_cast<int>(ExistingBatch::Retry) << QVector<int>{1, 2};
  }
  void resume_failedRuns_areMissing() {
    QFETCH(const int, earlier);
    QFETCH(const QVector<int>, missing);
    {
      const auto batch = *BatchFolder::open(folder(), study(), ExistingBatch::Refuse);
      app::StoredRun good = runOf(0), killed = runOf(1);
      good.row.ok = true;
      killed.row.failedBy = app::FailedBy::Machine;
      QVERIFY(batch->add(good).empty() && batch->add(killed).empty());
      QVERIFY(batch->add(runOf(2)).empty());
      QVERIFY(batch->finish().empty());
      QCOMPARE(batch->store().failed(), std::size_t{2});
      QCOMPARE(batch->store().failedByMachine(), std::size_t{1});
      QCOMPARE(batch->store().firstFailure()->run, std::size_t{1});
    }
    {
      const auto batch = *BatchFolder::open(folder(), study(), static_cast<ExistingBatch>(earlier));
      const std::vector<std::size_t> found = batch->missing();
      QCOMPARE(QVector<int>(found.begin(), found.end()), missing);
      QCOMPARE(batch->store().failed(), std::size_t{2} - found.size());
      for (const std::size_t run : found) {
        app::StoredRun again = runOf(run);
        again.row.ok = true;
        again.row.reason = "duration";
        QVERIFY(batch->add(again).empty());
      }
      QVERIFY(batch->finish().empty());
      QCOMPARE(batch->store().failedByMachine(), std::size_t{0});
    }
    QVERIFY(textOf("results.csv").find("1,scene,1,ok,duration,") != std::string::npos);
    const auto batch = *BatchFolder::open(folder(), study(), ExistingBatch::Resume);
    QVERIFY(batch->missing().empty());
  }

  /// Shards joined: what the machine ended is still known, so that the whole can be resumed.
  void merge_failedByMachine_isKept() {
    const std::string place = place_->path().toStdString();
    for (std::size_t number = 1; number <= 2; ++number) {
      app::Study part = study();
      part.shard = {number, 2};
      const auto batch =
          *BatchFolder::open(place + "/" + std::to_string(number), part, ExistingBatch::Refuse);
      for (const std::size_t run : batch->missing()) {
        app::StoredRun stored = runOf(run);
        stored.row.failedBy = run == 2 ? app::FailedBy::Machine : app::FailedBy::Run;
        QVERIFY(batch->add(stored).empty());
      }
      QVERIFY(batch->finish().empty());
    }
    {
      const auto whole =
          app::mergeShards(folder(), {place + "/1", place + "/2"}, ExistingBatch::Refuse);
      QVERIFY(static_cast<bool>(whole));
      QCOMPARE((*whole)->store().failed(), std::size_t{3});
      QCOMPARE((*whole)->store().failedByMachine(), std::size_t{1});
    }
    const auto resumed = *BatchFolder::open(folder(), study(), ExistingBatch::Resume);
    QVERIFY(resumed->missing() == std::vector<std::size_t>{2});
  }

  /// Killed while failed runs are removed: either all of them exist, or all are missing.
  void retry_killed_losesNothing() {
    QVERIFY(work(0, 3, ExistingBatch::Refuse));
    int kills = 0;
    for (int code = 9; code == 9; ++kills) {
      code = struck::elsewhere([&] {
        struck::callsLeft = kills;
        return work(0, 3, ExistingBatch::Retry) ? 0 : 1;
      });
      QVERIFY(code == 0 || code == 9);
      QVERIFY(work(0, 3, ExistingBatch::Resume));
      QVERIFY(textOf("manifest.json").find("\"finished\": 3") != std::string::npos);
    }
    QVERIFY2(kills >= 5, QByteArray::number(kills));
  }

  /// What a run has used belongs to the study: another file in its place is refused, in the run
  /// that met it, in later ones, and in those of other shards.
  void inputs_ofRuns_stayAsTheyAre() {
    const std::string tree = place_->path().toStdString() + "/b.xml";
    QVERIFY(base::writeFileAtomically(tree, "<root/>").empty());
    const std::string hash = app::sha256Of("<root/>");
    {
      const auto batch = *BatchFolder::open(folder(), study(), ExistingBatch::Refuse);
      app::StoredRun run = runOf(0);
      run.row.inputs = {{"a.xml", "11"}, {tree, hash}, {"lost.xml", ""}};
      QVERIFY(batch->add(run).empty());
      run = runOf(1);
      run.row.inputs = {{"a.xml", "11"}, {"a.xml", "12"}, {"c.xml", "13"}};
      const base::Diagnostics told = batch->add(run);
      QCOMPARE(told.size(), std::size_t{1});
      QCOMPARE(told.front().code, std::string_view("batch.input-changed"));
      QCOMPARE(told.front().file, std::string("a.xml"));
      QVERIFY(!batch->store().has(1));
      QVERIFY(batch->finish().empty());
    }
    const std::string manifest = textOf("manifest.json");
    QVERIFY2(
        manifest.find("e.yaml") < manifest.find("/b.xml") &&
            manifest.find("/b.xml") < manifest.find("a.xml"),  // by path, behind the experiment
        manifest.c_str());
    QVERIFY(manifest.find("c.xml") == std::string::npos);
    QVERIFY(manifest.find("lost.xml") == std::string::npos);
    const auto filesTold = [this](const app::Study& now) {
      std::vector<std::string> files;
      const auto batch = BatchFolder::open(folder(), now, ExistingBatch::Resume);
      files.reserve(batch.diagnostics().size());
      for (const base::Diagnostic& problem : batch.diagnostics()) {
        files.push_back(problem.file);
      }
      return files;
    };
    using Files = std::vector<std::string>;
    QVERIFY(filesTold(study()) == Files{"a.xml"});  // is not there
    app::Study now = study();
    now.inputs.push_back({"a.xml", "11"});
    QVERIFY(filesTold(now).empty());
    now.inputs.push_back({"new.xml", "14"});
    QVERIFY(filesTold(now) == Files{"new.xml"});
    now.inputs = {{"e.yaml", "00"}, {"a.xml", "15"}};
    QVERIFY(filesTold(now) == Files{"a.xml"});
    now.inputs = {{"e.yaml", "00"}, {"a.xml", "11"}};
    QVERIFY(base::writeFileAtomically(tree, "<root></root>").empty());
    QVERIFY(filesTold(now) == Files{tree});
  }

  /// It is that of the runs that are missing, and stays where none is told.
  void timeLimit_resumed_isTheLastOne() {
    const auto limitAfter = [this](double limit, std::size_t run) {
      app::Study now = study();
      now.timeLimit = limit;
      const auto batch = BatchFolder::open(folder(), now, ExistingBatch::Resume);
      if (!batch || (!(*batch)->store().has(run) && !(*batch)->add(runOf(run)).empty()) ||
          !(*batch)->finish().empty()) {
        return -1.0;
      }
      return (*batch)->store().study().timeLimit;
    };
    QCOMPARE(limitAfter(0.5, 0), 0.5);
    QCOMPARE(limitAfter(0.0, 1), 0.5);
    QVERIFY(textOf("manifest.json").find("\"time_limit\": 0.5") != std::string::npos);
    QCOMPARE(limitAfter(2.0, 2), 2.0);
    QCOMPARE(limitAfter(3.0, 2), 2.0);  // nothing is missing
  }
};

QTEST_APPLESS_MAIN(BatchFolderTest)
#include "tst_BatchFolder.moc"
