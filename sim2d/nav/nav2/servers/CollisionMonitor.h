#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {

/// A polygon of a velocity polygon and the range of commands for which it applies.
struct VelocitySubPolygon {
  std::string name;                                                        // not a key
  std::string points;                                                      // "[[x, y], …]" [m]
  double linearMin = 0.0, linearMax = 0.0;                                 // [m/s]
  double thetaMin = 0.0, thetaMax = 0.0;                                   // [rad/s]
  double directionStartAngle = -base::kPi, directionEndAngle = base::kPi;  // [rad], if holonomic
};

/// An entry of `polygons` of collision_monitor.
struct MonitorPolygon {
  std::string name;               // not a key
  std::string type;               // polygon, circle, velocity_polygon
  std::string points;             // "[[x, y], …]" [m]; empty: the robot's footprint
  std::vector<double> pointList;  // Humble's format: x1, y1, x2 …
  double radius = 0.0;            // [m]
  std::string actionType;         // stop, slowdown, limit, approach
  int minPoints = 4;              // minimum number of points for an action
  int maxPoints = 3;              // Humble: acts above this number
  double slowdownRatio = 0.5;
  double linearLimit = 0.5, angularLimit = 0.5;  // [m/s], [rad/s]
  double timeBeforeCollision = 2.0;              // [s]
  double simulationTimeStep = 0.1;               // [s]
  std::string footprintTopic;
  bool enabled = true, holonomic = false;
  std::vector<std::string> velocityPolygons;    // names
  std::vector<VelocitySubPolygon> subPolygons;  // not a key: their blocks
};

/// An entry of `observation_sources`: the robot's lidar.
struct MonitorSource {
  std::string name;  // not a key
  std::string type = "scan";
  bool enabled = true;
  double sourceTimeout = 2.0;  // [s]; default: that of the node
};

/// Frame of an exclusion zone.
enum class ZoneFrame : std::uint8_t { Robot, Odom, Map };

/// An entry of `exclusion_zones`: points inside are not used.
struct ExclusionZone {
  std::string name;  // not a key
  bool enabled = false;
  std::string type = "polygon";  // or circle, around the origin of the frame
  std::string points;            // "[[x, y], …]" [m]
  double radius = -1.0;          // [m]
  double minHeight = -kNoHeight, maxHeight = kNoHeight;  // [m]
  std::string frameId;                                   // empty: base_frame_id
  ZoneFrame frame = ZoneFrame::Robot;                    // not a key: kind of `frameId`

  static constexpr double kNoHeight = 1e9;  // in Nav2 the largest number
};

struct CollisionMonitorParameters {
  bool enabled = true;
  double sourceTimeout = 2.0;  // [s]
  std::vector<std::string> polygons, observationSources, exclusionZones;
  std::vector<MonitorPolygon> shapes;  // not a key: blocks of `polygons`, in that order
  std::vector<MonitorSource> sources;  // not a key: blocks of `observation_sources`
  std::vector<ExclusionZone> zones;    // not a key: blocks of `exclusion_zones`
};
Nav2Keys<CollisionMonitorParameters> collisionMonitorKeys();
Nav2Keys<MonitorPolygon> monitorPolygonKeys();
Nav2Keys<VelocitySubPolygon> velocitySubPolygonKeys();
Nav2Keys<MonitorSource> monitorSourceKeys();
Nav2Keys<ExclusionZone> exclusionZoneKeys();
IgnoredKeys ignoredCollisionMonitorKeys();
IgnoredKeys ignoredExclusionZoneKeys();
base::Diagnostics problemsOf(const CollisionMonitorParameters& parameters);

/// Whether a point is inside a polygon (even-odd rule).
bool isInPolygon(const Vec2& point, const Polygon& polygon);

/// The action applied to a command.
enum class MonitorAction : std::uint8_t { None, Stop, Slowdown, Limit, Approach };
struct MonitoredCommand {
  BodyTwist twist;
  MonitorAction action = MonitorAction::None;
  std::string polygon;  // name of the acting polygon; "invalid source" if a scan is too old
};

/// The last stage before the base (nav2_collision_monitor): slows commands down depending on the
/// points of the newest scan in polygons around the robot. Not thread-safe.
class CollisionMonitor {
 public:
  /// Precondition: no errors. `footprint`: padded, for polygons without points.
  CollisionMonitor(const CollisionMonitorParameters& parameters, const Polygon& footprint,
                   Distro distro);

  MonitoredCommand filter(const BodyTwist& command, const Observation& observation);

 private:
  struct Shape {
    MonitorPolygon keys;
    bool isCircle = false;
    Polygon corners;               // current corners; empty for a circle
    double reach = 0.0;            // [m], radius or distance of the farthest corner
    std::vector<Polygon> choices;  // polygons of keys.subPolygons
  };
  struct Zone {
    ZoneFrame frame = ZoneFrame::Robot;
    double radius = 0.0;  // [m], of a circle
    Polygon corners;      // empty for a circle
  };
  bool gatherPoints(const Observation& observation);
  bool isExcluded(const Vec2& point, const Observation& observation) const;
  static void selectCorners(Shape& shape, const BodyTwist& command);
  static void setCorners(Shape& shape, const Polygon& corners);
  static bool isTriggered(const Shape& shape, const std::vector<Vec2>& points);
  void collectNearPoints(const Shape& shape, const BodyTwist& command);
  double timeToCollision(const Shape& shape, const BodyTwist& command);
  BodyTwist safe(const Shape& shape, const BodyTwist& command, MonitorAction& action);

  CollisionMonitorParameters parameters_;
  std::vector<Shape> shapes_;
  std::vector<Zone> zones_;
  Distro distro_;
  std::vector<Vec2> points_, near_, moved_;  // robot frame [m]
};

}  // namespace sim2d::nav2
