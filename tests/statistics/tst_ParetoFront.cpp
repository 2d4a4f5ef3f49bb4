#include <QtTest>

#include "metrics/statistics/ParetoFront.h"
#include "tests/statistics/Near.h"

using namespace statistics;

class ParetoFrontTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// By hand: time (less is better) against distance kept (more is better).
  void paretoFront_byHand_isEqual() {
    const Numbers time = {10, 12, 11, 14, 10};
    const Numbers distance = {0.5, 0.9, 0.4, 0.9, 0.5};
    QCOMPARE(paretoFront(time, Sense::Lower, distance, Sense::Higher),
             std::vector<bool>({true, true, false, false, true}));
    QCOMPARE(paretoFront(time, Sense::Lower, distance, Sense::Lower),
             std::vector<bool>({true, false, true, false, true}));
    QCOMPARE(paretoFront({1, kUndefined}, Sense::Lower, {1, 0}, Sense::Lower),
             std::vector<bool>({true, false}));
    QVERIFY(paretoFront({}, Sense::Lower, {}, Sense::Lower).empty());
  }

  /// By hand: times 10, 15, 20 -> 1, 0.5, 0; distances 0.2, 0.6, 0.4 -> 0, 1, 0.5; weights 1, 3.
  void composite_byHand_isEqual() {
    const Numbers found =
        composite({{{10, 15, 20}, Sense::Lower, 1.0}, {{0.2, 0.6, 0.4}, Sense::Higher, 3.0}});
    const Numbers wanted = {0.25, 3.5 / 4.0, 1.5 / 4.0};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      VERIFY_NEAR(found[k], wanted[k], 1e-12);
    }
  }

  void composite_edgeCases_areAsSaid() {
    QVERIFY(composite({}).empty());
    QCOMPARE(composite({{{5, 5}, Sense::Lower, 1.0}}), Numbers({1.0, 1.0}));
    QVERIFY(std::isnan(composite({{{5, 6}, Sense::Lower, 0.0}})[0]));
    const Numbers gap = composite({{{5, kUndefined, 6}, Sense::Lower, 1.0}});
    QCOMPARE(gap[0], 1.0);
    QVERIFY(std::isnan(gap[1]));
    QCOMPARE(gap[2], 0.0);
  }
};

QTEST_APPLESS_MAIN(ParetoFrontTest)
#include "tst_ParetoFront.moc"
