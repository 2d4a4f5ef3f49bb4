#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/map/DistanceField.h"

namespace sim2d {

constexpr double kWantedClearance = 0.3;  // [m] beyond the radius

/// What a body of one radius may walk on: the cells of a distance field with their price, and one
/// closed cell all round them.
class Terrain {
 public:
  using Index = std::int32_t;

  Terrain(const DistanceField& field, double radius);

  bool isOpen(Index index) const { return price_[static_cast<std::size_t>(index)] != 0; }
  bool isUnknown(Index index) const { return unknown_[static_cast<std::size_t>(index)] != 0; }
  bool hasUnknown() const { return hasUnknown_; }
  /// 6 where there is clearance enough, up to 12 where the body just fits.
  std::uint32_t price(Index index) const { return price_[static_cast<std::size_t>(index)]; }
  Index indexOf(Cell cell) const { return (cell.row + 1) * stride_ + cell.column + 1; }
  Cell cellOf(Index index) const { return {index % stride_ - 1, index / stride_ - 1}; }
  Index stride() const { return stride_; }
  std::size_t size() const { return price_.size(); }

 private:
  Index stride_;
  bool hasUnknown_ = false;
  std::vector<std::uint8_t> price_;  // 0: closed
  std::vector<char> unknown_;
};

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

 private:
  static constexpr std::size_t kTile = 256;
  using Tile = std::array<std::uint32_t, kTile>;
  std::vector<std::unique_ptr<Tile>> tiles_;
};

/// Priority queue for keys that never fall below the last one taken (Ahuja et al. 1990), as in
/// Dijkstra's search. Entries of one key come out in an order that depends on the history only.
class RadixHeap {
 public:
  using Entry = std::pair<std::uint32_t, std::int32_t>;  // key, value

  bool isEmpty() const { return size_ == 0; }

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

/// Cheapest ways from all cells to one goal (Dijkstra over eight neighbours), searched only as far
/// as somebody has asked for. Unknown cells are entered when all that is known has been searched.
class GoalField {
 public:
  using Index = Terrain::Index;

  GoalField(const Terrain& terrain, Index goal);

  Index goal() const { return goal_; }
  /// Extends the search to the open cell `from`; false when no way leads there.
  bool reach(Index from);
  /// The next cell on the way from a cell that has been reached; the goal is its own.
  Index next(Index from) const;

 private:
  struct Neighbour {
    Index offset = 0;
    std::uint32_t length = 0;
    Index first = 0, second = 0;  // cells that a diagonal step passes; 0 for straight ones
  };
  struct Seed {
    Index cell = 0;
    std::uint32_t cost = 0;
  };

  bool canStep(Index from, const Neighbour& neighbour) const;
  std::uint32_t stepCost(Index from, const Neighbour& neighbour) const;
  void relax(Index cell, std::uint32_t cost);
  void expand(Index cell);
  bool enterUnknown();

  const Terrain& terrain_;
  Index goal_;
  std::array<Neighbour, 8> neighbours_;
  CellCosts cost_;
  RadixHeap heap_;
  std::uint32_t frontier_ = 0;  // costs up to here are final
  std::vector<Seed> seeds_;     // unknown cells beside the known ones
  bool inUnknown_ = false;
};

}  // namespace sim2d
