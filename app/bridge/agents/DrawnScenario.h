#pragma once

#include <memory>

#include "app/run/Bundle.h"
#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace bridge {

/// The scenario of a bundle with the values that its key `variation` draws for its seed: starts,
/// headings, speeds and the order of goals are those of a run with that seed. Factors of reaction
/// times have no key and are drawn later (`reactionTimesAlone`); start times are not used in the
/// world of a caller. Without variation the scenario is returned unchanged. Errors: no world can be
/// made of it.
base::Result<std::shared_ptr<const sim2d::Scenario>> drawnScenario(const app::Bundle& bundle);

/// The variation without the values that requests contain and those that are already drawn.
sim2d::VariationSettings reactionTimesAlone(sim2d::VariationSettings variation);

}  // namespace bridge
