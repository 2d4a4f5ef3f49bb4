#include <algorithm>
#include <cmath>
#include <optional>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/global/SmacPoseSearch.h"

namespace sim2d::nav2 {
namespace {

using StepTurn = ShortestCurve::Turn;

/// Bins of the sharpest turn whose chord leaves the cell: 2 asin(sqrt 2 / (2 R)), rounded up.
int sharpestTurn(double radius, double binSize) {
  const double angle = 2.0 * (0.5 * base::kPi - base::acos(std::sqrt(2.0) / (2.0 * radius)));
  return std::max(1, static_cast<int>(std::ceil(angle / binSize)));
}

CarMotion carOf(const SmacHybridParameters& parameters) {
  return parameters.motionModelForSearch == "REEDS_SHEPP" ? CarMotion::ReedsShepp
                                                          : CarMotion::Dubins;
}

}  // namespace

HybridMotion::HybridMotion(const SmacHybridParameters& given, double cellSize, Distro distro)
    : parameters(given),
      car(carOf(given)),
      bins(given.angleQuantizationBins),
      binSize(2.0 * base::kPi / bins),
      turningRadius(std::max(1.0, given.minimumTurningRadius / cellSize)),
      isQuadratic(distro != Distro::Humble && given.useQuadraticCostPenalty) {
  const int sharpest = sharpestTurn(turningRadius, binSize);
  const double angle = sharpest * binSize;
  const double chord = 2.0 * turningRadius * base::sin(0.5 * angle);
  steps.push_back({chord, 0.0, 0, StepTurn::Straight, false, chord});
  addTurn(sharpest, turningRadius, distro == Distro::Humble ? chord : turningRadius * angle);
  if (distro != Distro::Humble && given.allowPrimitiveInterpolation) {
    for (int turned = 1; turned < sharpest; ++turned) {
      const double radius = chord / (2.0 * base::sin(0.5 * turned * binSize));
      addTurn(turned, radius, radius * turned * binSize);
    }
  }
  if (car == CarMotion::ReedsShepp) {
    const std::vector<HybridStep> forward = steps;
    for (HybridStep step : forward) {
      step.dx = -step.dx;
      step.bins = -step.bins;
      step.isBackward = true;
      steps.push_back(step);
    }
  }
  for (const HybridStep& step : steps) {
    for (int bin = 0; bin < bins; ++bin) {
      const base::SinCos at = base::sinCos(bin * binSize);
      offsets.emplace_back(step.dx * at.cos - step.dy * at.sin,
                           step.dx * at.sin + step.dy * at.cos);
    }
  }
}

void HybridMotion::addTurn(int turnedBins, double radius, double length) {
  const double angle = turnedBins * binSize;
  const double dx = radius * base::sin(angle), dy = radius * (1.0 - base::cos(angle));
  steps.push_back({dx, dy, turnedBins, StepTurn::Left, false, length});
  steps.push_back({dx, -dy, -turnedBins, StepTurn::Right, false, length});
}

int HybridMotion::nearestBin(double heading) const {
  return wrappedBin(static_cast<int>(std::round(base::wrapToPi(heading) / binSize)));
}

double HybridMotion::cost(const HybridStep* before, const HybridStep& step,
                          std::uint8_t cellCost) const {
  const double share = cellCost / kSmacMaxCost;
  const double reward = 1.0 - parameters.retrospectivePenalty;
  double cost =
      step.length * (reward + parameters.costPenalty * (isQuadratic ? share * share : share));
  if (before != nullptr && step.turn != StepTurn::Straight) {
    const bool isSameWay = before->turn == step.turn && before->isBackward == step.isBackward;
    cost *= isSameWay ? parameters.nonStraightPenalty
                      : parameters.nonStraightPenalty + parameters.changePenalty;
  }
  return step.isBackward ? cost * parameters.reversePenalty : cost;
}

namespace {

class HybridSearch : public SmacPoseSearch {
 public:
  HybridSearch(const Setup& setup, const HybridMotion& motion, DistanceHeuristic& curves)
      : SmacPoseSearch(setup), motion_(motion), curves_(curves) {}

 private:
  int nearestHeading(double heading) const override { return motion_.nearestBin(heading); }
  double headingOf(int index) const override { return base::wrapToPi(index * motion_.binSize); }
  double curveEstimate(const Node& node, const Pose2& goal, double round) override {
    const int bin = motion_.wrappedBin(node.heading - motion_.nearestBin(goal.heading));
    const double length = curves_.from(goal.toLocal(node.pose.position), bin);
    return length <= 0.0 && round <= 0.0 ? curveLength(node, goal) : length;
  }
  void expand(int index) override {
    const Node node = nodeWith(index);
    const HybridStep* const before =
        node.step < 0 ? nullptr : &motion_.steps[static_cast<std::size_t>(node.step)];
    for (std::size_t step = 0; step < motion_.steps.size(); ++step) {
      const HybridStep& taken = motion_.steps[step];
      Node next;
      next.heading = motion_.wrappedBin(node.heading + taken.bins);
      next.pose.position = node.pose.position + motion_.offset(step, node.heading);
      next.step = static_cast<int>(step);
      next.parent = index;
      offer(next, [&](const Node& there) {
        const auto cost = costAt(there.pose);
        return cost ? std::optional(motion_.cost(before, taken, *cost)) : std::nullopt;
      });
    }
  }

  const HybridMotion& motion_;
  DistanceHeuristic& curves_;
};

/// nav2_smac_planner::SmacPlannerHybrid: A* over poses, for cars that drive forward (DUBIN) or
/// forward and in reverse (REEDS_SHEPP). Before Main, start and goal are moved to the centres of
/// their cells; their headings are always rounded to the nearest bin.
class SmacHybridPlanner final : public GlobalPlanner {
 public:
  SmacHybridPlanner(const SmacHybridParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro) {}

  PlanResult plan(const PlanRequest& request) override {
    const int factor = parameters_.downsampleCostmap ? parameters_.downsamplingFactor : 1;
    const Costmap costmap = downsampled(request.costmap, factor, false);
    const double radius = std::max(parameters_.minimumTurningRadius, costmap.resolution());
    return planOverPoses(costmap, request, parameters_, {carOf(parameters_), radius},
                         [&] { return planIn(costmap, request); });
  }

 private:
  DistanceHeuristic& curvesFor(const HybridMotion& motion, const Costmap& costmap) {
    constexpr double kMaxSide = 2000.0;  // [cells]
    const double wanted = std::fmin(parameters_.lookupTableSize / costmap.resolution(), kMaxSide);
    const int side = static_cast<int>(wanted) | 1;  // odd
    if (!curves_ || curveRadius_ != motion.turningRadius || curveSide_ != side) {
      curves_.emplace(motion.car, motion.turningRadius, motion.bins, side);
      curveRadius_ = motion.turningRadius;
      curveSide_ = side;
    }
    return *curves_;
  }

  /// Plans a path in cell coordinates.
  PlanResult planIn(const Costmap& costmap, const PlanRequest& request) {
    const HybridMotion motion(parameters_, costmap.resolution(), distro_);
    const bool isDownsampled = parameters_.downsampleObstacleHeuristic || distro_ == Distro::Humble;
    const SmacPoseSearch::Setup setup{
        SmacPoseSearch::Kind::Hybrid,
        parameters_,
        distro_,
        costmap,
        request,
        obstacles_,
        motion.car,
        motion.turningRadius,
        motion.bins,
        {parameters_.costPenalty, motion.isQuadratic, parameters_.allowUnknown, isDownsampled},
        parameters_.coarseSearchResolution};
    const bool isCentred = distro_ < Distro::Lyrical;
    return HybridSearch(setup, motion, curvesFor(motion, costmap))
        .plan(inCells(costmap, request.start, isCentred),
              inCells(costmap, request.goal, isCentred));
  }

  SmacHybridParameters parameters_;
  Distro distro_;
  ObstacleHeuristic obstacles_;
  std::optional<DistanceHeuristic> curves_;  // for the radius and side below
  double curveRadius_ = 0.0;                 // [cells]
  int curveSide_ = 0;                        // [cells]
};

}  // namespace

PlannerPointer makeGlobalPlanner(const SmacHybridParameters& parameters, Distro distro) {
  return std::make_unique<SmacHybridPlanner>(parameters, distro);
}

// Smac Lattice.
namespace {

constexpr double kOnTheSpot = 1e-4;  // [m]
constexpr double kNoArc = 1e-3;      // [m], arc length

CarMotion carOf(const SmacLatticeParameters& parameters) {
  return parameters.allowReverseExpansion ? CarMotion::ReedsShepp : CarMotion::Dubins;
}

bool isQuadratic(const SmacLatticeParameters& parameters, Distro distro) {
  return distro >= Distro::Lyrical && parameters.useQuadraticCostPenalty;
}

}  // namespace

int Lattice::nearestHeading(double heading) const {
  int nearest = 0;
  for (int i = 1; i < size(); ++i) {
    const auto off = [&](int number) {
      return std::abs(base::angleDiff(headings[static_cast<std::size_t>(number)], heading));
    };
    nearest = off(i) < off(nearest) ? i : nearest;
  }
  return nearest;
}

double latticeCost(const SmacLatticeParameters& parameters, Distro distro, double cellSize,
                   const LatticeStep& step, double cellCost) {
  const LatticePrimitive& primitive = step.primitive;
  const double length = primitive.length / cellSize;
  if (step.before == nullptr) {
    return length;
  }
  const double share = cellCost / kSmacMaxCost;
  const double penalty =
      parameters.costPenalty * (isQuadratic(parameters, distro) ? share * share : share);
  if (primitive.length < kOnTheSpot) {
    return parameters.rotationPenalty * (1.0 + penalty);
  }
  double cost = length * (1.0 - parameters.retrospectivePenalty + penalty);
  if (primitive.arcLength >= kNoArc) {
    const bool isSameWay = step.before->isLeftTurn == primitive.isLeftTurn;
    cost *= isSameWay ? parameters.nonStraightPenalty
                      : parameters.nonStraightPenalty + parameters.changePenalty;
  }
  return step.isBackward ? cost * parameters.reversePenalty : cost;
}

namespace {

/// One search of Smac Lattice (nav2_smac_planner, node_lattice.cpp): A* over the primitives of a
/// file. All references must outlive the search.
class LatticeSearch final : public SmacPoseSearch {
 public:
  LatticeSearch(const SmacLatticeParameters& parameters, Distro distro, const PlanRequest& request,
                ObstacleHeuristic& obstacles)
      : SmacPoseSearch({Kind::Lattice,
                        parameters,
                        distro,
                        request.costmap,
                        request,
                        obstacles,
                        carOf(parameters),
                        parameters.lattice->turningRadius / request.costmap.resolution(),
                        parameters.lattice->size(),
                        {parameters.costPenalty, isQuadratic(parameters, distro),
                         parameters.allowUnknown, parameters.downsampleObstacleHeuristic}}),
        parameters_(parameters),
        lattice_(*parameters.lattice),
        cellSize_(request.costmap.resolution()) {}

 private:
  int nearestHeading(double heading) const override { return lattice_.nearestHeading(heading); }
  double headingOf(int index) const override {
    return lattice_.headings[static_cast<std::size_t>(index)];
  }
  double curveEstimate(const Node& node, const Pose2& goal, double /*round*/) override {
    return curveLength(node, goal);
  }

  /// Backward motion uses the primitives of the opposite heading.
  const std::vector<LatticePrimitive>& primitivesFrom(int heading, bool isBackward) const {
    const int from = isBackward ? lattice_.oppositeOf(heading) : heading;
    return lattice_.primitives[static_cast<std::size_t>(from)];
  }

  /// The primitive into a node; null: start.
  const LatticePrimitive* primitiveInto(const Node& node) const {
    return node.parent < 0 ? nullptr
                           : &primitivesFrom(nodeWith(node.parent).heading,
                                             node.isBackward)[static_cast<std::size_t>(node.step)];
  }

  /// Expands forward, and with `allow_reverse_expansion` also backward.
  void expand(int index) override {
    for (const bool isBackward : {false, true}) {
      const int heading = nodeWith(index).heading;
      const auto steps = static_cast<int>(primitivesFrom(heading, isBackward).size());
      for (int step = 0; step < steps && (!isBackward || parameters_.allowReverseExpansion);
           ++step) {
        applyStep(index, step, isBackward);
      }
    }
  }

  void applyStep(int from, int step, bool isBackward) {
    const Node node = nodeWith(from);
    const LatticePrimitive& primitive =
        primitivesFrom(node.heading, isBackward)[static_cast<std::size_t>(step)];
    Node next;
    next.heading = isBackward ? lattice_.oppositeOf(primitive.endHeading) : primitive.endHeading;
    next.pose.position = node.pose.position + primitive.poses.back().position / cellSize_;
    next.parent = from;
    next.step = step;
    next.isBackward = isBackward;
    offer(next, [&](const Node& there) -> std::optional<double> {
      const auto cellCost = costAlong(node.pose, primitive, isBackward);
      const auto endCost = costAt(there.pose);
      if (!cellCost || !endCost) {
        return std::nullopt;
      }
      return latticeCost(parameters_, setup().distro, cellSize_,
                         {primitiveInto(node), primitive, isBackward},
                         std::max<double>(*cellCost, *endCost));
    });
  }

  /// The maximum cost along a primitive, sampled about once per cell; nullopt in a collision.
  std::optional<double> costAlong(const Pose2& from, const LatticePrimitive& primitive,
                                  bool isBackward) const {
    double highest = 0.0;
    const Pose2* last = nullptr;
    for (const Pose2& each : primitive.poses) {
      if (last != nullptr &&
          (each.position - last->position).squaredNorm() <= 2.0 * cellSize_ * cellSize_) {
        continue;
      }
      last = &each;
      const double heading = isBackward ? base::wrapToPi(each.heading + base::kPi) : each.heading;
      const auto cost = costAt({from.position + each.position / cellSize_, heading});
      if (!cost) {
        return std::nullopt;
      }
      highest = std::max<double>(highest, *cost);
    }
    return highest;
  }

  /// Appends the poses along the primitive.
  void addPoses(const Node& parent, const Node& node, Path& path) const override {
    const std::vector<Pose2>& poses = primitiveInto(node)->poses;
    for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
      const double heading =
          node.isBackward ? base::wrapToPi(poses[i].heading + base::kPi) : poses[i].heading;
      path.push_back({parent.pose.position + poses[i].position / cellSize_, heading});
    }
    path.push_back(node.pose);
  }

  const SmacLatticeParameters& parameters_;
  const Lattice& lattice_;
  double cellSize_;  // [m]
};

/// nav2_smac_planner::SmacPlannerLattice: A* over the motion primitives of a file. Lengths are
/// measured in cells of the costmap, regardless of the file's resolution.
class SmacLatticePlanner final : public GlobalPlanner {
 public:
  SmacLatticePlanner(const SmacLatticeParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro) {}

  PlanResult plan(const PlanRequest& request) override {
    const Costmap& costmap = request.costmap;
    const auto search = [&] {
      return LatticeSearch(parameters_, distro_, request, obstacles_)
          .plan(inCells(costmap, request.start, true), inCells(costmap, request.goal, true));
    };
    return planOverPoses(costmap, request, parameters_,
                         {carOf(parameters_), parameters_.lattice->turningRadius}, search);
  }

 private:
  SmacLatticeParameters parameters_;
  Distro distro_;
  ObstacleHeuristic obstacles_;
};

}  // namespace

PlannerPointer makeGlobalPlanner(const SmacLatticeParameters& parameters, Distro distro) {
  if (parameters.lattice == nullptr) {
    return makeGlobalPlanner(hybridFallback(parameters, distro), distro);
  }
  return std::make_unique<SmacLatticePlanner>(parameters, distro);
}

}  // namespace sim2d::nav2
