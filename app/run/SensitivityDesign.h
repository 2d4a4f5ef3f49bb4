#pragma once

#include <cstddef>
#include <vector>

#include "app/run/Design.h"

namespace app {

/// `design.points` random trajectories of dimensions + 1 points (Morris 1991, Technometrics 33).
/// Coordinates are 0, 1/3, 2/3 or 1; consecutive points of a trajectory differ in one of them by
/// 2/3, each coordinate once, in random order. Every level of every coordinate is equally likely.
std::vector<std::vector<double>> morrisPoints(const Design& design, std::size_t dimensions);

/// For each of `design.points` base points: the row of matrix A, the row of B, then per dimension
/// the row of A with this coordinate from B (Saltelli et al. 2010, Comput. Phys. Commun. 181). A
/// and B are a Sobol sequence of twice the dimensions with a random Owen scrambling per coordinate
/// (Burley 2020, J. Comput. Graph. Tech. 9(4)): without it, some pairs of coordinates are
/// correlated in the first hundreds of points, which biases the total indices beyond their
/// intervals.
std::vector<std::vector<double>> saltelliPoints(const Design& design, std::size_t dimensions);

}  // namespace app
