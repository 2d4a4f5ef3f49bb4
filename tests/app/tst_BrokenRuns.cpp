#include <algorithm>
#include <cmath>
#include <csignal>

#include <QDirIterator>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/RecordedRun.h"
#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

/// A program in a process group of its own, as a terminal starts it; `words[0]` is the program.
class Group {
 public:
  explicit Group(const QStringList& words) {
    process_.start(text("setsid"), words);
    process_.waitForStarted();
  }
  ~Group() {
    if (process_.state() != QProcess::NotRunning) {
      ::kill(-pid(), SIGKILL);
      process_.waitForFinished();
    }
  }
  Q_DISABLE_COPY_MOVE(Group)

  pid_t pid() const { return static_cast<pid_t>(process_.processId()); }
  bool isRunning() const { return process_.state() == QProcess::Running; }
  Finished wait() { return finishedOf(process_); }

 private:
  QProcess process_;
};

QStringList halfWritten(const QString& folder) {
  QStringList found;
  QDirIterator files(folder, {text("*.new-*")}, QDir::Files | QDir::Hidden,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    found << files.next();
  }
  return found;
}

QStringList runWords(const char* duration, const QString& folder) {
  return {text("run"), text("corner_cafe_agents"), text("--duration"), text(duration), text("-o"),
          folder};
}

QString statusOf(const QString& folder) {
  return readJson(folder + text("/manifest.json")).value(text("status")).toString();
}

}  // namespace

/// Runs that are cut short, and runs whose files cannot be written.
class BrokenRunsTest : public QObject {
  Q_OBJECT

 private:
  static QString program() { return text(HUNAVSIM_PROGRAM); }
  static QString longExperiment(const QTemporaryDir& folder) {
    QString path = folder.filePath(text("long.yaml"));
    writeText(path,
              "hunavsim_experiment: 1\n"
              "scenarios: [corner_cafe_agents]\n"
              "seeds: 3\n"
              "duration: 20000.0\n"
              "record: all\n");
    return path;
  }

 private Q_SLOTS:
  void batch_ctrlCInTheTerminal_leavesNoHalfRun() {
    QTemporaryDir folder;
    const QString experiment = longExperiment(folder);
    const QString out = folder.filePath(text("out"));
    Group batch({program(), text("batch"), experiment, text("-o"), out, text("--jobs"), text("2")});
    QTRY_VERIFY_WITH_TIMEOUT(halfWritten(out).size() >= 6, 30000);
    QVERIFY(::kill(-batch.pid(), SIGINT) == 0);  // the whole group, as Ctrl-C does
    QCOMPARE(unexpected(batch.wait(), 1, "interrupted"), QString());
    QCOMPARE(halfWritten(out), QStringList());
    QVERIFY(!QDir(out + text("/runs")).exists());
    QCOMPARE(statusOf(out), text("interrupted"));
    QCOMPARE(readCsv(out + text("/results.csv")).size(), std::size_t{0});
  }

  /// It cannot end them cleanly: they end with it, and what they left goes when it is resumed.
  void batch_killed_itsRunsEndToo() {
    QTemporaryDir folder;
    const QString experiment = longExperiment(folder);
    const QString out = folder.filePath(text("out"));
    const QStringList words = list("% batch % -o % --jobs 2", {program(), experiment, out});
    Group batch(words);
    QTRY_VERIFY_WITH_TIMEOUT(halfWritten(out).size() >= 6, 30000);
    const std::vector<qint64> workers = childrenOf(batch.pid());
    QCOMPARE(workers.size(), std::size_t{2});
    QVERIFY(::kill(batch.pid(), SIGKILL) == 0);
    batch.wait();
    for (const qint64 worker : workers) {
      QTRY_VERIFY_WITH_TIMEOUT(!isAlive(worker), 10000);
    }
    const QStringList rests = halfWritten(out);
    QVERIFY(rests.size() >= 6);
    Group again(words + list("--resume"));
    const auto areOthersThere = [&] {  // not some of the rests while they are taken away
      const QStringList now = halfWritten(out);
      return now.size() >= 6 && std::none_of(now.begin(), now.end(), [&](const QString& file) {
               return rests.contains(file);
             });
    };
    QTRY_VERIFY_WITH_TIMEOUT(areOthersThere(), 30000);
    QVERIFY(::kill(again.pid(), SIGTERM) == 0);
    QCOMPARE(again.wait().exitCode, 1);
    QCOMPARE(halfWritten(out), QStringList());
  }

  void run_signals_keepThePart_data() {
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    QTest::newRow("Ctrl-C") << SIGINT << 0;
    QTest::newRow("Ctrl-C and the parent's request") << SIGINT << SIGTERM;
    QTest::newRow("request") << SIGTERM << 0;
    QTest::newRow("end of the terminal") << SIGHUP << SIGTERM;
  }
  void run_signals_keepThePart() {
    QFETCH(int, first);
    QFETCH(int, second);
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    Group run(QStringList{program()} + runWords("20000", out));
    QTRY_VERIFY_WITH_TIMEOUT(halfWritten(out).size() >= 3, 30000);
    QVERIFY(::kill(run.pid(), first) == 0);
    if (second != 0) {
      QVERIFY(::kill(run.pid(), second) == 0);
    }
    const Finished found = run.wait();
    QVERIFY2(found.exitCode == 1, qPrintable(found.err));
    QCOMPARE(halfWritten(out), QStringList());
    QCOMPARE(statusOf(out), text("interrupted"));
  }

  void run_endOfTheTerminalUnderNohup_goesOn() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    Group run(list("nohup %", {program()}) + runWords("20000", out));
    QTRY_VERIFY_WITH_TIMEOUT(halfWritten(out).size() >= 3, 30000);
    QVERIFY(::kill(run.pid(), SIGHUP) == 0);
    QTest::qWait(500);
    QVERIFY(run.isRunning());
    QVERIFY(halfWritten(out).size() >= 3);
  }

  void run_fileThatCannotBeReplaced_leavesTheFormerRun() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    QCOMPARE(runProgram(runWords("2", out)).exitCode, 0);
    QVERIFY(QFile::remove(out + text("/metrics.csv")));
    QVERIFY(QDir().mkpath(out + text("/metrics.csv/in_the_way")));
    const Finished found = runProgram(runWords("20000", out));  // ends at once
    QVERIFY2(found.exitCode == 2, qPrintable(found.err));
    QVERIFY2(found.err.contains(text("metrics.csv: error: ")), qPrintable(found.err));
    QCOMPARE(failureOf("evaluate % -o %", {out, folder.filePath(text("evaluated"))}), QString());
  }

  /// Two runs into one folder: the second is told who has it, and nothing is mixed.
  void run_intoTheFolderOfAnother_isRefused() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    Group run(QStringList{program()} + runWords("20000", out));
    QTRY_VERIFY_WITH_TIMEOUT(halfWritten(out).size() >= 3, 30000);
    QCOMPARE(unexpected(runProgram(runWords("1", out)), 2,
                        text("process ") + QString::number(run.pid())),
             QString());
    QVERIFY(::kill(run.pid(), SIGINT) == 0);
    QCOMPARE(run.wait().exitCode, 1);
    QCOMPARE(statusOf(out), text("interrupted"));
    QCOMPARE(runProgram(runWords("1", out)).exitCode, 0);
  }

  /// Nothing is left of a run that was killed once another one went into the folder.
  void run_killed_nextOneCleansUp() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    Group run(QStringList{program()} + runWords("20000", out));
    QTRY_VERIFY_WITH_TIMEOUT(halfWritten(out).size() >= 3, 30000);
    QVERIFY(::kill(run.pid(), SIGKILL) == 0);
    run.wait();
    const Finished unread =
        runProgram("evaluate % -o %", {out, folder.filePath(text("evaluated"))});
    QCOMPARE(unread.exitCode, 2);
    QCOMPARE(runProgram(runWords("1", out)).exitCode, 0);
    QCOMPARE(halfWritten(out), QStringList());
    QVERIFY(!QFile::exists(out + text("/.hunavsim-lock")));
  }

  /// What was on the disk when it was killed can be looked at, and nothing else.
  void run_killed_canBeLookedAt() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    Group run(QStringList{program()} + runWords("20000", out));
    const auto written = [&out] {
      for (const QString& file : halfWritten(out)) {
        if (file.contains(text("trajectory.csv")) && QFileInfo(file).size() > 300000) {
          return true;
        }
      }
      return false;
    };
    QTRY_VERIFY_WITH_TIMEOUT(written(), 60000);
    QVERIFY(!app::readRecordedRun(out.toStdString(), sim2d::Recording::kDefaultMemory,
                                  app::IncompleteRecordings::Shown));  // it goes on
    QVERIFY(::kill(run.pid(), SIGKILL) == 0);
    run.wait();
    QVERIFY(!app::readRecordedRun(out.toStdString()));
    const auto shown = app::readRecordedRun(out.toStdString(), sim2d::Recording::kDefaultMemory,
                                            app::IncompleteRecordings::Shown);
    QVERIFY2(shown, shown ? "" : shown.diagnostics().front().text().c_str());
    QVERIFY(shown->cut.has_value() && shown->recording->size() > 100);
    QCOMPARE(std::string(shown.diagnostics().back().code), std::string("trace.killed"));
    const std::size_t last = shown->recording->size() - 1;
    QVERIFY(std::abs(shown->cut->time - shown->recording->timeOf(last)) < 1e-9);
    QCOMPARE(shown->recording->frame(last)->robots.size(), std::size_t{1});
  }

  void run_trajectoryThatCannotBeWritten_leavesTheFormerRun() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    QCOMPARE(runProgram(runWords("2", out)).exitCode, 0);
    const QByteArray manifest = bytesOf(out + text("/manifest.json"));
    const QByteArray events = bytesOf(out + text("/events.csv"));
    QVERIFY(QFile::rename(out + text("/trajectory.csv"), out + text("/kept.csv")));
    QVERIFY(QDir().mkpath(out + text("/trajectory.csv")));
    const Finished found = runProgram(runWords("20000", out));  // ends at once
    QVERIFY2(found.exitCode == 2, qPrintable(found.err));
    QCOMPARE(bytesOf(out + text("/manifest.json")), manifest);
    QCOMPARE(bytesOf(out + text("/events.csv")), events);
    QCOMPARE(halfWritten(out), QStringList());
  }

  void run_diskFull_endsEarlyAndTellsTheMetrics() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("out"));
    Group run(list("sh -c % %", {text("ulimit -f 400; exec \"$0\" \"$@\""), program()}) +
              runWords("20000", out) + list("--json"));
    const Finished found = run.wait();
    QVERIFY2(found.exitCode == 2, qPrintable(found.err));
    QVERIFY2(found.err.contains(out + text("/trajectory.csv: ")), qPrintable(found.err));
    QVERIFY2(found.err.contains(text("the files of the run could not be written")),
             qPrintable(found.err));
    const QJsonObject told = QJsonDocument::fromJson(found.out.toUtf8()).object();
    QVERIFY(told.value(text("metrics")).toObject().contains(text("path_length")));
    QCOMPARE(halfWritten(out), QStringList());
    QVERIFY(!QFile::exists(out + text("/manifest.json")));
  }
};

QTEST_GUILESS_MAIN(BrokenRunsTest)
#include "tst_BrokenRuns.moc"
