#pragma once

#include <memory>

#include "app/run/Bundle.h"
#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace bridge {

/// The scenario of a bundle with what its key `variation` draws for its seed written into it, as a
/// run of that seed has its people: starts, headings, speeds and the order of goals. Factors of
/// reaction times have no key and stay to be drawn (`reactionTimesAlone`); start times have no part
/// in the world of a caller. Without variation it is the scenario as it is. Errors: no world can be
/// made of it.
base::Result<std::shared_ptr<const sim2d::Scenario>> drawnScenario(const app::Bundle& bundle);

/// The variation without what requests contain or what is already drawn.
sim2d::VariationSettings reactionTimesAlone(sim2d::VariationSettings variation);

}  // namespace bridge
