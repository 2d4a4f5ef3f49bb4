#include <csignal>

#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

/// `serve` and `run --ros2` from outside.
class ServeProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void serve_withoutRos2_isAWrongCommandLine();
  void run_optionsOfRos2WithoutIt_areAWrongCommandLine();
  void help_ofRos2_saysWhoIsFound();
  void serve_badDomainOfTheVariable_isTold();
  void serve_brokenScenario_isTold();
  void serve_interrupted_endsCleanly();
  void serve_peerOnCyclone_isAnswered();
  void run_onRos2_keepsPaceAndIsTheSameRun();

 private:
  QString scenario() const { return folder_.filePath(text("walk.yaml")); }
  bool hasRos2Support() const { return !hasNoRos2_; }

  QTemporaryDir folder_;
  bool hasNoRos2_ = false;
};

namespace {

const char kWalk[] =
    "hunav_loader:\n  ros__parameters:\n    yaml_base_name: walk\n    map: walk\n"
    "    global_goals:\n      1:\n        x: 5.0\n        y: 0.0\n"
    "    agents:\n      - anna\n    anna:\n      id: 1\n      radius: 0.4\n      max_vel: 1.5\n"
    "      goal_radius: 0.3\n      cyclic_goals: false\n"
    "      init_pose:\n        x: 0.0\n        y: 0.0\n        h: 0.0\n"
    "      behavior:\n        type: Regular\n      goals:\n        - 1\n"
    "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
    "    duration: 1.0\n    robots:\n      - robot1\n    robot1:\n      planner: ros2\n"
    "      start:\n        x: -3.0\n        y: 2.0\n        h: 0.0\n"
    "      goal:\n        x: 3.0\n        y: 2.0\n";

QProcessEnvironment with(const QString& name, const QString& value) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(name, value);
  return environment;
}

}  // namespace

void ServeProgramTest::serve_withoutRos2_isAWrongCommandLine() {
  writeText(scenario(), kWalk);
  const Finished finished = runProgram("serve %", {scenario()});
  QCOMPARE(finished.exitCode, 64);
  QVERIFY(finished.err.contains(text("--ros2")));
  QCOMPARE(runProgram("serve % --ros2 --domain 233", {scenario()}).exitCode, 64);
  QCOMPARE(runProgram("serve % --ros2 --namespace lab", {scenario()}).exitCode, 64);
}

/// They would do nothing.
void ServeProgramTest::run_optionsOfRos2WithoutIt_areAWrongCommandLine() {
  writeText(scenario(), kWalk);
  for (const char* options : {"--domain 5", "--rmw fastrtps", "--ros-distro jazzy", "--network",
                              "--lockstep", "--stamped"}) {
    QCOMPARE(
        unexpected(runProgram(list("run %", {scenario()}) + text(options).split(QLatin1Char(' '))),
                   64, "--ros2"),
        QString());
  }
}

/// Without it a client on another interface or in another domain receives nothing, without an
/// explanation.
void ServeProgramTest::help_ofRos2_saysWhoIsFound() {
  for (const char* command : {"run", "serve", "evaluate"}) {
    const QString help = runProgram("% --help", {text(command)}).out.simplified();
    QVERIFY2(help.contains(text("loopback interface only, unless --network is given, and in one "
                                "domain only (--domain or ROS_DOMAIN_ID)")),
             qPrintable(help));
  }
}

void ServeProgramTest::serve_badDomainOfTheVariable_isTold() {
  QProcess process;
  process.setProcessEnvironment(with(text("ROS_DOMAIN_ID"), text("many")));
  process.start(text(HUNAVSIM_PROGRAM), {text("serve"), scenario(), text("--ros2")});
  const Finished finished = finishedOf(process);
  QCOMPARE(finished.exitCode, 2);
  hasNoRos2_ = finished.err.contains(text("has no ROS 2 support"));
  QVERIFY(hasNoRos2_ || finished.err.contains(text("ROS_DOMAIN_ID is 'many'")));
}

void ServeProgramTest::serve_brokenScenario_isTold() {
  if (!hasRos2Support()) {
    QSKIP("this build has no ROS 2 support");
  }
  const QString broken = folder_.filePath(text("broken.yaml"));
  QByteArray words = kWalk;
  writeText(broken, words.replace("goals:\n        - 1", "goals:\n        - 9"));
  QCOMPARE(unexpected(runProgram("serve % --ros2 --domain 27", {broken}), 2, "goal 9"), QString());
}

void ServeProgramTest::serve_interrupted_endsCleanly() {
  if (!hasRos2Support()) {
    QSKIP("this build has no ROS 2 support");
  }
  QProcess process;
  process.start(text(HUNAVSIM_PROGRAM),
                {text("serve"), scenario(), text("--ros2"), text("--domain"), text("27")});
  QVERIFY(process.waitForReadyRead(30000));
  QVERIFY(process.readAllStandardOutput().contains("in domain 27 on this machine"));
  ::kill(static_cast<pid_t>(process.processId()), SIGINT);
  const Finished finished = finishedOf(process);
  QCOMPARE(finished.exitCode, 0);
  QVERIFY(finished.out.contains(text("0 requests answered")));
  QCOMPARE(finished.err, QString());
}

void ServeProgramTest::serve_peerOnCyclone_isAnswered() {
  const QString peer = text(TEST_OUTPUT_DIR "/ros2/cyclone_compute");
  if (!hasRos2Support() || !QFile::exists(peer)) {
    QSKIP("this build has no ROS 2 support, or Cyclone DDS is not installed");
  }
  QProcess server;
  server.start(text(HUNAVSIM_PROGRAM),
               {text("serve"), scenario(), text("--ros2"), text("--domain"), text("28"),
                text("--rmw"), text("cyclonedds"), text("--compat"), text("hunav2")});
  QVERIFY(server.waitForReadyRead(30000));
  const QString configuration = folder_.filePath(text("cyclone.xml"));
  writeText(configuration,
            "<CycloneDDS><Domain><General><Interfaces><NetworkInterface address=\"127.0.0.1\" "
            "multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General>"
            "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
            "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>");
  QProcess client;
  client.setProcessEnvironment(with(text("CYCLONEDDS_URI"), text("file://") + configuration));
  client.start(peer, {text("28"), text("5")});
  const Finished called = finishedOf(client);
  ::kill(static_cast<pid_t>(server.processId()), SIGTERM);
  const Finished served = finishedOf(server);
  QVERIFY2(called.exitCode == 0, qPrintable(called.out + called.err + served.err));
  QVERIFY2(called.out.contains(text("answer 2 0.015000000 0.300000000 map")),
           qPrintable(called.out));
  QCOMPARE(served.exitCode, 0);
  QVERIFY(served.out.contains(text("5 requests answered")));
}

/// Whoever listens, the run and its bytes are those of the run alone.
void ServeProgramTest::run_onRos2_keepsPaceAndIsTheSameRun() {
  if (!hasRos2Support()) {
    QSKIP("this build has no ROS 2 support");
  }
  const QString alone = folder_.filePath(text("alone"));
  const QString told = folder_.filePath(text("told"));
  QCOMPARE(runProgram("run % -q -o %", {scenario(), alone}).exitCode, 0);
  QElapsedTimer clock;
  clock.start();
  QCOMPARE(failureOf("run % -q -o % --ros2 --domain 29", {scenario(), told}), QString());
  QVERIFY(clock.elapsed() > 900);  // one second, in real time
  QCOMPARE(bytesOf(told + text("/trajectory.csv")), bytesOf(alone + text("/trajectory.csv")));
}

QTEST_GUILESS_MAIN(ServeProgramTest)
#include "tst_ServeProgram.moc"
