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

BodyTwist slowedBy(const BodyTwist& twist, double factor) {
  return {factor * twist.linear, factor * twist.angular, factor * twist.lateral};
}

/// Nav2's measure of how safe a command is: the less the safer.
double dangerOf(const BodyTwist& twist) {
  return twist.linear * twist.linear + twist.lateral * twist.lateral +
         twist.angular * twist.angular;
}

double speedAlong(const BodyTwist& twist) {
  return std::sqrt(twist.linear * twist.linear + twist.lateral * twist.lateral);
}

constexpr int kMostPoints = 1000000;  // more than any scan has

constexpr std::array<const char*, 3> kShapeTypes = {"polygon", "circle", "velocity_polygon"};
constexpr std::array<const char*, 5> kActionTypes = {"none", "stop", "slowdown", "limit",
                                                     "approach"};

template <std::size_t N>
bool isShapeWord(const std::string& word, const std::array<const char*, N>& words) {
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

/// The number of steps is only checked when both times are valid.
void checkApproach(const MonitorPolygon& shape, base::Diagnostics& problems) {
  constexpr double kShortestStep = 1e-3, kLongest = 1000.0, kMostSteps = 1000.0;
  const bool isStep =
      shape.simulationTimeStep >= kShortestStep && shape.simulationTimeStep <= kLongest;
  const bool isTime = shape.timeBeforeCollision > 0.0 && shape.timeBeforeCollision <= kLongest;
  if (!isStep) {
    problems.push_back(base::error("nav2.bad-parameter",
                                   {shape.name + ".simulation_time_step", "0.001 to 1000 s"}));
  }
  if (!isTime) {
    problems.push_back(base::error(
        "nav2.bad-parameter", {shape.name + ".time_before_collision", "above 0, up to 1000 s"}));
  }
  const double steps = shape.timeBeforeCollision / shape.simulationTimeStep;
  if (isStep && isTime && steps > kMostSteps) {
    problems.push_back(base::error(
        "nav2.too-much-work", {shape.name + ".time_before_collision", shape.timeBeforeCollision,
                               "simulation_time_step", steps, "steps", kMostSteps}));
  }
}

void checkShape(const MonitorPolygon& shape, base::Diagnostics& problems) {
  const auto require = [&shape, &problems](bool isRight, const char* key, const char* wanted) {
    if (!isRight) {
      problems.push_back(base::error("nav2.bad-parameter", {shape.name + "." + key, wanted}));
    }
  };
  require(isShapeWord(shape.type, kShapeTypes), "type", "polygon, circle or velocity_polygon");
  require(isShapeWord(shape.actionType, kActionTypes), "action_type",
          "stop, slowdown, limit, approach or none");
  if (shape.type == "circle") {
    require(shape.radius > 0.0, "radius", "above 0");
  }
  if (shape.type == "velocity_polygon") {
    require(!shape.subPolygons.empty(), "velocity_polygons", "a list of names");
    for (const VelocitySubPolygon& part : shape.subPolygons) {
      base::append(problems, readPolygon(part.points).diagnostics());
    }
  }
  if (shape.type == "polygon" && shape.pointList.empty() && !shape.points.empty()) {
    base::append(problems, readPolygon(shape.points).diagnostics());
  }
  require(
      shape.pointList.size() % 2 == 0 && (shape.pointList.empty() || shape.pointList.size() >= 6),
      "points", "pairs of numbers, three at least");
  if (shape.actionType == "approach") {
    checkApproach(shape, problems);
  }
}

}  // namespace

const std::vector<Nav2Key<CollisionMonitorParameters>>& collisionMonitorKeys() {
  using P = CollisionMonitorParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the node changes commands.", kSinceLyrical},
      {"source_timeout", &P::sourceTimeout, "s",
       "An older scan is none; since Jazzy the robot stops then; 0: it does not."},
      {"polygons", &P::polygons, "", "Names of the polygons, in the order of their test."},
      {"observation_sources", &P::observationSources, "", "Names of the sources."},
  };
  return kKeys;
}

const std::vector<Nav2Key<MonitorPolygon>>& monitorPolygonKeys() {
  using P = MonitorPolygon;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"type", &P::type, "", "polygon, circle or velocity_polygon."},
      {"points", &P::pointList, "m", "Corners: x1, y1, x2 …", kHumble},
      {"points", &P::points, "m", "Corners: \"[[x, y], …]\"; none: the robot's footprint.",
       kSinceJazzy},
      {"radius", &P::radius, "m", "Radius of a circle."},
      {"action_type", &P::actionType, "", "stop, slowdown, limit or approach."},
      {"max_points", &P::maxPoints, "", "It acts above so many points.", kHumble},
      {"min_points", &P::minPoints, "", "Least number of points at which it acts.", kSinceJazzy},
      {"slowdown_ratio", &P::slowdownRatio, "", "Share of the command that is left."},
      {"linear_limit", &P::linearLimit, "m/s", "Greatest speed.", kSinceJazzy},
      {"angular_limit", &P::angularLimit, "rad/s", "Greatest turning speed.", kSinceJazzy},
      {"time_before_collision", &P::timeBeforeCollision, "s", "Approach: how far ahead."},
      {"simulation_time_step", &P::simulationTimeStep, "s", "Approach: in which steps."},
      {"footprint_topic", &P::footprintTopic, "", "Whose footprint: here always the robot's."},
      {"enabled", &P::enabled, "", "Whether it is tested."},
      {"holonomic", &P::holonomic, "", "Whether directions of motion count.", kSinceJazzy},
      {"velocity_polygons", &P::velocityPolygons, "", "Names of its parts.", kSinceJazzy},
  };
  return kKeys;
}

const std::vector<Nav2Key<VelocitySubPolygon>>& velocitySubPolygonKeys() {
  using P = VelocitySubPolygon;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"points", &P::points, "m", "Corners: \"[[x, y], …]\".", kSinceJazzy},
      {"linear_min", &P::linearMin, "m/s", "Least speed.", kSinceJazzy},
      {"linear_max", &P::linearMax, "m/s", "Greatest speed.", kSinceJazzy},
      {"theta_min", &P::thetaMin, "rad/s", "Least turning speed.", kSinceJazzy},
      {"theta_max", &P::thetaMax, "rad/s", "Greatest turning speed.", kSinceJazzy},
      {"direction_start_angle", &P::directionStartAngle, "rad", "First direction of motion.",
       kSinceJazzy},
      {"direction_end_angle", &P::directionEndAngle, "rad", "Last direction of motion.",
       kSinceJazzy},
  };
  return kKeys;
}

const std::vector<Nav2Key<MonitorSource>>& monitorSourceKeys() {
  using P = MonitorSource;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"type", &P::type, "", "scan, pointcloud, range: here always the robot's lidar."},
      {"enabled", &P::enabled, "", "Whether it is used."},
      {"source_timeout", &P::sourceTimeout, "s", "As that of the node, which counts without it.",
       kSinceJazzy},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleCollisionMonitorKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"base_frame_id", "the base frames of a robot coincide here"},
      {"odom_frame_id", "points are always placed by the odometry"},
      {"transform_tolerance", "no TF here"},
      {"base_shift_correction", "points are where the scan saw them"},
      {"stop_pub_timeout", "a robot that stands goes on standing"},
      {"cmd_vel_in_topic", "no topics here"},
      {"cmd_vel_out_topic", "no topics here"},
      {"state_topic", "no topics here"},
      {"topic", "the scan is the robot's"},
      {"min_height", "the lidar is planar"},
      {"max_height", "the lidar is planar"},
      {"visualize", "for displays of ROS"},
      {"polygon_pub_topic", "for displays of ROS"},
      {"polygon_sub_topic", "polygons do not change here"},
      {"trigger_consecutive_points", "counts as 1", kSinceLyrical},
      {"release_consecutive_points", "counts as 1", kSinceLyrical},
      {"polygon_subscribe_transient_local", "polygons do not change here"},
      {"sources_names", "there is one lidar here"},
      {"min_range", "the scan is the robot's"},
      {"use_global_height", "the lidar is planar"},
      {"sampling_distance", "polygons of other nodes are no sources here"},
      {"obstacles_angle", "ultrasound and infrared sensors are no sources here"},
      {"transport_type", "no topics here"},
      {"collision_points_marker_3d", "for displays of ROS"},
      {"use_realtime_priority", "time is simulated"},
      {"enable_stamped_cmd_vel", "no topics here"},
      {"use_sim_time", "time is simulated here"},
      {"introspection_mode", "no services of ROS here"},
  };
  return kKeys;
}

base::Diagnostics problemsOf(const CollisionMonitorParameters& parameters) {
  base::Diagnostics problems;
  for (const MonitorPolygon& shape : parameters.shapes) {
    checkShape(shape, problems);
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
      shape.keys.minPoints = std::min(keys.maxPoints, kMostPoints) + 1;
    }
    shape.isCircle = keys.type == "circle";
    setCorners(shape, keys.type == "polygon" ? shapeCorners(keys, footprint) : Polygon{});
    for (const VelocitySubPolygon& part : keys.subPolygons) {
      const base::Result<Polygon> corners = readPolygon(part.points);
      shape.choices.push_back(corners ? *corners : Polygon{});
    }
    shapes_.push_back(std::move(shape));
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
    choose(shape, command);
    MonitorAction action = MonitorAction::None;
    const BodyTwist twist = safe(shape, command, action);
    if (action == MonitorAction::Stop ||
        (action != MonitorAction::None && dangerOf(twist) < dangerOf(result.twist))) {
      result = {twist, action, shape.keys.name};
    }
  }
  return result;
}

/// False: a source is too old, and the robot has to stop.
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
    if (scan->distances[i] < scan->range) {
      const double angle =
          scan->sensor.heading + scan->angleMin + static_cast<double>(i) * scan->perBeam;
      points_.push_back(observation.pose.toLocal(scan->sensor.position +
                                                 scan->distances[i] * base::directionOf(angle)));
    }
  }
  return true;
}

/// The corners for a command; those before stay when none are for it.
void CollisionMonitor::choose(Shape& shape, const BodyTwist& command) {
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

/// Those that the shape may meet if the command goes on for its time; the others are farther away
/// than it comes.
void CollisionMonitor::findNear(const Shape& shape, const BodyTwist& command) {
  constexpr double kSlack = 0.001;  // [m] more than the rounding of the way
  const double time = shape.keys.timeBeforeCollision + 2.0 * shape.keys.simulationTimeStep;
  const double most =
      shape.reach + std::hypot(command.linear, command.lateral) * std::max(time, 0.0) + kSlack;
  near_.clear();
  std::copy_if(points_.begin(), points_.end(), std::back_inserter(near_),
               [most](const Vec2& point) { return point.squaredNorm() <= most * most; });
}

/// Until enough points lie inside, if the command goes on [s]; below 0: not within the time.
double CollisionMonitor::timeToCollision(const Shape& shape, const BodyTwist& command) {
  findNear(shape, command);
  if (isTriggered(shape, near_)) {
    return 0.0;
  }
  const double step = shape.keys.simulationTimeStep;
  const base::SinCos turn = base::sinCos(command.angular * step);
  Pose2 pose;
  Vec2 velocity(command.linear, command.lateral);
  double time = 0.0;  // summed up as Nav2 does
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

/// What a shape leaves of a command, and by which action; None: it does not act.
BodyTwist CollisionMonitor::safe(const Shape& shape, const BodyTwist& command,
                                 MonitorAction& action) {
  const MonitorAction own = monitorActionOf(shape.keys);
  if (own == MonitorAction::Approach) {
    const double time = timeToCollision(shape, command);
    if (time < 0.0) {
      return command;
    }
    action = own;
    return slowedBy(command, time / shape.keys.timeBeforeCollision);
  }
  if (!isTriggered(shape, points_)) {
    return command;
  }
  action = own;
  if (own == MonitorAction::Stop) {
    return {};
  }
  if (own == MonitorAction::Slowdown) {
    return slowedBy(command, shape.keys.slowdownRatio);
  }
  const double speed = speedAlong(command), turning = std::fabs(command.angular);
  double ratio = 1.0;
  ratio = speed > 0.0 ? std::min(ratio, shape.keys.linearLimit / speed) : ratio;
  ratio = turning > 0.0 ? std::min(ratio, shape.keys.angularLimit / turning) : ratio;
  return slowedBy(command, std::clamp(ratio, 0.0, 1.0));
}

}  // namespace sim2d::nav2
