#include "sim2d/nav/nav2/global/NavfnPlanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"

namespace sim2d::nav2 {
namespace {

constexpr float kThresholdStep = 2.0F * NavfnWavefront::kNeutral;
constexpr double kInverseRoot2 = 0.707106781;  // the digits that NavFn uses
constexpr std::size_t kBlockSize = 10000;      // cells in excess are dropped, as in NavFn
constexpr double kPathStep = 0.5;              // [cells]

float lengthOf(float x, float y) {  // std::hypot differs between libraries
  return static_cast<float>(
      std::sqrt(static_cast<double>(x) * x + static_cast<double>(y) * static_cast<double>(y)));
}

/// Potential of a cell from the lower of its horizontal and of its vertical neighbours.
float potentialFrom(float horizontal, float vertical, float cost) {
  const float low = std::min(horizontal, vertical);
  const float difference = std::fabs(horizontal - vertical);
  if (difference >= cost) {
    return low + cost;
  }
  // A quadratic approximation of the solution of the eikonal equation.
  const float d = difference / cost;
  const auto share = static_cast<float>(-0.2301 * d * d + 0.5307 * d + 0.7040);
  return low + cost * share;
}

}  // namespace

std::uint8_t NavfnWavefront::costOf(std::uint8_t cost, bool allowUnknown) {
  if (cost == kNoInformation) {
    return allowUnknown ? kUnknownCost : kObstacle;
  }
  if (cost >= kInscribed) {
    return kObstacle;
  }
  return static_cast<std::uint8_t>(std::min(kNeutral + 0.8 * cost, kUnknownCost - 2.0));
}

void NavfnWavefront::setCosts(const Costmap& costmap, bool allowUnknown) {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t cost = 0; cost < table.size(); ++cost) {
    table[cost] = costOf(static_cast<std::uint8_t>(cost), allowUnknown);
  }
  width_ = costmap.width();
  height_ = costmap.height();
  costs_.resize(costmap.costs().size());
  std::transform(costmap.costs().begin(), costmap.costs().end(), costs_.begin(),
                 [&](std::uint8_t cost) { return table[cost]; });
  closeBorder();
}

void NavfnWavefront::setCosts(int width, int height, std::vector<std::uint8_t> costs) {
  width_ = width;
  height_ = height;
  costs_ = std::move(costs);
  closeBorder();
}

void NavfnWavefront::free(Cell cell) {
  costs_[indexOf(cell)] = kNeutral;
  closeBorder();
}

void NavfnWavefront::closeBorder() {
  for (int column = 0; column < width_; ++column) {
    costs_[indexOf({column, 0})] = costs_[indexOf({column, height_ - 1})] = kObstacle;
  }
  for (int row = 0; row < height_; ++row) {
    costs_[indexOf({0, row})] = costs_[indexOf({width_ - 1, row})] = kObstacle;
  }
}

void NavfnWavefront::push(int index, Block& block) {
  if (index < 0 || index >= size() || block.size() == kBlockSize) {
    return;
  }
  const auto at = static_cast<std::size_t>(index);
  if (isPending_[at] == 0 && costs_[at] < kObstacle) {
    block.push_back(index);
    isPending_[at] = 1;
  }
}

void NavfnWavefront::seed(int robot) {
  potential_.assign(costs_.size(), kUnreached);
  isPending_.assign(costs_.size(), 0);
  for (Block& block : blocks_) {
    block.clear();
  }
  potential_[static_cast<std::size_t>(robot)] = 0.0F;
  for (const int neighbour : {robot + 1, robot - 1, robot - width_, robot + width_}) {
    push(neighbour, blocks_[current_]);
  }
}

int NavfnWavefront::propagate(Cell robot, Cell target, bool useAstar, const base::StopFlag* stop) {
  robot_ = robot;
  target_ = target;
  const auto targetIndex = indexOf(target);
  seed(static_cast<int>(indexOf(robot)));
  threshold_ = kObstacle;
  if (useAstar) {
    threshold_ += estimate(static_cast<int>(indexOf(robot)));
  }
  int updated = 0;
  const int most = std::max(size() / 20, width_ + height_);
  for (int cycle = 0; cycle < most && !blocks_[current_].empty(); ++cycle) {
    if (stop != nullptr && cycle % 256 == 0) {
      stop->check();
    }
    updated += static_cast<int>(blocks_[current_].size());
    processBlock(useAstar);
    if (potential_[targetIndex] < kUnreached) {
      break;
    }
  }
  return updated;
}

void NavfnWavefront::processBlock(bool useAstar) {
  Block& block = blocks_[current_];
  for (const int index : block) {
    isPending_[static_cast<std::size_t>(index)] = 0;
  }
  for (const int index : block) {  // pushes to the other blocks
    update(index, useAstar);
  }
  block.clear();
  std::swap(current_, next_);
  if (blocks_[current_].empty()) {
    threshold_ += kThresholdStep;
    std::swap(current_, overflow_);
  }
}

void NavfnWavefront::update(int index, bool useAstar) {
  const auto at = static_cast<std::size_t>(index);  // never on the border: obstacles are not pushed
  const auto stride = static_cast<std::size_t>(width_);
  const float left = potential_[at - 1], right = potential_[at + 1];
  const float down = potential_[at - stride], up = potential_[at + stride];
  float found = potentialFrom(std::min(left, right), std::min(down, up), costs_[at]);
  if (!(found < potential_[at])) {
    return;
  }
  potential_[at] = found;
  if (useAstar) {
    found += estimate(index);
  }
  Block& block = blocks_[found < threshold_ ? next_ : overflow_];
  const auto offer = [&](float potential, int neighbour) {
    const auto half =
        static_cast<float>(kInverseRoot2 * costs_[static_cast<std::size_t>(neighbour)]);
    if (potential > found + half) {
      push(neighbour, block);
    }
  };
  offer(left, index - 1);
  offer(right, index + 1);
  offer(down, index - width_);
  offer(up, index + width_);
}

/// A*: lower bound of the cost from there to the target.
float NavfnWavefront::estimate(int index) const {
  const int column = index % width_, row = index / width_;
  const double dx = column - target_.column, dy = row - target_.row;
  return static_cast<float>(std::sqrt(dx * dx + dy * dy) * kNeutral);
}

std::vector<Vec2> NavfnWavefront::descend(Cell target, int maxSteps) const {
  std::vector<Vec2> path;
  Descent at;
  at.cell = static_cast<int>(indexOf(target));
  for (int i = 0; i < maxSteps; ++i) {
    const int nearest = at.cell + static_cast<int>(std::round(at.dx)) +
                        width_ * static_cast<int>(std::round(at.dy));
    if (this->at(std::clamp(nearest, 0, size() - 1)) < kNeutral) {
      path.emplace_back(robot_.column, robot_.row);
      return path;
    }
    if (at.cell < width_ || at.cell > size() - width_) {
      return {};
    }
    const int column = at.cell % width_, row = at.cell / width_;
    path.emplace_back(static_cast<float>(column) + at.dx, static_cast<float>(row) + at.dy);
    const std::size_t count = path.size();
    const bool isSwinging = count > 2 && path[count - 1] == path[count - 3];
    if (!(isSwinging || lacksGradient(at.cell) ? moveToLowestNeighbour(at) : step(at))) {
      return {};
    }
  }
  return {};
}

/// Whether a cell or a neighbour has no potential, so that there is no gradient.
bool NavfnWavefront::lacksGradient(int cell) const {
  for (const int row : {cell - width_, cell, cell + width_}) {
    if (at(row - 1) >= kUnreached || at(row) >= kUnreached || at(row + 1) >= kUnreached) {
      return true;
    }
  }
  return false;
}

bool NavfnWavefront::moveToLowestNeighbour(Descent& place) const {
  if (at(place.cell) >= kUnreached) {
    return false;  // NavFn's minimum, an int, overflows here
  }
  const int down = place.cell - width_, up = place.cell + width_;
  int lowest = place.cell;
  auto least = static_cast<int>(at(place.cell));  // integers, as in NavFn
  for (const int cell :
       {down - 1, down, down + 1, place.cell - 1, place.cell + 1, up - 1, up, up + 1}) {
    if (at(cell) < static_cast<float>(least)) {
      least = static_cast<int>(at(cell));
      lowest = cell;
    }
  }
  place = {lowest, 0.0F, 0.0F};
  return true;
}

/// Moves half a cell along the gradient, interpolated between the four cells around the position.
/// Precondition: these cells and their neighbours but one have a potential.
bool NavfnWavefront::step(Descent& place) const {
  const Vec2 low = gradient(place.cell), lowRight = gradient(place.cell + 1);
  const Vec2 high = gradient(place.cell + width_), highRight = gradient(place.cell + width_ + 1);
  const auto mix = [&](int axis) {
    const auto first = static_cast<float>((1.0 - place.dx) * low[axis] + place.dx * lowRight[axis]);
    const auto second =
        static_cast<float>((1.0 - place.dx) * high[axis] + place.dx * highRight[axis]);
    return static_cast<float>((1.0 - place.dy) * first + place.dy * second);
  };
  const float x = mix(0), y = mix(1);
  if (x == 0.0F && y == 0.0F) {
    return false;
  }
  const auto scale = static_cast<float>(kPathStep / lengthOf(x, y));
  const auto carry = [&place](float& offset, int stride) {
    if (offset > 1.0F) {
      place.cell += stride;
      offset -= 1.0F;
    }
    if (offset < -1.0F) {
      place.cell -= stride;
      offset += 1.0F;
    }
  };
  place.dx += x * scale;
  place.dy += y * scale;
  carry(place.dx, 1);
  carry(place.dy, width_);
  return true;
}

/// The descent direction, normalized in single precision, or zero.
Vec2 NavfnWavefront::gradient(int index) const {
  const float here = at(index);
  const auto derivative = [&](int before, int after) {
    float sum = 0.0F;
    if (at(before) < kUnreached) {
      sum += at(before) - here;
    }
    if (at(after) < kUnreached) {
      sum += here - at(after);
    }
    return sum;
  };
  const float x = derivative(index - 1, index + 1), y = derivative(index - width_, index + width_);
  const float length = lengthOf(x, y);
  if (!(length > 0.0F)) {
    return Vec2::Zero();
  }
  const auto inverse = static_cast<float>(1.0 / length);
  return {inverse * x, inverse * y};
}

namespace {

/// The cell with the nearest lower left corner; may be one beyond the upper and right border.
Cell roundedCell(const Costmap& costmap, const Vec2& place) {
  const Vec2 cells = (place - costmap.origin()) / costmap.resolution();
  return {static_cast<int>(std::round(cells.x())), static_cast<int>(std::round(cells.y()))};
}

PlanResult navfnFailure(PlanError error, int iterations = 0) {
  return {error, {}, iterations};
}

/// nav2_navfn_planner::NavfnPlanner. As in Nav2 it rounds to cells instead of flooring, so paths
/// are half a cell to the lower left of those of other planners. Headings within the path are 0.
class NavfnPlanner final : public GlobalPlanner {
 public:
  NavfnPlanner(const NavfnParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro) {}

  PlanResult plan(const PlanRequest& request) override {
    const Costmap& costmap = request.costmap;
    const auto start = costmap.worldToCell(request.start.position);
    const auto goal = costmap.worldToCell(request.goal.position);
    if (!start || !costmap.contains(roundedCell(costmap, request.start.position))) {
      return navfnFailure(PlanError::StartOutsideMap);
    }
    if (!goal || !costmap.contains(roundedCell(costmap, request.goal.position))) {
      return navfnFailure(PlanError::GoalOutsideMap);
    }
    if (distro_ >= Distro::Lyrical && parameters_.tolerance == 0.0 &&
        costmap.at(*goal) == kLethal) {
      return navfnFailure(PlanError::GoalOccupied);
    }
    if (request.start.position == request.goal.position) {
      if (costmap.at(*start) == kLethal) {
        return navfnFailure(PlanError::StartOccupied);
      }
      return {PlanError::None,
              {singlePose(request.start, request.goal, parameters_.useFinalApproachOrientation)}};
    }
    const Cell robot = roundedCell(costmap, request.start.position);
    wavefront_.setCosts(costmap, parameters_.allowUnknown);
    wavefront_.free(robot);
    const int updated = wavefront_.propagate(robot, roundedCell(costmap, request.goal.position),
                                             parameters_.useAstar, request.stop);
    const auto end = nearestReached(costmap, request.goal);
    PlanResult result = end ? pathTo(request, *end) : navfnFailure(PlanError::NoValidPath);
    result.iterations = updated;
    return result;
  }

 private:
  float potentialAt(const Costmap& costmap, const Vec2& place) const {
    const Cell cell = roundedCell(costmap, place);
    return costmap.contains(cell) ? wavefront_.potential(cell) : std::numeric_limits<float>::max();
  }

  /// The goal, or the first of the reached positions nearest to it within the tolerance.
  std::optional<Pose2> nearestReached(const Costmap& costmap, const Pose2& goal) const {
    if (potentialAt(costmap, goal.position) < NavfnWavefront::kUnreached) {
      return goal;
    }
    const double reach = parameters_.tolerance, step = costmap.resolution();
    double least = std::numeric_limits<double>::max();
    std::optional<Pose2> nearest;
    Vec2 place = goal.position - Vec2::Constant(reach);  // sums of steps, as in Nav2
    while (place.y() <= goal.position.y() + reach) {
      place.x() = goal.position.x() - reach;
      while (place.x() <= goal.position.x() + reach) {
        const double distance = (place - goal.position).squaredNorm();
        if (distance < least && potentialAt(costmap, place) < NavfnWavefront::kUnreached) {
          least = distance;
          nearest = Pose2{place, goal.heading};
        }
        place.x() += step;
      }
      place.y() += step;
    }
    return nearest;
  }

  PlanResult pathTo(const PlanRequest& request, const Pose2& end) {
    const Costmap& costmap = request.costmap;
    const int factor = distro_ >= Distro::Lyrical ? parameters_.maxCyclesFactor : 4;
    const int steps = std::max(costmap.width(), costmap.height()) * factor;
    const std::vector<Vec2> cells = wavefront_.descend(roundedCell(costmap, end.position), steps);
    if (cells.empty()) {
      return navfnFailure(PlanError::NoValidPath);
    }
    PlanResult result;
    for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell) {
      result.path.push_back({costmap.origin() + costmap.resolution() * *cell, 0.0});
    }
    appendGoal(result.path, end);
    if (parameters_.useFinalApproachOrientation) {
      setFinalApproachHeading(result.path, request.start.heading);
    }
    return result;
  }

  /// Appends the goal to the path, replacing a last pose that is beyond it.
  void appendGoal(Path& path, const Pose2& goal) const {
    if (path.size() >= 2) {
      constexpr double kSame = 1e-3;  // [m]
      const Vec2& last = path.back().position;
      const Vec2& before = path[path.size() - 2].position;
      const bool isBeyond = (last - before).squaredNorm() > (goal.position - before).squaredNorm();
      const bool isThere =
          distro_ != Distro::Humble && (last - goal.position).squaredNorm() < kSame * kSame;
      if (isBeyond || isThere) {
        path.back() = goal;
        return;
      }
    }
    path.push_back(goal);
  }

  NavfnParameters parameters_;
  Distro distro_;
  NavfnWavefront wavefront_;
};

}  // namespace

PlannerPointer makeGlobalPlanner(const NavfnParameters& parameters, Distro distro) {
  return std::make_unique<NavfnPlanner>(parameters, distro);
}

}  // namespace sim2d::nav2
