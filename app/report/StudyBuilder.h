#pragma once

#include "app/report/Study.h"

namespace report {

/// Selects the compared options, cases and metrics: sets all members of `study` that follow from
/// its results, the drawn values and the command line options. Errors: invalid options.
base::Diagnostics selectCompared(const StudyOptions& studyOptions, Study& study);

}  // namespace report
