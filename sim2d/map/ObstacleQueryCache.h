#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "sim2d/map/Obstacles.h"

/// Per-thread caches of the query results of `Obstacles`. Private to it.
namespace sim2d {

/// Cache key: the arguments of a query, compared bit by bit.
template <std::size_t N>
struct QueryKey {
  std::uint64_t version = 0;  // 0: unused
  std::array<std::uint64_t, N> bits{};

  QueryKey() = default;
  QueryKey(std::uint64_t itsVersion, const std::array<double, N>& numbers) : version(itsVersion) {
    std::memcpy(bits.data(), numbers.data(), sizeof(bits));
  }
  bool operator==(const QueryKey& other) const {
    std::uint64_t differs = version ^ other.version;
    for (std::size_t k = 0; k < N; ++k) {
      differs |= bits[k] ^ other.bits[k];
    }
    return differs == 0;
  }
};

/// Direct-mapped cache of queries with N arguments. `CachedResult` has a member `queryKey`.
template <std::size_t N, class CachedResult, std::size_t kSlots>
class QueryCache {
 public:
  CachedResult& slotOf(const QueryKey<N>& queryKey) {
    std::uint64_t mixed = queryKey.version;
    for (const std::uint64_t word : queryKey.bits) {
      mixed = (mixed ^ word) * 0x9E3779B97F4A7C15U;
      mixed ^= mixed >> 32U;
    }
    return slots_[mixed % kSlots];
  }

 private:
  std::vector<CachedResult> slots_ = std::vector<CachedResult>(kSlots);
};

/// Results with at most 32 points.
struct CachedPoints {
  QueryKey<3> queryKey;  // position and range
  std::size_t count = 0;
  std::array<Obstacles::Point, 32> points;
};
inline QueryCache<3, CachedPoints, 256>& pointsCache() {
  thread_local QueryCache<3, CachedPoints, 256> answers;
  return answers;
}

struct CachedVisibility {
  QueryKey<4> queryKey;  // both ends
  bool isSeen = false;
};
inline QueryCache<4, CachedVisibility, 512>& visibilityCache() {
  thread_local QueryCache<4, CachedVisibility, 512> answers;
  return answers;
}

constexpr double kCacheSquare = 0.25;          // [m], side of the squares whose edges are cached
constexpr double kHalfDiagonal = 0.176776696;  // [m], of such a square, rounded up

/// The edges that may have a local minimum of distance for any position in a square, nearest first.
/// A walking person queries the same few edges repeatedly.
struct NearEdges {
  static constexpr std::size_t kMost = 160;  // with kSlots: 2.8 MB per thread
  static constexpr unsigned kFoot = 1, kCorner = 2;

  std::uint64_t version = 0;  // 0: unused
  double range = 0.0;         // [m]
  std::int64_t column = 0, row = 0;
  std::size_t count = 0;                // above kMost: not stored
  std::array<unsigned, kMost> edges{};  // 4 * edge number + kFoot, kCorner

  NearEdges() = default;
  NearEdges(std::uint64_t itsVersion, double itsRange, const Vec2& position)
      : version(itsVersion),
        range(itsRange),
        column(static_cast<std::int64_t>(std::floor(position.x() / kCacheSquare))),
        row(static_cast<std::int64_t>(std::floor(position.y() / kCacheSquare))) {}
  bool isOf(const NearEdges& other) const {
    return version == other.version && column == other.column && row == other.row &&
           range == other.range;
  }
  Vec2 middle() const {
    return kCacheSquare * Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  }
  /// The cache slot of this thread.
  NearEdges& slot() const {
    constexpr std::size_t kSlots = 4096;
    thread_local std::vector<NearEdges> slots(kSlots);
    std::uint64_t mixed = version;
    for (const std::int64_t word : {column, row, std::int64_t{std::llround(range * 1024.0)}}) {
      mixed = (mixed ^ static_cast<std::uint64_t>(word)) * 0x9E3779B97F4A7C15U;
      mixed ^= mixed >> 29U;
    }
    return slots[mixed % kSlots];
  }
};

}  // namespace sim2d
