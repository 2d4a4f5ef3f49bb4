#include <csignal>
#include <memory>

#include <QJsonArray>
#include <QtTest>

#include "tests/app/RunFiles.h"
#include "tests/bridge/LiveClient.h"
#include "tests/support/Peers.h"

using client::LiveClient;
using namespace outside;

namespace {

const char* const kSameFiles[] = {"trajectory.csv", "events.csv", "trees.csv",   "trace.json",
                                  "metrics.csv",    "steps.csv",  "metrics.json"};

/// A run that is watched; ends with the object.
struct Running {
  QProcess process;
  QByteArray said;  // on standard error, so far
  int port = 0;

  explicit Running(const QStringList& words) {
    process.setReadChannel(QProcess::StandardError);
    process.start(text(HUNAVSIM_PROGRAM), list("run") + words);
    while (port == 0 && process.waitForReadyRead(20000)) {
      read();
    }
    while (port == 0 && process.state() != QProcess::NotRunning) {
      QTest::qWait(20);
      read();
    }
  }
  ~Running() {
    process.kill();
    process.waitForFinished();
  }
  Q_DISABLE_COPY_MOVE(Running)

  void read() {
    said += process.readAllStandardError();
    const auto found = QRegularExpression(text("live view at ws://127\\.0\\.0\\.1:(\\d+) "))
                           .match(QString::fromUtf8(said));
    port = found.captured(1).toInt();
  }
  Finished finish() {
    Finished finished = finishedOf(process);
    finished.err.prepend(QString::fromUtf8(said));
    return finished;
  }
};

void speedUp(LiveClient& client) {
  client.text(R"({"op":"setParameters","id":"f","parameters":[)"
              R"({"name":"/hunavsim.real_time_factor","value":100}]})");
  QVERIFY(!client.await("parameterValues").isEmpty());
}

QStringList cafe(const QString& out, double duration) {
  return {text("corner_cafe_agents"), text("-o"), out, text("--duration"),
          QString::number(duration)};
}

}  // namespace

/// `run --foxglove` from outside.
class LiveProgramTest : public QObject, protected InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void run_watched_filesAreTheSame();
  void run_foxglovesOwnClient_readsAll_data();
  void run_foxglovesOwnClient_readsAll();
  void run_paused_ctrlCEndsIt();
  void run_portTaken_isToldAndNothingIsWritten();
  void run_wrongWords_areRefused_data();
  void run_wrongWords_areRefused();
  void run_otherAddress_isWarnedOf();
  void run_foreignPage_isRefusedAndTold();
  void run_teleop_isDrivenAndRecorded();
  void run_again_ignoresTheseWords();
  void run_watchedByNobody_isTold_data();
  void run_watchedByNobody_isTold();
  void run_forGroot2_filesAreTheSame();
  void run_forGroot2_ofNobody_isToldAndNothingIsWritten();
};

void LiveProgramTest::initTestCase() {
  QVERIFY(folder_.isValid());
}

void LiveProgramTest::run_watchedByNobody_isTold_data() {
  QTest::addColumn<QString>("address");
  QTest::addColumn<QString>("words");
  QTest::newRow("this machine") << text("127.0.0.1")
                                << text("warning: no client has connected to port ");
  QTest::newRow("all") << text("0.0.0.0")
                       << text("warning: no client has connected to ws://0.0.0.0:");
}

/// After five seconds, once for each port, with what prevents other machines from connecting.
void LiveProgramTest::run_watchedByNobody_isTold() {
  QFETCH(const QString, address);
  QFETCH(const QString, words);
  const QStringList given = list("run") + cafe(path("unwatched"), 7.0) +
                            list("--foxglove 0 --foxglove-address % --groot2 0", {address});
  const Finished run = runProgram(given);
  QCOMPARE(run.exitCode, 0);
  QVERIFY2(run.err.count(words) == 1, qPrintable(run.err));
  QCOMPARE(run.err.contains(text("or --foxglove-address)")), address == text("127.0.0.1"));
  QCOMPARE(run.err.count(text("warning: Groot2 has not connected to port ")), 1);
}

void LiveProgramTest::run_watched_filesAreTheSame() {
  const Finished alone = runProgram(list("run") + cafe(path("alone"), 8.0));
  QCOMPARE(alone.exitCode, 0);
  Running run(cafe(path("watched"), 8.0) + list("--foxglove 0"));
  QVERIFY2(run.port > 0, run.said);
  LiveClient client(run.port);
  QVERIFY(client.open());
  QVERIFY(client::pause(client, true));
  client.text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1},)"
              R"({"id":4,"channelId":4},{"id":11,"channelId":11},{"id":20,"channelId":20}]})");
  for (int i = 0; i < 5; ++i) {
    QVERIFY(call(client, 2, "{}").value(QLatin1String("success")).toBool());
  }
  QVERIFY(client::pause(client, false));
  speedUp(client);
  QCOMPARE(client.awaitClose(), 1001);
  const Finished watched = run.finish();
  QCOMPARE(watched.exitCode, 0);
  QCOMPARE(watched.out.section(QLatin1Char('\n'), 0, 20),
           alone.out.section(QLatin1Char('\n'), 0, 20));
  for (const char* name : kSameFiles) {
    const QByteArray bytes = bytesOf(path("alone") + QLatin1Char('/') + text(name));
    QVERIFY2(!bytes.isEmpty(), name);
    QVERIFY2(bytes == bytesOf(path("watched") + QLatin1Char('/') + text(name)), name);
  }
}

namespace {

void comparePeople(const QJsonArray& people, const QString& folder) {
  const std::vector<Sample> samples = readTrajectory(folder + text("/trajectory.csv"));
  QCOMPARE(static_cast<std::size_t>(people.size()), samples.back().people.size());
  for (int i = 0; i < people.size(); ++i) {
    const Body& body = samples.back().people[static_cast<std::size_t>(i)];
    const QJsonObject person = people[i].toObject();
    QCOMPARE(person.value(QLatin1String("id")).toInt(), body.id);
    QVERIFY(std::abs(person.value(QLatin1String("x")).toDouble() - body.x) < 1e-9);
    QVERIFY(std::abs(person.value(QLatin1String("y")).toDouble() - body.y) < 1e-9);
  }
}

void compareMetrics(const QJsonObject& seen, const QJsonObject& measured) {
  int compared = 0;
  for (const QString& key : seen.keys()) {
    const double seenValue = seen.value(key).toDouble();
    const QJsonValue known = measured.value(key).toObject().value(QLatin1String("value"));
    const double written = known.isBool() ? (known.toBool() ? 1.0 : 0.0) : known.toDouble(-1e300);
    QVERIFY2(std::abs(seenValue - written) <= 1e-9 * std::max(1.0, std::abs(written)),
             qPrintable(key));
    ++compared;
  }
  QVERIFY(compared > 20);
}

}  // namespace

void LiveProgramTest::run_foxglovesOwnClient_readsAll_data() {
  QTest::addColumn<QString>("protocol");
  QTest::addColumn<QString>("how");
  QTest::newRow("websocket.v1") << text("foxglove.websocket.v1") << QString();
  QTest::newRow("sdk.v1") << text("foxglove.sdk.v1") << QString();
  QTest::newRow("Node's own") << text("foxglove.websocket.v1") << text("native");
}

void LiveProgramTest::run_foxglovesOwnClient_readsAll() {
  QFETCH(const QString, protocol);
  QFETCH(const QString, how);
  const QString peers = peersFolder();
  if (!hasPeer(text("@foxglove/ws-protocol"))) {
    QSKIP("no client of Foxglove here (tests/support/Peers.h)");
  }
  const QString out = path("peer");
  Running run(cafe(out, 8.0) + list("--foxglove 0"));
  QVERIFY2(run.port > 0, run.said);
  QProcess node;
  QStringList words;
  if (!how.isEmpty()) {
    words << text("--experimental-websocket");
  }
  node.start(text("node"),
             words + QStringList{text(SOURCE_DIR "/tests/peers/live_peer.js"), peers,
                                 text("ws://127.0.0.1:%1").arg(run.port), protocol, how});
  const Finished seen = finishedOf(node);
  QCOMPARE(run.finish().exitCode, 0);
  const QJsonObject report = QJsonDocument::fromJson(seen.out.toUtf8()).object();
  const auto value = [&report](const char* key) { return report.value(QLatin1String(key)); };
  QVERIFY2(!report.isEmpty(), qPrintable(seen.err));
  QCOMPARE(value("problems").toArray(), QJsonArray());
  QCOMPARE(value("code").toInt(), 1001);
  QVERIFY(value("paused").toObject().value(QLatin1String("success")).toBool());
  QVERIFY(value("stepped").toObject().value(QLatin1String("success")).toBool());
  QVERIFY(value("times").toInt() > 3);
  const QJsonArray clocks = value("stepClocks").toArray();  // each step is 0.05 s
  QCOMPARE(clocks.size(), 4);
  for (int i = 1; i < clocks.size(); ++i) {
    QCOMPARE(clocks[i].toDouble() - clocks[i - 1].toDouble(), 5e7);
  }
  QCOMPARE(value("clocks").toArray().last().toDouble(), 8e9);
  QCOMPARE(value("all").toArray().size(), 5);
  QCOMPARE(value("set").toArray().at(0).toObject().value(QLatin1String("value")).toDouble(), 100.0);
  QCOMPARE(value("updates").toArray().at(0).toObject().value(QLatin1String("value")).toBool(true),
           false);
  QCOMPARE(value("statuses").toArray().at(0).toString(), text("/hunavsim.seed cannot be set"));
  const QJsonObject counts = value("counts").toObject();
  for (const char* topic : {"/clock", "/tf", "/tf_static", "/map", "/markers", "/human_states",
                            "/people", "/robot_states", "/odom", "/scan"}) {
    QVERIFY2(counts.value(QLatin1String(topic)).toInt() > 0, topic);
  }
  // what was seen last is what was recorded last, and measured
  comparePeople(value("people").toArray(), out);
  const QJsonObject map = value("map").toObject();
  QVERIFY(map.value(QLatin1String("cells")).toInt() > 0);
  QCOMPARE(map.value(QLatin1String("cells")).toInt(),
           map.value(QLatin1String("width")).toInt() * map.value(QLatin1String("height")).toInt());
  compareMetrics(value("metrics").toObject(), metricsOf(out));
}

void LiveProgramTest::run_paused_ctrlCEndsIt() {
  Running run(cafe(path("stopped"), 60.0) + list("--foxglove 0"));
  QVERIFY2(run.port > 0, run.said);
  LiveClient client(run.port);
  QVERIFY(client.open());
  QVERIFY(client::pause(client, true));
  ::kill(static_cast<pid_t>(run.process.processId()), SIGINT);
  QCOMPARE(client.awaitClose(), 1001);
  QCOMPARE(unexpected(run.finish(), 1, "interrupted after "), QString());
  QVERIFY(QFileInfo::exists(path("stopped/trajectory.csv")));
}

void LiveProgramTest::run_portTaken_isToldAndNothingIsWritten() {
  Running run(cafe(path("first"), 60.0) + list("--foxglove 0"));
  QVERIFY2(run.port > 0, run.said);
  const QString port = QString::number(run.port);
  const Finished second =
      runProgram(list("run") + cafe(path("second"), 1.0) + list("--foxglove %", {port}));
  QCOMPARE(second.exitCode, 2);
  QCOMPARE(second.err.section(QLatin1Char('\n'), -2, -2),
           text("error: port %1 is already in use (--foxglove 0 chooses a free port)").arg(port));
  QVERIFY(!QFileInfo::exists(path("second/manifest.json")));
}

void LiveProgramTest::run_wrongWords_areRefused_data() {
  QTest::addColumn<QStringList>("words");
  const auto row = [](const char* words) {
    QTest::newRow(words) << QString::fromLatin1(words).split(QLatin1Char(' '));
  };
  row("--foxglove 65536");
  row("--foxglove -1");
  row("--foxglove abc");
  row("--foxglove-address ::1");
  row("--foxglove-origin https://lab.example");
  row("--groot2 65536");
  row("--groot2-of Ana");
  row("--speed 0");
  row("--speed 0.05");
  row("--speed 101");
  row("--speed nan");
  row("--speed fast");
}

void LiveProgramTest::run_wrongWords_areRefused() {
  QFETCH(const QStringList, words);
  QCOMPARE(runProgram(list("run corner_cafe_agents") + words).exitCode, 64);
}

void LiveProgramTest::run_otherAddress_isWarnedOf() {
  const QStringList words =
      list("run corner_cafe_agents --duration 0.5 --speed max --foxglove 0 --foxglove-address");
  const Finished open = runProgram(words + list("0.0.0.0"));
  QCOMPARE(open.exitCode, 0);
  QVERIFY2(
      open.err.contains(text("warning: anyone who can connect to 0.0.0.0 can watch and control "
                             "this run\n")),
      qPrintable(open.err));
  const Finished nowhere = runProgram(words + list("nowhere"));
  QCOMPARE(nowhere.exitCode, 2);
  QVERIFY(nowhere.err.contains(text("error: 'nowhere' is not a numeric IP address")));
}

void LiveProgramTest::run_foreignPage_isRefusedAndTold() {
  Running run(cafe(path("page"), 60.0) +
              list("--foxglove 0 --foxglove-origin https://lab.example"));
  QVERIFY2(run.port > 0, run.said);
  LiveClient evil(run.port);
  QVERIFY(evil.request("Origin: https://evil.example\r\n").rfind("HTTP/1.1 403", 0) == 0);
  LiveClient lab(run.port);
  QVERIFY(lab.request("Origin: https://lab.example\r\n").rfind("HTTP/1.1 101", 0) == 0);
  lab.await("advertiseServices");
  speedUp(lab);
  QCOMPARE(unexpected(run.finish(), 0,
                      "warning: a connection from a page of https://evil.example was refused"),
           QString());
}

/// A robot that listens; what it was told is in inputs.csv, and the run can be made again by it.
void LiveProgramTest::run_teleop_isDrivenAndRecorded() {
  writeText(
      path("driven.yaml"),
      "hunav_loader:\n  ros__parameters:\n    agents: []\nhunavsim_desktop:\n"
      "  ros__parameters:\n    format: 1\n    map_file: none\n    duration: 20.0\n    robots:\n"
      "      - r\n    r:\n      planner: teleop\n      start:\n        x: 0.0\n        y: 0.0\n"
      "        h: 0.0\n");
  Running run({path("driven.yaml"), text("-o"), path("driven"), text("--foxglove"), text("0")});
  QVERIFY2(run.port > 0, run.said);
  LiveClient client(run.port);
  QVERIFY(client.open());
  QVERIFY(client::pause(client, true));
  client.text(R"({"op":"advertise","channels":[{"id":5,"topic":"/cmd_vel","encoding":"json",)"
              R"("schemaName":"geometry_msgs/msg/Twist"}]})");
  const std::string head = std::string("\x01\x05\0\0\0", 5);
  client.binary(head + R"({"linear":{"x":0.1}})");
  client.binary(head + R"({"linear":{"x":0.5},"angular":{"z":0.25}})");  // the newest counts
  for (int i = 0; i < 3; ++i) {
    call(client, 2, "{}");
  }
  client.binary(head + R"({"linear":{"x":"fast"}})");
  QCOMPARE(client.await("status").value(QLatin1String("message")).toString(),
           text("/cmd_vel: not a geometry_msgs/msg/Twist with finite numbers"));
  QVERIFY(client::pause(client, false));
  speedUp(client);
  QCOMPARE(run.finish().exitCode, 0);
  const QList<QByteArray> lines = bytesOf(path("driven/inputs.csv")).trimmed().split('\n');
  QCOMPARE(lines.size(), 2);
  QVERIFY2(lines[1].contains(",robot,-1,") && lines[1].contains("0.5") && lines[1].contains("0.25"),
           lines[1]);
  const Finished again =
      runProgram("run --from % -o %", {path("driven") + text("@20"), path("again")});
  QVERIFY2(again.exitCode == 0, qPrintable(again.err));
  QVERIFY(bytesOf(path("again/trajectory.csv")) == bytesOf(path("driven/trajectory.csv")));
}

/// The command line of a watched run is read again for `--from`.
void LiveProgramTest::run_again_ignoresTheseWords() {
  const QStringList words = cafe(path("before"), 2.0) + list("--foxglove 0 --speed max");
  QCOMPARE(runProgram(list("run") + words).exitCode, 0);
  const Finished again =
      runProgram("run --from % -o %", {path("before") + text("@1"), path("after")});
  QVERIFY2(again.exitCode == 0, qPrintable(again.err));
  QVERIFY(!again.err.contains(text("live view")));
  QVERIFY(bytesOf(path("before/trajectory.csv")) == bytesOf(path("after/trajectory.csv")));
}

void LiveProgramTest::run_forGroot2_filesAreTheSame() {
  const Finished alone = runProgram(list("run") + cafe(path("plain"), 3.0));
  QCOMPARE(alone.exitCode, 0);
  const Finished watched = runProgram(list("run") + cafe(path("groot"), 3.0) +
                                      list("--speed max --groot2 0 --groot2-of Greta"));
  QVERIFY2(watched.exitCode == 0, qPrintable(watched.err));
  QVERIFY(watched.err.contains(text("tree of Greta at 127.0.0.1:")));
  for (const char* name : kSameFiles) {
    const QByteArray bytes = bytesOf(path("plain") + QLatin1Char('/') + text(name));
    QVERIFY2(!bytes.isEmpty(), name);
    QVERIFY2(bytes == bytesOf(path("groot") + QLatin1Char('/') + text(name)), name);
  }
}

void LiveProgramTest::run_forGroot2_ofNobody_isToldAndNothingIsWritten() {
  QCOMPARE(unexpected(runProgram(list("run") + cafe(path("nobody"), 1.0) +
                                 list("--groot2 0 --groot2-of Grete")),
                      2,
                      "there is no person 'Grete' with a tree for Groot2 (did you mean "
                      "'Greta'?)"),
           QString());
  QVERIFY(!QFileInfo::exists(path("nobody")));
}

QTEST_GUILESS_MAIN(LiveProgramTest)
#include "tst_LiveProgram.moc"
