#pragma once

#include <string>
#include <vector>

#include "app/studies/SearchStudy.h"

namespace report {

/// The page of a search that covers behaviour trees: the trees with what was never reached, the
/// runs that reached a node first with the commands that play them, all nodes with their first run,
/// and the course of the search. `command`: the command line of the search. The output is
/// deterministic.
std::string coveragePage(const app::SearchStudy& study, const std::vector<std::string>& command);

}  // namespace report
