#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace sim2d::nav2 {

/// A value with its derivatives by N variables (forward differentiation).
template <std::size_t N>
struct DualNumber {
  double value = 0.0;
  std::array<double, N> slopes = {};

  DualNumber() = default;
  DualNumber(double constant) : value(constant) {}  // NOLINT: numbers are constants
  static DualNumber variable(double at, std::size_t index) {
    DualNumber number(at);
    number.slopes[index] = 1.0;
    return number;
  }
  /// f(x) by its value and derivative there.
  DualNumber mapped(double f, double derivative) const {
    DualNumber result(f);
    for (std::size_t i = 0; i < N; ++i) {
      result.slopes[i] = derivative * slopes[i];
    }
    return result;
  }
  DualNumber operator-() const { return mapped(-value, -1.0); }
  friend DualNumber operator+(DualNumber a, const DualNumber& b) {
    a.value += b.value;
    for (std::size_t i = 0; i < N; ++i) {
      a.slopes[i] += b.slopes[i];
    }
    return a;
  }
  friend DualNumber operator-(const DualNumber& a, const DualNumber& b) { return a + (-b); }
  friend DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    DualNumber result(a.value * b.value);
    for (std::size_t i = 0; i < N; ++i) {
      result.slopes[i] = a.slopes[i] * b.value + a.value * b.slopes[i];
    }
    return result;
  }
  friend DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    return a * b.mapped(1.0 / b.value, -1.0 / (b.value * b.value));
  }
};

template <std::size_t N>
DualNumber<N> sqrt(const DualNumber<N>& x) {
  const double root = std::sqrt(x.value);
  return x.mapped(root, root > 0.0 ? 0.5 / root : 0.0);
}

}  // namespace sim2d::nav2
