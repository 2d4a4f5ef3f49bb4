#pragma once

#include "app/report/Study.h"

namespace report {

/// What is compared, in which cases, by which metrics: fills in all of `study` that follows from
/// its results, what is drawn, and the wishes. Errors: wishes that it cannot have.
base::Diagnostics chooseCompared(const Wishes& wishes, Study& study);

}  // namespace report
