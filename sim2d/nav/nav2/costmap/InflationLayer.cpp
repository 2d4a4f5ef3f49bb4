#include "sim2d/nav/nav2/costmap/InflationLayer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {

std::uint8_t InflationCostFunction::cost(double distance) const {
  if (distance <= 0.0) {
    return kLethal;
  }
  if (distance <= inscribed) {
    return kInscribed;
  }
  constexpr double kMax = kInscribed - 1;
  const double cost = kMax * base::exp(-scaling * (distance - inscribed));
  return static_cast<std::uint8_t>(std::fmin(cost, kMax));  // a negative scaling makes costs rise
}

double InflationCostFunction::distance(std::uint8_t cost) const {
  return inscribed - base::log(static_cast<double>(cost) / kInscribed) / scaling;
}

namespace {

constexpr double kTableSteps = 100.0;  // per cell, as in Nav2 main

InflationCostFunction costFunctionOf(const InflationLayerParameters& parameters,
                                     const CostmapContext& context) {
  const bool isCustom =
      context.distro >= Distro::Lyrical && parameters.customInscribedRadius >= 0.0;
  return {parameters.inflationRadius, parameters.costScalingFactor,
          isCustom ? parameters.customInscribedRadius : context.footprint.inscribed};
}

constexpr int kBlock = 8;          // columns processed together
constexpr int kMaxRadius16 = 127;  // [cells]; (r + 1)² + r² fits 16 bits

int blockCount(const CellWindow& window) {
  return (window.right - window.left + kBlock - 1) / kBlock;
}

/// Lowers `squares` to `line` plus `more`; the fixed length allows vectorization.
template <class Square>
void minimizeBlock(std::array<Square, kBlock>& squares, const Square* line, Square more) {
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squares[i] = std::min(squares[i], static_cast<Square>(line[i] + more));
  }
}

}  // namespace

InflationLayer::InflationLayer(std::string name, const CostmapContext& context,
                               const InflationLayerParameters& parameters, double resolution)
    : CostmapLayer(std::move(name), context),
      parameters_(parameters),
      costFunction_(costFunctionOf(parameters, context)),
      radius_(Costmap(0, 0, resolution, Vec2::Zero()).cellDistance(parameters.inflationRadius)) {
  const int most = radius_ * radius_;
  costs_.reserve(static_cast<std::size_t>(most) + 1);
  for (int square = 0; square <= most; ++square) {
    double cells = std::sqrt(static_cast<double>(square));
    if (context.distro >= Distro::Lyrical) {
      cells = std::round(cells * kTableSteps) / kTableSteps;
    }
    costs_.push_back(costFunction_.cost(cells * resolution));
  }
  bins_.resize(costs_.size());
}

void InflationLayer::updateBounds(const Observation& /*observation*/, const Costmap& /*master*/,
                                  CostmapBounds& bounds) {
  const CostmapBounds now = bounds;
  if (needsFullUpdate_) {
    bounds = unboundedBounds();
    needsFullUpdate_ = false;
  } else {
    bounds.touch(last_);  // so that removed obstacles deflate
    bounds.low -= Vec2::Constant(costFunction_.radius);
    bounds.high += Vec2::Constant(costFunction_.radius);
  }
  last_ = now;
}

void InflationLayer::updateCosts(Costmap& master, const CellWindow& window) {
  isCurrent_ = true;
  if (!parameters_.enabled || radius_ == 0) {
    return;
  }
  // Obstacles outside the window affect costs inside.
  const CellWindow wide{std::max(0, window.left - radius_), std::max(0, window.bottom - radius_),
                        std::min(master.width(), window.right + radius_),
                        std::min(master.height(), window.top + radius_)};
  if (context().distro < Distro::Lyrical) {
    inflateBySpreading(master, window, wide);
  } else if (radius_ <= kMaxRadius16) {
    inflateExactly(master, window, wide, rowDistances_);
  } else {
    inflateExactly(master, window, wide, rowDistancesLarge_);
  }
}

void InflationLayer::reset(double /*time*/) {
  needsFullUpdate_ = true;
  isCurrent_ = false;
}

bool InflationLayer::isSource(std::uint8_t cost) const {
  return cost == kLethal || (cost == kNoInformation && parameters_.inflateAroundUnknown);
}

std::uint8_t InflationLayer::raisedCost(std::uint8_t old, std::uint8_t cost) const {
  if (old == kNoInformation) {
    const std::uint8_t least = parameters_.inflateUnknown ? std::uint8_t{1} : kInscribed;
    return cost >= least ? cost : old;
  }
  return std::max(old, cost);
}

void InflationLayer::inflateBySpreading(Costmap& master, const CellWindow& window,
                                        const CellWindow& wide) {
  for (int row = wide.bottom; row < wide.top; ++row) {
    for (int column = wide.left; column < wide.right; ++column) {
      if (isSource(master.at({column, row}))) {
        bins_[0].push_back({{column, row}, {column, row}});
      }
    }
  }
  resetSeen(master);
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
    for (std::size_t i = 0; i < bins_[bin].size(); ++i) {  // may grow during the loop
      const InflationCell spread = bins_[bin][i];
      const Cell cell = spread.cell;
      char& isSeen = seen_[seenIndex(cell)];
      if (isSeen != 0) {
        continue;
      }
      isSeen = 1;
      if (window.contains(cell)) {
        master.set(cell, raisedCost(master.at(cell), costs_[bin]));
      }
      enqueue({{cell.column - 1, cell.row}, spread.source}, bin);
      enqueue({{cell.column, cell.row - 1}, spread.source}, bin);
      enqueue({{cell.column + 1, cell.row}, spread.source}, bin);
      enqueue({{cell.column, cell.row + 1}, spread.source}, bin);
    }
    bins_[bin].clear();
  }
}

/// Marks only a border around the map as seen.
void InflationLayer::resetSeen(const Costmap& master) {
  seenWidth_ = static_cast<std::size_t>(master.width()) + 2;
  seen_.assign(seenWidth_ * (static_cast<std::size_t>(master.height()) + 2), 1);
  for (int row = 0; row < master.height(); ++row) {
    const auto begin = seen_.begin() + static_cast<std::ptrdiff_t>(seenIndex({0, row}));
    std::fill(begin, begin + master.width(), char{0});
  }
}

/// Bins before `bin` are complete.
void InflationLayer::enqueue(const InflationCell& spread, std::size_t bin) {
  if (seen_[seenIndex(spread.cell)] != 0) {
    return;
  }
  const int across = spread.cell.column - spread.source.column;
  const int up = spread.cell.row - spread.source.row;
  const int square = across * across + up * up;
  const auto place = static_cast<std::size_t>(square);
  if (place < bins_.size() && place >= bin) {
    bins_[place].push_back(spread);
  }
}

/// Writes the squared distance to the nearest source in the same row into `across`: rows of `wide`,
/// columns of `window`, padded to whole blocks.
template <class Square>
void InflationLayer::findRowDistances(const Costmap& master, const CellWindow& window,
                                      const CellWindow& wide, std::vector<Square>& across) const {
  const int stride = blockCount(window) * kBlock;
  const int far = radius_ + 1;
  across.assign(static_cast<std::size_t>(stride) * static_cast<std::size_t>(wide.top - wide.bottom),
                static_cast<Square>(far * far));
  Square* line = across.data();
  for (int row = wide.bottom; row < wide.top; ++row, line += stride) {
    const std::uint8_t* const costs = master.costs().data() + master.indexOf({0, row});
    int distance = far;
    for (int column = wide.left; column < window.right; ++column) {
      distance = isSource(costs[column]) ? 0 : std::min(distance + 1, far);
      if (column >= window.left) {
        line[column - window.left] = static_cast<Square>(distance * distance);
      }
    }
    distance = far;
    for (int column = wide.right - 1; column >= window.left; --column) {
      distance = isSource(costs[column]) ? 0 : std::min(distance + 1, far);
      if (column < window.right) {
        Square& square = line[column - window.left];
        square = std::min(square, static_cast<Square>(distance * distance));
      }
    }
  }
}

/// Minimizes row distance² + vertical distance² over the rows within the radius.
template <class Square>
void InflationLayer::inflateExactly(Costmap& master, const CellWindow& window,
                                    const CellWindow& wide, std::vector<Square>& across) {
  findRowDistances(master, window, wide, across);
  const int blocks = blockCount(window), width = window.right - window.left;
  const int most = radius_ * radius_;
  for (int row = window.bottom; row < window.top; ++row) {
    const int from = std::max(wide.bottom, row - radius_) - wide.bottom;
    const int to = std::min(wide.top, row + radius_ + 1) - wide.bottom;
    std::uint8_t* const costs = master.costs().data() + master.indexOf({window.left, row});
    for (int block = 0; block < blocks; ++block) {
      std::array<Square, kBlock> squares;
      squares.fill(static_cast<Square>(most + 1));
      const Square* line = across.data() + (from * blocks + block) * kBlock;
      for (int other = from; other < to; ++other, line += blocks * kBlock) {
        const int up = other + wide.bottom - row;
        minimizeBlock(squares, line, static_cast<Square>(up * up));
      }
      const int last = std::min(kBlock, width - block * kBlock);
      for (int i = 0; i < last; ++i) {
        const int square = squares[static_cast<std::size_t>(i)];
        if (square <= most) {
          std::uint8_t& cost = costs[block * kBlock + i];
          cost = raisedCost(cost, costs_[static_cast<std::size_t>(square)]);
        }
      }
    }
  }
}

namespace {

InflationLayerParameters withFactor(const AsymmetricInflationLayerParameters& parameters,
                                    double factor) {
  InflationLayerParameters one;
  one.enabled = parameters.enabled;
  one.inflationRadius = parameters.inflationRadius;
  one.costScalingFactor = factor;
  one.inflateUnknown = parameters.inflateUnknown;
  one.inflateAroundUnknown = parameters.inflateAroundUnknown;
  return one;
}

CostmapContext withJazzyDistro(CostmapContext context) {
  context.distro = Distro::Jazzy;
  return context;
}

}  // namespace

LegacyInflationLayer::LegacyInflationLayer(std::string name, const CostmapContext& context,
                                           const LegacyInflationLayerParameters& parameters,
                                           double resolution)
    : CostmapContext(withJazzyDistro(context)),
      InflationLayer(std::move(name), static_cast<const CostmapContext&>(*this), parameters,
                     resolution) {}

AsymmetricInflationLayer::AsymmetricInflationLayer(
    const std::string& name, const CostmapContext& context,
    const AsymmetricInflationLayerParameters& parameters, double resolution)
    : CostmapLayer(name, context),
      parameters_(parameters),
      left_(name, context, withFactor(parameters, parameters.costScalingFactorLeft), resolution),
      right_(name, context, withFactor(parameters, parameters.costScalingFactorRight), resolution),
      both_(name, context,
            withFactor(parameters, std::max(parameters.costScalingFactorLeft,
                                            parameters.costScalingFactorRight)),
            resolution) {}

void AsymmetricInflationLayer::setPlan(const Path& plan) {
  isNew_ = isNew_ || plan != plan_;
  plan_ = plan;
}

void AsymmetricInflationLayer::updateBounds(const Observation& observation, const Costmap& master,
                                            CostmapBounds& bounds) {
  const bool wasAsymmetric = isAsymmetric_;
  isAsymmetric_ = plan_.size() >= 2 && (observation.pose.position - plan_.back().position).norm() >
                                           parameters_.goalDistanceThreshold;
  left_.updateBounds(observation, master, bounds);
  if (wasAsymmetric != isAsymmetric_ || (isNew_ && isAsymmetric_)) {
    bounds = unboundedBounds();
  }
  isNew_ = false;
}

void AsymmetricInflationLayer::updateCosts(Costmap& master, const CellWindow& window) {
  isCurrent_ = true;
  if (!isAsymmetric_) {
    both_.updateCosts(master, window);
    return;
  }
  Costmap left = master, right = master;
  removeOtherSide(master, left, right);
  left_.updateCosts(left, window);
  right_.updateCosts(right, window);
  for (int row = window.bottom; row < window.top; ++row) {
    for (int column = window.left; column < window.right; ++column) {
      const Cell cell{column, row};
      const std::uint8_t old = master.at(cell), l = left.at(cell), r = right.at(cell);
      if (old != kNoInformation) {
        master.set(cell, std::max({old, l, r}));
      } else if (!isSource(old)) {  // stays 255 only if neither side raises it
        master.set(cell, l == old ? r : r == old ? l : std::max(l, r));
      }
    }
  }
}

bool AsymmetricInflationLayer::isSource(std::uint8_t cost) const {
  return cost == kLethal || (cost == kNoInformation && parameters_.inflateAroundUnknown);
}

/// Keeps in `left` and `right` only the obstacles on that side of the plan.
void AsymmetricInflationLayer::removeOtherSide(const Costmap& master, Costmap& left,
                                               Costmap& right) const {
  for (int row = 0; row < master.height(); ++row) {
    for (int column = 0; column < master.width(); ++column) {
      const Cell cell{column, row};
      if (isSource(master.at(cell))) {
        (isLeft(master.cellToWorld(cell)) ? right : left).set(cell, kFreeSpace);
      }
    }
  }
}

void AsymmetricInflationLayer::reset(double time) {
  left_.reset(time);
  plan_.clear();
  isNew_ = true;
  isCurrent_ = false;
}

InflationCostFunction AsymmetricInflationLayer::costFunction() const {
  InflationCostFunction costFunction = left_.costFunction();
  costFunction.scaling =
      0.5 * (parameters_.costScalingFactorLeft + parameters_.costScalingFactorRight);
  return costFunction;
}

bool AsymmetricInflationLayer::isLeft(const Vec2& place) const {
  std::size_t nearest = 0;
  double least = (plan_[0].position - place).squaredNorm();
  for (std::size_t i = 1; i < plan_.size(); ++i) {
    const double square = (plan_[i].position - place).squaredNorm();
    if (square < least) {
      least = square;
      nearest = i;
    }
  }
  const std::size_t from = std::min(nearest, plan_.size() - 2);
  const Vec2 way = plan_[from + 1].position - plan_[from].position;
  const Vec2 offset = place - plan_[from].position;
  return way.x() * offset.y() - way.y() * offset.x() > 0.0;
}

}  // namespace sim2d::nav2
