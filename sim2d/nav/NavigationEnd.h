#pragma once

#include <cstddef>
#include <string>

namespace sim2d {

/// How a planner that decides itself when a goal is over has ended the navigation to it: the result
/// of a navigator's action, as Nav2 reports it to its client.
struct NavigationEnd {
  bool hasSucceeded = false;
  /// Why it failed, by name: "planner NO_VALID_PATH (208)"; empty after success.
  std::string reason;
  std::string message;    // the same as a sentence; empty: there is none
  int errorCode = 0;      // Nav2's; 0: none
  std::size_t goals = 1;  // goals that are over with it, from the current one on
};

}  // namespace sim2d
