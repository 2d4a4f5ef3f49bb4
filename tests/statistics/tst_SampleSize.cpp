#include <QtTest>

#include "metrics/statistics/PairedTests.h"
#include "tests/statistics/Near.h"

using namespace statistics;

class SampleSizeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// By hand: (1.95996 √0.6 + 0.84162 √(0.6 - 0.36))² / 0.36 = 10.35;
  /// (1.95996 √0.4 + 0.84162 √(0.4 - 0.04))² / 0.04 = 76.09.
  void pairsForMcNemar_byHand_isEqual() {
    QCOMPARE(pairsForMcNemar(0.6, 0.0), 11.0);
    QCOMPARE(pairsForMcNemar(0.3, 0.1), 77.0);
    QCOMPARE(pairsForMcNemar(0.1, 0.3), 77.0);
  }

  /// With five pairs no p is below 2 / 2^5.
  void pairsForMcNemar_edgeCases_areAsSaid() {
    QCOMPARE(pairsForMcNemar(1.0, 0.0), 6.0);
    QCOMPARE(pairsForMcNemar(0.0, 1.0, {0.01, 0.8}), 8.0);
    QVERIFY(std::isnan(pairsForMcNemar(0.2, 0.2)));
    QVERIFY(std::isnan(pairsForMcNemar(kUndefined, 0.2)));
  }

  /// By hand: (1.95996 + 0.84162)² / (3 * 0.2²) = 7.8489 / 0.12 = 65.4; power 90 %:
  /// (1.95996 + 1.28155)² / 0.12 = 87.6.
  void pairsForSignedRank_byHand_isEqual() {
    QCOMPARE(pairsForSignedRank(0.7), 66.0);
    QCOMPARE(pairsForSignedRank(0.3), 66.0);
    QCOMPARE(pairsForSignedRank(0.7, {0.05, 0.9}), 88.0);
    QVERIFY(std::isnan(pairsForSignedRank(0.5)));
    QVERIFY(std::isnan(pairsForSignedRank(kUndefined)));
  }

  /// By hand: of 3 + -1, 3 + -3, -1 + -3 one is positive, one is zero.
  void chanceOfPositiveSum_byHand_isEqual() {
    QCOMPARE(chanceOfPositiveSum({3, -1, -3}), 0.5);
    QCOMPARE(chanceOfPositiveSum({1, 2, 3}), 1.0);
    QCOMPARE(chanceOfPositiveSum({0, 0}), 0.5);
    QVERIFY(std::isnan(chanceOfPositiveSum({1})));
  }
};

QTEST_APPLESS_MAIN(SampleSizeTest)
#include "tst_SampleSize.moc"
