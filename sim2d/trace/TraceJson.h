#pragma once

#include <string>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// Reads the text of trace.json; `file` is named in the problems.
base::Result<TraceHeader> parseTraceJson(const std::string& text, const std::string& file);

}  // namespace sim2d
