#pragma once

#include <vector>

#include "sim2d/base/Types.h"

namespace app {

/// A path [m] as a JSON array of [x, y].
template <class Json>
Json pathJson(const std::vector<base::Vec2>& path) {
  Json points = Json::array();
  for (const base::Vec2& point : path) {
    points.push_back({point.x(), point.y()});
  }
  return points;
}

/// The path that pathJson() wrote. Throws exceptions of the JSON library for other values.
template <class Json>
std::vector<base::Vec2> pathOfJson(const Json& points) {
  std::vector<base::Vec2> path;
  path.reserve(points.size());
  for (const Json& point : points) {
    path.emplace_back(point.at(0).template get<double>(), point.at(1).template get<double>());
  }
  return path;
}

}  // namespace app
