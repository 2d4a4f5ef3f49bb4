#pragma once

#include "editor/document/ScenarioDocument.h"

namespace editor {

/// A fix for a problem: the label of its button and one undoable step. Without `apply` the fix is
/// manual: the button opens the goal assignment.
struct Fix {
  QString label;
  std::function<void(ScenarioDocument&)> apply;
};

/// The fix for a problem that checkScenario() reported for this document; none if the user must
/// decide. The call is cheap: only `apply` examines walls.
std::optional<Fix> fixFor(const ScenarioDocument& document, const base::Diagnostic& problem);

/// Fixes all problems with this label as one undoable step. Each fix sees the results of the
/// previous ones.
void applyToAll(ScenarioDocument& document, const base::Diagnostics& problems,
                const QString& label);

/// Hints in addition to the errors: a scenario with people but without a robot.
base::Diagnostics adviceFor(const sim2d::Scenario& scenario);

}  // namespace editor
