#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/SocialForce.h"
#include "sim2d/world/WorkerPool.h"
#include "sim2d/world/crowd/CrowdKernel.h"

namespace sim2d {

/// The people of one instant sorted by cell, in the columns of the kernel. Allocates nothing once
/// it has seen its largest crowd. Thread: queries any, `rebuild` alone.
class CrowdCells {
 public:
  /// The vectors are as long as each other. `room`: free of walls round each person [m].
  void rebuild(const std::vector<Walker>& walkers, const std::vector<char>& present,
               const std::vector<double>& room, WorkerPool& workers);

  std::size_t count() const { return order_.size(); }  // slots = people who are present
  std::size_t personIn(std::size_t slot) const { return static_cast<std::size_t>(order_[slot]); }
  CrowdColumns columns() const {
    return {x_.data(), y_.data(), vx_.data(), vy_.data(), room_.data()};
  }
  double fastest() const { return fastest_; }  // [m/s]
  std::size_t rowCount() const { return static_cast<std::size_t>(height_); }

  /// Writes the slots of the cells that a disc meets, `rowCount` spans at most, and adds up how
  /// many slots these are; returns the end of the spans. The place of the disc is as in the
  /// columns.
  CrowdSpan* writeSpans(float x, float y, float radius, CrowdSpan* to, int& slots) const;

 private:
  struct alignas(64) Extent {  // of the people that one thread looked at
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
  Vec2 middle_ = Vec2::Zero();  // of the columns
  Vec2 cell_ = Vec2::Ones();    // size [m]
  int width_ = 0, height_ = 0;
  float originX_ = 0.0F, originY_ = 0.0F;  // of the grid, as in the columns
  float slack_ = 0.0F;                     // [m]; more than the columns are rounded
  double fastest_ = 0.0;
  std::vector<Extent> extents_;  // by thread
  std::vector<int> start_, next_, cellOf_;
  std::vector<int> order_;                     // people by slot
  std::vector<float> x_, y_, vx_, vy_, room_;  // by slot
};

}  // namespace sim2d
