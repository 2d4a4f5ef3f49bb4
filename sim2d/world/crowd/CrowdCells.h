#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/SocialForce.h"
#include "sim2d/world/WorkerPool.h"
#include "sim2d/world/crowd/CrowdKernel.h"

namespace sim2d {

/// The people of one instant sorted by cell, in the column format of the kernel. Does not allocate
/// once it has processed its largest crowd. Queries are thread-safe, `rebuild` is not.
class CrowdCells {
 public:
  /// All vectors have the same length. `room`: clearance of each person to walls [m].
  void rebuild(const std::vector<Walker>& walkers, const std::vector<char>& present,
               const std::vector<double>& room, WorkerPool& workers);

  std::size_t count() const { return order_.size(); }  // number of slots = people who are present
  std::size_t personIn(std::size_t slot) const { return static_cast<std::size_t>(order_[slot]); }
  CrowdColumns columns() const {
    return {x_.data(), y_.data(), vx_.data(), vy_.data(), room_.data()};
  }
  double fastest() const { return fastest_; }  // [m/s]
  std::size_t rowCount() const { return static_cast<std::size_t>(height_); }

  /// Writes the slots of the cells that a disc intersects as at most `rowCount` spans, and adds the
  /// number of slots to `slots`; returns the end of the spans. Coordinates are those of the
  /// columns.
  CrowdSpan* writeSpans(float x, float y, float radius, CrowdSpan* to, int& slots) const;

 private:
  struct alignas(64) Extent {  // of the people that one thread processed
    Vec2 low = Vec2::Zero(), high = Vec2::Zero();
    double squaredFastest = 0.0;
    bool isEmpty = true;
    void add(const Extent& other);
  };

  Extent extentOf(const std::vector<Walker>& walkers, const std::vector<char>& present,
                  WorkerPool& workers);
  void placeGrid(const Extent& all, std::size_t people);
  int cellAt(const Vec2& position) const;
  void fillColumns(const std::vector<Walker>& walkers, const std::vector<double>& room,
                   WorkerPool& workers);

  Vec2 origin_ = Vec2::Zero();  // corner of the grid
  Vec2 middle_ = Vec2::Zero();  // origin of the column coordinates
  Vec2 cell_ = Vec2::Ones();    // size [m]
  int width_ = 0, height_ = 0;
  float originX_ = 0.0F, originY_ = 0.0F;  // grid origin in column coordinates
  float slack_ = 0.0F;                     // [m]; above the rounding of the columns
  double fastest_ = 0.0;
  std::vector<Extent> extents_;  // per thread
  std::vector<int> start_, next_, cellOf_;
  std::vector<int> order_;                     // person per slot
  std::vector<float> x_, y_, vx_, vy_, room_;  // per slot
};

}  // namespace sim2d
