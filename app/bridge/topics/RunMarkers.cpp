#include "app/bridge/topics/RunMarkers.h"

#include <algorithm>
#include <string>
#include <string_view>
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
