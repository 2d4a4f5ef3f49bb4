#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace app {

/// The report as a person reads it: what is said of several people in the same words is one line,
/// "7 people: start_time is not known there".
struct ReportLine {
  base::Diagnostic said;
  std::vector<std::string> people;  // whom it is about, when they are several
};
std::vector<ReportLine> groupedByPeople(const base::Diagnostics& report);

}  // namespace app
