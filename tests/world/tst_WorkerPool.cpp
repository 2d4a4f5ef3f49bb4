#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include <QtTest>

#include "sim2d/world/WorkerPool.h"
#include "tests/support/Columns.h"

using sim2d::WorkerPool;

namespace {

/// Counts how often each item was worked on.
void addOne(WorkerPool& pool, std::vector<int>& done, std::size_t slice) {
  pool.parallelFor(done.size(), slice, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      ++done[i];
    }
  });
}

bool areAll(const std::vector<int>& done, int count) {
  return std::all_of(done.begin(), done.end(), [count](int each) { return each == count; });
}

}  // namespace

class WorkerPoolTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void forSlices_anyThreadsAndSlices_doEachItemOnce_data() {
    addColumns<int, int, int>({"threads", "items", "slice"});
    for (const int threads : {1, 2, 3, 8, 32}) {
      for (const int items : {0, 1, 199, 200, 1000}) {
        for (const int slice : {0, 1, 7, 512, 100000}) {
          QTest::addRow("%d threads, %d items by %d", threads, items, slice)
              << threads << items << slice;
        }
      }
    }
  }

  void forSlices_anyThreadsAndSlices_doEachItemOnce() {
    QFETCH(int, threads);
    QFETCH(int, items);
    QFETCH(int, slice);
    WorkerPool pool(threads);
    QCOMPARE(pool.threadCount(), static_cast<std::size_t>(threads));
    std::vector<int> done(static_cast<std::size_t>(items), 0);
    for (int round = 1; round <= 20; ++round) {
      addOne(pool, done, static_cast<std::size_t>(slice));
      QVERIFY(areAll(done, round));
    }
  }

  /// Longer pauses than threads wait awake, and shorter ones.
  void forSlices_afterSleep_wakesUp() {
    WorkerPool pool(4);
    std::vector<int> done(1000, 0);
    int rounds = 0;
    for (const int pause : {0, 10, 40, 50, 60, 100, 1000, 3000}) {
      for (int i = 0; i < 10; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(pause));
        addOne(pool, done, 16);
        QVERIFY(areAll(done, ++rounds));
      }
    }
  }

  void forSlices_oneSliceIsSlow_othersDoTheRest() {
    WorkerPool pool(2);
    std::atomic<int> others{0};
    bool sawOthers = false;
    pool.parallelFor(1000, 10, [&](std::size_t, std::size_t begin, std::size_t) {
      if (begin != 0) {
        ++others;
        return;
      }
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
      while (others < 99 && std::chrono::steady_clock::now() < end) {
        std::this_thread::yield();
      }
      sawOthers = others == 99;
    });
    QVERIFY(sawOthers);
  }

  void forSlices_fewItems_stayWithTheCaller() {
    WorkerPool pool(4);
    const std::thread::id caller = std::this_thread::get_id();
    bool isCaller = true;
    int calls = 0;
    pool.parallelFor(WorkerPool::kMinParallelItems - 1, 1,
                     [&](std::size_t thread, std::size_t begin, std::size_t end) {
                       isCaller = thread == 0 && std::this_thread::get_id() == caller;
                       calls += begin == 0 && end == WorkerPool::kMinParallelItems - 1 ? 1 : 0;
                     });
    QVERIFY(isCaller);
    QCOMPARE(calls, 1);
  }

  /// The memory that a thread works in is never used by two at once.
  void forSlices_thread_hasOneSliceAtATime() {
    constexpr std::size_t kThreads = 8;
    WorkerPool pool(kThreads);
    std::vector<std::atomic<int>> users(kThreads);
    std::atomic<int> clashes{0};
    for (int round = 0; round < 100; ++round) {
      pool.parallelFor(2000, 3, [&](std::size_t thread, std::size_t, std::size_t) {
        clashes += users[thread]++;
        --users[thread];
      });
    }
    QCOMPARE(clashes.load(), 0);
  }

  void rouse_withoutWork_isHarmless() {
    WorkerPool none(1);
    none.wakeThreads();
    WorkerPool pool(3);
    std::vector<int> done(500, 0);
    for (int round = 1; round <= 20; ++round) {
      pool.wakeThreads();
      pool.wakeThreads();
      std::this_thread::sleep_for(std::chrono::microseconds(round * 100));
      addOne(pool, done, 8);
      QVERIFY(areAll(done, round));
    }
    pool.wakeThreads();
  }

  void idle_afterWork_takesNoProcessor() {
    WorkerPool pool(2);
    std::vector<int> done(1000, 0);
    pool.wakeThreads();
    addOne(pool, done, 10);
    bool isIdle = false;
    for (int look = 0; look < 100 && !isIdle; ++look) {  // how soon is up to the machine
      const std::clock_t before = std::clock();          // of all threads
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      isIdle = std::clock() - before < CLOCKS_PER_SEC / 50;
    }
    QVERIFY(isIdle);
  }
};

QTEST_APPLESS_MAIN(WorkerPoolTest)
#include "tst_WorkerPool.moc"
