#include <cmath>
#include <functional>
#include <limits>

#include <QtTest>

#include "app/studies/CmaEs.h"

namespace {

using app::Point;
using Objective = std::function<double(const Point&)>;

constexpr double kPi = 3.14159265358979323846;

double sphere(const Point& x) {
  double sum = 0.0;
  for (const double value : x) {
    sum += value * value;
  }
  return sum;
}

double rosenbrock(const Point& x) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    sum += 100.0 * std::pow(x[k] * x[k] - x[k + 1], 2) + std::pow(x[k] - 1.0, 2);
  }
  return sum;
}

double rastrigin(const Point& x) {
  double sum = 0.0;
  for (const double value : x) {
    sum += value * value - 10.0 * std::cos(2.0 * kPi * value) + 10.0;
  }
  return sum;
}

/// A function of the special session on real-parameter optimisation at CEC 2005 (Suganthan et al.):
/// the function in [-half, half]^10, with its optimum moved.
struct CecFunction {
  Objective function;
  double half;
  double optimum;  // of the function, in all coordinates
  Point shift;
  double accuracy;
};

struct Attempts {
  int successes = 0;
  double evaluations = 0.0;  // mean of the successful ones
  /// Mean evaluations of successful runs over the rate of successes.
  double perSuccess(int runs) const { return evaluations * runs / successes; }
};

/// The number of evaluations until the accuracy is reached; 0: not within 100 000.
std::size_t evaluationsOf(const CecFunction& of, std::uint64_t seed) {
  app::RestartedCmaEs::Options options;
  options.dimensions = of.shift.size();
  options.sigma = 0.5;
  options.population = 10;
  options.seed = seed;
  app::RestartedCmaEs search(options);
  while (search.evaluations() < 100'000) {
    std::vector<double> values;
    for (const Point& point : search.ask()) {
      Point x = point;
      for (std::size_t d = 0; d < x.size(); ++d) {
        x[d] = (2.0 * point[d] - 1.0) * of.half - of.shift[d] + of.optimum;
      }
      values.push_back(of.function(x));
      if (values.back() <= of.accuracy) {
        return search.evaluations() + values.size();
      }
    }
    search.tell(values);
  }
  return 0;
}

Attempts attempts(const CecFunction& of, int runs) {
  Attempts made;
  for (int seed = 1; seed <= runs; ++seed) {
    if (const std::size_t count = evaluationsOf(of, static_cast<std::uint64_t>(seed))) {
      ++made.successes;
      made.evaluations += static_cast<double>(count);
    }
  }
  made.evaluations /= made.successes;
  return made;
}

/// The points of some generations of a run.
std::vector<Point> pointsOf(const Objective& function, int generations) {
  app::CmaEs::Options options;
  options.start = Point(4, 0.7);
  options.seed = 5;
  app::CmaEs search(options);
  std::vector<Point> points;
  for (int k = 0; k < generations; ++k) {
    std::vector<double> values;
    for (const Point& point : search.ask()) {
      points.push_back(point);
      values.push_back(function(point));
    }
    search.tell(values);
  }
  return points;
}

}  // namespace

/// Published numbers: A. Auger & N. Hansen 2005, "A restart CMA evolution strategy with increasing
/// population size", Proceedings of the IEEE Congress on Evolutionary Computation: numbers of
/// evaluations of functions 1, 6 and 9 for n = 10, 25 runs, accuracies 1e-6, 1e-2 and 1e-2: 1.61e3
/// and 1.08e4 (all runs successful), 7.57e4 per success (19 runs successful).
class CmaEsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sphere_needsThePublishedEvaluations() {
    const Attempts made =
        attempts({sphere,
                  100.0,
                  0.0,
                  {-39.3, 58.9, -46.3, -74.7, -16.8, -80.5, -10.6, 25.0, 89.8, 9.1},
                  1e-6},
                 25);
    QCOMPARE(made.successes, 25);
    QVERIFY2(std::fabs(made.evaluations / 1.61e3 - 1.0) < 0.2,
             std::to_string(made.evaluations).c_str());
  }

  /// Negative weights, which the published version did not have, need fewer evaluations.
  void rosenbrock_needsAtMostThePublishedEvaluations() {
    const Attempts made = attempts({rosenbrock,
                                    100.0,
                                    1.0,
                                    {81.0, -48.4, 19.2, -2.5, 70.4, 47.2, -7.8, -86.7, 57.9, 8.2},
                                    1e-2},
                                   25);
    QCOMPARE(made.successes, 25);
    QVERIFY2(made.evaluations < 1.2 * 1.08e4, std::to_string(made.evaluations).c_str());
  }

  /// More runs: the result of 25 varies by a fifth between sets of seeds.
  void rastrigin_needsThePublishedEvaluations() {
    constexpr int kRuns = 50;
    const Attempts made = attempts(
        {rastrigin,
         5.0,
         0.0,
         {1.9005, -1.5644, -0.9788, -2.2536, 2.4990, -3.2853, 0.9759, -3.6661, 0.0985, -3.2465},
         1e-2},
        kRuns);
    QVERIFY2(made.successes >= kRuns * 19 / 25, std::to_string(made.successes).c_str());
    QVERIFY2(std::fabs(made.perSuccess(kRuns) / 7.57e4 - 1.0) < 0.2,
             std::to_string(made.perSuccess(kRuns)).c_str());
  }

  /// The optimum of a linear function is a corner of the box.
  void box_optimumAtTheBounds_isFoundWithinIt() {
    app::RestartedCmaEs::Options options;
    options.start = Point(5, 0.5);
    app::RestartedCmaEs search(options);
    while (search.evaluations() < 2000) {
      std::vector<double> values;
      for (const Point& point : search.ask()) {
        for (const double x : point) {
          QVERIFY(x >= 0.0 && x <= 1.0);
        }
        values.push_back(point[0] - point[1] + point[2] - point[3] + point[4]);
      }
      search.tell(values);
    }
    QVERIFY(std::fabs(search.bestValue() + 2.0) < 1e-3);
  }

  void points_dependOnTheOrderOfValuesOnly() {
    const std::vector<Point> points = pointsOf(sphere, 20);
    QVERIFY(points == pointsOf(sphere, 20));
    QVERIFY(points == pointsOf([](const Point& x) { return std::log(sphere(x)) - 7.0; }, 20));
    QVERIFY(points != pointsOf([](const Point& x) { return -sphere(x); }, 20));
  }

  void values_notFinite_areTheWorst() {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double large = std::numeric_limits<double>::infinity();
    const auto half = [](double value) {
      return [value](const Point& x) { return x[0] > 0.7 ? value : sphere(x); };
    };
    const std::vector<Point> points = pointsOf(half(large), 20);
    QVERIFY(points == pointsOf(half(none), 20));
    QVERIFY(std::fabs(points.back()[0]) < 0.5);
  }

  void restart_hasTwiceThePopulation() {
    app::RestartedCmaEs::Options options;
    options.dimensions = 2;
    options.population = 6;
    app::RestartedCmaEs search(options);
    while (search.restarts() < 2) {
      const std::size_t points = search.ask().size();  // begins the next run if one has ended
      QCOMPARE(points, std::size_t{6} << static_cast<unsigned>(search.restarts()));
      search.tell(std::vector<double>(search.ask().size(), 1.0));  // a flat function
    }
    QVERIFY(search.evaluations() > 18);
  }
};

QTEST_APPLESS_MAIN(CmaEsTest)
#include "tst_CmaEs.moc"
