#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/run/RunSpec.h"
#include "sim2d/base/Result.h"

namespace app {

/// What a user compares: the base or the candidate of a gate.
struct GateSide {
  enum class Kind {
    Planner,     // a name of list planners
    Nav2Params,  // a parameter file, the name of a shipped one, or NAME:=VALUE
    Nav2Tree,    // an XML file
    Program,     // a command line: planner `external`
    Library,     // a shared library: planner `library`
    Value,       // PATH=VALUE of the scenario
    Scenarios    // a scenario, or a folder of scenarios
  };
  Kind kind = Kind::Planner;
  std::string text;   // as given
  std::string value;  // with absolute paths
  /// Kind::Scenarios: names (without .yaml) and paths, sorted.
  std::vector<std::pair<std::string, std::string>> scenarios{};
};

/// Recognises the kind: a folder or file by its content, otherwise a planner, a shipped file, a
/// value or a command whose program exists. Errors: it is none of these, an unreadable file, a
/// folder without scenarios.
base::Result<GateSide> gateSideOf(const std::string& text);

/// A scenario with its file for each side.
struct GateScenario {
  std::string name, base, candidate;
};
/// The scenarios of a gate: `named` files or names of list scenarios; if the sides are scenarios,
/// those of the same name (two single files always match), all or `named` ones. Errors: unknown or
/// unmatched names, no scenarios, a side with scenarios and one without.
base::Result<std::vector<GateScenario>> gateScenarios(const GateSide& base,
                                                      const GateSide& candidate,
                                                      const std::vector<std::string>& named);

/// The options of the runs of a side, added to those of both. `scenario`: its file, for the name of
/// the first robot.
RunSpec specOfSide(const GateSide& side, RunSpec common, const std::string& scenario);

}  // namespace app
