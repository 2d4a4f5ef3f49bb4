#pragma once

#include <string>
#include <vector>

#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/messages/tf2_msgs.h"
#include "app/bridge/messages/visualization_msgs.h"
#include "sim2d/world/CoupledWorld.h"

namespace bridge {

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

}  // namespace bridge
