#include "sim2d/base/Rng.h"

#include <cmath>

#include <Random123/philox.h>

#include "sim2d/base/Math.h"
#include "sim2d/base/Types.h"

#undef philox4x32  // a macro of Random123 that would replace our function

namespace base {
namespace {

constexpr double kTwoToMinus53 = 0x1p-53;

/// The upper 53 bits of two words, as an integer.
double wholeNumber(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t both = (static_cast<std::uint64_t>(high) << 32U) | low;
  return static_cast<double>(both >> 11U);
}

}  // namespace

std::array<std::uint32_t, 4> philox4x32(const std::array<std::uint32_t, 4>& counter,
                                        const std::array<std::uint32_t, 2>& key) {
  const r123::Philox4x32::ctr_type in = {{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x32::key_type with = {{key[0], key[1]}};
  const r123::Philox4x32::ctr_type out = r123::Philox4x32()(in, with);  // ten rounds
  return {out[0], out[1], out[2], out[3]};
}

// Counter: index, agent, lower 32 bits of the step, purpose (8 bits) and the next 24 bits of the
// step.
std::array<std::uint32_t, 4> AgentRng::block(DrawPurpose purpose, std::uint32_t index) const {
  const std::uint32_t upperStep = static_cast<std::uint32_t>(step_ >> 32U) & 0xFFFFFFU;
  const std::uint32_t tag = (static_cast<std::uint32_t>(purpose) << 24U) | upperStep;
  return philox4x32(
      {index, static_cast<std::uint32_t>(agentId_), static_cast<std::uint32_t>(step_), tag},
      {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32U)});
}

std::uint32_t AgentRng::bits(DrawPurpose purpose, std::uint32_t index) const {
  return block(purpose, index)[0];
}

double AgentRng::uniform01(DrawPurpose purpose, std::uint32_t index) const {
  const std::array<std::uint32_t, 4> words = block(purpose, index);
  return wholeNumber(words[0], words[1]) * kTwoToMinus53;
}

double AgentRng::uniform(double low, double high, DrawPurpose purpose, std::uint32_t index) const {
  const double value = low + (high - low) * uniform01(purpose, index);
  // Rounding may yield the upper end, which is excluded.
  return value < high || !(low < high) ? value : std::nextafter(high, low);
}

/// Box and Muller 1958: polar coordinates of a point whose Cartesian coordinates are independent
/// and normal.
AgentRng::Polar AgentRng::normalInPlane(DrawPurpose purpose, std::uint32_t index) const {
  const std::array<std::uint32_t, 4> words = block(purpose, index);
  const double radial = (wholeNumber(words[0], words[1]) + 1.0) * kTwoToMinus53;  // (0, 1]
  const double turn = wholeNumber(words[2], words[3]) * kTwoToMinus53;
  return {std::sqrt(-2.0 * log(radial)), 2.0 * kPi * turn};
}

double AgentRng::normal(double mean, double deviation, DrawPurpose purpose,
                        std::uint32_t index) const {
  const Polar point = normalInPlane(purpose, index);
  return mean + deviation * point.radius * cos(point.angle);
}

std::array<double, 2> AgentRng::normalPair(DrawPurpose purpose, std::uint32_t index) const {
  const Polar point = normalInPlane(purpose, index);
  const SinCos direction = sinCos(point.angle);
  return {point.radius * direction.cos, point.radius * direction.sin};
}

}  // namespace base
