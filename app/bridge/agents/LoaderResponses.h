#pragma once

#include <vector>

#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/rcl_interfaces.h"
#include "sim2d/scenario/Scenario.h"

namespace bridge {

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
