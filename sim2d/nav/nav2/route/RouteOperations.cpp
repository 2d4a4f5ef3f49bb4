#include "sim2d/nav/nav2/route/RouteOperations.h"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "sim2d/map/Outlines.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

bool isBoundary(const TrackState& state, const Route& route) {
  return state.edge == -1 || state.edge == static_cast<int>(route.edges.size()) - 1;
}

/// Whether a position is past the node, judged by the directions of the edges before and after it.
bool isPast(const Vec2& before, const Vec2& node, const Vec2& after, const Vec2& place) {
  constexpr double kMinimum = 1e-6;  // [m]
  const Vec2 in = node - before, out = after - node;
  if (in.norm() < kMinimum || out.norm() < kMinimum) {
    return true;
  }
  return (in.normalized() + out.normalized()).dot(node - place) <= 0.0;
}

}  // namespace

TrackState beginTracking(const Route& route, const RouteGraph& graph,
                         const ContinuedEdge& continued) {
  TrackState state;
  state.nextNode = route.start;
  if (continued.edge) {
    state.current = continued.edge;
    state.lastNode = graph.edges[*continued.edge].from;
  }
  return state;
}

bool isNodeAchieved(TrackState& state, const Vec2& robot, const Route& route,
                    const RouteGraph& graph, const RouteServerParameters& parameters) {
  constexpr double kThere = 1e-4;  // [m]
  const Vec2 node = graph.nodes[state.nextNode].place;
  const double distance = (node - robot).norm();
  const bool atBoundary = isBoundary(state, route);
  const bool isNear = distance <= (atBoundary ? parameters.boundaryRadiusToAchieveNode
                                              : parameters.radiusToAchieveNode);
  if (distance < kThere || (!isNear && state.isNear)) {
    return true;
  }
  state.isNear = isNear;
  if (atBoundary || !isNear) {
    return isNear;
  }
  const Vec2 before = graph.nodes[graph.edges[*state.current].from].place;
  const std::size_t next = route.edges[static_cast<std::size_t>(state.edge) + 1];
  return isPast(before, node, graph.nodes[graph.edges[next].to].place, robot);
}

bool advanceToNextEdge(TrackState& state, const Route& route, const RouteGraph& graph) {
  state.isNear = false;
  state.lastNode = state.nextNode;
  ++state.edge;
  if (state.edge >= static_cast<int>(route.edges.size())) {
    state.current.reset();
    return false;
  }
  state.current = route.edges[static_cast<std::size_t>(state.edge)];
  state.nextNode = graph.edges[*state.current].to;
  return true;
}

namespace {

bool isLineBlocked(const Costmap& costmap, const Vec2& from, const Vec2& to,
                   const RouteCollisionParameters& monitor) {
  const auto first = costmap.worldToCell(from), last = costmap.worldToCell(to);
  if (!first || !last) {
    return false;
  }
  int number = 0;
  bool isBlocked = false;
  visitLine(*first, *last, [&](Cell cell) {
    if (number++ % std::max(monitor.checkResolution, 1) == 0) {
      const std::uint8_t cost = costmap.at(cell);
      isBlocked = cost >= monitor.maxCost && cost != kNoInformation;
    }
    return !isBlocked;
  });
  return isBlocked;
}

/// The last point of a segment that is on the map, searched cell by cell from its end.
Vec2 lastPointOnMap(const Costmap& costmap, const Vec2& from, const Vec2& to) {
  const int cells = std::max(1, costmap.cellDistance((to - from).norm()));
  int left = cells;
  const auto point = [&] { return Vec2(from + (static_cast<double>(left) / cells) * (to - from)); };
  while (left > 0 && !costmap.worldToCell(point())) {
    --left;
  }
  return point();
}

}  // namespace

std::optional<std::size_t> blockedEdge(const RouteCollisionParameters& monitor,
                                       const OperationsScene& scene) {
  const auto inputs = scene.now.costmapOf(monitor.costmapTopic);
  const Costmap* const costmap = inputs.first;
  if (!scene.state.current || costmap == nullptr) {
    return std::nullopt;
  }
  std::size_t edge = *scene.state.current;
  const auto placeOf = [&](std::size_t node) { return scene.graph.nodes[node].place; };
  const auto inFrame = [&inputs](const Vec2& place) -> Vec2 {
    return toFrame(inputs.second, {place, 0.0}).position;
  };
  Vec2 from =
      closestOnSegment({placeOf(scene.graph.edges[edge].from), placeOf(scene.graph.edges[edge].to)},
                       scene.now.robot.position);
  double left = monitor.maxCollisionDist;
  auto next = static_cast<std::size_t>(scene.state.edge + std::ptrdiff_t{1});
  while (left > 0.0) {
    const Vec2 to = placeOf(scene.graph.edges[edge].to);
    const double length = (to - from).norm();
    const Vec2 end = length > left ? Vec2(from + (left / length) * (to - from)) : to;
    const Vec2 first = inFrame(from);
    if (isLineBlocked(*costmap, first, lastPointOnMap(*costmap, first, inFrame(end)), monitor)) {
      return edge;
    }
    left -= length;
    if (next >= scene.route.edges.size()) {
      break;
    }
    edge = scene.route.edges[next++];
    from = placeOf(scene.graph.edges[edge].from);
  }
  return std::nullopt;
}

void RouteOperations::begin() {
  lastCheck_.reset();
  timedEdge_.reset();
  isRerouteRequested_ = false;
}

OperationsResult RouteOperations::process(bool hasChanged, const OperationsScene& scene) {
  OperationsResult result;
  if (hasChanged) {
    onChange(scene, result);
    onGraph(scene, result);
  }
  onQuery(scene, result);
  return result;
}

/// Measures the time from the beginning to the end of an edge.
void RouteOperations::markTime(const TimeMarkerParameters& marker, const OperationsScene& scene,
                               OperationsResult& result) {
  if (timedEdge_ && scene.now.time > timedSince_) {
    result.edgeTime = std::pair(*timedEdge_, scene.now.time - timedSince_);
    result.timeTag = marker.timeTag;
  }
  timedEdge_ = scene.state.current;
  timedSince_ = scene.now.time;
}

void RouteOperations::onChange(const OperationsScene& scene, OperationsResult& result) {
  constexpr double kFull = 100.0;  // [%]
  for (const auto& [name, settings] : settings_) {
    if (const auto* const limit = std::get_if<AdjustSpeedLimitParameters>(&settings);
        limit != nullptr && scene.state.current) {
      const RouteEdge& edge = scene.graph.edges[*scene.state.current];
      result.speedLimit = edge.metadata.number(limit->speedTag).value_or(kFull);
      result.triggered.push_back(name);
    } else if (const auto* const marker = std::get_if<TimeMarkerParameters>(&settings)) {
      markTime(*marker, scene, result);
      result.triggered.push_back(name);
    }
  }
}

/// Executes the operations in the graph file at the achieved node, the end of the previous edge and
/// the beginning of the next. Each names a plugin.
void RouteOperations::onGraph(const OperationsScene& scene, OperationsResult& result) const {
  using Trigger = RouteOperation::Trigger;
  std::vector<const RouteOperation*> wanted;
  const auto take = [&](const std::vector<RouteOperation>& operations, Trigger trigger) {
    for (const RouteOperation& operation : operations) {
      if (operation.trigger == trigger) {
        wanted.push_back(&operation);
      }
    }
  };
  if (scene.state.lastNode) {
    take(scene.graph.nodes[*scene.state.lastNode].operations, Trigger::Node);
  }
  if (scene.state.current) {
    take(scene.graph.edges[*scene.state.current].operations, Trigger::OnEnter);
  }
  if (scene.state.edge > 0) {
    const std::size_t left = scene.route.edges[static_cast<std::size_t>(scene.state.edge) - 1];
    take(scene.graph.edges[left].operations, Trigger::OnExit);
  }
  for (const RouteOperation* const operation : wanted) {
    const auto found = std::find_if(settings_.begin(), settings_.end(), [&](const auto& each) {
      return each.first == operation->type &&
             std::holds_alternative<TriggerEventParameters>(each.second);
    });
    if (found == settings_.end()) {
      result.failure = "operation '" + operation->type + "' of the graph is not loaded";
      return;
    }
    const std::string& usual = std::get<TriggerEventParameters>(found->second).serviceName;
    result.events.push_back(operation->metadata.text("service_name").value_or(usual));
    result.triggered.push_back(found->first);
  }
}

void RouteOperations::onQuery(const OperationsScene& scene, OperationsResult& result) {
  constexpr double kRounding = 1e-9;  // [s]
  for (const auto& [name, settings] : settings_) {
    if (const auto* const monitor = std::get_if<RouteCollisionParameters>(&settings)) {
      const bool isDue =
          !lastCheck_ || scene.now.time - *lastCheck_ >= 1.0 / monitor->rate - kRounding;
      if (!isDue || !scene.state.current) {  // not evaluated before the first edge
        continue;
      }
      lastCheck_ = scene.now.time;
      const auto edge = blockedEdge(*monitor, scene);
      if (edge && monitor->rerouteOnCollision) {
        result.reroutes = true;
        result.blocked.insert(scene.graph.edges[*edge].id);
        result.triggered.push_back(name);
      } else if (edge) {
        result.failure = "an obstacle is on the route, and reroute_on_collision is false";
      }
    } else if (std::holds_alternative<ReroutingServiceParameters>(settings) &&
               isRerouteRequested_) {
      isRerouteRequested_ = false;
      result.reroutes = true;
      result.triggered.push_back(name);
    }
  }
}

}  // namespace sim2d::nav2
