#pragma once

#include <string>
#include <vector>

#include "app/bridge/messages/HunavServices.h"
#include "app/bridge/messages/MarkerMessages.h"
#include "sim2d/world/CoupledWorld.h"

namespace bridge {

/// What HuNavSim's manager publishes with each step but the first: the state of the request, which
/// is that before the step, under the request's stamp and frame. In this order.
struct StepTopics {
  std::vector<tf2_msgs::TFMessage> transforms;  // one each: robot, then people; frame -> name
  visualization_msgs::MarkerArray forces;       // sfm_forces
  hunav_msgs::Agents humans;                    // human_states
  hunav_msgs::Agent robot;                      // robot_states
  people_msgs::People people;                   // people
};

/// State of a request; forces of the world's last step.
StepTopics topicsOf(hunav_msgs::Agents agents, hunav_msgs::Agent robot,
                    const sim2d::CoupledWorld& world);

}  // namespace bridge
