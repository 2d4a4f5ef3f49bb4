#pragma once

#include <vector>

namespace sim2d {

/// Exact Euclidean distance, in cells, from the centre of each cell of a row-major grid to the
/// nearest square of a marked cell: 0 in marked cells, 0.5 beside them, infinity when none is
/// marked. Linear in the number of cells (Felzenszwalb and Huttenlocher 2012, lower envelope of
/// parabolas, here over the borders of cells).
std::vector<float> distancesToMarked(int width, int height, const std::vector<char>& marked);

}  // namespace sim2d
