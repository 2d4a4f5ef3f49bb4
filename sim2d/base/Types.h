#pragma once

#include <cmath>

#include <Eigen/Core>

/// Types of all layers. SI units, radians. World frame: x right, y up, headings counter-clockwise
/// from +x in (-pi, pi].
namespace base {

using Vec2 = Eigen::Vector2d;  // [m] or [m/s]; initialise with Vec2::Zero(), Vec2{} is not set

constexpr double kPi = 3.14159265358979323846;
constexpr double kMaxCoordinate = 1e6;  // [m], largest absolute coordinate

/// Whether a position is finite and within kMaxCoordinate.
inline bool isWithinCoordinateRange(const Vec2& place) {
  return std::abs(place.x()) <= kMaxCoordinate && std::abs(place.y()) <= kMaxCoordinate;
}

/// The equivalent angle in (-pi, pi]. NaN if `angle` is not finite.
double wrapToPi(double angle);

/// Signed angle from `from` to `to`, in (-pi, pi].
double angleDiff(double to, double from);

/// Unit vector of a heading, and the heading of a vector (0 for the zero vector).
Vec2 directionOf(double heading);
double headingOf(const Vec2& direction);

/// z component of the cross product: positive when `b` lies to the left of `a`.
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

struct Pose2 {
  Vec2 position = Vec2::Zero();  // [m]
  double heading = 0.0;          // [rad]

  Vec2 direction() const { return directionOf(heading); }
  Vec2 ahead(double distance) const { return position + distance * direction(); }
  Vec2 toWorld(const Vec2& pointInPose) const;
  Vec2 toLocal(const Vec2& pointInWorld) const;

  friend bool operator==(const Pose2& a, const Pose2& b) {
    return a.position.x() == b.position.x() && a.position.y() == b.position.y() &&
           a.heading == b.heading;
  }
  friend bool operator!=(const Pose2& a, const Pose2& b) { return !(a == b); }
};

/// Identifies the object of a message, command or selection. `key` is unique within a loaded
/// scenario and is not saved; 0 is "none".
enum class EntityKind { None, Scenario, Human, Robot, Goal, Obstacle, Door, Area, Dock };
struct EntityId {
  EntityKind kind = EntityKind::None;
  int key = 0;

  explicit operator bool() const { return kind != EntityKind::None; }
  friend bool operator==(EntityId a, EntityId b) { return a.kind == b.kind && a.key == b.key; }
  friend bool operator!=(EntityId a, EntityId b) { return !(a == b); }
  friend bool operator<(EntityId a, EntityId b) {
    return a.kind != b.kind ? a.kind < b.kind : a.key < b.key;
  }
};

/// Result of ticking a behaviour-tree node. Skipped is returned, never stored.
enum class NodeStatus : unsigned char { Idle, Running, Success, Failure, Skipped };
const char* nodeStatusName(NodeStatus status);  // "IDLE", "RUNNING" …

}  // namespace base
