#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::Finished;
using outside::runProgram;
using outside::text;

/// What the clock says about a run: told, and in none of the files that are equal from run to run.
class RunClockTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void run_withRobot_tellsPlanningTime();
  void run_withoutRobot_saysWhyNot();

 private:
  Finished run(const char* scenario, const char* to);
  QJsonValue ofManifest(const char* run, const char* key) const {
    return outside::readJson(path(run) + text("/manifest.json")).value(text(key));
  }
  QString path(const char* name) const { return folder_.filePath(text(name)); }

  QTemporaryDir folder_;
};

Finished RunClockTest::run(const char* scenario, const char* to) {
  return runProgram(
      {text("run"), text(scenario), text("--duration"), text("5"), text("-o"), path(to)});
}

void RunClockTest::run_withRobot_tellsPlanningTime() {
  const Finished first = run("two_workers_agents", "first");
  QCOMPARE(first.exitCode, 0);
  QCOMPARE(run("two_workers_agents", "second").exitCode, 0);
  for (const char* key : {"planning_time_mean", "planning_time_std"}) {
    QVERIFY2(ofManifest("first", key).toDouble() > 0.0, key);
    QVERIFY2(first.out.contains(QRegularExpression(text(key) + text(" +[0-9.e-]+  s\n"))), key);
  }
  for (const char* name : {"/metrics.json", "/metrics.csv", "/steps.csv", "/trace.json"}) {
    const QByteArray bytes = outside::bytesOf(path("first") + text(name));
    QVERIFY2(!bytes.isEmpty() && !bytes.contains("planning_time"), name);
    QVERIFY2(bytes == outside::bytesOf(path("second") + text(name)), name);
  }
}

void RunClockTest::run_withoutRobot_saysWhyNot() {
  const Finished finished = run("realism_corner_agents", "alone");
  QCOMPARE(finished.exitCode, 0);
  QVERIFY(ofManifest("alone", "planning_time_mean").isNull());
  QVERIFY(finished.out.contains(
      QRegularExpression(text("planning_time_mean +-  s \\(no planner was called\\)"))));
}

QTEST_GUILESS_MAIN(RunClockTest)
#include "tst_RunClock.moc"
