#include <algorithm>
#include <functional>
#include <numeric>

#include <QtTest>

#include "metrics/statistics/Bootstrap.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

/// Spatial test data A (Efron & Tibshirani 1993, table 14.1).
const Numbers& spatial() {
  static const Numbers values = {48, 36, 20, 29, 42, 42, 20, 42, 22, 41, 45, 14, 6,
                                 0,  33, 28, 34, 4,  32, 24, 47, 41, 24, 26, 30, 41};
  return values;
}

double plugInVariance(const Numbers& values) {
  const double sd = standardDeviation(values);
  return sd * sd * static_cast<double>(values.size() - 1) / static_cast<double>(values.size());
}

double correlation(const Numbers& x, const Numbers& y, const std::vector<std::size_t>& rows) {
  double sums[5] = {};
  for (const std::size_t row : rows) {
    const double terms[5] = {x[row], y[row], x[row] * x[row], y[row] * y[row], x[row] * y[row]};
    std::transform(terms, terms + 5, sums, sums, std::plus<>());
  }
  const auto n = static_cast<double>(rows.size());
  const double spread = (sums[2] - sums[0] * sums[0] / n) * (sums[3] - sums[1] * sums[1] / n);
  return (sums[4] - sums[0] * sums[1] / n) / std::sqrt(spread);
}

}  // namespace

class BootstrapTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Efron & Tibshirani 1993, table 14.2: variance 171.5, BCa interval of 90 % (115.8, 259.6).
  void bootstrapInterval_spatialData_isThatOfTheBook() {
    VERIFY_NEAR(plugInVariance(spatial()), 171.534, 1e-3);
    BootstrapOptions options;
    options.level = 0.9;
    options.resamples = 20000;
    const Interval found = bootstrapInterval(spatial(), plugInVariance, options);
    VERIFY_NEAR(found.low, 115.8, 2.0);
    VERIFY_NEAR(found.high, 259.6, 4.0);
  }

  /// Law schools (idem, table 3.1), correlation 0.776; scipy 1.10.1: bootstrap(paired, 'BCa',
  /// 40000 resamples) = (0.340, 0.942).
  void bootstrapRowsInterval_lawSchools_isThatOfScipy() {
    const Numbers lsat = {576, 635, 558, 578, 666, 580, 555, 661,
                          651, 605, 653, 575, 545, 572, 594};
    const Numbers gpa = {3.39, 3.30, 2.81, 3.03, 3.44, 3.07, 3.00, 3.43,
                         3.36, 3.13, 3.12, 2.74, 2.76, 2.88, 2.96};
    std::vector<std::size_t> all(lsat.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    VERIFY_NEAR(correlation(lsat, gpa, all), 0.776374491289407, 1e-9);
    BootstrapOptions options;
    options.resamples = 20000;
    const Interval found = bootstrapRowsInterval(
        lsat.size(), [&](const auto& rows) { return correlation(lsat, gpa, rows); }, options);
    VERIFY_NEAR(found.low, 0.340, 0.03);
    VERIFY_NEAR(found.high, 0.942, 0.01);
  }

  /// Treated mice (idem, table 2.1); scipy 1.10.1, 100000 resamples, three seeds: (46.3 to 47.0,
  /// 138.3).
  void bootstrapMeanInterval_mouseData_isThatOfScipy() {
    const Numbers treated = {94, 197, 16, 38, 99, 141, 23};
    BootstrapOptions options;
    options.resamples = 20000;
    const Interval found = bootstrapMeanInterval(treated, options);
    VERIFY_NEAR(found.low, 46.6, 1.0);
    VERIFY_NEAR(found.high, 138.3, 1.5);
    const Interval slow = bootstrapInterval(
        treated, [](const Numbers& x) { return mean(x); }, options);
    VERIFY_NEAR(found.low, slow.low, 1e-9);
    VERIFY_NEAR(found.high, slow.high, 1e-9);
  }

  /// Means that equal the estimate but for the order of their sums are equal to it. In Python, with
  /// whole sums, 40000 resamples: (-5, 3) / 15.
  void bootstrapMeanInterval_tiesByRounding_countAsHalf() {
    const Numbers differences = {1, 1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    BootstrapOptions options;
    options.resamples = 20000;
    const Interval found = bootstrapMeanInterval(differences, options);
    VERIFY_NEAR(found.low, -5.0 / 15.0, 1e-9);
    VERIFY_NEAR(found.high, 3.0 / 15.0, 1e-9);
    const Interval slow = bootstrapInterval(
        differences, [](const Numbers& x) { return mean(x); }, options);
    VERIFY_NEAR(slow.low, found.low, 1e-9);
    VERIFY_NEAR(slow.high, found.high, 1e-9);
  }

  void bootstrapMeanInterval_seed_decidesAlone() {
    BootstrapOptions options;
    const Interval one = bootstrapMeanInterval(spatial(), options);
    const Interval again = bootstrapMeanInterval(spatial(), options);
    QCOMPARE(one.low, again.low);
    QCOMPARE(one.high, again.high);
    options.seed = 2;
    QVERIFY(bootstrapMeanInterval(spatial(), options).low != one.low);
  }

  void bootstrapInterval_smallAndEqual_areAsSaid() {
    QVERIFY(!bootstrapMeanInterval({}).isDefined());
    QVERIFY(!bootstrapMeanInterval({1.0}).isDefined());
    const Interval equal = bootstrapMeanInterval({0.1, 0.1, 0.1});
    QCOMPARE(equal.low, 0.1);
    QCOMPARE(equal.high, 0.1);
    const Interval two = bootstrapMeanInterval({0.0, 1.0});
    QVERIFY(two.low >= 0.0 && two.low < two.high && two.high <= 1.0);
  }
};

QTEST_APPLESS_MAIN(BootstrapTest)
#include "tst_Bootstrap.moc"
