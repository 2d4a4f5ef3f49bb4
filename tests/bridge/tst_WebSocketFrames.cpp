#include <string>
#include <vector>

#include <QtTest>

#include "app/bridge/live/WebSocketFrames.h"
#include "tests/bridge/ClientFrames.h"

using client::bytesOf;
using live::CloseCode;
using live::FrameReader;
using live::Opcode;

namespace {

struct Read {
  std::vector<live::WebSocketMessage> messages;
  int violation = 0;  // its close code
};

/// All in pieces of that size.
Read readOf(const std::string& bytes, std::size_t piece, std::size_t largest = 1000) {
  FrameReader reader(largest);
  Read read;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    const auto wrong = reader.read(bytes.substr(at, piece), [&](live::WebSocketMessage&& message) {
      read.messages.push_back(std::move(message));
      return true;
    });
    if (wrong) {
      read.violation = static_cast<int>(wrong->code);
      break;
    }
  }
  return read;
}

std::string onlyText(const Read& read) {
  return read.violation == 0 && read.messages.size() == 1 ? read.messages[0].payload : "?";
}

}  // namespace

class WebSocketFramesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void frames_ofTheServer_areThoseOfTheRfc();
  void read_framesOfTheRfc_areUnderstood();
  void read_piecesOfAnySize_giveTheSame();
  void read_controlBetweenFragments_comesFirst();
  void read_afterTheTakerHasEnough_nothingIsRead();
  void read_violation_hasItsCode_data();
  void read_violation_hasItsCode();
  void read_closeCodes_areThoseOfTheRfc_data();
  void read_closeCodes_areThoseOfTheRfc();
  void isUtf8_knownTexts_areJudged_data();
  void isUtf8_knownTexts_areJudged();
  void isUtf8_everyCodePoint_isJudgedAsQtDoes();
};

/// RFC 6455, 5.7.
void WebSocketFramesTest::frames_ofTheServer_areThoseOfTheRfc() {
  QCOMPARE(live::wholeFrame(Opcode::Text, "Hello"), bytesOf("81 05 48 65 6c 6c 6f"));
  QCOMPARE(live::wholeFrame(Opcode::Ping, "Hello"), bytesOf("89 05 48 65 6c 6c 6f"));
  QCOMPARE(live::frameHead(Opcode::Binary, 256), bytesOf("82 7e 01 00"));
  QCOMPARE(live::frameHead(Opcode::Binary, 65536), bytesOf("82 7f 00 00 00 00 00 01 00 00"));
  QCOMPARE(live::frameHead(Opcode::Binary, 125), bytesOf("82 7d"));
  QCOMPARE(live::frameHead(Opcode::Binary, 126), bytesOf("82 7e 00 7e"));
  QCOMPARE(live::frameHead(Opcode::Binary, 65535), bytesOf("82 7e ff ff"));
  QCOMPARE(live::closeFrame(CloseCode::Normal, "ok"), bytesOf("88 04 03 e8 6f 6b"));
  QCOMPARE(live::closeFrame(CloseCode::Normal, std::string(500, 'x')).size(), std::size_t{127});
  // 123 bytes are left for the reason: 41 characters of 3 fit, the 42nd would be cut
  const std::string euros = QString(60, QChar(0x20AC)).toStdString();
  QCOMPARE(live::closeFrame(CloseCode::Normal, "x" + euros).size(), std::size_t{4 + 1 + 120});
}

/// The same, masked; the second in two fragments.
void WebSocketFramesTest::read_framesOfTheRfc_areUnderstood() {
  QCOMPARE(onlyText(readOf(bytesOf("81 85 37 fa 21 3d 7f 9f 4d 51 58"), 100)),
           std::string("Hello"));
  QCOMPARE(onlyText(readOf(client::frame(0x01, "Hel") + client::frame(0x80, "lo"), 100)),
           std::string("Hello"));
  const Read pong = readOf(bytesOf("8a 85 37 fa 21 3d 7f 9f 4d 51 58"), 100);
  QCOMPARE(pong.messages.size(), std::size_t{1});
  QVERIFY(pong.messages[0].opcode == Opcode::Pong);
}

void WebSocketFramesTest::read_piecesOfAnySize_giveTheSame() {
  const std::string medium(300, 'm');
  const std::string large(70000, 'l');
  const std::string all = client::frame(0x82, medium) + client::frame(0x81, "") +
                          client::frame(0x02, large) + client::frame(0x00, "") +
                          client::frame(0x80, large) + client::frame(0x89, "p");
  for (const std::size_t piece : {1U, 2U, 3U, 7U, 1000U, 1000000U}) {
    const Read read = readOf(all, piece, 1000000);
    QCOMPARE(read.violation, 0);
    QCOMPARE(read.messages.size(), std::size_t{4});
    QVERIFY(read.messages[0].opcode == Opcode::Binary && read.messages[0].payload == medium);
    QVERIFY(read.messages[1].opcode == Opcode::Text && read.messages[1].payload.empty());
    QVERIFY(read.messages[2].opcode == Opcode::Binary && read.messages[2].payload == large + large);
    QVERIFY(read.messages[3].opcode == Opcode::Ping && read.messages[3].payload == "p");
  }
}

void WebSocketFramesTest::read_controlBetweenFragments_comesFirst() {
  const Read read = readOf(
      client::frame(0x01, "a") + client::frame(0x89, "ping") + client::frame(0x80, "b"), 1000);
  QCOMPARE(read.messages.size(), std::size_t{2});
  QVERIFY(read.messages[0].opcode == Opcode::Ping && read.messages[0].payload == "ping");
  QVERIFY(read.messages[1].opcode == Opcode::Text && read.messages[1].payload == "ab");
}

void WebSocketFramesTest::read_afterTheTakerHasEnough_nothingIsRead() {
  FrameReader reader;
  int count = 0;
  const auto once = [&](live::WebSocketMessage&&) { return ++count > 1; };
  const std::string two = client::frame(0x81, "1") + client::frame(0x81, "2");
  QVERIFY(!reader.read(two, once));
  QVERIFY(!reader.read(two + bytesOf("ff ff ff"), once));
  QCOMPARE(count, 1);
}

void WebSocketFramesTest::read_violation_hasItsCode_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<int>("code");
  const auto row = [](const char* name, const std::string& bytes, int code) {
    QTest::newRow(name) << QByteArray::fromStdString(bytes) << code;
  };
  row("not masked", bytesOf("81 05 48 65 6c 6c 6f"), 1002);
  row("reserved bit", client::frame(0xC1, "x"), 1002);
  row("opcode 3", client::frame(0x83, "x"), 1002);
  row("opcode 11", client::frame(0x8B, "x"), 1002);
  row("continuation of nothing", client::frame(0x80, "x"), 1002);
  row("text within text", client::frame(0x01, "x") + client::frame(0x81, "y"), 1002);
  row("ping in fragments", client::frame(0x09, "x"), 1002);
  row("ping of 126", client::frame(0x89, std::string(126, 'x')), 1002);
  row("long form of 5", bytesOf("81 fe 00 05 00 00 00 00") + "Hello", 1002);
  row("longest form of 126", bytesOf("81 ff 00 00 00 00 00 00 00 7e"), 0);  // the mask is missing
  row("longest form of 126, masked", bytesOf("81 ff 00 00 00 00 00 00 00 7e 00 00 00 00"), 1002);
  row("length of 2^63", bytesOf("82 ff 80 00 00 00 00 00 00 00 00 00 00 00"), 1002);
  row("length of 2^63 - 1", bytesOf("82 ff 7f ff ff ff ff ff ff ff 00 00 00 00"), 1009);
  row("1001 bytes", client::frame(0x82, std::string(1001, 'x')), 1009);
  row("1000 bytes", client::frame(0x82, std::string(1000, 'x')), 0);
  row("1001 bytes in two",
      client::frame(0x02, std::string(600, 'x')) + client::frame(0x80, std::string(401, 'x')),
      1009);
  row("no UTF-8", client::frame(0x81, "\xFF"), 1007);
  row("half a character", client::frame(0x81, "\xC3"), 1007);
  row("a character in two fragments", client::frame(0x01, "\xC3") + client::frame(0x80, "\xA9"), 0);
  row("no UTF-8 in bytes", client::frame(0x82, "\xFF"), 0);
  row("close of one byte", client::frame(0x88, "x"), 1002);
  row("close with a reason of no UTF-8", client::frame(0x88, bytesOf("03 e8 ff")), 1007);
}

void WebSocketFramesTest::read_violation_hasItsCode() {
  QFETCH(const QByteArray, bytes);
  QFETCH(const int, code);
  QCOMPARE(readOf(bytes.toStdString(), 1).violation, code);
  QCOMPARE(readOf(bytes.toStdString(), 5000).violation, code);
}

void WebSocketFramesTest::read_closeCodes_areThoseOfTheRfc_data() {
  QTest::addColumn<int>("code");
  QTest::addColumn<bool>("isFine");
  for (const int fine :
       {1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010, 1011, 3000, 3999, 4000, 4999}) {
    QTest::addRow("%d", fine) << fine << true;
  }
  for (const int wrong : {0, 999, 1004, 1005, 1006, 1015, 1016, 1100, 2000, 2999, 5000, 65535}) {
    QTest::addRow("%d", wrong) << wrong << false;
  }
}

void WebSocketFramesTest::read_closeCodes_areThoseOfTheRfc() {
  QFETCH(const int, code);
  QFETCH(const bool, isFine);
  const std::string payload{static_cast<char>(code / 256), static_cast<char>(code % 256)};
  QCOMPARE(readOf(client::frame(0x88, payload), 100).violation, isFine ? 0 : 1002);
}

/// Of Markus Kuhn's stress test of decoders, as Autobahn has them (6.4 to 6.23).
void WebSocketFramesTest::isUtf8_knownTexts_areJudged_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<bool>("isFine");
  const auto row = [](const char* hex, bool isFine) {
    QTest::newRow(hex) << QByteArray::fromHex(hex) << isFine;
  };
  row("", true);
  row("ce bae1bdb9cf83cebcceb5", true);
  row("cebae1bdb9cf83cebcceb5f4908080656469746564", false);  // beyond U+10FFFF
  row("cebae1bdb9cf83cebcceb5eda080656469746564", false);    // a surrogate
  row("f48fbfbf", true);
  row("f0908080", true);
  row("f08fbfbf", false);  // overlong
  row("e0a080", true);
  row("e09fbf", false);
  row("c080", false);
  row("c1bf", false);
  row("c280", true);
  row("ed9fbf", true);
  row("ee8080", true);
  row("efbfbf", true);
  row("f8a1a1a1a1", false);
  row("80", false);
  row("c3", false);
  row("e282", false);
  row("f09f98", false);
  row("e28228", false);
  row("fe", false);
}

void WebSocketFramesTest::isUtf8_knownTexts_areJudged() {
  QFETCH(const QByteArray, text);
  QFETCH(const bool, isFine);
  QCOMPARE(live::isUtf8(text.toStdString()), isFine);
}

void WebSocketFramesTest::isUtf8_everyCodePoint_isJudgedAsQtDoes() {
  for (uint point = 0; point <= 0x10FFFF; point += point < 0x3000 ? 1 : 61) {
    const bool isSurrogate = point >= 0xD800 && point <= 0xDFFF;
    if (!isSurrogate) {
      const QByteArray text = QString::fromUcs4(&point, 1).toUtf8();
      QVERIFY2(live::isUtf8(text.toStdString()), text.toHex());
    }
  }
}

QTEST_APPLESS_MAIN(WebSocketFramesTest)
#include "tst_WebSocketFrames.moc"
