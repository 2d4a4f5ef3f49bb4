#include "app/cli/Ros2Words.h"

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

base::Result<int> domainOf(const Ros2Words& words) {
  if (words.domain) {
    return *words.domain;
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
            return bridge::isNamespace(text) ? std::string()
                                             : "'" + text + "' is no namespace (such as /lab)";
          },
          ""};
}

void addRos2Options(CLI::App& command, Ros2Words& words, const std::string& help) {
  CLI::Option* const ros2 =
      command.add_flag("--ros2", words.ros2,
                       help +
                           ". Nodes are found on the loopback interface alone unless --network is "
                           "given, and in one domain: --domain or ROS_DOMAIN_ID");
  command.add_option("--domain", words.domain, "ROS_DOMAIN_ID; else the variable, or 0")
      ->check(CLI::Range(0, bridge::kLastDomain))
      ->needs(ros2);
  command
      .add_option("--rmw", words.rmw,
                  "Middleware of the other nodes: fastrtps or cyclonedds; else RMW_IMPLEMENTATION")
      ->check(oneOf({"fastrtps", "cyclonedds"}))
      ->needs(ros2);
  command
      .add_option("--ros-distro", words.distro,
                  "humble, or jazzy for Iron and all later; else ROS_DISTRO")
      ->check(oneOf({"humble", "jazzy"}))
      ->needs(ros2);
  command
      .add_flag("--network", words.network,
                "Use all interfaces, so that other machines are found too (default: loopback only)")
      ->needs(ros2);
}

base::Result<bridge::DomainSettings> domainSettingsOf(const Ros2Words& words) {
#ifndef HUNAV_ROS2
  return base::error("ros2.not-built");
#endif
  const base::Result<int> domain = domainOf(words);
  if (!domain) {
    return domain.diagnostics();
  }
  bridge::DomainSettings settings;
  settings.domain = *domain;
  const bool isCyclone = words.rmw ? *words.rmw == "cyclonedds"
                                   : variable("RMW_IMPLEMENTATION") == "rmw_cyclonedds_cpp";
  settings.rmw = isCyclone ? bridge::Rmw::CycloneDds : bridge::Rmw::FastRtps;
  const std::string distro = words.distro.value_or(variable("ROS_DISTRO"));
  settings.distro =
      distro.empty() || distro == "humble" ? bridge::Distro::Humble : bridge::Distro::Jazzy;
  settings.localhostOnly = !words.network;
  return settings;
}

}  // namespace app
