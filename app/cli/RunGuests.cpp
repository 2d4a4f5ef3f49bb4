#include "app/cli/RunGuests.h"

#include <filesystem>
#include <utility>

#include "app/bridge/live/LiveRun.h"
#include "app/cli/Ros2Words.h"
#ifdef HUNAV_ROS2
#include "app/bridge/nodes/RunNode.h"
#endif

namespace app {

namespace {

void tellAny(const RunGuests& guests, const base::Diagnostics& said) {
  if (!said.empty()) {
    guests.tell(said);
  }
}

std::optional<Session::Guest> liveView(const RunGuests& guests, Session& session,
                                       sim2d::World& world, const Bundle& bundle) {
  const base::Result<MetricsSetup> metrics = metricsSetupOf(*bundle.scenario, bundle.path);
  tellAny(guests, metrics.diagnostics());
  if (!metrics) {
    return std::nullopt;
  }
  live::LiveRunSettings settings;
  settings.port = *guests.foxglove;
  settings.canDrive = false;  // by the keys of the window
  settings.warn = [tell = guests.tell](const base::Diagnostic& warning) { tell({warning}); };
  const std::string name = std::filesystem::path(bundle.path).stem().string();
  auto opened = live::LiveRun::open(settings, session, world, *bundle.scenario, name, *metrics);
  if (!opened) {
    settings.port = 0;
    opened = live::LiveRun::open(settings, session, world, *bundle.scenario, name, *metrics);
  }
  tellAny(guests, opened.diagnostics());
  if (!opened) {
    return std::nullopt;
  }
  const std::shared_ptr<live::LiveRun> run = *std::move(opened);
  guests.isWatched("ws://localhost:" + std::to_string(run->port()));
  return Session::Guest{[run](const sim2d::Frame& frame) { run->show(frame); }, {}};
}

#ifdef HUNAV_ROS2
std::optional<Session::Guest> topics(const RunGuests& guests, sim2d::World& world,
                                     const Bundle& bundle) {
  const base::Result<bridge::DomainSettings> domain = domainSettingsOf({});
  tellAny(guests, domain.diagnostics());
  if (!domain) {
    return std::nullopt;
  }
  auto made =
      bridge::RunNode::create(world.header(), bridge::lidarsOf(*bundle.scenario), {*domain},
                              [tell = guests.tell](const base::Diagnostic& said) { tell({said}); });
  tellAny(guests, made.diagnostics());
  if (!made) {
    return std::nullopt;
  }
  world.tellScans(true);
  const std::shared_ptr<bridge::RunNode> node = *std::move(made);
  return Session::Guest{[node](const sim2d::Frame& frame) { node->tell(frame); },
                        [node](const sim2d::Frame& frame) { return node->inputs(frame); }};
}
#endif

}  // namespace

bool speaksRos2() {
#ifdef HUNAV_ROS2
  return true;
#else
  return false;
#endif
}

std::vector<Session::Guest> letIn(const RunGuests& guests, Session& session, sim2d::World& world,
                                  const std::shared_ptr<const Bundle>& bundle) {
  std::vector<Session::Guest> there;
  const auto add = [&there](std::optional<Session::Guest> guest) {
    if (guest) {
      there.push_back(*std::move(guest));
    }
  };
  if (bundle != nullptr && guests.foxglove) {
    add(liveView(guests, session, world, *bundle));
  }
#ifdef HUNAV_ROS2
  if (bundle != nullptr && guests.ros2) {
    add(topics(guests, world, *bundle));
  }
#endif
  return there;
}

}  // namespace app
