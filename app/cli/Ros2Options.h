#pragma once

#include <optional>
#include <string>

#include "app/bridge/dds/Domain.h"
#include "sim2d/base/Result.h"

namespace CLI {  // NOLINT(readability-identifier-naming): name of the library
class App;
class Validator;
}  // namespace CLI

namespace app {

/// Common options of all commands that use ROS 2.
struct Ros2Options {
  bool ros2 = false;
  std::optional<int> domain;
  std::optional<std::string> rmw, distro;
  bool network = false;
};

/// For check() of an option: "/" or "/lab".
CLI::Validator namespaceName();

void addRos2Options(CLI::App& command, Ros2Options& options, const std::string& help);

/// Options that are not given come from ROS_DOMAIN_ID, RMW_IMPLEMENTATION and ROS_DISTRO. Errors:
/// such a variable is invalid; this build has no ROS 2 support.
base::Result<bridge::DomainSettings> domainSettingsOf(const Ros2Options& options);

}  // namespace app
