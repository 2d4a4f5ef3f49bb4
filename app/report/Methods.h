#pragma once

#include <string>

#include "app/report/Study.h"

namespace report {

/// Versions, input files with hashes, seeds and drawn values of a study, as entries of a <dl>.
std::string factsMarkup(const Study& study);

}  // namespace report
