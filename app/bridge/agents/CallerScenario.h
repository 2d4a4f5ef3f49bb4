#pragma once

#include <memory>

#include "app/bridge/messages/hunav_msgs.h"
#include "app/run/Bundle.h"
#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace bridge {

/// The loaded scenario adapted to the agents of a caller. The properties in the caller's first
/// request take precedence, as in HuNavSim: desired velocity, radius, group, goals, force factors.
/// The behavior trees come from the scenario, by agent id. An agent that is not in the scenario is
/// added with the properties in the message and the tree of its behavior, and is reported in
/// `remarks`. The result has no robots. Of the variation only reaction times apply; all other
/// values come from the caller.
sim2d::Scenario scenarioForCaller(const sim2d::Scenario& served, const hunav_msgs::Agents& agents,
                                  base::Diagnostics& remarks);

/// The scenario of a bundle with its key `variation` applied for its seed: starts, headings, speeds
/// and the order of goals are those of a run with that seed. Factors of reaction times have no key
/// and are drawn later (`onlyReactionTimes`). Start times are not used in the world of a caller.
/// Without variation the scenario is returned unchanged. Errors: no world can be created from it.
base::Result<std::shared_ptr<const sim2d::Scenario>> drawnScenario(const app::Bundle& bundle);

/// The variation without the values that requests contain and those that are already drawn.
sim2d::VariationSettings onlyReactionTimes(sim2d::VariationSettings variation);

}  // namespace bridge
