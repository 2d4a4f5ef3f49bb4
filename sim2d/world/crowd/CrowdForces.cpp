#include "sim2d/world/crowd/CrowdForces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <xmmintrin.h>

namespace sim2d {
namespace {

constexpr double kLeftOut = 5e-5;    // of k_s
constexpr double kWantedCell = 4.0;  // [m]
constexpr double kMostCells = 250000.0;

/// Numbers too small for a normal float count as zero, so that they cost no time.
class ZeroForTiny {
 public:
  ZeroForTiny() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040U);  // flush to zero, denormals are zero
  }
  ~ZeroForTiny() { _mm_setcsr(before_); }
  ZeroForTiny(const ZeroForTiny&) = delete;
  ZeroForTiny& operator=(const ZeroForTiny&) = delete;
  ZeroForTiny(ZeroForTiny&&) = delete;
  ZeroForTiny& operator=(ZeroForTiny&&) = delete;

 private:
  unsigned before_;
};

CrowdKernel kernelOf(VectorPath path) {
  switch (path) {
    case VectorPath::Avx512:
      return crowdKernelAvx512();
    case VectorPath::Avx2:
      return crowdKernelAvx2();
    case VectorPath::Sse2:
      break;
  }
  return crowdKernelSse2();
}

int cellsIn(double length, double cell) {
  return static_cast<int>(length / cell) + 1;
}

int clampedCell(double value, int count) {
  return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(count - 1)));
}

/// Distance between a cell and others `cells` away along one axis [m].
double gapOf(int cells, double size) {
  return std::max(0, std::abs(cells) - 1) * size;
}

int filled(int count) {
  return (count + kCrowdLanes - 1) / kCrowdLanes * kCrowdLanes;
}

}  // namespace

const char* vectorPathName(VectorPath path) {
  switch (path) {
    case VectorPath::Avx512:
      return "AVX-512";
    case VectorPath::Avx2:
      return "AVX2";
    case VectorPath::Sse2:
      break;
  }
  return "SSE2";
}

bool hasVectorPath(VectorPath path) {
  switch (path) {
    case VectorPath::Avx512:
      return __builtin_cpu_supports("avx512f") != 0;
    case VectorPath::Avx2:
      return __builtin_cpu_supports("avx2") != 0;
    case VectorPath::Sse2:
      break;
  }
  return true;
}

VectorPath fastestVectorPath() {
  if (hasVectorPath(VectorPath::Avx512)) {
    return VectorPath::Avx512;
  }
  return hasVectorPath(VectorPath::Avx2) ? VectorPath::Avx2 : VectorPath::Sse2;
}

void CrowdForces::Columns::resize(std::size_t count) {
  for (std::vector<float>* column : {&x, &y, &vx, &vy, &room}) {
    column->resize(count);
  }
}

void CrowdForces::Scratch::resize(std::size_t count) {
  const std::size_t padded = count + 2 * static_cast<std::size_t>(kCrowdLanes);
  near.resize(padded);
  for (std::vector<float>* column : {&dx, &dy, &dvx, &dvy, &fx, &fy}) {
    column->resize(padded);
  }
  index.resize(padded);
  doubtful.resize(padded);
}

CrowdColumns CrowdForces::Columns::view() {
  return {x.data(), y.data(), vx.data(), vy.data(), room.data()};
}

CrowdPairs CrowdForces::Scratch::pairs() {
  return {dx.data(),    dy.data(), dvx.data(), dvy.data(),
          index.data(), fx.data(), fy.data(),  doubtful.data()};
}

CrowdForces::CrowdForces(VectorPath path) : kernel_(kernelOf(path)), cutOff_(cutOff(kLeftOut)) {}

void CrowdForces::compute(const CrowdState& crowd, WorkerPool& workers) {
  forces_.assign(crowd.walkers.size(), Vec2::Zero());
  sortIntoCells(crowd);
  if (order_.empty()) {
    return;
  }
  const std::size_t shares = workers.shareCount();
  scratches_.resize(shares);
  const int cells = width_ * height_;
  firstCells_.resize(shares + 1);
  for (std::size_t share = 0; share <= shares; ++share) {
    const auto before = static_cast<int>(order_.size() * share / shares);  // people
    const auto cell = std::lower_bound(start_.begin(), start_.end(), before) - start_.begin();
    firstCells_[share] = std::min(static_cast<int>(cell), cells);
  }
  firstCells_[shares] = cells;
  workers.forShares([&](std::size_t share) {
    const ZeroForTiny mode;
    Scratch& scratch = scratches_[share];
    scratch.resize(order_.size());
    computeCells(crowd, firstCells_[share], firstCells_[share + 1], scratch);
  });
}

void CrowdForces::placeGrid(const CrowdState& crowd) {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  bool isFirst = true;
  double squaredFastest = 0.0;
  for (std::size_t i = 0; i < crowd.walkers.size(); ++i) {
    if (crowd.present[i] == 0) {
      continue;
    }
    const Walker& walker = crowd.walkers[i];
    low = isFirst ? walker.position : Vec2(low.cwiseMin(walker.position));
    high = isFirst ? walker.position : Vec2(high.cwiseMax(walker.position));
    squaredFastest = std::max(squaredFastest, walker.velocity.squaredNorm());
    isFirst = false;
  }
  fastest_ = std::sqrt(squaredFastest);
  const Vec2 size = high - low;
  cell_ = std::max({kWantedCell, std::sqrt(size.x() * size.y() / kMostCells),
                    std::max(size.x(), size.y()) / kMostCells});
  origin_ = low;
  middle_ = (low + high) / 2.0;
  width_ = isFirst ? 0 : cellsIn(size.x(), cell_);
  height_ = isFirst ? 0 : cellsIn(size.y(), cell_);
}

void CrowdForces::sortIntoCells(const CrowdState& crowd) {
  placeGrid(crowd);
  const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  start_.assign(cells + 1, 0);
  cellOf_.assign(crowd.walkers.size(), -1);
  for (std::size_t i = 0; i < crowd.walkers.size(); ++i) {
    if (crowd.present[i] != 0) {
      const Vec2 place = (crowd.walkers[i].position - origin_) / cell_;
      cellOf_[i] = clampedCell(place.y(), height_) * width_ + clampedCell(place.x(), width_);
      ++start_[static_cast<std::size_t>(cellOf_[i]) + 1];
    }
  }
  for (std::size_t cell = 0; cell < cells; ++cell) {
    start_[cell + 1] += start_[cell];
  }
  next_.assign(start_.begin(), start_.end());
  order_.resize(static_cast<std::size_t>(start_.back()));
  for (std::size_t i = 0; i < crowd.walkers.size(); ++i) {
    if (cellOf_[i] >= 0) {
      order_[static_cast<std::size_t>(next_[static_cast<std::size_t>(cellOf_[i])]++)] = i;
    }
  }
  fillColumns(crowd);
}

void CrowdForces::fillColumns(const CrowdState& crowd) {
  sorted_.resize(order_.size() + static_cast<std::size_t>(kCrowdLanes));
  for (std::size_t slot = 0; slot < order_.size(); ++slot) {
    const Walker& walker = crowd.walkers[order_[slot]];
    sorted_.x[slot] = static_cast<float>(walker.position.x() - middle_.x());
    sorted_.y[slot] = static_cast<float>(walker.position.y() - middle_.y());
    sorted_.vx[slot] = static_cast<float>(walker.velocity.x());
    sorted_.vy[slot] = static_cast<float>(walker.velocity.y());
    sorted_.room[slot] = static_cast<float>(crowd.room[order_[slot]]);
  }
}

void CrowdForces::computeCells(const CrowdState& crowd, int first, int last, Scratch& scratch) {
  for (int cell = first; cell < last; ++cell) {
    computeCell(crowd, cell % width_, cell / width_, scratch);
  }
}

/// How far the people of a cell feel anybody; negative: they feel nobody.
double CrowdForces::rangeOf(const CrowdState& crowd, std::size_t cell) const {
  double range = -1.0;
  for (int slot = start_[cell]; slot < start_[cell + 1]; ++slot) {
    const std::size_t person = order_[static_cast<std::size_t>(slot)];
    const ForceParameters* parameters = crowd.laws[person].parameters;
    if (parameters != nullptr) {
      range = std::max(range, socialRange(*parameters, crowd.walkers[person].velocity.norm(),
                                          fastest_, cutOff_));
    }
  }
  return range;
}

void CrowdForces::computeCell(const CrowdState& crowd, int column, int row, Scratch& scratch) {
  const int number = row * width_ + column;
  const auto cell = static_cast<std::size_t>(number);
  const double range = start_[cell] < start_[cell + 1] ? rangeOf(crowd, cell) : -1.0;
  if (range < 0.0) {
    return;
  }
  const int candidates = gatherNear(column, row, range, scratch);
  for (int slot = start_[cell]; slot < start_[cell + 1]; ++slot) {
    if (crowd.laws[order_[static_cast<std::size_t>(slot)]].parameters != nullptr) {
      forceOn(crowd, static_cast<std::size_t>(slot), candidates, scratch);
    }
  }
}

/// Copies everybody within range of a cell, row by row; returns their number.
int CrowdForces::gatherNear(int column, int row, double range, Scratch& scratch) {
  const int reach = static_cast<int>(std::min(range / cell_, kMostCells)) + 1;
  int count = 0;
  scratch.rows.clear();
  for (int y = std::max(0, row - reach); y <= std::min(height_ - 1, row + reach); ++y) {
    const double gap = gapOf(y - row, cell_);
    if (gap > range) {
      continue;
    }
    const double half = std::sqrt(range * range - gap * gap) / cell_;
    const int wide = static_cast<int>(std::min(half, kMostCells)) + 1;
    const int first = y * width_ + std::max(0, column - wide);
    const int last = y * width_ + std::min(width_ - 1, column + wide);
    const int begin = start_[static_cast<std::size_t>(first)];
    const int end = start_[static_cast<std::size_t>(last) + 1];
    if (begin < end) {
      kernel_.append(sorted_.view(), begin, end - begin, scratch.near.view(), count);
      scratch.rows.push_back({begin, count});
      count += end - begin;
    }
  }
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (int i = count; i < filled(count); ++i) {
    scratch.near.x[static_cast<std::size_t>(i)] = none;
  }
  return count;
}

std::size_t CrowdForces::personOf(int candidate, const Scratch& scratch) const {
  const auto after =
      std::upper_bound(scratch.rows.begin(), scratch.rows.end(), candidate,
                       [](int wanted, const Row& row) { return wanted < row.first; });
  const Row& row = *(after - 1);
  return order_[static_cast<std::size_t>(row.slot + candidate - row.first)];
}

void CrowdForces::forceOn(const CrowdState& crowd, std::size_t slot, int candidates,
                          Scratch& scratch) {
  const std::size_t person = order_[slot];
  const SocialLaw& law = crowd.laws[person];
  const ForceParameters& parameters = *law.parameters;
  CrowdReceiver receiver;
  receiver.x = sorted_.x[slot];
  receiver.y = sorted_.y[slot];
  receiver.vx = sorted_.vx[slot];
  receiver.vy = sorted_.vy[slot];
  receiver.room = sorted_.room[slot];
  receiver.lambda = static_cast<float>(parameters.lambda);
  receiver.gamma = static_cast<float>(parameters.gamma);
  receiver.n = static_cast<float>(parameters.n);
  receiver.nPrime = static_cast<float>(parameters.nPrime);
  receiver.epsilon = static_cast<float>(parameters.epsilon);
  receiver.cutOff = static_cast<float>(cutOff_);
  receiver.leastLooked = static_cast<float>(kLeftOut);
  receiver.seesWalls = !law.goesThroughWalls;
  receiver.candidates = filled(candidates);
  const CrowdPairs pairs = scratch.pairs();
  CrowdResult result = kernel_.force(scratch.near.view(), receiver, pairs);
  if (result.doubtful > 0) {
    for (int i = 0; i < result.doubtful; ++i) {
      const int pair = pairs.doubtful[i];
      if (!crowd.isVisible(person, personOf(pairs.index[pair], scratch))) {
        pairs.fx[pair] = pairs.fy[pair] = 0.0F;
      }
    }
    kernel_.sum(pairs, result);
  }
  Vec2& force = forces_[person];
  force =
      parameters.socialFactor * Vec2(static_cast<double>(result.x), static_cast<double>(result.y));
  if (result.touching > 1) {
    force += forceOfTouching(crowd, slot, candidates, scratch);
  }
}

/// Of those in the same place, whom the kernel leaves out.
Vec2 CrowdForces::forceOfTouching(const CrowdState& crowd, std::size_t slot, int candidates,
                                  const Scratch& scratch) const {
  Vec2 force = Vec2::Zero();
  const std::size_t person = order_[slot];
  for (int i = 0; i < candidates; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const float dx = scratch.near.x[at] - sorted_.x[slot];
    const float dy = scratch.near.y[at] - sorted_.y[slot];
    const std::size_t other = personOf(i, scratch);
    if (other == person || !(dx * dx + dy * dy <= kCrowdTouching * kCrowdTouching)) {
      continue;
    }
    const SocialLaw& law = crowd.laws[person];
    if (law.goesThroughWalls || crowd.isVisible(person, other)) {
      force += socialForce(*law.parameters, crowd.walkers[person], crowd.walkers[other]);
    }
  }
  return force;
}

}  // namespace sim2d
