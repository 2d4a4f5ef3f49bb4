#include <cmath>
#include <functional>
#include <vector>

#include <QtTest>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/global/ConstrainedResiduals.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "tests/nav/CostmapSketch.h"

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

namespace {

bool isNear(double a, double b, double tolerance = 1e-9) {
  return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b));
}

/// Residuals as functions, whose derivatives are differences.
class Functions final : public LeastSquares {
 public:
  using Function = std::function<double(const std::vector<double>&)>;
  Functions(std::vector<Function> functions, std::vector<std::vector<std::size_t>> variables)
      : functions_(std::move(functions)), variables_(std::move(variables)) {}
  std::size_t bandwidth() const override { return 2; }
  std::vector<Group> groups(const std::vector<double>& point) const override {
    std::vector<Group> all;
    for (std::size_t i = 0; i < functions_.size(); ++i) {
      Group group;
      group.variables = variables_[i];
      group.values = {functions_[i](point)};
      for (const std::size_t variable : variables_[i]) {
        std::vector<double> high = point, low = point;
        high[variable] += 1e-6;
        low[variable] -= 1e-6;
        group.derivatives.push_back((functions_[i](high) - functions_[i](low)) / 2e-6);
      }
      all.push_back(group);
    }
    return all;
  }

 private:
  std::vector<Function> functions_;
  std::vector<std::vector<std::size_t>> variables_;
};

/// A costmap whose costs fall off from a wall along x at y = 0.
Costmap slope() {
  Costmap costmap(80, 80, 0.05, {0.0, 0.0});
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 80; ++column) {
      costmap.set({column, row}, static_cast<std::uint8_t>(std::max(0, 200 - 5 * row)));
    }
  }
  return costmap;
}

Path line(const std::vector<Vec2>& places, double heading) {
  Path path;
  for (const Vec2& place : places) {
    path.push_back({place, heading});
  }
  return path;
}

/// Half the sum of the squared residuals of a path whose stretches were all of equal length, as the
/// description has it, without costs.
double objective(const ConstrainedSmootherParameters& p, const std::vector<Vec2>& given,
                 const std::vector<Vec2>& places) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const double before = (given[i] - given[i - 1]).norm();
    const double after = (given[i + 1] - given[i]).norm();
    const double ratio = before / after;
    const Vec2 bend = ratio * (places[i + 1] - places[i]) - (places[i] - places[i - 1]);
    const double smooth = p.wSmooth * bend.squaredNorm();
    const double distance = p.wDist * (places[i] - given[i]).squaredNorm();
    const Vec2 a = places[i - 1], b = places[i], c = places[i + 1];
    const double area2 = (b - a).x() * (c - b).y() - (b - a).y() * (c - b).x();
    double curve = 0.0;
    if (std::abs(area2) >= 1e-4) {  // radius of the circumscribed circle: abc / (4 area)
      const double curvature =
          2.0 * std::abs(area2) / ((b - a).norm() * (c - b).norm() * (c - a).norm());
      const double excess = curvature - 1.0 / p.minimumTurningRadius;
      curve = excess > 1e-4 ? p.wCurve * excess * excess : 0.0;
    }
    sum += smooth * smooth + distance * distance + curve * curve;
  }
  return 0.5 * sum;
}

}  // namespace

/// The constrained smoother: its residuals against a second evaluation, its derivatives against
/// differences, its minimum against the conditions of a minimum.
class Nav2ConstrainedSmootherTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// y = 1 + 2 x through (0, 1), (1, 3), (2, 5.3): by the normal equations 0.95 and 2.15.
  void leastSquares_line_isFittedInOneStep() {
    const auto at = [](double x, double y) {
      return [x, y](const std::vector<double>& p) { return p[0] + p[1] * x - y; };
    };
    const Functions problem({at(0.0, 1.0), at(1.0, 3.0), at(2.0, 5.3)}, {{0, 1}, {0, 1}, {0, 1}});
    std::vector<double> point = {0.0, 0.0};
    const LeastSquaresResult end = minimizeLeastSquares(problem, {}, point);
    QVERIFY(end.isConverged);
    QVERIFY(isNear(point[0], 0.95, 1e-3) && isNear(point[1], 2.15, 1e-3));
    // Of the residuals -0.05, 0.1, -0.05.
    QVERIFY(isNear(end.lastCost, 0.5 * (0.0025 + 0.01 + 0.0025), 1e-5));
  }

  /// Rosenbrock's valley: the minimum lies at (1, 1).
  void leastSquares_valley_isFollowedToItsEnd() {
    const Functions problem(
        {[](const std::vector<double>& p) { return 10.0 * (p[1] - p[0] * p[0]); },
         [](const std::vector<double>& p) { return 1.0 - p[0]; }},
        {{0, 1}, {0}});
    std::vector<double> point = {-1.2, 1.0};
    const LeastSquaresResult end = minimizeLeastSquares(problem, {}, point);
    QVERIFY(isNear(end.firstCost, 12.1, 1e-9));
    QVERIFY(isNear(point[0], 1.0, 1e-4) && isNear(point[1], 1.0, 1e-4));
    QVERIFY(end.lastCost < 1e-8 && end.iterations < 60);
  }

  /// Stretches of 0.1 m and 0.2 m in a line, ratio 0.5: no bend. Moved by 0.1 m aside: the bend is
  /// 0.5 (b - p) - (p - a) = (0, -0.05 - 0.1).
  void residuals_straightPath_byHand() {
    ConstrainedSmootherParameters p;
    p.wDist = 3.0;
    p.wCurve = 0.0;
    SmoothTerm term;
    term.given = {1.1, 3.0};
    term.ratio = 0.5;
    term.costWeight = 0.5;
    const Costmap costmap = slope();
    SmoothResiduals found = smoothResiduals(term, p, costmap, {1.0, 3.0}, {1.1, 3.0}, {1.3, 3.0});
    QVERIFY(isNear(found[0].value, 0.0) && isNear(found[1].value, 0.0) &&
            isNear(found[2].value, 0.0));
    found = smoothResiduals(term, p, costmap, {1.0, 3.0}, {1.1, 3.1}, {1.3, 3.0});
    QVERIFY(isNear(found[0].value, 2e6 * 0.15 * 0.15));
    QVERIFY(isNear(found[2].value, 3.0 * 0.01));
    // Costs are linear there, so the spline is exact: 200 - 100 (y - 0.025) with y in metres.
    found = smoothResiduals(term, p, costmap, {1.0, 1.0}, {1.1, 1.0}, {1.3, 1.0});
    QVERIFY(isNear(found[3].value, 0.5 * 102.5 * 102.5));
    // Two points of the robot, 0.2 m to both sides of a way along x, with weights 1 and 3.
    p.costCheckPoints = {0.0, 0.2, 1.0, 0.0, -0.2, 3.0};
    found = smoothResiduals(term, p, costmap, {1.0, 1.0}, {1.1, 1.0}, {1.3, 1.0});
    QVERIFY(isNear(found[3].value, 0.5 * (0.25 * 82.5 * 82.5 + 0.75 * 122.5 * 122.5)));
    term.isReversing = true;  // it comes backward: left and right are exchanged
    found = smoothResiduals(term, p, costmap, {1.0, 1.0}, {1.1, 1.0}, {1.3, 1.0});
    QVERIFY(isNear(found[3].value, 0.5 * (0.25 * 122.5 * 122.5 + 0.75 * 82.5 * 82.5)));
  }

  /// Three points of a circle of 0.25 m; the least radius is 0.4 m.
  void residuals_arc_byHand() {
    ConstrainedSmootherParameters p;
    SmoothTerm term;
    const auto at = [](double angle) {
      return Vec2(2.0 + 0.25 * std::cos(angle), 2.0 + 0.25 * std::sin(angle));
    };
    const Costmap costmap = slope();
    const auto curvature = [&](double radius) {
      p.minimumTurningRadius = radius;
      return smoothResiduals(term, p, costmap, at(0.2), at(0.6), at(1.2))[1].value;
    };
    QVERIFY(isNear(curvature(0.4), 30.0 * (4.0 - 2.5) * (4.0 - 2.5)));
    QCOMPARE(curvature(0.25), 0.0);
    QCOMPARE(curvature(0.2), 0.0);
    QCOMPARE(curvature(0.0), 0.0);  // a robot that turns in place
    QVERIFY(parameterErrors(p).empty());
    const Vec2 tangent = arcDirection(at(0.2), at(0.6), at(1.2), false).normalized();
    const double sine = tangent.x() * std::cos(0.6) + tangent.y() * std::sin(0.6);
    QVERIFY(std::abs(sine) < 1e-9);  // across the radius
    // At a cusp the third point is mirrored: (b) of p = (2, 2), a = (1.8, 2), b = (1.8, 2.1).
    term.ratio = -1.0;
    p.minimumTurningRadius = 1e6;
    const double mirrored =
        smoothResiduals(term, p, costmap, {1.8, 2.0}, {2.0, 2.0}, {1.8, 2.1})[1].value;
    const double chord = Vec2(2.2 - 1.8, 1.9 - 2.0).norm();
    const double expected = 2.0 * 0.2 * 0.1 / (0.2 * std::hypot(0.2, 0.1) * chord) - 1e-6;
    QVERIFY(isNear(mirrored, 30.0 * expected * expected));
  }

  void residuals_slopes_areThoseOfDifferences() {
    ConstrainedSmootherParameters p;
    p.wDist = 2.0;
    p.costCheckPoints = {0.2, 0.1, 1.0, -0.3, 0.0, 2.0};
    SmoothTerm term;
    term.given = {1.0, 1.0};
    term.ratio = 0.8;
    term.costWeight = 0.015;
    Costmap costmap = slope();
    costs::Numbers numbers(3);
    for (std::uint8_t& cost : costmap.costs()) {
      cost = static_cast<std::uint8_t>(numbers.between(0.0, 250.0));
    }
    const std::vector<double> at = {0.83, 0.97, 1.02, 1.04, 1.21, 0.93};
    const auto residuals = [&](const std::vector<double>& x) {
      return smoothResiduals(term, p, costmap, {x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]});
    };
    const SmoothResiduals found = residuals(at);
    for (std::size_t i = 0; i < kSmoothResiduals; ++i) {
      QVERIFY(found[i].value > 0.0);
      for (std::size_t k = 0; k < at.size(); ++k) {
        std::vector<double> high = at, low = at;
        high[k] += 1e-6;
        low[k] -= 1e-6;
        const double slope = (residuals(high)[i].value - residuals(low)[i].value) / 2e-6;
        QVERIFY2(isNear(found[i].derivatives[Eigen::Index(k)], slope, 1e-4),
                 qPrintable(QStringLiteral("residual %1, variable %2: %3, not %4")
                                .arg(i)
                                .arg(k)
                                .arg(found[i].derivatives[Eigen::Index(k)])
                                .arg(slope)));
      }
    }
  }

  /// Equal steps with a zigzag of 5 cm. Any pose moved by half a millimetre costs more.
  void smooth_zigzag_isAMinimum() {
    std::vector<Vec2> given;
    for (int i = 0; i <= 20; ++i) {
      given.emplace_back(0.5 + 0.1 * i, i % 2 == 0 || i < 2 || i > 18 ? 3.5 : 3.55);
    }
    ConstrainedSmootherParameters p;
    p.wDist = 1e4;
    p.wCost = 0.0;
    p.minimumTurningRadius = 0.01;
    p.fnTol = 1e-14;
    p.maxIterations = 2000;
    const Costmap free(80, 80, 0.05, {0.0, 0.0});
    const SmoothResult smoothed = smoothPath(p, Distro::Jazzy, line(given, 0.0), free, 10.0);
    QVERIFY(smoothed.error == SmoothError::None);
    QCOMPARE(smoothed.path.size(), given.size());
    std::vector<Vec2> places;
    for (const Pose2& pose : smoothed.path) {
      places.push_back(pose.position);
    }
    const double before = objective(p, given, given), least = objective(p, given, places);
    QVERIFY2(least < 0.5 * before, qPrintable(QString::number(least / before)));
    for (std::size_t i = 2; i + 2 < places.size(); ++i) {
      for (const Vec2& aside :
           {Vec2(5e-4, 0.0), Vec2(-5e-4, 0.0), Vec2(0.0, 5e-4), Vec2(0.0, -5e-4)}) {
        std::vector<Vec2> moved = places;
        moved[i] += aside;
        QVERIFY(objective(p, given, moved) > least);
      }
    }
  }

  /// A right angle in steps of 0.1 m has a radius of 0.07 m; afterwards it is near the least one.
  void smooth_corner_keepsTheRadius() {
    Path path;
    for (int i = 0; i < 20; ++i) {
      path.push_back({{0.5 + 0.1 * i, 1.0}, 0.0});
    }
    for (int i = 0; i < 20; ++i) {
      path.push_back({{2.5, 1.0 + 0.1 * i}, base::kPi / 2.0});
    }
    ConstrainedSmootherParameters p;
    p.wCost = 0.0;
    p.wSmooth = 15000.0;
    p.maxIterations = 1000;
    p.minimumTurningRadius = 0.5;
    const Costmap free(80, 80, 0.05, {0.0, 0.0});
    const SmoothResult smoothed = smoothPath(p, Distro::Jazzy, path, free, 10.0);
    const auto least = [](const Path& of) {
      double radius = 1e9;
      for (std::size_t i = 1; i + 1 < of.size(); ++i) {
        const Vec2 a = of[i - 1].position, b = of[i].position, c = of[i + 1].position;
        const double area2 = std::abs((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x());
        radius = std::min(radius, (b - a).norm() * (c - b).norm() * (c - a).norm() / (2.0 * area2));
      }
      return radius;
    };
    QVERIFY(least(path) < 0.08);
    QVERIFY2(least(smoothed.path) > 0.4, qPrintable(QString::number(least(smoothed.path))));
  }

  /// Beside a slope of costs the path moves towards lower ones.
  void smooth_obstacle_isAvoided() {
    std::vector<Vec2> given;
    for (int i = 0; i <= 30; ++i) {
      given.emplace_back(0.5 + 0.1 * i, 0.8);
    }
    ConstrainedSmootherParameters p;
    p.wSmooth = 20000.0;
    const SmoothResult smoothed = smoothPath(p, Distro::Jazzy, line(given, 0.0), slope(), 10.0);
    QCOMPARE(smoothed.path.size(), given.size());
    QVERIFY(smoothed.path[15].position.y() > 0.9);
    QVERIFY(std::abs(smoothed.path[0].position.y() - 0.8) < 1e-12);
    QVERIFY(std::abs(smoothed.path[1].position.y() - 0.8) < 1e-12);  // keeps the first heading
    QVERIFY(std::abs(smoothed.path[30].position.y() - 0.8) < 1e-12);
  }

  /// One of three poses is moved and the others lie on curves between; or two for each of the path.
  void smooth_factors_countPoses() {
    std::vector<Vec2> given;
    for (int i = 0; i <= 30; ++i) {
      given.emplace_back(0.5 + 0.1 * i, 2.0 + 0.1 * std::sin(0.3 * i));
    }
    const Costmap free(80, 80, 0.05, {0.0, 0.0});
    ConstrainedSmootherParameters p;
    p.pathDownsamplingFactor = 3;
    Path smoothed = smoothPath(p, Distro::Jazzy, line(given, 0.0), free, 10.0).path;
    QCOMPARE(smoothed.size(), given.size());
    for (std::size_t i = 1; i < smoothed.size(); ++i) {
      QVERIFY(std::abs((smoothed[i].position - smoothed[i - 1].position).norm() - 0.1) < 0.03);
      QVERIFY(std::abs(smoothed[i].heading) < 0.8);
    }
    p.pathUpsamplingFactor = 2;
    smoothed = smoothPath(p, Distro::Jazzy, line(given, 0.0), free, 10.0).path;
    QCOMPARE(smoothed.size(), 2 * given.size() - 1);
  }

  /// Forward along x, then backward: headings stay ahead, places near the turning point.
  void smooth_cusp_keepsDirections() {
    Path path;
    for (int i = 0; i <= 15; ++i) {
      path.push_back({{0.5 + 0.1 * i, 2.0}, 0.0});
    }
    for (int i = 1; i <= 15; ++i) {
      path.push_back({{2.0 - 0.1 * i, 2.0 + 0.02 * i * i / 15.0}, 0.0});
    }
    const Costmap free(80, 80, 0.05, {0.0, 0.0});
    const SmoothResult smoothed =
        smoothPath(ConstrainedSmootherParameters(), Distro::Jazzy, path, free, 10.0);
    QVERIFY(smoothed.error == SmoothError::None);
    double farthest = 0.0;
    for (const Pose2& pose : smoothed.path) {
      farthest = std::max(farthest, pose.position.x());
      QVERIFY(std::abs(pose.heading) < 0.5);
    }
    QVERIFY2(std::abs(farthest - 2.0) < 0.15, qPrintable(QString::number(farthest)));
  }

  void smooth_ends_keepTheirHeadings() {
    std::vector<Vec2> given;
    for (int i = 0; i <= 10; ++i) {
      given.emplace_back(0.5 + 0.1 * i, 2.0);
    }
    Path path = line(given, 0.0);
    path.front().heading = 0.3;
    path.back().heading = -0.4;
    const Costmap free(80, 80, 0.05, {0.0, 0.0});
    ConstrainedSmootherParameters p;
    Path smoothed = smoothPath(p, Distro::Jazzy, path, free, 10.0).path;
    QVERIFY(isNear(smoothed.front().heading, 0.3) && isNear(smoothed.back().heading, -0.4));
    p.keepStartOrientation = p.keepGoalOrientation = false;
    smoothed = smoothPath(p, Distro::Jazzy, path, free, 10.0).path;
    QVERIFY(isNear(smoothed.front().heading, 0.0) && isNear(smoothed.back().heading, 0.0));
  }

  void smooth_shortPaths() {
    const Costmap free(80, 80, 0.05, {0.0, 0.0});
    const auto smooth = [&free](const Path& path) {
      return smoothPath(ConstrainedSmootherParameters(), Distro::Jazzy, path, free, 1.0);
    };
    QVERIFY(smooth({}).error == SmoothError::InvalidPath);
    QVERIFY(smooth({{{1.0, 1.0}, 0.0}}).error == SmoothError::FailedToSmoothPath);
    const SmoothResult two = smooth(line({{1.0, 1.0}, {2.0, 1.0}}, 0.0));
    QVERIFY(two.error == SmoothError::None);
    QCOMPARE(two.path.size(), std::size_t{2});
  }
};

QTEST_APPLESS_MAIN(Nav2ConstrainedSmootherTest)
#include "tst_Nav2ConstrainedSmoother.moc"
