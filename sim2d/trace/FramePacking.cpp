#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <type_traits>
#include <utility>

#include "sim2d/trace/FrameHistory.h"

namespace sim2d {
namespace {

constexpr char kEqual = 0, kSome = 1, kAll = 2;  // column encodings, relative to the prediction
constexpr unsigned kNibble = 4, kNibbleMask = 15;
constexpr std::size_t kBytes = sizeof(double);
using Numbers = std::vector<double>;

std::uint64_t bitsOf(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  return bits;
}

double numberOf(std::uint64_t bits) {
  double number = 0.0;
  std::memcpy(&number, &bits, sizeof(number));
  return number;
}

double* numbersOf(Numbers& column) {
  return column.data();
}
double* numbersOf(std::vector<Vec2>& column) {
  return column.empty() ? nullptr : column.front().data();
}
const double* numbersOf(const Numbers& column) {
  return column.data();
}
const double* numbersOf(const std::vector<Vec2>& column) {
  return column.empty() ? nullptr : column.front().data();
}
std::size_t countOf(const Numbers& column) {
  return column.size();
}
std::size_t countOf(const std::vector<Vec2>& column) {
  return 2 * column.size();
}

class Packer {
 public:
  template <class T>
  void value(const T& value) {
    append(&value, sizeof(T));
  }
  template <class T>
  void column(const std::vector<T>& column, const std::vector<T>& expected) {
    std::vector<std::uint32_t> others;
    if (column.size() == expected.size()) {
      for (std::size_t k = 0; k < column.size(); ++k) {
        if (column[k] != expected[k]) {
          others.push_back(static_cast<std::uint32_t>(k));
        }
      }
    }
    const std::size_t size = others.size() * (sizeof(T) + sizeof(std::uint32_t));
    if (column.size() != expected.size() || size > column.size() * sizeof(T)) {
      all(column);
    } else if (others.empty()) {
      value(kEqual);
    } else {
      value(kSome);
      value(others.size());
      for (const std::uint32_t k : others) {
        value(k);
        value(column[k]);
      }
    }
  }
  template <class Column>
  void numbers(const Column& column, const Numbers& expected) {
    if (countOf(column) != expected.size()) {
      all(column);
      return;
    }
    value(kSome);
    const double* const found = numbersOf(column);
    const std::size_t count = expected.size();
    std::size_t at = bytes_.size();
    bytes_.resize(at + (count + 1) / 2 + kBytes * count);
    char* const lengths = bytes_.data() + at;
    at += (count + 1) / 2;
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint64_t other = bitsOf(found[k]) ^ bitsOf(expected[k]);
      unsigned length = 0;
      while (length < kBytes && other >> (8 * length) != 0) {
        ++length;
      }
      std::memcpy(bytes_.data() + at, &other, length);  // low bytes (little-endian)
      at += length;
      lengths[k / 2] =
          static_cast<char>(lengths[k / 2] | static_cast<int>(length << kNibble * (k % 2)));
    }
    bytes_.resize(at);
  }
  template <class Path>
  std::size_t sizeOf(const std::vector<Path>& paths) {
    value(paths.size());
    return paths.size();
  }
  std::string take() { return std::move(bytes_); }

 private:
  template <class Column>
  void all(const Column& column) {
    value(kAll);
    value(column.size());
    append(column.data(), column.size() * sizeof(column[0]));
  }
  void append(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void value(T& value) {
    take(&value, sizeof(T));
  }
  template <class T>
  void column(std::vector<T>& column, const std::vector<T>& expected) {
    char kind = kEqual;
    value(kind);
    if (kind == kAll) {
      all(column);
      return;
    }
    column = expected;
    std::size_t others = 0;
    if (kind == kSome) {
      value(others);
    }
    for (; others > 0 && !bytes_.empty(); --others) {
      std::uint32_t k = 0;
      value(k);
      if (k < column.size()) {
        value(column[k]);
      }
    }
  }
  template <class Column>
  void numbers(Column& column, const Numbers& expected) {
    char kind = kEqual;
    value(kind);
    if (kind == kAll) {
      all(column);
      return;
    }
    const std::size_t count = expected.size();
    column.resize(count * sizeof(double) / sizeof(column[0]));
    const std::string_view lengths = bytes_.substr(0, (count + 1) / 2);
    bytes_.remove_prefix(lengths.size());
    double* const to = numbersOf(column);
    for (std::size_t k = 0; k < count && k / 2 < lengths.size(); ++k) {
      const auto both = static_cast<unsigned char>(lengths[k / 2]);
      std::uint64_t other = 0;
      take(&other, std::min<std::size_t>((both >> kNibble * (k % 2)) & kNibbleMask, kBytes));
      to[k] = numberOf(other ^ bitsOf(expected[k]));
    }
  }
  template <class Path>
  std::size_t sizeOf(std::vector<Path>& paths) {
    std::size_t size = 0;
    value(size);
    paths.resize(std::min(size, bytes_.size()));
    return paths.size();
  }

 private:
  template <class Column>
  void all(Column& column) {
    std::size_t size = 0;
    value(size);
    column.resize(std::min(size, bytes_.size() / sizeof(column[0])));
    take(column.data(), column.size() * sizeof(column[0]));
  }
  void take(void* to, std::size_t size) {
    if (size > 0 && size <= bytes_.size()) {
      std::memcpy(to, bytes_.data(), size);
      bytes_.remove_prefix(size);
    }
  }
  std::string_view bytes_;
};

/// Prediction from the previous state. Not inlined: packing and unpacking must produce identical
/// bits, also for NaN, whose payload depends on the operand order chosen by the compiler.
namespace expected {

[[gnu::noinline]] Numbers numbers(const std::vector<Vec2>& before) {
  const double* const from = numbersOf(before);
  return Numbers(from, from + countOf(before));
}

[[gnu::noinline]] Numbers placesAfter(const Numbers& before, const Numbers& velocity,
                                      double interval) {
  Numbers places(before);
  for (std::size_t k = 0; k < places.size() && k < velocity.size(); ++k) {
    places[k] += velocity[k] * interval;
  }
  return places;
}

/// Component 0 or 1 of the velocities that result from the forces.
[[gnu::noinline]] Numbers velocitiesAfter(const Numbers& before, const ForceColumns& forces,
                                          int component, double interval) {
  Numbers velocities(before);
  const std::size_t count = velocities.size();
  if (forces.goal.size() != count || forces.social.size() != count ||
      forces.obstacle.size() != count || forces.group.size() != count) {
    return velocities;
  }
  for (std::size_t k = 0; k < count; ++k) {
    velocities[k] += (forces.goal[k][component] + forces.social[k][component] +
                      forces.obstacle[k][component] + forces.group[k][component]) *
                     interval;
  }
  return velocities;
}

/// People face their direction of motion; standing people keep their heading.
[[gnu::noinline]] Numbers headingsOf(const Numbers& before, const Numbers& vx, const Numbers& vy) {
  Numbers headings(before);
  for (std::size_t k = 0; k < headings.size() && k < vx.size() && k < vy.size(); ++k) {
    const Vec2 velocity(vx[k], vy[k]);
    headings[k] = velocity.isZero(0.0) ? before[k] : base::headingOf(velocity);
  }
  return headings;
}

[[gnu::noinline]] Numbers headingsAfter(const Numbers& before, const Numbers& omega,
                                        double interval) {
  Numbers headings(before);
  for (std::size_t k = 0; k < headings.size() && k < omega.size(); ++k) {
    headings[k] = base::wrapToPi(before[k] + omega[k] * interval);
  }
  return headings;
}

[[gnu::noinline]] Numbers omegasOf(const Numbers& before, const Numbers& now, double interval) {
  Numbers omegas(before);
  for (std::size_t k = 0; k < omegas.size() && k < now.size(); ++k) {
    omegas[k] = base::angleDiff(now[k], before[k]) / interval;
  }
  return omegas;
}

}  // namespace expected

/// Selects rows of a column by index; negative indices give `zero`.
template <class T>
std::vector<T> rowsOf(const std::vector<T>& column, const std::vector<int>& rows, T zero) {
  std::vector<T> taken;
  taken.reserve(rows.size());
  for (const int row : rows) {
    const auto at = static_cast<std::size_t>(row);
    taken.push_back(row >= 0 && at < column.size() ? column[at] : zero);
  }
  return taken;
}

template <class Columns>
void takeRows(Columns& columns, const std::vector<int>& rows) {
  forEachColumn(columns, [&rows](auto& column) {
    using T = typename std::decay_t<decltype(column)>::value_type;
    if constexpr (std::is_same_v<T, Vec2>) {
      column = rowsOf<Vec2>(column, rows, Vec2::Zero());
    } else {
      column = rowsOf<T>(column, rows, T{});
    }
  });
}

/// The index of each of `ids` in `before`; -1: missing.
std::vector<int> rowsOfBodies(const std::vector<int>& ids, const std::vector<int>& before) {
  std::map<int, int> places;
  for (std::size_t k = 0; k < before.size(); ++k) {
    places.emplace(before[k], static_cast<int>(k));
  }
  std::vector<int> rows;
  rows.reserve(ids.size());
  for (const int id : ids) {
    const auto found = places.find(id);
    rows.push_back(found == places.end() ? -1 : found->second);
  }
  return rows;
}

/// Encodes or decodes one state. `before`: the previous state, empty for the first.
template <class AnyPacker, class AnyFrame>
class FrameCodec {
 public:
  FrameCodec(AnyPacker& packer, AnyFrame& frame, const Frame& before, double interval)
      : packer_(packer), frame_(frame), before_(before), interval_(interval) {}

  void pass() {
    packer_.value(frame_.step);
    packer_.value(frame_.time);
    packer_.column(frame_.doorOpen, before_.doorOpen);
    passPeople();
    passRobots();
    passPaths();
  }

 private:
  void passPeople() {
    packer_.column(frame_.humans.id, before_.humans.id);
    if (frame_.humans.id == before_.humans.id) {
      passPeople(before_.humans, before_.forces);
      return;
    }
    const std::vector<int> rows = rowsOfBodies(frame_.humans.id, before_.humans.id);
    HumanColumns humans = before_.humans;
    ForceColumns forces = before_.forces;
    takeRows(humans, rows);
    takeRows(forces, rows);
    passPeople(humans, forces);
  }

  void passPeople(const HumanColumns& before, const ForceColumns& forces) {
    auto& people = frame_.humans;
    packer_.numbers(frame_.forces.goal, expected::numbers(forces.goal));
    packer_.numbers(frame_.forces.social, expected::numbers(forces.social));
    packer_.numbers(frame_.forces.obstacle, expected::numbers(forces.obstacle));
    packer_.numbers(frame_.forces.group, expected::numbers(forces.group));
    const ForceColumns& now = frame_.forces;
    packer_.numbers(people.vx, expected::velocitiesAfter(before.vx, now, 0, interval_));
    packer_.numbers(people.vy, expected::velocitiesAfter(before.vy, now, 1, interval_));
    packer_.numbers(people.heading, expected::headingsOf(before.heading, people.vx, people.vy));
    packer_.numbers(people.omega, expected::omegasOf(before.heading, people.heading, interval_));
    packer_.numbers(people.x, expected::placesAfter(before.x, people.vx, interval_));
    packer_.numbers(people.y, expected::placesAfter(before.y, people.vy, interval_));
    packer_.column(people.goal, before.goal);
    packer_.column(people.group, before.group);
    packer_.column(people.state, before.state);
  }

  void passRobots() {
    auto& robots = frame_.robots;
    packer_.column(robots.id, before_.robots.id);
    RobotColumns before = before_.robots;
    if (robots.id != before.id) {
      takeRows(before, rowsOfBodies(robots.id, before_.robots.id));
    }
    packer_.numbers(robots.vx, before.vx);
    packer_.numbers(robots.vy, before.vy);
    packer_.numbers(robots.omega, before.omega);
    packer_.numbers(robots.heading,
                    expected::headingsAfter(before.heading, robots.omega, interval_));
    packer_.numbers(robots.x, expected::placesAfter(before.x, robots.vx, interval_));
    packer_.numbers(robots.y, expected::placesAfter(before.y, robots.vy, interval_));
    packer_.column(robots.goal, before.goal);
  }

  void passPaths() {
    static const std::vector<Vec2> kNone;
    const std::size_t count = packer_.sizeOf(frame_.robotPaths);
    for (std::size_t k = 0; k < count; ++k) {
      const bool wasThere = k < before_.robotPaths.size();
      packer_.numbers(frame_.robotPaths[k],
                      expected::numbers(wasThere ? before_.robotPaths[k] : kNone));
    }
  }

  AnyPacker& packer_;
  AnyFrame& frame_;
  const Frame& before_;
  const double interval_;
};

}  // namespace

std::string packFrames(const std::vector<FramePtr>& frames, double interval) {
  Packer packer;
  packer.value(interval);
  packer.value(frames.size());
  const Frame emptyFrame;
  const Frame* before = &emptyFrame;
  for (const FramePtr& frame : frames) {
    FrameCodec<Packer, const Frame>(packer, *frame, *before, interval).pass();
    before = frame.get();
  }
  return packer.take();
}

std::vector<FramePtr> unpackFrames(std::string_view bytes) {
  Unpacker unpacker(bytes);
  double interval = 0.0;
  std::size_t count = 0;
  unpacker.value(interval);
  unpacker.value(count);
  std::vector<FramePtr> frames;
  frames.reserve(std::min(count, bytes.size()));
  const Frame emptyFrame;
  const Frame* before = &emptyFrame;
  while (frames.size() < std::min(count, bytes.size())) {
    auto frame = std::make_shared<Frame>();
    FrameCodec<Unpacker, Frame>(unpacker, *frame, *before, interval).pass();
    frames.push_back(std::move(frame));
    before = frames.back().get();
  }
  return frames;
}

std::size_t unpackedSize(const Frame& frame) {
  std::size_t size = sizeof(Frame);
  const auto add = [&size](const auto& column) { size += column.capacity() * sizeof(column[0]); };
  forEachColumn(frame.humans, add);
  forEachColumn(frame.robots, add);
  forEachColumn(frame.forces, add);
  add(frame.doorOpen);
  add(frame.robotPaths);
  for (const std::vector<Vec2>& path : frame.robotPaths) {
    add(path);
  }
  return size;
}

}  // namespace sim2d
