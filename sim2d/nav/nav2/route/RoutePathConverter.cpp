#include "sim2d/nav/nav2/route/RoutePathConverter.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

/// Appends points of a segment, with its first but not its last point, at equal distances <=
/// `density`.
void addSegment(const Vec2& from, const Vec2& to, double density, std::vector<Vec2>& points) {
  const double length = (to - from).norm();
  const auto count = static_cast<int>(std::ceil(length / density));
  for (int i = 0; i < count; ++i) {
    points.push_back(from + (static_cast<double>(i) / count) * (to - from));
  }
}

Path withHeadings(const std::vector<Vec2>& points, double last) {
  Path path;
  path.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    double heading = last;
    if (i + 1 < points.size()) {
      const Vec2 along = points[i + 1] - points[i];
      heading = base::atan2(along.y(), along.x());
    }
    path.push_back({points[i], heading});
  }
  return path;
}

}  // namespace

CornerArc::CornerArc(const Vec2& start, const Vec2& corner, const Vec2& end, double radius) {
  constexpr double kStraight = 1e-6;  // [rad]
  const Vec2 back = start - corner, on = end - corner;
  const double before = back.norm(), after = on.norm();
  if (before == 0.0 || after == 0.0) {
    return;
  }
  const double angle = base::acos(back.dot(on) / (before * after));  // between the segments
  if (angle < kStraight || base::kPi - angle < kStraight) {
    return;
  }
  const double half = 0.5 * angle;
  const double tangent = radius * base::cos(half) / base::sin(half);
  if (tangent >= before || tangent >= after) {
    return;
  }
  const Vec2 first = back / before, second = on / after;
  begin_ = corner + tangent * first;
  end_ = corner + tangent * second;
  centre_ = corner + (radius / base::sin(half)) * (first + second).normalized();
  isValid_ = true;
}

std::vector<Vec2> CornerArc::points(double step) const {
  const Vec2 from = begin_ - centre_, to = end_ - centre_;
  const double turn = base::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  const int count = std::max(1, static_cast<int>(std::ceil(std::fabs(turn) / step)));
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double angle = turn * i / count;
    const double c = base::cos(angle), s = base::sin(angle);
    points.push_back(centre_ + Vec2(from.x() * c - from.y() * s, from.x() * s + from.y() * c));
  }
  return points;
}

Path pathOf(const Route& route, const RouteGraph& graph, const RouteServerParameters& parameters,
            const ContinuedEdge& continued) {
  std::vector<Vec2> points;
  Vec2 lastFrom = Vec2::Zero(), lastTo = Vec2::Zero();
  if (continued.edge) {
    lastFrom = graph.nodes[graph.edges[*continued.edge].from].place;
    lastTo = graph.nodes[graph.edges[*continued.edge].to].place;
    addSegment(continued.nearest, lastTo, parameters.pathDensity, points);
  }
  Vec2 from = graph.nodes[route.start].place;
  for (std::size_t i = 0; i < route.edges.size(); ++i) {
    const RouteEdge& edge = graph.edges[route.edges[i]];
    lastFrom = graph.nodes[edge.from].place;
    lastTo = graph.nodes[edge.to].place;
    const bool isSmooth = parameters.smoothCorners && i + 1 < route.edges.size();
    if (isSmooth) {
      const Vec2 next = graph.nodes[graph.edges[route.edges[i + 1]].to].place;
      const CornerArc arc(from, lastTo, next, parameters.smoothingRadius);
      if (arc.isValid()) {
        addSegment(from, arc.begin(), parameters.pathDensity, points);
        const auto arcPoints = arc.points(parameters.pathDensity / parameters.smoothingRadius);
        points.insert(points.end(), arcPoints.begin(), arcPoints.end());
        from = arc.end();
        continue;
      }
    }
    addSegment(from, lastTo, parameters.pathDensity, points);
    from = lastTo;
  }
  points.push_back(graph.nodes[route.endOf(graph)].place);
  const Vec2 along = lastTo - lastFrom;
  return withHeadings(points, base::atan2(along.y(), along.x()));
}

}  // namespace sim2d::nav2
