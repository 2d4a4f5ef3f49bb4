#include <random>
#include <set>

#include <QDirIterator>
#include <QJsonArray>
#include <QStandardPaths>
#include <QtTest>

#include "tests/app/LoopbackSlurm.h"
#include "tests/app/StudyFiles.h"

using namespace outside;

/// Studies of many runs: interrupted, resumed, split; their results are always the same.
class StudiesTest : public QObject {
  Q_OBJECT

 private:
  StudyFolder folder_;
  QString undisturbed() const { return folder_.path(text("undisturbed")); }
  static bool isWhole(const QString& runs) {
    QDirIterator files(runs, {text("*.new-*")}, QDir::Files, QDirIterator::Subdirectories);
    return !files.hasNext();
  }

 private Q_SLOTS:
  void initTestCase() {
    QCOMPARE(
        failureOf(StudyFolder::words(folder_.study(), undisturbed(), {text("--jobs"), text("1")})),
        QString());
    QCOMPARE(StudyFolder::runFolders(undisturbed()).size(), 24);
    QVERIFY(!QFile::exists(undisturbed() + text("/.hunavsim-lock")));
    QVERIFY(!QFile::exists(undisturbed() + text("/results.sqlite-wal")));
  }

  /// A line of JSON per run, also of those that were there; they say what results.csv says.
  void rows_areThoseOfTheResults() {
    const Finished found = runProgram(StudyFolder::words(
        folder_.path(text("study.yaml")), undisturbed(), {text("--resume"), text("--rows")}));
    QVERIFY2(found.exitCode == 0, qPrintable(found.err));
    const auto rows = readCsv(undisturbed() + text("/results.csv"));
    QStringList lines = found.out.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(lines.takeFirst(), text("{\"runs\":24,\"finished\":24}"));
    QCOMPARE(static_cast<std::size_t>(lines.size()), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const QJsonObject row = QJsonDocument::fromJson(lines[static_cast<int>(k)].toUtf8()).object();
      QCOMPARE(row.value(text("run")).toInt(-1), static_cast<int>(k));
      QCOMPARE(row.value(text("seed")).toInt(), rows[k].at(text("seed")).toInt());
      QCOMPARE(row.value(text("status")).toString(), rows[k].at(text("status")));
      const QJsonObject values = row.value(text("values")).toObject();
      QCOMPARE(values.value(text("*.max_vel")).toString(), rows[k].at(text("*.max_vel")));
      const QJsonObject metrics = row.value(text("metrics")).toObject();
      QCOMPARE(metrics.value(text("path_length")).toDouble(),
               rows[k].at(text("path_length")).toDouble());
      QCOMPARE(metrics.value(text("success")).toBool(),
               rows[k].at(text("success")) == text("True"));
    }
  }

  /// The draws are those of scenario and seed, whatever the planner is; the manifest tells them.
  void draws_areEqualForAllPlanners() {
    std::map<QString, QString> speeds;
    std::set<QString> different;
    for (const auto& row : readCsv(undisturbed() + text("/results.csv"))) {
      const QString speed = row.at(text("*.max_vel"));
      QVERIFY(speed.toDouble() >= 0.6 && speed.toDouble() <= 1.8);
      QCOMPARE(speeds.emplace(row.at(text("seed")), speed).first->second, speed);
      different.insert(speed);
    }
    QCOMPARE(different.size(), std::size_t{4});
    const QJsonObject drawn = readJson(undisturbed() + text("/manifest.json"))
                                  .value(text("drawn"))
                                  .toObject()
                                  .value(text("yard.yaml"))
                                  .toObject();
    for (const auto& [seed, speed] : speeds) {
      QCOMPARE(drawn.value(seed).toObject().value(text("*.max_vel")).toString(), speed);
    }
    // People are alike in both, down to what the world has drawn for them.
    const auto people = [this](int run) {
      return readJson(undisturbed() + text("/runs/%1/trace.json").arg(run)).value(text("humans"));
    };
    const QString planner = text("robot1.planner");
    const auto rows = readCsv(undisturbed() + text("/results.csv"));
    QVERIFY(rows[2].at(planner) != rows[14].at(planner));
    QVERIFY(people(2).toArray().size() == 2 && people(2) == people(14));
    QVERIFY(people(2) != people(3));
  }

  void jobs_anyNumber_sameBytes() {
    const QString out = folder_.path(text("four"));
    QCOMPARE(failureOf(StudyFolder::words(folder_.study(), out, {text("--jobs"), text("4")})),
             QString());
    QCOMPARE(StudyFolder::results(out), StudyFolder::results(undisturbed()));
    QCOMPARE(bytesOf(out + text("/manifest.json")),
             bytesOf(undisturbed() + text("/manifest.json")));
  }

  /// Workers and the batch itself are killed again and again; in the end nothing of it is seen.
  void killed_andResumed_sameBytes() {
    const int rounds = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 20 : 3;
    const QString out = folder_.path(text("killed"));
    std::mt19937 random(7);  // NOLINT: the same moments each time, as far as a clock can
    for (int round = 0; round < rounds; ++round) {
      Running batch(
          StudyFolder::words(folder_.study(), out, {text("--jobs"), text("2"), text("--resume")}));
      QTest::qWait(50 + static_cast<int>(random() % 150));
      const std::vector<qint64> workers = batch.workers();
      if (!workers.empty()) {
        ::kill(static_cast<pid_t>(workers[random() % workers.size()]), SIGKILL);
      }
      QTest::qWait(static_cast<int>(random() % 60));
      const std::vector<qint64> left = batch.workers();
      if (batch.isRunning()) {
        ::kill(batch.pid(), SIGKILL);
        batch.wait();
      }
      for (const qint64 worker : left) {  // none is left behind
        QTRY_VERIFY_WITH_TIMEOUT(!isAlive(worker), 10000);
      }
    }
    QCOMPARE(failureOf(StudyFolder::words(folder_.study(), out, {text("--resume")})), QString());
    QCOMPARE(StudyFolder::results(out), StudyFolder::results(undisturbed()));
    QCOMPARE(bytesOf(out + text("/manifest.json")),
             bytesOf(undisturbed() + text("/manifest.json")));
    QCOMPARE(StudyFolder::runFolders(out).size(), 24);
    QVERIFY(isWhole(out));
    for (const QString& run : StudyFolder::runFolders(out)) {
      const QString file = text("/runs/") + run + text("/trajectory.csv");
      QCOMPARE(bytesOf(out + file), bytesOf(undisturbed() + file));
    }
  }

  void interrupted_tellsAndResumes() {
    const QString out = folder_.path(text("interrupted"));
    const QString experiment = folder_.study();
    Running batch(StudyFolder::words(experiment, out, {text("--jobs"), text("1")}));
    QTRY_VERIFY_WITH_TIMEOUT(StudyFolder::runFolders(out).size() >= 3, 30000);
    ::kill(batch.pid(), SIGTERM);
    QCOMPARE(unexpected(batch.wait(), 1, "batch --resume"), QString());
    const auto rows = readCsv(out + text("/results.csv"));
    QVERIFY(rows.size() >= 2 && rows.size() < 24);
    QCOMPARE(StudyFolder::runFolders(out).size(), static_cast<int>(rows.size()));
    QVERIFY(StudyFolder::results(undisturbed()).startsWith(StudyFolder::results(out)));
    // Not again by mistake, and not with anything else.
    QCOMPARE(
        unexpected(runProgram(StudyFolder::words(experiment, out)), 2, "--resume continues it"),
        QString());
    const Finished shard = runProgram(
        StudyFolder::words(experiment, out, {text("--resume"), text("--shard"), text("1/2")}));
    QCOMPARE(shard.exitCode, 2);
    QCOMPARE(failureOf(StudyFolder::words(experiment, out, {text("--resume")})), QString());
    QCOMPARE(StudyFolder::results(out), StudyFolder::results(undisturbed()));
    // A finished one is left as it is.
    const QDateTime made = QFileInfo(out + text("/runs/0/manifest.json")).lastModified();
    QCOMPARE(runProgram(StudyFolder::words(experiment, out, {text("--resume")})).exitCode, 0);
    QCOMPARE(QFileInfo(out + text("/runs/0/manifest.json")).lastModified(), made);
    QCOMPARE(StudyFolder::results(out), StudyFolder::results(undisturbed()));
  }

  void resume_changedExperimentOrScenario_isRefused() {
    const QString out = folder_.path(text("changed"));
    QVERIFY(QDir().mkpath(folder_.path(text("other"))));
    writeText(folder_.path(text("other/yard.yaml")), kYardText);
    const auto write = [this](const char* seeds) {
      QString file = folder_.path(text("other/e.yaml"));
      writeText(file, QByteArray("hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: ") +
                          seeds + "\nduration: 1.0\n");
      return file;
    };
    const QString experiment = write("2");
    QCOMPARE(runProgram(StudyFolder::words(experiment, out)).exitCode, 0);
    const QByteArray before = StudyFolder::results(out);
    write("3");
    const Finished other = runProgram(StudyFolder::words(experiment, out, {text("--resume")}));
    QCOMPARE(other.exitCode, 2);
    QVERIFY2(other.err.contains(text("e.yaml:3: error:")) && other.err.contains(text("'seeds: 2'")),
             qPrintable(other.err));
    write("2");
    writeText(folder_.path(text("other/yard.yaml")), QByteArray(kYardText) + "    duration: 3.0\n");
    QCOMPARE(unexpected(runProgram(StudyFolder::words(experiment, out, {text("--resume")})), 2,
                        "yard.yaml: error: this file has changed since"),
             QString());
    QCOMPARE(StudyFolder::results(out), before);
  }

  void shards_merged_sameBytes_data() {
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 7}) {
      QTest::newRow(std::to_string(count).c_str()) << count;
    }
  }
  void shards_merged_sameBytes() {
    QFETCH(int, count);
    const QString base = folder_.path(text("shards%1").arg(count));
    const QString out = base + text("/all");
    QStringList merge = list("merge -o %", {out});
    for (int k = count; k >= 1; --k) {  // in any order
      const QString shard = base + text("/%1").arg(k);
      QCOMPARE(failureOf(StudyFolder::words(
                   folder_.study(), shard,
                   {text("--shard"), text("%1/%2").arg(k).arg(count), text("--resume")})),
               QString());
      for (const auto& row : readCsv(shard + text("/results.csv"))) {
        QCOMPARE(row.at(text("run")).toInt() % count, k - 1);
      }
      merge << shard;
    }
    QCOMPARE(failureOf(merge), QString());
    QCOMPARE(StudyFolder::results(out), StudyFolder::results(undisturbed()));
    QCOMPARE(bytesOf(out + text("/manifest.json")),
             bytesOf(undisturbed() + text("/manifest.json")));
    QCOMPARE(StudyFolder::runFolders(out).size(), 24);
    QCOMPARE(runProgram(merge).exitCode, 0);  // again
    QCOMPARE(StudyFolder::results(out), StudyFolder::results(undisturbed()));
  }

  /// The script by bash itself, with the real GNU parallel.
  void script_parallel_sameBytes() {
    if (QStandardPaths::findExecutable(text("parallel")).isEmpty()) {
      QSKIP("GNU parallel is not installed");
    }
    const QString out = folder_.path(text("by parallel"));
    const Finished script = runProgram(StudyFolder::words(
        folder_.study(), out, {text("--script"), text("parallel"), text("--chunks"), text("3")}));
    QVERIFY2(script.exitCode == 0, qPrintable(script.err));
    QVERIFY(!QDir(out).exists());
    writeText(folder_.path(text("job.sh")), script.out.toUtf8());
    for (int k = 0; k < 2; ++k) {  // the second time nothing is left to do
      QProcess bash;
      QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
      environment.insert(text("PARALLEL_HOME"),
                         folder_.path({}));  // else it writes into the user's
      bash.setProcessEnvironment(environment);
      bash.start(text("bash"), {folder_.path(text("job.sh"))});
      QVERIFY(bash.waitForFinished(50000));
      QVERIFY2(bash.exitCode() == 0, bash.readAllStandardError().constData());
      QCOMPARE(StudyFolder::results(out), StudyFolder::results(undisturbed()));
    }
  }

  /// By the cluster of whoever runs this, else by one of our own on loopback.
  void script_slurm_sameBytes() {
    LoopbackSlurm cluster;
    if (LoopbackSlurm::nodeState().isEmpty()) {
      if (!LoopbackSlurm::isInstalled()) {
        QSKIP("there is no Slurm here");
      }
      QVERIFY(cluster.start());
    }
    const QString out = folder_.path(text("by slurm"));
    const Finished script = runProgram(StudyFolder::words(
        folder_.study(), out, {text("--script"), text("slurm"), text("--chunks"), text("3")}));
    writeText(folder_.path(text("job.sh")), script.out.toUtf8());
    QProcess bash;
    bash.start(text("bash"), {folder_.path(text("job.sh"))});
    QVERIFY(bash.waitForFinished(50000));
    QVERIFY2(bash.exitCode() == 0, bash.readAllStandardError().constData());
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(out + text("/results.csv")), 50000);
    QTRY_COMPARE_WITH_TIMEOUT(StudyFolder::results(out), StudyFolder::results(undisturbed()),
                              10000);
  }
};

QTEST_GUILESS_MAIN(StudiesTest)
#include "tst_Studies.moc"
