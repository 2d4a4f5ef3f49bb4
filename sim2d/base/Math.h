#pragma once

#include <cstddef>

/// Elementary functions with identical results on every x86-64 processor (the C library selects its
/// implementation by processor). Used for motion and for drawn parameters. Error: at most 4 units
/// in the last place over the ranges below. NaN gives NaN.
namespace base {

double exp(double x);  // 0 below -745, infinity above 709.78
double log(double x);  // x > 0; -infinity at 0, NaN below
double sin(double x);  // |x| <= 1e5; larger arguments are first reduced by whole turns
double cos(double x);  // as sin
struct SinCos {
  double sin, cos;
};
SinCos sinCos(double x);           // the same values, faster than two calls
double atan2(double y, double x);  // (-pi, pi]; 0 at the origin
double acos(double x);             // the argument is clamped to [-1, 1]
double tanh(double x);

/// Functions of Math.h for arrays, with identical results.

/// Replaces each number by its exp.
void expArray(double* numbers, std::size_t count);
/// results[i] = sinCos(angles[i])
void sinCosArray(const double* angles, SinCos* results, std::size_t count);

}  // namespace base
