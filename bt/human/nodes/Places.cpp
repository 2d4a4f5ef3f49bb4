#include <algorithm>
#include <limits>

#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"
#include "sim2d/base/Rng.h"

/// Nodes that walk to areas and objects; the original does not have them.
namespace bt {

using base::Vec2;

namespace {

constexpr double kReached = 0.3;  // [m]
constexpr int kTries = 32;        // points drawn before a wanderer gives up for this step

/// Even-odd rule.
bool isInside(const std::vector<Vec2>& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

/// Where the horizontal line at `y` crosses the outline, ascending.
std::vector<double> crossingsAt(const std::vector<Vec2>& polygon, double y) {
  std::vector<double> crossings;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > y) != (b.y() > y)) {
      crossings.push_back((b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()) + a.x());
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

/// The mean of the corners; where that is outside, the middle of the widest part at its height.
Vec2 middleOf(const std::vector<Vec2>& polygon) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& corner : polygon) {
    mean += corner;
  }
  mean /= static_cast<double>(polygon.size());
  if (isInside(polygon, mean)) {
    return mean;
  }
  const std::vector<double> crossings = crossingsAt(polygon, mean.y());
  double widest = 0.0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] > widest) {
      widest = crossings[i + 1] - crossings[i];
      mean.x() = 0.5 * (crossings[i] + crossings[i + 1]);
    }
  }
  return mean;
}

struct Memory {
  std::int64_t startStep;
  int human;
  int goalId;
  double x, y;  // walked to
  bool hasTarget;
  bool isThere;
  double duration;  // [s]
};

/// A point of the area that the person can reach.
std::optional<Vec2> drawPoint(LeafContext& leaf, int human, const sim2d::Area& area) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  Vec2 low = area.points.front();
  Vec2 high = area.points.front();
  for (const Vec2& corner : area.points) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const base::AgentRng random(view.seed(), view.constants(human).id,
                              static_cast<std::uint64_t>(view.step()));
  const auto first = static_cast<std::uint32_t>(leaf.node()) * (2 * kTries);
  for (std::uint32_t i = 0; i < kTries; ++i) {
    const double x = random.uniform(low.x(), high.x(), base::Draw::GoalChoice, first + 2 * i);
    const double y = random.uniform(low.y(), high.y(), base::Draw::GoalChoice, first + 2 * i + 1);
    if (isInside(area.points, Vec2(x, y)) && view.isReachable(human, Vec2(x, y))) {
      return Vec2(x, y);
    }
  }
  return std::nullopt;
}

/// The area named by a port; nothing and one warning when there is none.
const sim2d::Area* areaOf(LeafContext& leaf, int port) {
  HumanContext& context = humanOf(leaf);
  const std::string name(leaf.require<std::string_view>(port));
  const sim2d::Area* area = context.view().area(name);
  if (!area || area->points.size() < 3) {
    context.warn(leaf, "tree.runs-without-area", {name});
    return nullptr;
  }
  return area;
}

bool isAt(const HumanContext& context, const Memory& memory) {
  return (context.view().pose(memory.human).position - Vec2(memory.x, memory.y)).norm() <= kReached;
}

void walkOn(HumanContext& context, const Memory& memory) {
  context.move(memory.human,
               walkTo(context, memory.human, {memory.goalId, Vec2(memory.x, memory.y), 0.1}));
}

NodeStatus startWander(LeafContext& leaf) {
  const std::optional<int> human = humanOf(leaf).person(leaf, 0);
  const sim2d::Area* area = areaOf(leaf, 1);
  const double duration = leaf.require<double>(2);
  if (!human || !area) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {leaf.step(), *human, 0, 0.0, 0.0, false, false, duration};
  return NodeStatus::Running;
}

NodeStatus runWander(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  Memory& memory = leaf.memory<Memory>();
  const sim2d::Area* area = areaOf(leaf, 1);
  if (!area || !context.view().isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  if (!memory.hasTarget || isAt(context, memory)) {
    const std::optional<Vec2> point = drawPoint(leaf, memory.human, *area);
    memory.hasTarget = point.has_value();
    if (point) {
      memory.x = point->x();
      memory.y = point->y();
    }
  }
  if (memory.hasTarget) {
    walkOn(context, memory);
  }
  return byDuration(leaf, memory.startStep, memory.duration);
}

NodeStatus startExit(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  if (!human) {
    return NodeStatus::Failure;
  }
  double shortest = std::numeric_limits<double>::infinity();
  Vec2 nearest = Vec2::Zero();
  for (const sim2d::Area& area : context.view().scenario().areas) {
    if (area.kind != sim2d::AreaKind::Exit || !area.listed || area.points.size() < 3) {
      continue;
    }
    const Vec2 middle = middleOf(area.points);
    const std::optional<double> length = context.view().wayLength(*human, middle);
    if (length && *length < shortest) {
      shortest = *length;
      nearest = middle;
    }
  }
  leaf.memory<Memory>() = {leaf.step(), *human, 0, nearest.x(), nearest.y(), true, false, 0.0};
  return shortest < std::numeric_limits<double>::infinity() ? NodeStatus::Running
                                                            : NodeStatus::Failure;
}

NodeStatus runExit(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  if (isAt(context, memory)) {
    return NodeStatus::Success;
  }
  walkOn(context, memory);
  return NodeStatus::Running;
}

NodeStatus startUse(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<sim2d::GoalItem> place = context.place(leaf, 1);
  const double duration = leaf.require<double>(4);
  if (!human || !place) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {leaf.step(),         *human, place->id, place->position.x(),
                           place->position.y(), true,   false,     duration};
  return NodeStatus::Running;
}

NodeStatus runUse(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  if (!memory.isThere && isAt(context, memory)) {
    memory.isThere = true;
    memory.startStep = leaf.step();
  }
  if (!memory.isThere) {
    walkOn(context, memory);
    return NodeStatus::Running;
  }
  context.setActive(memory.human);
  return leaf.hasElapsed(memory.startStep, memory.duration) ? NodeStatus::Success
                                                            : NodeStatus::Running;
}

}  // namespace

void addPlaces(NodeLibrary& to) {
  to.addStateful<Memory>(
      ownNode(
          "WanderInArea", "Walking", "Walks from one random point of an area to the next.",
          {port::agent(),
           PortSpec("area", PortType::String, "", "Name of the area.").needed().suggest("area1"),
           port::lasting().suggest("0.0")}),
      {startWander, runWander, nullptr});
  to.addStateful<Memory>(
      ownNode("GoToNearestExit", "Walking",
              "Walks into the area of kind exit that is nearest by the way there; fails "
              "without one.",
              {port::agent()}),
      {startExit, runExit, nullptr});
  to.addStateful<Memory>(
      ownNode("UseObject", "Walking", "Walks to a global goal and stays there for some time.",
              {port::agent(), port::goal("Id of the global goal at the object."), port::oldX(),
               port::oldY(), port::duration("duration", "Time at the object.").byDefault("5.0")}),
      {startUse, runUse, nullptr});
}

}  // namespace bt
