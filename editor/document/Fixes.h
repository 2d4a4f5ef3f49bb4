#pragma once

#include <functional>
#include <optional>

#include <QString>

#include "editor/document/ScenarioDocument.h"

namespace editor {

/// A way to mend a problem: the words of its button and one undoable step. Without `apply` it needs
/// a hand: the button opens the assignment of goals.
struct Fix {
  QString words;
  std::function<void(ScenarioDocument&)> apply;
};

/// How to mend a problem that checkScenario() told of this document; nothing for those that only a
/// person can solve. Cheap: walls are looked at by `apply` alone.
std::optional<Fix> fixFor(const ScenarioDocument& document, const base::Diagnostic& problem);

/// Mends all problems whose fix has these words as one undoable step. Each sees what the ones
/// before have done.
void applyToAll(ScenarioDocument& document, const base::Diagnostics& problems,
                const QString& words);

/// What an editor may point at beside the errors: a scenario of people without a robot.
base::Diagnostics adviceFor(const sim2d::Scenario& scenario);

}  // namespace editor
