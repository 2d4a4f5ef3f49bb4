#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <QtTest>

#include "metrics/MapFields.h"
#include "sim2d/map/Obstacles.h"
#include "sim2d/nav/Observation.h"

using base::Vec2;
using metrics::DensityField;
using metrics::GaussianPersonalSpace;
using metrics::personalSpaceOf;
using sim2d::Outline;
using sim2d::Segment;

namespace {

/// The density at a point, summed over all people: the reference of the fields.
double densityAt(const std::vector<Vec2>& people, const Vec2& place) {
  constexpr double kSquare = metrics::kDensityRadius * metrics::kDensityRadius;  // [m²]
  double sum = 0.0;
  for (const Vec2& person : people) {
    sum += std::exp(-(person - place).squaredNorm() / kSquare);
  }
  return sum / (base::kPi * kSquare);
}

constexpr double kHalf = 1.7407963267948966;  // [rad] to each side

std::vector<Segment> edgesOf(const Outline& outline) {
  std::vector<Segment> edges;
  for (std::size_t k = 0; k < outline.points.size(); ++k) {
    edges.push_back({outline.points[k], outline.points[(k + 1) % outline.points.size()]});
  }
  return edges;
}

Outline box(double x, double y, double length, double width, double heading = 0.0) {
  return sim2d::boxOutline({{x, y}, heading}, length, width);
}

}  // namespace

class MapFieldsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// 1 / pi = 0.3183099, 1 / (pi e) = 0.1170997.
  void densityAt_onePerson_isTheKernel() {
    const std::vector<Vec2> one = {{3.0, 4.0}};
    QVERIFY(std::abs(densityAt(one, {3.0, 4.0}) - 0.31830989) < 1e-8);
    QVERIFY(std::abs(densityAt(one, {4.0, 4.0}) - 0.11709966) < 1e-8);
    QVERIFY(std::abs(densityAt(one, {3.0, 2.0}) - 0.31830989 * 0.01831564) < 1e-8);
    QCOMPARE(densityAt({}, {0.0, 0.0}), 0.0);
  }

  /// One person per m² on a square lattice: theta_3(0, 1/e)^2 / pi = 1.7726372048^2 / pi at a
  /// person and theta_2(0, 1/e)^2 / pi = 1.7722704969^2 / pi between four of them (Abramowitz and
  /// Stegun 16.27), both 1 but for 2 parts in 10 000.
  void densityAt_oneForEachSquareMetre_isOne() {
    std::vector<Vec2> crowd;
    for (int x = -8; x <= 8; ++x) {
      for (int y = -8; y <= 8; ++y) {
        crowd.emplace_back(x, y);
      }
    }
    QVERIFY(std::abs(densityAt(crowd, {0.0, 0.0}) - 1.00020691) < 1e-7);
    QVERIFY(std::abs(densityAt(crowd, {0.5, 0.5}) - 0.99979312) < 1e-7);
  }

  /// Whole people: the field adds up to their number.
  void field_ofSomePeople_holdsTheirNumber() {
    const std::vector<Vec2> people = {{5.1, 5.3}, {6.0, 5.0}, {7.77, 8.2}, {12.0, 9.9}};
    const DensityField field = metrics::densityField(people, {0.0, 0.0}, {20.0, 15.0}, 0.25);
    double sum = 0.0;
    for (const float value : field.values) {
      sum += value * field.cell * field.cell;
    }
    QVERIFY2(std::abs(sum - 4.0) < 2e-3, qPrintable(QString::number(sum)));
    QCOMPARE(field.columns, 80);
    QCOMPARE(field.rows, 60);
  }

  void field_atCentres_isTheSumOverAll() {
    std::vector<Vec2> people;
    people.reserve(40);
    for (int k = 0; k < 40; ++k) {  // spread by the golden angle
      people.emplace_back(10.0 + 0.9 * std::sqrt(k) * std::cos(2.39996 * k),
                          8.0 + 0.9 * std::sqrt(k) * std::sin(2.39996 * k));
    }
    const DensityField field = metrics::densityField(people, {1.0, 2.0}, {18.0, 15.0}, 0.4);
    double worst = 0.0;
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < field.columns; ++column) {
        const double exact = densityAt(people, field.centreOf(column, row));
        worst = std::max(worst, std::abs(exact - double(field.at(column, row))));
      }
    }
    QVERIFY2(worst < 40 * 4e-5, qPrintable(QString::number(worst)));
    QVERIFY(worst > 0.0);  // somebody is cut off
    QVERIFY(field.peak() > 0.3);
  }

  void field_peopleBesideTheBox_countAtItsBorder() {
    const DensityField field = metrics::densityField({{-0.5, 0.5}}, {0.0, 0.0}, {3.0, 1.0}, 1.0);
    QVERIFY(std::abs(field.at(0, 0) - 0.11709966) < 1e-6);  // 1 m from the person
    QVERIFY(metrics::densityField({{-50.0, 0.5}}, {0.0, 0.0}, {3.0, 1.0}).peak() == 0.0);
    QVERIFY(metrics::densityField({{500.0, 900.0}}, {0.0, 0.0}, {3.0, 1.0}).peak() == 0.0);
  }

  void field_largeBox_hasFewCells() {
    const DensityField field =
        metrics::densityField({{500.0, 400.0}}, {0.0, 0.0}, {1000.0, 800.0}, 0.25, 10000);
    QVERIFY(field.values.size() <= 10500);
    QVERIFY(std::abs(field.cell - std::sqrt(80.0)) < 1e-9);
  }

  /// Of a record with a place that cannot be.
  void field_longNarrowBox_hasFewCells() {
    const DensityField field = metrics::densityField({{0.0, 0.0}}, {0.0, 0.0}, {2.8e11, 10.0});
    QVERIFY(field.columns <= 4097);
    QCOMPARE(field.rows, 1);
    const DensityField few =
        metrics::densityField({{0.0, 0.0}}, {0.0, 0.0}, {1000.0, 0.001}, 0.25, 100);
    QVERIFY(few.values.size() <= 101);
  }

  /// By hand: 1.2 m/s gives Vf = 2.4, Vr = 1.2, Vs = 1.6 m²; at 1 m ahead exp(-1/4.8) = 0.811936,
  /// behind exp(-1/2.4) = 0.659241, beside exp(-1/3.2) = 0.731616.
  void value_byHand_isTheSame() {
    const GaussianPersonalSpace walking = personalSpaceOf(1.2);
    QVERIFY(std::abs(std::exp(-walking.outsideness({1.0, 0.0})) - 0.811936) < 1e-6);
    QVERIFY(std::abs(std::exp(-walking.outsideness({-1.0, 0.0})) - 0.659241) < 1e-6);
    QVERIFY(std::abs(std::exp(-walking.outsideness({0.0, -1.0})) - 0.731616) < 1e-6);
    const GaussianPersonalSpace standing = personalSpaceOf(0.1);  // Vf = 0.5
    QVERIFY(std::abs(std::exp(-standing.outsideness({1.0, 0.0})) - 0.367879) < 1e-6);
  }

  void contour_everyCorner_hasTheLevel() {
    const GaussianPersonalSpace space = personalSpaceOf(0.9);
    const base::Pose2 person{{2.0, -1.0}, 2.2};
    for (const double level : {0.2, 0.5, 0.8}) {
      for (const Vec2& corner : metrics::personalSpaceContour(space, person, level)) {
        const double value = std::exp(-space.outsideness(person.toLocal(corner)));
        QVERIFY(std::abs(value - level) < 1e-12);
      }
    }
  }

  /// At exp(-1/2) the contour is one standard deviation away: sqrt(2 * 0.5) = 1 m ahead,
  /// sqrt(0.5) = 0.7071 m behind.
  void contour_oneDeviation_isWhereTheRootsSay() {
    const auto contour =
        metrics::personalSpaceContour(personalSpaceOf(0.5), {{0.0, 0.0}, 0.0}, std::exp(-0.5), 4);
    QVERIFY((contour[0] - Vec2(1.0, 0.0)).norm() < 1e-12);
    QVERIFY((contour[1] - Vec2(0.0, std::sqrt(2.0 / 3.0))).norm() < 1e-12);
    QVERIFY((contour[2] - Vec2(-std::sqrt(0.5), 0.0)).norm() < 1e-12);
  }

  /// A regular polygon of n corners on a circle of radius r has n/2 r² sin(2 pi / n): 120 corners
  /// around, 60 in the half.
  void sight_openPlane_isASector() {
    const auto all = metrics::visibilityPolygon({{1.0, 2.0}, 0.3}, base::kPi, 5.0, {});
    QCOMPARE(all.size(), std::size_t{120});
    QVERIFY(std::abs(sim2d::signedArea(all) - 60.0 * 25.0 * std::sin(base::kPi / 60.0)) < 1e-9);
    const auto half = metrics::visibilityPolygon({{1.0, 2.0}, 0.3}, base::kPi / 2.0, 5.0, {});
    QVERIFY(std::abs(sim2d::signedArea(half) - 30.0 * 25.0 * std::sin(base::kPi / 60.0)) < 1e-9);
    QCOMPARE(half.front(), Vec2(1.0, 2.0));
  }

  void sight_insideARoom_isTheRoom() {
    const auto all =
        metrics::visibilityPolygon({{1.0, 0.5}, 2.0}, base::kPi, 50.0, edgesOf(box(0, 0, 6, 4)));
    QVERIFY(std::abs(sim2d::signedArea(all) - 24.0) < 1e-9);
    // The quarter around +x from the middle of a square of side 4: a triangle of 4 m².
    const auto quarter = metrics::visibilityPolygon({{0.0, 0.0}, 0.0}, base::kPi / 4.0, 50.0,
                                                    edgesOf(box(0, 0, 4, 4)));
    QVERIFY(std::abs(sim2d::signedArea(quarter) - 4.0) < 1e-9);
  }

  /// A wall from (1, -1) to (1, 1) hides a trapezoid of a room up to x = 3: the lines through its
  /// ends meet x = 3 at -3 and 3, so that (2 + 6) / 2 * 2 = 8 m² are out of sight.
  void sight_wallInTheMiddle_hidesWhatIsBehind() {
    std::vector<Segment> walls = edgesOf(box(0, 0, 6, 8));  // x to 3, y to 4
    walls.push_back({{1.0, -1.0}, {1.0, 1.0}});
    const auto seen = metrics::visibilityPolygon({{0.0, 0.0}, 0.0}, base::kPi, 50.0, walls);
    QVERIFY(std::abs(sim2d::signedArea(seen) - (48.0 - 8.0)) < 1e-9);
  }

  /// A chord at 3 of 5 m cuts the segment r² (a - sin a cos a), cos a = 3/5, off the circle.
  void sight_wallAcrossTheRange_isCutOff() {
    const auto seen = metrics::visibilityPolygon({{0.0, 0.0}, 0.0}, base::kPi, 5.0,
                                                 {{{3.0, -20.0}, {3.0, 20.0}}});
    const double cut = 25.0 * (std::acos(0.6) - 0.6 * 0.8);
    QVERIFY(std::abs(sim2d::signedArea(seen) - (25.0 * base::kPi - cut)) < 0.05);
    for (const Vec2& corner : seen) {
      QVERIFY(corner.x() < 3.0 + 1e-9 && corner.norm() < 5.0 + 1e-9);
    }
    QVERIFY(std::any_of(seen.begin(), seen.end(), [](const Vec2& corner) {
      return (corner - Vec2(3.0, 4.0)).norm() < 1e-9;
    }));
  }

  /// Lines of sight, one by one, tell the same.
  void sight_anyPlace_isWhatLinesOfSightSay() {
    std::vector<Outline> outlines = {box(0, 0, 20, 14), box(3, 2, 2, 1, 0.4), box(-4, 3, 0.3, 4),
                                     box(-3, -4, 3, 0.5, 1.1), box(5, -3, 1, 1, 0.7)};
    sim2d::Obstacles obstacles;
    std::vector<Segment> walls;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      for (const Segment& edge : edgesOf(outlines[k])) {
        walls.push_back(edge);
      }
      if (k == 0) {  // a room: solid outside
        std::reverse(outlines[k].points.begin(), outlines[k].points.end());
      }
      obstacles.add({outlines[k]});
    }
    obstacles.build();
    std::mt19937 random(7);
    const auto draw = [&random](double low, double high) {
      return low + (high - low) * double(random()) / double(std::mt19937::max());
    };
    const base::Pose2 eye{{-0.5, 0.2}, 0.9};
    const auto seen = metrics::visibilityPolygon(eye, kHalf, 8.0, walls);
    int inside = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vec2 place(draw(-10.0, 10.0), draw(-7.0, 7.0));
      const bool isSeen = sim2d::isInView(eye, place, 8.0, kHalf, obstacles);
      const bool isIn = sim2d::isInside(seen, place);
      inside += isIn ? 1 : 0;
      if (isIn != isSeen) {  // only at the arc, whose chords leave 3 mm out
        QVERIFY2((place - eye.position).norm() > 7.99,
                 qPrintable(QStringLiteral("%1 %2").arg(place.x()).arg(place.y())));
      }
    }
    QVERIFY(inside > 500 && inside < 2500);
  }

  void walls_ofARun_areThoseNearAndClosed() {
    sim2d::TraceHeader header;
    header.obstacles.resize(3);
    header.obstacles[0].outlines = {box(0, 0, 2, 2), box(30, 0, 2, 2)};
    for (const std::size_t door : {1U, 2U}) {
      header.obstacles[door].isDoor = true;
      header.obstacles[door].open = door == 1;
      header.obstacles[door].outlines = {box(0, 3.0 * double(door), 1, 0.1)};
    }
    QCOMPARE(metrics::wallsAround(header, {}, {0.0, 0.0}, 10.0).size(), std::size_t{8});
    QCOMPARE(metrics::wallsAround(header, {0, 0}, {0.0, 0.0}, 10.0).size(), std::size_t{12});
    QCOMPARE(metrics::wallsAround(header, {1, 1}, {0.0, 0.0}, 10.0).size(), std::size_t{4});
    QCOMPARE(metrics::wallsAround(header, {1, 1}, {0.0, 0.0}, 40.0).size(), std::size_t{8});
    QCOMPARE(metrics::wallsAround(header, {1, 1}, {2.5, 2.5}, 2.0).size(), std::size_t{0});
  }
};

QTEST_APPLESS_MAIN(MapFieldsTest)
#include "tst_MapFields.moc"
