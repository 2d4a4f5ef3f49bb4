#include <cmath>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "tests/nav/CostmapSketch.h"

using namespace costs;
using namespace sim2d::nav2;

namespace {

Costmap openMap() {
  return {200, 200, 0.1, {-10.0, -10.0}};
}

Path zigzag(std::size_t count, std::uint64_t seed = 1) {
  Numbers numbers(seed);
  Path path;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.1 * static_cast<double>(i);
    path.push_back({{x, 0.5 * x * x * 0.2 + numbers.between(-0.04, 0.04)}, 0.0});
  }
  return path;
}

/// The formula of the sweeps in plain arrays.
struct Plain {
  std::vector<double> x, y;

  explicit Plain(const Path& path) {
    for (const auto& pose : path) {
      x.push_back(pose.position.x());
      y.push_back(pose.position.y());
    }
  }
  void smooth(int most, double data, double smooth, double tolerance) {
    const std::vector<double> x0 = x, y0 = y;
    double change = tolerance;
    for (int its = 1; change >= tolerance && its < most; ++its) {
      change = 0.0;
      for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const double oldX = x[i], oldY = y[i];
        x[i] += data * (x0[i] - x[i]) + smooth * (x[i + 1] + x[i - 1] - 2.0 * x[i]);
        y[i] += data * (y0[i] - y[i]) + smooth * (y[i + 1] + y[i - 1] - 2.0 * y[i]);
        change += std::fabs(x[i] - oldX) + std::fabs(y[i] - oldY);
      }
    }
  }
};

SmoothResult simple(const Path& path, const SimpleSmootherParameters& parameters = {},
                    Distro distro = Distro::Jazzy, const Costmap& costmap = openMap(),
                    double seconds = 3.0) {
  return smoothPath(parameters, distro, path, costmap, seconds);
}

SmoothResult golay(const Path& path, const SavitzkyGolayParameters& parameters,
                   Distro distro = Distro::Jazzy) {
  return smoothPath(parameters, distro, path, openMap(), 3.0);
}

/// Ten poses to the right, then back to the upper left.
Path withCusp() {
  Path path;
  for (int i = 0; i <= 10; ++i) {
    path.push_back({{0.1 * i, i % 2 == 0 ? 0.0 : 0.02}, 0.0});
  }
  for (int i = 1; i <= 10; ++i) {
    path.push_back({{1.0 - 0.08 * i, 0.06 * i + (i % 2 == 0 ? 0.0 : 0.02)}, 0.0});
  }
  return path;
}

}  // namespace

class Nav2SmoothersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void simple_zigzag_isTheRecomputed_data() {
    QTest::addColumn<int>("refinements");
    QTest::addColumn<int>("maxIts");
    QTest::addColumn<double>("wData");
    QTest::addColumn<double>("wSmooth");
    QTest::newRow("none") << 0 << 1000 << 0.2 << 0.3;
    QTest::newRow("two") << 2 << 1000 << 0.2 << 0.3;
    QTest::newRow("stiff") << 1 << 1000 << 0.5 << 0.1;
    QTest::newRow("soft") << 0 << 20000 << 0.01 << 0.49;
  }

  void simple_zigzag_isTheRecomputed() {
    QFETCH(int, refinements);
    QFETCH(int, maxIts);
    QFETCH(double, wData);
    QFETCH(double, wSmooth);
    SimpleSmootherParameters parameters;
    parameters.doRefinement = refinements > 0;
    parameters.refinementNum = refinements;
    parameters.maxIts = maxIts;
    parameters.wData = wData;
    parameters.wSmooth = wSmooth;
    const Path path = zigzag(40);
    const SmoothResult result = simple(path, parameters);
    QVERIFY(result.error == SmoothError::None && result.wasCompleted);
    Plain plain(path);
    for (int i = 0; i <= refinements; ++i) {
      plain.smooth(maxIts, wData, wSmooth, 1e-10);
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
      QVERIFY(std::fabs(result.path[i].position.x() - plain.x[i]) < 1e-12);
      QVERIFY(std::fabs(result.path[i].position.y() - plain.y[i]) < 1e-12);
    }
  }

  void simple_oneSweep_isByHand() {
    SimpleSmootherParameters parameters;
    parameters.maxIts = 2;  // one sweep
    parameters.doRefinement = false;
    const Path path = {{{0, 0}, 0}, {{1, 1}, 0}, {{2, 0}, 0}, {{3, 1}, 0}, {{4, 0}, 0}};
    const SmoothResult result = simple(path, parameters);
    QVERIFY(result.error == SmoothError::None);
    QVERIFY(!result.wasCompleted);
    // y1 = 1 + 0.3 (0 + 0 - 2), y2 = 0 + 0.3 (1 + 0.4), y3 = 1 + 0.3 (0 + 0.42 - 2)
    QVERIFY(std::fabs(result.path[1].position.y() - 0.4) < 1e-15);
    QVERIFY(std::fabs(result.path[2].position.y() - 0.42) < 1e-15);
    QVERIFY(std::fabs(result.path[3].position.y() - 0.526) < 1e-15);
    QCOMPARE(result.path[4].position, path[4].position);
  }

  void simple_straight_stays() {
    Path path;
    for (int i = 0; i < 20; ++i) {
      path.push_back({{0.25 * i, 0.5 * i}, std::atan2(0.5, 0.25)});
    }
    const SmoothResult result = simple(path);
    for (std::size_t i = 0; i < path.size(); ++i) {
      QVERIFY((result.path[i].position - path[i].position).norm() < 1e-9);
      QVERIFY(std::fabs(result.path[i].heading - path[i].heading) < 1e-9);
    }
  }

  void simple_headings_areAlongThePath() {
    Path path = zigzag(30);
    path.back().heading = 2.2;
    const Path smooth = simple(path).path;
    for (std::size_t i = 0; i + 1 < smooth.size(); ++i) {
      const Vec2 way = smooth[i + 1].position - smooth[i].position;
      QVERIFY(std::fabs(smooth[i].heading - std::atan2(way.y(), way.x())) < 1e-12);
    }
    QCOMPARE(smooth.back().heading, 2.2);  // the goal's
    for (Pose2& pose : path) {
      pose.heading = base::kPi;  // driven backward
    }
    const Path backward = simple(path).path;
    for (std::size_t i = 0; i + 1 < backward.size(); ++i) {
      const Vec2 way = backward[i].position - backward[i + 1].position;
      QVERIFY(std::fabs(base::angleDiff(backward[i].heading, std::atan2(way.y(), way.x()))) < 1e-9);
    }
  }

  void simple_obstacle_keepsTheLastFreeSweep() {
    // A right angle round an obstacle: smoothing cuts the corner until it would touch.
    Path corner;
    for (int i = 0; i <= 20; ++i) {
      corner.push_back({{i <= 10 ? 0.2 * i : 2.0, i <= 10 ? 0.0 : 0.2 * (i - 10)}, 0.0});
    }
    Costmap costmap = openMap();
    const Vec2 inside(1.85, 0.15);  // cell of 0.1 m
    costmap.set(*costmap.worldToCell(inside), 254);
    SimpleSmootherParameters parameters;
    parameters.doRefinement = false;
    parameters.wData = 0.02;  // cuts deep
    const Path open = simple(corner, parameters).path;
    QVERIFY(open[10].position.y() > 0.2);
    const SmoothResult blocked = simple(corner, parameters, Distro::Jazzy, costmap);
    QVERIFY(blocked.error == SmoothError::None);
    QVERIFY(!blocked.wasCompleted);
    QVERIFY(blocked.path[10].position.y() > 0.01);  // some sweeps were possible
    for (const Pose2& pose : blocked.path) {
      QVERIFY(costmap.at(*costmap.worldToCell(pose.position)) < 253);
    }
    // As many sweeps in plain numbers; one more leads into the obstacle.
    Plain plain(corner);
    bool isFound = false, isNextBlocked = false;
    for (int sweeps = 1; sweeps < 60 && !isNextBlocked; ++sweeps) {
      Plain tried(corner);
      tried.smooth(sweeps + 1, 0.02, 0.3, 0.0);
      if (isFound) {
        for (std::size_t i = 0; i < tried.x.size(); ++i) {
          const auto cell = costmap.worldToCell({tried.x[i], tried.y[i]});
          isNextBlocked = isNextBlocked || costmap.at(*cell) == 254;
        }
        QVERIFY(isNextBlocked);
      }
      isFound = std::fabs(tried.y[10] - blocked.path[10].position.y()) < 1e-12;
    }
    QVERIFY(isNextBlocked);
    QVERIFY(blocked.path[10].position.y() < open[10].position.y());
  }

  void simple_unknown_isNoObstacle() {
    const Path path = zigzag(30);
    const Costmap unknown(200, 200, 0.1, {-10.0, -10.0}, 255);
    QCOMPARE(simple(path, {}, Distro::Jazzy, unknown).path, simple(path).path);
    const Costmap inscribed(200, 200, 0.1, {-10.0, -10.0}, 253);
    const SmoothResult stays = simple(path, {}, Distro::Jazzy, inscribed);
    QVERIFY(!stays.wasCompleted);
    QCOMPARE(stays.path[7].position, path[7].position);
  }

  void simple_shortPaths_dependOnDistro() {
    const auto moves = [](std::size_t count, Distro distro) {
      const Path path = zigzag(count);
      return simple(path, {}, distro).path[1].position != path[1].position;
    };
    QVERIFY(!moves(10, Distro::Humble));
    QVERIFY(moves(11, Distro::Humble));
    QVERIFY(!moves(4, Distro::Jazzy));
    QVERIFY(moves(5, Distro::Jazzy));
    QVERIFY(moves(5, Distro::Main));
  }

  void simple_cusp_stays() {
    const Path path = withCusp();
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      const Path smooth = simple(path, {}, distro).path;
      QCOMPARE(smooth[10].position, path[10].position);
      QVERIFY(smooth[5].position != path[5].position);
      QVERIFY(smooth[15].position != path[15].position);
    }
  }

  void simple_inversionNotEnforced_smoothsOver() {
    SimpleSmootherParameters parameters;
    parameters.enforcePathInversion = false;
    const Path path = withCusp();
    QVERIFY(simple(path, parameters, Distro::Kilted).path[10].position.x() <
            path[10].position.x() - 0.02);
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {  // have no such key
      QCOMPARE(simple(path, parameters, distro).path[10].position, path[10].position);
    }
  }

  void simple_outOfTime_dependsOnDistro() {
    const Path path = zigzag(30);
    const double fourSweeps = 4.5 * 30.0 / kSweptPosesPerSecond;  // [s]
    const SmoothResult jazzy = simple(path, {}, Distro::Jazzy, openMap(), fourSweeps);
    QVERIFY(jazzy.error == SmoothError::Timeout);
    QVERIFY(jazzy.path.empty());
    const SmoothResult humble = simple(path, {}, Distro::Humble, openMap(), fourSweeps);
    QVERIFY(humble.error == SmoothError::None);
    QVERIFY(!humble.wasCompleted);
    Plain plain(path);
    plain.smooth(5, 0.2, 0.3, 1e-10);
    QVERIFY(std::fabs(humble.path[7].position.y() - plain.y[7]) < 1e-14);
  }

  void simple_maxIts_isNotCompleted() {
    SimpleSmootherParameters parameters;
    parameters.maxIts = 6;
    const Path path = zigzag(30);
    const SmoothResult result = simple(path, parameters);
    QVERIFY(!result.wasCompleted);
    Plain plain(path);
    plain.smooth(6, 0.2, 0.3, 1e-10);
    QVERIFY(std::fabs(result.path[11].position.y() - plain.y[11]) < 1e-14);
  }

  void simple_converged_solvesTheEquations() {
    // At rest w_data (x_i - y_i) + w_smooth (y_(i+1) + y_(i-1) - 2 y_i) = 0.
    SimpleSmootherParameters parameters;
    parameters.doRefinement = false;
    const Path path = zigzag(30);
    const Path smooth = simple(path, parameters).path;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const Vec2 rest =
          0.2 * (path[i].position - smooth[i].position) +
          0.3 * (smooth[i + 1].position + smooth[i - 1].position - 2.0 * smooth[i].position);
      QVERIFY(rest.norm() < 1e-9);
    }
  }

  void segments_cuspsAndTurns_areFound() {
    const std::vector<PathSegment> cusp = directionalSegments(withCusp());
    QCOMPARE(cusp.size(), std::size_t{2});
    QCOMPARE(cusp[0].last, std::size_t{10});
    QCOMPARE(cusp[1].first, std::size_t{10});
    QCOMPARE(cusp[1].last, std::size_t{20});
    const Path turn = {{{0, 0}, 0}, {{1, 0}, 0}, {{2, 0}, 0}, {{2, 0}, 1.5}, {{2, 1}, 1.5}};
    const std::vector<PathSegment> parts = directionalSegments(turn);
    QCOMPARE(parts.size(), std::size_t{2});
    QCOMPARE(parts[0].last, std::size_t{2});
    QCOMPARE(directionalSegments({{{0, 0}, 0}}).size(), std::size_t{1});
  }

  void weights_sevenOfOrderThree_areThePublished() {
    const auto isNear = [](const std::vector<double>& found, const std::vector<double>& wanted,
                           double divisor) {
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (std::fabs(found[i] - wanted[i] / divisor) > 1e-14) {
          return false;
        }
      }
      return found.size() == wanted.size();
    };
    // Savitzky and Golay 1964, table I, and for the last Madden 1978.
    QVERIFY(isNear(savitzkyGolayWeights(7, 3), {-2, 3, 6, 7, 6, 3, -2}, 21.0));
    QVERIFY(isNear(savitzkyGolayWeights(7, 2), {-2, 3, 6, 7, 6, 3, -2}, 21.0));
    QVERIFY(isNear(savitzkyGolayWeights(5, 2), {-3, 12, 17, 12, -3}, 35.0));
    QVERIFY(isNear(savitzkyGolayWeights(9, 3), {-21, 14, 39, 54, 59, 54, 39, 14, -21}, 231.0));
    QVERIFY(isNear(savitzkyGolayWeights(7, 4), {5, -30, 75, 131, 75, -30, 5}, 231.0));
  }

  void weights_otherWindows_keepPolynomials() {
    for (const int window : {3, 11, 31}) {
      for (int order = 0; order < std::min(window, 6); ++order) {
        const std::vector<double> weights = savitzkyGolayWeights(window, order);
        for (int degree = 0; degree <= order; ++degree) {
          double sum = 0.0;
          for (int i = 0; i < window; ++i) {
            sum += weights[static_cast<std::size_t>(i)] * std::pow((i - window / 2) / 5.0, degree);
          }
          QVERIFY(std::fabs(sum - (degree == 0 ? 1.0 : 0.0)) < 1e-9);
        }
      }
    }
  }

  void golay_polynomial_stays() {
    Path path;
    for (int i = 0; i < 25; ++i) {
      const double x = 0.1 * i;
      path.push_back({{x, 0.1 * x * x * x - 0.2 * x}, 0.0});
    }
    const Path smooth = golay(path, {}).path;
    for (std::size_t i = 9; i < 16; ++i) {  // 3 rounds spoil 9 poses from each end
      QVERIFY((smooth[i].position - path[i].position).norm() < 1e-12);
    }
  }

  void golay_shortPath_stays() {
    QVERIFY(golay(zigzag(10), {}).path == zigzag(10));
    const SmoothResult result = golay(zigzag(25), {});
    QVERIFY(result.error == SmoothError::None && result.wasCompleted);
    QVERIFY(result.path != zigzag(25));
  }

  void golay_windowOfMain_counts() {
    SavitzkyGolayParameters parameters;
    parameters.windowSize = 3;
    parameters.polyOrder = 1;  // the mean of three
    parameters.doRefinement = false;
    const Path path = zigzag(25);
    const Path smooth = golay(path, parameters, Distro::Main).path;
    const double mean = (path[4].position.y() + path[5].position.y() + path[6].position.y()) / 3.0;
    QVERIFY(std::fabs(smooth[5].position.y() - mean) < 1e-14);
    QVERIFY(golay(path, parameters, Distro::Jazzy).path != smooth);
  }

  void both_emptyPath_isInvalid() {
    QVERIFY(simple({}).error == SmoothError::InvalidPath);
    QVERIFY(golay({}, {}).error == SmoothError::InvalidPath);
    QCOMPARE(simple({{{1, 1}, 0.3}}).path.size(), std::size_t{1});
  }
};

QTEST_APPLESS_MAIN(Nav2SmoothersTest)
#include "tst_Nav2Smoothers.moc"
