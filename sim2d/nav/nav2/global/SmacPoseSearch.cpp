#include "sim2d/nav/nav2/global/SmacPoseSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

constexpr double kNoPoseTolerance = 1e-3;  // [cells]
constexpr double kNewCell =
    1.4142135623730951;  // [cells] a move of this length always leaves the cell
constexpr int kAncestors = 8, kAncestorStride = 5;
constexpr std::size_t kMaxPoseNodes = 5000000;
constexpr std::size_t kMaxSlots = 100000000;  // headings of visited cells

}  // namespace

Cell cellAt(const Vec2& inCells) {
  return {static_cast<int>(inCells.x()), static_cast<int>(inCells.y())};
}

Pose2 inCells(const Costmap& costmap, const Pose2& pose, bool isCentred) {
  Vec2 place = (pose.position - costmap.origin()) / costmap.resolution();
  if (isCentred) {
    place = place.array().floor() + 0.5;
  }
  return {place, pose.heading};
}

PlanResult planOverPoses(const Costmap& costmap, const PlanRequest& request,
                         const SmacPoseParameters& parameters, const CarModel& car,
                         const std::function<PlanResult()>& search) {
  if (!costmap.worldToCell(request.start.position)) {
    return {PlanError::StartOutsideMap, {}, 0};
  }
  if (!costmap.worldToCell(request.goal.position)) {
    return {PlanError::GoalOutsideMap, {}, 0};
  }
  if (!std::isfinite(request.start.heading) || !std::isfinite(request.goal.heading)) {
    return {PlanError::Unknown, {}, 0};
  }
  PlanResult result = search();
  for (Pose2& pose : result.path) {
    pose.position = costmap.origin() + costmap.resolution() * pose.position;
  }
  if (parameters.smoothPath && result.iterations > 1) {
    smoothSmacPath(result.path, parameters, request.costmap, car);
  }
  return result;
}

SmacPoseSearch::SmacPoseSearch(const Setup& setup)
    : setup_(setup), costmap_(setup.costmap), blockOf_(setup.costmap.costs().size(), -1) {}

PlanResult SmacPoseSearch::plan(const Pose2& start, const Pose2& goal) {
  const Cell startCell = cellAt(start.position);
  goals_ = goalsAt(goal);
  if (setup_.distro != Distro::Humble) {
    costmap_.set(startCell, kFreeSpace);
  } else if (!costAt(start)) {
    return {PlanError::StartOccupied, {}, 0};
  }
  const auto isFree = [this](const Pose2& each) { return costAt(each).has_value(); };
  if (tolerance() < kNoPoseTolerance && std::none_of(goals_.begin(), goals_.end(), isFree)) {
    return {PlanError::GoalOccupied, {}, 0};
  }
  const Cell goalCell = cellAt(goals_.front().position);
  if (startCell == goalCell &&
      nearestHeading(start.heading) == nearestHeading(goals_.front().heading)) {
    return {PlanError::None, {{start.position, goal.heading}}, 0};
  }
  setup_.obstacles.start(costmap_, goalCell, setup_.heuristic,
                         setup_.parameters.cacheObstacleHeuristic);
  return find(start);
}

std::vector<Pose2> SmacPoseSearch::goalsAt(const Pose2& goal) const {
  const int nearest = nearestHeading(goal.heading), count = setup_.headings;
  const std::string& mode = setup_.parameters.goalHeadingMode;
  const bool hasModes = setup_.distro >= Distro::Kilted;
  std::vector<int> indices = {nearest};
  if (hasModes && mode == "BIDIRECTIONAL") {
    indices.push_back((nearest + count / 2) % count);
  } else if (hasModes && mode == "ALL_DIRECTION") {
    for (int i = 1; i < count; ++i) {
      indices.push_back((nearest + i) % count);
    }
  }
  std::vector<Pose2> goals;
  goals.reserve(indices.size());
  for (const int each : indices) {
    goals.push_back({goal.position, headingOf(each)});
  }
  return goals;
}

bool SmacPoseSearch::isInside(const Vec2& place) const {
  return place.x() >= 0.0 && place.y() >= 0.0 && place.x() < costmap_.width() &&
         place.y() < costmap_.height();
}

bool SmacPoseSearch::isFull() const {
  return nodes_.size() > kMaxPoseNodes ||
         (setup_.kind == Kind::Hybrid && slots_.size() > kMaxSlots);
}

double SmacPoseSearch::tolerance() const {
  return setup_.parameters.tolerance / costmap_.resolution();
}

std::optional<std::uint8_t> SmacPoseSearch::costAt(const Pose2& pose) const {
  if (!isInside(pose.position)) {
    return std::nullopt;
  }
  const bool allowUnknown = setup_.parameters.allowUnknown;
  const std::uint8_t cost = costmap_.at(cellAt(pose.position));
  if (!isSmacFree(cost, allowUnknown)) {
    return std::nullopt;
  }
  const PlanRequest& request = setup_.request;
  const double safe = request.circumscribedCost;
  if (request.footprint.empty() || (safe > 0.0 && cost < safe)) {
    return cost;
  }
  const Pose2 inWorld{costmap_.origin() + costmap_.resolution() * pose.position, pose.heading};
  const std::uint8_t edges = footprintCost(costmap_, request.footprint, inWorld);
  return isEdgeCollision(edges, allowUnknown) ? std::nullopt : std::optional(cost);
}

int SmacPoseSearch::nodeAt(const Vec2& place, int heading) {
  const auto headings = static_cast<std::size_t>(setup_.headings);
  std::int32_t& block = blockOf_[costmap_.indexOf(cellAt(place))];
  if (block < 0) {
    block = static_cast<std::int32_t>(slots_.size() / headings);
    slots_.resize(slots_.size() + headings, -1);
  }
  std::int32_t& slot =
      slots_[static_cast<std::size_t>(block) * headings + static_cast<std::size_t>(heading)];
  if (slot < 0) {
    slot = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().g = std::numeric_limits<double>::max();
    nodes_.back().heading = heading;
  }
  return slot;
}

/// The maximum of the obstacle heuristic and the shortest curve to a goal.
double SmacPoseSearch::estimate(const Node& node) {
  const double round = setup_.obstacles.from(cellAt(node.pose.position));
  double curve = std::numeric_limits<double>::max();
  for (const Pose2& goal : goals_) {
    curve = std::min(curve, curveEstimate(node, goal, round));
  }
  return std::max(round, curve);
}

/// The path to a goal by analytic expansion, or if the node is a goal.
std::optional<Path> SmacPoseSearch::connectToGoal(int index) {
  if (std::optional<Path> whole = tryAnalyticExpansion(index)) {
    return whole;
  }
  const bool isGoal = std::find(goalNodes_.begin(), goalNodes_.end(), index) != goalNodes_.end();
  return isGoal ? std::optional(pathTo(index)) : std::nullopt;
}

void SmacPoseSearch::begin(const Pose2& start) {
  for (const Pose2& goal : goals_) {
    goalNodes_.push_back(nodeAt(goal.position, nearestHeading(goal.heading)));
  }
  const int heading = nearestHeading(start.heading);
  const int first = nodeAt(start.position, heading);
  nodes_[static_cast<std::size_t>(first)].pose = {start.position, headingOf(heading)};
  nodes_[static_cast<std::size_t>(first)].g = 0.0;
  open_.push(0.0, static_cast<std::size_t>(first));
}

PlanResult SmacPoseSearch::find(const Pose2& start) {
  const SmacLimits limits =
      smacLimits(setup_.parameters, setup_.parameters.maxPlanningTime, kSmacHybridPerSecond);
  begin(start);
  PlanResult result;
  int nearGoal = 0;
  while (!open_.isEmpty() && result.iterations < limits.most) {
    if (isFull()) {
      result.error = PlanError::Timeout;
      break;
    }
    const std::size_t at = open_.pop().node;
    const int index = static_cast<int>(at);
    if (nodes_[at].isVisited) {
      continue;
    }
    if (setup_.request.stop != nullptr && result.iterations % limits.checkInterval == 0) {
      setup_.request.stop->check();
    }
    ++result.iterations;
    nodes_[at].isVisited = true;
    if (auto whole = connectToGoal(index)) {
      result.path = *std::move(whole);
      return result;
    }
    if (nearest_.estimate < tolerance() && ++nearGoal >= limits.maxOnApproach) {
      break;
    }
    expand(index);
  }
  endWithoutGoal(result, limits.most);
  return result;
}

/// Uses the path to the node nearest to the goal if it is within the tolerance, or sets the error.
void SmacPoseSearch::endWithoutGoal(PlanResult& result, int mostIterations) const {
  const bool isHybrid = setup_.kind == Kind::Hybrid;
  if (isHybrid && result.error != PlanError::None) {
    return;
  }
  if (nearest_.estimate < tolerance()) {
    result.error = PlanError::None;
    result.path = pathTo(static_cast<int>(nearest_.node));
  } else {
    const bool isDone = isHybrid ? result.iterations < mostIterations : open_.isEmpty();
    result.error = isDone ? PlanError::NoValidPath : PlanError::Timeout;
  }
}

/// Analytic expansion: tries a curve to the goal at intervals that decrease near the goal, from the
/// earliest possible ancestor.
std::optional<Path> SmacPoseSearch::tryAnalyticExpansion(int index) {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  const double ratio = setup_.parameters.analyticExpansionRatio;
  closest_ = std::min(closest_, static_cast<int>(estimate(node)));
  const int desired =
      std::max(static_cast<int>(closest_ / ratio), static_cast<int>(std::ceil(ratio)));
  due_ = std::min(due_, desired);
  if (due_-- > 0) {
    return std::nullopt;
  }
  due_ = desired - 1;
  const Pose2* goal = nullptr;
  std::optional<Path> curve = shortestToGoals(node, goal);
  if (!curve) {
    return std::nullopt;
  }
  const Node* from = &node;
  for (int i = 0; setup_.kind == Kind::Hybrid && i < kAncestors; ++i) {
    const Node* ancestor = ancestorOf(*from);
    auto longer = ancestor == nullptr ? std::nullopt : analyticExpansionFrom(*ancestor, *goal);
    if (!longer) {
      break;
    }
    curve = std::move(longer);
    from = ancestor;
  }
  Path path = pathTo(static_cast<int>(from - nodes_.data()));
  path.insert(path.end(), curve->begin(), curve->end());
  return path;
}

/// Tries every coarse-th heading of the goal first, and all headings if one of these is reachable.
std::optional<Path> SmacPoseSearch::shortestToGoals(const Node& node, const Pose2*& goal) const {
  const auto coarse = static_cast<std::size_t>(std::max(1, setup_.coarseSearchResolution));
  std::optional<Path> shortest;
  double least = std::numeric_limits<double>::max();
  for (const bool isCoarse : {true, false}) {
    for (std::size_t i = 0; i < goals_.size() && (isCoarse || shortest); ++i) {
      if ((i % coarse == 0) != isCoarse) {
        continue;
      }
      const double length = curveLength(node, goals_[i]);
      auto curve = length < least ? analyticExpansionFrom(node, goals_[i]) : std::nullopt;
      if (curve) {
        least = length;
        goal = &goals_[i];
        shortest = std::move(curve);
      }
    }
  }
  return shortest;
}

double SmacPoseSearch::curveLength(const Node& node, const Pose2& goal) const {
  return shortestCurve(setup_.car, node.pose, goal, setup_.turningRadius).length();
}

const SmacPoseSearch::Node* SmacPoseSearch::ancestorOf(const Node& node) const {
  const Node* ancestor = &node;
  for (int i = 0; i < kAncestorStride; ++i) {
    if (ancestor->parent < 0) {
      return nullptr;
    }
    ancestor = &nodes_[static_cast<std::size_t>(ancestor->parent)];
  }
  return ancestor;
}

/// The poses of a curve after its start; nullopt if its length is out of range, it collides or its
/// cost is too high.
std::optional<Path> SmacPoseSearch::analyticExpansionFrom(const Node& node,
                                                          const Pose2& goal) const {
  const ShortestCurve curve = shortestCurve(setup_.car, node.pose, goal, setup_.turningRadius);
  const double length = curve.length();
  const double most = setup_.parameters.analyticExpansionMaxLength / costmap_.resolution();
  if (length > most || length < kNewCell) {
    return std::nullopt;
  }
  const int pieces = static_cast<int>(length / kNewCell);
  Path path;
  std::vector<std::uint8_t> costs;
  for (int i = 1; i <= pieces; ++i) {
    path.push_back(i < pieces ? curve.at(length * i / pieces) : goal);
    const auto cost = costAt(path.back());
    if (!cost) {
      return std::nullopt;
    }
    costs.push_back(*cost);
  }
  return isTooCostly(costs, length) ? std::nullopt : std::optional(std::move(path));
}

/// Whether cells above the maximum cost are elsewhere than in the last part of a curve.
bool SmacPoseSearch::isTooCostly(const std::vector<std::uint8_t>& costs, double length) const {
  const SmacPoseParameters& given = setup_.parameters;
  if (setup_.distro == Distro::Humble) {
    return false;
  }
  const auto isCheap = [&](std::uint8_t cost) { return cost <= given.analyticExpansionMaxCost; };
  if (std::all_of(std::find_if(costs.rbegin(), costs.rend(), isCheap), costs.rend(), isCheap)) {
    return false;
  }
  const double circle = 2.0 * base::kPi * setup_.turningRadius;
  return !(given.analyticExpansionMaxCostOverride && length < circle);
}

Path SmacPoseSearch::pathTo(int index) const {
  std::vector<const Node*> chain;
  for (int at = index; at >= 0; at = nodeWith(at).parent) {
    chain.push_back(&nodeWith(at));
  }
  Path path = {chain.back()->pose};
  for (std::size_t i = chain.size() - 1; i-- > 0;) {
    addPoses(*chain[i + 1], *chain[i], path);
  }
  return path;
}

void SmacPoseSearch::addPoses(const Node& /*parent*/, const Node& node, Path& path) const {
  path.push_back(node.pose);
}

}  // namespace sim2d::nav2
