#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

constexpr const char* kShortRun =
    "hunavsim_experiment: 1\nscenarios: [corner_cafe_agents]\nduration: 0.5\n";

}  // namespace

/// `hunavsim batch` from outside.
class BatchProgramTest : public QObject {
  Q_OBJECT

 private:
  static Finished batch(const QString& experiment, const QString& folder, int jobs) {
    return runProgram("batch % -o % --jobs %", {experiment, folder, QString::number(jobs)});
  }

 private Q_SLOTS:
  void batch_jobs_sameBytesAndOrder() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("seeds.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\n"
              "scenarios: [corner_cafe_agents]\n"
              "seeds: 3\n"
              "duration: 5.0\n"
              "values:\n"
              "  \"*.max_vel\": [1.0, 1.4]\n");
    const QString one = folder.filePath(text("one"));
    const QString two = folder.filePath(text("two"));
    const Finished first = batch(experiment, one, 1);
    QVERIFY2(first.exitCode == 0, qPrintable(first.err));
    QCOMPARE(batch(experiment, two, 2).exitCode, 0);
    for (const char* name : {"/results.csv", "/manifest.json"}) {
      const QByteArray bytes = bytesOf(one + QString::fromLatin1(name));
      QVERIFY(!bytes.isEmpty());
      QVERIFY2(bytes == bytesOf(two + QString::fromLatin1(name)), name);
    }
    const auto rows = readCsv(one + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{6});
    const char* speeds[] = {"1.0", "1.0", "1.0", "1.4", "1.4", "1.4"};
    for (std::size_t k = 0; k < rows.size(); ++k) {
      QCOMPARE(rows[k].at(text("run")).toInt(), static_cast<int>(k));
      QCOMPARE(rows[k].at(text("seed")).toInt(), static_cast<int>(k % 3) + 1);
      QCOMPARE(rows[k].at(text("*.max_vel")), QString::fromLatin1(speeds[k]));
      QCOMPARE(rows[k].at(text("status")), text("ok"));
      QCOMPARE(rows[k].at(text("simulated")).toDouble(), 5.0);
      QVERIFY(rows[k].at(text("path_length")).toDouble() > 1.0);
    }
    QVERIFY(!QDir(one + text("/runs")).exists());  // record: metrics
  }

  /// Runs whose folders are not kept make less of them; the results are the same.
  void batch_record_changesNoResult() {
    QTemporaryDir folder;
    QByteArray results[2];
    for (const bool all : {false, true}) {
      const QString experiment = folder.filePath(text("one.yaml"));
      writeText(experiment, QByteArray("hunavsim_experiment: 1\n"
                                       "scenarios: [corner_cafe_agents]\n"
                                       "seeds: 1\n"
                                       "duration: 12.0\n") +
                                (all ? "record: all\n" : ""));
      const QString out = folder.filePath(all ? text("all") : text("some"));
      QCOMPARE(batch(experiment, out, 1).exitCode, 0);
      results[all ? 1 : 0] = bytesOf(out + text("/results.csv"));
    }
    QVERIFY(results[0].size() > 2000);
    QCOMPARE(results[0], results[1]);
    const QString kept = folder.filePath(text("all/runs/0"));
    QVERIFY(QFile::exists(kept + text("/steps.csv")));
    // The same into a folder that holds a whole run: its other files are gone.
    QCOMPARE(failureOf("run corner_cafe_agents --duration 1 --totals -o %", {kept}), QString());
    QCOMPARE(QDir(kept).entryList(QDir::Files, QDir::Name), list("manifest.json metrics.json"));
  }

  /// A run that is too short for its goal: what is undefined is empty.
  void batch_undefinedMetrics_areEmptyFields() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("short.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\n"
              "scenarios: [corner_cafe_agents]\n"
              "seeds: 1\n"
              "duration: 0.1\n");
    const QString out = folder.filePath(text("out"));
    QCOMPARE(batch(experiment, out, 1).exitCode, 0);
    const auto rows = readCsv(out + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{1});
    QCOMPARE(rows[0].at(text("time_to_reach_goal")), QString());
    QCOMPARE(rows[0].at(text("completed")), text("False"));
    for (const auto& [column, field] : rows[0]) {
      for (const char* word : {"nan", "inf", "-inf", "null"}) {
        QVERIFY2(field.toLower() != QLatin1String(word), qPrintable(column));
      }
    }
  }

  /// A navigator that gives up, and one that reports success far from the goal.
  void batch_endOfTheNavigator_isInColumns() {
    QTemporaryDir folder;
    const auto tree = [&folder](const char* node) {
      const QString path = folder.filePath(QLatin1String(node) + text(".xml"));
      writeText(path,
                "<root BTCPP_format=\"4\" main_tree_to_execute=\"T\"><BehaviorTree "
                "ID=\"T\"><" +
                    QByteArray(node) + "/></BehaviorTree></root>");
      return path.toUtf8();
    };
    const QString experiment = folder.filePath(text("ends.yaml"));
    writeText(experiment, "hunavsim_experiment: 1\nscenarios: [" SOURCE_DIR
                          "/maps/planners/crossing_agents.yaml]\nseeds: 2\n"
                          "planner: nav2\nvalues:\n  robot1.nav2_tree: [" +
                              tree("AlwaysFailure") + ", " + tree("AlwaysSuccess") + "]\n");
    const QString out = folder.filePath(text("out"));
    const Finished found = batch(experiment, out, 1);
    QVERIFY2(found.exitCode == 0, qPrintable(found.err));
    const auto rows = readCsv(out + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{4});
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool fails = k < 2;
      const auto field = [&](const char* key) { return rows[k].at(QLatin1String(key)); };
      QCOMPARE(field("ended_by_failure"), QLatin1String(fails ? "True" : "False"));
      QCOMPARE(field("ended_by_success"), QLatin1String(fails ? "False" : "True"));
      QCOMPARE(field("ended_by_time"), text("False"));
      QCOMPARE(field("success"), text("False"));
      QVERIFY(field("distance_left").toDouble() > 13.0);
      QVERIFY2(
          field("reason").startsWith(QLatin1String(
              fails ? "navigation_failed: robot1, node AlwaysFailure" : "goal_missed: robot1, ")),
          qPrintable(field("reason")));
    }
    QCOMPARE(failureOf("report % -q", {out}), QString());
    const QByteArray html = bytesOf(out + text("/report.html"));
    QVERIFY(html.contains("Ended by the navigator"));
    QVERIFY(html.contains("node AlwaysFailure"));
  }

  void batch_failedRun_isARowWithItsReason() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("walls.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\n"
              "scenarios: [corner_cafe_agents]\n"
              "duration: 1.0\n"
              "record: failed\n"
              "values:\n"
              "  Ana.init_pose.x: [7.35, -40.0]\n");  // the second stands far outside
    const QString out = folder.filePath(text("out"));
    const Finished found = batch(experiment, out, 2);
    QVERIFY2(found.exitCode == 1, qPrintable(found.err));
    const auto rows = readCsv(out + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{2});
    QCOMPARE(rows[0].at(text("status")), text("ok"));
    QCOMPARE(rows[1].at(text("status")), text("failed"));
    QVERIFY(!rows[1].at(text("reason")).isEmpty());
  }

  /// Of four runs one succeeds, one has no time to, and two cannot begin.
  void batch_record_keepsWhatItSays_data() {
    QTest::addColumn<QByteArray>("record");
    QTest::addColumn<QStringList>("kept");
    QTest::newRow("metrics") << QByteArray("metrics") << QStringList();
    QTest::newRow("failed") << QByteArray("failed") << QStringList();
    QTest::newRow("unsuccessful") << QByteArray("unsuccessful") << list("1");
    QTest::newRow("all") << QByteArray("all") << list("0 1");
  }
  void batch_record_keepsWhatItSays() {
    QFETCH(const QByteArray, record);
    QFETCH(const QStringList, kept);
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    writeText(
        experiment,
        kShortRun + ("record: " + record) +
            "\nvalues:\n  Ana.init_pose.x: [7.35, -40.0]\n  robot1.goal_radius: [100.0, 0.2]\n");
    const QString out = folder.filePath(text("out"));
    batch(experiment, out, 1);
    const auto rows = readCsv(out + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{4});
    QCOMPARE(rows[0].at(text("success")), text("True"));
    QCOMPARE(rows[1].at(text("success")), text("False"));
    QCOMPARE(rows[2].at(text("status")), text("failed"));
    QCOMPARE(QDir(out + text("/runs")).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name),
             kept);
  }

  void batch_folderOfAnEarlierBatch_lendsNoValues() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("twice.yaml"));
    const QString out = folder.filePath(text("out"));
    const auto rowOf = [&](const char* places) {
      writeText(experiment, QByteArray("hunavsim_experiment: 1\n"
                                       "scenarios: [corner_cafe_agents]\n"
                                       "duration: 1.0\n"
                                       "record: all\n"
                                       "values:\n"
                                       "  Ana.init_pose.x: ") +
                                places);
      batch(experiment, out, 1);
      return readCsv(out + text("/results.csv")).back();
    };
    QVERIFY(!rowOf("[7.35, 7.3]\n").at(text("path_length")).isEmpty());
    const auto failed = rowOf("[7.35, -40.0]\n");  // refused before it writes anything
    QCOMPARE(failed.at(text("status")), text("failed"));
    QVERIFY(failed.at(text("path_length")).isEmpty());
  }

  /// Files that are of no batch stay, and stop it.
  void batch_strangersInRuns_areKept() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    const QString out = folder.filePath(text("out"));
    writeText(experiment, kShortRun);
    const auto tried = [&] { return runProgram("batch % -o %", {experiment, out}); };
    writeText(out + text("/runs/0/notes.txt"), "mine");
    Finished finished = tried();
    QCOMPARE(finished.exitCode, 2);
    QVERIFY2(finished.err.contains(text("notes.txt: error: not part of a batch")),
             qPrintable(finished.err));
    QCOMPARE(bytesOf(out + text("/runs/0/notes.txt")), QByteArray("mine"));
    // Nor is a run that somebody else made, whatever its files are called.
    QVERIFY(QFile::remove(out + text("/runs/0/notes.txt")));
    writeText(out + text("/runs/0/trajectory.csv"), "mine");
    finished = tried();
    QCOMPARE(finished.exitCode, 2);
    QVERIFY2(finished.err.contains(text("trajectory.csv: error: not part of a batch")),
             qPrintable(finished.err));
    QCOMPARE(bytesOf(out + text("/runs/0/trajectory.csv")), QByteArray("mine"));
    QVERIFY(QFile::remove(out + text("/runs/0/trajectory.csv")));
    for (const char* file : {"/results.csv", "/manifest.json"}) {
      writeText(out + QLatin1String(file), "{}");
      finished = tried();
      QCOMPARE(finished.exitCode, 2);
      QVERIFY2(finished.err.contains(text("--force")), qPrintable(finished.err));
      QCOMPARE(bytesOf(out + QLatin1String(file)), QByteArray("{}"));
      QVERIFY(QFile::remove(out + QLatin1String(file)));
    }
    // Leftovers of a run are no strangers: they are removed.
    writeText(out + text("/runs/0/trajectory.csv.new-1-0"), "cut");
    finished = tried();
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(!QFile::exists(out + text("/runs/0/trajectory.csv.new-1-0")));
  }

  /// Without its manifest a run is read as it is: who takes it away does not want to lose the run.
  void resume_runWithoutManifest_isKept() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    const QString out = folder.filePath(text("out"));
    writeText(experiment, QByteArray(kShortRun) + "record: all\n");
    const QStringList words = list("batch % -q -o %", {experiment, out});
    QCOMPARE(runProgram(words).exitCode, 0);
    const QString run = out + text("/runs/0/");
    const QByteArray recorded = bytesOf(run + text("trajectory.csv"));
    QVERIFY(!recorded.isEmpty());
    QVERIFY(QFile::remove(run + text("manifest.json")));
    QCOMPARE(runProgram(words + list("--resume")).exitCode, 0);
    QCOMPARE(bytesOf(run + text("trajectory.csv")), recorded);
  }

  /// Somebody's work on the table is not lost.
  void batch_overAChangedTable_isRefused() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    const QString out = folder.filePath(text("out"));
    writeText(experiment, kShortRun);
    const QStringList words = list("batch % -q -o %", {experiment, out});
    QCOMPARE(runProgram(words).exitCode, 0);
    QCOMPARE(runProgram(words).exitCode, 0);  // its own it writes again
    const QString table = out + text("/results.csv");
    const QByteArray changed = bytesOf(table) + "my remark\n";
    writeText(table, changed);
    const auto refused = runProgram(words);
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.err.contains(table + text(": error: ")), qPrintable(refused.err));
    QCOMPARE(bytesOf(table), changed);
    QCOMPARE(runProgram(words + list("--force")).exitCode, 0);
    QVERIFY(bytesOf(table) != changed);
  }

  /// What a link points at is not of this folder.
  void batch_linkInPlaceOfRuns_isRefused() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    const QString out = folder.filePath(text("out"));
    const QString elsewhere = folder.filePath(text("elsewhere"));
    writeText(experiment, kShortRun);
    writeText(elsewhere + text("/trajectory.csv"), "mine");
    for (const char* link : {"/runs/0", "/runs"}) {
      QDir(out).removeRecursively();
      const QString place = out + QString::fromLatin1(link);
      QVERIFY(QDir().mkpath(QFileInfo(place).absolutePath()));
      QVERIFY(QFile::link(elsewhere, place));
      QCOMPARE(unexpected(runProgram("batch % -o %", {experiment, out}), 2,
                          "not part of a batch, and not a folder"),
               QString());
      const Finished forced = runProgram("batch % --force -o %", {experiment, out});
      QCOMPARE(forced.exitCode, 2);
      QCOMPARE(bytesOf(elsewhere + text("/trajectory.csv")), QByteArray("mine"));
    }
  }

  void batch_wrongExperiment_saysEveryProblem() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("bad.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\n"
              "scenarios: [no_such_place]\n"
              "seed: 3\n"
              "duration: soon\n");
    const Finished found = batch(experiment, folder.filePath(text("out")), 1);
    QCOMPARE(found.exitCode, 2);
    QVERIFY2(found.err.contains(text("bad.yaml:2:13: error:")), qPrintable(found.err));
    QVERIFY2(found.err.contains(text("did you mean 'seeds'")), qPrintable(found.err));
    QVERIFY2(found.err.contains(text("bad.yaml:4:11: error: duration")), qPrintable(found.err));
    QVERIFY(!QDir(folder.filePath(text("out"))).exists());
  }

  void check_valuesThatNoScenarioTakes_areToldWithTheirPlaces() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("values.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\n"
              "scenarios: [corner_cafe_agents]\n"
              "model: sfn\n"
              "values:\n"
              "  Anna.max_vel: [1.0]\n"
              "  Ana.max_vel: [1.0, abc]\n");
    const Finished found = runProgram("check %", {experiment});
    QCOMPARE(found.exitCode, 2);
    for (const char* place :
         {"values.yaml:3:8: error:", "values.yaml:5:18: error:", "values.yaml:6:22: error:"}) {
      QVERIFY2(found.err.contains(QString::fromLatin1(place)), qPrintable(found.err));
    }
  }

  void check_experiment_isFine() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("fine.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\nscenarios: [corner_cafe_agents]\nseeds: [3, 7]\n");
    const Finished found = runProgram("check %", {experiment});
    QVERIFY2(found.exitCode == 0, qPrintable(found.err));
    QVERIFY(found.out.contains(text("0 errors")));
  }
};

QTEST_GUILESS_MAIN(BatchProgramTest)
#include "tst_BatchProgram.moc"
