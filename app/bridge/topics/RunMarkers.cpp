#include "app/bridge/topics/RunMarkers.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/topics/RunMessages.h"

namespace bridge {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kPersonHeight = 1.7, kRobotHeight = 0.5;  // [m]
constexpr double kTextSize = 0.3, kTextGap = 0.3;          // [m]
constexpr double kArrowShaft = 0.06, kArrowHead = 0.14;    // [m]
constexpr double kLineWidth = 0.05;                        // [m]
constexpr double kSlowest = 0.05;                          // [m/s] that have an arrow

constexpr std_msgs::ColorRGBA kPersonColor{0.16F, 0.44F, 0.78F, 0.9F};
constexpr std_msgs::ColorRGBA kActiveColor{0.90F, 0.49F, 0.13F, 0.9F};  // a reaction runs
constexpr std_msgs::ColorRGBA kRobotColor{0.20F, 0.60F, 0.33F, 0.9F};
constexpr std_msgs::ColorRGBA kArrowColor{0.25F, 0.25F, 0.25F, 0.9F};
constexpr std_msgs::ColorRGBA kTextColor{0.55F, 0.55F, 0.55F, 1.0F};  // on light and dark ground
constexpr std_msgs::ColorRGBA kWallColor{0.35F, 0.35F, 0.40F, 1.0F};
constexpr std_msgs::ColorRGBA kDoorColor{0.62F, 0.42F, 0.20F, 1.0F};

/// Valid until the next one is added.
Marker& addMarker(MarkerArray& to, double seconds, std::string kind, int id, int type) {
  Marker& made = to.markers.emplace_back();
  made.header = headerOf(seconds);
  made.ns = std::move(kind);
  made.id = id;
  made.type = type;
  made.action = Marker::kAdd;
  made.scale = {1.0, 1.0, 1.0};
  return made;
}

/// All of before goes.
void addEraser(MarkerArray& to, double seconds) {
  addMarker(to, seconds, "", 0, Marker::kArrow).action = Marker::kDeleteall;
}

geometry_msgs::Point pointOf(const base::Vec2& point, double height) {
  return {point.x(), point.y(), height};
}

struct Body {
  std::string kind;  // "people", "robots"
  int id = 0;
  std::string name;
  base::Pose2 pose;
  base::Vec2 velocity = base::Vec2::Zero();
  double radius = 0.35, height = 1.7;  // [m]
  std_msgs::ColorRGBA color;
};

void addBody(MarkerArray& to, double seconds, const Body& body) {
  Marker& cylinder = addMarker(to, seconds, body.kind, body.id, Marker::kCylinder);
  cylinder.pose = poseOf(body.pose);
  cylinder.pose.position.z = body.height / 2.0;
  cylinder.scale = {2.0 * body.radius, 2.0 * body.radius, body.height};
  cylinder.color = body.color;
  if (body.velocity.norm() > kSlowest) {
    Marker& arrow = addMarker(to, seconds, body.kind + "/velocity", body.id, Marker::kArrow);
    const double height = body.height + kArrowHead;
    arrow.points = {pointOf(body.pose.position, height),
                    pointOf(body.pose.position + body.velocity, height)};  // a second's way
    arrow.scale = {kArrowShaft, kArrowHead, 0.0};
    arrow.color = kArrowColor;
  }
  Marker& text = addMarker(to, seconds, body.kind + "/name", body.id, Marker::kTextViewFacing);
  text.pose = poseOf(body.pose.position);
  text.pose.position.z = body.height + kTextGap;
  text.scale.z = kTextSize;
  text.color = kTextColor;
  text.text = body.name;
}

Marker& addOutline(MarkerArray& to, double seconds, const std::string& kind, int id,
                   const std::vector<base::Vec2>& points, const std_msgs::ColorRGBA& color) {
  Marker& line = addMarker(to, seconds, kind, id, Marker::kLineStrip);
  line.scale.x = kLineWidth;
  line.color = color;
  for (std::size_t k = 0; k <= points.size() && !points.empty(); ++k) {
    line.points.push_back(pointOf(points[k % points.size()], 0.0));
  }
  return line;
}

void addPeople(MarkerArray& to, const sim2d::TraceHeader& header, const sim2d::Frame& frame) {
  const sim2d::HumanColumns& humans = frame.humans;
  for (std::size_t k = 0; k < humans.size(); ++k) {
    const sim2d::TraceHuman* const human = humanOf(header, humans, k);
    Body body;
    body.kind = "people";
    body.id = humans.id[k];
    body.name = human != nullptr ? human->name : std::to_string(humans.id[k]);
    body.pose = poseIn(humans, k);
    body.velocity = {humans.vx[k], humans.vy[k]};
    body.radius = human != nullptr ? human->radius : body.radius;
    body.height = kPersonHeight;
    body.color = humans.state[k] != 0 ? kActiveColor : kPersonColor;
    addBody(to, frame.time, body);
  }
}

void addRobots(MarkerArray& to, const sim2d::TraceHeader& header, const sim2d::Frame& frame) {
  const sim2d::RobotColumns& robots = frame.robots;
  for (std::size_t k = 0; k < robots.size() && k < header.robots.size(); ++k) {
    const sim2d::TraceRobot& robot = header.robots[k];
    Body body;
    body.kind = "robots";
    body.id = robots.id[k];
    body.name = robot.name;
    body.pose = poseIn(robots, k);
    body.velocity = {robots.vx[k], robots.vy[k]};
    body.radius = robot.radius;
    body.height = kRobotHeight;
    body.color = kRobotColor;
    addBody(to, frame.time, body);
    if (!robot.footprint.empty()) {
      addOutline(to, frame.time, "robots/footprint", body.id, robot.footprint, kRobotColor).pose =
          poseOf(body.pose);
    }
  }
}

}  // namespace

MarkerArray bodyMarkersOf(const sim2d::TraceHeader& header, const sim2d::Frame& frame) {
  MarkerArray all;
  all.markers.reserve(1 + 3 * frame.humans.size() + 4 * frame.robots.size());
  addEraser(all, frame.time);
  addPeople(all, header, frame);
  addRobots(all, header, frame);
  return all;
}

MarkerArray obstacleMarkersOf(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                              double seconds) {
  MarkerArray all;
  addEraser(all, seconds);
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
      addOutline(all, seconds, obstacle.name, id++, outline.points,
                 obstacle.isDoor ? kDoorColor : kWallColor);
    }
  }
  return all;
}

}  // namespace bridge
