#pragma once

#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include <queue>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// Theta* a second time, from descriptions of Nav2's planner alone and built otherwise than the
/// program's: nodes are objects that point to each other, the queue is std::priority_queue, lengths
/// are std::hypot, and the cells of a line come from closed forms instead of an error that is
/// carried along.
namespace thetareference {

using sim2d::nav2::Costmap;
using sim2d::nav2::Distro;
using sim2d::nav2::ThetaStarParameters;
using sim2d::nav2::Vec2;

struct Node {
  int x = 0, y = 0;
  double g = DBL_MAX, h = DBL_MAX, f = DBL_MAX;
  const Node* parent = nullptr;
  bool isInQueue = false;
};

struct IsDearer {
  bool operator()(const Node* a, const Node* b) const { return a->f > b->f; }
};

class ThetaStar {
 public:
  ThetaStar(const Costmap& costmap, const ThetaStarParameters& parameters, Distro distro)
      : map_(costmap), parameters_(parameters), isBresenham_(distro >= Distro::Lyrical) {}

  /// Poses' places from start to goal; empty without a path. The start's cell is free.
  std::vector<Vec2> path(int startX, int startY, int goalX, int goalY) {
    goalX_ = goalX;
    goalY_ = goalY;
    map_.set({startX, startY}, 0);
    if (!mayEnter(goalX, goalY)) {
      return {};
    }
    const Node* const last = search(startX, startY);
    return last == nullptr ? std::vector<Vec2>() : pointsTo(*last);
  }

 private:
  int cost(int x, int y) const { return map_.at({x, y}); }
  bool mayEnter(int x, int y) const {
    return cost(x, y) == 255 ? parameters_.allowUnknown : cost(x, y) <= 252;
  }
  double share(double weighed) const {
    return parameters_.traversalCost * weighed * weighed / 252 / 252;
  }
  double traversal(int x, int y) const { return share(26 + 0.9 * cost(x, y)); }
  double euclid(const Node& a, const Node& b) const {
    return parameters_.eucCost * std::hypot(a.x - b.x, a.y - b.y);
  }

  const Node* search(int startX, int startY) {
    nodes_.clear();
    nodes_.resize(map_.costs().size());
    std::priority_queue<Node*, std::vector<Node*>, IsDearer> queue;
    Node* now = at(startX, startY);
    now->g = traversal(startX, startY);
    now->h = heuristic(*now);
    now->f = now->g + now->h;
    now->parent = now;
    now->isInQueue = true;
    queue.push(now);
    while (!queue.empty()) {
      if (now->x == goalX_ && now->y == goalY_) {
        return now;
      }
      now->isInQueue = false;
      const Node* const grandparent = now->parent->parent;
      double alongLine = 0.0;
      if (sees(*now, *grandparent, alongLine)) {
        const double g = grandparent->g + euclid(*now, *grandparent) + alongLine;
        if (g < now->g) {
          now->parent = grandparent;
          now->g = g;
          now->f = g + now->h;
        }
      }
      improveNeighbours(*now, queue);
      now = queue.top();
      queue.pop();
    }
    return nullptr;
  }

  double heuristic(const Node& node) const {
    const double weight = parameters_.eucCost < 1.0 ? parameters_.eucCost : 1.0;
    return weight * std::hypot(node.x - goalX_, node.y - goalY_);
  }

  Node* at(int x, int y) {
    auto& node = nodes_[map_.indexOf({x, y})];
    if (!node) {
      node = std::make_unique<Node>();
      node->x = x;
      node->y = y;
    }
    return node.get();
  }

  template <class Queue>
  void improveNeighbours(const Node& now, Queue& queue) {
    const int across[] = {0, 0, 1, -1, 1, -1, 1, -1}, up[] = {1, -1, 0, 0, -1, 1, 1, -1};
    for (int i = 0; i < parameters_.howManyCorners; ++i) {
      const int x = now.x + across[i], y = now.y + up[i];
      if (!map_.contains({x, y}) || !mayEnter(x, y)) {
        continue;
      }
      Node* const next = at(x, y);
      const double g = now.g + euclid(now, *next) + traversal(x, y);
      const double h = heuristic(*next);
      if (next->f > g + h) {
        next->g = g;
        next->h = h;
        next->f = g + h;
        next->parent = &now;
        if (!next->isInQueue) {
          next->isInQueue = true;
          queue.push(next);
        }
      }
    }
  }

  /// A cell of a line; the index of cells beside the map is taken modulo 2^32, as Nav2 computes it.
  bool isSeenThrough(int x, int y, double& sum) const {
    const unsigned index =
        static_cast<unsigned>(y) * static_cast<unsigned>(map_.width()) + static_cast<unsigned>(x);
    if (index >= map_.costs().size()) {
      return false;
    }
    const int cost = map_.costs()[index];
    const double weighed = cost == 255 ? 253.0 : 26 + 0.9 * cost;
    if (cost == 255 ? !parameters_.allowUnknown : weighed > 252) {
      return false;
    }
    sum += share(weighed);
    return true;
  }

  bool sees(const Node& a, const Node& b, double& sum) const {
    return isBresenham_ ? seesByCells(a, b, sum) : seesByCorners(a, b, sum);
  }

  /// Column k of the line (row, where it is steeper) passes the cells between the heights
  /// k across / along and (k + 1) across / along.
  bool seesByCorners(const Node& a, const Node& b, double& sum) const {
    const bool isFlat = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const int along = isFlat ? std::abs(b.x - a.x) : std::abs(b.y - a.y);
    const int across = isFlat ? std::abs(b.y - a.y) : std::abs(b.x - a.x);
    const int sx = b.x > a.x ? 1 : -1, sy = b.y > a.y ? 1 : -1;
    const auto look = [&](int k, int side) {
      const int i = isFlat ? k : side, j = isFlat ? side : k;  // corners to the right, upward
      return isSeenThrough(a.x + sx * i - (sx < 0 ? 1 : 0), a.y + sy * j - (sy < 0 ? 1 : 0), sum);
    };
    for (int k = 0; k < along; ++k) {
      if (across == 0) {  // along an axis: one of both sides is enough
        const int x = isFlat ? a.x + sx * k - (sx < 0 ? 1 : 0) : a.x;
        const int y = isFlat ? a.y : a.y + sy * k - (sy < 0 ? 1 : 0);
        if (!isSeenThrough(x, y, sum) &&
            !isSeenThrough(isFlat ? x : x - 1, isFlat ? y - 1 : y, sum)) {
          return false;
        }
        continue;
      }
      const int low = k * across / along, high = (k + 1) * across / along;  // whole heights
      if (high > low && !look(k, low)) {
        return false;
      }
      if ((k + 1) * across % along != 0 && !look(k, high)) {
        return false;
      }
    }
    return true;
  }

  /// The cells of a line are those of the rounded heights: half a cell is rounded up where the line
  /// is flat or diagonal, down where it is steep.
  bool seesByCells(const Node& a, const Node& b, double& sum) const {
    const int dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y);
    const int sx = b.x > a.x ? 1 : -1, sy = b.y > a.y ? 1 : -1;
    const bool isFlat = dx >= dy;
    const int along = isFlat ? dx : dy, across = isFlat ? dy : dx;
    const auto rounded = [&](int k) {
      return isFlat ? (2 * k * across + along) / (2 * along)
                    : (2 * k * across + along - 1) / (2 * along);
    };
    for (int k = 0; k < along; ++k) {
      const int side = rounded(k);
      const int x = a.x + sx * (isFlat ? k : side), y = a.y + sy * (isFlat ? side : k);
      if (!isSeenThrough(x, y, sum)) {
        return false;
      }
      if (rounded(k + 1) > side && !(mayEnter(x + sx, y) && mayEnter(x, y + sy))) {
        return false;
      }
    }
    return true;
  }

  std::vector<Vec2> pointsTo(const Node& last) const {
    std::vector<const Node*> nodes = {&last};
    while (nodes.back()->parent != nodes.back()) {
      nodes.push_back(nodes.back()->parent);
    }
    std::vector<Vec2> points;
    for (std::size_t i = nodes.size() - 1; i > 0; --i) {
      const Vec2 from = map_.cellToWorld({nodes[i]->x, nodes[i]->y});
      const Vec2 to = map_.cellToWorld({nodes[i - 1]->x, nodes[i - 1]->y});
      const double length = std::hypot(to.x() - from.x(), to.y() - from.y());
      const int pieces = static_cast<int>(length / map_.resolution());
      points.push_back(from);
      for (int k = 1; k < pieces; ++k) {
        points.push_back(from + k * map_.resolution() * (to - from) / length);
      }
    }
    points.push_back(map_.cellToWorld({last.x, last.y}));
    return points;
  }

  Costmap map_;
  ThetaStarParameters parameters_;
  bool isBresenham_;
  int goalX_ = 0, goalY_ = 0;
  std::vector<std::unique_ptr<Node>> nodes_;
};

}  // namespace thetareference
