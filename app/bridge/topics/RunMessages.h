#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/messages/Time.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/messages/sensor_msgs.h"
#include "app/bridge/messages/visualization_msgs.h"
#include "sim2d/trace/Trace.h"

/// Conversion of run states to messages. Pure functions of the trace header and a frame;
/// thread-safe. The world frame is the ROS frame "map", z = 0. Stamps are simulation time.
namespace bridge {

constexpr const char* kMapFrame = "map";

/// The parameters of a person with a reaction, as they are named in traces.
struct BehaviorParameter {
  std::string_view key;
  float hunav_msgs::AgentBehavior::*member;
};
constexpr BehaviorParameter kBehaviorParameters[] = {
    {"duration", &hunav_msgs::AgentBehavior::duration},
    {"vel", &hunav_msgs::AgentBehavior::vel},
    {"dist", &hunav_msgs::AgentBehavior::dist},
    {"goal_force_factor", &hunav_msgs::AgentBehavior::goalForceFactor},
    {"obstacle_force_factor", &hunav_msgs::AgentBehavior::obstacleForceFactor},
    {"social_force_factor", &hunav_msgs::AgentBehavior::socialForceFactor},
    {"other_force_factor", &hunav_msgs::AgentBehavior::otherForceFactor}};

std::int64_t nanosecondsOf(double seconds);  // rounded
builtin_interfaces::Time stampOf(double seconds);
std_msgs::Header headerOf(double seconds, const std::string& frame = kMapFrame);

geometry_msgs::Quaternion quaternionFromYaw(double heading);  // rotation about z [rad]
/// The header entry of a person; null: none. Usually both are in the same order.
const sim2d::TraceHuman* humanOf(const sim2d::TraceHeader& header,
                                 const sim2d::HumanColumns& humans, std::size_t at);
double headingOf(const geometry_msgs::Quaternion& q);  // yaw, (-pi, pi]
geometry_msgs::Pose poseOf(const base::Pose2& pose);
geometry_msgs::Pose poseOf(const base::Vec2& point);  // identity rotation
geometry_msgs::Transform transformOf(const base::Pose2& pose);

/// The pose of one body of a frame.
base::Pose2 poseIn(const sim2d::BodyColumns& bodies, std::size_t at);

/// Fills in the people of a frame; goals start with the current one. Fields that the trace does not
/// contain (skin, closest_obs) are empty. Reuses the memory of `to`, which is a previous message or
/// empty.
void setAgents(const sim2d::TraceHeader& header, const sim2d::Frame& frame, hunav_msgs::Agents& to);
/// The robot with this index in the frame. Its type is ROBOT; goals start with the current one.
hunav_msgs::Agent robotOf(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                          std::size_t robot);
/// position.z = heading, velocity = (vx, vy, omega), as HuNavSim fills them in. Reuses the memory
/// of `to`.
void setPeople(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
               people_msgs::People& to);

/// `estimatedPose`: the pose in the frame "odom". The twist is in the robot's frame.
nav_msgs::Odometry odometryOf(const sim2d::Frame& frame, std::size_t robot,
                              const base::Pose2& estimatedPose, const std::string& odometryFrame,
                              const std::string& robotFrame);
/// Beams without a hit are +inf, as in ROS.
sensor_msgs::LaserScan scanOf(const sim2d::RobotTelemetry::Scan& scan, double period,
                              const std::string& sensorFrame);
nav_msgs::OccupancyGrid mapOf(const sim2d::OccupancyGrid& grid);
nav_msgs::Path pathOf(const std::vector<base::Vec2>& points, double seconds);
geometry_msgs::PoseStamped goalOf(const base::Vec2& goal, double seconds);

/// Markers of all people and robots: a body, a velocity arrow, a name; robots also have their
/// footprint. The first marker deletes the previous ones, so each message is complete. Reuses the
/// memory of `to`, which is a previous message or empty.
void setBodyMarkers(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                    visualization_msgs::MarkerArray& to);
/// Outlines of the obstacles other than the map's walls, with doors as in the frame. `seconds`:
/// time stamp.
visualization_msgs::MarkerArray obstacleMarkersOf(const sim2d::TraceHeader& header,
                                                  const sim2d::Frame& frame, double seconds);

}  // namespace bridge
