#pragma once

#include <string>
#include <vector>

#include "metrics/RobotPlaces.h"
#include "sim2d/trace/Trace.h"

namespace report {

/// The skeleton with its holes filled; `withPlayer`: its script too.
std::string wholePage(const std::string& title, const std::string& body, bool withPlayer);
/// The player's box and the runs' data, JSON each.
std::string playerMarkup(const std::vector<std::string>& runs);

/// A page that plays one run; `contacts` as for playerJson().
std::string playerPage(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const std::string& title);

}  // namespace report
