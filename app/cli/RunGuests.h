#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/Session.h"

namespace app {

/// To whom a run of the window is told while it goes on.
struct RunGuests {
  /// Port of the live view, on this machine alone; another one where that is taken.
  std::optional<std::uint16_t> foxglove;
  bool ros2 = false;  // topics and /cmd_vel, by the variables of the shell
  // Both in the thread that runs or that of the live view.
  std::function<void(const std::string& url)> isWatched;    // the live view is there
  std::function<void(const base::Diagnostics& said)> tell;  // what could not be opened, warnings
};

/// Topics of ROS 2 are in this build.
bool speaksRos2();

/// Those who could be let in; in the thread that runs. Results stay the same but for what comes
/// from ROS 2, which is an input of the step that it acts in.
std::vector<Session::Guest> letIn(const RunGuests& guests, Session& session, sim2d::World& world,
                                  const std::shared_ptr<const Bundle>& bundle);

}  // namespace app
