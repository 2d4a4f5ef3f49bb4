#pragma once

/// Elementary functions that give the same bits on every x86-64 (the C library chooses its own by
/// CPU). For whatever moves a body or draws a parameter. Stated error: 4 units in the last place
/// over the ranges below; NaN in, NaN out.
namespace base {

double exp(double x);  // 0 below -745, infinity above 709.78
double log(double x);  // x > 0; -infinity at 0, NaN below
double sin(double x);  // |x| <= 1e5; beyond it the argument is reduced by whole turns first
double cos(double x);  // idem
struct SinCos {
  double sin, cos;
};
SinCos sinCos(double x);           // the same values, in less time than one after the other
double atan2(double y, double x);  // (-pi, pi]; 0 at the origin
double acos(double x);             // the argument is clamped to [-1, 1]
double tanh(double x);

}  // namespace base
