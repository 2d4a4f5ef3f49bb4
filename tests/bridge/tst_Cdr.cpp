#include <QtTest>

#include "app/bridge/messages/AllMessages.h"
#include "app/bridge/messages/Codec.h"
#include "tests/bridge/Golden.h"
#include "tests/support/Mutator.h"

using namespace bridge;

namespace {

/// A message of nothing but what a case needs.
template <class A, class B>
struct Pair {
  static constexpr const char* kType = "test_msgs/msg/Pair";
  A first{};
  B second{};
  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("first", self.first);
    field("second", self.second);
  }
};

std::string bytesOf(const char* hex) {
  return QByteArray::fromHex(hex).toStdString();
}

template <class M>
QByteArray hexOf(const M& message) {
  return QByteArray::fromStdString(encode(message)).toHex();
}

template <class M>
std::string codeOf(const std::string& bytes) {
  const base::Result<M> read = decode<M>(bytes);
  return read ? "" : std::string(read.diagnostics().front().code);
}

/// What is read is written again as it was.
template <class... M>
void readAsAll(const std::string& bytes, TypeList<M...> /*list*/) {
  (static_cast<void>(decode<M>(bytes)), ...);
}

}  // namespace

class CdrTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void encode_goldenAgents_sameBytes() {
    QCOMPARE(static_cast<int>(goldenBytes().size()), 308);
    QCOMPARE(hexOf(goldenAgents()), QByteArray::fromStdString(goldenBytes()).toHex());
  }

  /// The same bytes whatever is expected, and no more room than they take when that is right.
  void encode_expectedLength_isJustEnough() {
    nav_msgs::Odometry odometry;
    odometry.childFrameId = "base_footprint";
    hunav_msgs::Agents agents;
    agents.agents.resize(50, goldenAgents().agents.front());
    const auto verify = [](const auto& message) {
      const std::string bytes = encode(message);
      for (const std::size_t expected : {std::size_t{1}, bytes.size() - 1, 2 * bytes.size()}) {
        QVERIFY(encode(message, expected) == bytes);
      }
      const std::string fitting = encode(message, bytes.size());
      QVERIFY(fitting == bytes);
      QCOMPARE(fitting.capacity(), bytes.size());
    };
    verify(odometry);
    verify(agents);
  }

  void decode_goldenBytes_sameValues() {
    const base::Result<hunav_msgs::Agents> read = decode<hunav_msgs::Agents>(goldenBytes());
    QVERIFY(static_cast<bool>(read));
    QCOMPARE(read->header.stamp.sec, 12);
    QCOMPARE(read->header.stamp.nanosec, 500000000U);
    QCOMPARE(read->header.frameId, std::string("map"));
    QCOMPARE(read->agents.size(), std::size_t{1});
    const hunav_msgs::Agent& anna = read->agents.front();
    QCOMPARE(anna.name, std::string("anna"));
    QCOMPARE(anna.groupId, std::int8_t{-1});
    QCOMPARE(anna.position.position.y, -2.0);
    QCOMPARE(anna.position.orientation.w, 0.8);
    QCOMPARE(anna.velocity.angular.z, 0.25);
    QCOMPARE(anna.behavior.otherForceFactor, 20.0F);
    QCOMPARE(anna.goals.front().position.x, 4.0);
    QCOMPARE(anna.closestObs.front().z, 3.0);
    QCOMPARE(encode(*read), goldenBytes());
  }

  void encode_numbers_areAlignedToTheirSize() {
    QCOMPARE(hexOf(Pair<std::uint8_t, double>{1, 1.0}), QByteArray("00010000"
                                                                   "0100000000000000"
                                                                   "000000000000f03f"));
    QCOMPARE(hexOf(Pair<bool, std::int16_t>{true, -2}), QByteArray("000100000100feff"));
    QCOMPARE(hexOf(Pair<std::string, std::uint32_t>{"ab", 7}),
             QByteArray("00010000"
                        "030000006162000007000000"));
  }

  void encode_sequences_haveNoPaddingWhenEmpty() {
    QCOMPARE(hexOf(Pair<std::vector<double>, std::uint8_t>{{}, 9}), QByteArray("00010000"
                                                                               "0000000009"));
    QCOMPARE(hexOf(Pair<std::vector<double>, std::uint8_t>{{1.0}, 9}),
             QByteArray("00010000"
                        "0100000000000000000000000000f03f09"));
    QCOMPARE(hexOf(Pair<std::array<std::uint16_t, 2>, bool>{{{1, 2}}, true}),
             QByteArray("00010000"
                        "0100020001"));
  }

  void encode_emptyMessage_isOneByte() {
    QCOMPARE(hexOf(std_msgs::Empty{}), QByteArray("0001000000"));
    QCOMPARE(hexOf(std_srvs::Empty::Request{}), QByteArray("0001000000"));
    QVERIFY(static_cast<bool>(decode<std_srvs::Empty::Request>(bytesOf("0001000000000000"))));
  }

  void decode_bigEndian_isTurnedRound() {
    const auto read =
        decode<std_msgs::Header>(bytesOf("00000000"
                                         "0000000c1dcd650000000004"
                                         "6d617000"));
    QVERIFY(static_cast<bool>(read));
    QCOMPARE(read->stamp.sec, 12);
    QCOMPARE(read->stamp.nanosec, 500000000U);
    QCOMPARE(read->frameId, std::string("map"));
    const auto numbers =
        decode<Pair<std::vector<float>, bool>>(bytesOf("00000000"
                                                       "000000023f80000040000000"
                                                       "01"));
    QVERIFY(static_cast<bool>(numbers));
    QCOMPARE(numbers->first, (std::vector<float>{1.0F, 2.0F}));
  }

  void decode_padding_isLeftAlone() {
    for (const char* padding : {"", "00", "0000", "000000"}) {
      QCOMPARE(codeOf<std_msgs::String>(bytesOf("00010000020000006100") + bytesOf(padding)),
               std::string());
    }
    const std::string tooLong = bytesOf("0001000002000000610000000000");
    QCOMPARE(codeOf<std_msgs::String>(tooLong), std::string("cdr.rest"));
    QVERIFY(static_cast<bool>(decode<std_msgs::String>(tooLong, TrailingBytes::Ignored)));
  }

  void decode_textOfLengthZero_isEmpty() {
    const auto read = decode<std_msgs::String>(bytesOf("0001000000000000"));
    QVERIFY(static_cast<bool>(read));
    QVERIFY(read->data.empty());
  }

  void decode_wrongBytes_areToldByCode_data() {
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<QByteArray>("code");
    QTest::newRow("nothing") << QByteArray() << QByteArray("cdr.no-encapsulation");
    QTest::newRow("head cut") << QByteArray("000100") << QByteArray("cdr.no-encapsulation");
    QTest::newRow("parameter list") << QByteArray("00030000") << QByteArray("cdr.encapsulation");
    QTest::newRow("no length") << QByteArray("000100000200") << QByteArray("cdr.too-short");
    QTest::newRow("cut") << QByteArray("000100000400000061") << QByteArray("cdr.bad-length");
    QTest::newRow("huge") << QByteArray("00010000ffffffff") << QByteArray("cdr.bad-length");
    QTest::newRow("open") << QByteArray("00010000010000006100") << QByteArray("cdr.open-text");
  }
  void decode_wrongBytes_areToldByCode() {
    QFETCH(QByteArray, hex);
    QFETCH(QByteArray, code);
    QCOMPARE(codeOf<std_msgs::String>(bytesOf(hex)), code.toStdString());
  }

  void decode_wrongValues_areToldByCode() {
    QCOMPARE((codeOf<std_srvs::SetBool::Request>(bytesOf("0001000002"))),
             std::string("cdr.bad-bool"));
    // Bytes as long as the message says, a bound that is broken.
    QCOMPARE((codeOf<Pair<BoundedString<2>, bool>>(bytesOf("00010000"
                                                           "04000000"
                                                           "6162630001"))),
             std::string("cdr.bad-length"));
    QCOMPARE((codeOf<Pair<BoundedString<3>, bool>>(bytesOf("00010000"
                                                           "04000000"
                                                           "6162630001"))),
             std::string());
    QCOMPARE((codeOf<Pair<BoundedSequence<std::uint8_t, 1>, bool>>(bytesOf("00010000"
                                                                           "020000000000"
                                                                           "01"))),
             std::string("cdr.bad-length"));
  }

  void decode_everyCutOfTheGoldenBytes_isAnError() {
    const std::string whole = goldenBytes();
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const base::Result<hunav_msgs::Agents> read =
          decode<hunav_msgs::Agents>(std::string_view(whole).substr(0, size));
      QVERIFY2(!read, std::to_string(size).c_str());
    }
  }

  void decode_lengthsOfAll32Bits_areErrorsEverywhere() {
    const std::string whole = goldenBytes();
    for (std::size_t at = 4; at + 4 <= whole.size(); at += 4) {
      std::string bytes = whole;
      bytes.replace(at, 4, "\xff\xff\xff\xff", 4);
      readAsAll(bytes, AllMessages{});
    }
    std::string goals = whole;
    goals.replace(16, 4, std::string("\xff\xff\xff\xff", 4));  // length of the frame's name: "map"
    QVERIFY(!codeOf<hunav_msgs::Agents>(goals).empty());
  }

  void decode_damagedBytes_neverCrashes() {
    Mutator mutator(7);
    const std::string whole = goldenBytes();
    for (int i = 0; i < 2000; ++i) {
      const std::string bytes = mutator.mutated(whole);
      readAsAll(bytes, AllMessages{});
      const auto read = decode<hunav_msgs::Agents>(bytes);
      if (read) {  // then it is such a message, and writing it loses nothing
        const std::string again = encode(*read);
        const auto twice = decode<hunav_msgs::Agents>(again);
        QVERIFY(static_cast<bool>(twice));
        QCOMPARE(encode(*twice), again);
      }
    }
  }

  void problem_namesTypeAndField() {
    std::string bytes = goldenBytes();
    bytes.resize(60);
    const auto read = decode<hunav_msgs::Agents>(bytes);
    QVERIFY(!read);
    QCOMPARE(read.diagnostics().front().value("type"), std::string("hunav_msgs/msg/Agents"));
    QVERIFY(!read.diagnostics().front().value("field").empty());
  }
};

QTEST_APPLESS_MAIN(CdrTest)
#include "tst_Cdr.moc"
