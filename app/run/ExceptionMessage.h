#pragma once

#include <exception>
#include <new>
#include <string>

#include "sim2d/base/JsonText.h"

namespace app {

/// The message of an unexpected exception.
inline std::string exceptionMessage(const std::exception& problem) {
  return dynamic_cast<const std::bad_alloc*>(&problem) != nullptr
             ? "not enough memory"
             : base::jsonErrorMessage(problem.what());
}

}  // namespace app
