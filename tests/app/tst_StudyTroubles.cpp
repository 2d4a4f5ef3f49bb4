#include <QtTest>

#include "app/run/OutputFolder.h"
#include "tests/app/StudyFiles.h"

using namespace outside;

/// Studies that cannot go on, and what is said of it.
class StudyTroublesTest : public QObject {
  Q_OBJECT

 private:
  StudyFolder folder_;

 private Q_SLOTS:
  void merge_wrongShards_areToldAllAtOnce() {
    const QString experiment = folder_.writeStudy("small.yaml", "seeds: 4\nduration: 0.5\n");
    const QString other = folder_.writeStudy("others.yaml", "seeds: 4\nduration: 0.6\n");
    const auto made = [this](const QString& file, const char* shard, const char* name) {
      const QString out = folder_.path(text(name));
      return runProgram(StudyFolder::words(file, out, {text("--shard"), text(shard)})).exitCode == 0
                 ? out
                 : QString();
    };
    const QString one = made(experiment, "1/4", "s1"), again = made(experiment, "1/4", "s1b");
    const QString foreign = made(other, "2/4", "s2");
    const QString out = folder_.path(text("wrong"));
    const Finished found = runProgram({text("merge"), text("-o"), out, one, again, foreign});
    QCOMPARE(found.exitCode, 2);
    for (const char* said : {"shard 1/4 is duplicated", "the experiments differ",
                             "shard 2/4 is not given", "shard 4/4 is not given"}) {
      QVERIFY2(found.err.contains(text(said)), qPrintable(found.err));
    }
    QVERIFY(!QDir(out).exists());
    QCOMPARE(runProgram("merge -o % %", {one, one}).exitCode, 2);
    const Finished same = runProgram({text("merge"), text("-o"), out, one, one});
    QCOMPARE(same.exitCode, 2);
    QVERIFY2(same.err.contains(text("shard 1/4 is duplicated")), qPrintable(same.err));
    QVERIFY2(!same.err.contains(text("process")), qPrintable(same.err));
    const Finished none = runProgram("merge -o % %", {out, folder_.path(text("nowhere"))});
    QVERIFY2(none.err.contains(text("there are no results of a batch")), qPrintable(none.err));
    // One that is not complete.
    const QString half = folder_.path(text("half"));
    Running batch(StudyFolder::words(folder_.endless(), half,
                                     {text("--shard"), text("1/1"), text("--jobs"), text("1")}));
    QTRY_VERIFY_WITH_TIMEOUT(!batch.workers().empty(), 20000);
    QCOMPARE(
        unexpected(runProgram("merge -o % %", {out, half}), 2, text("process %1").arg(batch.pid())),
        QString());
    ::kill(batch.pid(), SIGINT);
    batch.wait();
    QCOMPARE(unexpected(runProgram("merge -o % %", {out, half}), 2, "not complete: 0 of 2 runs"),
             QString());
  }

  /// Two definitions of a metric do not belong into one table.
  void merge_anotherMetricsFile_isRefused() {
    const QString metrics = folder_.path(text("own_metrics.yaml"));
    const QString scenario = folder_.path(text("own.yaml"));
    writeText(scenario, QByteArray(kYardText) + "    metrics:\n      file: own_metrics.yaml\n");
    const QString experiment = folder_.path(text("own_e.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\nscenarios: [own.yaml]\nseeds: 2\n"
              "duration: 0.5\n");
    QStringList merge = list("merge -o %", {folder_.path(text("own_all"))});
    for (const char* shard : {"1/2", "2/2"}) {
      writeText(metrics, QByteArray("metrics: {path_length: true}\n# ") + shard + "\n");
      merge << folder_.path(text("own_%1").arg(text(shard).left(1)));
      QCOMPARE(
          failureOf(StudyFolder::words(experiment, merge.back(), {text("--shard"), text(shard)})),
          QString());
    }
    QCOMPARE(
        unexpected(runProgram(merge), 2, "own_metrics.yaml: error: this file has changed since"),
        QString());
  }

  void twoBatches_inOneFolder_theSecondIsRefused() {
    const QString out = folder_.path(text("busy"));
    Running first(StudyFolder::words(folder_.endless(), out, {text("--jobs"), text("1")}));
    QTRY_VERIFY_WITH_TIMEOUT(!first.workers().empty(), 20000);
    QCOMPARE(unexpected(runProgram(StudyFolder::words(folder_.endless(), out, {text("--resume")})),
                        2, text("process %1 is writing results here").arg(first.pid())),
             QString());
    QVERIFY(first.isRunning());
    ::kill(first.pid(), SIGKILL);  // the lock ends with it
    first.wait();
    const Finished third = runProgram(StudyFolder::words(folder_.endless(), out));
    QVERIFY2(third.err.contains(text("a batch was interrupted here after 0 of 2 runs")),
             qPrintable(third.err));
  }

  /// A worker that is killed costs nothing; one whose run kills it each time is a failed row.
  void worker_killedTwice_isAFailedRow() {
    const QString out = folder_.path(text("crashes"));
    Running batch(StudyFolder::words(folder_.endless(1), out, {text("--jobs"), text("1")}));
    for (int k = 0; k < 2; ++k) {
      QTRY_VERIFY_WITH_TIMEOUT(batch.workers().size() == 1, 20000);
      const qint64 worker = batch.workers().front();
      ::kill(static_cast<pid_t>(worker), SIGKILL);
      QTRY_VERIFY_WITH_TIMEOUT(!isAlive(worker), 20000);
    }
    const Finished found = batch.wait();
    QVERIFY2(found.exitCode == 1, qPrintable(text("%1 ").arg(found.exitCode) + found.err));
    const auto rows = readCsv(out + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{1});
    QCOMPARE(rows[0].at(text("status")), text("failed"));
    QVERIFY2(rows[0].at(text("reason")).startsWith(text("the process was killed (signal 9)")),
             qPrintable(rows[0].at(text("reason"))));
    QVERIFY2(found.err.contains(text("1 of 1 finished runs failed, the first is run 0: the process "
                                     "was killed (signal 9)")),
             qPrintable(found.err));
    QVERIFY2(found.err.contains(text("batch --resume repeats those")), qPrintable(found.err));
    Running again(
        StudyFolder::words(folder_.endless(1), out, {text("--jobs"), text("1"), text("--resume")}));
    QTRY_VERIFY_WITH_TIMEOUT(again.workers().size() == 1, 20000);  // its run is repeated
    ::kill(again.pid(), SIGKILL);
    again.wait();
  }

  void timeLimit_passed_isAFailedRow() {
    const QString out = folder_.path(text("late"));
    const Finished found =
        runProgram(StudyFolder::words(folder_.endless(), out, {text("--time-limit"), text("0.2")}));
    QCOMPARE(found.exitCode, 1);
    const auto rows = readCsv(out + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{2});
    QCOMPARE(rows[1].at(text("reason")), text("not finished within 0.2 s"));
    QCOMPARE(runProgram("report % -q", {out}).exitCode, 0);
    QVERIFY(bytesOf(out + text("/report.html")).contains("--time-limit 0.2"));
  }

  /// A run that failed by itself stays failed when the batch is resumed, until a retry is asked
  /// for.
  void retryFailed_makesFailedRunsAgain() {
    const QString out = folder_.path(text("retried"));
    const auto reasonsAfter = [&](const QStringList& more) {
      const Finished found =
          runProgram(StudyFolder::words(folder_.endless(), out, more + list("-q")));
      [&] { QCOMPARE(found.exitCode, 1); }();
      [&] { QCOMPARE(found.out, QString()); }();
      // The reason for exit code 1 is also reported without other output.
      [&] {
        QVERIFY2(found.err.contains(text("2 of 2 finished runs failed, the first is run 0: not "
                                         "finished within")),
                 qPrintable(found.err));
      }();
      QStringList reasons;
      for (const auto& row : readCsv(out + text("/results.csv"))) {
        reasons += row.at(text("reason"));
      }
      return reasons.join(text("; "));
    };
    const QString limit = text("--time-limit");
    const QString first = text("not finished within 0.2 s; not finished within 0.2 s");
    QCOMPARE(reasonsAfter({limit, text("0.2")}), first);
    QCOMPARE(reasonsAfter({text("--resume"), limit, text("0.3")}), first);
    QCOMPARE(reasonsAfter({text("--retry-failed"), limit, text("0.3")}),
             text("not finished within 0.3 s; not finished within 0.3 s"));
  }

  /// Nobody knows which of both such a run has read.
  void scenario_changedWhileItRuns_endsTheBatch() {
    QVERIFY(QDir().mkpath(folder_.path(text("edited"))));
    const QString scenario = folder_.path(text("edited/yard.yaml"));
    const QString experiment = folder_.path(text("edited/e.yaml"));
    writeText(scenario, kYardText);
    writeText(experiment,
              "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 3\n"
              "duration: 4000.0\n");
    const QString out = folder_.path(text("edited/out"));
    const QStringList words =
        StudyFolder::words(experiment, out, {text("--jobs"), text("1"), text("--resume")});
    Running batch(words);
    QTRY_VERIFY_WITH_TIMEOUT(!batch.workers().empty(), 20000);
    writeText(scenario, QByteArray(kYardText).replace("max_vel: 1.2", "max_vel: 1.3"));
    const Finished found = batch.wait();
    QCOMPARE(unexpected(found, 2, "yard.yaml: error: this file changed during"), QString());
    QVERIFY2(found.err.contains(text(" of 3 runs: continue with batch --resume")),
             qPrintable(found.err));
    QCOMPARE(unexpected(runProgram(words), 2, "this file has changed since"), QString());
    writeText(scenario, kYardText);
    QCOMPARE(runProgram(words).exitCode, 0);
    QCOMPARE(readCsv(out + text("/results.csv")).size(), std::size_t{3});
  }

  void damagedDatabase_isToldAndKept() {
    const QString experiment = folder_.writeStudy("tiny.yaml", "seeds: 2\nduration: 0.5\n");
    const QString out = folder_.path(text("damaged"));
    QCOMPARE(runProgram(StudyFolder::words(experiment, out)).exitCode, 0);
    const QString file = out + text("/results.sqlite");
    const QByteArray whole = bytesOf(file);
    QVERIFY(whole.size() > 8192);
    const QByteArray cut = whole.left(5000);
    QByteArray broken = whole;
    broken.replace(4096, 4000, QByteArray(4000, 'x'));
    for (const QByteArray& bytes : {cut, broken, QByteArray("no database at all, by no means")}) {
      writeText(file, bytes);
      for (const char* option : {"--resume", "--quiet"}) {
        QCOMPARE(unexpected(runProgram(StudyFolder::words(experiment, out, {text(option)})), 2,
                            "results.sqlite: error: the results cannot be read"),
                 QString());
        QCOMPARE(bytesOf(file), bytes);
      }
    }
    writeText(file, whole);  // as the message advises
    QCOMPARE(runProgram(StudyFolder::words(experiment, out, {text("--resume")})).exitCode, 0);
  }

  /// There is no table yet: what runs is to be waited for, what was killed goes on.
  void report_ofABatchThatHasNotEnded_isTold() {
    const QString experiment =
        folder_.writeStudy("not ended.yaml", "seeds: 2\nduration: 900000.0\n");
    const QString out = folder_.path(text("not-ended"));
    Running batch(
        StudyFolder::words(experiment, out, {text("--jobs"), text("1"), text("--allow-code")}));
    QTRY_VERIFY_WITH_TIMEOUT(!batch.workers().empty(), 20000);
    QCOMPARE(unexpected(runProgram("report %", {out}), 2,
                        "not-ended: error: the batch in this folder is running"),
             QString());
    ::kill(batch.pid(), SIGKILL);
    batch.wait();
    const Finished cut = runProgram("report %", {out});
    QCOMPARE(cut.exitCode, 2);
    const QString goOn = text("hunavsim batch '%1' -o %2 --resume --allow-code\n");
    QVERIFY2(cut.err.contains(text("is incomplete (0 of 2 runs): continue it with ")) &&
                 cut.err.contains(goOn.arg(experiment, out)),
             qPrintable(cut.err));
    QVERIFY(!QFile::exists(out + text("/report.html")));
  }

  /// The table of the interrupted part is there, and out of date.
  void report_ofABatchThatRunsAgain_isTold() {
    const QString experiment = folder_.writeStudy("again.yaml", "seeds: 2\nduration: 900000.0\n");
    const QString out = folder_.path(text("again"));
    const QStringList words =
        StudyFolder::words(experiment, out, {text("--jobs"), text("1"), text("--allow-code")});
    {
      Running first(words);
      QTRY_VERIFY_WITH_TIMEOUT(!first.workers().empty(), 20000);
      ::kill(first.pid(), SIGINT);
      first.wait();
    }
    QVERIFY(QFile::exists(out + text("/results.csv")));
    Running again(words + QStringList{text("--resume")});
    QTRY_VERIFY_WITH_TIMEOUT(!again.workers().empty(), 20000);
    QCOMPARE(unexpected(runProgram("report %", {out}), 2,
                        "again: error: the batch in this folder is running"),
             QString());
    ::kill(again.pid(), SIGKILL);
    again.wait();
  }

  /// No batch runs there: the process that uses the folder is named.
  void report_ofAFolderInUse_namesTheProcess() {
    const QString out = folder_.path(text("used"));
    QCOMPARE(runProgram(StudyFolder::words(folder_.writeStudy("used.yaml", "duration: 0.5\n"), out))
                 .exitCode,
             0);
    const auto lock = app::FolderLock::acquire(out.toStdString());  // as another `report`
    QVERIFY(bool(lock));
    const QString user =
        text("process %1 is writing results here").arg(QCoreApplication::applicationPid());
    QCOMPARE(unexpected(runProgram("report %", {out}), 2, qPrintable(user)), QString());
  }

  /// What does not fit on the disk ends the batch with the reason; what fitted is kept.
  void fullDisk_isToldAndResumed() {
    const QString out = folder_.path(text("full"));
    const QString experiment = folder_.writeStudy("full.yaml", "seeds: 60\nduration: 0.5\n");
    QProcess program;
    program.start(text("bash"),
                  {text("-c"), text("ulimit -f 60; exec \"$0\" \"$@\""), text(HUNAVSIM_PROGRAM),
                   text("batch"), experiment, text("-o"), out});
    QVERIFY(program.waitForFinished(50000));
    const QString said = QString::fromUtf8(program.readAllStandardError());
    QVERIFY2(program.exitCode() == 2, qPrintable(said));
    QVERIFY2(said.contains(text("results.sqlite: error: the results cannot be written")),
             qPrintable(said));
    const QString free = folder_.path(text("free"));
    QCOMPARE(runProgram(StudyFolder::words(experiment, free)).exitCode, 0);
    QCOMPARE(failureOf(StudyFolder::words(experiment, out, {text("--resume")})), QString());
    QCOMPARE(StudyFolder::results(out), StudyFolder::results(free));
  }

  void readOnlyFolder_isAnError() {
    const QString out = folder_.path(text("read-only"));
    QVERIFY(QDir().mkpath(out));
    QVERIFY(QFile::setPermissions(out, QFile::ReadOwner | QFile::ExeOwner));
    if (::access(qPrintable(out), W_OK) == 0) {
      QSKIP("this user may write everywhere");
    }
    QCOMPARE(unexpected(runProgram(StudyFolder::words(folder_.study(), out)), 2, "no permission"),
             QString());
    QFile::setPermissions(out, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  }

  void wrongValues_areToldWithTheirPlaces() {
    const QString experiment = folder_.writeStudy("wrong.yaml",
                                                  "values:\n"
                                                  "  anna.max_vell: {uniform: [1, 2]}\n"
                                                  "  anna.max_vel: {norml: [1, 2, 0, 3]}\n"
                                                  "  ben.max_vel: {normal: [1, 0.2, -3, 3]}\n"
                                                  "  ben.id: {uniform: [2, 4]}\n"
                                                  "  robot1.planner: {choice: [pursuit, dva]}\n"
                                                  "  anna.radius: {range: [0.2, 0.4]}\n");
    const Finished found = runProgram(StudyFolder::words(experiment, folder_.path(text("none"))));
    QCOMPARE(found.exitCode, 2);
    for (const char* said : {"wrong.yaml:4:29: error:", "did you mean 'anna.max_vel'",
                             "wrong.yaml:5:18: error:", "did you mean 'normal'",
                             "wrong.yaml:6:34: error:", "wrong.yaml:7:21: error:",
                             "wrong.yaml:8:38: error:", "wrong.yaml:9:24: error: range takes"}) {
      QVERIFY2(found.err.contains(text(said)), qPrintable(text(said) + text("\n") + found.err));
    }
  }

  void wrongShard_isAWrongCommandLine() {
    for (const char* shard : {"0/2", "3/2", "1", "a/b", "1/2/3", "-1/2"}) {
      QCOMPARE(runProgram(StudyFolder::words(folder_.study(), folder_.path(text("none")),
                                             {text("--shard"), text(shard)}))
                   .exitCode,
               64);
    }
    QVERIFY(!QDir(folder_.path(text("none"))).exists());
  }

  void script_isBash() {
    for (const char* kind : {"slurm", "parallel"}) {
      const Finished script = runProgram(StudyFolder::words(
          folder_.study(), folder_.path(text("it's")),
          {text("--script"), text(kind), text("--retry-failed"), text("--time-limit"), text("9")}));
      QCOMPARE(script.exitCode, 0);
      QVERIFY2(script.out.contains(text("MORE='--retry-failed --time-limit 9'\n")),
               qPrintable(script.out));
      writeText(folder_.path(text("check.sh")), script.out.toUtf8());
      QProcess bash;
      bash.start(text("bash"), {text("-n"), folder_.path(text("check.sh"))});
      QVERIFY(bash.waitForFinished(10000));
      QVERIFY2(bash.exitCode() == 0, bash.readAllStandardError().constData());
      const Finished json =
          runProgram(StudyFolder::words(folder_.study(), folder_.path(text("it's")),
                                        {text("--script"), text(kind), text("--json"),
                                         text("--retry-failed"), text("--time-limit"), text("9")}));
      const QJsonObject told = QJsonDocument::fromJson(json.out.toUtf8()).object();
      QCOMPARE(told.value(text("script")).toString(), text(kind));
      QCOMPARE(told.value(text("text")).toString(), script.out);
    }
  }
};

QTEST_GUILESS_MAIN(StudyTroublesTest)
#include "tst_StudyTroubles.moc"
