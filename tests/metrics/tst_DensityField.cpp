#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest>

#include "metrics/MapFields.h"

using base::Vec2;
using metrics::DensityField;

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

}  // namespace

class DensityFieldTest : public QObject {
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
};

QTEST_APPLESS_MAIN(DensityFieldTest)
#include "tst_DensityField.moc"
