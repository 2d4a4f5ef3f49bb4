#include <QDir>
#include <QJsonArray>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

constexpr char kNear[] = "    near: {start: {x: 0.0, y: 0.0, h: 0.0}, goal: {x: 2.0, y: 0.0}}\n";
constexpr char kFar[] = "    far: {start: {x: 0.0, y: 9.0, h: 0.0}, goal: {x: 5.0, y: 9.0}}\n";
/// Stands in the way of `near`, which with this planner does not stop for it.
constexpr char kBlock[] = "    block: {start: {x: 1.3, y: 0.0, h: 0.0}}\n";
constexpr char kBlind[] =
    "    near: {start: {x: 0.0, y: 0.0, h: 0.0}, goal: {x: 4.0, y: 0.0}, planner_parameters: "
    "{slow_distance: 0.0, stop_distance: 0.0}}\n";

/// Robots on the open plane.
QByteArray scenarioOf(const char* listed, const QByteArray& robots, const char* duration = "8.0") {
  return QByteArray("hunav_loader:\n  ros__parameters:\n    agents: []\n") +
         "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n    "
         "duration: " +
         duration + "\n    robots: [" + listed + "]\n" + robots;
}

/// Of metrics.json, of a robot that is not the first.
QJsonObject furtherMetrics(const QString& folder, const QString& robot) {
  return readJson(folder + text("/metrics.json"))
      .value(text("robots"))
      .toObject()
      .value(robot)
      .toObject()
      .value(text("metrics"))
      .toObject();
}

/// "result time" of each robot by the manifest.
QStringList resultsOf(const QString& folder) {
  QStringList results;
  for (const auto& robot :
       readJson(folder + text("/manifest.json")).value(text("robots")).toArray()) {
    const QJsonObject its = robot.toObject();
    results << its.value(text("name")).toString() + text(" ") +
                   its.value(text("result")).toString(text("-"));
  }
  return results;
}

QString reasonOf(const QString& folder) {
  return readJson(folder + text("/manifest.json")).value(text("reason")).toString();
}

/// [s] of the first event of this kind and robot; -1 when there is none.
double timeOf(const QString& folder, const char* kind, const char* id) {
  for (const auto& row : readCsv(folder + text("/events.csv"))) {
    if (row.at(text("kind")) == text(kind) && row.at(text("id")) == text(id)) {
      return row.at(text("time")).toDouble();
    }
  }
  return -1.0;
}

}  // namespace

/// Several robots, and what ends a run, from outside.
class RobotsProgramTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  Finished run(const QByteArray& scenario, const QString& name, const QStringList& more = {}) {
    writeText(path(name + text(".yaml")), scenario);
    return runProgram(list("run % -o %", {path(name + text(".yaml")), path(name)}) + more);
  }

 private Q_SLOTS:
  void run_twoRobots_measuresBoth() {
    const Finished made = run(scenarioOf("near, far", QByteArray(kNear) + kFar), text("pair"));
    QVERIFY2(made.exitCode == 0 && made.err.isEmpty(), qPrintable(made.err));
    const QStringList lines = made.out.trimmed().split(QLatin1Char('\n'));
    QCOMPARE(lines.front().simplified(), text("metric near far unit"));
    QVERIFY2(lines.back().contains(text("real time")), qPrintable(lines.back()));
    QVERIFY2(lines.back().contains(text("; near arrived at ")) &&
                 lines.back().contains(text(", far arrived at ")),
             qPrintable(lines.back()));
    QCOMPARE(resultsOf(path(text("pair"))),
             (QStringList{text("near arrived"), text("far arrived")}));
    const QJsonArray robots =
        readJson(path(text("pair/manifest.json"))).value(text("robots")).toArray();
    QCOMPARE(robots[0].toObject().value(text("time")).toDouble(),
             timeOf(path(text("pair")), "arrived", "-1"));
    QCOMPARE(robots[1].toObject().value(text("time")).toDouble(),
             timeOf(path(text("pair")), "arrived", "-2"));
    // Both drive straight along x, until they arrive.
    const auto lengthOf = [this](const char* id) {
      const double end = timeOf(path(text("pair")), "arrived", id);
      double length = 0.0;
      for (const auto& row : readCsv(path(text("pair/trajectory.csv")))) {
        const bool isIts = row.at(text("id")) == text(id);
        length = isIts && row.at(text("time")).toDouble() < end + 1e-9
                     ? row.at(text("x")).toDouble()
                     : length;
      }
      return length;
    };
    const QJsonObject far = furtherMetrics(path(text("pair")), text("far"));
    QVERIFY(std::fabs(valueOf(metricsOf(path(text("pair"))), text("path_length")) -
                      lengthOf("-1")) < 1e-6);
    QVERIFY(std::fabs(valueOf(far, text("path_length")) - lengthOf("-2")) < 1e-6);
    const auto row = readCsv(path(text("pair/metrics_far.csv")));
    QCOMPARE(row.size(), std::size_t{1});
    QCOMPARE(row[0].at(text("path_length")).toDouble(), valueOf(far, text("path_length")));
    QCOMPARE(readCsv(path(text("pair/steps_far.csv"))).size(),
             readCsv(path(text("pair/steps.csv"))).size());
  }

  void run_json_isTheFile() {
    const Finished made = run(scenarioOf("near, far", QByteArray(kNear) + kFar), text("json"),
                              {text("--json"), text("--duration"), text("2")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QCOMPARE(made.out.toUtf8(), bytesOf(path(text("json/metrics.json"))));
    QVERIFY(!furtherMetrics(path(text("json")), text("far")).isEmpty());
  }

  void evaluate_folderOfSeveral_givesTheSame() {
    const Finished made = run(scenarioOf("near, far", QByteArray(kNear) + kFar), text("again"));
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    const QString out = path(text("evaluated"));
    QCOMPARE(failureOf("evaluate % -o %", {path(text("again")), out}), QString());
    for (const char* name :
         {"/metrics.json", "/metrics.csv", "/steps.csv", "/metrics_far.csv", "/steps_far.csv"}) {
      QVERIFY2(!bytesOf(out + text(name)).isEmpty(), name);
      QVERIFY2(bytesOf(out + text(name)) == bytesOf(path(text("again")) + text(name)), name);
    }
    // One alone leaves no tables of the others behind.
    QCOMPARE(failureOf("evaluate % -o % --robot far", {path(text("again")), out}), QString());
    QVERIFY(!QFile::exists(out + text("/metrics_far.csv")));
    QVERIFY(!readJson(out + text("/metrics.json")).contains(text("robots")));
    QCOMPARE(metricsOf(out), furtherMetrics(path(text("again")), text("far")));
  }

  /// The world does not depend on the order, so the metrics of a robot do not either.
  void run_otherOrder_givesTheSameMetrics() {
    QCOMPARE(run(scenarioOf("near, far", QByteArray(kNear) + kFar), text("one")).exitCode, 0);
    QCOMPARE(run(scenarioOf("far, near", QByteArray(kFar) + kNear), text("two")).exitCode, 0);
    for (const bool isFirst : {true, false}) {
      const QJsonObject one =
          isFirst ? metricsOf(path(text("one"))) : furtherMetrics(path(text("one")), text("far"));
      const QJsonObject two =
          isFirst ? furtherMetrics(path(text("two")), text("near")) : metricsOf(path(text("two")));
      QVERIFY(one.size() > 80);
      QCOMPARE(one.keys(), two.keys());
      for (const QString& key : one.keys()) {
        const double difference = std::fabs(valueOf(one, key) - valueOf(two, key));
        QVERIFY2(difference < 1e-9 * std::max(1.0, std::fabs(valueOf(one, key))), qPrintable(key));
      }
    }
  }

  void run_intoTheFolderOfMoreRobots_removesTheirFiles() {
    QCOMPARE(run(scenarioOf("near, far", QByteArray(kNear) + kFar, "1.0"), text("less")).exitCode,
             0);
    QVERIFY(QFile::exists(path(text("less/steps_far.csv"))));
    writeText(path(text("less/metrics_mine.csv")), "mine");
    QCOMPARE(run(scenarioOf("near", kNear, "1.0"), text("less")).exitCode, 0);
    QVERIFY(!QFile::exists(path(text("less/metrics_far.csv"))));
    QVERIFY(!QFile::exists(path(text("less/steps_far.csv"))));
    QCOMPARE(bytesOf(path(text("less/metrics_mine.csv"))), QByteArray("mine"));
  }

  /// Both discs have 0.35 m, so they meet when it has driven 0.6 m: at 1.1 s, as after 0.5 m and
  /// 1 s it has its full speed.
  void run_stopOnCollision_endsThere() {
    const QByteArray scenario = scenarioOf("near, block", QByteArray(kBlind) + kBlock);
    const Finished made = run(scenario, text("hit"), {text("--stop-on-collision"), text("any")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QCOMPARE(reasonOf(path(text("hit"))), text("collision: near with block"));
    QCOMPARE(resultsOf(path(text("hit"))), (QStringList{text("near collision"), text("block -")}));
    QVERIFY(std::fabs(timeOf(path(text("hit")), "contact", "-1") - 1.1) < 0.2);
    QVERIFY2(made.out.contains(text("; near collision at 1.")), qPrintable(made.out));
    QCOMPARE(run(scenario, text("through"), {text("--stop-on-collision"), text("people")}).exitCode,
             0);
    QCOMPARE(reasonOf(path(text("through"))), text("duration"));
  }

  void run_stuckAfter_endsThere() {
    const Finished made = run(scenarioOf("near, block", QByteArray(kBlind) + kBlock, "30.0"),
                              text("stuck"), {text("--stuck-after"), text("2.5")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QCOMPARE(reasonOf(path(text("stuck"))), text("stuck: near"));
    QCOMPARE(resultsOf(path(text("stuck"))), (QStringList{text("near stuck"), text("block -")}));
    const double told = timeOf(path(text("stuck")), "stuck", "-1");
    QVERIFY2(told > 3.4 && told < 5.0, qPrintable(QString::number(told)));
  }

  void run_wrongWords_areRefused() {
    for (const QStringList& words : {list("--stop-on-collision maybe"), list("--stuck-after -1"),
                                     list("--stuck-after soon")}) {
      const Finished made = run(scenarioOf("near", kNear), text("wrong"), words);
      QVERIFY2(made.exitCode == 64, qPrintable(words.join(QLatin1Char(' '))));
      QVERIFY(made.err.contains(words[0]));
    }
  }

  void batch_severalRobots_haveColumnsOfTheirOwn() {
    writeText(path(text("s.yaml")), scenarioOf("near, far", QByteArray(kNear) + kFar, "4.0"));
    writeText(path(text("hit.yaml")),
              scenarioOf("near, block", QByteArray(kBlind) + kBlock, "4.0"));
    writeText(path(text("e.yaml")),
              "hunavsim_experiment: 1\nscenarios: [s.yaml, hit.yaml]\n"
              "stop_on_collision: any\nstuck_after: 60.0\n");
    const QString out = path(text("batch"));
    QCOMPARE(failureOf("batch % -o % --jobs 1", {path(text("e.yaml")), out}), QString());
    const auto rows = readCsv(out + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{2});
    QCOMPARE(rows[0].at(text("status")), text("ok"));
    QCOMPARE(rows[0].at(text("reason")), text("duration"));
    QCOMPARE(rows[1].at(text("status")), text("ok"));
    QCOMPARE(rows[1].at(text("reason")), text("collision: near with block"));
    QVERIFY(rows[0].at(text("path_length")).toDouble() > 1.0);
    QVERIFY(rows[0].at(text("far.path_length")).toDouble() >
            rows[0].at(text("path_length")).toDouble() + 0.5);
    QCOMPARE(rows[0].at(text("block.path_length")), QString());
    QCOMPARE(rows[1].at(text("far.path_length")), QString());
    QVERIFY(rows[1].at(text("block.path_length")).toDouble() < 1e-3);  // by the push
    const QString head =
        QString::fromUtf8(bytesOf(out + text("/results.csv"))).section(QLatin1Char('\n'), 0, 0);
    QVERIFY(head.indexOf(text(",path_length,")) < head.indexOf(text("far.")));
    QVERIFY(head.lastIndexOf(text("far.")) < head.indexOf(text("block.")));
    // The same for one run of the first scenario alone.
    const Finished alone = runProgram("run % -o %", {path(text("s.yaml")), path(text("alone"))});
    QVERIFY2(alone.exitCode == 0, qPrintable(alone.err));
    QCOMPARE(rows[0].at(text("far.path_length")).toDouble(),
             valueOf(furtherMetrics(path(text("alone")), text("far")), text("path_length")));
  }
};

QTEST_GUILESS_MAIN(RobotsProgramTest)
#include "tst_RobotsProgram.moc"
