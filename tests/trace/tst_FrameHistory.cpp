#include <atomic>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/trace/FrameHistory.h"
#include "tests/support/FullDisk.h"
#include "tests/trace/WildRun.h"

using namespace sim2d;

namespace {

constexpr int kPeople = 30;
constexpr std::size_t kMega = std::size_t{1} << 20;

void appendTo(FrameHistory& history, std::size_t upTo) {
  while (history.size() < upTo) {
    history.append(wild::frameAt(static_cast<std::int64_t>(history.size()), kPeople));
  }
}

bool isRight(const FramePtr& frame, std::size_t index) {
  return frame != nullptr &&
         wild::isSameState(*frame, wild::frameAt(static_cast<std::int64_t>(index), kPeople));
}

/// All that are kept, forwards and backwards, and none of the others.
void checkAll(const FrameHistory& history) {
  const std::size_t first = history.first();
  for (std::size_t k = first; k < history.size(); ++k) {
    QVERIFY2(isRight(history.frame(k), k), QByteArray::number(int(k)));
  }
  for (std::size_t k = history.size(); k-- > first;) {
    QVERIFY2(isRight(history.frame(k), k), QByteArray::number(int(k)));
  }
  for (std::size_t k = 0; k < first; ++k) {
    QVERIFY(history.frame(k) == nullptr);
  }
  QVERIFY(history.frame(history.size()) == nullptr);
}

std::vector<FramePtr> wildFrames(std::int64_t from, int count, int people) {
  std::vector<FramePtr> frames;
  frames.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    frames.push_back(std::make_shared<const Frame>(wild::frameAt(from + k, people)));
  }
  return frames;
}

}  // namespace

class FrameHistoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void frame_anyIndex_isWhatWasAppended_data() {
    QTest::addColumn<qulonglong>("memory");
    QTest::newRow("in memory") << qulonglong{64 * kMega};
    QTest::newRow("both") << qulonglong{kMega};
    QTest::newRow("on disk") << qulonglong{0};
  }

  void frame_anyIndex_isWhatWasAppended() {
    QFETCH(qulonglong, memory);
    FrameHistory history(memory);
    QCOMPARE(history.size(), std::size_t{0});
    QVERIFY(history.frame(0) == nullptr);
    appendTo(history, 600);
    QCOMPARE(history.size(), std::size_t{600});
    QCOMPARE(history.first(), std::size_t{0});
    QCOMPARE(history.disk() > 0, memory <= kMega);
    checkAll(history);
    QVERIFY(!history.problem());
  }

  void append_longRun_staysWithinItsMemory() {
    FrameHistory history(kMega);
    for (const std::size_t size : {100U, 1000U, 3000U}) {
      while (history.size() < size) {
        appendTo(history, history.size() + 1);
        history.frame(history.size() / 3);
        QVERIFY2(history.memory() <= kMega, QByteArray::number(qulonglong(history.memory())));
      }
      QVERIFY(isRight(history.frame(1), 1));
    }
    QVERIFY(history.disk() > 3 * kMega);  // noise takes nearly as much as it did
    QCOMPARE(history.first(), std::size_t{0});
  }

  void file_whileItIsUsed_hasNoName() {
    const QTemporaryDir folder;
    FrameHistory history(0, folder.path().toStdString());
    appendTo(history, 50);
    QVERIFY(history.disk() > 0);
    QVERIFY(!history.problem());
    QVERIFY(QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
  }

  void frame_readAgain_isNotUnpackedAgain() {
    FrameHistory history(16 * kMega);
    appendTo(history, 400);
    const FramePtr frame = history.frame(70);
    QVERIFY(history.frame(71) != frame);
    QCOMPARE(history.frame(70).get(), frame.get());
  }

  void append_folderIsNotThere_dropsTheOldest() {
    const QTemporaryDir folder;
    FrameHistory history(kMega, (folder.path() + QStringLiteral("/none")).toStdString());
    appendTo(history, 40);
    QVERIFY(!history.problem());  // nothing was to be put there yet
    std::size_t before = 0;
    for (const std::size_t size : {600U, 900U, 1200U}) {
      appendTo(history, size);
      QVERIFY(history.first() > before && history.first() < size);
      before = history.first();
      QVERIFY(history.memory() <= kMega);
      QCOMPARE(history.disk(), std::size_t{0});
      checkAll(history);
    }
    QVERIFY(history.problem() == std::errc::no_such_file_or_directory);
  }

  void append_diskIsFull_writesOverTheOldest() {
    const support::FullDisk disk(2 * kMega);
    FrameHistory history(kMega);
    std::size_t before = 0;
    for (const std::size_t size : {1500U, 2200U, 2900U, 3600U}) {
      appendTo(history, size);
      QVERIFY(history.first() > before && history.first() < size);
      before = history.first();
      QVERIFY(history.memory() <= kMega);
      QVERIFY(history.disk() <= 2 * kMega);
      QVERIFY(history.disk() > kMega);  // it is used on
      checkAll(history);
    }
    QVERIFY(history.problem() == std::errc::file_too_large);
  }

  void append_diskIsFullFromTheStart_dropsTheOldest() {
    FrameHistory history(kMega);
    {
      const support::FullDisk disk;
      appendTo(history, 900);
      QVERIFY(history.problem());
      QCOMPARE(history.disk(), std::size_t{0});
      checkAll(history);
    }
    appendTo(history, 1300);  // there is room again
    QVERIFY(history.disk() > 0);
    checkAll(history);
  }

  void read_whileTheOldestAreDropped_seesWholeStatesOrNone() {
    const support::FullDisk disk(kMega);
    FrameHistory history(kMega / 2);
    constexpr std::size_t kSize = 3000;
    std::atomic<bool> isWrong{false};
    const auto read = [&](std::size_t stride) {
      while (history.size() < kSize) {
        const std::size_t size = history.size();
        for (std::size_t k = history.first(); k < size; k += stride) {
          const FramePtr frame = history.frame(k);
          isWrong = isWrong || (frame == nullptr ? history.first() <= k : !isRight(frame, k));
        }
      }
    };
    std::thread near(read, 13), far(read, 101);
    appendTo(history, kSize);
    near.join();
    far.join();
    QVERIFY(!isWrong);
    QVERIFY(history.first() > 0);
  }

  void unpack_anyStates_areEqualBitByBit_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("people");
    QTest::addColumn<double>("interval");
    QTest::newRow("none") << 0 << 5 << 0.05;
    QTest::newRow("one") << 1 << 5 << 0.0;
    QTest::newRow("nobody") << 10 << 0 << 0.05;
    QTest::newRow("few") << 200 << 3 << 0.05;
    QTest::newRow("crowd") << 64 << 150 << 0.05;
    QTest::newRow("no interval") << 64 << 20 << 0.0;
  }

  void unpack_anyStates_areEqualBitByBit() {
    QFETCH(int, count);
    QFETCH(int, people);
    QFETCH(double, interval);
    const std::vector<FramePtr> frames = wildFrames(17, count, people);
    const std::vector<FramePtr> found = unpackFrames(packFrames(frames, interval));
    QCOMPARE(found.size(), frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
      QVERIFY2(wild::isSameState(*found[k], *frames[k]), QByteArray::number(int(k)));
    }
  }

  /// Without forces everybody goes on as before: of the 14 numbers of each only the lengths are
  /// kept, four bits each. A fixed part of a state comes to it.
  void pack_straightWalk_takesHalfAByteForANumber() {
    constexpr int kCrowd = 100, kStates = 64;
    constexpr double kInterval = 0.05;  // [s]
    std::vector<FramePtr> frames;
    Frame frame;
    for (int id = 1; id <= kCrowd; ++id) {
      const Vec2 velocity(0.01 * id, 1.0 - 0.003 * id);
      frame.humans.add(id, {Vec2(0.3 * id, -0.7 * id), base::headingOf(velocity)}, velocity, 0.0,
                       1);
      frame.humans.group.push_back(-1);
      frame.humans.state.push_back(0);
      for (std::vector<Vec2>* force : {&frame.forces.goal, &frame.forces.social,
                                       &frame.forces.obstacle, &frame.forces.group}) {
        force->emplace_back(0.0, 0.0);
      }
    }
    for (int k = 0; k < kStates; ++k) {
      frames.push_back(std::make_shared<const Frame>(frame));
      ++frame.step;
      for (std::size_t i = 0; i < frame.humans.size(); ++i) {
        frame.humans.x[i] += frame.humans.vx[i] * kInterval;
        frame.humans.y[i] += frame.humans.vy[i] * kInterval;
      }
    }
    const std::size_t first = packFrames({frames.front()}, kInterval).size();
    const std::size_t all = packFrames(frames, kInterval).size();
    const double perState = static_cast<double>(all - first) / (kStates - 1);
    QVERIFY2(perState >= 7.0 * kCrowd && perState < 7.0 * kCrowd + 100.0,
             QByteArray::number(perState));
  }

  void unpack_bytesThatEndEarly_doesNotReadOn() {
    const std::string bytes = packFrames(wildFrames(3, 6, 4), 0.05);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const std::string cut = bytes.substr(0, size);  // sanitizers see its end
      QVERIFY(unpackFrames(cut).size() <= 6);
    }
  }
};

QTEST_APPLESS_MAIN(FrameHistoryTest)
#include "tst_FrameHistory.moc"
