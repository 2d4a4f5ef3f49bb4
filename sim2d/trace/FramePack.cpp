#include "sim2d/trace/FramePack.h"

#include <cstring>
#include <type_traits>

namespace sim2d {

namespace {

constexpr char kEqual = 0, kOther = 1;

/// Calls take(column, the key's) for all of a fixed number.
template <class AnyFrame, class Take>
void forEachColumn(AnyFrame& frame, const Frame& key, Take take) {
  const auto body = [&take](auto& columns, const auto& keys) {
    take(columns.id, keys.id);
    take(columns.x, keys.x);
    take(columns.y, keys.y);
    take(columns.heading, keys.heading);
    take(columns.vx, keys.vx);
    take(columns.vy, keys.vy);
    take(columns.omega, keys.omega);
    take(columns.goal, keys.goal);
  };
  body(frame.humans, key.humans);
  body(frame.robots, key.robots);
  take(frame.humans.group, key.humans.group);
  take(frame.humans.state, key.humans.state);
  take(frame.forces.goal, key.forces.goal);
  take(frame.forces.social, key.forces.social);
  take(frame.forces.obstacle, key.forces.obstacle);
  take(frame.forces.group, key.forces.group);
  take(frame.doorOpen, key.doorOpen);
}

const std::vector<Vec2>& pathOf(const Frame& frame, std::size_t robot) {
  static const std::vector<Vec2> kNone;
  return robot < frame.robotPaths.size() ? frame.robotPaths[robot] : kNone;
}

class Packer {
 public:
  template <class T>
  void value(const T& value) {
    bytes(&value, sizeof(T));
  }
  template <class T>
  void column(const std::vector<T>& column, const std::vector<T>& key) {
    const std::size_t size = column.size() * sizeof(T);
    if (column.size() == key.size() &&
        (size == 0 ||
         std::memcmp(static_cast<const void*>(column.data()), key.data(), size) == 0)) {
      value(kEqual);
      return;
    }
    value(kOther);
    value(column.size());
    bytes(column.data(), size);
  }
  std::string take() { return std::move(bytes_); }

 private:
  void bytes(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void value(T& value) {
    bytes(&value, sizeof(T));
  }
  template <class T>
  void column(std::vector<T>& column, const std::vector<T>& key) {
    char kind = kEqual;
    value(kind);
    if (kind == kEqual) {
      column = key;
      return;
    }
    std::size_t size = 0;
    value(size);
    column.resize(size);
    bytes(column.data(), size * sizeof(T));
  }

 private:
  void bytes(void* to, std::size_t size) {
    if (size > 0) {
      std::memcpy(to, bytes_.data(), size);
      bytes_.remove_prefix(size);
    }
  }
  std::string_view bytes_;
};

}  // namespace

std::string packFrame(const Frame& frame, const Frame& key) {
  Packer packer;
  packer.value(frame.step);
  packer.value(frame.time);
  forEachColumn(frame, key,
                [&](const auto& column, const auto& its) { packer.column(column, its); });
  packer.value(frame.robotPaths.size());
  for (std::size_t k = 0; k < frame.robotPaths.size(); ++k) {
    packer.column(frame.robotPaths[k], pathOf(key, k));
  }
  return packer.take();
}

Frame unpackFrame(std::string_view bytes, const Frame& key) {
  Frame frame;
  Unpacker unpacker(bytes);
  unpacker.value(frame.step);
  unpacker.value(frame.time);
  forEachColumn(frame, key, [&](auto& column, const auto& its) { unpacker.column(column, its); });
  std::size_t paths = 0;
  unpacker.value(paths);
  frame.robotPaths.resize(paths);
  for (std::size_t k = 0; k < paths; ++k) {
    unpacker.column(frame.robotPaths[k], pathOf(key, k));
  }
  return frame;
}

}  // namespace sim2d
