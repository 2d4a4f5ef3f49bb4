#pragma once

namespace sim2d {

/// Planners that run external code.
constexpr const char* kExternalPlanner = "external";
constexpr const char* kLibraryPlanner = "library";

/// A scenario file alone never runs code: the user must allow it (--allow-code, or a prompt in the
/// window).
struct CodePermission {
  bool allowed = false;
};

/// How programs and libraries that a scenario names are handled.
enum class ExternalCodePolicy {
  Refused,  // an error
  Skipped,  // nothing is started and the robot stands still, for validation only
  Allowed
};

}  // namespace sim2d
