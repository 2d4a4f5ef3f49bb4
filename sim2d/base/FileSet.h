#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace base {

struct FileContent {
  std::string path;
  std::string content;
};

/// writeFileAtomically (Text.h) for files that belong together: all are written beside their places
/// before the first one is put there; when one cannot be, those before it are put back as they
/// were. Empty = written.
Diagnostics writeFilesTogether(const std::vector<FileContent>& files);

}  // namespace base
