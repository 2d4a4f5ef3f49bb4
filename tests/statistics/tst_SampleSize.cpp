#include <QtTest>

#include "metrics/statistics/SampleSize.h"
#include "tests/statistics/Near.h"

using namespace statistics;

class SampleSizeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Pairs for a paired t test at 5 %, power 80 %: 199, 34 and 15 for effects of 0.2, 0.5 and 0.8
  /// (Cohen's small, medium, large; G*Power 3.1).
  void pairsForMean_cohen_isThatOfGPower() {
    QCOMPARE(pairsForMean(0.2, 1.0), 199.0);
    QCOMPARE(pairsForMean(0.5, 1.0), 34.0);
    QCOMPARE(pairsForMean(-1.6, 2.0), 15.0);
  }

  void pairsForMean_edgeCases_areAsSaid() {
    QVERIFY(std::isnan(pairsForMean(0.0, 1.0)));
    QVERIFY(std::isnan(pairsForMean(kUndefined, 1.0)));
    QVERIFY(std::isnan(pairsForMean(1.0, kUndefined)));
    QCOMPARE(pairsForMean(1.0, 0.0), 2.0);
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
