#include <cmath>

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/nodes/AgentServer.h"
#include "tests/agents/Caller.h"
#include "tests/ros2/Ros2Test.h"

/// A program on Eclipse Cyclone DDS calls and hears us: neither its DDS nor its types are ours.
class CyclonePeerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void peer_callsComputeAgents_walksByTheNumbersByHand();
};

namespace {

constexpr int kDomain = 26;

/// On the loopback alone, looking for others at the ports they take in turn.
const char kConfiguration[] = R"(<CycloneDDS><Domain><General>
<Interfaces><NetworkInterface address="127.0.0.1" multicast="false"/></Interfaces>
<AllowMulticast>false</AllowMulticast></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>20</MaxAutoParticipantIndex>
<Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>)";

}  // namespace

void CyclonePeerTest::peer_callsComputeAgents_walksByTheNumbersByHand() {
  const QString program = QStringLiteral(TEST_OUTPUT_DIR "/ros2/cyclone_peer");
  if (!QFile::exists(program)) {
    QSKIP("Cyclone DDS is not installed (Debian: cyclonedds-dev cyclonedds-tools)");
  }
  QTemporaryDir folder;
  QFile file(folder.filePath(QStringLiteral("cyclone.xml")));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(kConfiguration);
  file.close();

  bridge::ServeSettings settings;
  settings.domain = ros2test::inDomain(kDomain, bridge::Rmw::CycloneDds);
  base::Diagnostics told;
  auto server = bridge::AgentServer::create(
      agentstest::bundleOf(agentstest::oneWalker(), "hunav2"), settings,
      [&](const base::Diagnostic& said) { told.push_back(said); });
  QVERIFY(server);

  QProcess peer;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("CYCLONEDDS_URI"),
                     QStringLiteral("file://") + file.fileName());
  peer.setProcessEnvironment(environment);
  peer.start(program, {QString::number(kDomain), QStringLiteral("21")});
  QVERIFY(peer.waitForStarted());
  QElapsedTimer clock;
  clock.start();
  while (peer.state() != QProcess::NotRunning && clock.elapsed() < 50000) {
    (*server)->spin(bridge::Milliseconds(5));
    peer.waitForFinished(0);
  }
  const QByteArray said = peer.readAllStandardOutput();
  QVERIFY2(peer.exitStatus() == QProcess::NormalExit && peer.exitCode() == 0,
           said + peer.readAllStandardError());
  QVERIFY(told.empty());
  const QList<QByteArray> lines = said.split('\n');
  QVERIFY(lines.contains("answer 1 0.000000000 0.000000000 map"));
  QVERIFY(lines.contains("answer 2 0.015000000 0.300000000 map"));
  QVERIFY(!said.contains("states 1 "));                  // nothing is published in the first call
  QVERIFY(lines.contains("states 2 0.000000000"));       // the state before the step
  QVERIFY(lines.contains("states 3 0.015000000"));
  // After 1 s x is 1.203459 m and v 1.482706 m/s: from the library of HuNavSim itself.
  for (const QByteArray& line : lines) {
    if (line.startsWith("answer 21 ")) {
      const QList<QByteArray> words = line.split(' ');
      QVERIFY2(std::fabs(words[2].toDouble() - 1.203459) < 2e-6, line);
      QVERIFY2(std::fabs(words[3].toDouble() - 1.482706) < 2e-6, line);
      return;
    }
  }
  QFAIL(said);
}

QTEST_GUILESS_MAIN(CyclonePeerTest)
#include "tst_CyclonePeer.moc"
