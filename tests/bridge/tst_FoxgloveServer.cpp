#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <QJsonArray>
#include <QtTest>

#include "app/bridge/live/FoxgloveServer.h"
#include "tests/bridge/LiveClient.h"
#include "tests/support/Mutator.h"

using client::bytesOf;
using client::LiveClient;
using live::FoxgloveServer;

namespace {

live::SharedBytes shared(const std::string& bytes) {
  return std::make_shared<const std::string>(bytes);
}

/// A server with two channels, the second latched, a service that turns bytes around, an inlet and
/// three parameters.
struct Scene {
  live::FoxgloveSettings settings;
  std::unique_ptr<FoxgloveServer> server;
  std::atomic<double> factor{1.0};
  std::atomic<bool> isPaused{false};
  std::atomic<int> taken{0};

  explicit Scene(std::size_t mostClients = 8) {
    settings.session = "s1";
    settings.server.mostClients = mostClients;
    settings.server.handshakeTime = std::chrono::milliseconds(300);
    addService();
    settings.clientTopics.push_back({"/cmd_vel", "geometry_msgs/msg/Twist",
                                     [this](std::string_view encoding, std::string_view payload) {
                                       ++taken;
                                       return payload == "bad"
                                                  ? std::string("is bad ") + std::string(encoding)
                                                  : std::string();
                                     }});
    settings.parameters.push_back({"factor", [this] { return live::ParameterValue(factor.load()); },
                                   [this](const live::ParameterValue& value) {
                                     const double* const number = std::get_if<double>(&value);
                                     factor = number != nullptr ? *number : factor.load();
                                     return std::string(number != nullptr ? "" : "is no number");
                                   }});
    settings.parameters.push_back(
        {"paused", [this] { return live::ParameterValue(isPaused.load()); }, nullptr});
    settings.parameters.push_back(
        {"seed", [] { return live::ParameterValue(std::int64_t{7}); }, nullptr});
  }
  void addService() {
    live::Service turn;
    turn.name = "/turn";
    turn.type = "std_srvs/srv/Trigger";
    turn.request = {"std_srvs/srv/Trigger_Request", "uint8 dummy"};
    turn.response = {"std_srvs/srv/Trigger_Response", "bool success\nstring message"};
    turn.call = [](std::string_view encoding, std::string_view payload) {
      if (payload == "fail") {
        return live::ServiceAnswer{false, "it was told to"};
      }
      return live::ServiceAnswer{
          true, std::string(encoding) + std::string(payload.rbegin(), payload.rend())};
    };
    settings.services.push_back(turn);
  }
  bool listen() {
    auto listening = FoxgloveServer::listen(
        settings, {{"/clock", {"rosgraph_msgs/msg/Clock", "builtin_interfaces/Time clock"}, false},
                   {"/map", {"nav_msgs/msg/OccupancyGrid", "x"}, true}});
    if (listening) {
      server = *std::move(listening);
      server->start();
    }
    return static_cast<bool>(server);
  }
  int port() const { return server->port(); }
  void publish(std::uint64_t time, live::ChannelId channel, const std::string& payload) const {
    server->publish(time, {{channel, shared(payload)}});
  }
};

/// A scene with a client.
struct Connected : Scene {
  std::unique_ptr<LiveClient> client;

  Connected() {
    if (!listen() || !(client = std::make_unique<LiveClient>(port()))->open()) {
      qFatal("no connection");
    }
  }
};

/// Little endian.
std::string number(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) {
    text += static_cast<char>(value >> (8 * i) & 255);
  }
  return text;
}

/// Whoever asks for parameters has been heard before.
QJsonObject parameters(LiveClient& client, const char* names = "") {
  client.text("{\"op\":\"getParameters\",\"parameterNames\":[" + std::string(names) +
              "],\"id\":\"q\"}");
  return client.await("parameterValues");
}

QString valuesOf(const QJsonObject& message) {
  return QString::fromUtf8(QJsonDocument(message.value(QLatin1String("parameters")).toArray())
                               .toJson(QJsonDocument::Compact));
}

}  // namespace

class FoxgloveServerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void connect_serverTellsWhatItHas() {
    Scene scene;
    QVERIFY(scene.listen());
    LiveClient client(scene.port());
    QVERIFY(client.request({}, "chat, foxglove.sdk.v1")
                .find("Sec-WebSocket-Protocol: foxglove.sdk.v1") != std::string::npos);
    const QByteArray info = QByteArray::fromStdString(client.next().payload);
    QCOMPARE(info, QByteArray(R"({"op":"serverInfo","name":"hunavsim","capabilities":["time",)"
                              R"("clientPublish","services","parameters","parametersSubscribe"],)"
                              R"("supportedEncodings":["cdr","json"],"metadata":{},)"
                              R"("sessionId":"s1"})"));
    const QByteArray channels = QByteArray::fromStdString(client.next().payload);
    QVERIFY(channels.startsWith(
        R"({"op":"advertise","channels":[{"id":1,"topic":"/clock","encoding":"cdr",)"
        R"("schemaName":"rosgraph_msgs/msg/Clock","schemaEncoding":"ros2msg",)"
        R"("schema":"builtin_interfaces/Time clock"},{"id":2,)"));
    const QJsonObject services = client.await("advertiseServices");
    const QJsonObject turn = services.value(QLatin1String("services")).toArray().at(0).toObject();
    QCOMPARE(turn.value(QLatin1String("name")).toString(), QStringLiteral("/turn"));
    QCOMPARE(turn.value(QLatin1String("request"))
                 .toObject()
                 .value(QLatin1String("schemaName"))
                 .toString(),
             QStringLiteral("std_srvs/srv/Trigger_Request"));
  }

  void connect_foreignProtocolAndPage_areRefused() {
    Scene scene;
    QString page;
    scene.settings.refused = [&](const std::string& origin) {
      page = QString::fromStdString(origin);
    };
    QVERIFY(scene.listen());
    LiveClient other(scene.port());
    QVERIFY(other.request({}, "chat").rfind("HTTP/1.1 400", 0) == 0);
    QVERIFY(other.awaitEnd());
    LiveClient evil(scene.port());
    QVERIFY(evil.request("Origin: https://evil.example\r\n").rfind("HTTP/1.1 403", 0) == 0);
    QVERIFY(evil.awaitEnd());
    scene.server->stop("");
    QCOMPARE(page, QStringLiteral("https://evil.example"));
  }

  void connect_oneTooMany_isRefused() {
    Scene scene(2);
    QVERIFY(scene.listen());
    LiveClient one(scene.port());
    QVERIFY(one.open());
    auto two = std::make_unique<LiveClient>(scene.port());
    QVERIFY(two->open());
    LiveClient three(scene.port());
    QVERIFY(three.request().rfind("HTTP/1.1 503", 0) == 0);
    two.reset();
    QTRY_COMPARE(scene.server->clientCount(), std::size_t{1});
    LiveClient four(scene.port());
    QVERIFY(four.open());
  }

  void connect_halfOpen_ends() {
    Scene scene;
    QVERIFY(scene.listen());
    LiveClient client(scene.port());
    client.write("GET / HTTP/1.1\r\n");
    QVERIFY(client.awaitEnd());
  }

  void connect_besideManyHalfOpen_opensAtOnce_data() {
    QTest::addColumn<QByteArray>("said");
    QTest::addColumn<int>("count");
    for (const int count : {100, 500}) {
      QTest::addRow("%d say nothing", count) << QByteArray() << count;
      QTest::addRow("%d half requests", count)
          << QByteArray("GET / HTTP/1.1\r\nHost: x\r\n") << count;
      QTest::addRow("%d refused", count) << QByteArray("GET / HTTP/1.1\r\n\r\n") << count;
    }
  }

  /// A client with a complete request is served within a second and stays connected.
  void connect_besideManyHalfOpen_opensAtOnce() {
    QFETCH(const QByteArray, said);
    QFETCH(const int, count);
    Scene scene;
    scene.settings.server.handshakeTime = std::chrono::seconds(60);
    QVERIFY(scene.listen());
    LiveClient before(scene.port());
    QVERIFY(before.open());
    std::vector<std::unique_ptr<LiveClient>> others;
    for (int k = 0; k < count; ++k) {
      others.push_back(std::make_unique<LiveClient>(scene.port()));
      others.back()->write(said.toStdString());
    }
    QElapsedTimer timer;
    timer.start();
    LiveClient client(scene.port());
    QVERIFY(client.open());
    QVERIFY2(timer.elapsed() < 1000, QByteArray::number(timer.elapsed()));
    for (int k = 0; k < 200; ++k) {  // and after it
      others.push_back(std::make_unique<LiveClient>(scene.port()));
    }
    QVERIFY(!parameters(client).isEmpty());
    QVERIFY(!parameters(before).isEmpty());
    QCOMPARE(scene.server->clientCount(), std::size_t{2});
  }

  void listen_takenPort_isAnError() {
    Scene scene;
    QVERIFY(scene.listen());
    live::FoxgloveSettings settings;
    settings.server.port = scene.server->port();
    const auto second = FoxgloveServer::listen(settings, {});
    QVERIFY(!second);
    QCOMPARE(second.diagnostics().front().code, std::string_view("live.port-taken"));
  }

  void listen_noAddress_isAnError() {
    live::FoxgloveSettings settings;
    settings.server.address = "localhost.evil";
    QCOMPARE(FoxgloveServer::listen(settings, {}).diagnostics().front().code,
             std::string_view("live.no-address"));
    settings.server.address = "192.0.2.1";  // of nobody (RFC 5737)
    QCOMPARE(FoxgloveServer::listen(settings, {}).diagnostics().front().code,
             std::string_view("live.no-port"));
  }

  void subscribe_messagesCome() {
    Connected scene;
    LiveClient& client = *scene.client;
    QVERIFY(!scene.server->isWanted(1));
    client.text(R"({"op":"subscribe","subscriptions":[{"id":4000000000,"channelId":1}]})");
    parameters(client);
    QVERIFY(scene.server->isWanted(1));
    scene.publish(1500000000, 1, "abc");
    QCOMPARE(client.awaitBinary(2), "\x02" + number(1500000000, 8));
    QCOMPARE(client.awaitBinary(1), "\x01" + number(4000000000, 4) + number(1500000000, 8) + "abc");
  }

  void subscribe_latched_comesAtOnce() {
    Scene scene;
    QVERIFY(scene.listen());
    scene.publish(5, 2, "old");
    scene.publish(6, 2, "the map");
    LiveClient client(scene.port());
    QVERIFY(client.open());
    client.text(R"({"op":"subscribe","subscriptions":[{"id":3,"channelId":2}]})");
    QCOMPARE(client.awaitBinary(1), "\x01" + number(3, 4) + number(6, 8) + "the map");
  }

  /// For a channel that is not latched: a subscription that has received a message gets no extra
  /// one.
  void subscribe_messageMadeForIt_comesToNobodyElse() {
    Scene scene;
    std::atomic<int> calls{0};
    scene.settings.subscribed = [&calls] { ++calls; };
    QVERIFY(scene.listen());
    LiveClient first(scene.port()), second(scene.port());
    QVERIFY(first.open() && second.open());
    first.text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
    QTRY_COMPARE(calls.load(), 1);
    QVERIFY(scene.server->isMessageAwaited(1));
    scene.publish(7, 1, "one");
    QCOMPARE(first.awaitBinary(1), "\x01" + number(1, 4) + number(7, 8) + "one");
    QVERIFY(!scene.server->isMessageAwaited(1));
    second.text(R"({"op":"subscribe","subscriptions":[{"id":9,"channelId":1}]})");
    QTRY_COMPARE(calls.load(), 2);
    QVERIFY(scene.server->isMessageAwaited(1));
    scene.server->publish(7, {{1, shared("again")}}, FoxgloveServer::Recipients::Awaiting);
    QCOMPARE(second.awaitBinary(1), "\x01" + number(9, 4) + number(7, 8) + "again");
    QVERIFY(!scene.server->isMessageAwaited(1));
    scene.publish(8, 1, "two");
    QCOMPARE(first.awaitBinary(1), "\x01" + number(1, 4) + number(8, 8) + "two");
    QCOMPARE(second.awaitBinary(1), "\x01" + number(9, 4) + number(8, 8) + "two");
    first.text(R"({"op":"unsubscribe","subscriptionIds":[1]})");
    first.text(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":1}]})");
    QTRY_COMPARE(calls.load(), 3);
    QVERIFY(scene.server->isMessageAwaited(1));
    first.write(client::frame(0x88, ""));
    QTRY_VERIFY(!scene.server->isMessageAwaited(1));
  }

  void subscribe_wrongOnes_areTold() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1},)"
                R"({"id":1,"channelId":2},{"id":2,"channelId":1},{"id":3,"channelId":99}]})");
    const QJsonObject status = client.await("status");
    QCOMPARE(status.value(QLatin1String("level")).toInt(), 2);
    QCOMPARE(status.value(QLatin1String("message")).toString(),
             QStringLiteral("subscription 1 already exists; channel 1 is already subscribed; "
                            "there is no channel 99"));
  }

  void unsubscribe_nothingComes() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
    client.text(R"({"op":"unsubscribe","subscriptionIds":[1,77]})");
    parameters(client);
    QVERIFY(!scene.server->isWanted(1));
    scene.publish(1, 1, "abc");
    client.binary("\x02" + number(1, 4) + number(1, 4) + number(3, 4) + "cdr");
    for (;;) {
      const client::Frame frame = client.next();
      QVERIFY(frame.first == 0x82);
      QVERIFY(frame.payload[0] != 1);
      if (frame.payload[0] == 3) {
        break;
      }
    }
  }

  void twoClients_haveTheirOwnNumbers() {
    Scene scene;
    QVERIFY(scene.listen());
    LiveClient one(scene.port());
    LiveClient two(scene.port());
    QVERIFY(one.open() && two.open());
    one.text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
    two.text(R"({"op":"subscribe","subscriptions":[{"id":9,"channelId":1}]})");
    parameters(one);
    parameters(two);
    scene.publish(1, 1, "x");
    QCOMPARE(one.awaitBinary(1), "\x01" + number(1, 4) + number(1, 8) + "x");
    QCOMPARE(two.awaitBinary(1), "\x01" + number(9, 4) + number(1, 8) + "x");
    two.write(client::frame(0x88, ""));
    QCOMPARE(two.awaitClose(), 1000);
    QTRY_COMPARE(scene.server->clientCount(), std::size_t{1});
    QVERIFY(scene.server->isWanted(1));
  }

  void service_call_isAnswered() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.binary("\x02" + number(1, 4) + number(77, 4) + number(3, 4) + "cdr" + "abc");
    QCOMPARE(client.awaitBinary(3),
             "\x03" + number(1, 4) + number(77, 4) + number(3, 4) + "cdr" + "cdrcba");
  }

  void service_failures_areTold() {
    Connected scene;
    LiveClient& client = *scene.client;
    const auto why = [&](int service, const std::string& encoding, const std::string& payload) {
      client.binary("\x02" + number(static_cast<std::uint64_t>(service), 4) + number(5, 4) +
                    number(encoding.size(), 4) + encoding + payload);
      const QJsonObject failure = client.await("serviceCallFailure");
      return failure.value(QLatin1String("serviceId")).toInt() == service &&
                     failure.value(QLatin1String("callId")).toInt() == 5
                 ? failure.value(QLatin1String("message")).toString()
                 : QString();
    };
    QCOMPARE(why(1, "cdr", "fail"), QStringLiteral("it was told to"));
    QCOMPARE(why(2, "cdr", ""), QStringLiteral("there is no service 2"));
    QCOMPARE(why(0, "cdr", ""), QStringLiteral("there is no service 0"));
    QCOMPARE(why(1, "protobuf", ""), QStringLiteral("services support the encodings cdr and json"));
  }

  void publish_toAnInlet_isTaken() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.text(R"({"op":"advertise","channels":[{"id":12,"topic":"/cmd_vel","encoding":"json",)"
                R"("schemaName":"geometry_msgs/msg/Twist"}]})");
    client.binary("\x01" + number(12, 4) + "good");
    client.binary("\x01" + number(12, 4) + "bad");
    QCOMPARE(client.await("status").value(QLatin1String("message")).toString(),
             QStringLiteral("/cmd_vel: is bad json"));
    QCOMPARE(scene.taken.load(), 2);
  }

  void publish_wrongOnes_areTold() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.text(R"({"op":"advertise","channels":[{"id":1,"topic":"/x","encoding":"cdr",)"
                R"("schemaName":"y"},{"id":2,"topic":"/cmd_vel","encoding":"ros1",)"
                R"("schemaName":"geometry_msgs/msg/Twist"}]})");
    QCOMPARE(
        client.await("status").value(QLatin1String("message")).toString(),
        QStringLiteral("no subscriber for /x of type y; the encoding 'ros1' is not supported"));
    client.binary("\x01" + number(2, 4) + "good");
    QCOMPARE(client.await("status").value(QLatin1String("message")).toString(),
             QStringLiteral("there is no client channel 2"));
    QCOMPARE(scene.taken.load(), 0);
  }

  void parameters_getAndSet() {
    Connected scene;
    LiveClient& client = *scene.client;
    QCOMPARE(valuesOf(parameters(client)),
             QStringLiteral(R"([{"name":"factor","type":"float64","value":1},)"
                            R"({"name":"paused","value":false},{"name":"seed","value":7}])"));
    QCOMPARE(valuesOf(parameters(client, "\"seed\",\"nobody\"")),
             QStringLiteral(R"([{"name":"seed","value":7}])"));
    client.text(R"({"op":"setParameters","id":"s","parameters":[{"name":"factor","value":2.5}]})");
    const QJsonObject set = client.await("parameterValues");
    QCOMPARE(set.value(QLatin1String("id")).toString(), QStringLiteral("s"));
    QCOMPARE(valuesOf(set), QStringLiteral(R"([{"name":"factor","type":"float64","value":2.5}])"));
    client.text(R"({"op":"setParameters","parameters":[{"name":"factor","value":"x"},)"
                R"({"name":"seed","value":1},{"name":"nobody"}]})");
    QCOMPARE(client.await("status").value(QLatin1String("message")).toString(),
             QStringLiteral("factor is no number; seed cannot be set; nobody does not exist"));
    QCOMPARE(scene.factor.load(), 2.5);
  }

  void parameters_watched_areTold() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.text(R"({"op":"subscribeParameterUpdates","parameterNames":["paused","factor"]})");
    parameters(client);
    const auto call = [&] {  // a service may change parameters
      client.binary("\x02" + number(1, 4) + number(1, 4) + number(3, 4) + "cdr");
    };
    scene.isPaused = true;
    call();
    QCOMPARE(valuesOf(client.await("parameterValues")),
             QStringLiteral(R"([{"name":"paused","value":true}])"));
    client.text(R"({"op":"unsubscribeParameterUpdates","parameterNames":["paused"]})");
    parameters(client);
    scene.isPaused = false;
    scene.factor = 3.0;
    call();
    QCOMPARE(valuesOf(client.await("parameterValues")),
             QStringLiteral(R"([{"name":"factor","type":"float64","value":3}])"));
  }

  void unknownOp_isAnError_data() {
    QTest::addColumn<QByteArray>("message");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* message, const char* said) {
      QTest::newRow(said) << QByteArray(message) << QString::fromUtf8(said);
    };
    row(R"({"op":"subscribeConnectionGraph"})", "unknown operation 'subscribeConnectionGraph'");
    row("{}", "'op' is missing");
    row("[1]", "a text message must be a JSON object");
    row("{", "a text message must be a JSON object ");
    row("", "a text message must be a JSON object  ");
    row(R"({"op":7})", "'op' must be a short text");
    row(R"({"op":"subscribe"})", "'subscriptions' is missing");
    row(R"({"op":"subscribe","subscriptions":[7]})", "the items of a list must be objects");
    row(R"({"op":"unsubscribe","subscriptionIds":[-1]})",
        "'subscriptionIds' must be an integer from 0 to 4294967295");
    row(R"({"op":"unsubscribe","subscriptionIds":[4294967296]})",
        "'subscriptionIds' must be an integer from 0 to 4294967295 ");
    row(R"({"op":"unsubscribe","subscriptionIds":[1.5]})",
        "'subscriptionIds' must be an integer from 0 to 4294967295  ");
    row(R"({"op":"unsubscribe","subscriptionIds":{}})",
        "'subscriptionIds' must be a list of at most 1000 items");
    row(R"({"op":"x","a":[[[[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]]]]})",
        "brackets are nested too deeply");
  }

  void unknownOp_isAnError() {
    QFETCH(const QByteArray, message);
    QFETCH(const QString, said);
    Connected scene;
    LiveClient& client = *scene.client;
    client.text(message.toStdString());
    const QJsonObject status = client.await("status");
    QCOMPARE(status.value(QLatin1String("level")).toInt(), 2);
    QCOMPARE(status.value(QLatin1String("message")).toString(), said.trimmed());
  }

  void largeMessage_closesWith1009() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.write(client::frame(0x82, std::string((1 << 20) + 1, 'x')).substr(0, 100));
    QCOMPARE(client.awaitClose(), 1009);
  }

  void wrongText_closesWith1007() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.text("\xFF\xFE");
    QCOMPARE(client.awaitClose(), 1007);
    QVERIFY(client.awaitEnd());
  }

  /// One that does not read: of 50 MB it gets what the sockets and the outbox held, the newest at
  /// last.
  void slowClient_oldestAreLeftOut() {
    Scene scene;
    QVERIFY(scene.listen());
    LiveClient client(scene.port(), 65536);
    QVERIFY(client.open());
    client.text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
    parameters(client);
    constexpr int kCount = 500;
    for (int i = 0; i < kCount; ++i) {
      scene.publish(static_cast<std::uint64_t>(i), 1, std::string(100000, 'x'));
    }
    std::vector<int> times;
    int told = 0;
    while (times.empty() || times.back() < kCount - 1) {
      const client::Frame frame = client.next();
      QVERIFY(frame.first != 0);
      if (frame.first == 0x81) {
        ++told;
        QVERIFY(frame.payload.find("\"id\":\"slow\"") != std::string::npos);
      } else if (frame.payload[0] == 1) {
        QCOMPARE(frame.payload.size(), std::size_t{100013});
        times.push_back(static_cast<std::uint8_t>(frame.payload[5]) +
                        256 * static_cast<std::uint8_t>(frame.payload[6]));
      }
    }
    QCOMPARE(told, 1);
    QVERIFY(std::is_sorted(times.begin(), times.end()));
    QVERIFY2(times.size() > 80 && times.size() < 200, qPrintable(QString::number(times.size())));
  }

  void stop_clientsAreTold() {
    Connected scene;
    LiveClient& client = *scene.client;
    client.text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
    parameters(client);
    scene.publish(3, 1, "last");
    scene.server->stop("over");
    QCOMPARE(client.awaitBinary(1).substr(13), std::string("last"));
    QCOMPARE(client.awaitClose(), 1001);
    LiveClient late(scene.port());
    QVERIFY(!late.isConnected() || !late.open());
  }

  /// Damaged requests and frames of all kinds, then one who does it right is served.
  void anyBytes_doNoHarm() {
    Scene scene;
    QVERIFY(scene.listen());
    const std::vector<std::string> texts = {
        R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1},{"id":2,"channelId":2}]})",
        R"({"op":"setParameters","id":"s","parameters":[{"name":"factor","value":2.5}]})",
        R"({"op":"advertise","channels":[{"id":12,"topic":"/cmd_vel","encoding":"json",)"
        R"("schemaName":"geometry_msgs/msg/Twist"}]})",
        R"({"op":"getParameters","parameterNames":[],"id":"x"})"};
    const std::vector<std::string> binaries = {
        "\x01" + number(12, 4) + "abc",
        "\x02" + number(1, 4) + number(1, 4) + number(3, 4) + "cdr"};
    Mutator mutator(1);
    for (int i = 0; i < 300; ++i) {
      LiveClient client(scene.port());
      if (mutator.pick(4) == 0) {
        client.write(mutator.mutated("GET / HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\n\r\n"));
        continue;
      }
      if (!client.open()) {  // those before are still being put away
        continue;
      }
      for (int k = 0; k < 20; ++k) {
        const bool isText = mutator.pick(2) == 0;
        std::string bytes =
            isText ? texts[mutator.pick(texts.size())] : binaries[mutator.pick(binaries.size())];
        const bool isInside = mutator.pick(2) == 0;  // else the frame itself is damaged
        bytes = client::frame(isText ? 0x81 : 0x82, isInside ? mutator.mutated(bytes) : bytes);
        client.write(isInside ? bytes : mutator.mutated(bytes));
      }
      scene.publish(static_cast<std::uint64_t>(i), static_cast<live::ChannelId>(1 + i % 2), "abc");
    }
    QTRY_COMPARE(scene.server->clientCount(), std::size_t{0});
    LiveClient good(scene.port());
    QTRY_VERIFY(good.isConnected());
    QVERIFY(good.open());
    QCOMPARE(parameters(good).value(QLatin1String("id")).toString(), QStringLiteral("q"));
  }
};

QTEST_APPLESS_MAIN(FoxgloveServerTest)
#include "tst_FoxgloveServer.moc"
