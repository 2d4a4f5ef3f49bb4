#include <array>
#include <cmath>
#include <functional>
#include <map>

#include <QtTest>

#include "app/run/SensitivityDesign.h"
#include "metrics/statistics/Sensitivity.h"

using app::Design;
using statistics::Numbers;

namespace {

constexpr double kPi = 3.14159265358979323846;

using Model = std::function<double(const Numbers&)>;

/// The g-function (Saltelli & Sobol 1995): product of (|4 u - 2| + a) / (1 + a).
constexpr std::array<double, 6> kG = {0.0, 0.5, 3.0, 9.0, 99.0, 99.0};
double gFunction(const Numbers& at) {
  double product = 1.0;
  for (std::size_t k = 0; k < kG.size(); ++k) {
    product *= (std::abs(4.0 * at[k] - 2.0) + kG[k]) / (1.0 + kG[k]);
  }
  return product;
}

double ishigami(const Numbers& at) {
  const double x = kPi * (2.0 * at[0] - 1.0), y = kPi * (2.0 * at[1] - 1.0);
  const double z = kPi * (2.0 * at[2] - 1.0);
  return std::sin(x) + 7.0 * std::sin(y) * std::sin(y) + 0.1 * std::pow(z, 4) * std::sin(x);
}

Numbers outputsOf(const Model& model, const std::vector<Numbers>& points) {
  Numbers outputs;
  for (const Numbers& point : points) {
    outputs.push_back(model(point));
  }
  return outputs;
}

statistics::SobolIndices sobolOf(const Model& model, std::size_t factors, std::size_t count) {
  const Numbers outputs =
      outputsOf(model, app::designPoints({Design::Method::Saltelli, count, 1}, factors));
  std::vector<statistics::SaltelliRow> rows;
  for (std::size_t k = 0; k < outputs.size(); k += factors + 2) {
    const auto at = outputs.begin() + static_cast<std::ptrdiff_t>(k);
    rows.push_back({at[0], at[1], Numbers(at + 2, at + 2 + static_cast<std::ptrdiff_t>(factors))});
  }
  return statistics::sobolIndices(rows);
}

bool contains(const statistics::Interval& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

/// The first coordinate with the mean and deviation of all effects on Morris' grid, by enumeration:
/// from each of two low levels, at every combination of the levels of the others.
struct GridEffects {
  double mean = 0.0, meanSize = 0.0, deviation = 0.0;
};
GridEffects gridEffectsOf(const Model& model, std::size_t factors, std::size_t factor) {
  const std::array<double, 4> levels = {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0};
  std::size_t combinations = 1;
  for (std::size_t k = 0; k < factors; ++k) {
    combinations *= 4;
  }
  double sum = 0.0, sizes = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t number = 0; number < combinations; ++number) {
    Numbers low;
    for (std::size_t k = 0, rest = number; k < factors; ++k, rest /= 4) {
      low.push_back(levels[rest % 4]);
    }
    if (low[factor] > 0.5) {
      continue;
    }
    Numbers high = low;
    high[factor] += 2.0 / 3.0;
    const double effect = (model(high) - model(low)) / (2.0 / 3.0);
    sum += effect;
    sizes += std::abs(effect);
    squares += effect * effect;
    count += 1.0;
  }
  const double mean = sum / count;
  return {mean, sizes / count, std::sqrt(squares / count - mean * mean)};
}

}  // namespace

/// Designs for sensitivity analysis, and the indices at their points.
class SensitivityDesignTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void morris_trajectoriesChangeEachCoordinateOnce() {
    constexpr std::size_t kFactors = 5, kCount = 200;
    const auto points = app::designPoints({Design::Method::Morris, kCount, 3}, kFactors);
    QCOMPARE(points.size(), kCount * (kFactors + 1));
    std::map<std::pair<std::size_t, int>, int> levels;
    for (std::size_t start = 0; start < points.size(); start += kFactors + 1) {
      std::vector<int> changes(kFactors);
      for (std::size_t k = start; k < start + kFactors; ++k) {
        int changed = 0;
        for (std::size_t f = 0; f < kFactors; ++f) {
          const double step = std::abs(points[k + 1][f] - points[k][f]);
          QVERIFY(step == 0.0 || std::abs(step - 2.0 / 3.0) < 1e-15);
          changes[f] += step > 0.0 ? 1 : 0;
          changed += step > 0.0 ? 1 : 0;
        }
        QCOMPARE(changed, 1);
      }
      QCOMPARE(changes, std::vector<int>(kFactors, 1));
      for (std::size_t f = 0; f < kFactors; ++f) {
        ++levels[{f, static_cast<int>(std::lround(3.0 * points[start][f]))}];
      }
    }
    QCOMPARE(levels.size(), kFactors * 4);
    for (const auto& [level, count] : levels) {  // 50 expected, deviation 6.1
      QVERIFY2(count > 25 && count < 75, qPrintable(QString::number(count)));
    }
  }

  void saltelli_pointsShareCoordinates() {
    constexpr std::size_t kFactors = 3;
    const auto points = app::designPoints({Design::Method::Saltelli, 16, 1}, kFactors);
    QCOMPARE(points.size(), std::size_t{16 * (kFactors + 2)});
    for (std::size_t k = 0; k < points.size(); k += kFactors + 2) {
      for (std::size_t f = 0; f < kFactors; ++f) {
        for (std::size_t other = 0; other < kFactors; ++other) {
          QCOMPARE(points[k + 2 + f][other], points[k + (other == f ? 1 : 0)][other]);
        }
      }
    }
  }

  /// A scrambled net: each of 16 intervals of each coordinate has one of 16 points.
  void saltelli_isStratified() {
    const auto points = app::designPoints({Design::Method::Saltelli, 16, 7}, 4);
    for (const std::size_t row : {0U, 1U}) {  // A and B
      for (std::size_t f = 0; f < 4; ++f) {
        std::vector<int> counts(16);
        for (std::size_t k = 0; k < points.size(); k += 6) {
          ++counts[static_cast<std::size_t>(16.0 * points[k + row][f])];
        }
        QCOMPARE(counts, std::vector<int>(16, 1));
      }
    }
  }

  void designs_dependOnTheSeedAndHavePrefixes() {
    for (const auto method : {Design::Method::Morris, Design::Method::Saltelli}) {
      const auto few = app::designPoints({method, 5, 1}, 3);
      const auto more = app::designPoints({method, 9, 1}, 3);
      QVERIFY(std::equal(few.begin(), few.end(), more.begin()));
      QVERIFY(few != app::designPoints({method, 5, 2}, 3));
    }
  }

  /// Exact: V_i = 1 / (3 (1 + a)²), total V = prod (1 + V_i) - 1 (Saltelli et al. 2008, 4.3).
  void sobol_gFunction_intervalsContainTheExactValues() {
    double product = 1.0;
    for (const double a : kG) {
      product *= 1.0 + 1.0 / (3.0 * (1.0 + a) * (1.0 + a));
    }
    const auto found = sobolOf(gFunction, kG.size(), 512);
    for (std::size_t k = 0; k < kG.size(); ++k) {
      const double own = 1.0 / (3.0 * (1.0 + kG[k]) * (1.0 + kG[k]));
      QVERIFY(contains(found.factors[k].firstInterval, own / (product - 1.0)));
      QVERIFY(
          contains(found.factors[k].totalInterval, own * product / (1.0 + own) / (product - 1.0)));
    }
    QCOMPARE(found.ranking.order[0], std::size_t{0});
    QCOMPARE(found.ranking.order[1], std::size_t{1});
  }

  /// Exact: V1 = (1 + b π⁴ / 5)² / 2, V2 = a² / 8, V13 = 8 b² π⁸ / 225 with a = 7, b = 0.1.
  void sobol_ishigami_intervalsContainTheExactValues() {
    const double first = 0.5 * std::pow(1.0 + 0.1 * std::pow(kPi, 4) / 5.0, 2);
    const double second = 49.0 / 8.0, mixed = 0.08 * std::pow(kPi, 8) / 225.0;
    const double all = first + second + mixed;
    const auto found = sobolOf(ishigami, 3, 512);
    const std::array<double, 3> alone = {first, second, 0.0};
    const std::array<double, 3> whole = {first + mixed, second, mixed};
    for (std::size_t k = 0; k < 3; ++k) {
      QVERIFY(contains(found.factors[k].firstInterval, alone[k] / all));
      QVERIFY(contains(found.factors[k].totalInterval, whole[k] / all));
    }
  }

  void morris_intervalsContainTheValuesOfTheWholeGrid_data() {
    QTest::addColumn<int>("factors");
    QTest::newRow("Ishigami") << 3;
    QTest::newRow("g-function") << 6;
  }
  void morris_intervalsContainTheValuesOfTheWholeGrid() {
    QFETCH(int, factors);
    const auto count = static_cast<std::size_t>(factors);
    const Model model = count == 3 ? Model(ishigami) : Model(gFunction);
    const auto points = app::designPoints({Design::Method::Morris, 400, 1}, count);
    const auto found = statistics::morrisIndices(
        statistics::elementaryEffects(points, outputsOf(model, points)), {0.99, 2000, 1});
    for (std::size_t k = 0; k < count; ++k) {
      const GridEffects exact = gridEffectsOf(model, count, k);
      const statistics::MorrisFactor& factor = found.factors[k];
      const double error = exact.deviation / 20.0;  // of the mean of 400
      const double small = 1e-9 * (1.0 + exact.meanSize);
      QCOMPARE(factor.count, 400);
      QVERIFY(std::abs(factor.mean - exact.mean) <= 3.0 * error + small);
      QVERIFY(factor.meanSizeInterval.low <= exact.meanSize + small &&
              factor.meanSizeInterval.high >= exact.meanSize - small);
      QVERIFY(std::abs(factor.deviation - exact.deviation) <= 0.1 * exact.deviation + small);
    }
  }

  /// The g-function on the grid by formulas: levels give |4 u - 2| = 2, 2/3, 2/3, 2, so effects of
  /// one coordinate are ±2 / (1 + a), times the others with the mean (4/3 + a) / (1 + a).
  void gridOfTheGFunction_isAsByFormula() {
    double others = 1.0;
    for (std::size_t k = 1; k < kG.size(); ++k) {
      others *= (4.0 / 3.0 + kG[k]) / (1.0 + kG[k]);
    }
    const GridEffects exact = gridEffectsOf(gFunction, kG.size(), 0);
    QVERIFY(std::abs(exact.mean) < 1e-12);
    QVERIFY(std::abs(exact.meanSize - 2.0 * others) < 1e-12);
  }
};

QTEST_APPLESS_MAIN(SensitivityDesignTest)
#include "tst_SensitivityDesign.moc"
