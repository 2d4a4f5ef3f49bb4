#include <atomic>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "WildRun.h"
#include "sim2d/trace/FrameHistory.h"
#include "tests/support/FullDisk.h"

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

}  // namespace

class FrameHistoryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void frame_anyIndex_isWhatWasAppended_data();
  void frame_anyIndex_isWhatWasAppended();
  void append_longRun_staysWithinItsMemory();
  void file_whileItIsUsed_hasNoName();
  void frame_readAgain_isNotUnpackedAgain();
  void append_folderIsNotThere_dropsTheOldest();
  void append_diskIsFull_writesOverTheOldest();
  void append_diskIsFullFromTheStart_dropsTheOldest();
  void read_whileTheOldestAreDropped_seesWholeStatesOrNone();
};

void FrameHistoryTest::frame_anyIndex_isWhatWasAppended_data() {
  QTest::addColumn<qulonglong>("memory");
  QTest::newRow("in memory") << qulonglong{64 * kMega};
  QTest::newRow("both") << qulonglong{kMega};
  QTest::newRow("on disk") << qulonglong{0};
}

void FrameHistoryTest::frame_anyIndex_isWhatWasAppended() {
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

void FrameHistoryTest::append_longRun_staysWithinItsMemory() {
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

void FrameHistoryTest::file_whileItIsUsed_hasNoName() {
  const QTemporaryDir folder;
  FrameHistory history(0, folder.path().toStdString());
  appendTo(history, 50);
  QVERIFY(history.disk() > 0);
  QVERIFY(!history.problem());
  QVERIFY(QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
}

void FrameHistoryTest::frame_readAgain_isNotUnpackedAgain() {
  FrameHistory history(16 * kMega);
  appendTo(history, 400);
  const FramePtr frame = history.frame(70);
  QVERIFY(history.frame(71) != frame);
  QCOMPARE(history.frame(70).get(), frame.get());
}

void FrameHistoryTest::append_folderIsNotThere_dropsTheOldest() {
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

void FrameHistoryTest::append_diskIsFull_writesOverTheOldest() {
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

void FrameHistoryTest::append_diskIsFullFromTheStart_dropsTheOldest() {
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

void FrameHistoryTest::read_whileTheOldestAreDropped_seesWholeStatesOrNone() {
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

QTEST_APPLESS_MAIN(FrameHistoryTest)
#include "tst_FrameHistory.moc"
