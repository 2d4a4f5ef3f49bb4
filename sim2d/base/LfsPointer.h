#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/Result.h"

/// Git LFS stores a short text file instead of a large one until the large one is fetched.
namespace base {

/// By its first bytes, whatever the file is called.
inline bool isLfsPointer(std::string_view begin) {
  constexpr std::string_view kBegin = "version https://git-lfs";
  return begin.substr(0, kBegin.size()) == kBegin;
}

/// For readers that do not use readTextFile (Text.h), which checks this. Empty: the file is no
/// pointer, or cannot be read.
Diagnostics lfsPointerProblem(const std::string& path);

}  // namespace base
