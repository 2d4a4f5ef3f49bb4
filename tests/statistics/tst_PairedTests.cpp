#include <algorithm>
#include <numeric>

#include <QtTest>

#include "metrics/statistics/PairedTests.h"
#include "metrics/statistics/Ranks.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

/// Depression scores before and after therapy (Hollander & Wolfe 1999, table 3.1; R's
/// ?wilcox.test).
const Numbers& therapy() {
  static const Numbers differences = {1.83 - 0.878, 0.50 - 0.647, 1.62 - 0.598,
                                      2.48 - 2.05,  1.68 - 1.06,  1.88 - 1.29,
                                      1.55 - 1.06,  3.06 - 3.14,  1.30 - 1.29};
  return differences;
}

/// C4.5 with and without m, AUC times 1000 (Demšar 2006, table 2).
const Numbers& demsar() {
  static const Numbers differences = {5, -8, 17, 33, 6, -5, 7, 0, 63, 0, 22, 47, 9, 21};
  return differences;
}

/// numpy 1.24: round(default_rng(5).normal(.3, 1, 60), 3).
const Numbers& sixty() {
  static const Numbers differences = {
      -0.502, -1.024, 0.052,  0.72,   1.436,  0.41,   -0.253, -0.485, 1.049,  1.935,
      0.573,  -0.933, -0.658, 1.9,    0.503,  -1.432, 0.216,  -0.863, -0.329, -0.188,
      -0.413, 0.853,  0.237,  -0.289, 0.71,   1.13,   -1.343, 0.043,  -0.681, 0.127,
      -0.989, 0.321,  0.262,  -0.004, -0.748, -0.096, -0.791, -1.055, 0.525,  -0.809,
      1.47,   1.017,  -1.698, 0.572,  -0.802, 0.333,  0.344,  -1.688, 0.067,  0.044,
      1.262,  -0.881, 1.038,  -0.799, -0.031, -0.54,  1.749,  0.868,  2.732,  0.942};
  return differences;
}

/// The two-sided p value of differences in one stratum.
double pOf(const Numbers& differences) {
  return stratifiedSignedRank({differences}).p;
}

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

class PairedTestsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void midranks_ties_shareTheirMean() {
    QCOMPARE(midranks({3, 1, 3, 2, 3}), Numbers({4, 1, 4, 2, 4}));
    QCOMPARE(midranks({}), Numbers());
  }

  /// Largest smaller sums that are significant at 5 % two-sided: the usual table (Wilcoxon & Wilcox
  /// 1964).
  void signedRankSumCdf_criticalValues_areThoseOfTheTable_data() {
    QTest::addColumn<int>("n");
    QTest::addColumn<int>("critical");
    const int rows[][2] = {{6, 0},   {7, 2},   {8, 3},   {9, 5},    {10, 8},  {12, 13},
                           {15, 25}, {20, 52}, {25, 89}, {30, 137}, {50, 434}};
    for (const auto& row : rows) {
      QTest::addRow("%d", row[0]) << row[0] << row[1];
    }
  }
  void signedRankSumCdf_criticalValues_areThoseOfTheTable() {
    QFETCH(int, n);
    QFETCH(int, critical);
    Numbers ranks(static_cast<std::size_t>(n));
    std::iota(ranks.begin(), ranks.end(), 1.0);
    QVERIFY(signedRankSumCdf(ranks, critical) <= 0.025);
    QVERIFY(signedRankSumCdf(ranks, critical + 1) > 0.025);
    VERIFY_NEAR(signedRankSumCdf(ranks, 0.5 * n * (n + 1)), 1.0, 1e-12);
  }

  /// H & W: T+ = 40, one-sided p .0195.
  void signedRank_therapy_isThatOfTheBook() {
    const StratifiedSignedRank found = stratifiedSignedRank({therapy()});
    QVERIFY(found.isExact);
    VERIFY_NEAR(found.p, 0.0390625, 1e-12);
  }

  /// All 2^12 signs listed: of 16 the smaller sum is as small.
  void signedRank_tiesAndZeros_areThoseOfTheList() {
    const StratifiedSignedRank found = stratifiedSignedRank({demsar()});
    QCOMPARE(found.n, 12);
    QCOMPARE(found.zeros, 2);
    QVERIFY(found.isExact);
    VERIFY_NEAR(found.p, 2.0 * 16.0 / 4096.0, 1e-15);
  }

  /// By hand: all of one sign is 2 / 2^n, no p is smaller; of {1, 1, -1, 2} four of 16 sums are at
  /// most 2.
  void signedRank_tiesAndZerosOfFew_areByHand() {
    QCOMPARE(pOf({1, 1, 1, 1, 1}), 2.0 / 32.0);
    QCOMPARE(pOf({0, 1, 2, 3, 4, 5, 6}), 2.0 / 64.0);
    QCOMPARE(pOf({0, 0, 0, 0, 2, 2}), 2.0 / 4.0);
    QCOMPARE(pOf({1, 1, -1, 2}), 2.0 * 4.0 / 16.0);
  }

  /// scipy 1.10.1: wilcoxon(d, zero_method, correction=True, mode='approx').
  void signedRank_manyWithTies_isThatOfScipy() {
    const StratifiedSignedRank many = stratifiedSignedRank({sixty()});
    QVERIFY(!many.isExact);
    VERIFY_NEAR(many.p, 0.6089089992671246, 1e-9);
  }

  void signedRank_edgeCases_areAsSaid() {
    QCOMPARE(pOf({}), 1.0);
    QCOMPARE(pOf({0.0, 0.0, 0.0}), 1.0);
    QCOMPARE(pOf({2.0}), 1.0);
    QCOMPARE(pOf({1, 2, 3, 4, 5}), 2.0 / 32.0);  // all of one sign: 2 / 2^n
    QCOMPARE(pOf({-1, -2, -3, -4, -5}), 2.0 / 32.0);
  }

  /// H & W, examples 3.2 and 3.3: estimate .46, interval of 96 % (.010, .786).
  void pairedShift_therapy_isThatOfTheBook() {
    VERIFY_NEAR(stratifiedShift({therapy()}), 0.46, 1e-9);
    const Interval found =
        stratifiedShiftInterval({therapy()}, 0.95);  // next possible level: 96.1 %
    VERIFY_NEAR(found.low, 0.010, 1e-9);
    VERIFY_NEAR(found.high, 0.786, 1e-9);
  }

  /// All means of pairs listed and sorted; the places by the normal distribution, by hand:
  /// 60 * 61 / 4 = 915, √(60 * 61 * 121 / 24) = 135.84, 915 - 1.95996 * 135.84 - 0.5 = 648.3.
  void pairedShift_manyPairs_isTheOneOfTheList() {
    Numbers means;
    const Numbers& values = sixty();
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t j = i; j < values.size(); ++j) {
        means.push_back(0.5 * (values[i] + values[j]));
      }
    }
    std::sort(means.begin(), means.end());
    QCOMPARE(means.size(), std::size_t{1830});
    VERIFY_NEAR(stratifiedShift({values}), 0.5 * (means[914] + means[915]), 1e-12);
    const Interval found = stratifiedShiftInterval({values});
    QCOMPARE(found.low, means[648]);
    QCOMPARE(found.high, means[1830 - 649]);
  }

  void pairedShift_edgeCases_areAsSaid() {
    QVERIFY(std::isnan(stratifiedShift({{}})));
    QCOMPARE(stratifiedShift({{-3.0}}), -3.0);
    QCOMPARE(stratifiedShift({{0.0, 0.0, 0.0}}), 0.0);
    QVERIFY(!stratifiedShiftInterval({{1, 2, 3, 4, 5}}).isDefined());
    QVERIFY(!stratifiedShiftInterval({{}}).isDefined());
    const Interval six = stratifiedShiftInterval({{1, 2, 3, 4, 5, 6}});
    QCOMPARE(six.low, 1.0);
    QCOMPARE(six.high, 6.0);
  }

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

  /// By hand: variances of the means 9/49 · 1/3 and 16/49 · 5/3, 3.64379 degrees of freedom, t =
  /// 2.88683 (integrated numerically).
  void meanInterval_strata_welchSatterthwaite() {
    const Interval both = stratifiedMeanInterval({{1.0, 2.0, 3.0}, {}, {2.0, 4.0, 6.0, 8.0}});
    VERIFY_NEAR(both.low, 1.468035972740413, 1e-6);
    VERIFY_NEAR(both.high, 5.960535455831016, 1e-6);
    const Numbers alone = {1.0, 5.0, 2.0, 9.0};
    VERIFY_NEAR(stratifiedMeanInterval({alone}).low, meanInterval(alone).low, 1e-12);
    VERIFY_NEAR(stratifiedMeanInterval({alone}).high, meanInterval(alone).high, 1e-12);
    QCOMPARE(stratifiedMeanInterval({{2.0, 2.0}, {4.0, 4.0}}).low, 3.0);
    QVERIFY(!stratifiedMeanInterval({{1.0}, {1.0, 2.0}}).isDefined());
    QVERIFY(!stratifiedMeanInterval({}).isDefined());
  }
};

QTEST_APPLESS_MAIN(PairedTestsTest)
#include "tst_PairedTests.moc"
