#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2Block.h"
#include "sim2d/nav/nav2/control/Controller.h"

namespace sim2d::nav2 {

/// All that a controller is made of.
struct ControllerSetup {
  Distro distro = Distro::Jazzy;
  double frequency = 20.0;  // controller_frequency [Hz]
  Nav2Block block;          // what is given below its name
  std::string name = "FollowPath";
  std::uint64_t seed = 1;  // of those that draw
  int robotId = -1;        // with the seed: whose draws
};

/// A class of controllers, by the name of its plugin.
struct ControllerType {
  std::string plugin;  // "dwb_core::DWBLocalPlanner"
  std::string help;    // a sentence for people
  unsigned distros = kEveryDistro;
  /// Its keys; some depend on what is given, as a critic's on the list of critics.
  std::function<Nav2Keys(const Nav2Block& given, Distro distro)> keys;
  /// Every problem of the block at once: wrong types, values that cannot be, unknown critics.
  std::function<base::Result<std::unique_ptr<Controller>>(const ControllerSetup& setup)> make;
};

/// Every controller, in the order of registration. A new one: its `add` in ControllerRegistry.cpp.
class ControllerRegistry {
 public:
  void add(ControllerType type) { types_.push_back(std::move(type)); }
  const std::vector<ControllerType>& types() const { return types_; }
  /// In either spelling ("a::B", "a/B"); null: unknown, or not in that distro.
  const ControllerType* find(const std::string& plugin, Distro distro) const;
  /// The same, with an error that tells what comes nearest.
  base::Result<std::unique_ptr<Controller>> make(const std::string& plugin,
                                                 const ControllerSetup& setup) const;
  std::vector<std::string> plugins(Distro distro) const;

 private:
  std::vector<ControllerType> types_;
};

const ControllerRegistry& controllerRegistry();

/// "unknown plugin", with the nearest of `known` and all of them.
base::Diagnostic unknownPlugin(const std::string& found, const std::vector<std::string>& known);

void addDwb(ControllerRegistry& registry);
void addGraceful(ControllerRegistry& registry);
void addMppi(ControllerRegistry& registry);
void addRegulatedPurePursuit(ControllerRegistry& registry);
void addRotationShim(ControllerRegistry& registry);

}  // namespace sim2d::nav2
