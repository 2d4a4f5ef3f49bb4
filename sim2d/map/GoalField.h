#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/map/Terrain.h"

namespace sim2d {

/// One number per cell, in tiles that exist only where something was written: a search that ends
/// early leaves most of a large map without any.
class CellCosts {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  explicit CellCosts(std::size_t size) : tiles_((size + kTile - 1) / kTile) {}
  /// kNone where nothing was written.
  std::uint32_t at(Terrain::Index index) const {
    const auto cell = static_cast<std::size_t>(index);
    const std::unique_ptr<Tile>& tile = tiles_[cell / kTile];
    return tile ? (*tile)[cell % kTile] : kNone;
  }
  void set(Terrain::Index index, std::uint32_t cost);
  std::size_t bytes() const { return sizeof(tiles_[0]) * tiles_.size() + sizeof(Tile) * made_; }

 private:
  static constexpr std::size_t kTile = 256;
  using Tile = std::array<std::uint32_t, kTile>;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::size_t made_ = 0;  // of them
};

/// Priority queue for keys that never fall below the last one taken (Ahuja et al. 1990), as in
/// Dijkstra's search. Entries of one key come out in an order that depends on the history only.
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
  /// Number of the highest bit in which the key differs from the last one, counted from 1.
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

/// Cheapest ways from all places of a ground (cells of a `Terrain`, nodes of a `BlockGraph`) to one
/// goal, by Dijkstra, searched only as far as somebody has asked for. What is unknown is entered
/// when all that is known has been searched. `Ground` gives size(), stopFlag(), isUnknown(place)
/// and forEachStep(place, visit(place, cost)), whose steps go both ways.
template <class Ground>
class GoalSearch {
 public:
  using Index = typename Ground::Index;

  GoalSearch(const Ground& ground, Index goal)
      : ground_(ground), goal_(goal), cost_(ground.size()) {
    relax(goal, 0);
  }

  Index goal() const { return goal_; }
  std::size_t bytes() const {
    return cost_.bytes() + heap_.bytes() + sizeof(RadixHeap::Entry) * seeds_.capacity();
  }
  /// Extends the search to the open place `from`; false when no way leads there. Stopped, it can be
  /// gone on with.
  bool reach(Index from) {
    while (cost_.at(from) > frontier_) {
      ground_.stopFlag().check();
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
  /// The next place on the way from one that has been reached; the goal is its own.
  Index next(Index from) const {
    const std::uint32_t here = cost_.at(from);
    Index best = from;
    std::uint32_t lowest = kNoWay;
    ground_.forEachStep(from, [&](Index to, std::uint32_t step) {
      const std::uint32_t there = cost_.at(to);
      if (there < here && step < kNoWay - there && there + step < lowest) {
        lowest = there + step;
        best = to;
      }
    });
    assert(best != from || from == goal_);
    return best;
  }

 private:
  static constexpr std::uint32_t kNoWay = CellCosts::kNone;

  void relax(Index place, std::uint32_t cost) {
    if (cost < cost_.at(place)) {
      cost_.set(place, cost);
      heap_.push(cost, place);
    }
  }

  void expand(Index place) {
    const std::uint32_t cost = cost_.at(place);
    ground_.forEachStep(place, [&](Index to, std::uint32_t step) {
      if (step >= kNoWay - cost) {
        return;  // beyond what can be counted
      }
      if (ground_.isUnknown(to) && !inUnknown_) {
        seeds_.push_back({cost + step, to});
      } else {
        relax(to, cost + step);
      }
    });
  }

  /// All costs from here on lie above those of the first search, so that what it found stays.
  bool enterUnknown() {
    const std::uint32_t above = frontier_ + 1;
    inUnknown_ = true;
    for (const RadixHeap::Entry& seed : seeds_) {
      if (seed.first < kNoWay - above) {
        relax(seed.second, above + seed.first);
      }
    }
    seeds_ = {};
    return !heap_.isEmpty();
  }

  const Ground& ground_;
  Index goal_;
  CellCosts cost_;
  RadixHeap heap_;
  std::uint32_t frontier_ = 0;           // costs up to here are final
  std::vector<RadixHeap::Entry> seeds_;  // unknown places beside the known ones
  bool inUnknown_ = false;
};

using GoalField = GoalSearch<Terrain>;

}  // namespace sim2d
