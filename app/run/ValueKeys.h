#pragma once

#include <string>
#include <vector>

#include "app/run/ExperimentValues.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// The keys of a scenario that a value sets, each as the names that lead to it.
struct ValueKeys {
  using KeyPath = std::vector<std::string>;

  std::vector<KeyPath> replaced;  // with all that is below them
  std::vector<KeyPath> leaves;    // of these, also inside maps
};
/// Of all texts of the value; a map for a whole entity sets each of its keys.
ValueKeys keysOf(const ExperimentValue& value);

/// A key of `earlier` that `later` replaces in one of the scenarios, "robot1.planner"; empty: there
/// is none. `*` is each listed person; a later value of one person does not replace it.
std::string replacedKey(const ValueKeys& earlier, const ValueKeys& later,
                        const std::vector<const sim2d::Scenario*>& scenarios);

}  // namespace app
