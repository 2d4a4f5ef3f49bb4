#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>

#include <QJsonArray>
#include <QProcess>
#include <QtTest>

#include "app/bridge/live/FoxglovePublisher.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/run/Bundle.h"
#include "tests/bridge/LiveClient.h"
#include "tests/support/Peers.h"
#include "tests/support/TraceHash.h"

using client::LiveClient;

namespace {

const char* const kCafe = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";
constexpr std::int64_t kSteps = 160;  // 8 s

/// The café with its robot, in a thread of its own once it is started.
class Scene {
 public:
  Scene() {
    app::RunSpec options;
    options.scenario = kCafe;
    const base::Result<app::RunSettings> settings = app::runSettingsOf(options);
    bundle_ = app::readBundle(options, *settings, {});
    verdict_ = app::check(bundle_);
    session_.enableHistory(1);
  }
  ~Scene() {
    session_.stop();
    finish();
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  bool isThere() const { return verdict_.world != nullptr; }
  /// Returns the port; 0: it could not be opened.
  int watch(double speed) {
    live::FoxglovePublisherSettings settings;
    session_.setSpeed(speed);
    settings.wantsStop = [this] { return wantsStop_.load(); };
    auto opened = live::FoxglovePublisher::open(settings, session_, *verdict_.world,
                                                *bundle_.scenario, "cafe", verdict_.metrics);
    if (!opened) {
      return 0;
    }
    live_ = *std::move(opened);
    return live_->port();
  }
  void start() {
    thread_ = std::thread([this] {
      result_ = session_.run(*verdict_.world, nullptr, [this](const sim2d::Frame& frame) {
        if (live_) {
          live_->show(frame);
        }
      });
      if (live_) {
        live_->finish(verdict_.world->frame(), result_.reason);
      }
    });
  }
  void interrupt() { wantsStop_ = true; }
  const sim2d::RunResult& finish() {
    if (thread_.joinable()) {
      thread_.join();
    }
    return result_;
  }
  std::uint64_t hash() const {
    return sim2d::hashOf(session_.history()->trace(verdict_.world->header()));
  }
  const sim2d::World& world() const { return *verdict_.world; }
  const sim2d::Scenario& scenario() const { return *bundle_.scenario; }

 private:
  app::Bundle bundle_;
  app::Verdict verdict_;
  app::Session session_{{kSteps, false}};
  std::atomic<bool> wantsStop_{false};
  sim2d::RunResult result_;
  std::unique_ptr<live::FoxglovePublisher> live_;
  std::thread thread_;
};

void speedUp(LiveClient& client) {
  client.text(R"({"op":"setParameters","id":"f","parameters":[)"
              R"({"name":"/hunavsim.real_time_factor","value":100}]})");
}

}  // namespace

/// A run watched by clients.
class LiveRunTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Paused, stepped and hurried on, all of it asked for.
  void run_watched_isTheSame() {
    Scene alone;
    QVERIFY(alone.isThere());
    alone.start();
    alone.finish();
    Scene scene;
    const int port = scene.watch(1.0);
    QVERIFY(port > 0);
    LiveClient client(port);
    QVERIFY(client.open());
    QVERIFY(client::pause(client, true));
    scene.start();
    QString wanted;
    for (int channel = 1; channel <= 60; ++channel) {  // those that are not there are complained of
      wanted += QStringLiteral("%1{\"id\":%2,\"channelId\":%2}")
                    .arg(channel > 1 ? QStringLiteral(",") : QString())
                    .arg(channel);
    }
    client.text(
        QStringLiteral("{\"op\":\"subscribe\",\"subscriptions\":[%1]}").arg(wanted).toStdString());
    for (int i = 0; i < 5; ++i) {
      QVERIFY(call(client, 2, "{}").value(QLatin1String("success")).toBool());
    }
    QVERIFY(client::pause(client, false));
    speedUp(client);
    QCOMPARE(client.awaitClose(), 1001);
    QCOMPARE(scene.finish().reason, std::string("duration"));
    QCOMPARE(scene.finish().steps, kSteps);
    QCOMPARE(scene.hash(), alone.hash());
  }

  void run_asFastAsItGoes_endsBeforeItsClients() {
    Scene scene;
    const int port = scene.watch(std::numeric_limits<double>::infinity());
    LiveClient idle(port);  // says nothing
    LiveClient client(port);
    QVERIFY(client.open());
    scene.start();
    QCOMPARE(scene.finish().steps, kSteps);
    QCOMPARE(client.awaitClose(), 1001);
    QVERIFY(idle.awaitEnd());
  }

  void run_pausedThenInterrupted_ends() {
    Scene scene;
    LiveClient client(scene.watch(1.0));
    QVERIFY(client.open());
    QVERIFY(client::pause(client, true));
    scene.start();
    scene.interrupt();
    QVERIFY(scene.finish().status == sim2d::RunStatus::Interrupted);
  }

  void run_pausedThenJoined_showsTheLastState_data() {
    QTest::addColumn<double>("speed");
    QTest::newRow("real time") << 1.0;
    QTest::newRow("faster than screens") << 20.0;
  }

  /// One client pauses the run, then another one connects: it receives every topic of the state in
  /// which the run waits, immediately and without a step.
  void run_pausedThenJoined_showsTheLastState() {
    QFETCH(const double, speed);
    Scene scene;
    const int port = scene.watch(speed);
    LiveClient first(port);
    QVERIFY(first.open());
    scene.start();
    QTRY_VERIFY(!first.awaitBinary(2).empty());  // the clock of some states
    QTest::qWait(static_cast<int>(1000.0 / speed));
    QVERIFY(client::pause(first, true));
    LiveClient late(port);
    QVERIFY(late.open());
    std::map<std::string, int> channels;
    QString wanted;
    for (const QJsonValue& each :
         late.await("advertise").value(QLatin1String("channels")).toArray()) {
      const int id = each.toObject().value(QLatin1String("id")).toInt();
      channels[each.toObject().value(QLatin1String("topic")).toString().toStdString()] = id;
      wanted += QStringLiteral("%1{\"id\":%2,\"channelId\":%2}")
                    .arg(wanted.isEmpty() ? QString() : QStringLiteral(","))
                    .arg(id);
    }
    QElapsedTimer timer;
    timer.start();
    late.text(
        QStringLiteral("{\"op\":\"subscribe\",\"subscriptions\":[%1]}").arg(wanted).toStdString());
    std::set<std::string> missing = {"/clock",
                                     "/tf",
                                     "/tf_static",
                                     "/map",
                                     "/obstacles",
                                     "/markers",
                                     "/scan",
                                     "/human_states",
                                     "/people",
                                     "/robot_states",
                                     "/odom",
                                     "/goal_pose",
                                     "/hunavsim/metrics/path_length"};
    std::map<int, std::string> messages;
    while (!missing.empty()) {
      const std::string message = late.awaitBinary(1);
      QVERIFY2(!message.empty(), ("no message of " + *missing.begin()).c_str());
      const int channel = static_cast<std::uint8_t>(message.at(1));
      QVERIFY(messages.emplace(channel, message.substr(13)).second);  // each once
      for (const auto& [topic, id] : channels) {
        if (id == channel) {
          missing.erase(topic);
        }
      }
    }
    QVERIFY2(timer.elapsed() < 1000, QByteArray::number(timer.elapsed()));
    // It waits in a state, which is the one that was shown.
    const sim2d::Frame& frame = scene.world().frame();
    QVERIFY(frame.step > 0 && frame.step < kSteps);
    using bridge::hunav_msgs::Agents;
    const auto people = bridge::decode<Agents>(messages.at(channels.at("/human_states")));
    QVERIFY(static_cast<bool>(people));
    const double stamp = people->header.stamp.sec + 1e-9 * people->header.stamp.nanosec;
    QVERIFY(std::fabs(stamp - frame.time) < 1e-6);
    QCOMPARE(people->agents.size(), frame.humans.size());
    for (std::size_t k = 0; k < people->agents.size(); ++k) {
      QCOMPARE(people->agents[k].position.position.x, frame.humans.x[k]);
      QCOMPARE(people->agents[k].position.position.y, frame.humans.y[k]);
    }
  }

  void run_foxglovesOwnClient_readsAll_data() {
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<QString>("how");
    QTest::newRow("websocket.v1") << QStringLiteral("foxglove.websocket.v1") << QString();
    QTest::newRow("sdk.v1") << QStringLiteral("foxglove.sdk.v1") << QString();
    QTest::newRow("Node's own") << QStringLiteral("foxglove.websocket.v1")
                                << QStringLiteral("native");
  }

  void run_foxglovesOwnClient_readsAll() {
    QFETCH(const QString, protocol);
    QFETCH(const QString, how);
    const QString peers = peersFolder();
    if (!hasPeer(QStringLiteral("@foxglove/ws-protocol"))) {
      QSKIP("no client of Foxglove here (tests/support/Peers.h)");
    }
    Scene scene;
    const int port = scene.watch(1.0);
    QStringList words{QStringLiteral(SOURCE_DIR "/tests/peers/live_peer.js"), peers,
                      QStringLiteral("ws://127.0.0.1:%1").arg(port), protocol, how};
    if (!how.isEmpty()) {
      words.prepend(QStringLiteral("--experimental-websocket"));
    }
    scene.start();
    QProcess node;
    node.start(QStringLiteral("node"), words);
    QVERIFY(node.waitForFinished(55000));
    const QByteArray said = node.readAllStandardOutput();
    const QJsonObject report = QJsonDocument::fromJson(said).object();
    const auto value = [&report](const char* key) { return report.value(QLatin1String(key)); };
    QVERIFY2(!report.isEmpty(), node.readAllStandardError());
    QCOMPARE(value("problems").toArray(), QJsonArray());
    QCOMPARE(value("code").toInt(), 1001);
    QCOMPARE(value("reason").toString(), QStringLiteral("duration"));
    QVERIFY(value("paused").toObject().value(QLatin1String("success")).toBool());
    QVERIFY(value("stepped").toObject().value(QLatin1String("success")).toBool());
    QVERIFY(value("times").toInt() > 3);
    const QJsonArray clocks = value("stepClocks").toArray();  // [ns], each step is 0.05 s
    QCOMPARE(clocks.size(), 4);
    for (int i = 1; i < clocks.size(); ++i) {
      QCOMPARE(clocks[i].toDouble() - clocks[i - 1].toDouble(), 5e7);
    }
    QCOMPARE(value("clocks").toArray().last().toDouble(), 8e9);
    QCOMPARE(value("all").toArray().size(), 5);
    QCOMPARE(value("set").toArray().at(0).toObject().value(QLatin1String("value")).toDouble(),
             100.0);
    QCOMPARE(value("updates").toArray().at(0).toObject().value(QLatin1String("value")).toBool(true),
             false);
    QCOMPARE(value("statuses").toArray().at(0).toString(),
             QStringLiteral("/hunavsim.seed cannot be set"));
    for (const char* topic :
         {"/clock", "/tf", "/tf_static", "/map", "/markers", "/human_states", "/people",
          "/robot_states", "/odom", "/scan", "/plan", "/hunavsim/metrics/path_length"}) {
      QVERIFY2(value("counts").toObject().value(QLatin1String(topic)).toInt() > 0, topic);
    }
    scene.finish();
    // what was seen last is what was there last
    const sim2d::HumanColumns& humans = scene.world().frame().humans;
    const QJsonArray people = value("people").toArray();
    QCOMPARE(static_cast<std::size_t>(people.size()), humans.size());
    for (std::size_t i = 0; i < humans.size(); ++i) {
      const QJsonObject person = people[static_cast<int>(i)].toObject();
      QCOMPARE(person.value(QLatin1String("id")).toInt(), humans.id[i]);
      QCOMPARE(person.value(QLatin1String("x")).toDouble(), humans.x[i]);
      QCOMPARE(person.value(QLatin1String("y")).toDouble(), humans.y[i]);
      QCOMPARE(static_cast<float>(person.value(QLatin1String("yaw")).toDouble()),
               static_cast<float>(humans.heading[i]));
    }
    const QJsonObject map = value("map").toObject();
    QCOMPARE(
        map.value(QLatin1String("cells")).toInt(),
        map.value(QLatin1String("width")).toInt() * map.value(QLatin1String("height")).toInt());
    QVERIFY(map.value(QLatin1String("cells")).toInt() > 1000);
    // nobody but the robot drives, so its way is at least the straight line and at most 1 m/s * 8 s
    const double way =
        value("metrics").toObject().value(QLatin1String("path_length")).toDouble(-1.0);
    QVERIFY2(way > 1.0 && way <= 8.0, qPrintable(QString::number(way)));
  }
};

QTEST_GUILESS_MAIN(LiveRunTest)
#include "tst_FoxglovePublisher.moc"
