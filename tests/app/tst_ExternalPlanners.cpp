#include <csignal>

#include <QCryptographicHash>
#include <QJsonArray>
#include <QStandardPaths>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

const char* const kReady = "read -r line; echo '{\"ready\":true}'\n";

/// As a scalar of YAML in double quotes.
QByteArray quoted(QByteArray words) {
  return '"' + words.replace('\\', "\\\\").replace('"', "\\\"") + '"';
}

/// One person who crosses the way of a robot from (0, 0) to (3, 1). `ofRobot`: further keys of it.
QByteArray scenarioWith(const QByteArray& ofRobot, const QByteArray& more = {}) {
  return "hunav_loader:\n  ros__parameters:\n    yaml_base_name: yard\n    map: yard\n"
         "    global_goals:\n      1:\n        x: 1.500\n        y: -3.000\n"
         "    agents:\n      - anna\n    anna:\n      id: 1\n      cyclic_goals: false\n"
         "      init_pose:\n        x: 1.500\n        y: 3.000\n        h: -1.571\n"
         "      behavior:\n        type: Regular\n      goals:\n        - 1\n"
         "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n" +
         more + "    robots:\n      - robot1\n    robot1:\n" + ofRobot +
         "      start:\n        x: 0.0\n        y: 0.0\n        h: 0.0\n"
         "      goal:\n        x: 3.0\n        y: 1.0\n";
}

QByteArray externalBy(const QByteArray& command, const QByteArray& timeout = "20.0") {
  return "      planner: external\n      command: " + quoted(command) +
         "\n      planner_parameters:\n        timeout: " + timeout + "\n";
}

QString sha256Of(const QString& file) {
  return QString::fromLatin1(
      QCryptographicHash::hash(bytesOf(file), QCryptographicHash::Sha256).toHex());
}

/// Of the first robot, in the last row of the file.
QPointF lastPlaceOfRobot(const QString& folder) {
  const auto samples = readTrajectory(folder + text("/trajectory.csv"));
  return {samples.back().robot->x, samples.back().robot->y};
}

}  // namespace

/// Planners of others, by the program from outside.
class ExternalPlannersTest : public QObject, protected InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void run_examples_reachTheGoalInLockStep_data();
  void run_examples_reachTheGoalInLockStep();
  void run_commandByOptions_drives();
  void run_withoutPermission_startsNothing_data();
  void run_withoutPermission_startsNothing();
  void otherCommands_neverStartCode();
  void run_misbehaviour_endsWithItsReason_data();
  void run_misbehaviour_endsWithItsReason();
  void run_interruptedWhileItHangs_ends();
  void batch_permission_isHandedOn();
  void batch_withoutPermission_isRefused();
  void check_parameters_areChecked_data();
  void check_parameters_areChecked();
  void run_replay_drivesTheSameWay();
  void run_teleop_stands();

 private:
  /// A scenario in the test's folder.
  QString scenario(const QByteArray& content) const {
    QString file = path("yard.yaml");
    writeText(file, content);
    return file;
  }
  /// A program that writes its number into a file before it does what it does.
  QByteArray script(const QByteArray& what) const {
    QFile::remove(path("child"));
    writeText(path("planner.sh"), "echo $$ > '" + path("child").toUtf8() + "'\n" + what);
    return "/bin/sh '" + path("planner.sh").toUtf8() + "'";
  }
};

void ExternalPlannersTest::run_examples_reachTheGoalInLockStep_data() {
  QTest::addColumn<QByteArray>("ofRobot");
  QTest::addColumn<QStringList>("files");
  const QString python = QStandardPaths::findExecutable(text("python3"));
  const QString follow = text(SOURCE_DIR "/resources/planners/follow.py");
  const QString built = text(TEST_OUTPUT_DIR "/planners/");
  QTest::newRow("python") << externalBy("python3 '" + follow.toUtf8() + "'")
                          << QStringList{python, follow};
  QTest::newRow("c++") << externalBy("'" + built.toUtf8() + "follow'")
                       << QStringList{built + text("follow")};
  QTest::newRow("library") << QByteArray(
                                  "      planner: library\n      planner_parameters:\n"
                                  "        file: ") +
                                  quoted(built.toUtf8() + "library.so") + "\n"
                           << QStringList{built + text("library.so")};
}

void ExternalPlannersTest::run_examples_reachTheGoalInLockStep() {
  QFETCH(QByteArray, ofRobot);
  QFETCH(QStringList, files);
  for (const QString& file : files) {
    if (!QFile::exists(file)) {
      QSKIP("a program of this example is not on this machine");
    }
  }
  const QString yard = scenario(scenarioWith(ofRobot));
  const QString folders[] = {path("first"), path("second")};
  for (const QString& folder : folders) {
    QCOMPARE(failureOf("run % --allow-code -o %", {yard, folder}), QString());
    QVERIFY(bytesOf(folder + text("/events.csv")).contains(",arrived,-1,"));
    const QPointF end = lastPlaceOfRobot(folder);
    QVERIFY(std::hypot(end.x() - 3.0, end.y() - 1.0) < 0.2 + 0.5);  // the radius, and to brake
  }
  for (const char* file : {"/trajectory.csv", "/events.csv"}) {
    const QByteArray first = bytesOf(folders[0] + text(file));
    QVERIFY(first.size() > 100);
    QCOMPARE(bytesOf(folders[1] + text(file)), first);
  }
  const QJsonObject code = readJson(folders[0] + text("/manifest.json"))[text("code")].toObject();
  QVERIFY(code[text("allowed")].toBool());
  const QJsonObject started = code[text("started")].toArray().at(0).toObject();
  QCOMPARE(started[text("robot")].toString(), text("robot1"));
  QStringList told;
  const QJsonArray listed = started[text("files")].toArray();
  for (const auto& file : listed) {
    told << file.toObject()[text("path")].toString();
    QCOMPARE(file.toObject()[text("sha256")].toString(), sha256Of(told.back()));
  }
  QCOMPARE(told, files);
}

/// A file of HuNavSim's without a robot, and all about the robot on the command line.
void ExternalPlannersTest::run_commandByOptions_drives() {
  QByteArray plain = scenarioWith({});
  const QString file = scenario(plain.left(plain.indexOf("hunavsim_desktop")));
  QCOMPARE(failureOf("run % --map none --robot-start % --robot-goal % --planner external --set % "
                     "--allow-code -o %",
                     {file, text("0 0 0"), text("2 0"),
                      text("robot1.command=") +
                          QString::fromUtf8(
                              script(QByteArray(kReady) +
                                     "while read -r line; do echo '{\"linear\":1,\"angular\":0}'; "
                                     "done\n")),
                      path("out")}),
           QString());
  QVERIFY(bytesOf(path("out/events.csv")).contains(",arrived,-1,"));
  QVERIFY(isGone(bytesOf(path("child"))));
}

void ExternalPlannersTest::run_withoutPermission_startsNothing_data() {
  QTest::addColumn<bool>("isLibrary");
  QTest::newRow("program") << false;
  QTest::newRow("library") << true;
}

void ExternalPlannersTest::run_withoutPermission_startsNothing() {
  QFETCH(bool, isLibrary);
  const QByteArray command = "touch '" + path("was-here").toUtf8() + "'";
  const QByteArray content =
      scenarioWith(isLibrary ? QByteArray("      planner: library\n      planner_parameters:\n"
                                          "        file: ours.so\n")
                             : externalBy(command));
  const QString yard = scenario(content);
  const QByteArray key = isLibrary ? "file: ours" : "command:";
  const auto line = content.left(content.indexOf(key)).count('\n') + 1;
  const QString problem = text(
                              "robot 'robot1' runs external code (%1) with your permissions: "
                              "allow it with --allow-code")
                              .arg(QString::fromUtf8(isLibrary ? "ours.so" : command));
  const QString place =
      text("%1:%2:%3: ").arg(yard).arg(line).arg(isLibrary ? 9 : 7);  // behind the blanks

  QCOMPARE(unexpected(runProgram("run % -o %", {yard, path("none")}), 2,
                      place + text("error: ") + problem),
           QString());
  QVERIFY(!QFile::exists(path("none/manifest.json")));
  const Finished check = runProgram("check %", {yard});
  QVERIFY2(check.err.contains(place + text("warning: ") + problem), qPrintable(check.err));
  QCOMPARE(check.exitCode, isLibrary ? 2 : 0);  // there is no ours.so
  writeText(path("study.yaml"),
            "hunavsim_experiment: 1\nscenarios: ['" + yard.toUtf8() + "']\nduration: 1.0\n");
  const Finished study = runProgram("check %", {path("study.yaml")});
  QVERIFY2(study.err.contains(place + text("warning: ") + problem), qPrintable(study.err));
  QCOMPARE(study.exitCode, isLibrary ? 2 : 0);
  const Finished batch = runProgram("batch % -o %", {path("study.yaml"), path("none")});
  QVERIFY2(batch.err.contains(place + text("error: ") + problem), qPrintable(batch.err));
  QCOMPARE(batch.exitCode, 2);
  QTest::qWait(200);
  QVERIFY(!QFile::exists(path("was-here")));
}

void ExternalPlannersTest::otherCommands_neverStartCode() {
  const QString yard = scenario(scenarioWith(externalBy("'" TEST_OUTPUT_DIR "/planners/follow'")));
  const Finished run = runProgram("run % --allow-code -o %", {yard, path("run")});
  QVERIFY2(run.exitCode == 0, qPrintable(run.err));
  const QByteArray command = "touch '" + path("was-here").toUtf8() + "'";
  scenario(scenarioWith(externalBy(command)));
  const QList<QStringList> commands = {
      {text("check"), yard},
      {text("convert"), yard, text("-o"), path("converted"), text("--target"), text("native")},
      {text("trees"), yard, text("-o"), path("trees")},
      {text("evaluate"), path("run"), text("-o"), path("evaluated")},
      {text("render"), path("run"), text("-o"), path("run.png")}};
  for (const QStringList& words : commands) {
    const Finished done = runProgram(words);
    QVERIFY2(done.exitCode == 0, qPrintable(words.front() + done.err));
  }
  for (const char* name : {"evaluate", "check"}) {  // there is nothing to allow
    QCOMPARE(runProgram({text(name), yard, text("--allow-code")}).exitCode, 64);
  }
  QTest::qWait(200);
  QVERIFY(!QFile::exists(path("was-here")));
}

void ExternalPlannersTest::run_misbehaviour_endsWithItsReason_data() {
  QTest::addColumn<QByteArray>("what");
  QTest::addColumn<QString>("reason");
  const auto row = [](const char* name, const char* what, const char* reason) {
    QTest::newRow(name) << QByteArray(kReady) + what << text(reason);
  };
  row("dies", "read -r line; echo 'no more' >&2; exit 3\n", "with exit code 3");
  row("hangs", "read -r line; sleep 600\n", "did not answer within 0.5 s");
  row("floods", "yes '{\"linear\":0,\"angular\":0}'\n", "more than one line");
  row("floods one line", "read -r line; tr '\\0' 'x' < /dev/zero\n", "without a line break");
  row("talks nonsense", "read -r line; echo hello; sleep 600\n", "not a JSON object: 'hello'");
  row("gives up", "read -r line; echo '{\"error\":\"too narrow\"}'; sleep 600\n",
      "reports an error: too narrow");
}

void ExternalPlannersTest::run_misbehaviour_endsWithItsReason() {
  QFETCH(QByteArray, what);
  QFETCH(QString, reason);
  const QString yard = scenario(scenarioWith(externalBy(script(what), "0.5")));
  const QString out = path("out");
  QCOMPARE(unexpected(runProgram("run % --allow-code -o %", {yard, out}), 1, reason), QString());
  const QJsonObject manifest = readJson(out + text("/manifest.json"));
  QCOMPARE(manifest[text("status")].toString(), text("failed"));
  const QString told = manifest[text("reason")].toString();
  QVERIFY2(told.startsWith(text("robot 'robot1': ")) && told.contains(reason), qPrintable(told));
  QCOMPARE(told.count(text("robot1")), 1);
  const QList<QByteArray> events = bytesOf(out + text("/events.csv")).trimmed().split('\n');
  QVERIFY2(events.back().contains(",stop,"), events.back());
  QVERIFY2(QString::fromUtf8(events.back()).replace(text("\"\""), text("\"")).contains(told),
           events.back());
  QVERIFY(isGone(bytesOf(path("child"))));
}

/// The time that the program may take for an answer is longer than this test.
void ExternalPlannersTest::run_interruptedWhileItHangs_ends() {
  const QByteArray asked = path("asked").toUtf8();
  const QByteArray command =
      script(QByteArray(kReady) + "read -r line; touch '" + asked + "'; sleep 600\n");
  const QString yard = scenario(scenarioWith(externalBy(command, "600.0")));
  const QString out = path("interrupted");
  QProcess process;
  process.start(text(HUNAVSIM_PROGRAM), {text("run"), yard, text("--allow-code"), text("-o"), out});
  QVERIFY(process.waitForStarted());
  QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("asked")), 50000);
  QVERIFY(!isGone(bytesOf(path("child"))));
  QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
  QVERIFY(process.waitForFinished(50000));
  QCOMPARE(process.exitStatus(), QProcess::NormalExit);
  QCOMPARE(process.exitCode(), 1);
  QCOMPARE(readJson(out + text("/manifest.json"))[text("status")].toString(), text("interrupted"));
  QVERIFY(bytesOf(out + text("/events.csv")).contains(",stop,,,interrupted"));
  QVERIFY(isGone(bytesOf(path("child"))));
}

void ExternalPlannersTest::batch_permission_isHandedOn() {
  scenario(scenarioWith(externalBy("'" TEST_OUTPUT_DIR "/planners/follow'")));
  writeText(path("two.yaml"), "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 2\n");
  QCOMPARE(failureOf("batch % -o % --jobs 2 --allow-code", {path("two.yaml"), path("two")}),
           QString());
  const auto rows = readCsv(path("two/results.csv"));
  QCOMPARE(rows.size(), std::size_t{2});
  for (const auto& row : rows) {
    QCOMPARE(row.at(text("status")), text("ok"));
  }
  QVERIFY(readJson(path("two/manifest.json"))[text("code")].toObject()[text("allowed")].toBool());
}

/// Also where only one of the values starts a program.
void ExternalPlannersTest::batch_withoutPermission_isRefused() {
  const QByteArray command = "touch '" + path("was-here").toUtf8() + "'";
  scenario(scenarioWith("      planner: pursuit\n      command: " + quoted(command) + "\n"));
  writeText(path("two.yaml"),
            "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 1\nvalues:\n"
            "  robot1.planner: [pursuit, external]\n");
  QCOMPARE(unexpected(runProgram("batch % -o %", {path("two.yaml"), path("refused")}), 2,
                      "error: robot 'robot1' runs external code"),
           QString());
  QVERIFY(!QFile::exists(path("refused/results.csv")));
  QVERIFY(!QFile::exists(path("was-here")));
}

void ExternalPlannersTest::check_parameters_areChecked_data() {
  QTest::addColumn<QByteArray>("ofRobot");
  QTest::addColumn<QString>("problem");
  const auto row = [](const char* name, const QByteArray& ofRobot, const char* problem) {
    QTest::newRow(name) << ofRobot << text(problem);
  };
  const QByteArray parameters = "      planner_parameters:\n        ";
  row("no command", "      planner: external\n", "error: robot 'robot1': planner 'external' needs");
  row("no program", externalBy("no-such-program-here"),
      "error: robot 'robot1': 'no-such-program-here' cannot be started");
  row("unknown name",
      "      planner: external\n      command: \"true\"\n" + parameters + "timeut: 1.0\n",
      "did you mean 'timeout'?");
  row("no number", externalBy("true", "soon"), "'soon' is not a number");
  row("too small", externalBy("true", "0.0"), "'0.0' is not a number");
  row("no library", "      planner: library\n", "planner 'library' needs a 'file'");
  row("library gone", "      planner: library\n" + parameters + "file: gone.so\n",
      "gone.so' does not exist");
  row("no file", "      planner: replay\n", "planner 'replay' needs a 'file'");
  row("a list", "      planner: replay\n" + parameters + "file: [a, b]\n", "error: ");
  row("for another planner", "      command: \"true\"\n", "warning: robot1.command: ");
}

void ExternalPlannersTest::check_parameters_areChecked() {
  QFETCH(QByteArray, ofRobot);
  QFETCH(QString, problem);
  const Finished check = runProgram("check %", {scenario(scenarioWith(ofRobot))});
  QVERIFY2(check.err.contains(problem), qPrintable(check.err));
  QCOMPARE(check.exitCode, problem.startsWith(text("warning")) ? 0 : 2);
}

/// Robots at the same place at the same time; the file is looked for beside the scenario.
void ExternalPlannersTest::run_replay_drivesTheSameWay() {
  const QByteArray duration = "    duration: 6.0\n";
  const auto alone = [](QByteArray content) {  // nobody pushes
    return content.replace("x: 1.500", "x: 30.0");
  };
  const QString yard = scenario(alone(scenarioWith({}, duration)));
  QCOMPARE(failureOf("run % -o %", {yard, path("driven")}), QString());
  QByteArray again = scenarioWith(
      "      planner: replay\n      planner_parameters:\n        file: driven/trajectory.csv\n",
      duration);
  again.truncate(again.indexOf("      goal:\n"));  // it needs none
  QCOMPARE(failureOf("run % -o %", {scenario(alone(again)), path("replayed")}), QString());
  const auto was = readTrajectory(path("driven/trajectory.csv"));
  const auto is = readTrajectory(path("replayed/trajectory.csv"));
  QCOMPARE(is.size(), was.size());
  QVERIFY(was.back().robot->x > 2.0);
  for (std::size_t k = 0; k < was.size(); ++k) {
    const double off =
        std::hypot(is[k].robot->x - was[k].robot->x, is[k].robot->y - was[k].robot->y);
    QVERIFY2(off < 0.001, qPrintable(text("%1 m at %2 s").arg(off).arg(was[k].time)));
  }
  const QJsonArray inputs = readJson(path("replayed/manifest.json"))[text("inputs")].toArray();
  QCOMPARE(inputs.last().toObject()[text("sha256")].toString(),
           sha256Of(path("driven/trajectory.csv")));
}

void ExternalPlannersTest::run_teleop_stands() {
  const QString yard = scenario(scenarioWith("      planner: teleop\n", "    duration: 2.0\n"));
  QCOMPARE(failureOf("run % -o %", {yard, path("teleop")}), QString());
  QCOMPARE(lastPlaceOfRobot(path("teleop")), QPointF(0.0, 0.0));
}

QTEST_GUILESS_MAIN(ExternalPlannersTest)
#include "tst_ExternalPlanners.moc"
