#pragma once

#include "sim2d/base/Files.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

/// The files of a record by their texts; the paths name them in problems.
struct TraceTexts {
  base::FileContent trajectory, events, header;
};

/// The same as readTrace (Trace.h) of texts that are in memory.
base::Result<Trace> parseTrace(const TraceTexts& texts);

}  // namespace sim2d
