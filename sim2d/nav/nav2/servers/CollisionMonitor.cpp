#include "sim2d/nav/nav2/servers/CollisionMonitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

BodyTwist scaledTwist(const BodyTwist& twist, double factor) {
  return {factor * twist.linear, factor * twist.angular, factor * twist.lateral};
}

/// Nav2's measure of the danger of a command; lower is safer.
double dangerOf(const BodyTwist& twist) {
  return twist.linear * twist.linear + twist.lateral * twist.lateral +
         twist.angular * twist.angular;
}

double speedAlong(const BodyTwist& twist) {
  return std::sqrt(twist.linear * twist.linear + twist.lateral * twist.lateral);
}

constexpr int kMaxScanPoints = 1000000;  // larger than any scan

constexpr std::array<const char*, 3> kShapeTypes = {"polygon", "circle", "velocity_polygon"};
constexpr std::array<const char*, 5> kActionTypes = {"none", "stop", "slowdown", "limit",
                                                     "approach"};

constexpr double kBeamHeight = 0.2;  // [m], of the lidar's plane

template <std::size_t N>
bool isShapeName(const std::string& word, const std::array<const char*, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

MonitorAction monitorActionOf(const MonitorPolygon& keys) {
  const auto found = std::find(kActionTypes.begin(), kActionTypes.end(), keys.actionType);
  return static_cast<MonitorAction>(found - kActionTypes.begin());
}

Polygon shapeCorners(const MonitorPolygon& keys, const Polygon& footprint) {
  if (!keys.pointList.empty()) {
    Polygon corners;
    for (std::size_t i = 0; i + 1 < keys.pointList.size(); i += 2) {
      corners.emplace_back(keys.pointList[i], keys.pointList[i + 1]);
    }
    return corners;
  }
  const base::Result<Polygon> corners = readPolygon(keys.points);
  return corners ? *corners : footprint;
}

bool isInRange(const VelocitySubPolygon& part, const BodyTwist& command, bool isHolonomic) {
  const double linear = isHolonomic ? speedAlong(command) : command.linear;
  bool isIn = linear >= part.linearMin && linear <= part.linearMax &&
              command.angular >= part.thetaMin && command.angular <= part.thetaMax;
  if (isHolonomic) {
    const double direction = base::atan2(command.lateral, command.linear);
    const bool isAfter = direction >= part.directionStartAngle;
    const bool isBefore = direction <= part.directionEndAngle;
    const bool isWhole = part.directionStartAngle <= part.directionEndAngle;
    isIn = isIn && (isWhole ? isAfter && isBefore : isAfter || isBefore);
  }
  return isIn;
}

/// The number of steps is checked only if both times are valid.
void checkApproach(const MonitorPolygon& shape, ParameterChecks& checks,
                   base::Diagnostics& problems) {
  constexpr double kMinStep = 1e-3, kMaxDuration = 1000.0, kMaxSteps = 1000.0;
  const bool isStep = checks.require("simulation_time_step", shape.simulationTimeStep,
                                     {{kMinStep, kMaxDuration}, "0.001 to 1000 s"});
  const bool isTime = checks.require("time_before_collision", shape.timeBeforeCollision,
                                     {{0.0, kMaxDuration, true}, "above 0, up to 1000 s"});
  const double steps = shape.timeBeforeCollision / shape.simulationTimeStep;
  if (isStep && isTime && steps > kMaxSteps) {
    problems.push_back(base::error(
        "nav2.too-much-work", {shape.name + ".time_before_collision", shape.timeBeforeCollision,
                               "simulation_time_step", steps, "steps", kMaxSteps}));
  }
}

void checkShape(const MonitorPolygon& shape, base::Diagnostics& problems) {
  ParameterChecks checks(problems, shape.name + ".");
  checks.require(isShapeName(shape.type, kShapeTypes), "type",
                 "polygon, circle or velocity_polygon");
  checks.require(isShapeName(shape.actionType, kActionTypes), "action_type",
                 "stop, slowdown, limit, approach or none");
  if (shape.type == "circle") {
    checks.require(shape.radius > 0.0, "radius", "above 0");
  }
  if (shape.type == "velocity_polygon") {
    checks.require(!shape.subPolygons.empty(), "velocity_polygons", "a list of names");
    for (const VelocitySubPolygon& part : shape.subPolygons) {
      base::append(problems, readPolygon(part.points).diagnostics());
    }
  }
  if (shape.type == "polygon" && shape.pointList.empty() && !shape.points.empty()) {
    base::append(problems, readPolygon(shape.points).diagnostics());
  }
  checks.require(
      shape.pointList.size() % 2 == 0 && (shape.pointList.empty() || shape.pointList.size() >= 6),
      "points", "at least three pairs of numbers");
  if (shape.actionType == "approach") {
    checkApproach(shape, checks, problems);
  }
}

/// The values of a disabled zone are not used.
void checkZone(const ExclusionZone& zone, base::Diagnostics& problems) {
  ParameterChecks checks(problems, zone.name + ".");
  if (!zone.enabled) {
    return;
  }
  if (checks.require(zone.type == "polygon" || zone.type == "circle", "type",
                     "polygon or circle")) {
    if (zone.type == "circle") {
      checks.require(zone.radius > 0.0, "radius", "above 0");
    } else {
      base::append(problems, readPolygon(zone.points).diagnostics());
    }
  }
}

}  // namespace

Nav2Keys<CollisionMonitorParameters> collisionMonitorKeys() {
  using P = CollisionMonitorParameters;
  return {
      {"enabled", &P::enabled, "", "Whether the node limits commands.", kSinceLyrical},
      {"source_timeout", &P::sourceTimeout, "s",
       "Age above which a scan is ignored; since Jazzy the robot then stops; 0: it does not stop."},
      {"polygons", &P::polygons, "", "Names of the polygons, in the order of evaluation."},
      {"observation_sources", &P::observationSources, "", "Names of the sources."},
      {"exclusion_zones", &P::exclusionZones, "", "Names of the zones whose points are not used.",
       kSinceLyrical},
  };
}

Nav2Keys<MonitorPolygon> monitorPolygonKeys() {
  using P = MonitorPolygon;
  return {
      {"type", &P::type, "", "polygon, circle or velocity_polygon."},
      {"points", &P::pointList, "m", "Corners: x1, y1, x2 …", kHumble},
      {"points", &P::points, "m", "Corners: \"[[x, y], …]\"; none: the robot's footprint.",
       kSinceJazzy},
      {"radius", &P::radius, "m", "Radius of a circle."},
      {"action_type", &P::actionType, "", "stop, slowdown, limit or approach."},
      {"max_points", &P::maxPoints, "", "Number of points above which the polygon acts.", kHumble},
      {"min_points", &P::minPoints, "", "Minimum number of points at which the polygon acts.",
       kSinceJazzy},
      {"slowdown_ratio", &P::slowdownRatio, "", "Remaining share of the command."},
      {"linear_limit", &P::linearLimit, "m/s", "Maximum speed.", kSinceJazzy},
      {"angular_limit", &P::angularLimit, "rad/s", "Maximum turn rate.", kSinceJazzy},
      {"time_before_collision", &P::timeBeforeCollision, "s",
       "Approach: time that is simulated ahead."},
      {"simulation_time_step", &P::simulationTimeStep, "s",
       "Approach: time step of that simulation."},
      {"footprint_topic", &P::footprintTopic, "",
       "Topic of the footprint; this program uses the robot's footprint."},
      {"enabled", &P::enabled, "", "Whether the polygon is evaluated."},
      {"holonomic", &P::holonomic, "", "Whether directions of motion are used.", kSinceJazzy},
      {"velocity_polygons", &P::velocityPolygons, "", "Names of its sub-polygons.", kSinceJazzy},
  };
}

Nav2Keys<VelocitySubPolygon> velocitySubPolygonKeys() {
  using P = VelocitySubPolygon;
  return onlyIn<Nav2Key<P>>(
      kSinceJazzy,
      {
          {"points", &P::points, "m", "Corners: \"[[x, y], …]\"."},
          {"linear_min", &P::linearMin, "m/s", "Minimum speed."},
          {"linear_max", &P::linearMax, "m/s", "Maximum speed."},
          {"theta_min", &P::thetaMin, "rad/s", "Minimum turn rate."},
          {"theta_max", &P::thetaMax, "rad/s", "Maximum turn rate."},
          {"direction_start_angle", &P::directionStartAngle, "rad", "First direction of motion."},
          {"direction_end_angle", &P::directionEndAngle, "rad", "Last direction of motion."},
      });
}

Nav2Keys<MonitorSource> monitorSourceKeys() {
  using P = MonitorSource;
  return {
      {"type", &P::type, "", "scan, pointcloud or range; this program uses the robot's lidar."},
      {"enabled", &P::enabled, "", "Whether the source is used."},
      {"source_timeout", &P::sourceTimeout, "s",
       "Replaces source_timeout of the node for this source.", kSinceJazzy},
  };
}

Nav2Keys<ExclusionZone> exclusionZoneKeys() {
  using P = ExclusionZone;
  return onlyIn<Nav2Key<P>>(
      kSinceLyrical,
      {
          {"enabled", &P::enabled, "", "Whether the zone is used."},
          {"type", &P::type, "", "polygon, or circle around the origin of the frame."},
          {"points", &P::points, "m", "Corners: \"[[x, y], …]\"."},
          {"radius", &P::radius, "m", "Radius of a circle."},
          {"min_height", &P::minHeight, "m",
           "A zone that begins above the plane of the lidar (0.2 m) has no effect."},
          {"max_height", &P::maxHeight, "m",
           "A zone that ends below the plane of the lidar (0.2 m) has no effect."},
          {"frame_id", &P::frameId, "",
           "Frame of the zone: on the robot, odom or map; empty: base_frame_id."},
      });
}

IgnoredKeys ignoredExclusionZoneKeys() {
  return {{"visualize", "only used by ROS displays", kSinceLyrical},
          {"frame_hold_timeout", "transforms are never late", kSinceLyrical}};
}

IgnoredKeys ignoredCollisionMonitorKeys() {
  return {
      {"base_frame_id", "all base frames of a robot are identical"},
      {"odom_frame_id", "points are always placed in the odometry frame"},
      {"transform_tolerance", "TF is not used"},
      {"base_shift_correction", "points stay where the scan measured them"},
      {"stop_pub_timeout", "a standing robot stays at rest"},
      {"cmd_vel_in_topic", "ROS topics are not used"},
      {"cmd_vel_out_topic", "ROS topics are not used"},
      {"state_topic", "ROS topics are not used"},
      {"topic", "the scan is that of the robot"},
      {"min_height", "the lidar is planar"},
      {"max_height", "the lidar is planar"},
      {"visualize", "only used by ROS displays"},
      {"polygon_pub_topic", "only used by ROS displays"},
      {"polygon_sub_topic", "polygons are constant"},
      {"trigger_consecutive_points", "treated as 1", kSinceLyrical},
      {"release_consecutive_points", "treated as 1", kSinceLyrical},
      {"polygon_subscribe_transient_local", "polygons are constant", kSinceJazzy},
      {"sources_names", "the robot has a single lidar", kSinceJazzy},
      {"min_range", "the scan is that of the robot", kSinceJazzy},
      {"use_global_height", "the lidar is planar", kSinceJazzy},
      {"sampling_distance", "polygons of other nodes are not supported as sources", kSinceJazzy},
      {"obstacles_angle", "ultrasound and infrared sensors are not supported as sources"},
      {"transport_type", "ROS topics are not used", kSinceLyrical},
      {"collision_points_marker_3d", "only used by ROS displays", kSinceLyrical},
  };
}

base::Diagnostics problemsOf(const CollisionMonitorParameters& parameters) {
  base::Diagnostics problems;
  for (const MonitorPolygon& shape : parameters.shapes) {
    checkShape(shape, problems);
  }
  for (const ExclusionZone& zone : parameters.zones) {
    checkZone(zone, problems);
  }
  return problems;
}

bool isInPolygon(const Vec2& point, const Polygon& polygon) {
  bool isIn = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& to = polygon[i];
    const Vec2& from = polygon[j];
    if ((point.y() <= to.y()) == (point.y() > from.y())) {
      const double share = (point.y() - to.y()) / (from.y() - to.y());
      isIn = isIn != (to.x() + share * (from.x() - to.x()) > point.x());
    }
  }
  return isIn;
}

CollisionMonitor::CollisionMonitor(const CollisionMonitorParameters& parameters,
                                   const Polygon& footprint, Distro distro)
    : parameters_(parameters), distro_(distro) {
  for (const MonitorPolygon& keys : parameters.shapes) {
    Shape shape;
    shape.keys = keys;
    if (distro == Distro::Humble) {
      shape.keys.minPoints = std::min(keys.maxPoints, kMaxScanPoints) + 1;
    }
    shape.isCircle = keys.type == "circle";
    setCorners(shape, keys.type == "polygon" ? shapeCorners(keys, footprint) : Polygon{});
    for (const VelocitySubPolygon& part : keys.subPolygons) {
      const base::Result<Polygon> corners = readPolygon(part.points);
      shape.choices.push_back(corners ? *corners : Polygon{});
    }
    shapes_.push_back(std::move(shape));
  }
  for (const ExclusionZone& zone : parameters_.zones) {
    if (zone.enabled && zone.minHeight <= kBeamHeight && zone.maxHeight >= kBeamHeight) {
      const base::Result<Polygon> corners = readPolygon(zone.points);
      zones_.push_back(
          {zone.frame, zone.radius, zone.type == "circle" || !corners ? Polygon{} : *corners});
    }
  }
}

MonitoredCommand CollisionMonitor::filter(const BodyTwist& command,
                                          const Observation& observation) {
  MonitoredCommand result;
  result.twist = command;
  if (!parameters_.enabled) {
    return result;
  }
  if (!gatherPoints(observation)) {
    return {BodyTwist{}, MonitorAction::Stop, "invalid source"};
  }
  for (Shape& shape : shapes_) {
    if (!shape.keys.enabled) {
      continue;
    }
    if (result.action == MonitorAction::Stop) {
      break;
    }
    selectCorners(shape, command);
    MonitorAction action = MonitorAction::None;
    const BodyTwist twist = safe(shape, command, action);
    if (action == MonitorAction::Stop ||
        (action != MonitorAction::None && dangerOf(twist) < dangerOf(result.twist))) {
      result = {twist, action, shape.keys.name};
    }
  }
  return result;
}

/// Returns false if a source is too old; the robot must then stop.
bool CollisionMonitor::gatherPoints(const Observation& observation) {
  constexpr double kRounding = 1e-9;  // [s]
  points_.clear();
  const LaserScan* const scan = observation.scan;
  bool isRight = true, isSeen = false;
  for (const MonitorSource& source : parameters_.sources) {
    const bool isOld =
        scan == nullptr || (source.sourceTimeout > 0.0 &&
                            observation.time - scan->time > source.sourceTimeout + kRounding);
    isSeen = isSeen || (source.enabled && !isOld);
    isRight = isRight &&
              !(source.enabled && isOld && source.sourceTimeout > 0.0 && distro_ != Distro::Humble);
  }
  if (!isSeen || !isRight) {
    return isRight;
  }
  for (std::size_t i = 0; i < scan->distances.size(); ++i) {
    const Vec2 point =
        scan->sensor.position + scan->distances[i] * base::directionOf(scan->angle(i));
    if (scan->distances[i] < scan->range && !isExcluded(point, observation)) {
      points_.push_back(observation.pose.toLocal(point));
    }
  }
  return true;
}

/// Whether a point in the frame of the observation is in an exclusion zone.
bool CollisionMonitor::isExcluded(const Vec2& point, const Observation& observation) const {
  return std::any_of(zones_.begin(), zones_.end(), [&](const Zone& zone) {
    const Vec2 inZone = zone.frame == ZoneFrame::Robot ? observation.pose.toLocal(point)
                        : zone.frame == ZoneFrame::Map ? observation.frame.toWorld(point)
                                                       : point;
    return zone.corners.empty() ? inZone.squaredNorm() < zone.radius * zone.radius
                                : isInPolygon(inZone, zone.corners);
  });
}

/// Selects the corners for a command; keeps the previous ones if none apply.
void CollisionMonitor::selectCorners(Shape& shape, const BodyTwist& command) {
  for (std::size_t i = 0; i < shape.choices.size(); ++i) {
    if (isInRange(shape.keys.subPolygons[i], command, shape.keys.holonomic)) {
      setCorners(shape, shape.choices[i]);
      return;
    }
  }
}

void CollisionMonitor::setCorners(Shape& shape, const Polygon& corners) {
  shape.corners = corners;
  shape.reach = shape.isCircle ? std::fabs(shape.keys.radius) : 0.0;
  for (const Vec2& corner : corners) {
    shape.reach = std::max(shape.reach, corner.norm());
  }
}

bool CollisionMonitor::isTriggered(const Shape& shape, const std::vector<Vec2>& points) {
  int inside = 0;
  if (shape.isCircle) {
    const double most = shape.keys.radius * shape.keys.radius;
    inside =
        static_cast<int>(std::count_if(points.begin(), points.end(), [most](const Vec2& point) {
          return point.squaredNorm() < most;
        }));
  } else if (!shape.corners.empty()) {
    inside = static_cast<int>(std::count_if(points.begin(), points.end(), [&](const Vec2& point) {
      return isInPolygon(point, shape.corners);
    }));
  }
  return inside >= shape.keys.minPoints;
}

/// Collects the points that the shape may reach within its time at this command.
void CollisionMonitor::collectNearPoints(const Shape& shape, const BodyTwist& command) {
  constexpr double kSlack = 0.001;  // [m], above rounding errors
  const double time = shape.keys.timeBeforeCollision + 2.0 * shape.keys.simulationTimeStep;
  const double most =
      shape.reach + std::hypot(command.linear, command.lateral) * std::max(time, 0.0) + kSlack;
  near_.clear();
  std::copy_if(points_.begin(), points_.end(), std::back_inserter(near_),
               [most](const Vec2& point) { return point.squaredNorm() <= most * most; });
}

/// Time until enough points are inside at this command [s]; negative: not within the time.
double CollisionMonitor::timeToCollision(const Shape& shape, const BodyTwist& command) {
  collectNearPoints(shape, command);
  if (isTriggered(shape, near_)) {
    return 0.0;
  }
  const double step = shape.keys.simulationTimeStep;
  const base::SinCos turn = base::sinCos(command.angular * step);
  Pose2 pose;
  Vec2 velocity(command.linear, command.lateral);
  double time = 0.0;  // summed like in Nav2
  while (time <= shape.keys.timeBeforeCollision) {
    pose.position += step * velocity;
    pose.heading += step * command.angular;
    velocity = Vec2(velocity.x() * turn.cos - velocity.y() * turn.sin,
                    velocity.x() * turn.sin + velocity.y() * turn.cos);
    const Vec2 ahead = pose.direction();
    moved_.clear();
    for (const Vec2& point : near_) {
      const Vec2 offset = point - pose.position;
      moved_.emplace_back(ahead.dot(offset), base::cross(ahead, offset));
    }
    if (isTriggered(shape, moved_)) {
      return time;
    }
    time += step;
  }
  return -1.0;
}

/// The command after a shape's action; None: the shape does not act.
BodyTwist CollisionMonitor::safe(const Shape& shape, const BodyTwist& command,
                                 MonitorAction& action) {
  const MonitorAction own = monitorActionOf(shape.keys);
  if (own == MonitorAction::Approach) {
    const double time = timeToCollision(shape, command);
    if (time < 0.0) {
      return command;
    }
    action = own;
    return scaledTwist(command, time / shape.keys.timeBeforeCollision);
  }
  if (!isTriggered(shape, points_)) {
    return command;
  }
  action = own;
  if (own == MonitorAction::Stop) {
    return {};
  }
  if (own == MonitorAction::Slowdown) {
    return scaledTwist(command, shape.keys.slowdownRatio);
  }
  const double speed = speedAlong(command), turning = std::fabs(command.angular);
  double ratio = 1.0;
  ratio = speed > 0.0 ? std::min(ratio, shape.keys.linearLimit / speed) : ratio;
  ratio = turning > 0.0 ? std::min(ratio, shape.keys.angularLimit / turning) : ratio;
  return scaledTwist(command, std::clamp(ratio, 0.0, 1.0));
}

}  // namespace sim2d::nav2
