#include "app/cli/Ros2Options.h"

#include <cstdlib>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

base::Result<int> domainOf(const Ros2Options& options) {
  if (options.domain) {
    return *options.domain;
  }
  const std::string text = variable("ROS_DOMAIN_ID");
  if (text.empty()) {
    return 0;
  }
  const auto number = base::parseInt(text);
  if (!number || *number < 0 || *number > bridge::kLastDomain) {
    return base::error("ros2.bad-domain", {text});
  }
  return static_cast<int>(*number);
}

}  // namespace

CLI::Validator namespaceName() {
  return {[](const std::string& text) {
            return bridge::isNamespace(text)
                       ? std::string()
                       : "'" + text + "' is not a namespace (for example /lab)";
          },
          ""};
}

void addRos2Options(CLI::App& command, Ros2Options& options, const std::string& help) {
  CLI::Option* const ros2 =
      command.add_flag("--ros2", options.ros2,
                       help +
                           ". Discovers nodes on the loopback interface only, unless --network is "
                           "given, and in one domain only (--domain or ROS_DOMAIN_ID)");
  command
      .add_option("--domain", options.domain, "ROS domain ID (default: ROS_DOMAIN_ID, otherwise 0)")
      ->check(CLI::Range(0, bridge::kLastDomain))
      ->needs(ros2);
  command
      .add_option("--rmw", options.rmw,
                  "Middleware of the other nodes: fastrtps or cyclonedds (default: "
                  "RMW_IMPLEMENTATION)")
      ->check(oneOf({"fastrtps", "cyclonedds"}))
      ->needs(ros2);
  command
      .add_option("--ros-distro", options.distro,
                  "ROS distribution: humble, or jazzy for Iron and later (default: ROS_DISTRO)")
      ->check(oneOf({"humble", "jazzy"}))
      ->needs(ros2);
  command
      .add_flag("--network", options.network,
                "Use all network interfaces to discover other machines (default: loopback only)")
      ->needs(ros2);
}

base::Result<bridge::DomainSettings> domainSettingsOf(const Ros2Options& options) {
#ifndef HUNAV_ROS2
  return base::error("ros2.not-built");
#endif
  const base::Result<int> domain = domainOf(options);
  if (!domain) {
    return domain.diagnostics();
  }
  bridge::DomainSettings settings;
  settings.domain = *domain;
  const bool isCyclone = options.rmw ? *options.rmw == "cyclonedds"
                                     : variable("RMW_IMPLEMENTATION") == "rmw_cyclonedds_cpp";
  settings.rmw = isCyclone ? bridge::Rmw::CycloneDds : bridge::Rmw::FastRtps;
  const std::string distro = options.distro.value_or(variable("ROS_DISTRO"));
  settings.distro =
      distro.empty() || distro == "humble" ? bridge::Distro::Humble : bridge::Distro::Jazzy;
  settings.localhostOnly = !options.network;
  return settings;
}

}  // namespace app
