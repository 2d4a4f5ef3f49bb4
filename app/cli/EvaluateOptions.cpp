#include "app/cli/EvaluateOptions.h"

#include <filesystem>
#include <map>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;

namespace {

/// Errors for given options of trajectory files; `code` says where they do not apply. Bags take
/// some of them.
base::Diagnostics givenFileOptions(const EvaluateOptions& options, const char* code, bool isBag) {
  struct FileOption {
    const char* word;
    bool isGiven;
    bool isForBags = false;
  };
  const FileOption all[] = {{"--format", !options.format.empty()},
                            {"--columns", !options.columns.empty()},
                            {"--fps", options.framesPerSecond.has_value()},
                            {"--unit", !options.unit.empty()},
                            {"--time-unit", !options.timeUnit.empty()},
                            {"--degrees", options.degrees},
                            {"--radius", options.radius.has_value()},
                            {"--dt", options.step.has_value(), true},
                            {"--robot-goal", options.robotGoal.has_value(), true}};
  base::Diagnostics wrong;
  for (const FileOption& option : all) {
    if (option.isGiven && !(isBag && option.isForBags)) {
      wrong.push_back(base::error(code, {option.word}));
    }
  }
  return wrong;
}

/// Checks options that apply only to bags, or not to bags.
base::Diagnostics checkBagOptions(const EvaluateOptions& options, bridge::BagTopicOptions& use) {
  const bool isBag = isBagSource(options);
  base::Diagnostics wrong;
  if (!options.topics.empty() && !isBag) {
    wrong.push_back(base::error("option.only-bags", {"--topics"}));
  }
  if (isBag) {
    base::append(wrong, givenFileOptions(options, "option.not-for-bags", true));
  }
  const base::Result<bridge::BagTopicOptions> read = bridge::parseBagTopicOptions(options.topics);
  base::append(wrong, read.diagnostics());
  use = read ? *read : use;
  return wrong;
}

/// Which body is the robot in a third-party file: a name or an id.
void readRobot(const EvaluateOptions& options, sim2d::TrackOptions& tracks) {
  if (isRunFolder(options.source)) {
    return;
  }
  tracks.robotName = options.robot;
  const std::optional<long long> id = base::parseInt(options.robot);
  if (id && *id == static_cast<int>(*id)) {
    tracks.robotId = static_cast<int>(*id);
  }
}

/// Parses the options for reading and converting third-party files; returns the invalid ones.
base::Diagnostics parseForeignOptions(const EvaluateOptions& options,
                                      sim2d::TrackImportOptions& reading,
                                      sim2d::TrackOptions& tracks) {
  base::Diagnostics wrong;
  reading.format = options.format;  // checked by the command-line parser
  if (!options.columns.empty()) {
    const auto columns = sim2d::parseColumns(options.columns);
    base::append(wrong, columns.diagnostics());
    if (columns) {
      reading.columns = *columns;
    }
  }
  const auto positive = [&wrong](const std::optional<double>& value, const char* word) {
    if (value && !(*value > 0.0 && *value <= 1e6)) {
      wrong.push_back(base::error("option.not-positive", {word}));
    }
    return value.value_or(0.0);
  };
  reading.framesPerSecond = positive(options.framesPerSecond, "--fps");
  reading.radius = positive(options.radius, "--radius");
  reading.degrees = options.degrees;
  static const std::map<std::string, double> kTimes = {
      {"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
  reading.timeUnit = options.timeUnit.empty() ? 0.0 : kTimes.at(options.timeUnit);
  if (!options.unit.empty()) {
    static const std::map<std::string, double> kLengths = {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}};
    const auto named = kLengths.find(options.unit);
    const std::optional<double> metres =
        named != kLengths.end() ? named->second : base::parseDouble(options.unit);
    reading.lengthUnit = positive(metres.value_or(0.0), "--unit");
  }
  tracks.step = positive(options.step, "--dt");
  readRobot(options, tracks);
  if (options.robotGoal) {
    const std::optional<std::vector<double>> goal = parseNumbers(*options.robotGoal, 2);
    if (goal) {
      tracks.robotGoal = base::Vec2((*goal)[0], (*goal)[1]);
    } else {
      wrong.push_back(base::error("option.evaluate-goal", {*options.robotGoal}));
    }
  }
  return wrong;
}

}  // namespace

bool isRunFolder(const std::string& source) {
  std::error_code ignored;
  return fs::is_directory(source, ignored) && !bridge::isBag(source);
}

bool isBagSource(const EvaluateOptions& options) {
  return options.ros2.ros2 || bridge::isBag(options.source);
}

base::Diagnostics parseEvaluateOptions(const EvaluateOptions& options, SourceOptions& parsed) {
  base::Diagnostics wrong = isRunFolder(options.source)
                                ? givenFileOptions(options, "option.only-foreign", false)
                                : base::Diagnostics();
  base::append(wrong, parseForeignOptions(options, parsed.reading, parsed.tracks));
  base::append(wrong, checkBagOptions(options, parsed.use));
  return wrong;
}

}  // namespace app
