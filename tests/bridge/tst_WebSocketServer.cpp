#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <QtTest>

#include "app/bridge/live/WebSocketServer.h"
#include "tests/bridge/LiveClient.h"

using client::bytesOf;
using client::frame;
using client::LiveClient;
using live::SendQueue;
using live::WebSocketServer;
using std::chrono::milliseconds;

namespace {

/// The request of RFC 6455, 1.3, with another protocol.
const char* const kUsual =
    "GET /chat HTTP/1.1\r\n"
    "Host: server.example.com\r\n"
    "Upgrade: websocket\r\n"
    "Connection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
    "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n"
    "Sec-WebSocket-Version: 13\r\n";

/// Sends each message back and counts what happens.
struct Echo : WebSocketServer::Handler {
  void opened(WebSocketServer::Client client) override {
    ++openedCount;
    last = client;
  }
  void received(WebSocketServer::Client client, bool isText, const std::string& message) override {
    if (message == "no memory") {
      throw std::bad_alloc();
    }
    const auto kind = isText ? SendQueue::Kind::Text : SendQueue::Kind::Response;
    server->send(client, {kind, message});
  }
  void closed(WebSocketServer::Client /*client*/) override { ++closedCount; }
  void refused(const std::string& origin) override { refusedOrigin = origin; }

  WebSocketServer* server = nullptr;
  std::atomic<int> openedCount{0}, closedCount{0};
  std::atomic<WebSocketServer::Client> last{0};
  std::string refusedOrigin;
};

/// Messages of at most 1000 bytes.
struct Scene {
  explicit Scene(milliseconds idleTimeout = milliseconds(20000),
                 milliseconds closeTime = milliseconds(300)) {
    live::ServerSettings settings;
    settings.protocols = {"foxglove.sdk.v1", "foxglove.websocket.v1"};
    settings.origins = {"https://lab.example"};
    settings.largestMessage = 1000;
    settings.handshakeTime = milliseconds(500);
    settings.idleTimeout = idleTimeout;
    settings.closeTime = closeTime;
    server = *WebSocketServer::listen(settings, echo);
    echo.server = server.get();
    server->start();
  }
  int port() const { return server->port(); }

  Echo echo;
  std::unique_ptr<WebSocketServer> server;
};

/// The head of the response to these lines.
std::string responseTo(const Scene& scene, const QByteArray& lines) {
  LiveClient client(scene.port());
  client.write((lines + "\r\n").toStdString());
  return client.httpAnswer();
}

std::string statusOf(const Scene& scene, const QByteArray& lines) {
  return responseTo(scene, lines).substr(9, 3);
}

/// The code of a close frame.
std::string closeOf(int code) {
  return {static_cast<char>(code / 256), static_cast<char>(code % 256)};
}

}  // namespace

class WebSocketServerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void request_exampleOfTheRfc_isAccepted() {
    const Scene scene;
    const QByteArray response = QByteArray::fromStdString(responseTo(scene, kUsual));
    QVERIFY(response.startsWith("HTTP/1.1 101 Switching Protocols\r\n"));
    QVERIFY(response.contains("\r\nSec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"));
    QVERIFY(response.contains("\r\nSec-WebSocket-Protocol: foxglove.websocket.v1"));
  }

  void request_severalProtocols_theFirstKnownIsTaken_data() {
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QString>("taken");
    int rows = 0;
    const auto row = [&rows](const char* lines, const char* taken) {
      QTest::addRow("%s %d", taken, ++rows) << QByteArray(lines) << QString::fromLatin1(taken);
    };
    row("Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n", "foxglove.sdk.v1");
    row("Sec-WebSocket-Protocol: chat, foxglove.websocket.v1,foxglove.sdk.v1\r\n",
        "foxglove.websocket.v1");
    row("sec-websocket-protocol: chat\r\nSEC-WEBSOCKET-PROTOCOL: foxglove.sdk.v1\r\n",
        "foxglove.sdk.v1");
    row("Sec-WebSocket-Protocol: chat\r\n", "");
    row("Sec-WebSocket-Protocol: Foxglove.Websocket.v1\r\n", "");
    row("", "");
  }

  void request_severalProtocols_theFirstKnownIsTaken() {
    QFETCH(const QByteArray, lines);
    QFETCH(const QString, taken);
    const Scene scene;
    QByteArray request(kUsual);
    request.replace("Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n", lines);
    const QString response = QString::fromStdString(responseTo(scene, request));
    QCOMPARE(response.mid(9, 3), taken.isEmpty() ? QStringLiteral("400") : QStringLiteral("101"));
    QCOMPARE(response.contains(QStringLiteral("\r\nSec-WebSocket-Protocol: ") + taken),
             !taken.isEmpty());
  }

  void request_variants_haveTheirStatus_data() {
    QTest::addColumn<QByteArray>("what");
    QTest::addColumn<QByteArray>("by");
    QTest::addColumn<QString>("status");
    const auto row = [](const char* name, const char* what, const QByteArray& by, int status) {
      QTest::newRow(name) << QByteArray(what) << by << QString::number(status);
    };
    row("as it is", "", "", 101);
    row("words in other case", "Upgrade: websocket", "upgrade:WebSocket", 101);
    row("several connections", "Connection: Upgrade", "Connection: keep-alive, Upgrade", 101);
    row("two lines of connections", "Connection: Upgrade",
        "Connection: keep-alive\r\nConnection: upgrade", 101);
    row("more headers", "Host:", "User-Agent: x\r\nCookie: a=b\r\nCookie: c=d\r\nHost:", 101);
    row("POST", "GET", "POST", 400);
    row("HTTP 1.0", "HTTP/1.1", "HTTP/1.0", 400);
    row("HTTP 2", "HTTP/1.1", "HTTP/2.0", 400);
    row("no target", "GET /chat", "GET", 400);
    row("not of ours", "GET /chat", "GET http://a/", 400);
    row("no host", "Host: server.example.com\r\n", "", 400);
    row("two hosts", "Host:", "Host: a\r\nHost:", 400);
    row("two keys", "Sec-WebSocket-Key:",
        "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Key:", 400);
    row("two origins", "Host:", "Origin: file://\r\nOrigin: file://\r\nHost:", 400);
    row("no key", "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n", "", 400);
    row("short key", "dGhlIHNhbXBsZSBub25jZQ==", "dGhlIHNhbXBsZSBub25j", 400);
    row("key of other letters", "dGhl", "dG-_", 400);
    row("version 8", "Version: 13", "Version: 8", 426);
    row("no version", "Sec-WebSocket-Version: 13\r\n", "", 426);
    row("another upgrade", "Upgrade: websocket", "Upgrade: h2c", 426);
    row("no upgrade", "Upgrade: websocket\r\n", "", 426);
    row("no connection", "Connection: Upgrade\r\n", "", 426);
    row("a folded line", "Host:", "X: a\r\n b\r\nHost:", 101);
    row("a line without a colon", "Host:", "nonsense\r\nHost:", 400);
    row("a name with a blank", "Host:", "Host :", 400);
    row("line ends of another kind", "\r\nHost", "\nHost", 400);
    row("a zero byte", "server", QByteArray("ser\0ver", 7), 400);
  }

  void request_variants_haveTheirStatus() {
    QFETCH(const QByteArray, what);
    QFETCH(const QByteArray, by);
    QFETCH(const QString, status);
    QByteArray request(kUsual);
    if (!what.isEmpty()) {
      QVERIFY(request.contains(what));
      request.replace(what, by);
    }
    const Scene scene;
    QCOMPARE(QString::fromStdString(statusOf(scene, request)), status);
  }

  void request_ofABrowserPage_getsAnExplanation() {
    const Scene scene;
    LiveClient client(scene.port());
    client.write("GET / HTTP/1.1\r\nHost: localhost:8765\r\n\r\n");
    QCOMPARE(QByteArray::fromStdString(client.rest()),
             QByteArray("HTTP/1.1 426 Upgrade Required\r\nConnection: close\r\n"
                        "Content-Type: text/plain; charset=utf-8\r\nUpgrade: websocket\r\n"
                        "Sec-WebSocket-Version: 13\r\nContent-Length: 117\r\n\r\n"
                        "This is the live view of hunavsim. Open it in Foxglove: Open connection, "
                        "Foxglove WebSocket, ws:// and this address.\n"));
  }

  void request_ofARefusedPage_isReported() {
    Scene scene;
    LiveClient client(scene.port());
    client.write(std::string(kUsual) + "Origin: https://evil.example\r\n\r\n");
    const std::string response = client.rest();
    QVERIFY(response.rfind("HTTP/1.1 403 Forbidden\r\n", 0) == 0);
    QVERIFY(response.find("evil") == std::string::npos);  // nothing of theirs comes back
    std::string origin;
    scene.server->exclusively([&] { origin = scene.echo.refusedOrigin; });
    QCOMPARE(origin, std::string("https://evil.example"));
  }

  void request_inPieces_opens() {
    const Scene scene;
    LiveClient client(scene.port());
    for (const char c : std::string(kUsual) + "\r\n" + frame(0x81, "one")) {
      client.write(std::string(1, c));
    }
    QVERIFY(client.httpAnswer().rfind("HTTP/1.1 101 ", 0) == 0);
    QCOMPARE(client.next().payload, std::string("one"));
  }

  void request_withFramesBehind_theyAreRead() {
    const Scene scene;
    LiveClient client(scene.port());
    client.write(std::string(kUsual) + "\r\n" + frame(0x81, "one") + frame(0x81, "two"));
    QVERIFY(client.httpAnswer().rfind("HTTP/1.1 101 ", 0) == 0);
    QCOMPARE(client.next().payload, std::string("one"));
    QCOMPARE(client.next().payload, std::string("two"));
  }

  void request_garbage_isRefusedAndEnds() {
    const Scene scene;
    LiveClient client(scene.port());
    client.write("\x16\x03\x01 nonsense\r\n\r\n" + frame(0x81, "x"));
    QVERIFY(client.rest().rfind("HTTP/1.1 400 Bad Request\r\n", 0) == 0);
    QTRY_VERIFY(!client.write("y"));  // the server does not wait for the client's end
    QCOMPARE(scene.echo.openedCount.load(), 0);
  }

  /// The response arrives, although the client sends more than is read.
  void request_withoutEnd_isRefusedAt8192() {
    const Scene scene;
    LiveClient client(scene.port());
    client.write(std::string(8000, 'x'));
    client.write(std::string(500000, 'x'));
    QVERIFY(client.rest().rfind("HTTP/1.1 431 Request Header Fields Too Large\r\n", 0) == 0);
  }

  /// Byte by byte does not help.
  void request_thatDoesNotCome_endsInTime() {
    const Scene scene;
    LiveClient client(scene.port());
    QElapsedTimer timer;
    timer.start();
    while (client.write("x") && timer.elapsed() < 5000) {
      QTest::qWait(20);
    }
    QVERIFY2(timer.elapsed() >= 450 && timer.elapsed() < 2000, QByteArray::number(timer.elapsed()));
  }

  void origin_each_isJudged_data() {
    QTest::addColumn<QByteArray>("origin");
    QTest::addColumn<bool>("isAllowed");
    for (const char* fine :
         {"https://app.foxglove.dev", "https://studio.foxglove.dev", "file://", "http://localhost",
          "http://localhost:8080", "https://localhost:8443", "http://127.0.0.1:3000",
          "http://[::1]:3000", "http://[::1]", "https://lab.example"}) {
      QTest::newRow(fine) << QByteArray(fine) << true;
    }
    for (const char* wrong : {"null",
                              "",
                              "https://evil.example",
                              "http://app.foxglove.dev",
                              "https://app.foxglove.dev.evil.example",
                              "https://app.foxglove.dev:8443",
                              "https://evil.app.foxglove.dev",
                              "http://localhost.evil.example",
                              "http://localhost:",
                              "http://localhost:80.evil.example",
                              "http://localhost:80@evil.example",
                              "http://evil.example:80",
                              "http://127.0.0.1.evil.example",
                              "http://127.0.0.2",
                              "http://[::1].evil.example",
                              "file://evil",
                              "localhost",
                              "ftp://localhost",
                              "http://LOCALHOST",
                              "http://192.168.1.5",
                              "https://lab.example:444"}) {
      QTest::newRow(wrong) << QByteArray(wrong) << false;
    }
  }

  void origin_each_isJudged() {
    QFETCH(const QByteArray, origin);
    QFETCH(const bool, isAllowed);
    QCOMPARE(live::isAllowedOrigin(origin.toStdString(), {"https://lab.example"}), isAllowed);
    const Scene scene;
    QCOMPARE(statusOf(scene, QByteArray(kUsual) + "Origin: " + origin + "\r\n"),
             std::string(isAllowed ? "101" : "403"));
  }

  /// Lengths of 7 and 16 bits from the client, and of 64 bits to it.
  void messages_ofAllSizes_comeBack() {
    Scene scene;
    LiveClient client(scene.port());
    QVERIFY(client.open());
    for (const std::size_t size : {0U, 1U, 125U, 126U, 127U, 999U, 1000U}) {
      client.binary(std::string(size, 'b'));
      const client::Frame received = client.next();
      QCOMPARE(received.first, 0x82);
      QCOMPARE(received.payload, std::string(size, 'b'));
    }
    for (const std::size_t size : {65535U, 65536U, 1000000U}) {
      const auto body = std::make_shared<const std::string>(size, 'c');
      scene.server->exclusively([&] {
        scene.server->send(scene.echo.last, {SendQueue::Kind::Topic, "head", body});
      });
      const client::Frame received = client.next();
      QCOMPARE(received.first, 0x82);
      QVERIFY(received.payload == "head" + *body);
    }
  }

  void messages_inPieces_giveTheSame() {
    const Scene scene;
    const std::string medium(300, 'm');
    const std::string all = frame(0x82, medium) + frame(0x81, "") + frame(0x02, medium) +
                            frame(0x00, "") + frame(0x80, medium) + frame(0x89, "p");
    for (const std::size_t piece : {1U, 7U, 1000U}) {
      LiveClient client(scene.port());
      QVERIFY(client.open());
      for (std::size_t at = 0; at < all.size(); at += piece) {
        client.write(all.substr(at, piece));
      }
      const client::Frame first = client.next();
      QVERIFY(first.first == 0x82 && first.payload == medium);
      const client::Frame second = client.next();
      QVERIFY(second.first == 0x81 && second.payload.empty());
      const client::Frame third = client.next();
      QVERIFY(third.first == 0x82 && third.payload == medium + medium);
      const client::Frame pong = client.next();
      QVERIFY(pong.first == 0x8A && pong.payload == "p");
    }
  }

  void message_inFragments_controlComesFirst() {
    const Scene scene;
    LiveClient client(scene.port());
    QVERIFY(client.open());
    client.write(frame(0x01, "a") + frame(0x89, "ping") + frame(0x80, "b"));
    const client::Frame pong = client.next();
    QVERIFY(pong.first == 0x8A && pong.payload == "ping");
    const client::Frame text = client.next();
    QVERIFY(text.first == 0x81 && text.payload == "ab");
  }

  void message_forWhichMemoryLacks_endsItsClientOnly() {
    const Scene scene;
    LiveClient client(scene.port()), other(scene.port());
    QVERIFY(client.open() && other.open());
    client.text("no memory");
    QVERIFY(client.awaitEnd());
    QTRY_COMPARE(scene.echo.closedCount.load(), 1);
    other.text("still here");
    QCOMPARE(other.next().payload, std::string("still here"));
  }

  void violation_closesWithItsCode_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("code");  // 0: none
    const auto row = [](const char* name, const std::string& bytes, int code) {
      QTest::newRow(name) << QByteArray::fromStdString(bytes) << code;
    };
    row("not masked", bytesOf("81 05 48 65 6c 6c 6f"), 1002);
    row("reserved bit", frame(0xC1, "x"), 1002);
    row("opcode 3", frame(0x83, "x"), 1002);
    row("opcode 11", frame(0x8B, "x"), 1002);
    row("continuation of nothing", frame(0x80, "x"), 1002);
    row("text within text", frame(0x01, "x") + frame(0x81, "y"), 1002);
    row("ping in fragments", frame(0x09, "x"), 1002);
    row("ping of 126", frame(0x89, std::string(126, 'x')), 1002);
    row("long form of 5", bytesOf("81 fe 00 05 00 00 00 00") + "Hello", 1002);
    row("longest form of 126", bytesOf("81 ff 00 00 00 00 00 00 00 7e 00 00 00 00"), 1002);
    row("length of 2^63 - 1", bytesOf("82 ff 7f ff ff ff ff ff ff ff 00 00 00 00"), 1009);
    row("1001 bytes", frame(0x82, std::string(1001, 'x')), 1009);
    row("head of 1001 bytes", frame(0x82, std::string(1001, 'x')).substr(0, 20), 1009);
    row("1001 bytes in two",
        frame(0x02, std::string(600, 'x')) + frame(0x80, std::string(401, 'x')), 1009);
    row("more behind it", frame(0x82, std::string(1001, 'x')) + std::string(100000, 'y'), 1009);
    row("no UTF-8", frame(0x81, "\xFF"), 1007);
    row("half a character", frame(0x81, "\xC3"), 1007);
    row("a surrogate", frame(0x81, "\xED\xA0\x80"), 1007);
    row("an overlong form", frame(0x81, "\xC0\x80"), 1007);
    row("beyond U+10FFFF", frame(0x81, "\xF4\x90\x80\x80"), 1007);
    row("a character in two fragments", frame(0x01, "\xC3") + frame(0x80, "\xA9"), 0);
    row("no UTF-8 in bytes", frame(0x82, "\xFF"), 0);
    row("close of one byte", frame(0x88, "x"), 1002);
    row("close with a reason of no UTF-8", frame(0x88, bytesOf("03 e8 ff")), 1002);
  }

  /// The close frame arrives also if more data follows.
  void violation_closesWithItsCode() {
    QFETCH(const QByteArray, bytes);
    QFETCH(const int, code);
    const Scene scene;
    LiveClient client(scene.port());
    QVERIFY(client.open());
    client.write(bytes.toStdString());
    client.write(frame(0x81, "more"));
    if (code == 0) {
      QVERIFY(client.next().first < 0x88);
      QCOMPARE(client.next().payload, std::string("more"));
    } else {
      QCOMPARE(client.awaitClose(), code);
      QVERIFY(client.awaitEnd());
      QTRY_COMPARE(scene.echo.closedCount.load(), 1);
    }
  }

  void close_codesOfTheRfc_areEchoed_data() {
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("answer");
    for (const int fine :
         {1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010, 1011, 3000, 3999, 4000, 4999}) {
      QTest::addRow("%d", fine) << fine << fine;
    }
    for (const int wrong : {0, 999, 1004, 1005, 1006, 1015, 1016, 1100, 2000, 2999}) {
      QTest::addRow("%d", wrong) << wrong << 1002;
    }
  }

  void close_codesOfTheRfc_areEchoed() {
    QFETCH(const int, code);
    QFETCH(const int, answer);
    const Scene scene;
    LiveClient client(scene.port());
    QVERIFY(client.open());
    client.write(frame(0x88, closeOf(code) + "bye") + frame(0x81, "late"));
    QCOMPARE(client.awaitClose(), answer);
    QVERIFY(client.awaitEnd());
  }

  /// A close frame without a code is answered with 1000.
  void close_clientThatStays_endsInTime() {
    const Scene scene;
    LiveClient client(scene.port());
    QVERIFY(client.open());
    QElapsedTimer timer;
    timer.start();
    client.write(frame(0x88, ""));
    QCOMPARE(client.awaitClose(), 1000);
    QVERIFY(client.awaitEnd());
    QTRY_COMPARE(scene.echo.closedCount.load(),
                 1);  // the server does not wait for the client's end
    QVERIFY2(timer.elapsed() < 1500, QByteArray::number(timer.elapsed()));
  }

  void silence_isAskedThenEnds() {
    const Scene scene(milliseconds(400));
    LiveClient client(scene.port());
    QVERIFY(client.open());
    QElapsedTimer timer;
    timer.start();
    const client::Frame ping = client.next();
    QVERIFY(ping.first == 0x89 && ping.payload.empty());
    QVERIFY2(timer.elapsed() >= 350, QByteArray::number(timer.elapsed()));
    client.write(frame(0x8A, ""));
    timer.restart();
    QCOMPARE(client.next().first, 0x89);
    QVERIFY2(timer.elapsed() >= 350, QByteArray::number(timer.elapsed()));
    QCOMPARE(client.next().first, 0);
    QVERIFY2(timer.elapsed() >= 750 && timer.elapsed() < 2000, QByteArray::number(timer.elapsed()));
  }

  /// Messages without end, whose responses are not read: the server stops reading. It goes on as
  /// soon as the client reads.
  void slowReader_isNotReadFrom() {
    const Scene scene;
    LiveClient client(scene.port(), 4096);
    QVERIFY(client.open());
    constexpr int kCount = 20000;  // 20 MB, far more than the sockets hold
    std::atomic<int> written{0};
    std::thread writer([&] {
      for (; written < kCount && client.write(frame(0x82, std::string(1000, 'x'))); ++written) {
      }
    });
    int before = -1;
    while (before != written) {
      before = written;
      QTest::qWait(500);
    }
    const int waiting = written;
    int received = 0;
    while (received < kCount && client.next().payload.size() == 1000) {
      ++received;
    }
    writer.join();
    QVERIFY2(waiting < kCount, QByteArray::number(waiting));
    QCOMPARE(received, kCount);
  }

  void clientVanishes_isClosed() {
    Scene scene(milliseconds(20000), milliseconds(60000));  // without waiting for a close frame
    auto client = std::make_unique<LiveClient>(scene.port());
    QVERIFY(client->open());
    QTRY_COMPARE(scene.echo.openedCount.load(), 1);
    client.reset();
    QTRY_COMPARE(scene.echo.closedCount.load(), 1);
    scene.server->exclusively([&] {
      scene.server->send(scene.echo.last, {SendQueue::Kind::Text, "ignored"});
    });
  }

  /// Frames that were received before a client vanished may be handled after it.
  void clientsThatVanishAmidFrames_areClosedOnce() {
    const Scene scene;
    constexpr int kCount = 50;
    std::string frames;
    for (int i = 0; i < 200; ++i) {
      frames += frame(0x89, "ping") + frame(0x81, "text");
    }
    for (int i = 0; i < kCount; ++i) {
      LiveClient client(scene.port());
      QVERIFY(client.open());
      client.write(frames + frame(0x88, closeOf(1000)) + frames);
    }
    QTRY_COMPARE(scene.echo.closedCount.load(), kCount);
    QTest::qWait(500);
    QCOMPARE(scene.echo.openedCount.load(), kCount);
    QTRY_COMPARE(scene.echo.closedCount.load(), kCount);
  }

  void exclusively_beforeAndAfterServing_isDone() {
    Echo echo;
    const auto server = *WebSocketServer::listen({}, echo);
    int count = 0;
    server->exclusively([&] { ++count; });
    server->start();
    server->exclusively([&] { ++count; });
    server->stop("over");
    server->exclusively([&] { ++count; });
    QCOMPARE(count, 3);
  }

  /// 123 bytes are left for the reason: 41 characters of 3 fit, the 42nd would be cut.
  void stop_longReason_isCutBetweenCharacters() {
    Scene scene;
    LiveClient client(scene.port());
    QVERIFY(client.open());
    scene.server->stop("x" + QString(60, QChar(0x20AC)).toStdString());
    const client::Frame close = client.next();
    QCOMPARE(close.first, 0x88);
    QCOMPARE(close.payload, closeOf(1001) + "x" + QString(40, QChar(0x20AC)).toStdString());
    QTRY_COMPARE(scene.echo.closedCount.load(), 1);
  }

  void stop_clientThatDoesNotRead_endsWithinASecond() {
    Scene scene;
    LiveClient client(scene.port(), 4096);
    QVERIFY(client.open());
    const auto body = std::make_shared<const std::string>(5000000, 'x');
    scene.server->exclusively([&] {
      scene.server->send(scene.echo.last, {SendQueue::Kind::Topic, "", body});
    });
    QElapsedTimer timer;
    timer.start();
    scene.server->stop("over");
    QVERIFY2(timer.elapsed() < 1500, QByteArray::number(timer.elapsed()));
    QTRY_COMPARE(scene.echo.closedCount.load(), 1);
  }
};

QTEST_APPLESS_MAIN(WebSocketServerTest)
#include "tst_WebSocketServer.moc"
