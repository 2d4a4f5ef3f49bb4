#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "sim2d/map/Obstacles.h"

/// What `Obstacles` keeps on each thread of what it has found; private to it.
namespace sim2d {

/// What was asked, bit by bit.
template <std::size_t N>
struct Question {
  std::uint64_t version = 0;  // of nothing that was built
  std::array<std::uint64_t, N> bits{};

  Question() = default;
  Question(std::uint64_t itsVersion, const std::array<double, N>& numbers) : version(itsVersion) {
    std::memcpy(bits.data(), numbers.data(), sizeof(bits));
  }
  bool operator==(const Question& other) const {
    std::uint64_t differs = version ^ other.version;
    for (std::size_t k = 0; k < N; ++k) {
      differs |= bits[k] ^ other.bits[k];
    }
    return differs == 0;
  }
};

/// The last answers to questions of N numbers, few enough to stay near at hand. `Answer` holds its
/// `question`.
template <std::size_t N, class Answer, std::size_t kSlots>
class LastAnswers {
 public:
  Answer& slotOf(const Question<N>& question) {
    std::uint64_t mixed = question.version;
    for (const std::uint64_t word : question.bits) {
      mixed = (mixed ^ word) * 0x9E3779B97F4A7C15U;
      mixed ^= mixed >> 32U;
    }
    return slots_[mixed % kSlots];
  }

 private:
  std::vector<Answer> slots_ = std::vector<Answer>(kSlots);
};

/// Those that are not too long.
struct PointsAnswer {
  Question<3> question;  // position and range
  std::size_t count = 0;
  std::array<Obstacles::Point, 32> points;
};
inline LastAnswers<3, PointsAnswer, 256>& lastPoints() {
  thread_local LastAnswers<3, PointsAnswer, 256> answers;
  return answers;
}

struct SightAnswer {
  Question<4> question;  // both ends
  bool isSeen = false;
};
inline LastAnswers<4, SightAnswer, 512>& lastSights() {
  thread_local LastAnswers<4, SightAnswer, 512> answers;
  return answers;
}

constexpr double kSquare = 0.25;               // [m] side of a square whose edges are kept
constexpr double kHalfDiagonal = 0.176776696;  // [m] of it, rounded up

/// The edges that may have a local minimum for any position in a square, from near to far: who
/// walks asks of the same few again and again.
struct NearEdges {
  static constexpr std::size_t kMost = 160;  // with kSlots 2.8 MB per thread that asks
  static constexpr unsigned kFoot = 1, kCorner = 2;

  std::uint64_t version = 0;  // of nothing
  double range = 0.0;         // [m]
  std::int64_t column = 0, row = 0;
  std::size_t count = 0;                // more than kMost: too many to keep
  std::array<unsigned, kMost> edges{};  // number * 4 + what it may have

  NearEdges() = default;
  NearEdges(std::uint64_t itsVersion, double itsRange, const Vec2& position)
      : version(itsVersion),
        range(itsRange),
        column(static_cast<std::int64_t>(std::floor(position.x() / kSquare))),
        row(static_cast<std::int64_t>(std::floor(position.y() / kSquare))) {}
  bool isOf(const NearEdges& other) const {
    return version == other.version && column == other.column && row == other.row &&
           range == other.range;
  }
  Vec2 middle() const {
    return kSquare * Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  }
  /// Where it is kept, on this thread.
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
