#pragma once

#include <algorithm>
#include <string>

#include "sim2d/nav/nav2/params/Nav2Parameters.h"

/// Reading of parameter files in tests.
namespace nav2test {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

inline ParameterFile parsed(const std::string& text) {
  auto file = ParameterFile::parse(text, "p.yaml");
  return file ? *file : ParameterFile();
}

inline Nav2ReadResult readOf(const std::string& text, Distro distro = Distro::Jazzy) {
  return readNav2Parameters(parsed(text), {distro, {}});
}

/// A controller that takes few keys; the rest are Nav2's defaults.
inline const std::string kPursuit = R"(controller_server:
  ros__parameters:
    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
)";

inline std::string texts(const base::Diagnostics& problems) {
  std::string all;
  for (const base::Diagnostic& problem : problems) {
    all += problem.text() + "\n";
  }
  return all;
}

inline const base::Diagnostic* problemOf(const base::Diagnostics& problems,
                                         const std::string& code) {
  const auto found = std::find_if(problems.begin(), problems.end(),
                                  [&](const base::Diagnostic& each) { return each.code == code; });
  return found == problems.end() ? nullptr : &*found;
}

inline const KeyUsage* noteOf(const Nav2ReadResult& reading, const std::string& path) {
  const auto& keys = reading.parameters.notes.keys;
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const KeyUsage& key) { return key.path == path; });
  return found == keys.end() ? nullptr : &*found;
}

inline std::string valueOf(const NodeParameters& node, const std::string& name) {
  const GivenParameter* const given = node.find(name);
  return given == nullptr ? "-" : given->value->text;
}

}  // namespace nav2test
