#pragma once

#include <array>
#include <cmath>

/// Operators between two values of a formula; comparisons and logic give 1 or 0.
namespace metrics {

struct Operator {
  const char* sign;
  double (*apply)(double, double);
};

inline double truth(bool holds) {
  return holds ? 1.0 : 0.0;
}

/// Undefined stays undefined.
template <class Apply>
double unlessNaN(double a, double b, Apply apply) {
  return std::isnan(a) || std::isnan(b) ? a + b : apply(a, b);
}

// Longer signs first: "<=" before "<".
inline constexpr std::array<Operator, 1> kOr = {
    {{"or", [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p != 0.0 || q != 0.0); });
      }}}};
inline constexpr std::array<Operator, 1> kAnd = {
    {{"and", [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p != 0.0 && q != 0.0); });
      }}}};
inline constexpr std::array<Operator, 6> kCompare = {
    {{"<=",
      [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p <= q); });
      }},
     {">=",
      [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p >= q); });
      }},
     {"==",
      [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p == q); });
      }},
     {"!=",
      [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p != q); });
      }},
     {"<",
      [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p < q); });
      }},
     {">", [](double a, double b) {
        return unlessNaN(a, b, [](double p, double q) { return truth(p > q); });
      }}}};
inline constexpr std::array<Operator, 2> kAdd = {{{"+", [](double a, double b) { return a + b; }},
                                                  {"-", [](double a, double b) { return a - b; }}}};
inline constexpr std::array<Operator, 2> kMultiply = {
    {{"*", [](double a, double b) { return a * b; }},
     {"/", [](double a, double b) { return b == 0.0 ? std::nan("") : a / b; }}}};

}  // namespace metrics
