#pragma once

#include <string>
#include <vector>

#include "app/report/Study.h"

namespace report {

/// The section on methods, as markup: what was done and by whom it was described, what it was done
/// with, and the commands. `blocks`: how many there are; `command`: the words that ask for this
/// report.
std::string methodsMarkup(const Study& study, std::size_t blocks,
                          const std::vector<std::string>& command);

}  // namespace report
