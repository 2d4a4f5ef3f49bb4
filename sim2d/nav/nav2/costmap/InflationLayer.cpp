#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

/// Whether costs spread from a cell.
bool isInflationSource(std::uint8_t cost, bool inflatesAroundUnknown) {
  return cost == kLethal || (cost == kNoInformation && inflatesAroundUnknown);
}

/// Costs around lethal cells (nav2_costmap_2d::InflationLayer). Humble and Jazzy spread over the
/// four neighbours in order of distance, so a cell occasionally takes a source that is not quite
/// the nearest; main uses the exact distance, in steps of 1/100 cell.
class InflationLayer final : public CostmapLayer {
 public:
  InflationLayer(const InflationLayerParameters& parameters, Distro distro, const LayerSite& site)
      : CostmapLayer(site),
        parameters_(parameters),
        isExact_(distro >= Distro::Lyrical),
        costFunction_{parameters.inflationRadius, parameters.costScalingFactor,
                      isExact_ && parameters.customInscribedRadius >= 0.0
                          ? parameters.customInscribedRadius
                          : site.context.footprint.inscribed},
        radius_(Costmap(0, 0, site.master.resolution(), Vec2::Zero())
                    .cellDistance(parameters.inflationRadius)) {
    const int most = radius_ * radius_;
    costs_.reserve(static_cast<std::size_t>(most) + 1);
    for (int square = 0; square <= most; ++square) {
      double cells = std::sqrt(static_cast<double>(square));
      if (isExact_) {
        cells = std::round(cells * kTableSteps) / kTableSteps;
      }
      costs_.push_back(costFunction_.cost(cells * site.master.resolution()));
    }
    bins_.resize(costs_.size());
  }

  void updateBounds(const Observation& /*observation*/, const Costmap& /*master*/,
                    CostmapBounds& bounds) override {
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

  void updateCosts(Costmap& master, const CellWindow& window) override {
    isCurrent_ = true;
    if (!parameters_.enabled || radius_ == 0) {
      return;
    }
    // Obstacles outside the window affect costs inside.
    const CellWindow wide{std::max(0, window.left - radius_), std::max(0, window.bottom - radius_),
                          std::min(master.width(), window.right + radius_),
                          std::min(master.height(), window.top + radius_)};
    if (!isExact_) {
      inflateBySpreading(master, window, wide);
    } else if (radius_ <= kMaxRadius16) {
      inflateExactly(master, window, wide, rowDistances_);
    } else {
      inflateExactly(master, window, wide, rowDistancesLarge_);
    }
  }

  void reset(double /*time*/) override {
    needsFullUpdate_ = true;
    isCurrent_ = false;
  }
  bool isCurrent() const override { return isCurrent_; }
  std::optional<InflationCostFunction> inflation(const std::string& wanted) const override {
    return wanted.empty() || wanted == name() ? std::optional(costFunction_) : std::nullopt;
  }

 private:
  struct InflationCell {  // a cell and the lethal cell from which its cost is computed
    Cell cell, source;
  };

  bool isSource(std::uint8_t cost) const {
    return isInflationSource(cost, parameters_.inflateAroundUnknown);
  }

  std::uint8_t raisedCost(std::uint8_t old, std::uint8_t cost) const {
    if (old == kNoInformation) {
      const std::uint8_t least = parameters_.inflateUnknown ? std::uint8_t{1} : kInscribed;
      return cost >= least ? cost : old;
    }
    return std::max(old, cost);
  }

  std::size_t seenIndex(Cell cell) const {
    return static_cast<std::size_t>(cell.row + 1) * seenWidth_ +
           static_cast<std::size_t>(cell.column + 1);
  }

  void inflateBySpreading(Costmap& master, const CellWindow& window, const CellWindow& wide) {
    forEachCell(wide, [&](Cell cell) {
      if (isSource(master.at(cell))) {
        bins_[0].push_back({cell, cell});
      }
    });
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
  void resetSeen(const Costmap& master) {
    seenWidth_ = static_cast<std::size_t>(master.width()) + 2;
    seen_.assign(seenWidth_ * (static_cast<std::size_t>(master.height()) + 2), 1);
    for (int row = 0; row < master.height(); ++row) {
      const auto begin = seen_.begin() + static_cast<std::ptrdiff_t>(seenIndex({0, row}));
      std::fill(begin, begin + master.width(), char{0});
    }
  }

  /// Bins before `bin` are complete.
  void enqueue(const InflationCell& spread, std::size_t bin) {
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

  /// Writes the squared distance to the nearest source in the same row into `across`: rows of
  /// `wide`, columns of `window`, padded to whole blocks.
  template <class Square>
  void findRowDistances(const Costmap& master, const CellWindow& window, const CellWindow& wide,
                        std::vector<Square>& across) const {
    const int stride = blockCount(window) * kBlock;
    const int far = radius_ + 1;
    across.assign(
        static_cast<std::size_t>(stride) * static_cast<std::size_t>(wide.top - wide.bottom),
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
  void inflateExactly(Costmap& master, const CellWindow& window, const CellWindow& wide,
                      std::vector<Square>& across) {
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

  InflationLayerParameters parameters_;
  bool isExact_;
  InflationCostFunction costFunction_;
  int radius_ = 0;  // [cells]
  bool needsFullUpdate_ = true, isCurrent_ = true;
  CostmapBounds last_;
  std::vector<std::uint8_t> costs_;               // by squared distance [cells²], up to radius_²
  std::vector<std::vector<InflationCell>> bins_;  // by squared distance; empty between updates
  std::vector<char> seen_;                        // cells, plus a border of one marked cell
  std::size_t seenWidth_ = 0;
  std::vector<std::int16_t> rowDistances_;       // squared distances along rows [cells²]
  std::vector<std::int32_t> rowDistancesLarge_;  // the same for a large radius
};

/// Inflation costs that decay with `cost_scaling_factor_left` to the left of the robot's path and
/// with `cost_scaling_factor_right` to the right of it, so that a robot in a corridor keeps to the
/// side of the greater factor (nav2_costmap_2d::AsymmetricInflationLayer).
///
/// A lethal cell is to the left of the path when it lies to the left of the line through the
/// nearest pose and the next. Without a path, and when the robot is nearer to its end than
/// `goal_distance_threshold`, both sides decay with the greater factor. Nav2 had published only the
/// keys of this layer when it was implemented; the handling of these two cases is an interpretation
/// of the keys.
class AsymmetricInflationLayer final : public CostmapLayer {
 public:
  AsymmetricInflationLayer(const AsymmetricInflationLayerParameters& parameters,
                           const LayerSite& site)
      : CostmapLayer(site),
        parameters_(parameters),
        left_(withFactor(parameters.costScalingFactorLeft), site.context.distro, site),
        right_(withFactor(parameters.costScalingFactorRight), site.context.distro, site),
        both_(withFactor(
                  std::max(parameters.costScalingFactorLeft, parameters.costScalingFactorRight)),
              site.context.distro, site) {}

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override {
    const bool wasAsymmetric = isAsymmetric_;
    isAsymmetric_ =
        plan_.size() >= 2 && (observation.pose.position - plan_.back().position).norm() >
                                 parameters_.goalDistanceThreshold;
    left_.updateBounds(observation, master, bounds);
    if (wasAsymmetric != isAsymmetric_ || (isNew_ && isAsymmetric_)) {
      bounds = unboundedBounds();
    }
    isNew_ = false;
  }

  void updateCosts(Costmap& master, const CellWindow& window) override {
    isCurrent_ = true;
    if (!isAsymmetric_) {
      both_.updateCosts(master, window);
      return;
    }
    Costmap left = master, right = master;  // each with the obstacles on its side of the plan
    forEachCell(wholeWindow(master), [&](Cell cell) {
      if (isSource(master.at(cell))) {
        (isLeft(master.cellToWorld(cell)) ? right : left).set(cell, kFreeSpace);
      }
    });
    left_.updateCosts(left, window);
    right_.updateCosts(right, window);
    forEachCell(window, [&](Cell cell) {
      const std::uint8_t old = master.at(cell), l = left.at(cell), r = right.at(cell);
      if (old != kNoInformation) {
        master.set(cell, std::max({old, l, r}));
      } else if (!isSource(old)) {  // stays 255 only if neither side raises it
        master.set(cell, l == old ? r : r == old ? l : std::max(l, r));
      }
    });
  }

  void reset(double time) override {
    left_.reset(time);
    plan_.clear();
    isNew_ = true;
    isCurrent_ = false;
  }
  bool isCurrent() const override { return isCurrent_; }
  void setPlan(const Path& plan) override {
    isNew_ = isNew_ || plan != plan_;
    plan_ = plan;
  }

  /// With the mean of the two factors, for planners and controllers that estimate distances from
  /// costs.
  std::optional<InflationCostFunction> inflation(const std::string& wanted) const override {
    std::optional<InflationCostFunction> costFunction = left_.inflation(wanted);
    if (costFunction) {
      costFunction->scaling =
          0.5 * (parameters_.costScalingFactorLeft + parameters_.costScalingFactorRight);
    }
    return costFunction;
  }

 private:
  InflationLayerParameters withFactor(double factor) const {
    InflationLayerParameters one = static_cast<const InflationLayerParameters&>(parameters_);
    one.costScalingFactor = factor;
    return one;
  }

  bool isSource(std::uint8_t cost) const {
    return isInflationSource(cost, parameters_.inflateAroundUnknown);
  }

  bool isLeft(const Vec2& place) const {
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

  AsymmetricInflationLayerParameters parameters_;
  InflationLayer left_, right_, both_;
  Path plan_;                  // latest path
  bool isAsymmetric_ = false;  // the sides have different factors in this update
  bool isNew_ = false;         // the path has changed since the last update
  bool isCurrent_ = true;
};

}  // namespace

LayerPointer makeLayer(const InflationLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<InflationLayer>(parameters, site.context.distro, site);
}
/// Nav2's inflation layer until Kilted, available in every branch
/// (nav2_costmap_2d::LegacyInflationLayer, which exists since Lyrical).
LayerPointer makeLayer(const LegacyInflationLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<InflationLayer>(parameters, Distro::Jazzy, site);
}
LayerPointer makeLayer(const AsymmetricInflationLayerParameters& parameters,
                       const LayerSite& site) {
  return std::make_unique<AsymmetricInflationLayer>(parameters, site);
}

}  // namespace sim2d::nav2
