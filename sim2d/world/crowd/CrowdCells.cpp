#include "sim2d/world/crowd/CrowdCells.h"

#include <algorithm>
#include <cmath>

#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

// Cells are narrow, so that a row of candidates ends where it should, and high, so that there are
// few rows.
constexpr double kCellWidth = 1.0;   // [m]
constexpr double kCellHeight = 5.0;  // [m]

int cellsIn(double length, double cell) {
  return static_cast<int>(length / cell) + 1;
}

int clampedCell(double value, int count) {
  return static_cast<int>(std::max(0.0, std::min(value, static_cast<double>(count - 1))));
}

}  // namespace

void CrowdCells::placeGrid(const std::vector<Walker>& walkers, const std::vector<char>& present) {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  bool isFirst = true;
  double squaredFastest = 0.0;
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    if (present[i] == 0) {
      continue;
    }
    const Walker& walker = walkers[i];
    low = isFirst ? walker.position : Vec2(low.cwiseMin(walker.position));
    high = isFirst ? walker.position : Vec2(high.cwiseMax(walker.position));
    squaredFastest = std::max(squaredFastest, walker.velocity.squaredNorm());
    isFirst = false;
  }
  fastest_ = std::sqrt(squaredFastest);
  const Vec2 size = high - low;
  const double mostCells = 4096.0 + 4.0 * static_cast<double>(walkers.size());
  const Vec2 wanted = Vec2(size.x() / kCellWidth, size.y() / kCellHeight);  // cells
  const double coarser = std::max(
      {1.0, std::sqrt(wanted.x() * wanted.y() / mostCells), wanted.maxCoeff() / mostCells});
  cell_ = coarser * Vec2(kCellWidth, kCellHeight);
  origin_ = low;
  middle_ = (low + high) / 2.0;
  width_ = isFirst ? 0 : cellsIn(size.x(), cell_.x());
  height_ = isFirst ? 0 : cellsIn(size.y(), cell_.y());
}

void CrowdCells::rebuild(const std::vector<Walker>& walkers, const std::vector<char>& present,
                         const std::vector<double>& room) {
  placeGrid(walkers, present);
  const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  refill(start_, cells + 1, 0);
  cellOf_.assign(walkers.size(), -1);
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    if (present[i] != 0) {
      const Vec2 place = (walkers[i].position - origin_).cwiseQuotient(cell_);
      cellOf_[i] = clampedCell(place.y(), height_) * width_ + clampedCell(place.x(), width_);
      ++start_[static_cast<std::size_t>(cellOf_[i]) + 1];
    }
  }
  for (std::size_t cell = 0; cell < cells; ++cell) {
    start_[cell + 1] += start_[cell];
  }
  refill(next_, start_.size(), 0);
  std::copy(start_.begin(), start_.end(), next_.begin());
  order_.resize(static_cast<std::size_t>(start_.back()));
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    if (cellOf_[i] >= 0) {
      order_[static_cast<std::size_t>(next_[static_cast<std::size_t>(cellOf_[i])]++)] = i;
    }
  }
  fillColumns(walkers, room);
}

void CrowdCells::fillColumns(const std::vector<Walker>& walkers, const std::vector<double>& room) {
  for (std::vector<float>* column : {&x_, &y_, &vx_, &vy_, &room_}) {
    column->resize(order_.size() + static_cast<std::size_t>(kCrowdLanes));
  }
  for (std::size_t slot = 0; slot < order_.size(); ++slot) {
    const Walker& walker = walkers[order_[slot]];
    x_[slot] = static_cast<float>(walker.position.x() - middle_.x());
    y_[slot] = static_cast<float>(walker.position.y() - middle_.y());
    vx_[slot] = static_cast<float>(walker.velocity.x());
    vy_[slot] = static_cast<float>(walker.velocity.y());
    room_[slot] = static_cast<float>(room[order_[slot]]);
  }
}

CrowdColumns CrowdCells::columns() const {
  return {x_.data(), y_.data(), vx_.data(), vy_.data(), room_.data()};
}

int CrowdCells::appendSpans(const Vec2& centre, double radius,
                            std::vector<CrowdSpan>& spans) const {
  const Vec2 middle = centre - origin_;
  const Vec2 perCell = cell_.cwiseInverse();
  const std::size_t begin = spans.size();
  int count = 0;
  const int top = clampedCell((middle.y() + radius) * perCell.y(), height_);
  for (int row = clampedCell((middle.y() - radius) * perCell.y(), height_); row <= top; ++row) {
    const double low = row * cell_.y() - middle.y();
    const double gap = std::max(std::max(0.0, low), -low - cell_.y());
    const double half = std::sqrt(std::max(0.0, radius * radius - gap * gap));
    const int first = row * width_ + clampedCell((middle.x() - half) * perCell.x(), width_);
    const int last = row * width_ + clampedCell((middle.x() + half) * perCell.x(), width_);
    const CrowdSpan span{start_[static_cast<std::size_t>(first)],
                         start_[static_cast<std::size_t>(last) + 1]};
    count += span.last - span.first;
    if (spans.size() > begin && spans.back().last == span.first) {
      spans.back().last = span.last;
    } else {
      spans.push_back(span);
    }
  }
  return count;
}

}  // namespace sim2d
