#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bridge/messages/Time.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/messages/rcl_interfaces.h"
#include "app/bridge/messages/tf2_msgs.h"
#include "app/bridge/messages/visualization_msgs.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/CoupledWorld.h"

/// Conversion between hunav_msgs/Agent and the agents of a world; messages of a step.
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

/// The messages that HuNavSim's agent manager publishes after each step but the first, in this
/// order: the state in the request, i.e. before the step, with the request's stamp and frame.
struct StepMessages {
  std::vector<tf2_msgs::TFMessage> transforms;  // one per body: robot, then people; frame -> name
  visualization_msgs::MarkerArray forces;       // sfm_forces
  hunav_msgs::Agents humans;                    // human_states
  hunav_msgs::Agent robot;                      // robot_states
  people_msgs::People people;                   // people
};

/// The state of a request, and the forces of the world's last step.
StepMessages topicsOf(hunav_msgs::Agents agents, hunav_msgs::Agent robot,
                      const sim2d::CoupledWorld& world);

/// The data of a scenario that HuNavSim's loader and its wrappers' world generators provide.

/// The parameters of the node `hunav_loader`, with exactly the types that the world generators
/// request. Force factors and reactions are those drawn for `seed`.
std::vector<rcl_interfaces::Parameter> loaderParameters(const sim2d::Scenario& scenario,
                                                        long long seed);

/// The response of the service `get_parameters`. It contains goals 1, 2, 3 … up to the first gap,
/// as in the original.
hunav_msgs::GetParameters::Response loaderSummary(const sim2d::Scenario& scenario);

/// The response of the service `get_agents`: all agents at their starts, in the frame `map`.
hunav_msgs::GetAgents::Response agentsAtStart(const sim2d::Scenario& scenario, long long seed);

// Creates a parameter.
rcl_interfaces::Parameter parameter(std::string name, bool value);
rcl_interfaces::Parameter parameter(std::string name, std::int64_t value);
rcl_interfaces::Parameter parameter(std::string name, double value);
rcl_interfaces::Parameter parameter(std::string name, std::string value);

}  // namespace bridge
