#include <string>

#include <QtTest>

#include "app/bridge/live/WebSocketHandshake.h"

namespace {

const std::vector<std::string> kProtocols = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// The request of RFC 6455, 1.3, with another protocol.
const char* const kUsual =
    "GET /chat HTTP/1.1\r\n"
    "Host: server.example.com\r\n"
    "Upgrade: websocket\r\n"
    "Connection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
    "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n"
    "Sec-WebSocket-Version: 13\r\n";

std::string statusOf(const QByteArray& lines) {
  const live::HandshakeResponse answer =
      live::respondToHandshake((lines + "\r\n").toStdString(), kProtocols, {"https://lab.example"});
  return answer.response.substr(9, 3);
}

}  // namespace

class WebSocketHandshakeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void acceptOf_exampleOfTheRfc_isItsAnswer();
  void answer_exampleOfTheRfc_isAccepted();
  void answer_severalProtocols_theFirstKnownIsTaken_data();
  void answer_severalProtocols_theFirstKnownIsTaken();
  void answer_variants_haveTheirStatus_data();
  void answer_variants_haveTheirStatus();
  void answer_browserThatLooks_isToldWhatThisIs();
  void origin_each_isJudged_data();
  void origin_each_isJudged();
  void answer_refusedPage_isNamed();
};

void WebSocketHandshakeTest::acceptOf_exampleOfTheRfc_isItsAnswer() {
  QCOMPARE(live::acceptKeyOf("dGhlIHNhbXBsZSBub25jZQ=="),
           std::string("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="));
}

void WebSocketHandshakeTest::answer_exampleOfTheRfc_isAccepted() {
  const live::HandshakeResponse answer =
      live::respondToHandshake(std::string(kUsual) + "\r\n", kProtocols);
  QVERIFY(answer.isAccepted);
  QCOMPARE(answer.response, std::string("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n"
                                        "Connection: Upgrade\r\n"
                                        "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"
                                        "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n"));
}

void WebSocketHandshakeTest::answer_severalProtocols_theFirstKnownIsTaken_data() {
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

void WebSocketHandshakeTest::answer_severalProtocols_theFirstKnownIsTaken() {
  QFETCH(const QByteArray, lines);
  QFETCH(const QString, taken);
  QByteArray request(kUsual);
  request.replace("Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n", lines);
  const live::HandshakeResponse answer =
      live::respondToHandshake((request + "\r\n").toStdString(), kProtocols);
  QCOMPARE(QString::fromStdString(answer.protocol), taken);
  QCOMPARE(answer.isAccepted, !taken.isEmpty());
  QCOMPARE(answer.response.substr(9, 3), std::string(taken.isEmpty() ? "400" : "101"));
}

void WebSocketHandshakeTest::answer_variants_haveTheirStatus_data() {
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
  row("a folded line", "Host:", "X: a\r\n b\r\nHost:", 400);
  row("a line without a colon", "Host:", "nonsense\r\nHost:", 400);
  row("a name with a blank", "Host:", "Host :", 400);
  row("line ends of another kind", "\r\nHost", "\nHost", 400);
  row("a zero byte", "server", QByteArray("ser\0ver", 7), 400);
}

void WebSocketHandshakeTest::answer_variants_haveTheirStatus() {
  QFETCH(const QByteArray, what);
  QFETCH(const QByteArray, by);
  QFETCH(const QString, status);
  QByteArray request(kUsual);
  if (!what.isEmpty()) {
    QVERIFY(request.contains(what));
    request.replace(what, by);
  }
  QCOMPARE(QString::fromStdString(statusOf(request)), status);
}

void WebSocketHandshakeTest::answer_browserThatLooks_isToldWhatThisIs() {
  const live::HandshakeResponse answer =
      live::respondToHandshake("GET / HTTP/1.1\r\nHost: localhost:8765\r\n\r\n", kProtocols);
  QVERIFY(!answer.isAccepted);
  const QString response = QString::fromStdString(answer.response);
  QVERIFY(response.startsWith(QStringLiteral("HTTP/1.1 426 ")));
  QVERIFY(response.contains(QStringLiteral("\r\nUpgrade: websocket\r\n")));
  const QStringList parts = response.split(QStringLiteral("\r\n\r\n"));
  QCOMPARE(parts.size(), 2);
  QVERIFY(parts[1].contains(QStringLiteral("Foxglove")));
  QVERIFY(parts[0].contains(QStringLiteral("Content-Length: %1").arg(parts[1].size())));
}

void WebSocketHandshakeTest::origin_each_isJudged_data() {
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

void WebSocketHandshakeTest::origin_each_isJudged() {
  QFETCH(const QByteArray, origin);
  QFETCH(const bool, isAllowed);
  QCOMPARE(live::isAllowedOrigin(origin.toStdString(), {"https://lab.example"}), isAllowed);
  QByteArray request(kUsual);
  request += "Origin: " + origin + "\r\n";
  QCOMPARE(statusOf(request), std::string(isAllowed ? "101" : "403"));
}

void WebSocketHandshakeTest::answer_refusedPage_isNamed() {
  const live::HandshakeResponse answer = live::respondToHandshake(
      std::string(kUsual) + "Origin: https://evil.example\r\n\r\n", kProtocols);
  QCOMPARE(answer.rejectedOrigin, std::string("https://evil.example"));
  QVERIFY(answer.response.find("evil") == std::string::npos);  // nothing of theirs comes back
}

QTEST_APPLESS_MAIN(WebSocketHandshakeTest)
#include "tst_WebSocketHandshake.moc"
