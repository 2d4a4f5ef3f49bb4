#pragma once

#include <vector>

#include "app/bridge/messages/HunavServices.h"
#include "app/bridge/messages/ParameterMessages.h"
#include "sim2d/scenario/Scenario.h"

namespace bridge {

/// What HuNavSim's loader and the world generators of its wrappers tell of a scenario.

/// The parameters of the node `hunav_loader`: their types are exactly those that the generators
/// ask for. Force factors and reactions as they were drawn for `seed`.
std::vector<rcl_interfaces::Parameter> loaderParameters(const sim2d::Scenario& scenario,
                                                        long long seed);

/// Of the service `get_parameters`; goals 1, 2, 3 … up to the first gap, as the original.
hunav_msgs::GetParameters::Response loaderSummary(const sim2d::Scenario& scenario);

/// Of the service `get_agents`: all agents at their starts, in the frame `map`.
hunav_msgs::GetAgents::Response agentsAtStart(const sim2d::Scenario& scenario, long long seed);

// Values of parameters.
rcl_interfaces::Parameter parameter(std::string name, bool value);
rcl_interfaces::Parameter parameter(std::string name, std::int64_t value);
rcl_interfaces::Parameter parameter(std::string name, double value);
rcl_interfaces::Parameter parameter(std::string name, std::string value);

}  // namespace bridge
