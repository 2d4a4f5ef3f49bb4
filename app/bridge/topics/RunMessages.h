#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/BasicMessages.h"
#include "app/bridge/messages/GeometryMessages.h"
#include "app/bridge/messages/HunavMessages.h"
#include "app/bridge/messages/NavigationMessages.h"
#include "sim2d/trace/Trace.h"

/// States of a run as messages. Pure functions of the header of the record and of a frame; any
/// thread. World frame of ours = frame "map" of theirs, z = 0; stamps are simulation time.
namespace bridge {

constexpr const char* kMapFrame = "map";

std::int64_t nanosecondsOf(double seconds);  // rounded
builtin_interfaces::Time stampOf(double seconds);
double secondsOf(const builtin_interfaces::Time& stamp);
std_msgs::Header headerOf(double seconds, const std::string& frame = kMapFrame);

geometry_msgs::Quaternion turnOf(double heading);  // about z, [rad]
/// Of the record; null: it does not have that one. Mostly they stand there in the same order.
const sim2d::TraceHuman* humanOf(const sim2d::TraceHeader& header,
                                 const sim2d::HumanColumns& humans, std::size_t at);
double headingOf(const geometry_msgs::Quaternion& q);  // about z, (-pi, pi]
geometry_msgs::Pose poseOf(const base::Pose2& pose);
geometry_msgs::Pose poseOf(const base::Vec2& point);  // not turned
geometry_msgs::Transform transformOf(const base::Pose2& pose);

/// Of one body of a frame.
base::Pose2 poseIn(const sim2d::BodyColumns& bodies, std::size_t at);

/// The people in the world, with what is known of them; goals from the current one on. What a
/// record does not have (skin, closest_obs) is empty. Into the message of a state before, whose
/// memory is used again, or into an empty one.
void setAgents(const sim2d::TraceHeader& header, const sim2d::Frame& frame, hunav_msgs::Agents& to);
/// The robot at this place in the frame; type ROBOT, goals from the current one on.
hunav_msgs::Agent robotOf(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                          std::size_t robot);
/// position.z = heading, velocity = (vx, vy, turning), as HuNavSim fills them. Into a message of
/// before, or an empty one.
void setPeople(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
               people_msgs::People& to);

/// The pose is `believed` (in the frame "odom"), the twist in the robot's frame.
nav_msgs::Odometry odometryOf(const sim2d::Frame& frame, std::size_t robot,
                              const base::Pose2& believed, const std::string& odometryFrame,
                              const std::string& robotFrame);
/// Beams without a hit are +inf, as ROS has them.
sensor_msgs::LaserScan scanOf(const sim2d::RobotSenses::Scan& scan, double period,
                              const std::string& sensorFrame);
nav_msgs::OccupancyGrid mapOf(const sim2d::OccupancyGrid& grid);
nav_msgs::Path pathOf(const std::vector<base::Vec2>& points, double seconds);
geometry_msgs::PoseStamped goalOf(const base::Vec2& goal, double seconds);

}  // namespace bridge
