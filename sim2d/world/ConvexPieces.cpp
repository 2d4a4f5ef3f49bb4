#include "sim2d/world/ConvexPieces.h"

#include <algorithm>
#include <utility>

namespace sim2d {
namespace {

constexpr double kSmallestPiece = 1e-5;  // [m²]; smaller pieces of a footprint are left out

bool isConvex(const std::vector<Vec2>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % points.size()];
    const Vec2& c = points[(i + 2) % points.size()];
    if (base::cross(b - a, c - b) < 0.0) {
      return false;
    }
  }
  return true;
}

bool isEar(const std::vector<Vec2>& points, std::size_t at) {
  const std::size_t count = points.size();
  const std::vector<Vec2> ear = {points[(at + count - 1) % count], points[at],
                                 points[(at + 1) % count]};
  if (base::cross(ear[1] - ear[0], ear[2] - ear[1]) <= 0.0) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool isCorner = i == at || i == (at + 1) % count || i == (at + count - 1) % count;
    if (!isCorner && isInside(ear, points[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::vector<Vec2>> convexPieces(std::vector<Vec2> rest, std::size_t mostCorners) {
  std::vector<std::vector<Vec2>> pieces;
  while (rest.size() > 3 && (rest.size() > mostCorners || !isConvex(rest))) {
    std::size_t ear = 0;
    while (ear + 1 < rest.size() && !isEar(rest, ear)) {
      ++ear;
    }
    const std::size_t count = rest.size();
    pieces.push_back({rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  pieces.push_back(std::move(rest));
  const auto isSliver = [](const std::vector<Vec2>& piece) {
    return signedArea(piece) < kSmallestPiece;
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isSliver), pieces.end());
  return pieces;
}

}  // namespace sim2d
