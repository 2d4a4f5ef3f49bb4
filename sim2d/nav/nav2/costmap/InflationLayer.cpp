#include "sim2d/nav/nav2/costmap/InflationLayer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim2d/nav/nav2/costmap/CostmapCells.h"

namespace sim2d::nav2 {
namespace {

constexpr double kTableSteps = 100.0;  // per cell, of Nav2 main

InflationLaw lawOf(const InflationLayerParameters& parameters, const CostmapContext& context) {
  const bool isCustom =
      context.distro >= Distro::Lyrical && parameters.customInscribedRadius >= 0.0;
  return {parameters.inflationRadius, parameters.costScalingFactor,
          isCustom ? parameters.customInscribedRadius : context.footprint.inscribed};
}

constexpr int kBlock = 8;           // columns worked at in one go
constexpr int kMostRadius16 = 127;  // [cells]; (r + 1)² + r² fits 16 bits

bool isInside(const CellWindow& window, Cell cell) {
  return cell.column >= window.left && cell.column < window.right && cell.row >= window.bottom &&
         cell.row < window.top;
}

int blocksFor(const CellWindow& window) {
  return (window.right - window.left + kBlock - 1) / kBlock;
}

/// `squares` lowered to those of `line` plus `more`; of a fixed length, so that it is vectorised.
template <class Square>
void lowerBlock(std::array<Square, kBlock>& squares, const Square* line, Square more) {
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squares[i] = std::min(squares[i], static_cast<Square>(line[i] + more));
  }
}

}  // namespace

InflationLayer::InflationLayer(std::string name, const CostmapContext& context,
                               const InflationLayerParameters& parameters, double resolution)
    : CostmapLayer(std::move(name), context),
      parameters_(parameters),
      law_(lawOf(parameters, context)),
      radius_(Costmap(0, 0, resolution, Vec2::Zero()).cellDistance(parameters.inflationRadius)) {
  const int most = radius_ * radius_;
  costs_.reserve(static_cast<std::size_t>(most) + 1);
  for (int square = 0; square <= most; ++square) {
    double cells = std::sqrt(static_cast<double>(square));
    if (context.distro >= Distro::Lyrical) {
      cells = std::round(cells * kTableSteps) / kTableSteps;
    }
    costs_.push_back(law_.cost(cells * resolution));
  }
  bins_.resize(costs_.size());
}

void InflationLayer::updateBounds(const Observation& /*observation*/, const Costmap& /*master*/,
                                  CostmapBounds& bounds) {
  const CostmapBounds now = bounds;
  if (isWhole_) {
    bounds = unboundedBounds();
    isWhole_ = false;
  } else {
    bounds.touch(last_);  // so that what is no longer there deflates
    bounds.low -= Vec2::Constant(law_.radius);
    bounds.high += Vec2::Constant(law_.radius);
  }
  last_ = now;
}

void InflationLayer::updateCosts(Costmap& master, const CellWindow& window) {
  isCurrent_ = true;
  if (!parameters_.enabled || radius_ == 0) {
    return;
  }
  // Obstacles outside the window reach into it.
  const CellWindow wide{std::max(0, window.left - radius_), std::max(0, window.bottom - radius_),
                        std::min(master.width(), window.right + radius_),
                        std::min(master.height(), window.top + radius_)};
  if (context().distro < Distro::Lyrical) {
    inflateBySpreading(master, window, wide);
  } else if (radius_ <= kMostRadius16) {
    inflateExactly(master, window, wide, across_);
  } else {
    inflateExactly(master, window, wide, acrossFar_);
  }
}

void InflationLayer::reset(double /*time*/) {
  isWhole_ = true;
  isCurrent_ = false;
}

bool InflationLayer::isSource(std::uint8_t cost) const {
  return cost == kLethal || (cost == kNoInformation && parameters_.inflateAroundUnknown);
}

std::uint8_t InflationLayer::raised(std::uint8_t old, std::uint8_t cost) const {
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
  beginSeen(master);
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
    for (std::size_t i = 0; i < bins_[bin].size(); ++i) {  // may grow meanwhile
      const Spread spread = bins_[bin][i];
      const Cell cell = spread.cell;
      char& isSeen = seen_[seenIndex(cell)];
      if (isSeen != 0) {
        continue;
      }
      isSeen = 1;
      if (isInside(window, cell)) {
        master.set(cell, raised(master.at(cell), costs_[bin]));
      }
      enqueue({{cell.column - 1, cell.row}, spread.source}, bin);
      enqueue({{cell.column, cell.row - 1}, spread.source}, bin);
      enqueue({{cell.column + 1, cell.row}, spread.source}, bin);
      enqueue({{cell.column, cell.row + 1}, spread.source}, bin);
    }
    bins_[bin].clear();
  }
}

/// Nothing is seen but a border about the map.
void InflationLayer::beginSeen(const Costmap& master) {
  seenWidth_ = static_cast<std::size_t>(master.width()) + 2;
  seen_.assign(seenWidth_ * (static_cast<std::size_t>(master.height()) + 2), 1);
  for (int row = 0; row < master.height(); ++row) {
    const auto begin = seen_.begin() + static_cast<std::ptrdiff_t>(seenIndex({0, row}));
    std::fill(begin, begin + master.width(), char{0});
  }
}

/// Bins before `bin` are done.
void InflationLayer::enqueue(const Spread& spread, std::size_t bin) {
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

/// Squared distance to the nearest source in the same row, in `across`: rows of `wide`, columns of
/// `window`, filled up to whole blocks.
template <class Square>
void InflationLayer::findRowDistances(const Costmap& master, const CellWindow& window,
                                      const CellWindow& wide, std::vector<Square>& across) const {
  const int stride = blocksFor(window) * kBlock;
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

/// The squares of the rows around plus that of the way up or down: the least of them.
template <class Square>
void InflationLayer::inflateExactly(Costmap& master, const CellWindow& window,
                                    const CellWindow& wide, std::vector<Square>& across) {
  findRowDistances(master, window, wide, across);
  const int blocks = blocksFor(window), width = window.right - window.left;
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
        lowerBlock(squares, line, static_cast<Square>(up * up));
      }
      const int last = std::min(kBlock, width - block * kBlock);
      for (int i = 0; i < last; ++i) {
        const int square = squares[static_cast<std::size_t>(i)];
        if (square <= most) {
          std::uint8_t& cost = costs[block * kBlock + i];
          cost = raised(cost, costs_[static_cast<std::size_t>(square)]);
        }
      }
    }
  }
}

}  // namespace sim2d::nav2
