#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/Result.h"

/// Git LFS keeps a small text in the place of a large file until the file is fetched.
namespace base {

/// By its first bytes, whatever the file is called.
inline bool isLfsPointer(std::string_view begin) {
  constexpr std::string_view kBegin = "version https://git-lfs";
  return begin.substr(0, kBegin.size()) == kBegin;
}

/// For readers that do not read by readTextFile (Text.h), which looks itself. Empty: the file is no
/// pointer, or cannot be read.
Diagnostics lfsPointerProblem(const std::string& path);

}  // namespace base
