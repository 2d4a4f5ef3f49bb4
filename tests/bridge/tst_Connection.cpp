#include <string>
#include <vector>

#include <QtTest>

#include "app/bridge/live/Connection.h"
#include "tests/bridge/ClientFrames.h"

using client::bytesOf;
using client::frame;
using live::Clock;
using live::Connection;
using live::SendQueue;
using std::chrono::milliseconds;

namespace {

const char* const kRequest =
    "GET / HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: x\r\n"
    "Sec-WebSocket-Version: 13\r\n\r\n";

std::string joined(const std::vector<std::string_view>& parts) {
  std::string all;
  for (const std::string_view part : parts) {
    all.append(part);
  }
  return all;
}

/// A connection with a clock of its own.
struct Probe {
  live::ConnectionLimits rules = {
      {"x"}, {}, 1000, 1000, milliseconds(100), milliseconds(200), milliseconds(50)};
  Clock::time_point now{};
  Connection connection{rules, now};
  int opened = 0;
  std::vector<std::string> received;

  void read(const std::string& bytes) {
    Connection::Events events;
    events.opened = [this] { ++opened; };
    events.received = [this](live::WebSocketMessage&& message) {
      received.push_back(message.payload);
    };
    events.refused = [](const std::string&) {};
    connection.read(bytes, now, events);
  }
  void open() {
    read(kRequest);
    said();
  }
  void pass(int time) {
    now += milliseconds(time);
    connection.tick(now);
  }
  /// All that waits, which is sent with it.
  std::string said() {
    const std::string all = joined(connection.out().next(100000));
    connection.out().sent(all.size());
    return all;
  }
};

live::SharedBytes shared(const std::string& bytes) {
  return std::make_shared<const std::string>(bytes);
}

}  // namespace

class ConnectionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void outbox_messagesAboveTheLimit_oldestAreLeftOut();
  void outbox_oneThatHasBegun_isSentWhole();
  void outbox_answers_areNeverLeftOut();
  void outbox_oneLargeMessage_isKept();
  void outbox_control_overtakesMessages();
  void outbox_partsOfAnySize_giveTheSameBytes();

  void request_inPieces_opens();
  void request_withFramesBehind_theyAreRead();
  void request_garbage_isRefusedAndEnds();
  void request_withoutEnd_isRefusedAt8192();
  void request_thatDoesNotCome_endsInTime();
  void ping_isAnsweredWithItsBytes();
  void silence_isAskedThenEnds();
  void violation_closesWithItsCode();
  void clientCloses_isEchoedAndEnds();
  void weClose_waitsForTheAnswerOrTheTime();
  void slowReader_isNotReadFrom();
  void clientVanishes_ends();
};

/// 1000 bytes in all, each message 100 and 128 for itself: four.
void ConnectionTest::outbox_messagesAboveTheLimit_oldestAreLeftOut() {
  SendQueue out(1000);
  for (char name = 'a'; name <= 'j'; ++name) {
    out.add("", shared(std::string(100, name)), SendQueue::Kind::Message);
  }
  QCOMPARE(out.droppedCount(), std::size_t{6});
  QCOMPARE(joined(out.next(100)), std::string(100, 'g') + std::string(100, 'h') +
                                      std::string(100, 'i') + std::string(100, 'j'));
}

void ConnectionTest::outbox_oneThatHasBegun_isSentWhole() {
  SendQueue out(1000);
  out.add("", shared(std::string(100, 'a')), SendQueue::Kind::Message);
  out.sent(30);
  for (char name = 'b'; name <= 'j'; ++name) {
    out.add("", shared(std::string(100, name)), SendQueue::Kind::Message);
  }
  QCOMPARE(joined(out.next(100)), std::string(70, 'a') + std::string(100, 'h') +
                                      std::string(100, 'i') + std::string(100, 'j'));
}

void ConnectionTest::outbox_answers_areNeverLeftOut() {
  SendQueue out(300);
  out.add("[one]");
  for (int i = 0; i < 100; ++i) {
    out.add("m", shared(std::string(100, 'm')), SendQueue::Kind::Message);
    out.add("[two]");
  }
  const std::string all = joined(out.next(10000));
  QCOMPARE(QByteArray::fromStdString(all).count("[two]"), 100);
  QVERIFY(all.rfind("[one]", 0) == 0);
  QCOMPARE(QByteArray::fromStdString(all).count('m'), 101);  // the newest
  QVERIFY(!out.hasManyReplies());
  out.add(std::string(300000, 'x'));
  QVERIFY(out.hasManyReplies());
}

void ConnectionTest::outbox_oneLargeMessage_isKept() {
  SendQueue out(1000);
  out.add("", shared(std::string(5000, 'a')), SendQueue::Kind::Message);
  QCOMPARE(joined(out.next(10)).size(), std::size_t{5000});
  out.add("", shared("b"), SendQueue::Kind::Message);
  QCOMPARE(joined(out.next(10)), std::string("b"));
}

void ConnectionTest::outbox_control_overtakesMessages() {
  SendQueue out(10000);
  out.add("first");
  out.add("m1", nullptr, SendQueue::Kind::Message);
  out.add("m2", nullptr, SendQueue::Kind::Message);
  out.addNext("P");
  QCOMPARE(joined(out.next(10)), std::string("firstPm1m2"));
  out.sent(7);  // m1 has begun
  out.addNext("Q");
  QCOMPARE(joined(out.next(10)), std::string("1Qm2"));
  out.dropAllMessages();
  QCOMPARE(joined(out.next(10)), std::string("1Q"));
}

void ConnectionTest::outbox_partsOfAnySize_giveTheSameBytes() {
  for (const std::size_t step : {1U, 2U, 3U, 5U, 100U}) {
    SendQueue out;
    out.add("");
    out.add("ab", shared("cde"), SendQueue::Kind::Message);
    out.add("", shared(""), SendQueue::Kind::Message);
    out.add("f", shared("g"));
    std::string all;
    while (!out.isEmpty()) {
      const std::string some = joined(out.next(2)).substr(0, step);
      all += some;
      out.sent(some.size());
    }
    QCOMPARE(all, std::string("abcdefg"));
    QCOMPARE(out.waiting(), std::size_t{0});
  }
}

void ConnectionTest::request_inPieces_opens() {
  Probe probe;
  for (const char c : std::string(kRequest)) {
    QCOMPARE(probe.opened, 0);
    probe.read(std::string(1, c));
  }
  QCOMPARE(probe.opened, 1);
  QVERIFY(probe.said().rfind("HTTP/1.1 101 ", 0) == 0);
  QVERIFY(probe.connection.isOpen());
}

void ConnectionTest::request_withFramesBehind_theyAreRead() {
  Probe probe;
  probe.read(kRequest + frame(0x81, "one") + frame(0x89, "p"));
  QCOMPARE(probe.received, std::vector<std::string>{"one"});
  const std::string said = probe.said();
  QVERIFY(said.rfind("HTTP/1.1 101 ", 0) == 0);
  QCOMPARE(said.substr(said.find("\r\n\r\n") + 4), bytesOf("8a 01 70"));
}

void ConnectionTest::request_garbage_isRefusedAndEnds() {
  Probe probe;
  probe.read("\x16\x03\x01 nonsense\r\n\r\n" + frame(0x81, "x"));
  QVERIFY(probe.said().rfind("HTTP/1.1 400 ", 0) == 0);
  QVERIFY(probe.connection.isSendFinished());
  probe.read(frame(0x81, "y"));
  QVERIFY(probe.received.empty() && probe.opened == 0);
  QVERIFY(!probe.connection.isFinished());
  probe.pass(50);
  QVERIFY(probe.connection.isFinished());
}

void ConnectionTest::request_withoutEnd_isRefusedAt8192() {
  Probe probe;
  probe.read(std::string(8000, 'x'));
  QCOMPARE(probe.said(), std::string());
  probe.read(std::string(500000, 'x'));
  QVERIFY(probe.said().rfind("HTTP/1.1 431 ", 0) == 0);
}

/// Byte by byte does not help.
void ConnectionTest::request_thatDoesNotCome_endsInTime() {
  Probe probe;
  for (int i = 0; i < 9; ++i) {
    probe.pass(10);
    probe.read("x");
  }
  QVERIFY(!probe.connection.isFinished());
  probe.pass(10);
  QVERIFY(probe.connection.isFinished());
}

void ConnectionTest::ping_isAnsweredWithItsBytes() {
  Probe probe;
  probe.open();
  probe.read(frame(0x89, "abc"));
  QCOMPARE(probe.said(), bytesOf("8a 03 61 62 63"));
}

void ConnectionTest::silence_isAskedThenEnds() {
  Probe probe;
  probe.open();
  probe.pass(199);
  QCOMPARE(probe.said(), std::string());
  probe.pass(1);
  QCOMPARE(probe.said(), bytesOf("89 00"));
  probe.pass(100);
  QCOMPARE(probe.said(), std::string());
  probe.read(frame(0x8a, ""));
  probe.pass(200);
  QCOMPARE(probe.said(), bytesOf("89 00"));
  QVERIFY(!probe.connection.isFinished());
  probe.pass(200);
  QVERIFY(probe.connection.isFinished());
}

void ConnectionTest::violation_closesWithItsCode() {
  Probe probe;
  probe.open();
  probe.read(frame(0x82, std::string(1001, 'x')) + frame(0x81, "not read"));
  QCOMPARE(probe.said().substr(0, 4), bytesOf("88 1a 03 f1"));  // 1009
  QVERIFY(probe.received.empty());
  probe.connection.sendText("nobody listens");
  QCOMPARE(probe.said(), std::string());
  QVERIFY(!probe.connection.isFinished());
  probe.pass(50);
  QVERIFY(probe.connection.isFinished());
}

void ConnectionTest::clientCloses_isEchoedAndEnds() {
  Probe probe;
  probe.open();
  probe.connection.sendBinary("waits", nullptr, SendQueue::Kind::Message);
  probe.read(frame(0x88, bytesOf("03 e8") + "bye") + frame(0x81, "late"));
  QCOMPARE(probe.said(), bytesOf("88 02 03 e8"));
  QVERIFY(probe.received.empty());
  QVERIFY(probe.connection.isSendFinished());
  probe.connection.readEnd();
  QVERIFY(probe.connection.isFinished());
}

void ConnectionTest::weClose_waitsForTheAnswerOrTheTime() {
  Probe probe;
  probe.open();
  probe.connection.close(live::CloseCode::GoingAway, "over", probe.now);
  QCOMPARE(probe.said(), bytesOf("88 06 03 e9") + "over");
  QVERIFY(!probe.connection.isSendFinished() && !probe.connection.isFinished());
  probe.read(frame(0x88, bytesOf("03 e9")));
  QCOMPARE(probe.said(), std::string());
  QVERIFY(probe.connection.isSendFinished());
  probe.pass(50);
  QVERIFY(probe.connection.isFinished());
}

/// Pings without end: the answers that wait have a limit.
void ConnectionTest::slowReader_isNotReadFrom() {
  Probe probe;
  probe.open();
  int count = 0;
  while (probe.connection.canRead() && count < 100000) {
    probe.read(frame(0x89, "x"));
    ++count;
  }
  QCOMPARE(count, (256 * 1024) / (3 + 128) + 1);
  probe.said();
  QVERIFY(probe.connection.canRead());
}

void ConnectionTest::clientVanishes_ends() {
  Probe probe;
  probe.open();
  probe.connection.sendText("waits");
  probe.connection.readEnd();
  QVERIFY(!probe.connection.isOpen());
  QVERIFY(probe.connection.isFinished());
}

QTEST_APPLESS_MAIN(ConnectionTest)
#include "tst_Connection.moc"
