#include <QJsonArray>
#include <QtTest>

#include "tests/app/Nav2Yard.h"
#include "tests/app/StudyFiles.h"

using outside::failureOf;
using outside::runProgram;
using outside::text;
using outside::unexpected;

/// `hunavsim verify` from outside.
class VerifyProgramTest : public QObject {
  Q_OBJECT

 private:
  outside::StudyFolder folder_;

  QString path(const char* name) const { return folder_.path(text(name)); }
  /// Empty: the run is made, packed, and equal when it is repeated.
  QString failureOfRun(const QStringList& words) const {
    QDir(path("run")).removeRecursively();
    QFile::remove(path("run.hnv"));
    QString failure = failureOf(QStringList{text("run")} + words +
                                QStringList{text("-q"), text("-o"), path("run")});
    if (failure.isEmpty()) {
      failure = failureOf("pack % -o % -q", {path("run"), path("run.hnv")});
    }
    return failure.isEmpty() ? failureOf("verify %", {path("run.hnv")}) : failure;
  }

 private Q_SLOTS:
  void initTestCase() {
    outside::writeText(path("study.yaml"),
                       "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 10\nduration: 1.0\n"
                       "values:\n  robot1.planner: [pursuit, dwa]\n");
    QCOMPARE(failureOf("batch % -o % -q", {path("study.yaml"), path("results")}), QString());
    QCOMPARE(failureOf("pack % -o % -q", {path("results"), path("study.hnv")}), QString());
  }

  void equalStudy_isFineAndSaysWhatWasRepeated() {
    const outside::Finished found =
        runProgram(outside::list("verify % --sample 20% --seed 3", {path("study.hnv")}));
    QCOMPARE(found.exitCode, 0);
    QCOMPARE(found.err, QString());
    QVERIFY(found.out.startsWith(text("batch of 20 runs by hunavsim ")));
    QVERIFY(found.out.contains(text("repeated 4 of 20 runs (--seed 3): ")));
    QVERIFY(found.out.endsWith(text("\nequal\n")));
    QCOMPARE(found.out,
             runProgram(outside::list("verify % --runs 4 --seed 3 -j 1", {path("study.hnv")})).out);
    QVERIFY(found.out !=
            runProgram(outside::list("verify % --runs 4 --seed 4", {path("study.hnv")})).out);
  }

  /// Without a seed the sample cannot be known beforehand, but can be repeated.
  void seed_notGiven_isPrinted() {
    const outside::Finished first = runProgram(outside::list("verify %", {path("study.hnv")}));
    const QRegularExpressionMatch seed =
        QRegularExpression(text("repeated 1 of 20 runs \\(--seed (\\d+)\\)")).match(first.out);
    QVERIFY2(seed.hasMatch(), qPrintable(first.out));
    QCOMPARE(
        runProgram(outside::list("verify % --seed %", {path("study.hnv"), seed.captured(1)})).out,
        first.out);
  }

  void json_listsDifferences() {
    QByteArray bytes = outside::bytesOf(path("study.hnv"));
    outside::writeText(path("copy.hnv"), bytes);
    const outside::Finished equal =
        runProgram(outside::list("verify % --runs 2 --json", {path("copy.hnv")}));
    QCOMPARE(equal.exitCode, 0);
    const QJsonObject json = QJsonDocument::fromJson(equal.out.toUtf8()).object();
    QCOMPARE(json[text("equal")].toBool(), true);
    QCOMPARE(json[text("runs")].toInt(), 20);
    QCOMPARE(json[text("repeated")].toArray().size(), 2);
    QCOMPARE(json[text("differences")].toArray().size(), 0);
    QCOMPARE(json[text("identity")].toString().size(), 64);
  }

  void damaged_isBadInput() {
    QByteArray bytes = outside::bytesOf(path("study.hnv"));
    outside::writeText(path("cut.hnv"), bytes.left(bytes.size() / 2));
    QCOMPARE(unexpected(runProgram("verify %", {path("cut.hnv")}), 2, "is not a ZIP archive"),
             QString());
    QCOMPARE(unexpected(runProgram("verify %", {path("absent.hnv")}), 2, "cannot read"), QString());
  }

  void words_thatAreWrong_areRefused_data() {
    QTest::addColumn<QString>("more");
    for (const char* more : {"--sample 5", "--sample 0%", "--sample 101%", "--sample x%",
                             "--runs -1", "--runs 2 --sample 5%", "--jobs 0"}) {
      QTest::newRow(more) << text(more);
    }
  }
  void words_thatAreWrong_areRefused() {
    QFETCH(QString, more);
    const QStringList words =
        QStringList{text("verify"), path("study.hnv")} + more.split(QLatin1Char(' '));
    QCOMPARE(runProgram(words).exitCode, 64);
  }

  void runs_ofAllKinds_areEqual() {
    QCOMPARE(failureOfRun({text("corner_cafe_agents"), text("--duration"), text("2"),
                           text("--seed"), text("4")}),
             QString());
    QCOMPARE(failureOfRun({path("yard.yaml"), text("--duration"), text("2"), text("--totals")}),
             QString());
    QCOMPARE(failureOfRun({path("yard.yaml"), text("--duration"), text("2"),
                           text("--counterfactual"), text("--record-every"), text("3")}),
             QString());
    QCOMPARE(failureOfRun({path("yard.yaml"), text("--duration=2"), text("--record"), text("mcap"),
                           text("--set"), text("anna.max_vel=1.4")}),
             QString());
  }

  void runOfNav2_isEqual() {
    outside::writeNav2Yard(path("n"));
    QCOMPARE(failureOfRun({path("n/yard.yaml"), text("--duration"), text("1")}), QString());
    QCOMPARE(
        failureOfRun({path("n/yard.yaml"), text("--duration"), text("1"), text("--nav2-params"),
                      path("n/params_jazzy.yaml"), text("--map"), path("n/yard_map.yaml")}),
        QString());
  }

  void runWithMetricsFile_isEqual() {
    outside::writeText(path("metrics.yaml"), "metrics: [path_length]\n");
    if (failureOf("run % --metrics % --duration 1 -q", {path("yard.yaml"), path("metrics.yaml")})
            .isEmpty()) {
      QCOMPARE(failureOfRun({path("yard.yaml"), text("--duration"), text("1"), text("--metrics"),
                             path("metrics.yaml")}),
               QString());
    }
  }

  void externalPlanner_startsOnlyWithPermission() {
    const QByteArray follow = outside::bytesOf(text(SOURCE_DIR "/resources/planners/follow.py"));
    outside::writeText(path("follow.py"), follow);
    QFile::setPermissions(path("follow.py"),
                          QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QByteArray scenario = outside::kYardText;
    scenario.replace("    robot1:\n",
                     "    robot1:\n      planner: external\n      command: ./follow.py\n");
    outside::writeText(path("external.yaml"), scenario);
    const QStringList commands[] = {
        // the command is relative to the working folder
        outside::list("run external.yaml --duration 1 --allow-code -q -o external"),
        outside::list("pack external -o run.hnv --with-code -q --force")};
    for (const QStringList& words : commands) {
      const outside::Finished finished = runProgram(words, path(""));
      QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    }
    QFile::remove(path("follow.py"));
    QCOMPARE(failureOf("verify % --allow-code", {path("run.hnv")}), QString());
    QCOMPARE(unexpected(runProgram("verify %", {path("run.hnv")}), 2, "--allow-code"), QString());
    outside::writeText(path("follow.py"), follow);
    QCOMPARE(runProgram(outside::list("pack external -o run.hnv -q --force"), path("")).exitCode,
             0);
    QCOMPARE(
        unexpected(runProgram("verify % --allow-code", {path("run.hnv")}), 2, "pack --with-code"),
        QString());
    QCOMPARE(failureOf("verify % --runs 0", {path("run.hnv")}), QString());
  }
};

QTEST_GUILESS_MAIN(VerifyProgramTest)
#include "tst_VerifyProgram.moc"
