#pragma once

#include <optional>
#include <string>

#include "app/bridge/messages/Time.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "sim2d/world/CoupledWorld.h"

/// Conversion between hunav_msgs/Agent and the agents of a world.
namespace bridge {

/// The reason why the state of an agent is invalid ("yaw is not finite"); empty: valid. Limits:
/// positions 1e6 m, velocities 1000 m/s.
std::string invalidReason(const hunav_msgs::Agent& agent);

/// The fields that are read in each request: position, yaw, velocity, obstacle points in the plane.
/// linear_vel, angular_vel and the orientation are ignored, as in HuNavSim.
sim2d::CoupledPerson personOf(const hunav_msgs::Agent& agent);
/// Nothing: the caller has no robot yet (type 0 and an empty name).
std::optional<sim2d::CoupledRobot> robotOf(const hunav_msgs::Agent& robot);

/// Sets all fields but state and configuration.
void setBehavior(const sim2d::ResolvedHuman& person, hunav_msgs::AgentBehavior& to);

/// `asked` with the current state of the agent in the world. Height, skin and group keep the
/// received values; obstacle points are removed. The goals are kept if the agent has none left,
/// because the Gazebo Fortress wrapper reads the first one unconditionally.
hunav_msgs::Agent responseFor(const hunav_msgs::Agent& asked, const sim2d::CoupledWorld& world,
                              int human);

/// A rotation about z by `yaw` [rad].
geometry_msgs::Quaternion quaternionOf(double yaw);

}  // namespace bridge
