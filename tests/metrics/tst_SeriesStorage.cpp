#include <QtTest>

#include "metrics/Instant.h"
#include "tests/support/FullDisk.h"

using namespace metrics;

namespace {

double numberAt(std::size_t k) {
  return 0.1 * static_cast<double>(k) - 7.0;
}

void check(const StoredSeries& numbers, std::size_t count) {
  QCOMPARE(numbers.size(), count);
  const std::vector<double> all = numbers.all();
  QCOMPARE(all.size(), count);
  StoredSeriesReader reader(numbers);
  for (std::size_t k = 0; k < count; ++k) {
    QCOMPARE(all[k], numberAt(k));
    QCOMPARE(reader.next(), numberAt(k));
  }
}

}  // namespace

/// Numbers that wait on the disk.
class SeriesStorageTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void add_manyNumbers_areReadBack_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("onDisk");
    for (const int count : {0, 1, 511, 512, 513, 5000}) {
      QTest::addRow("%d", count) << count << true;
      QTest::addRow("%d, in memory", count) << count << false;
    }
  }

  void add_manyNumbers_areReadBack() {
    QFETCH(int, count);
    QFETCH(bool, onDisk);
    SeriesStorage store;
    StoredSeries numbers;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      numbers.add(numberAt(k), onDisk ? &store : nullptr);
    }
    check(numbers, static_cast<std::size_t>(count));
    QVERIFY(!store.hasFailed());
  }

  void add_twoLists_shareAStore() {
    SeriesStorage store;
    StoredSeries first;
    StoredSeries second;
    for (std::size_t k = 0; k < 2000; ++k) {
      first.add(numberAt(k), &store);
      if (k % 2 == 0) {
        second.add(numberAt(k / 2), &store);
      }
    }
    check(first, 2000);
    check(second, 1000);
  }

  void add_diskIsFull_staysInMemory() {
    SeriesStorage store;
    StoredSeries numbers;
    for (std::size_t k = 0; k < 600; ++k) {
      numbers.add(numberAt(k), &store);
    }
    {
      const support::FullDisk full;
      for (std::size_t k = 600; k < 1800; ++k) {
        numbers.add(numberAt(k), &store);
      }
    }
    for (std::size_t k = 1800; k < 2500; ++k) {
      numbers.add(numberAt(k), &store);
    }
    check(numbers, 2500);
    QVERIFY(!store.hasFailed());
  }

  void get_nothingThere_isAFailure() {
    SeriesStorage store;
    double number = 0.0;
    QVERIFY(!store.get({8000, sizeof(number)}, &number));
    QVERIFY(store.hasFailed());
  }
};

QTEST_APPLESS_MAIN(SeriesStorageTest)
#include "tst_SeriesStorage.moc"
