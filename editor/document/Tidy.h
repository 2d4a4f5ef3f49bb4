#pragma once

#include <cmath>

#include "sim2d/base/Types.h"

namespace editor {

/// To the micrometre: sums of steps would otherwise be written as 12.629999999999999.
inline double tidied(double metres) {
  constexpr double kPerMetre = 1e6;
  return std::round(metres * kPerMetre) / kPerMetre + 0.0;  // 0, not -0
}
inline base::Vec2 tidied(const base::Vec2& point) {
  return {tidied(point.x()), tidied(point.y())};
}

}  // namespace editor
