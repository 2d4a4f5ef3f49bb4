#include "sim2d/nav/nav2/route/RouteServer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>

#include <queue>

#include "sim2d/base/Math.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

bool isObstacleCost(std::uint8_t cost) {
  return cost >= kInscribed && cost != kNoInformation;
}

bool isLineFree(const Costmap& costmap, Cell from, Cell to) {
  bool isFree = true;
  visitLine(from, to, [&](Cell cell) {
    isFree = !isObstacleCost(costmap.at(cell));
    return isFree;
  });
  return isFree;
}

/// Dijkstra's search through free cells with 8 neighbours.
class FreeSpaceSearch {
 public:
  FreeSpaceSearch(const Costmap& costmap, Cell from)
      : costmap_(costmap), costs_(costmap.costs().size(), std::numeric_limits<double>::infinity()) {
    reach(from, 0.0);
  }

  /// Index of the first of the wanted cells that is reached; nullopt if there is none within
  /// `maxIterations` cells.
  std::optional<std::size_t> run(const std::vector<std::optional<Cell>>& wanted,
                                 int maxIterations) {
    for (int i = 0; i < maxIterations && !open_.empty(); ++i) {
      const auto [cost, index] = open_.top();
      open_.pop();
      const Cell cell = costmap_.cellOf(index);
      const auto goal = std::find(wanted.begin(), wanted.end(), std::optional(cell));
      if (goal != wanted.end()) {
        return static_cast<std::size_t>(goal - wanted.begin());
      }
      if (cost <= costs_[index]) {
        expand(cell, cost);
      }
    }
    return std::nullopt;
  }

 private:
  void reach(Cell cell, double cost) {
    double& known = costs_[costmap_.indexOf(cell)];
    if (cost < known) {
      known = cost;
      open_.emplace(cost, costmap_.indexOf(cell));
    }
  }
  void expand(Cell cell, double cost) {
    for (int row = -1; row <= 1; ++row) {
      for (int column = -1; column <= 1; ++column) {
        const Cell next{cell.column + column, cell.row + row};
        if (costmap_.contains(next) && !isObstacleCost(costmap_.at(next))) {
          reach(next, cost + std::sqrt(static_cast<double>(row * row + column * column)));
        }
      }
    }
  }

  using Entry = std::tuple<double, std::size_t>;
  const Costmap& costmap_;
  std::vector<double> costs_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

/// Cosine of the angle between two vectors; 0 if one has no length.
double normalizedDot(const Vec2& a, const Vec2& b) {
  constexpr double kMinimum = 1e-6;
  const double lengths = a.norm() * b.norm();
  return lengths < kMinimum ? 0.0 : a.dot(b) / lengths;
}

constexpr double kEpsilon = 1e-6;

void dropFirst(Route& route, const RouteGraph& graph) {
  route.cost -= route.costs.front();
  route.start = graph.edges[route.edges.front()].to;
  route.edges.erase(route.edges.begin());
  route.costs.erase(route.costs.begin());
}

}  // namespace

std::vector<std::size_t> nearestNodes(const RouteGraph& graph, const Vec2& place,
                                      std::size_t count) {
  std::vector<std::size_t> nodes(graph.nodes.size());
  std::iota(nodes.begin(), nodes.end(), std::size_t{0});
  const auto distance = [&](std::size_t node) {
    return (graph.nodes[node].place - place).squaredNorm();
  };
  std::stable_sort(nodes.begin(), nodes.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  nodes.resize(std::min(nodes.size(), count));
  return nodes;
}

std::optional<std::size_t> nodeOfPose(const RouteGraph& graph, const Vec2& place,
                                      const Costmap* costmap,
                                      const RouteServerParameters& parameters) {
  const auto count = static_cast<std::size_t>(std::max(parameters.numNearestNodes, 1));
  const std::vector<std::size_t> nodes =
      nearestNodes(graph, place, parameters.enableNnSearch ? count : 1);
  if (nodes.empty()) {
    return std::nullopt;
  }
  if (!parameters.enableNnSearch || nodes.size() == 1 || costmap == nullptr) {
    return nodes.front();
  }
  const auto from = costmap->worldToCell(place);
  const auto nearest = costmap->worldToCell(graph.nodes[nodes.front()].place);
  if (!from || !nearest || isLineFree(*costmap, *nearest, *from)) {
    return nodes.front();
  }
  std::vector<std::optional<Cell>> wanted;
  wanted.reserve(nodes.size());
  for (const std::size_t node : nodes) {
    wanted.push_back(costmap->worldToCell(graph.nodes[node].place));
  }
  const auto reached =
      FreeSpaceSearch(*costmap, *from).run(wanted, parameters.maxNnSearchIterations);
  return nodes[reached.value_or(0)];
}

Route pruneRoute(Route route, const RouteGraph& graph, const RouteRequest& request, bool isFirst,
                 const RouteServerParameters& parameters, ContinuedEdge& continued) {
  const std::optional<std::size_t> followed = continued.edge;
  continued.edge.reset();
  if (route.edges.empty() || (!request.usesPoses && isFirst)) {
    return route;
  }
  const RouteEdge& first = graph.edges[route.edges.front()];
  const Vec2 begin = graph.nodes[first.from].place, next = graph.nodes[first.to].place;
  const Vec2 on = closestOnSegment({begin, next}, request.start.position);
  const Vec2 past = request.start.position - begin;
  if (normalizedDot(next - begin, past) > kEpsilon &&
      past.norm() > parameters.minPruneDistFromStart &&
      (on - request.start.position).norm() <= parameters.maxPruneDistFromEdge) {
    if (followed == route.edges.front()) {
      continued = {followed, on};
    }
    dropFirst(route, graph);
  }
  if (!parameters.pruneGoal || !request.usesPoses || route.edges.empty()) {
    return route;
  }
  const RouteEdge& last = graph.edges[route.edges.back()];
  const Vec2 before = graph.nodes[last.from].place, end = graph.nodes[last.to].place;
  const Vec2 back = request.goal.position - end;
  const Vec2 onLast = closestOnSegment({before, end}, request.goal.position);
  if (normalizedDot(end - before, back) < -kEpsilon &&
      back.norm() > parameters.minPruneDistFromGoal &&
      (onLast - request.goal.position).norm() <= parameters.maxPruneDistFromEdge) {
    route.cost -= route.costs.back();
    route.edges.pop_back();
    route.costs.pop_back();
  }
  return route;
}

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

RouteServer::RouteServer(const RouteSettings& settings, RouteGraph graph)
    : settings_(settings), graph_(std::move(graph)), operations_(settings.operations) {}

RoutePlan RouteServer::compute(const RouteRequest& request, const RouteScene& scene) const {
  Rerouting none;
  return plan(request, scene, none);
}

RoutePlan RouteServer::plan(const RouteRequest& request, const RouteScene& scene,
                            Rerouting& rerouting) const {
  if (graph_.isEmpty()) {
    return {{RouteError::NoValidGraph, "there is no graph (graph_filepath)", {}}, {}};
  }
  std::optional<std::size_t> start = rerouting.start, goal;
  if (request.usesPoses) {
    const auto nodeOf = [&](const Pose2& pose) {
      return nodeOfPose(graph_, pose.position, scene.global, settings_.server);
    };
    start = start ? start : nodeOf(request.start);
    goal = nodeOf(request.goal);
  } else {
    start = start ? start : graph_.nodeOf(request.startId);
    goal = graph_.nodeOf(request.goalId);
  }
  if (!start || !goal) {
    const std::uint32_t id = start ? request.goalId : request.startId;
    return {{RouteError::IndeterminantNodes, "the graph has no node " + std::to_string(id), {}},
            {}};
  }
  return between(*start, *goal, request, scene, rerouting);
}

RoutePlan RouteServer::between(std::size_t start, std::size_t goal, const RouteRequest& request,
                               const RouteScene& scene, Rerouting& rerouting) const {
  RoutePlan plan;
  plan.route.start = start;
  if (start != goal) {
    static_cast<RouteResult&>(plan) =
        findRoute(graph_, {start, goal, settings_.server.maxIterations}, rerouting.blocked,
                  settings_.scorers, {request, dynamicEdges_, scene});
  }
  if (plan.error != RouteError::None) {
    return plan;
  }
  RouteRequest from = request;
  if (!rerouting.isFirst) {
    from.start = rerouting.pose;
  }
  plan.route = pruneRoute(std::move(plan.route), graph_, from, rerouting.isFirst, settings_.server,
                          rerouting.continued);
  rerouting.isFirst = false;
  plan.path = pathOf(plan.route, graph_, settings_.server, rerouting.continued);
  return plan;
}

void RouteServer::track(const RouteRequest& request, const RouteScene& scene) {
  request_ = request;
  rerouting_ = {};
  operations_.begin();
  startTime_ = scene.time;
  lastUpdate_.reset();
  feedback_ = {};
  follow(scene, false);
}

/// Computes a route and follows it from its beginning.
void RouteServer::follow(const RouteScene& scene, bool isRerouted) {
  RoutePlan plan = this->plan(request_, scene, rerouting_);
  if (plan.error != RouteError::None) {
    fail(plan.error, plan.text);
    return;
  }
  feedback_.plan = std::move(plan);
  feedback_.status = TrackStatus::Running;
  state_ = beginTracking(feedback_.plan.route, graph_, rerouting_.continued);
  publish(isRerouted);
}

void RouteServer::publish(bool isRerouted) {
  ++feedback_.number;
  feedback_.isRerouted = isRerouted;
  feedback_.lastNode = state_.lastNode ? graph_.nodes[*state_.lastNode].id : 0;
  feedback_.nextNode = graph_.nodes[state_.nextNode].id;
  feedback_.currentEdge = state_.current ? graph_.edges[*state_.current].id : 0;
}

void RouteServer::fail(RouteError error, const std::string& text) {
  feedback_.status = TrackStatus::Failed;
  feedback_.plan = {{error, text, {}}, {}};
}

/// Stores the results of operations.
void RouteServer::applyOperations(const OperationsResult& result, double time) {
  if (result.speedLimit) {
    speedLimit_ = result.speedLimit;
  }
  if (result.edgeTime) {
    graph_.edges[result.edgeTime->first].metadata.set(result.timeTag, result.edgeTime->second);
  }
  for (const std::string& event : result.events) {
    events_.push_back({time, event});
  }
}

void RouteServer::reroute(const OperationsResult& result, const RouteScene& scene) {
  if (!settings_.server.aggregateBlockedIds) {
    rerouting_.blocked.clear();
  }
  rerouting_.blocked.insert(result.blocked.begin(), result.blocked.end());
  rerouting_.start = state_.lastNode;
  rerouting_.pose = state_.lastNode ? scene.robot : request_.start;
  rerouting_.continued.edge = state_.current;
  events_.push_back({scene.time, "reroute"});
  follow(scene, true);
}

void RouteServer::update(const RouteScene& scene) {
  constexpr double kRounding = 1e-9;  // [s]
  const double period = 1.0 / settings_.server.trackerUpdateRate;
  const bool isDue = !lastUpdate_ || scene.time - *lastUpdate_ >= period - kRounding;
  if (feedback_.status != TrackStatus::Running || !isDue) {
    return;
  }
  lastUpdate_ = scene.time;
  feedback_.duration = scene.time - startTime_;
  const Route& route = feedback_.plan.route;
  const bool hasChanged =
      isNodeAchieved(state_, scene.robot.position, route, graph_, settings_.server);
  const bool isOver = hasChanged && !advanceToNextEdge(state_, route, graph_);
  const OperationsResult result = operations_.process(hasChanged, {graph_, route, state_, scene});
  applyOperations(result, scene.time);
  if (!result.failure.empty()) {
    fail(RouteError::OperationFailed, result.failure);
  } else if (isOver) {
    feedback_.status = TrackStatus::Succeeded;
    publish(false);
  } else if (result.reroutes) {
    reroute(result, scene);
  } else if (hasChanged || !result.triggered.empty()) {
    publish(false);
  }
}

}  // namespace sim2d::nav2
