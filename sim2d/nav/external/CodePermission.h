#pragma once

namespace sim2d {

/// Planners that run code of others.
constexpr const char* kExternalPlanner = "external";
constexpr const char* kLibraryPlanner = "library";

/// A scenario file alone never runs code: whoever starts the run must have said so (--allow-code,
/// or a question in the window).
struct CodePermission {
  bool allowed = false;
};

/// What becomes of programs and libraries that a scenario names.
enum class CodeUse {
  Refused,  // an error
  LeftOut,  // nothing is started, the robot stands: for those who only look whether all is well
  Allowed
};

}  // namespace sim2d
