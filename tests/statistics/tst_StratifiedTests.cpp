#include <algorithm>

#include <QtTest>

#include "metrics/statistics/PairedTests.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

/// Sum of weighted ranks of positive differences, by counting: the rank of a size is how many are
/// smaller, and half of those equal to it and one more.
double weightedSum(const Strata& strata, const std::vector<std::vector<int>>& signs) {
  double sum = 0.0;
  for (std::size_t k = 0; k < strata.size(); ++k) {
    const Numbers& all = strata[k];
    for (std::size_t i = 0; i < all.size(); ++i) {
      double rank = 0.5;
      for (const double other : all) {
        rank += std::abs(other) < std::abs(all[i]) ? 1.0 : 0.0;
        rank += std::abs(other) == std::abs(all[i]) ? 0.5 : 0.0;
      }
      const bool counts = all[i] != 0.0 && signs[k][i] > 0;
      sum += counts ? rank / (static_cast<double>(all.size()) + 1.0) : 0.0;
    }
  }
  return sum;
}

/// Two-sided p by listing every change of signs of what is not zero.
double listedP(const Strata& strata) {
  std::vector<std::vector<int>> signs;
  std::vector<int*> free;
  for (const Numbers& each : strata) {
    signs.emplace_back(each.size(), 1);
  }
  for (std::size_t k = 0; k < strata.size(); ++k) {
    for (std::size_t i = 0; i < strata[k].size(); ++i) {
      signs[k][i] = strata[k][i] > 0.0 ? 1 : -1;
      if (strata[k][i] != 0.0) {
        free.push_back(&signs[k][i]);
      }
    }
  }
  const double observed = weightedSum(strata, signs);
  int atMost = 0;
  int atLeast = 0;
  const int all = 1 << free.size();
  for (int choice = 0; choice < all; ++choice) {
    for (std::size_t bit = 0; bit < free.size(); ++bit) {
      *free[bit] = (choice >> bit & 1) != 0 ? 1 : -1;
    }
    const double sum = weightedSum(strata, signs);
    atMost += sum <= observed + 1e-9 ? 1 : 0;
    atLeast += sum >= observed - 1e-9 ? 1 : 0;
  }
  return std::min(1.0, 2.0 * std::min(atMost, atLeast) / all);
}

/// Median of listed means of pairs within the strata, each as often as the smallest whole weights
/// of strata of 3 and 5 require (1/4 and 1/6: 3 and 2).
double listedShift(const Strata& strata, const std::vector<int>& weights) {
  Numbers means;
  for (std::size_t k = 0; k < strata.size(); ++k) {
    for (std::size_t i = 0; i < strata[k].size(); ++i) {
      for (std::size_t j = i; j < strata[k].size(); ++j) {
        means.insert(means.end(), static_cast<std::size_t>(weights[k]),
                     0.5 * (strata[k][i] + strata[k][j]));
      }
    }
  }
  return median(means);
}

/// Differences that shift little within three scenarios of very different spread.
Strata threeScenarios() {
  return {{0.11, 0.14, -0.02, 0.09, 0.17}, {3.1, 5.2, 4.4, -1.0, 2.5, 6.1}, {40.0, -71.0, 55.0}};
}

}  // namespace

class StratifiedTestsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void p_isThatOfAllChangesOfSigns_data() {
    QTest::addColumn<Numbers>("first");
    QTest::addColumn<Numbers>("second");
    QTest::addColumn<Numbers>("third");
    QTest::newRow("equal sizes") << Numbers{1, 2, 3} << Numbers{-1, 5, 7} << Numbers{2, 2.5, -9};
    QTest::newRow("unequal sizes") << Numbers{1, 2, 3} << Numbers{-1, 5, 7, 8, 2} << Numbers{2};
    QTest::newRow("ties and zeros")
        << Numbers{0, 2, 2, -2} << Numbers{1, 1, 0, 0, 3, -1} << Numbers{5, 5, -5};
    QTest::newRow("three scenarios")
        << threeScenarios()[0] << threeScenarios()[1] << threeScenarios()[2];
    QTest::newRow("nothing") << Numbers{0, 0} << Numbers{0} << Numbers{};
  }
  void p_isThatOfAllChangesOfSigns() {
    QFETCH(Numbers, first);
    QFETCH(Numbers, second);
    QFETCH(Numbers, third);
    const Strata strata = {first, second, third};
    const StratifiedSignedRank test = stratifiedSignedRank(strata);
    QVERIFY(test.isExact);
    VERIFY_NEAR(test.p, listedP(strata), 1e-12);
  }

  /// The scenario with the largest spread contributes nothing here and would hide the other two.
  void pooledRanks_wouldHideIt() {
    const Strata strata = threeScenarios();
    Numbers pooled;
    for (const Numbers& each : strata) {
      pooled.insert(pooled.end(), each.begin(), each.end());
    }
    VERIFY_NEAR(stratifiedSignedRank(strata).p, 61.0 / 4096.0, 1e-12);  // listed, as above
    QVERIFY(stratifiedSignedRank({pooled}).p > 0.049);
  }

  /// Empty strata change nothing, for few differences and for many.
  void emptyStrata_areIgnored() {
    Numbers many;
    for (int k = 0; k < 80; ++k) {
      many.push_back(std::sin(k) + 0.2);
    }
    const Numbers few(many.begin(), many.begin() + 9);
    for (const Numbers& each : {few, many}) {
      const Strata strata = {{}, each, {}};
      QCOMPARE(stratifiedSignedRank(strata).p, stratifiedSignedRank({each}).p);
      QCOMPARE(stratifiedShift(strata), stratifiedShift({each}));
      QCOMPARE(stratifiedShiftInterval(strata).low, stratifiedShiftInterval({each}).low);
      QCOMPARE(stratifiedShiftInterval(strata).high, stratifiedShiftInterval({each}).high);
    }
    QVERIFY(!stratifiedSignedRank({many}).isExact);
  }

  /// The distribution by all changes of signs is close to the normal one for 60 differences.
  void normal_isCloseToExact() {
    Strata strata(6);
    for (int k = 0; k < 54; ++k) {
      strata[static_cast<std::size_t>(k % 6)].push_back(std::sin(3.0 * k) + 0.25);
    }
    Strata fewer = strata;
    for (Numbers& each : fewer) {
      each.resize(8);
    }
    QVERIFY(stratifiedSignedRank(fewer).isExact && !stratifiedSignedRank(strata).isExact);
    Strata more = fewer;
    more[0].insert(more[0].end(), {1e-9, -1e-9, 1e-9});  // of the least ranks
    QVERIFY(std::abs(stratifiedSignedRank(more).p - stratifiedSignedRank(fewer).p) < 0.02);
  }

  void shift_isTheMedianOfMeansWithin() {
    const Strata strata = {{1.0, 2.0, 9.0}, {0.5, 0.75, 4.0, -3.0, 2.5}};
    VERIFY_NEAR(stratifiedShift(strata), listedShift(strata, {3, 2}), 1e-12);
    QVERIFY(std::isnan(stratifiedShift({{}, {}})));
  }

  /// Shifts within the interval are not rejected by the test, shifts outside are.
  void interval_isWhatTheTestAllows() {
    const Strata strata = threeScenarios();
    const Interval interval = stratifiedShiftInterval(strata);
    const auto pAt = [&strata](double shift) {
      Strata moved = strata;
      for (Numbers& each : moved) {
        for (double& difference : each) {
          difference -= shift;
        }
      }
      return stratifiedSignedRank(moved).p;
    };
    QVERIFY(interval.low > 0.0 && interval.high > interval.low);
    const double step = 1e-6;
    QVERIFY(pAt(interval.low - step) <= 0.05 && pAt(interval.low + step) > 0.05);
    QVERIFY(pAt(interval.high + step) <= 0.05 && pAt(interval.high - step) > 0.05);
    QVERIFY(!stratifiedShiftInterval({{1.0, 2.0}, {3.0}}).isDefined());
  }

  /// Equal strata of half the pairs: the same estimate, distances shorter by the root of two.
  void rates_ofStrata() {
    const PairedOutcomes half = {36, 12, 2, 0};
    const Interval one = pairedRateInterval(half);
    const Interval both = stratifiedRateInterval({half, {}, half});
    const double estimate = 0.2;
    VERIFY_NEAR(estimate - both.low, (estimate - one.low) / std::sqrt(2.0), 1e-12);
    VERIFY_NEAR(both.high - estimate, (one.high - estimate) / std::sqrt(2.0), 1e-12);
    const Interval alone = stratifiedRateInterval({half});
    VERIFY_NEAR(alone.low, one.low, 1e-12);
    VERIFY_NEAR(alone.high, one.high, 1e-12);
    QVERIFY(!stratifiedRateInterval({}).isDefined());
  }
};

QTEST_APPLESS_MAIN(StratifiedTestsTest)
#include "tst_StratifiedTests.moc"
