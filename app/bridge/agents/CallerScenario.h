#pragma once

#include "app/bridge/messages/HunavMessages.h"
#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace bridge {

/// The scenario that is served, for the people of a caller. What the caller says of each agent in
/// its first request counts, as in HuNavSim: desired velocity, radius, group, goals, force factors.
/// What the agents do, their trees, is as the scenario has it, by id. Somebody whom the scenario
/// does not know is added as the message describes them, with the tree of their behaviour, and
/// reported in `remarks`. Without robots; of the variation only reaction times apply, everything
/// else is the caller's.
sim2d::Scenario scenarioFor(const sim2d::Scenario& served, const hunav_msgs::Agents& agents,
                            base::Diagnostics& remarks);

}  // namespace bridge
