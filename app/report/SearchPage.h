#pragma once

#include <string>
#include <vector>

#include "app/studies/SearchStudy.h"

namespace report {

/// The page of a search: its failures with the commands that play them, the archive as a map of
/// cells, and the course of the search. `folder`: of the results, as the user names it; `command`:
/// the command line of the search. The output is deterministic.
std::string searchPage(const app::SearchStudy& study, const std::string& folder,
                       const std::vector<std::string>& command);

}  // namespace report
