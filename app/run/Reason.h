#pragma once

#include <exception>
#include <new>
#include <string>

#include "sim2d/base/JsonText.h"

namespace app {

/// What went wrong that nobody foresaw, in words.
inline std::string reasonOf(const std::exception& problem) {
  return dynamic_cast<const std::bad_alloc*>(&problem) != nullptr
             ? "not enough memory"
             : base::jsonReason(problem.what());
}

}  // namespace app
