#pragma once

#include "sim2d/base/Result.h"

namespace app {

/// Returns `some` without diagnostics for which `all` contains an equivalent one: reading, trees
/// and world creation report some problems that the scenario check also reports, with other text.
base::Diagnostics withoutDuplicates(const base::Diagnostics& some, const base::Diagnostics& all);

/// Returns the diagnostics of `more` whose text does not occur in `reported`.
base::Diagnostics newDiagnostics(const base::Diagnostics& reported, const base::Diagnostics& more);

}  // namespace app
