#include <string>
#include <vector>

#include <QtTest>

#include "app/bridge/live/WebSocketServer.h"

using live::SendQueue;
using Kind = SendQueue::Kind;

namespace {

live::SharedBytes shared(const std::string& bytes) {
  return std::make_shared<const std::string>(bytes);
}

std::string bytesOf(const SendQueue::Message& message) {
  return message.head + (message.body ? *message.body : std::string());
}

/// Takes all messages.
std::vector<std::string> taken(SendQueue& queue) {
  std::vector<std::string> all;
  while (!queue.isEmpty()) {
    all.push_back(bytesOf(queue.startFirst()));
    queue.removeFirst();
  }
  return all;
}

}  // namespace

class SendQueueTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// 1000 bytes in all, each message 100 and 128 for itself: four.
  void add_aboveTheLimit_oldestAreDropped() {
    SendQueue queue(1000);
    for (char name = 'a'; name <= 'j'; ++name) {
      queue.add({Kind::Topic, "", shared(std::string(100, name))});
    }
    QCOMPARE(queue.droppedCount(), std::size_t{6});
    QCOMPARE(taken(queue),
             (std::vector<std::string>{std::string(100, 'g'), std::string(100, 'h'),
                                       std::string(100, 'i'), std::string(100, 'j')}));
  }

  void add_whileOneIsSent_itIsKept() {
    SendQueue queue(1000);
    queue.add({Kind::Topic, "head", shared(std::string(96, 'a'))});
    const SendQueue::Message& sent = queue.startFirst();
    const char* const place = sent.head.data();
    for (char name = 'b'; name <= 'j'; ++name) {
      queue.add({Kind::Topic, "", shared(std::string(100, name))});
    }
    QVERIFY(sent.head.data() == place);
    QCOMPARE(bytesOf(sent), "head" + std::string(96, 'a'));
    queue.removeFirst();
    QCOMPARE(taken(queue), (std::vector<std::string>{std::string(100, 'h'), std::string(100, 'i'),
                                                     std::string(100, 'j')}));
  }

  void add_responses_areNeverDropped() {
    SendQueue queue(300);
    queue.add({Kind::Text, "one"});
    for (int i = 0; i < 100; ++i) {
      queue.add({Kind::Topic, "m", shared(std::string(100, 'm'))});
      queue.add({i % 2 == 0 ? Kind::Text : Kind::Response, "two"});
    }
    QVERIFY(!queue.hasManyReplies());
    const std::vector<std::string> all = taken(queue);
    QCOMPARE(all.size(), std::size_t{102});  // with the newest message
    QCOMPARE(all.front(), std::string("one"));
    QCOMPARE(all[all.size() - 2], std::string(101, 'm'));
    queue.add({Kind::Text, std::string(300000, 'x')});
    QVERIFY(queue.hasManyReplies());
    taken(queue);
    QVERIFY(!queue.hasManyReplies());
  }

  void add_oneLargeMessage_isKept() {
    SendQueue queue(1000);
    queue.add({Kind::Topic, "", shared(std::string(5000, 'a'))});
    QCOMPARE(queue.droppedCount(), std::size_t{0});
    queue.add({Kind::Topic, "", shared("b")});
    QCOMPARE(taken(queue), std::vector<std::string>{"b"});
  }
};

QTEST_APPLESS_MAIN(SendQueueTest)
#include "tst_SendQueue.moc"
