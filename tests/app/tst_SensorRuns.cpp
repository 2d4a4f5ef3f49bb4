#include <QJsonArray>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

/// What the program writes about the sensors of robots, and what it says of bad ones.
class SensorRunsTest : public QObject, protected InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void run_recordedLidar_writesScans();
  void run_laterWithoutRecording_takesTheScansAway();
  void run_manifest_namesTheSensors();
  void run_groundTruth_isToldInTheManifest();
  void run_setOnTheCommandLine_counts();
  void check_badValues_areToldWithTheirLines();
  void check_badLocalization_isToldWithItsLines();
  void batch_localizationVaried_isInTheTable();

 private:
  QByteArray scenarioWith(const QByteArray& robotKeys) const;
  Finished runWith(const QByteArray& robotKeys, const QString& out,
                   const QStringList& more = {}) const;
};

void SensorRunsTest::initTestCase() {
  QVERIFY(folder_.isValid());
}

QByteArray SensorRunsTest::scenarioWith(const QByteArray& robotKeys) const {
  return "hunav_loader:\n  ros__parameters:\n    agents: []\nhunavsim_desktop:\n"
         "  ros__parameters:\n    format: 1\n    map_file: none\n    duration: 1.0\n    robots:\n"
         "      - r\n    r:\n      start:\n        x: 0.0\n        y: 0.0\n        h: 0.0\n"
         "      goal:\n        x: 5.0\n        y: 0.0\n" +
         robotKeys;
}

Finished SensorRunsTest::runWith(const QByteArray& robotKeys, const QString& out,
                                 const QStringList& more) const {
  writeText(path("s.yaml"), scenarioWith(robotKeys));
  return runProgram(list("run % -o % --quiet", {path("s.yaml"), out}) + more);
}

/// 1 s at 4 Hz: turns at 0, 0.25, 0.5 and 0.75 s.
void SensorRunsTest::run_recordedLidar_writesScans() {
  const QByteArray keys =
      "      lidar:\n        beams: 8\n        rate: 4.0\n        record: true\n";
  QCOMPARE(runWith(keys, path("one")).exitCode, 0);
  QCOMPARE(runWith(keys, path("two")).exitCode, 0);
  const QByteArray scans = bytesOf(path("one/scans.csv"));
  QVERIFY(scans == bytesOf(path("two/scans.csv")));
  const QList<QByteArray> lines = scans.split('\n');
  QCOMPARE(lines.size(), 6);  // the head, four turns, the end
  QCOMPARE(lines[0], QByteArray("step,time,id,x,y,heading,angle_min,angle_step,range,distances"));
  const char* const starts[] = {"0,0,-1,", "5,0.25,-1,", "10,0.5,-1,", "15,0.75,-1,"};
  for (int i = 0; i < 4; ++i) {
    QVERIFY(lines[i + 1].startsWith(starts[i]));
    QVERIFY(lines[i + 1].endsWith(",10,10 10 10 10 10 10 10 10"));  // nothing is there
  }
}

void SensorRunsTest::run_laterWithoutRecording_takesTheScansAway() {
  const QByteArray keys = "      lidar:\n        record: true\n";
  QCOMPARE(runWith(keys, path("again")).exitCode, 0);
  QVERIFY(QFileInfo::exists(path("again/scans.csv")));
  QCOMPARE(runWith({}, path("again")).exitCode, 0);
  QVERIFY(!QFileInfo::exists(path("again/scans.csv")));
  QVERIFY(QFileInfo::exists(path("again/trajectory.csv")));
}

void SensorRunsTest::run_manifest_namesTheSensors() {
  QCOMPARE(runWith("      kinematics: omnidirectional\n"
                   "      detector:\n        noise: 0.05\n        latency: 0.2\n"
                   "      odometry_noise:\n        alpha3: 0.01\n"
                   "      localization:\n        std_x: 0.05\n",
                   path("manifest"))
               .exitCode,
           0);
  const QJsonObject robot = readJson(path("manifest/manifest.json"))
                                .value(QLatin1String("robots"))
                                .toArray()
                                .at(0)
                                .toObject();
  QCOMPARE(robot.value(QLatin1String("kinematics")).toString(), text("omnidirectional"));
  const QJsonObject detector = robot.value(QLatin1String("detector")).toObject();
  QCOMPARE(detector.value(QLatin1String("kind")).toString(), text("sensor"));
  QCOMPARE(detector.value(QLatin1String("range")).toDouble(), 10.0);
  QCOMPARE(detector.value(QLatin1String("noise")).toDouble(), 0.05);
  QCOMPARE(detector.value(QLatin1String("latency")).toDouble(), 0.2);
  QCOMPARE(detector.value(QLatin1String("velocities")).toString(), text("filtered"));
  const QJsonObject lidar = robot.value(QLatin1String("lidar")).toObject();
  QCOMPARE(lidar.value(QLatin1String("beams")).toInt(), 360);
  QCOMPARE(lidar.value(QLatin1String("range")).toDouble(), 10.0);
  const QJsonObject odometry = robot.value(QLatin1String("odometry_noise")).toObject();
  QCOMPARE(odometry.value(QLatin1String("alpha3")).toDouble(), 0.01);
  QCOMPARE(odometry.value(QLatin1String("alpha1")).toDouble(-1.0), 0.0);
  const QJsonObject localization = robot.value(QLatin1String("localization")).toObject();
  QCOMPARE(localization.value(QLatin1String("std_x")).toDouble(), 0.05);
  QCOMPARE(localization.value(QLatin1String("std_y")).toDouble(-1.0), 0.0);
  QCOMPARE(localization.value(QLatin1String("rate")).toDouble(), 2.0);  // as there is an error
  const QByteArray trace = bytesOf(path("manifest/trace.json"));
  QVERIFY(trace.contains("\"kinematics\":\"omnidirectional\""));
}

void SensorRunsTest::run_groundTruth_isToldInTheManifest() {
  QCOMPARE(runWith("      detector:\n        kind: ground_truth\n      lidar:\n        beams: 0\n",
                   path("truth"))
               .exitCode,
           0);
  const QJsonObject robot = readJson(path("truth/manifest.json"))
                                .value(QLatin1String("robots"))
                                .toArray()
                                .at(0)
                                .toObject();
  const QJsonObject all = {{text("kind"), text("ground_truth")}};
  QCOMPARE(robot.value(QLatin1String("detector")).toObject(), all);
  const QJsonObject none = {{text("beams"), 0}};
  QCOMPARE(robot.value(QLatin1String("lidar")).toObject(), none);
}

void SensorRunsTest::run_setOnTheCommandLine_counts() {
  const Finished run =
      runWith({}, path("set"),
              {text("--set"), text("r.lidar.record=true"), text("--set"), text("r.lidar.beams=3"),
               text("--set"), text("r.detector.range=4.5")});
  QVERIFY2(run.exitCode == 0, qPrintable(run.err));
  QVERIFY(bytesOf(path("set/scans.csv")).contains(",10,10 10 10\n"));
  QVERIFY(bytesOf(path("set/manifest.json")).contains("\"range\": 4.5"));
}

/// The keys of the robot begin in line 19.
void SensorRunsTest::check_badValues_areToldWithTheirLines() {
  writeText(path("bad.yaml"),
            scenarioWith("      kinematics: hover\n"
                         "      lidar:\n        beams: -1\n        range: far\n"
                         "      detector:\n        misses: 1.5\n        rnage: 2.0\n"));
  const Finished check = runProgram("check %", {path("bad.yaml")});
  QCOMPARE(check.exitCode, 2);
  const QStringList told = list(":19: :21: :22: :24: :25:");
  for (const QString& line : told) {
    QVERIFY2(check.err.contains(text("bad.yaml") + line), qPrintable(check.err));
  }
  QVERIFY(check.err.contains(text("'range'")));  // for rnage
  writeText(path("span.yaml"), scenarioWith("      lidar:\n        angle_min: 1.0\n"
                                            "        angle_max: 0.5\n"));
  const Finished span = runProgram("check %", {path("span.yaml")});
  QCOMPARE(unexpected(span, 2, "span.yaml:11:"), QString());
  QVERIFY2(span.err.contains(text("angle_max must be above angle_min")), qPrintable(span.err));
}

/// The keys of the robot begin in line 19.
void SensorRunsTest::check_badLocalization_isToldWithItsLines() {
  writeText(path("lost.yaml"),
            scenarioWith("      localization:\n        std_x: -0.1\n        std_yaw: 2.0\n"
                         "        correlation_time: .nan\n        jump_rate: often\n"
                         "        start_yaw: 4.0\n        std_z: 0.1\n        rate: 1e9\n"));
  const Finished check = runProgram("check %", {path("lost.yaml")});
  QCOMPARE(check.exitCode, 2);
  for (const char* line : {":20:16: error", ":21:18: error", ":22:27: error", ":23:20: error",
                           ":24:20: error", ":25:9: warning", ":26:15: error"}) {
    QVERIFY2(check.err.contains(text("lost.yaml") + QLatin1String(line)),
             qPrintable(QLatin1String(line) + QLatin1Char('\n') + check.err));
  }
  const Finished set =
      runWith({}, path("refused"), {text("--set"), text("r.localization.std_x=11")});
  QCOMPARE(set.exitCode, 64);  // a wrong command line
  QVERIFY2(set.err.contains(text("std_x")), qPrintable(set.err));
}

void SensorRunsTest::batch_localizationVaried_isInTheTable() {
  writeText(path("s.yaml"), scenarioWith({}));
  writeText(path("e.yaml"), "hunavsim_experiment: 1\nscenarios: [" + path("s.yaml").toUtf8() +
                                "]\nseeds: 2\nvalues:\n  r.localization.std_y: [0.0, 0.1]\n");
  const Finished batch = runProgram("batch % -q -o %", {path("e.yaml"), path("batch")});
  QVERIFY2(batch.exitCode == 0, qPrintable(batch.err));
  const auto rows = readCsv(path("batch/results.csv"));
  QCOMPARE(rows.size(), 4);
  int varied = 0;
  for (const auto& row : rows) {
    const QString value = row.at(text("r.localization.std_y"));
    varied += value.toDouble() == 0.1 ? 1 : 0;
  }
  QCOMPARE(varied, 2);
}

QTEST_GUILESS_MAIN(SensorRunsTest)
#include "tst_SensorRuns.moc"
