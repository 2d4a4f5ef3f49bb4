#pragma once

#include <optional>
#include <string>

#include "app/bridge/messages/HunavMessages.h"
#include "sim2d/world/CoupledWorld.h"

/// Between hunav_msgs/Agent and the people of a world.
namespace bridge {

/// What cannot be used of the state of an agent ("yaw is not finite"); empty: it is fine.
/// Places up to 1e6 m, velocities up to 1000 m/s.
std::string faultOf(const hunav_msgs::Agent& agent);

/// The fields that are truth in each request: position, yaw, velocity, obstacle points in the plane.
/// linear_vel, angular_vel and the orientation are not read, as in HuNavSim.
sim2d::CoupledPerson personOf(const hunav_msgs::Agent& agent);
/// Nothing: the caller has no robot yet (type 0 and no name).
std::optional<sim2d::CoupledRobot> robotOf(const hunav_msgs::Agent& robot);

/// `asked` with the state that the person has in the world now, so height, skin and group are those
/// that came; obstacle points are left out. Goals stay when the person has none left: Gazebo Fortress
/// reads the first one without looking.
hunav_msgs::Agent answerFor(const hunav_msgs::Agent& asked, const sim2d::CoupledWorld& world,
                            int human);

/// Of a turn about z [rad].
geometry_msgs::Quaternion quaternionOf(double yaw);
std::int64_t nanosecondsOf(const builtin_interfaces::Time& stamp);

}  // namespace bridge
