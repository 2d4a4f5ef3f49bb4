#include "app/bridge/topics/RunMessages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Find.h"

namespace bridge {
namespace {

constexpr const char* kTagNames[] = {"id", "group_id", "behavior"};  // of people_msgs/Person

float floatOf(double value) {
  return static_cast<float>(value);
}

/// A resolved numeric parameter of a person; 0 if the trace does not contain it.
double parameterOf(const sim2d::TraceHuman& human, std::string_view key) {
  const auto* const found = base::findIf(
      human.parameters, [key](const auto& each) { return std::string_view(each.first) == key; });
  return found == nullptr ? 0.0 : found->second;
}

std::size_t placeOf(const std::vector<sim2d::TraceGoal>& goals, int current) {
  const auto found = std::find_if(goals.begin(), goals.end(),
                                  [current](const auto& goal) { return goal.id == current; });
  return static_cast<std::size_t>(found - goals.begin());
}

/// The goals from the current one on; cyclic goals wrap around.
void setGoals(const std::vector<sim2d::TraceGoal>& goals, int current, bool isCyclic,
              std::vector<geometry_msgs::Pose>& poses) {
  const std::size_t first = placeOf(goals, current);
  poses.clear();
  poses.reserve(isCyclic ? goals.size() : goals.size() - first);
  for (std::size_t k = first; k < goals.size(); ++k) {
    poses.push_back(poseOf(goals[k].position));
  }
  for (std::size_t k = 0; isCyclic && first < goals.size() && k < first; ++k) {
    poses.push_back(poseOf(goals[k].position));
  }
}

void setMotion(const sim2d::BodyColumns& bodies, std::size_t at, hunav_msgs::Agent& agent) {
  agent.position = poseOf(poseIn(bodies, at));
  agent.yaw = floatOf(bodies.heading[at]);
  agent.velocity.linear.x = bodies.vx[at];
  agent.velocity.linear.y = bodies.vy[at];
  agent.velocity.angular.z = bodies.omega[at];
  agent.linearVel = floatOf(std::hypot(bodies.vx[at], bodies.vy[at]));
  agent.angularVel = floatOf(bodies.omega[at]);
}

hunav_msgs::AgentBehavior behaviorOf(const sim2d::TraceHuman& human, std::uint8_t state) {
  hunav_msgs::AgentBehavior behavior;
  behavior.type = static_cast<std::uint8_t>(human.behavior);
  behavior.state = state;
  behavior.configuration = static_cast<std::uint8_t>(human.configuration);
  for (const auto& [key, value] : human.parameters) {
    const std::string_view name = key;  // faster: compares lengths first
    if (name == "once") {
      behavior.once = value != 0.0;
    }
    for (const BehaviorParameter& parameter : kBehaviorParameters) {
      if (name == parameter.key) {
        behavior.*parameter.member = floatOf(value);
      }
    }
  }
  return behavior;
}

void setAgent(const sim2d::TraceHeader& header, const sim2d::HumanColumns& humans, std::size_t at,
              hunav_msgs::Agent& agent) {
  const sim2d::TraceHuman* const human = humanOf(header, humans, at);
  if (human == nullptr) {
    agent = {};
  }
  agent.id = humans.id[at];
  agent.type = hunav_msgs::Agent::kPerson;
  agent.groupId = static_cast<std::int8_t>(std::clamp(humans.group[at], -1, 127));
  setMotion(humans, at, agent);
  if (human != nullptr) {
    agent.name = human->name;
    agent.desiredVelocity = floatOf(human->desiredSpeed);
    agent.radius = floatOf(human->radius);
    agent.behavior = behaviorOf(*human, humans.state[at]);
    setGoals(human->goals, humans.goal[at], human->cyclicGoals, agent.goals);
    agent.cyclicGoals = human->cyclicGoals;
    agent.goalRadius = human->goals.empty() ? floatOf(parameterOf(*human, "goal_radius"))
                                            : floatOf(human->goals.front().radius);
  }
}

}  // namespace

const sim2d::TraceHuman* humanOf(const sim2d::TraceHeader& header,
                                 const sim2d::HumanColumns& humans, std::size_t at) {
  const bool isThere = at < header.humans.size() && header.humans[at].id == humans.id[at];
  return isThere ? &header.humans[at] : header.human(humans.id[at]);
}

std::int64_t nanosecondsOf(double seconds) {
  return std::llround(seconds * 1e9);
}

builtin_interfaces::Time stampOf(double seconds) {
  return stampOfNanoseconds(nanosecondsOf(seconds));
}

std_msgs::Header headerOf(double seconds, const std::string& frame) {
  return {stampOf(seconds), frame};
}

geometry_msgs::Quaternion quaternionFromYaw(double heading) {
  return {0.0, 0.0, std::sin(heading / 2.0), std::cos(heading / 2.0)};
}

double headingOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

geometry_msgs::Pose poseOf(const base::Pose2& pose) {
  return {{pose.position.x(), pose.position.y(), 0.0}, quaternionFromYaw(pose.heading)};
}

geometry_msgs::Pose poseOf(const base::Vec2& point) {
  return {{point.x(), point.y(), 0.0}, {}};
}

geometry_msgs::Transform transformOf(const base::Pose2& pose) {
  return {{pose.position.x(), pose.position.y(), 0.0}, quaternionFromYaw(pose.heading)};
}

base::Pose2 poseIn(const sim2d::BodyColumns& bodies, std::size_t at) {
  return {{bodies.x[at], bodies.y[at]}, bodies.heading[at]};
}

void setAgents(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
               hunav_msgs::Agents& to) {
  to.header = headerOf(frame.time);
  to.agents.resize(frame.humans.size());
  for (std::size_t k = 0; k < frame.humans.size(); ++k) {
    setAgent(header, frame.humans, k, to.agents[k]);
  }
}

hunav_msgs::Agent robotOf(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                          std::size_t robot) {
  hunav_msgs::Agent agent;
  agent.id = frame.robots.id[robot];
  agent.type = hunav_msgs::Agent::kRobot;
  agent.groupId = -1;
  agent.behavior.type = hunav_msgs::AgentBehavior::kBehRegular;
  setMotion(frame.robots, robot, agent);
  if (const sim2d::TraceRobot* const known = header.robot(frame.robots.id[robot])) {
    agent.name = known->name;
    agent.radius = floatOf(known->radius);
    agent.desiredVelocity = floatOf(known->maxVel);
    setGoals(known->goals, frame.robots.goal[robot], false, agent.goals);
    agent.goalRadius = known->goals.empty() ? 0.0F : floatOf(known->goals.front().radius);
  }
  return agent;
}

void setPeople(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
               people_msgs::People& to) {
  to.header = headerOf(frame.time);
  const sim2d::HumanColumns& humans = frame.humans;
  to.people.resize(humans.size());
  for (std::size_t k = 0; k < humans.size(); ++k) {
    const sim2d::TraceHuman* const human = humanOf(header, humans, k);
    people_msgs::Person& person = to.people[k];
    person.name = human != nullptr ? human->name : std::to_string(humans.id[k]);
    person.position = {humans.x[k], humans.y[k], humans.heading[k]};
    person.velocity = {humans.vx[k], humans.vy[k], humans.omega[k]};
    person.reliability = 1.0;
    const int tags[] = {humans.id[k], humans.group[k], human != nullptr ? human->behavior : 0};
    person.tagnames.assign(std::begin(kTagNames), std::end(kTagNames));
    person.tags.resize(std::size(tags));
    for (std::size_t tag = 0; tag < std::size(tags); ++tag) {
      person.tags[tag] = std::to_string(tags[tag]);
    }
  }
}

nav_msgs::Odometry odometryOf(const sim2d::Frame& frame, std::size_t robot,
                              const base::Pose2& estimatedPose, const std::string& odometryFrame,
                              const std::string& robotFrame) {
  nav_msgs::Odometry odometry;
  odometry.header = headerOf(frame.time, odometryFrame);
  odometry.childFrameId = robotFrame;
  odometry.pose.pose = poseOf(estimatedPose);
  const base::Vec2 ahead = base::directionOf(frame.robots.heading[robot]);
  const base::Vec2 velocity(frame.robots.vx[robot], frame.robots.vy[robot]);
  odometry.twist.twist.linear.x = ahead.dot(velocity);
  odometry.twist.twist.linear.y = base::cross(ahead, velocity);
  odometry.twist.twist.angular.z = frame.robots.omega[robot];
  return odometry;
}

sensor_msgs::LaserScan scanOf(const sim2d::RobotTelemetry::Scan& scan, double period,
                              const std::string& sensorFrame) {
  sensor_msgs::LaserScan message;
  message.header = headerOf(scan.time, sensorFrame);
  const std::size_t beams = scan.distances.size();
  const double span = beams > 0 ? static_cast<double>(beams - 1) * scan.angleIncrement : 0.0;
  message.angleMin = floatOf(scan.angleMin);
  message.angleMax = floatOf(scan.angleMin + span);
  message.angleIncrement = floatOf(scan.angleIncrement);
  message.scanTime = floatOf(period);
  message.rangeMin = 0.0F;
  message.rangeMax = floatOf(scan.range);
  message.ranges.reserve(beams);
  for (const double distance : scan.distances) {
    message.ranges.push_back(distance < scan.range ? floatOf(distance)
                                                   : std::numeric_limits<float>::infinity());
  }
  return message;
}

nav_msgs::OccupancyGrid mapOf(const sim2d::OccupancyGrid& grid) {
  nav_msgs::OccupancyGrid map;
  map.header = headerOf(0.0);
  map.info.resolution = floatOf(grid.resolution());
  map.info.width = static_cast<std::uint32_t>(grid.width());
  map.info.height = static_cast<std::uint32_t>(grid.height());
  map.info.origin = poseOf(grid.origin());
  if (!grid.isEmpty()) {
    map.data = grid.cells();
  }
  return map;
}

nav_msgs::Path pathOf(const std::vector<base::Vec2>& points, double seconds) {
  nav_msgs::Path path;
  path.header = headerOf(seconds);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t to = std::min(k + 1, points.size() - 1);
    const base::Vec2 way = k < to ? points[to] - points[k] : points[k] - points[k > 0 ? k - 1 : k];
    path.poses.push_back({path.header, poseOf(base::Pose2{points[k], base::headingOf(way)})});
  }
  return path;
}

geometry_msgs::PoseStamped goalOf(const base::Vec2& goal, double seconds) {
  return {headerOf(seconds), poseOf(goal)};
}

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kPersonHeight = 1.7, kRobotHeight = 0.5;  // [m]
constexpr double kTextSize = 0.3, kTextGap = 0.3;          // [m]
constexpr double kArrowShaft = 0.06, kArrowHead = 0.14;    // [m]
constexpr double kLineWidth = 0.05;                        // [m]
constexpr double kSlowest = 0.05;                          // [m/s], minimum for an arrow

constexpr std_msgs::ColorRGBA kPersonColor{0.16F, 0.44F, 0.78F, 0.9F};
constexpr std_msgs::ColorRGBA kActiveColor{0.90F, 0.49F, 0.13F, 0.9F};  // during a reaction
constexpr std_msgs::ColorRGBA kRobotColor{0.20F, 0.60F, 0.33F, 0.9F};
constexpr std_msgs::ColorRGBA kArrowColor{0.25F, 0.25F, 0.25F, 0.9F};
constexpr std_msgs::ColorRGBA kTextColor{0.55F, 0.55F, 0.55F, 1.0F};  // for any background
constexpr std_msgs::ColorRGBA kWallColor{0.35F, 0.35F, 0.40F, 1.0F};
constexpr std_msgs::ColorRGBA kDoorColor{0.62F, 0.42F, 0.20F, 1.0F};

struct Kind {  // namespaces of markers
  const char* body = "";
  const char* velocity = "";
  const char* name = "";
};
constexpr Kind kPeople{"people", "people/velocity", "people/name"};
constexpr Kind kRobots{"robots", "robots/velocity", "robots/name"};

/// Writes the markers of one state, reusing the elements of the previous message.
class Markers {
 public:
  Markers(MarkerArray& to, double seconds) : to_(to), header_(headerOf(seconds)) {}
  ~Markers() { to_.markers.resize(count_); }
  Markers(const Markers&) = delete;
  Markers& operator=(const Markers&) = delete;
  Markers(Markers&&) = delete;
  Markers& operator=(Markers&&) = delete;

  /// The reference is valid until the next call.
  Marker& add(std::string_view kind, int id, int type) {
    if (count_ == to_.markers.size()) {
      to_.markers.emplace_back();
    }
    Marker& made = to_.markers[count_++];
    made.header = header_;
    made.ns = kind;
    made.id = id;
    made.type = type;
    made.action = Marker::kAdd;
    made.pose = {};
    made.scale = {1.0, 1.0, 1.0};
    made.color = {};
    made.points.clear();
    made.text.clear();
    return made;
  }
  /// Deletes all previous markers.
  void addDeleteAll() { add("", 0, Marker::kArrow).action = Marker::kDeleteall; }

 private:
  MarkerArray& to_;
  std_msgs::Header header_;
  std::size_t count_ = 0;
};

geometry_msgs::Point pointOf(const base::Vec2& point, double height) {
  return {point.x(), point.y(), height};
}

struct Body {
  Kind kind;
  int id = 0;
  std::string_view name;
  base::Pose2 pose;
  base::Vec2 velocity = base::Vec2::Zero();
  double radius = 0.35, height = 1.7;  // [m]
  std_msgs::ColorRGBA color;
};

void addBody(Markers& to, const Body& body) {
  Marker& cylinder = to.add(body.kind.body, body.id, Marker::kCylinder);
  cylinder.pose = poseOf(body.pose);
  cylinder.pose.position.z = body.height / 2.0;
  cylinder.scale = {2.0 * body.radius, 2.0 * body.radius, body.height};
  cylinder.color = body.color;
  if (body.velocity.norm() > kSlowest) {
    Marker& arrow = to.add(body.kind.velocity, body.id, Marker::kArrow);
    const double height = body.height + kArrowHead;
    arrow.points = {pointOf(body.pose.position, height),
                    pointOf(body.pose.position + body.velocity, height)};  // distance in 1 s
    arrow.scale = {kArrowShaft, kArrowHead, 0.0};
    arrow.color = kArrowColor;
  }
  Marker& text = to.add(body.kind.name, body.id, Marker::kTextViewFacing);
  text.pose = poseOf(body.pose.position);
  text.pose.position.z = body.height + kTextGap;
  text.scale.z = kTextSize;
  text.color = kTextColor;
  text.text = body.name;
}

Marker& addOutline(Markers& to, std::string_view kind, int id,
                   const std::vector<base::Vec2>& points, const std_msgs::ColorRGBA& color) {
  Marker& line = to.add(kind, id, Marker::kLineStrip);
  line.scale.x = kLineWidth;
  line.color = color;
  for (std::size_t k = 0; k <= points.size() && !points.empty(); ++k) {
    line.points.push_back(pointOf(points[k % points.size()], 0.0));
  }
  return line;
}

void addPeople(Markers& to, const sim2d::TraceHeader& header, const sim2d::Frame& frame) {
  const sim2d::HumanColumns& humans = frame.humans;
  for (std::size_t k = 0; k < humans.size(); ++k) {
    const sim2d::TraceHuman* const human = humanOf(header, humans, k);
    const std::string number = human != nullptr ? "" : std::to_string(humans.id[k]);
    Body body;
    body.kind = kPeople;
    body.id = humans.id[k];
    body.name = human != nullptr ? human->name : number;
    body.pose = poseIn(humans, k);
    body.velocity = {humans.vx[k], humans.vy[k]};
    body.radius = human != nullptr ? human->radius : body.radius;
    body.height = kPersonHeight;
    body.color = humans.state[k] != 0 ? kActiveColor : kPersonColor;
    addBody(to, body);
  }
}

void addRobots(Markers& to, const sim2d::TraceHeader& header, const sim2d::Frame& frame) {
  const sim2d::RobotColumns& robots = frame.robots;
  for (std::size_t k = 0; k < robots.size() && k < header.robots.size(); ++k) {
    const sim2d::TraceRobot& robot = header.robots[k];
    Body body;
    body.kind = kRobots;
    body.id = robots.id[k];
    body.name = robot.name;
    body.pose = poseIn(robots, k);
    body.velocity = {robots.vx[k], robots.vy[k]};
    body.radius = robot.radius;
    body.height = kRobotHeight;
    body.color = kRobotColor;
    addBody(to, body);
    if (!robot.footprint.empty()) {
      addOutline(to, "robots/footprint", body.id, robot.footprint, kRobotColor).pose =
          poseOf(body.pose);
    }
  }
}

void addObstacles(Markers&& to, const sim2d::TraceHeader& header, const sim2d::Frame& frame) {
  to.addDeleteAll();
  std::size_t door = 0;
  for (const sim2d::TraceObstacle& obstacle : header.obstacles) {
    const bool isOpen = obstacle.isDoor &&
                        (door < frame.doorOpen.size() ? frame.doorOpen[door] != 0 : obstacle.open);
    door += obstacle.isDoor ? 1 : 0;
    if (obstacle.name == "map" || isOpen) {
      continue;
    }
    int id = 0;
    for (const sim2d::Outline& outline : obstacle.outlines) {
      addOutline(to, obstacle.name, id++, outline.points,
                 obstacle.isDoor ? kDoorColor : kWallColor);
    }
  }
}

}  // namespace

void setBodyMarkers(const sim2d::TraceHeader& header, const sim2d::Frame& frame, MarkerArray& to) {
  to.markers.reserve(1 + 3 * frame.humans.size() + 4 * frame.robots.size());
  Markers markers(to, frame.time);
  markers.addDeleteAll();
  addPeople(markers, header, frame);
  addRobots(markers, header, frame);
}

MarkerArray obstacleMarkersOf(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                              double seconds) {
  MarkerArray all;
  addObstacles(Markers(all, seconds), header, frame);
  return all;
}

}  // namespace bridge
