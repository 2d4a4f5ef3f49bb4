#include "app/run/SensitivityDesign.h"

#include <boost/random/sobol.hpp>
#include <numeric>
#include <utility>

#include "sim2d/base/Rng.h"

namespace app {

namespace {

using Points = std::vector<std::vector<double>>;

/// Fisher-Yates; the draws are those of a trajectory.
std::vector<std::size_t> shuffledDimensions(std::uint64_t seed, std::size_t trajectory,
                                            std::size_t dimensions) {
  std::vector<std::size_t> order(dimensions);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const base::AgentRng rng(seed, 0, trajectory);
  for (std::size_t left = order.size(); left > 1; --left) {
    const double draw =
        rng.uniform01(base::DrawPurpose::DesignOrder, static_cast<std::uint32_t>(left));
    std::swap(order[left - 1], order[static_cast<std::size_t>(draw * static_cast<double>(left))]);
  }
  return order;
}

std::uint32_t reversedBits(std::uint32_t bits) {
  std::uint32_t reversed = 0;
  for (int k = 0; k < 32; ++k) {
    reversed = (reversed << 1U) | (bits & 1U);
    bits >>= 1U;
  }
  return reversed;
}

/// Permutes each bit depending on the bits above it only, by the hash of Laine & Karras (2011) with
/// the constants of Burley (2020, listing 3).
std::uint32_t owenScrambled(std::uint32_t bits, std::uint32_t seed) {
  std::uint32_t hash = reversedBits(bits) + seed;
  hash ^= hash * 0x6c50b47cU;
  hash ^= hash * 0xb82f1e52U;
  hash ^= hash * 0xc7afe638U;
  hash ^= hash * 0x8d22f6e6U;
  return reversedBits(hash);
}

/// Points of the scrambled sequence, the origin of the unscrambled one included.
class ScrambledSobol {
 public:
  ScrambledSobol(std::uint64_t seed, std::size_t dimensions) : sequence_(dimensions) {
    for (std::size_t k = 0; k < dimensions; ++k) {
      seeds_.push_back(
          base::AgentRng(seed, static_cast<int>(k)).bits(base::DrawPurpose::DesignOrder));
    }
  }
  std::vector<double> next() {
    std::vector<double> point;
    for (const std::uint32_t seed : seeds_) {
      const std::uint32_t bits =
          isFirst_ ? 0U : static_cast<std::uint32_t>(std::uint64_t{sequence_()} >> 32U);
      point.push_back(static_cast<double>(owenScrambled(bits, seed)) * 0x1p-32);
    }
    isFirst_ = false;
    return point;
  }

 private:
  boost::random::sobol sequence_;
  std::vector<std::uint32_t> seeds_;  // per dimension
  bool isFirst_ = true;
};

}  // namespace

Points morrisPoints(const Design& design, std::size_t dimensions) {
  constexpr double kStep = 2.0 / 3.0;
  Points points;
  points.reserve(design.points * (dimensions + 1));
  for (std::size_t trajectory = 0; trajectory < design.points; ++trajectory) {
    std::vector<double> point, other;  // the first and the last point
    for (std::size_t k = 0; k < dimensions; ++k) {
      const std::uint32_t bits = base::AgentRng(design.seed, static_cast<int>(k), trajectory)
                                     .bits(base::DrawPurpose::Design);
      const double low = (bits & 1U) != 0 ? 1.0 / 3.0 : 0.0;
      const double high = low == 0.0 ? kStep : 1.0;
      const bool goesUp = (bits & 2U) != 0;
      point.push_back(goesUp ? low : high);
      other.push_back(goesUp ? high : low);
    }
    points.push_back(point);
    for (const std::size_t k : shuffledDimensions(design.seed, trajectory, dimensions)) {
      point[k] = other[k];
      points.push_back(point);
    }
  }
  return points;
}

Points saltelliPoints(const Design& design, std::size_t dimensions) {
  Points points;
  points.reserve(design.points * (dimensions + 2));
  ScrambledSobol sequence(design.seed, 2 * dimensions);
  for (std::size_t base = 0; base < design.points; ++base) {
    const std::vector<double> both = sequence.next();
    const auto middle = both.begin() + static_cast<std::ptrdiff_t>(dimensions);
    const std::vector<double> a(both.begin(), middle), b(middle, both.end());
    points.push_back(a);
    points.push_back(b);
    for (std::size_t k = 0; k < dimensions; ++k) {
      points.push_back(a);
      points.back()[k] = b[k];
    }
  }
  return points;
}

}  // namespace app
