#include "sim2d/base/Math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "sim2d/base/Types.h"

// Arguments are reduced with constants split into parts whose products with the number of periods
// are exact (Cody and Waite 1980), then a Taylor series is evaluated. Only operations that IEEE 754
// rounds correctly are used: + - * / sqrt fmod ldexp frexp.
namespace base {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr double kLn2High = 0x1.62e42fefp-1;  // 33 bits
constexpr double kLn2Low = 0x1.473de6af278edp-34;
constexpr double kInvLn2 = 0x1.71547652b82fep+0;

constexpr double kHalfPiA = 0x1.921fb544p+0;  // A, B, C: 33 bits each, D: the remainder
constexpr double kHalfPiB = 0x1.0b4611a6p-34;
constexpr double kHalfPiC = 0x1.3198a2ep-69;
constexpr double kHalfPiD = 0x1.b839a252049c1p-104;
constexpr double kHalfPi = 0x1.921fb54442d18p+0;
constexpr double kHalfPiLow = 0x1.1a62633145c07p-54;

constexpr double kLargestAngle = 1e5;  // below it the products with A, B and C are exact

// The templates below work on one number or, with the same bits for each, on two.
using Two = double __attribute__((vector_size(16)));

/// Rounds to the nearest integer, ties to even, for |x| < 2^51, as nearbyint does, without a call:
/// the sum has no fraction bits.
template <class Number>
Number nearest(const Number& x) {
  constexpr double kNoFraction = 0x1.8p52;
  const Number sum = x + kNoFraction;
  return sum - kNoFraction;
}

/// x * 2^exponent, without a call if both factors and the product are normal numbers.
double scaled(double x, int exponent) {
  constexpr int kBias = 1023;
  constexpr unsigned kFraction = 52;  // [bits]
  if (exponent < -1000 || exponent > 1000) {
    return std::ldexp(x, exponent);
  }
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + kBias) << kFraction;
  double factor = 0.0;
  std::memcpy(&factor, &bits, sizeof(factor));
  return x * factor;
}

/// mantissa * 2^exponent
struct SplitNumber {
  double mantissa;  // [0.5, 1)
  int exponent;
};

/// Splits a finite number > 0 as frexp does, without a call for normal numbers.
SplitNumber splitNumber(double x) {
  constexpr std::uint64_t kFractionBits = (std::uint64_t{1} << 52U) - 1;
  constexpr int kBiasOfHalf = 1022;
  if (x < std::numeric_limits<double>::min()) {
    SplitNumber split{};
    split.mantissa = std::frexp(x, &split.exponent);
    return split;
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof(x));
  const int exponent = static_cast<int>(bits >> 52U) - kBiasOfHalf;
  bits = (bits & kFractionBits) | (std::uint64_t{kBiasOfHalf} << 52U);
  std::memcpy(&x, &bits, sizeof(x));
  return {x, exponent};
}

/// -x if `isNegative`, else x.
double negatedIf(double x, bool isNegative) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof(x));
  bits ^= std::uint64_t{isNegative ? 1U : 0U} << 63U;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}

/// Sum of c[i] * x^i.
template <class Number, std::size_t N>
Number polynomial(const std::array<double, N>& c, const Number& x) {
  Number sum = c[N - 1] * x + c[N - 2];
  for (std::size_t i = N - 2; i > 0; --i) {
    sum = sum * x + c[i - 1];
  }
  return sum;
}

/// 1/first!, sign/(first + stride)!, 1/(first + 2 stride)! …
template <std::size_t N>
constexpr std::array<double, N> inverseFactorials(int first, int stride, double sign) {
  std::array<double, N> c{};
  double factorial = 1.0;  // exact up to 18!
  double alternating = 1.0;
  int n = 1;
  for (std::size_t i = 0; i < N; ++i) {
    for (; n <= first + stride * static_cast<int>(i); ++n) {
      factorial *= n;
    }
    c[i] = alternating / factorial;
    alternating *= sign;
  }
  return c;
}

constexpr auto kExp = inverseFactorials<12>(2, 1, 1.0);  // e^r = 1 + r + r^2 (…)
constexpr auto kSin = inverseFactorials<8>(3, 2, -1.0);  // sin r = r - r^3 (…)
constexpr auto kCos = inverseFactorials<7>(4, 2, -1.0);  // cos r = 1 - r^2/2 + r^4 (…)

/// An unevaluated sum of two numbers.
template <class Number>
struct UnevaluatedSum {
  Number high;
  Number low;
};
using DoubleDouble = UnevaluatedSum<double>;

/// An angle as quarter turns, a whole number, plus a remainder of at most an eighth turn.
template <class Number>
struct ReducedAngle {
  Number quarters;
  UnevaluatedSum<Number> rest;
};

/// a + b without rounding error (Knuth's TwoSum).
template <class Number>
UnevaluatedSum<Number> twoSum(const Number& a, const Number& b) {
  const Number sum = a + b;
  const Number part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// |x| <= kLargestAngle
template <class Number>
ReducedAngle<Number> reduceAngle(const Number& x) {
  const Number turns = nearest<Number>(x / kHalfPi);
  const auto b = twoSum<Number>(x - turns * kHalfPiA, -turns * kHalfPiB);
  const auto c = twoSum<Number>(b.high, -turns * kHalfPiC);
  return {turns, twoSum<Number>(c.high, b.low + c.low - turns * kHalfPiD)};
}

template <class Number>
Number sinOfReduced(const UnevaluatedSum<Number>& a) {
  const Number z = a.high * a.high;
  return a.high + (a.low * (1.0 - 0.5 * z) - a.high * z * polynomial<Number>(kSin, z));
}

template <class Number>
Number cosOfReduced(const UnevaluatedSum<Number>& a) {
  const Number z = a.high * a.high;
  const Number half = 0.5 * z;
  const Number head = 1.0 - half;
  const Number lost = (1.0 - head) - half;
  return head + (lost + (z * z * polynomial<Number>(kCos, z) - a.high * a.low));
}

double withoutWholeTurns(double x) {
  return std::abs(x) <= kLargestAngle ? x : std::fmod(x, 2.0 * kPi);
}

/// Sine and cosine of an angle from those of its remainder.
SinCos turnedByQuarters(double sine, double cosine, double quarters) {
  const int quadrant = static_cast<int>(quarters) & 3;
  const bool isAcross = (quadrant & 1) != 0;  // branchless: quadrants are unpredictable
  return {negatedIf(isAcross ? cosine : sine, (quadrant & 2) != 0),
          negatedIf(isAcross ? sine : cosine, ((quadrant + 1) & 2) != 0)};
}

/// sin(x + quarters * pi / 2)
double sinShifted(double x, int quarters) {
  if (!std::isfinite(x)) {
    return kNaN;
  }
  const auto [turns, rest] = reduceAngle(withoutWholeTurns(x));
  const int quarter = (static_cast<int>(turns) + quarters) & 3;
  const double value = quarter % 2 == 0 ? sinOfReduced(rest) : cosOfReduced(rest);
  return quarter < 2 ? value : -value;
}

/// atan(i / 8)
constexpr std::array<DoubleDouble, 9> kAtanOfEighths = {{
    {0.0, 0.0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
}};

/// atan of t in [0, 1]: the nearest eighth from the table plus a series for the difference.
double atanOfUnit(double t) {
  static constexpr std::array<double, 7> kSeries = {1.0 / 3,  -1.0 / 5,  1.0 / 7, -1.0 / 9,
                                                    1.0 / 11, -1.0 / 13, 1.0 / 15};
  const double eighths = nearest(t * 8.0);
  const double centre = eighths / 8.0;
  const DoubleDouble& known = kAtanOfEighths[static_cast<std::size_t>(eighths)];
  const double u = (t - centre) / (1.0 + t * centre);
  const double z = u * u;
  return known.high + (u - (u * z * polynomial(kSeries, z) - known.low));
}

/// If any component is infinite, infinite components become +-1 and finite ones 0, so that their
/// ratio is defined.
double limited(double component, bool anyInfinite) {
  if (!anyInfinite) {
    return component;
  }
  return std::isinf(component) ? std::copysign(1.0, component) : 0.0;
}

/// value * 2^exponent
template <class Number>
struct SplitExp {
  Number value, exponent;
};

/// exp of a number for which the result neither overflows nor underflows.
template <class Number>
SplitExp<Number> splitExp(const Number& x) {
  const Number k = nearest<Number>(x * kInvLn2);
  const Number high = x - k * kLn2High;
  const Number r = high - k * kLn2Low;
  const Number lost = (high - r) - k * kLn2Low;
  return {1.0 + (r + (lost + r * r * polynomial<Number>(kExp, r))), k};
}

}  // namespace

double exp(double x) {
  if (std::isnan(x)) {
    return x;
  }
  if (x > 709.79) {
    return kInfinity;
  }
  if (x < -745.14) {
    return 0.0;
  }
  const SplitExp<double> split = splitExp(x);
  return scaled(split.value, static_cast<int>(split.exponent));
}

void expArray(double* numbers, std::size_t count) {
  const auto isUsual = [](double x) { return std::abs(x) < 700.0; };
  std::size_t i = 0;
  for (; i + 1 < count; i += 2) {
    double& first = numbers[i];
    double& second = numbers[i + 1];
    if (isUsual(first) && isUsual(second)) {
      const SplitExp<Two> split = splitExp(Two{first, second});
      first = scaled(split.value[0], static_cast<int>(split.exponent[0]));
      second = scaled(split.value[1], static_cast<int>(split.exponent[1]));
    } else {
      first = exp(first);
      second = exp(second);
    }
  }
  if (i < count) {
    numbers[i] = exp(numbers[i]);
  }
}

double log(double x) {
  if (std::isnan(x) || x < 0.0) {
    return kNaN;
  }
  if (x == 0.0) {
    return -kInfinity;
  }
  if (std::isinf(x)) {
    return x;
  }
  // Coefficients 2/3, 2/5 … of log((1 + s) / (1 - s)) = 2 s + s (2/3 s^2 + 2/5 s^4 + …)
  static constexpr std::array<double, 10> kSeries = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,
                                                     2.0 / 11, 2.0 / 13, 2.0 / 15, 2.0 / 17,
                                                     2.0 / 19, 2.0 / 21};
  auto [mantissa, exponent] = splitNumber(x);
  const bool isLow = mantissa < 0x1.6a09e667f3bcdp-1;  // sqrt(1/2)
  mantissa *= isLow ? 2.0 : 1.0;
  exponent -= isLow ? 1 : 0;
  const double f = mantissa - 1.0;
  const double s = f / (2.0 + f);
  const double z = s * s;
  const double half = 0.5 * f * f;
  const double series = z * polynomial(kSeries, z);
  const double k = exponent;
  return k * kLn2High + (f - (half - (s * (half + series) + k * kLn2Low)));
}

double sin(double x) {
  return sinShifted(x, 0);
}

double cos(double x) {
  return sinShifted(x, 1);
}

SinCos sinCos(double x) {
  if (!std::isfinite(x)) {
    return {kNaN, kNaN};
  }
  const auto [quarters, rest] = reduceAngle(withoutWholeTurns(x));
  return turnedByQuarters(sinOfReduced(rest), cosOfReduced(rest), quarters);
}

void sinCosArray(const double* angles, SinCos* results, std::size_t count) {
  const auto isUsual = [](double x) { return std::abs(x) <= kLargestAngle; };
  std::size_t i = 0;
  for (; i + 1 < count; i += 2) {
    if (isUsual(angles[i]) && isUsual(angles[i + 1])) {
      const auto [quarters, rest] = reduceAngle<Two>(Two{angles[i], angles[i + 1]});
      const Two sine = sinOfReduced(rest);
      const Two cosine = cosOfReduced(rest);
      results[i] = turnedByQuarters(sine[0], cosine[0], quarters[0]);
      results[i + 1] = turnedByQuarters(sine[1], cosine[1], quarters[1]);
    } else {
      results[i] = sinCos(angles[i]);
      results[i + 1] = sinCos(angles[i + 1]);
    }
  }
  if (i < count) {
    results[i] = sinCos(angles[i]);
  }
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) {
    return kNaN;
  }
  const bool anyInfinite = std::isinf(x) || std::isinf(y);
  const double a = std::abs(limited(x, anyInfinite));
  const double b = std::abs(limited(y, anyInfinite));
  if (a == 0.0 && b == 0.0) {
    return 0.0;
  }
  double angle = 0.0;  // of (|x|, |y|)
  if (b <= a) {
    angle = atanOfUnit(b / a);
  } else {
    angle = kHalfPi - (atanOfUnit(a / b) - kHalfPiLow);
  }
  if (x < 0.0) {
    angle = kPi - (angle - 2.0 * kHalfPiLow);
  }
  return y < 0.0 && angle < kPi ? -angle : angle;
}

double acos(double x) {
  if (std::isnan(x)) {
    return x;
  }
  const double c = std::min(std::abs(x), 1.0);
  const double angle = 2.0 * atanOfUnit(std::sqrt((1.0 - c) / (1.0 + c)));
  return x < 0.0 ? kPi - (angle - 2.0 * kHalfPiLow) : angle;
}

double tanh(double x) {
  if (std::isnan(x)) {
    return x;
  }
  const double size = std::abs(x);
  if (size < 0.55) {
    // Lambert's continued fraction up to the ninth level, written as x - x * (…) / (…).
    static constexpr std::array<double, 4> kRest = {11486475, 810810, 12870, 44};
    static constexpr std::array<double, 5> kBelow = {34459425, 16216200, 945945, 13860, 45};
    const double z = x * x;
    return x - x * (z * polynomial(kRest, z) / polynomial(kBelow, z));
  }
  const double value = size > 20.0 ? 1.0 : 1.0 - 2.0 / (exp(2.0 * size) + 1.0);
  return std::copysign(value, x);
}

}  // namespace base
