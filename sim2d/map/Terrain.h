#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim2d/map/DistanceField.h"

namespace sim2d {

constexpr double kWantedClearance = 0.3;  // [m] beyond the radius

/// 6 where a body of that radius has clearance enough, up to 12 where it just fits, 0 where it does
/// not.
std::uint8_t priceOf(const DistanceField& field, double radius, Cell cell);

/// What a body of one radius may walk on: the cells of a distance field, or of a rectangle of it,
/// with their price, and one closed cell all round them.
class Terrain {
 public:
  using Index = std::int32_t;

  Terrain(const DistanceField& field, double radius);
  /// The cells from `low` to `high`, both included and in the field.
  Terrain(const DistanceField& field, double radius, Cell low, Cell high);

  bool isOpen(Index index) const { return price_[static_cast<std::size_t>(index)] != 0; }
  bool isUnknown(Index index) const {
    return (price_[static_cast<std::size_t>(index)] & kUnknown) != 0;
  }
  std::uint32_t price(Index index) const {
    return price_[static_cast<std::size_t>(index)] & ~kUnknown;
  }
  Index indexOf(Cell cell) const {
    return (cell.row - low_.row + 1) * stride_ + cell.column - low_.column + 1;
  }
  Cell cellOf(Index index) const {
    return {index % stride_ - 1 + low_.column, index / stride_ - 1 + low_.row};
  }
  Index stride() const { return stride_; }
  std::size_t size() const { return price_.size(); }
  const base::StopFlag& stopFlag() const { return *stop_; }

  /// visit(Index, std::uint32_t cost) for the open neighbours, eight at most.
  template <class Visit>
  void forEachStep(Index from, Visit visit) const {
    for (const Neighbour& neighbour : neighbours_) {
      if (canStep(from, neighbour)) {
        visit(from + neighbour.offset, stepCost(from, neighbour));
      }
    }
  }

 protected:
  struct Neighbour {
    Index offset = 0;
    std::uint32_t length = 0;
    Index first = 0, second = 0;  // cells that a step passes; 0 for straight ones
  };
  Terrain(const DistanceField& field, Cell low, Cell high);  // all closed
  std::uint32_t stepCost(Index from, const Neighbour& neighbour) const;
  void setPrice(Index index, std::uint8_t price, bool isUnknown) {
    price_[static_cast<std::size_t>(index)] =
        static_cast<std::uint8_t>(isUnknown ? price | kUnknown : price);
  }

 private:
  static constexpr std::uint32_t kUnknown = 0x80;  // beside the price

  bool canStep(Index from, const Neighbour& neighbour) const {
    return isOpen(from + neighbour.offset) && isOpen(from + neighbour.first) &&
           isOpen(from + neighbour.second);
  }

  const base::StopFlag* stop_;  // of the field
  Cell low_;
  Index stride_;
  std::array<Neighbour, 8> neighbours_;
  std::vector<std::uint8_t> price_;  // 0: closed
};

/// As terrain counts it: 12 times the cells walked, times the prices of both ends.
constexpr std::uint32_t kCellLength = 12;
constexpr std::uint32_t kUnknownFactor = 16;

inline std::uint32_t Terrain::stepCost(Index from, const Neighbour& neighbour) const {
  const Index to = from + neighbour.offset;
  const std::uint32_t cost = neighbour.length * (price(from) + price(to));
  return isUnknown(from) || isUnknown(to) ? kUnknownFactor * cost : cost;
}

/// The same where the length of a way alone counts: all prices are equal, and steps go in 16
/// directions, so that a way is longer by 3.1 % at most than the straight lines it stands for.
class EvenTerrain : public Terrain {
 public:
  EvenTerrain(const DistanceField& field, double radius);

  /// As of Terrain.
  template <class Visit>
  void forEachStep(Index from, Visit visit) const {
    Terrain::forEachStep(from, visit);
    for (const Neighbour& leap : leaps_) {
      // What is passed first: a leap out of the terrain passes its border.
      if (isOpen(from + leap.first) && isOpen(from + leap.second) && isOpen(from + leap.offset)) {
        visit(from + leap.offset, stepCost(from, leap));
      }
    }
  }

 private:
  std::array<Neighbour, 8> leaps_;  // two cells along, one across
};

}  // namespace sim2d
