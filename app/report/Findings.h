#pragma once

#include <string>

#include "app/report/Comparison.h"

namespace report {

/// What a comparison says, in a sentence of markup; empty: nothing was compared.
/// "Path length: best is dwa (7.1 m), better than pursuit; not clearly different from mppi."
std::string findingMarkup(const Study& study, const MetricComparison& comparison);

}  // namespace report
