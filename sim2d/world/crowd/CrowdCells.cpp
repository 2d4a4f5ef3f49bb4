#include <algorithm>
#include <cmath>
#include <cstddef>

#include <xsimd/xsimd.hpp>

#include "sim2d/world/StepBuffers.h"
#include "sim2d/world/crowd/CrowdForces.h"

namespace sim2d {
namespace {

// Cells are narrow, so that a row of candidates ends near the disc, and high, so that there are few
// rows.
constexpr double kCellWidth = 1.0;   // [m]
constexpr double kCellHeight = 5.0;  // [m]

using Rows = xsimd::batch<float, xsimd::sse2>;
constexpr int kRowsAtOnce = Rows::size;

constexpr std::size_t kSlice = 512;  // people per work slice

int cellsIn(double length, double cell) {
  return static_cast<int>(length / cell) + 1;
}

int boundedCell(double value, int count) {
  return static_cast<int>(std::max(0.0, std::min(value, static_cast<double>(count - 1))));
}

}  // namespace

void CrowdCells::Extent::add(const Extent& other) {
  if (!other.isEmpty) {
    low = isEmpty ? other.low : Vec2(low.cwiseMin(other.low));
    high = isEmpty ? other.high : Vec2(high.cwiseMax(other.high));
    squaredFastest = std::max(squaredFastest, other.squaredFastest);
    isEmpty = false;
  }
}

CrowdCells::Extent CrowdCells::extentOf(const std::vector<Walker>& walkers,
                                        const std::vector<char>& present, WorkerPool& workers) {
  extents_.assign(workers.threadCount(), Extent{});
  workers.parallelFor(
      walkers.size(), kSlice, [&](std::size_t thread, std::size_t begin, std::size_t end) {
        Extent extent = extents_[thread];
        for (std::size_t i = begin; i < end; ++i) {
          const Walker& walker = walkers[i];
          if (present[i] != 0) {
            extent.add({walker.position, walker.position, walker.velocity.squaredNorm(), false});
          }
        }
        extents_[thread] = extent;
      });
  Extent all;
  for (const Extent& extent : extents_) {
    all.add(extent);
  }
  return all;
}

void CrowdCells::placeGrid(const Extent& all, std::size_t people) {
  fastest_ = std::sqrt(all.squaredFastest);
  const Vec2 size = all.high - all.low;
  const double mostCells = 4096.0 + 4.0 * static_cast<double>(people);
  const Vec2 wanted = Vec2(size.x() / kCellWidth, size.y() / kCellHeight);  // in cells
  const double coarser = std::max(
      {1.0, std::sqrt(wanted.x() * wanted.y() / mostCells), wanted.maxCoeff() / mostCells});
  cell_ = coarser * Vec2(kCellWidth, kCellHeight);
  origin_ = all.low;
  middle_ = (all.low + all.high) / 2.0;
  originX_ = static_cast<float>(origin_.x() - middle_.x());
  originY_ = static_cast<float>(origin_.y() - middle_.y());
  slack_ = static_cast<float>(1e-3 + 1e-6 * size.maxCoeff());
  width_ = all.isEmpty ? 0 : cellsIn(size.x(), cell_.x());
  height_ = all.isEmpty ? 0 : cellsIn(size.y(), cell_.y());
}

void CrowdCells::rebuild(const std::vector<Walker>& walkers, const std::vector<char>& present,
                         const std::vector<double>& room, WorkerPool& workers) {
  placeGrid(extentOf(walkers, present, workers), walkers.size());
  cellOf_.resize(walkers.size());
  workers.parallelFor(walkers.size(), kSlice,
                      [&](std::size_t /*thread*/, std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          cellOf_[i] = present[i] != 0 ? cellAt(walkers[i].position) : -1;
                        }
                      });
  sortByCell(cellOf_, static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), start_,
             next_, order_);
  fillColumns(walkers, room, workers);
}

int CrowdCells::cellAt(const Vec2& position) const {
  const Vec2 place = (position - origin_).cwiseQuotient(cell_);
  return boundedCell(place.y(), height_) * width_ + boundedCell(place.x(), width_);
}

void CrowdCells::fillColumns(const std::vector<Walker>& walkers, const std::vector<double>& room,
                             WorkerPool& workers) {
  for (std::vector<float>* column : {&x_, &y_, &vx_, &vy_, &room_}) {
    column->resize(order_.size() + static_cast<std::size_t>(kCrowdLanes));
  }
  workers.parallelFor(order_.size(), kSlice,
                      [&](std::size_t /*thread*/, std::size_t begin, std::size_t end) {
                        for (std::size_t slot = begin; slot < end; ++slot) {
                          const Walker& walker = walkers[personIn(slot)];
                          x_[slot] = static_cast<float>(walker.position.x() - middle_.x());
                          y_[slot] = static_cast<float>(walker.position.y() - middle_.y());
                          vx_[slot] = static_cast<float>(walker.velocity.x());
                          vy_[slot] = static_cast<float>(walker.velocity.y());
                          assignIfChanged(room_[slot], static_cast<float>(room[personIn(slot)]));
                        }
                      });
}

/// Processes four rows at a time.
CrowdSpan* CrowdCells::writeSpans(float x, float y, float radius, CrowdSpan* to, int& slots) const {
  const float right = x - originX_;
  const float up = y - originY_;
  const float reach = radius + slack_;
  const auto height = static_cast<float>(cell_.y());
  const auto perWidth = static_cast<float>(1.0 / cell_.x());
  const int bottom = boundedCell((up - reach) / height, height_);
  const int top = boundedCell((up + reach) / height, height_);
  const Rows middle(right * perWidth);
  const Rows lastColumn(static_cast<float>(width_ - 1));
  const Rows zero(0.0F);
  const Rows steps = Rows{0.0F, 1.0F, 2.0F, 3.0F} * Rows(height);
  const CrowdSpan* const begin = to;
  for (int row = bottom; row <= top; row += kRowsAtOnce) {
    // Distances from the disc's centre to the lower edge of the row, and to the row.
    const Rows low = Rows(static_cast<float>(row) * height - up) + steps;
    const Rows gap = xsimd::max(xsimd::max(zero, low), zero - low - Rows(height));
    const Rows half2 = Rows(reach * reach) - gap * gap;
    const Rows half = xsimd::sqrt(xsimd::max(zero, half2)) * Rows(perWidth);
    const auto write = [&](const Rows& place, int* columns) {
      xsimd::to_int(xsimd::max(zero, xsimd::min(place, lastColumn))).store_aligned(columns);
    };
    alignas(16) int first[kRowsAtOnce];
    alignas(16) int last[kRowsAtOnce];
    write(middle - half, first);
    write(middle + half, last);
    for (int i = 0; i < kRowsAtOnce && row + i <= top; ++i) {
      const int* const start = start_.data() + static_cast<std::ptrdiff_t>(row + i) * width_;
      const CrowdSpan span{start[first[i]], start[last[i] + 1]};
      slots += span.last - span.first;
      if (to != begin && to[-1].last == span.first) {
        to[-1].last = span.last;
      } else {
        *to = span;
        ++to;
      }
    }
  }
  return to;
}

}  // namespace sim2d
