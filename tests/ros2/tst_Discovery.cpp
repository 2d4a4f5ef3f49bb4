#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/std_msgs.h"
#include "tests/ros2/Ros2Test.h"

using namespace ros2test;

/// Discovery of participants and publishers of other programs. In a process of its own: Fast DDS
/// numbers the participants of a process, and finds only the first ones on the loopback interface.
class DiscoveryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void topic_anyPublisher_isHeardOnce_data() {
    QTest::addColumn<bool>("latched");
    QTest::newRow("volatile") << false;
    QTest::newRow("latched") << true;
  }

  /// DDS matches no reliable reader with a publisher that is not, no latched one with one that is
  /// not: `Qos::anyPublisher` receives from all of them, and every message once.
  void topic_anyPublisher_isHeardOnce() {
    constexpr int kDomain = 63;
    QFETCH(const bool, latched);
    const auto reader = participant(inDomain(kDomain)), writer = participant(inDomain(kDomain));
    const int to = reader->addNode("/", "reader"), from = writer->addNode("/", "writer");
    Qos wanted = Qos::input(100);
    wanted.transientLocal = latched;
    std::map<std::string, int> heard;
    const auto subscription =
        reader->subscription(to, "mixed", "std_msgs/msg/String", wanted,
                             [&heard](const Bytes& bytes) { ++heard[textIn(bytes)]; });
    QVERIFY(static_cast<bool>(subscription));
    const Qos offers[] = {Qos::keepLast(10), Qos::sensor(), Qos::latched()};
    const char* const names[] = {"reliable", "best effort", "latched"};
    std::vector<std::unique_ptr<Publisher>> publishers;
    for (const Qos& offer : offers) {
      auto made = writer->publisher(from, "mixed", "std_msgs/msg/String", offer);
      QVERIFY(static_cast<bool>(made));
      publishers.push_back(*std::move(made));
    }
    QVERIFY(spinBoth(*reader, *writer, [&] {
      return (*subscription)->matched() == 3 &&
             std::all_of(publishers.begin(), publishers.end(),
                         [](const auto& each) { return each->matched() >= 1; });
    }));
    spinBoth(*reader, *writer, [begin = std::chrono::steady_clock::now()] {
      return std::chrono::steady_clock::now() - begin > Milliseconds(500);
    });
    for (int k = 0; k < 20; ++k) {
      for (std::size_t i = 0; i < publishers.size(); ++i) {
        QVERIFY(publishers[i]->publish(encodedText(names[i] + std::to_string(k))));
      }
      reader->spin(Milliseconds(5));
    }
    QVERIFY(spinBoth(*reader, *writer, [&] { return heard.size() == 60; }));
    while (reader->spin(Milliseconds(200))) {  // samples that would arrive twice
    }
    QCOMPARE(heard.size(), std::size_t{60});
    for (const auto& [words, times] : heard) {
      QVERIFY2(times == 1, words.c_str());
    }
  }

  void others_areMet() {
    constexpr int kEmptyDomain = 60;
    const auto one = participant(inDomain(kEmptyDomain));
    QVERIFY(!one->hasDiscoveredPeers());
    one->spin(Milliseconds(300));
    QVERIFY(!one->hasDiscoveredPeers());
    auto two = participant(inDomain(kEmptyDomain));
    QVERIFY(spinBoth(*one, *two,
                     [&] { return one->hasDiscoveredPeers() && two->hasDiscoveredPeers(); }));
    two.reset();
    one->spin(Milliseconds(300));
    QVERIFY(one->hasDiscoveredPeers());
  }
};

QTEST_APPLESS_MAIN(DiscoveryTest)
#include "tst_Discovery.moc"
