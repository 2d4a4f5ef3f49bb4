#include <limits>

#include <QtTest>

#include "app/studies/EliteArchive.h"

using app::Descriptor;
using app::EliteArchive;

namespace {

EliteArchive archive() {
  return EliteArchive({Descriptor{"a", 0.0, 10.0, 5}, Descriptor{"b", -1.0, 1.0, 4}});
}

}  // namespace

/// The archive of MAP-Elites; all cells were calculated by hand.
class EliteArchiveTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cellOf_valueInRange_isCountedFromTheLowEnd_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("cell");
    QTest::newRow("low end") << 0.0 << 0;
    QTest::newRow("inside the first") << 1.99 << 0;
    QTest::newRow("boundary belongs to the upper cell") << 2.0 << 1;
    QTest::newRow("middle") << 5.5 << 2;
    QTest::newRow("high end belongs to the last cell") << 10.0 << 4;
    QTest::newRow("below") << -3.0 << 0;
    QTest::newRow("above") << 1e300 << 4;
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 4;
    QTest::newRow("undefined") << std::numeric_limits<double>::quiet_NaN() << -1;
  }
  void cellOf_valueInRange_isCountedFromTheLowEnd() {
    QFETCH(double, value);
    QFETCH(int, cell);
    QCOMPARE((Descriptor{"a", 0.0, 10.0, 5}.cellOf(value)), cell);
  }

  void parseDescriptor_textWithFourParts_isRead() {
    const auto descriptor = app::parseDescriptor("total_time:0:60.5:12");
    QVERIFY(descriptor.has_value());
    QCOMPARE(descriptor->key, std::string("total_time"));
    QCOMPARE(descriptor->high, 60.5);
    QCOMPARE(descriptor->cells, 12);
    for (const char* wrong :
         {"", "total_time", "total_time:0:1", "total_time:1:0:3", ":0:1:3", "total_time:0:1:0",
          "total_time:0:1:1001", "total_time:0:inf:3", "total_time:0:1:3:4", "total_time:x:1:3"}) {
      QVERIFY2(!app::parseDescriptor(wrong), wrong);
    }
  }

  void add_runs_keepsTheBestOfEachCell() {
    EliteArchive kept = archive();
    auto change = kept.add({0, 1.5, {3.0, 0.2}});  // cell 1, 2
    QVERIFY(change && change->isNewCell);
    QCOMPARE(change->improvement, 1.5);
    QVERIFY(!kept.add({1, 1.0, {3.9, 0.4}}));  // the same cell, worse
    QVERIFY(!kept.add({2, 1.5, {2.0, 0.0}}));  // the same cell, as good
    change = kept.add({3, 4.0, {2.5, 0.49}});
    QVERIFY(change && !change->isNewCell);
    QCOMPARE(change->improvement, 2.5);
    QVERIFY(kept.add({4, -7.0, {4.0, 0.2}})->isNewCell);  // cell 2, 2
    QCOMPARE(kept.elites().size(), std::size_t{2});
    QVERIFY((kept.elites().begin()->first == EliteArchive::Cell{1, 2}));
    QCOMPARE(kept.runs()[0], std::size_t{3});
    QCOMPARE(kept.runs()[1], std::size_t{4});
  }

  void improvementRanks_newCellsFirst_thenImprovements() {
    using Change = EliteArchive::Change;
    const std::vector<std::optional<Change>> changes = {
        std::nullopt, Change{false, 9.0}, Change{true, 1.0}, std::nullopt, Change{true, 2.0}};
    const std::vector<double> fitness = {5.0, 20.0, 1.0, 6.0, 2.0};
    QCOMPARE(app::improvementRanks(changes, fitness), (std::vector<std::size_t>{4, 2, 1, 3, 0}));
  }
};

QTEST_APPLESS_MAIN(EliteArchiveTest)
#include "tst_EliteArchive.moc"
