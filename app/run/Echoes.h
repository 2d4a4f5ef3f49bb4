#pragma once

#include "sim2d/base/Result.h"

namespace app {

/// Some of all problems, without those that another of all tells too: reading, trees and the
/// beginning of a run find in their words what the check of the scenario finds.
base::Diagnostics withoutEchoes(const base::Diagnostics& some, const base::Diagnostics& all);

/// Those of `more` whose lines are not among the `told`.
base::Diagnostics notYetTold(const base::Diagnostics& told, const base::Diagnostics& more);

}  // namespace app
