#pragma once

#include <optional>
#include <string>

#include "app/bridge/dds/Domain.h"
#include "sim2d/base/Result.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
class Validator;
}  // namespace CLI

namespace app {

/// Options of all commands that speak to ROS 2, as given.
struct Ros2Words {
  bool ros2 = false;
  std::optional<int> domain;
  std::optional<std::string> rmw, distro;
  bool network = false;
};

/// For check() of an option: "/" or "/lab".
CLI::Validator namespaceName();

void addRos2Options(CLI::App& command, Ros2Words& words, const std::string& help);

/// What is not given comes from ROS_DOMAIN_ID, RMW_IMPLEMENTATION and ROS_DISTRO. Errors: such a
/// variable cannot be used; this build does not speak to ROS 2.
base::Result<bridge::DomainSettings> domainSettingsOf(const Ros2Words& words);

}  // namespace app
