#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/map/TraversableSpace.h"

namespace sim2d {

/// One cost per cell, in tiles that are allocated on first write, so a search that ends early needs
/// little memory on a large map.
class CellCosts {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  explicit CellCosts(std::size_t size) : tiles_((size + kTile - 1) / kTile) {}
  /// kNone if never written.
  std::uint32_t at(Terrain::Index index) const {
    const auto cell = static_cast<std::size_t>(index);
    const std::unique_ptr<Tile>& tile = tiles_[cell / kTile];
    return tile ? (*tile)[cell % kTile] : kNone;
  }
  void set(Terrain::Index index, std::uint32_t cost) {
    const auto cell = static_cast<std::size_t>(index);
    std::unique_ptr<Tile>& tile = tiles_[cell / kTile];
    if (!tile) {
      tile = std::make_unique<Tile>();
      tile->fill(kNone);
      ++made_;
    }
    (*tile)[cell % kTile] = cost;
  }
  std::size_t bytes() const { return sizeof(tiles_[0]) * tiles_.size() + sizeof(Tile) * made_; }

 private:
  static constexpr std::size_t kTile = 256;
  using Tile = std::array<std::uint32_t, kTile>;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::size_t made_ = 0;  // allocated tiles
};

/// Monotone priority queue: pushed keys are never below the last popped one (Ahuja et al. 1990), as
/// in Dijkstra's algorithm. The order of equal keys depends only on the history of calls.
class RadixHeap {
 public:
  using Entry = std::pair<std::uint32_t, std::int32_t>;  // key, value

  bool isEmpty() const { return size_ == 0; }
  std::size_t bytes() const {
    std::size_t entries = spare_.capacity();
    for (const std::vector<Entry>& bucket : buckets_) {
      entries += bucket.capacity();
    }
    return sizeof(Entry) * entries;
  }

  void push(std::uint32_t key, std::int32_t value) {
    assert(key >= last_);
    buckets_[bucketOf(key)].emplace_back(key, value);
    ++size_;
  }

  Entry pop() {
    assert(!isEmpty());
    if (buckets_[0].empty()) {
      refill();
    }
    const Entry entry = buckets_[0].back();
    buckets_[0].pop_back();
    --size_;
    return entry;
  }

 private:
  /// Position of the highest bit in which the key differs from the last popped one, from 1; 0:
  /// equal.
  std::size_t bucketOf(std::uint32_t key) const {
    const std::uint32_t difference = key ^ last_;
    return difference == 0 ? 0U : 32U - static_cast<std::size_t>(__builtin_clz(difference));
  }

  void refill() {
    std::size_t first = 1;
    while (buckets_[first].empty()) {
      ++first;
    }
    spare_.swap(buckets_[first]);
    last_ = std::min_element(spare_.begin(), spare_.end())->first;
    for (const Entry& entry : spare_) {
      buckets_[bucketOf(entry.first)].push_back(entry);
    }
    spare_.clear();
  }

  std::array<std::vector<Entry>, 33> buckets_;
  std::vector<Entry> spare_;
  std::uint32_t last_ = 0;
  std::size_t size_ = 0;
};

/// Single-goal Dijkstra search on a graph (cells of a `Terrain`, nodes of a `BlockGraph`), extended
/// only as far as queries require. Unknown places are entered after all known ones are searched.
/// The graph provides size(), stopFlag(), isUnknown(place) and forEachStep(place, visit(place,
/// cost)) with symmetric steps.
template <class Graph>
class GoalSearch {
 public:
  using Index = typename Graph::Index;

  GoalSearch(const Graph& graph, Index goal) : graph_(graph), goal_(goal), cost_(graph.size()) {
    relax(goal, 0);
  }

  Index goal() const { return goal_; }
  std::size_t bytes() const {
    return cost_.bytes() + heap_.bytes() + sizeof(RadixHeap::Entry) * seeds_.capacity();
  }
  /// Extends the search to the open place `from`; false: the goal is unreachable from it. After
  /// `base::Stopped` the search can be resumed.
  bool reach(Index from) {
    while (cost_.at(from) > frontier_) {
      graph_.stopFlag().check();
      if (heap_.isEmpty() && (inUnknown_ || !enterUnknown())) {
        return false;
      }
      const auto [cost, place] = heap_.pop();
      if (cost == cost_.at(place)) {
        frontier_ = cost;
        expand(place);
      }
    }
    return true;
  }
  /// The next place on the path from a reached place; the goal returns itself.
  Index next(Index from) const {
    const std::uint32_t here = cost_.at(from);
    Index best = from;
    std::uint32_t lowest = kUnreachable;
    graph_.forEachStep(from, [&](Index to, std::uint32_t step) {
      const std::uint32_t there = cost_.at(to);
      if (there < here && step < kUnreachable - there && there + step < lowest) {
        lowest = there + step;
        best = to;
      }
    });
    assert(best != from || from == goal_);
    return best;
  }

 private:
  static constexpr std::uint32_t kUnreachable = CellCosts::kNone;

  void relax(Index place, std::uint32_t cost) {
    if (cost < cost_.at(place)) {
      cost_.set(place, cost);
      heap_.push(cost, place);
    }
  }

  void expand(Index place) {
    const std::uint32_t cost = cost_.at(place);
    graph_.forEachStep(place, [&](Index to, std::uint32_t step) {
      if (step >= kUnreachable - cost) {
        return;  // the cost would overflow
      }
      if (graph_.isUnknown(to) && !inUnknown_) {
        seeds_.push_back({cost + step, to});
      } else {
        relax(to, cost + step);
      }
    });
  }

  /// Costs continue above those of the search in known places, so earlier results stay valid.
  bool enterUnknown() {
    const std::uint32_t above = frontier_ + 1;
    inUnknown_ = true;
    for (const RadixHeap::Entry& seed : seeds_) {
      if (seed.first < kUnreachable - above) {
        relax(seed.second, above + seed.first);
      }
    }
    seeds_ = {};
    return !heap_.isEmpty();
  }

  const Graph& graph_;
  Index goal_;
  CellCosts cost_;
  RadixHeap heap_;
  std::uint32_t frontier_ = 0;           // costs up to this value are final
  std::vector<RadixHeap::Entry> seeds_;  // unknown places next to known ones
  bool inUnknown_ = false;
};

using CellGoalSearch = GoalSearch<Terrain>;

}  // namespace sim2d
