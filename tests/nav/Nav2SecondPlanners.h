#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include <queue>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// Parts of Nav2 a second time, from their descriptions alone and without the program's code: what
/// the program's inflation, Smac 2D and smoothers are compared with.
namespace nav2second {

using namespace sim2d::nav2;
using sim2d::Cell;

/// What a cell costs at a distance from a lethal one [m].
inline int inflatedCost(double distance, double inscribed, double scaling) {
  if (distance == 0.0) {
    return 254;
  }
  return distance <= inscribed
             ? 253
             : static_cast<int>(252.0 * std::exp(-scaling * (distance - inscribed)));
}

/// Inflation of the cells of `window`. Until Kilted cells are visited in the order of the distance
/// from the lethal cell that reached them, equal ones in the order of their discovery; later each
/// cell has the nearest one, at a distance rounded to 1/100 cell.
class Inflation {
 public:
  Inflation(const Costmap& before, const CellWindow& window,
            const InflationLayerParameters& parameters, double inscribed, Distro distro)
      : before_(before),
        after_(before),
        window_(window),
        parameters_(parameters),
        inscribed_(inscribed),
        reach_(static_cast<int>(std::ceil(parameters.inflationRadius / before.resolution()))) {
    distro < Distro::Lyrical ? spread() : measure();
  }
  const Costmap& result() const { return after_; }

 private:
  bool isLethal(Cell cell) const {
    const int cost = before_.at(cell);
    return cost == 254 || (cost == 255 && parameters_.inflateAroundUnknown);
  }
  void write(Cell cell, double cells) {
    if (cell.column < window_.left || cell.column >= window_.right || cell.row < window_.bottom ||
        cell.row >= window_.top) {
      return;
    }
    const int cost =
        inflatedCost(cells * before_.resolution(), inscribed_, parameters_.costScalingFactor);
    const int old = before_.at(cell);
    const bool isWritten =
        old == 255 ? (parameters_.inflateUnknown ? cost > 0 : cost >= 253) : cost > old;
    if (isWritten) {
      after_.set(cell, static_cast<std::uint8_t>(cost));
    }
  }
  template <class Visit>
  void eachLethal(const Visit& visit) const {
    for (int row = std::max(0, window_.bottom - reach_);
         row < std::min(before_.height(), window_.top + reach_); ++row) {
      for (int column = std::max(0, window_.left - reach_);
           column < std::min(before_.width(), window_.right + reach_); ++column) {
        if (isLethal({column, row})) {
          visit(Cell{column, row});
        }
      }
    }
  }
  void spread() {
    using Entry = std::tuple<int, int, Cell, Cell>;  // squared distance, number, cell, source
    const auto isLater = [](const Entry& a, const Entry& b) {
      return std::tie(std::get<0>(a), std::get<1>(a)) > std::tie(std::get<0>(b), std::get<1>(b));
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(isLater)> queue(isLater);
    std::vector<bool> isSeen(before_.costs().size(), false);
    int number = 0;
    eachLethal([&](Cell cell) { queue.emplace(0, number++, cell, cell); });
    while (!queue.empty()) {
      const auto [square, unused, cell, source] = queue.top();
      static_cast<void>(unused);
      queue.pop();
      if (isSeen[before_.indexOf(cell)]) {
        continue;
      }
      isSeen[before_.indexOf(cell)] = true;
      write(cell, std::sqrt(static_cast<double>(square)));
      for (const auto& [across, up] : {std::pair(-1, 0), {0, -1}, {1, 0}, {0, 1}}) {
        const Cell next{cell.column + across, cell.row + up};
        const int dx = next.column - source.column, dy = next.row - source.row;
        if (before_.contains(next) && !isSeen[before_.indexOf(next)] &&
            std::hypot(dx, dy) <= reach_) {
          queue.emplace(dx * dx + dy * dy, number++, next, source);
        }
      }
    }
  }
  void measure() {
    std::vector<Cell> lethal;
    eachLethal([&](Cell cell) { lethal.push_back(cell); });
    for (int row = window_.bottom; row < window_.top; ++row) {
      for (int column = window_.left; column < window_.right; ++column) {
        double least = std::numeric_limits<double>::infinity();
        for (const Cell cell : lethal) {
          least = std::min(least, std::hypot(cell.column - column, cell.row - row));
        }
        if (least <= reach_) {
          write({column, row}, std::floor(100.0 * least + 0.5) / 100.0);
        }
      }
    }
  }

  const Costmap& before_;
  Costmap after_;
  CellWindow window_;
  InflationLayerParameters parameters_;
  double inscribed_;
  int reach_;
};

/// Smac 2D up to its smoother.
class Smac2D {
 public:
  Smac2D(const Costmap& map, const Smac2DParameters& parameters, Distro distro)
      : map_(map), parameters_(parameters), distro_(distro) {}

  /// Cells from the start to the goal or, within the tolerance, near it; empty: no path.
  std::vector<Cell> path(Cell start, Cell goal) {
    if (distro_ != Distro::Humble) {
      map_.set(start, 0);
    } else if (collides(start)) {
      return {};
    }
    goal_ = goal;
    places_.assign(map_.costs().size(), {});
    const auto within = static_cast<float>(parameters_.tolerance / map_.resolution());
    const int last = indexOf(goal);
    int end = -1, nearGoal = 0;
    at(indexOf(start)).paid = 0.0F;
    queue_.emplace(0.0F, indexOf(start));
    while (!queue_.empty() && end < 0) {
      const int index = queue_.top().second;
      queue_.pop();
      if (std::exchange(at(index).isVisited, true)) {
        continue;
      }
      if (index == last) {
        end = index;
      } else if (nearest_.first < within && ++nearGoal >= parameters_.maxOnApproachIterations) {
        end = nearest_.second;
      } else {
        lookAround(index);
      }
    }
    return pathTo(end < 0 && nearest_.first < within ? nearest_.second : end);
  }

 private:
  using Entry = std::pair<float, int>;
  struct IsDearer {
    bool operator()(const Entry& a, const Entry& b) const { return a.first > b.first; }
  };
  struct Place {
    float paid = std::numeric_limits<float>::max();
    int parent = -1;
    bool isVisited = false;
  };

  int indexOf(Cell cell) const { return cell.row * map_.width() + cell.column; }
  Cell cellOf(int index) const { return {index % map_.width(), index / map_.width()}; }
  Place& at(int index) { return places_[static_cast<std::size_t>(index)]; }
  bool collides(Cell cell) const {
    const int cost = map_.at(cell);
    return cost == 255 ? !parameters_.allowUnknown : cost >= 253;
  }
  float toGoal(Cell cell) const {
    const auto dx = static_cast<float>(goal_.column - cell.column);
    const auto dy = static_cast<float>(goal_.row - cell.row);
    return std::sqrt(dx * dx + dy * dy);
  }

  /// Neighbours by offsets of the index, of which some lie at the other side of the map.
  void lookAround(int index) {
    const int width = map_.width();
    for (const int offset : {-1, 1, -width, width, -width - 1, -width + 1, width - 1, width + 1}) {
      const int other = index + offset;
      const bool isOnMap = other >= 0 && other < static_cast<int>(places_.size()) &&
                           std::abs(other % width - index % width) <= 1;
      if (!isOnMap || collides(cellOf(other)) || at(other).isVisited) {
        continue;
      }
      const bool isStraight = std::abs(offset) == 1 || std::abs(offset) == width;
      const auto share = static_cast<float>(map_.at(cellOf(other)) / 252.0);
      const auto multiplier = static_cast<float>(parameters_.costTravelMultiplier);
      const auto step =
          static_cast<float>((isStraight ? 1.0F : std::sqrt(2.0F)) * (1.0 + multiplier * share));
      if (at(index).paid + step < at(other).paid) {
        at(other).paid = at(index).paid + step;
        at(other).parent = index;
        const float rest = toGoal(cellOf(other));
        if (rest < nearest_.first) {
          nearest_ = {rest, other};
        }
        queue_.emplace(at(other).paid + rest, other);
      }
    }
  }

  std::vector<Cell> pathTo(int end) {
    std::vector<Cell> path;
    for (int index = end; index >= 0; index = at(index).parent) {
      path.push_back(cellOf(index));
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  Costmap map_;
  Smac2DParameters parameters_;
  Distro distro_;
  Cell goal_;
  std::vector<Place> places_;
  std::priority_queue<Entry, std::vector<Entry>, IsDearer> queue_;
  Entry nearest_{std::numeric_limits<float>::max(), -1};
};

using Points = std::vector<Vec2>;

/// Indices where a path turns back, with both ends.
inline std::vector<std::size_t> turningPoints(const Path& path) {
  std::vector<std::size_t> points = {0};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vec2 in = path[i].position - path[i - 1].position;
    const Vec2 out = path[i + 1].position - path[i].position;
    if (in.x() * out.x() + in.y() * out.y() < 0.0) {
      points.push_back(i);
    }
  }
  points.push_back(path.size() - 1);
  return points;
}

/// Applies `smooth` to each stretch between turning points that has more than `least` steps.
template <class Smooth>
Points smoothedStretches(const Path& path, std::size_t least, const Smooth& smooth) {
  Points all;
  for (const Pose2& pose : path) {
    all.push_back(pose.position);
  }
  const std::vector<std::size_t> turns = turningPoints(path);
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    const std::size_t first = turns[k], last = turns[k + 1];
    if (last - first <= least) {
      continue;
    }
    Points part(all.begin() + static_cast<std::ptrdiff_t>(first),
                all.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    smooth(part);
    std::copy(part.begin(), part.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return all;
}

/// Sweeps over all points but the ends until they rest; false: ended before, by an obstacle or the
/// number of sweeps.
inline bool sweptToRest(Points& points, const Costmap& map,
                        const SimpleSmootherParameters& parameters) {
  const Points given = points;
  Points tried = points;
  for (int sweep = 1; sweep < parameters.maxIts; ++sweep) {
    double change = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Vec2 pull = parameters.wData * (given[i] - tried[i]) +
                        parameters.wSmooth * (tried[i + 1] + tried[i - 1] - 2.0 * tried[i]);
      tried[i] += pull;
      change += std::fabs(pull.x()) + std::fabs(pull.y());
      const auto cell = map.worldToCell(tried[i]);
      if (!cell || map.at(*cell) == 253 || map.at(*cell) == 254) {
        return false;
      }
    }
    points = tried;
    if (change < parameters.tolerance) {
      return true;
    }
  }
  return false;
}

/// The sweeps, and again as often as the result is refined.
inline void sweepAll(Points& points, const Costmap& map,
                     const SimpleSmootherParameters& parameters) {
  const int rounds = parameters.doRefinement ? 1 + parameters.refinementNum : 1;
  for (int i = 0; i < rounds && sweptToRest(points, map, parameters); ++i) {
  }
}

/// nav2_smoother::SimpleSmoother without a limit of time.
inline Points simplySmoothed(const Path& path, const Costmap& map,
                             const SimpleSmootherParameters& parameters, Distro distro) {
  return smoothedStretches(path, distro == Distro::Humble ? 9 : 3,
                           [&](Points& part) { sweepAll(part, map, parameters); });
}

/// The smoother inside of Smac 2D: cusps do not count, paths of up to eleven poses stay.
inline Points smacSmoothed(Points points, const Costmap& map, const Smac2DParameters& parameters) {
  SimpleSmootherParameters sweeps;
  sweeps.tolerance = parameters.smootherTolerance;
  sweeps.maxIts = parameters.smootherMaxIterations;
  sweeps.wData = parameters.smootherWData;
  sweeps.wSmooth = parameters.smootherWSmooth;
  sweeps.doRefinement = parameters.smootherDoRefinement;
  sweeps.refinementNum = parameters.smootherRefinementNum;
  if (points.size() > 11) {
    sweepAll(points, map, sweeps);
  }
  return points;
}

/// Weights of the middle of `window` values of a polynomial of least squares.
inline Eigen::RowVectorXd polynomialWeights(int window, int order) {
  Eigen::MatrixXd powers(window, order + 1);
  for (int i = 0; i < window; ++i) {
    for (int k = 0; k <= order; ++k) {
      powers(i, k) = std::pow(static_cast<double>(i - window / 2), k);
    }
  }
  const Eigen::MatrixXd fit =
      (powers.transpose() * powers).ldlt().solve(powers.transpose());  // coefficients of values
  return fit.row(0);
}

/// nav2_smoother::SavitzkyGolaySmoother.
inline Points polynomiallySmoothed(const Path& path, const SavitzkyGolayParameters& parameters,
                                   Distro distro) {
  const bool isFree = distro >= Distro::Lyrical;
  const Eigen::RowVectorXd weights =
      polynomialWeights(isFree ? parameters.windowSize : 7, isFree ? parameters.polyOrder : 3);
  const auto half = static_cast<int>(weights.size() / 2);
  return smoothedStretches(path, 9, [&](Points& part) {
    const auto last = static_cast<int>(part.size()) - 1;
    for (int round = 0; round <= (parameters.doRefinement ? parameters.refinementNum : 0);
         ++round) {
      const Points given = part;
      for (int i = 1; i < last; ++i) {
        part[static_cast<std::size_t>(i)].setZero();
        for (int k = -half; k <= half; ++k) {
          const int from = std::max(0, std::min(last, i + k));
          part[static_cast<std::size_t>(i)] +=
              weights(k + half) * given[static_cast<std::size_t>(from)];
        }
      }
    }
  });
}

}  // namespace nav2second
