#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>

#include <QtTest>

#include "editor/document/LatestTask.h"

using namespace editor;

/// Work beside the window of which only the newest counts.
class LatestTaskTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void start_many_deliversTheFirstAndTheLast() {
    std::vector<int> delivered;
    LatestTask<int> task([&](int value) { delivered.push_back(value); });
    for (int i = 1; i <= 5; ++i) {
      task.start([i] { return i; });
    }
    task.finish();
    QVERIFY(delivered == (std::vector<int>{1, 5}));
  }

  void start_stopped_deliversNothingAndGoesOn() {
    std::vector<int> delivered;
    const auto flag = std::make_shared<base::StopFlag>();
    LatestTask<int> task([&](int value) { delivered.push_back(value); });
    flag->stop();
    task.start([flag] {
      flag->check();
      return 1;
    });
    task.start([] { return 2; });
    task.finish();
    QVERIFY(delivered == std::vector<int>{2});
    QVERIFY(!task.isBusy());
  }

  void forget_busy_deliversWhatIsRequestedAfterwards() {
    std::vector<int> delivered;
    LatestTask<int> task([&](int value) { delivered.push_back(value); });
    task.start([] { return 1; });
    task.start([] { return 2; });
    task.forget();
    task.start([] { return 3; });
    task.finish();
    QVERIFY(delivered == std::vector<int>{3});
    task.forget();  // nothing is being worked on
    task.start([] { return 4; });
    task.finish();
    QVERIFY(delivered == (std::vector<int>{3, 4}));
  }

  void abandon_busy_waitsAndDeliversNothing() {
    std::atomic<int> ended{0};
    LatestTask<int> task([](int) { QFAIL("nothing was to be delivered"); });
    for (int i = 0; i < 2; ++i) {
      task.start([&ended] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return ++ended;
      });
    }
    task.abandon();
    QCOMPARE(ended.load(), 1);  // the second had not begun
    QVERIFY(!task.isBusy());
    QTest::qWait(50);
    QCOMPARE(ended.load(), 1);
  }

  /// The work ends only because it is told to.
  void destruct_stopped_endsEndlessWork() {
    const auto flag = std::make_shared<base::StopFlag>();
    {
      LatestTask<int> task([](int) { QFAIL("nothing was to be delivered"); });
      task.start([flag]() -> int {
        while (true) {
          flag->check();
        }
      });
      flag->stop();
    }
    QVERIFY_EXCEPTION_THROWN(flag->check(), base::Stopped);
  }
};

QTEST_GUILESS_MAIN(LatestTaskTest)
#include "tst_LatestTask.moc"
