#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// A robot whose changed Nav2 parameters have been written to a file of their own.
struct SavedNav2Parameters {
  sim2d::Robot robot;             // reads the new file; without the written values
  std::vector<std::string> kept;  // paths of values that remain in the scenario
};

/// Writes the parameter file of the robot to `path`, with the values of the scenario in their
/// places; comments, order and layout of the file are kept. Of several files it is the last one,
/// which overrides the others. Values that cannot be written, or that would have no effect in the
/// file, remain in the scenario. `entry`: how the scenario names the new file. Errors: the files
/// cannot be read, the new file cannot be written.
base::Result<SavedNav2Parameters> saveNav2Parameters(const sim2d::Robot& robot,
                                                     const std::string& scenarioPath,
                                                     const std::string& path,
                                                     const std::string& entry);

}  // namespace app
