#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bridge/groot/GrootPublisher.h"
#include "app/bridge/live/FoxglovePublisher.h"
#include "app/run/Bundle.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
}  // namespace CLI

namespace app {

/// Options of the pace of a run and of the programs that may watch it.
struct LiveOptions {
  std::string speed;        // simulated seconds per second, or "max"; empty: the usual one
  std::optional<int> port;  // of the live view; none: there is none; 0: any free port
  std::string address = "127.0.0.1";
  std::vector<std::string> origins;  // further web pages that may connect
  std::optional<int> grootPort;      // none: Groot2 cannot connect; 0: any free port
  std::string grootPerson;           // whose tree Groot2 shows; empty: the first person's
};
/// --speed, --foxglove, --groot2 and the options that need them.
void addLiveOptions(CLI::App& command, LiveOptions& options);

/// Sets the pace of the session and opens the live view if the options ask for it; else returns
/// null. `canDrive`: clients may give inputs. Messages go to standard error. Ends the command when
/// the port is not available.
std::unique_ptr<live::FoxglovePublisher> openLive(const LiveOptions& options, const Bundle& bundle,
                                                  const MetricsSetup& metrics, bool canDrive,
                                                  Session& session, sim2d::World& world);

/// The same for Groot2. Also ends the command when no person has that name, or the person has no
/// tree.
std::unique_ptr<groot::GrootPublisher> openGroot(const LiveOptions& options, const Bundle& bundle,
                                                 sim2d::World& world);

/// Warns once, after the first seconds, of each port that no client has connected to.
class NoViewerCheck {
 public:
  /// Null: the port is not open. Both must outlive this object.
  NoViewerCheck(const LiveOptions& options, const live::FoxglovePublisher* live,
                const groot::GrootPublisher* groot)
      : options_(options), live_(live), groot_(groot) {}
  /// To be called with each state; writes the warnings that are due to standard error.
  void update();

 private:
  const LiveOptions& options_;
  const live::FoxglovePublisher* live_;
  const groot::GrootPublisher* groot_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  bool isOver_ = false;
};

}  // namespace app
