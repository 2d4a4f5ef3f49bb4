#pragma once

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Trace.h"

/// What is shown of entities while a run is shown: the values of the run, and those that the user
/// has edited since its start, which apply at the next start.
namespace editor {

/// The entity with the values of the shown run where the user has not edited them since its start.
/// Without a run: as it is.
Entity withRunValues(const ScenarioDocument& document, Entity entity);

/// By the behaviour in the shown run; without a run, or for a person who is not in it, by that of
/// the document.
Look shownLookOf(const ScenarioDocument& document, const sim2d::Human& human);

/// The ids of the people with custom trees in a run.
std::set<int> customTreesOf(const sim2d::TraceHeader& run);

}  // namespace editor
