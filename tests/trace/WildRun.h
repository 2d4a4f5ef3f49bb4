#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "sim2d/trace/Frame.h"

/// States that are hard on what packs them: numbers without a pattern, also those that are none,
/// people and robots that come and go, columns that are not there.
namespace wild {

/// The next of a row of numbers (splitmix64: Steele, Lea, Flood, OOPSLA 2014).
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }
  int below(int limit) { return static_cast<int>(next() % static_cast<unsigned>(limit)); }
  /// Any bits now and then, else between -10 and 10.
  double number() {
    switch (below(40)) {
      case 0: {
        const std::uint64_t bits = next();
        double any = 0.0;
        std::memcpy(&any, &bits, sizeof(any));
        return any;
      }
      case 1:
        return -0.0;
      case 2:
        return std::numeric_limits<double>::infinity();
      case 3:
        return std::numeric_limits<double>::quiet_NaN();
      case 4:
        return std::numeric_limits<double>::denorm_min();
      default:
        return static_cast<double>(next() >> 11U) / 9007199254740992.0 * 20.0 - 10.0;
    }
  }

 private:
  std::uint64_t state_;
};

inline void addBody(sim2d::BodyColumns& to, int id, Draws& draws) {
  const double x = draws.number(), y = draws.number(), heading = draws.number();
  const double vx = draws.number(), vy = draws.number(), omega = draws.number();
  to.add(id, {sim2d::Vec2(x, y), heading}, sim2d::Vec2(vx, vy), omega, draws.below(3));
}

/// The same for equal steps; of about nine tenths of `people`.
inline sim2d::Frame frameAt(std::int64_t step, int people) {
  Draws draws(static_cast<std::uint64_t>(step) * 1000003U);
  Draws crowd(static_cast<std::uint64_t>(step) / 5U);  // comes and goes every fifth step
  sim2d::Frame frame;
  frame.step = step;
  frame.time = 0.05 * static_cast<double>(step);
  const bool hasForces = crowd.below(10) != 0;
  for (int id = 1; id <= people; ++id) {
    if (crowd.below(10) == 0) {
      continue;
    }
    addBody(frame.humans, id, draws);
    frame.humans.group.push_back(draws.below(2) - 1);
    frame.humans.state.push_back(static_cast<std::uint8_t>(draws.below(2)));
    for (std::vector<sim2d::Vec2>* force :
         {&frame.forces.goal, &frame.forces.social, &frame.forces.obstacle, &frame.forces.group}) {
      const double x = draws.number(), y = draws.number();
      if (hasForces) {
        force->emplace_back(x, y);
      }
    }
  }
  for (int robot = 1; robot <= crowd.below(3); ++robot) {
    addBody(frame.robots, -robot, draws);
    frame.robotPaths.emplace_back(static_cast<std::size_t>(crowd.below(4)),
                                  sim2d::Vec2(draws.number(), 1.0));
  }
  frame.doorOpen.assign(static_cast<std::size_t>(crowd.below(3)), static_cast<char>(step % 2));
  return frame;
}

template <class T>
bool isSameColumn(const std::vector<T>& a, const std::vector<T>& b) {
  const auto* const bytes = static_cast<const void*>(a.data());
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(bytes, b.data(), a.size() * sizeof(T)) == 0);
}

template <class Columns>
bool areSameColumns(const Columns& a, const Columns& b) {
  bool same = true;
  Columns::eachColumn([&](auto column) { same = same && isSameColumn(a.*column, b.*column); });
  return same;
}

/// Bit by bit, of the state alone.
inline bool isSameState(const sim2d::Frame& a, const sim2d::Frame& b) {
  bool areSamePaths = a.robotPaths.size() == b.robotPaths.size();
  for (std::size_t k = 0; areSamePaths && k < a.robotPaths.size(); ++k) {
    areSamePaths = isSameColumn(a.robotPaths[k], b.robotPaths[k]);
  }
  return areSamePaths && a.step == b.step && a.time == b.time &&
         areSameColumns(a.humans, b.humans) && areSameColumns(a.robots, b.robots) &&
         areSameColumns(a.forces, b.forces) && isSameColumn(a.doorOpen, b.doorOpen);
}

}  // namespace wild
