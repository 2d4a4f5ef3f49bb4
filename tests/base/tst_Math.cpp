#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include <QtTest>

#include "sim2d/base/Math.h"
#include "sim2d/base/Types.h"
#include "tests/support/Columns.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kDraws = 40000;
constexpr double kAllowedUlps = 4.0;

/// Distance of a result from the C library's value in extended precision, in units of its last
/// place.
double ulps(double got, long double wanted) {
  const double rounded = std::abs(static_cast<double>(wanted));
  const double unit = std::nextafter(rounded, kInf) - rounded;
  return static_cast<double>(std::abs(got - wanted) / unit);
}

enum class Spread { Even, Logarithmic, NearQuarterTurns };

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// The generator's own bits: std:: distributions differ between libraries.
double draw(std::mt19937_64& generator, Spread spread, double low, double high) {
  const double unit = static_cast<double>(generator() >> 11U) * 0x1p-53;
  if (spread == Spread::Logarithmic) {
    return std::exp(std::log(low) + unit * (std::log(high) - std::log(low)));
  }
  const double value = low + unit * (high - low);
  if (spread == Spread::Even) {
    return value;
  }
  const long double quarter = 1.57079632679489661923132169163975144L;
  return static_cast<double>(std::round(static_cast<long double>(value) / quarter) * quarter);
}

using Ours = double (*)(double);
using Theirs = long double (*)(long double);

struct Pair {
  Ours ours;
  Theirs theirs;
};

double worst(Pair function, Spread spread, double low, double high) {
  std::mt19937_64 generator(20240317);
  double error = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = draw(generator, spread, low, high);
    const double at = ulps(function.ours(x), function.theirs(x));
    if (std::isnan(at)) {
      return kInf;
    }
    error = std::max(error, at);
  }
  return error;
}

}  // namespace

Q_DECLARE_METATYPE(Pair)

class MathTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void function_overItsRange_staysWithinFourUlps_data() {
    addColumns<Pair, int, double, double>({"function", "spread", "low", "high"});
    const auto row = [](const char* name, Ours ours, Theirs theirs, Spread spread, double low,
                        double high) {
      QTest::newRow(name) << Pair{ours, theirs} << static_cast<int>(spread) << low << high;
    };
    row("exp", base::exp, expl, Spread::Even, -708.0, 709.7);
    row("exp near 0", base::exp, expl, Spread::Even, -1.0, 1.0);
    row("exp subnormal", base::exp, expl, Spread::Even, -745.0, -708.0);
    row("log", base::log, logl, Spread::Logarithmic, 1e-320, 1e308);
    row("log near 1", base::log, logl, Spread::Even, 0.9, 1.1);
    row("sin", base::sin, sinl, Spread::Even, -7.0, 7.0);
    row("sin wide", base::sin, sinl, Spread::Even, -1e5, 1e5);
    row("sin near its zeros", base::sin, sinl, Spread::NearQuarterTurns, -99990.0, 99990.0);
    row("sin tiny", base::sin, sinl, Spread::Logarithmic, 1e-300, 1e-3);
    row("cos", base::cos, cosl, Spread::Even, -7.0, 7.0);
    row("cos wide", base::cos, cosl, Spread::Even, -1e5, 1e5);
    row("cos near its zeros", base::cos, cosl, Spread::NearQuarterTurns, -99990.0, 99990.0);
    row("acos", base::acos, acosl, Spread::Even, -1.0, 1.0);
    row("acos near 1", base::acos, acosl, Spread::Even, 0.999999, 1.0);
    row("acos near -1", base::acos, acosl, Spread::Even, -1.0, -0.999999);
    row("tanh", base::tanh, tanhl, Spread::Even, -22.0, 22.0);
    row("tanh near 0", base::tanh, tanhl, Spread::Even, -1.0, 1.0);
    row("tanh tiny", base::tanh, tanhl, Spread::Logarithmic, 1e-300, 1e-2);
  }

  void function_overItsRange_staysWithinFourUlps() {
    QFETCH(Pair, function);
    QFETCH(int, spread);
    QFETCH(double, low);
    QFETCH(double, high);
    const double error = worst(function, static_cast<Spread>(spread), low, high);
    QVERIFY2(error <= kAllowedUlps, QByteArray::number(error).constData());
  }

  void atan2_allQuadrants_staysWithinFourUlps() {
    std::mt19937_64 generator(7);
    for (int i = 0; i < kDraws; ++i) {
      const double y = draw(generator, Spread::Even, -1.0, 1.0);
      const double size = draw(generator, Spread::Logarithmic, 1e-12, 1e12);
      const double x = draw(generator, Spread::Even, -size, size);
      const long double wanted = atan2l(y, x);
      if (static_cast<double>(wanted) == -base::kPi) {
        continue;  // rounds to the cut, where ours is +pi: see the table below
      }
      const double error = ulps(base::atan2(y, x), wanted);
      QVERIFY2(error <= kAllowedUlps, QByteArray::number(error).constData());
    }
  }

  void atan2_axesAndLimits_areExact_data() {
    addColumns<double, double, double>({"y", "x", "angle"});
    QTest::newRow("origin") << 0.0 << 0.0 << 0.0;
    QTest::newRow("negative zeros") << -0.0 << -0.0 << 0.0;
    QTest::newRow("right") << 0.0 << 2.0 << 0.0;
    QTest::newRow("up") << 3.0 << 0.0 << base::kPi / 2;
    QTest::newRow("down") << -3.0 << 0.0 << -base::kPi / 2;
    QTest::newRow("left") << 0.0 << -1.0 << base::kPi;
    QTest::newRow("left, zero from below") << -0.0 << -1.0 << base::kPi;
    QTest::newRow("left, rounded to the cut") << -1e-300 << -1.0 << base::kPi;
    QTest::newRow("diagonal") << 1.0 << 1.0 << base::kPi / 4;
    QTest::newRow("infinite up") << kInf << 1.0 << base::kPi / 2;
    QTest::newRow("infinite left") << 1.0 << -kInf << base::kPi;
    QTest::newRow("both infinite") << -kInf << kInf << -base::kPi / 4;
    QTest::newRow("smallest numbers") << 5e-324 << 5e-324 << base::kPi / 4;
  }

  void atan2_axesAndLimits_areExact() {
    QFETCH(double, y);
    QFETCH(double, x);
    QFETCH(double, angle);
    QVERIFY(base::atan2(y, x) == angle);
  }

  void exp_atItsLimits_overflowsAndUnderflows() {
    QVERIFY(base::exp(0.0) == 1.0);
    QVERIFY(std::isfinite(base::exp(709.78)));
    QVERIFY(base::exp(709.79) == kInf);
    QVERIFY(base::exp(kInf) == kInf);
    QVERIFY(base::exp(-745.0) > 0.0);
    QVERIFY(base::exp(-746.0) == 0.0);
    QVERIFY(base::exp(-kInf) == 0.0);
  }

  void expEach_hasTheBitsOfExp() {
    std::mt19937_64 random(5);
    std::vector<double> numbers = {kNan, 1.0,    kInf, -kInf, -744.0, 0.0,
                                   -0.0, -800.0, 1e-9, 709.7, -699.9, 1e300};
    for (int i = 0; i < 999; ++i) {
      numbers.push_back(-60.0 + 65.0 * static_cast<double>(random() >> 11U) * 0x1p-53);
    }
    for (const std::size_t first : {0U, 1U}) {  // either of a pair
      std::vector<double> each(numbers.begin() + static_cast<std::ptrdiff_t>(first), numbers.end());
      base::expArray(each.data(), each.size());
      for (std::size_t i = 0; i < each.size(); ++i) {
        const double one = base::exp(numbers[first + i]);
        QVERIFY2(bitsOf(each[i]) == bitsOf(one), qPrintable(QString::number(i)));
      }
    }
  }

  void sinCosArray_hasTheBitsOfSinCos() {
    std::mt19937_64 random(6);
    std::vector<double> angles = {kNan, 1.0, kInf, -0.0, 1e5, 100000.5, -1e300, 0.0, 1e-300};
    for (int i = 0; i < 999; ++i) {
      angles.push_back(-20.0 + 40.0 * static_cast<double>(random() >> 11U) * 0x1p-53);
    }
    for (const std::size_t first : {0U, 1U}) {  // either of a pair
      std::vector<base::SinCos> results(angles.size() - first);
      base::sinCosArray(angles.data() + first, results.data(), results.size());
      for (std::size_t i = 0; i < results.size(); ++i) {
        const base::SinCos one = base::sinCos(angles[first + i]);
        const bool isSame =
            bitsOf(results[i].sin) == bitsOf(one.sin) && bitsOf(results[i].cos) == bitsOf(one.cos);
        QVERIFY2(isSame, qPrintable(QString::number(angles[first + i])));
      }
    }
  }

  void log_outsideItsRange_isInfiniteOrNan() {
    QVERIFY(base::log(1.0) == 0.0);
    QVERIFY(base::log(0.0) == -kInf);
    QVERIFY(base::log(-0.0) == -kInf);
    QVERIFY(base::log(kInf) == kInf);
    QVERIFY(std::isnan(base::log(-1e-300)));
    QVERIFY(std::isnan(base::log(-kInf)));
  }

  void sinCos_hugeArguments_areBoundedAndPeriodic() {
    for (const double x : {1e6, -3e8, 1e15, 1e300}) {
      const double s = base::sin(x);
      const double c = base::cos(x);
      QVERIFY(std::abs(s * s + c * c - 1.0) < 1e-15);
      QVERIFY(base::sin(std::fmod(x, 2.0 * base::kPi)) == s);
    }
    QVERIFY(std::isnan(base::sin(kInf)));
    QVERIFY(std::isnan(base::cos(-kInf)));
  }

  void sin_signedZero_keepsItsSign() {
    QVERIFY(base::sin(0.0) == 0.0 && !std::signbit(base::sin(0.0)));
    QVERIFY(base::cos(0.0) == 1.0);
    QVERIFY(base::sin(5e-324) == 5e-324);
  }

  void sinCos_anyAngle_areSinAndCos() {
    for (int i = -4000; i <= 4000; ++i) {
      const double x = i < 0 ? 25.7 * i : 0.003 * i;
      const base::SinCos both = base::sinCos(x);
      QVERIFY(both.sin == base::sin(x) && both.cos == base::cos(x));
      QVERIFY(std::signbit(both.sin) == std::signbit(base::sin(x)));  // of zeros too
    }
    QVERIFY(std::isnan(base::sinCos(std::nan("")).sin));
    QVERIFY(std::isnan(base::sinCos(std::nan("")).cos));
  }

  void acos_outsideItsRange_isClamped() {
    QVERIFY(base::acos(1.0) == 0.0);
    QVERIFY(base::acos(1.0000001) == 0.0);
    QVERIFY(base::acos(-1.0) == base::kPi);
    QVERIFY(base::acos(-2.0) == base::kPi);
    QVERIFY(base::acos(0.0) == base::kPi / 2);
  }

  void tanh_farOut_isOne() {
    QVERIFY(base::tanh(0.0) == 0.0);
    QVERIFY(base::tanh(800.0) == 1.0);
    QVERIFY(base::tanh(-kInf) == -1.0);
  }

  void everyFunction_nan_staysNan() {
    for (const Ours function :
         {base::exp, base::log, base::sin, base::cos, base::acos, base::tanh}) {
      QVERIFY(std::isnan(function(kNan)));
    }
    QVERIFY(std::isnan(base::atan2(kNan, 1.0)));
    QVERIFY(std::isnan(base::atan2(kInf, kNan)));
  }

  /// Not a question of accuracy: one number for all compilers, build types and processors. It
  /// changes together with the trajectories of all recorded runs.
  void everyFunction_anyBuild_givesTheSameBits() {
    std::mt19937_64 generator(11);
    std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a over words
    const auto add = [&hash](double value) { hash = (hash ^ bitsOf(value)) * 1099511628211ULL; };
    for (int i = 0; i < 20000; ++i) {
      const double x = draw(generator, Spread::Even, -50.0, 50.0);
      const double y = draw(generator, Spread::Even, -1.0, 1.0);
      for (const double value : {base::exp(x), base::log(std::abs(x)), base::sin(x), base::cos(x),
                                 base::atan2(y, x), base::acos(y), base::tanh(y)}) {
        add(value);
      }
    }
    QCOMPARE(QByteArray::number(static_cast<qulonglong>(hash), 16), QByteArray("f338bd2392062119"));
  }
};

QTEST_APPLESS_MAIN(MathTest)
#include "tst_Math.moc"
