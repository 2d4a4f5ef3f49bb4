#pragma once

#include "sim2d/base/Files.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

/// Contents of the files of a recording; paths are used in messages.
struct TraceTexts {
  base::FileContent trajectory, events, header;
};

/// As readTrace (Trace.h), from memory.
base::Result<Trace> parseTrace(const TraceTexts& texts);

}  // namespace sim2d
