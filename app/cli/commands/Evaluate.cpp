#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateLive.h"
#include "app/cli/EvaluateSource.h"
#include "app/cli/EvaluateWords.h"
#include "app/cli/RunWords.h"

namespace app {

namespace {

int evaluateCommand(const EvaluateOptions& options, const Invocation& given) {
  if (options.ros2.ros2) {
    return evaluateLive(options, given);
  }
  evaluateSource(options, given);
  return ExitFine;
}

void addForeignOptions(CLI::App& command, EvaluateOptions& options) {
  command
      .add_option("--format", options.format,
                  "Format of a trajectory file (default: recognised by its content)")
      ->check(oneOf(sim2d::trackFormatNames()));
  command.add_option("--columns", options.columns,
                     "Names of its columns: time=t,id=ped,x=px; their numbers from 1 where "
                     "the format has no names (petrack, trajnet, socnavbench)");
  command.add_option("--fps", options.framesPerSecond,
                     "Frames per second of its frame numbers, if the file states none");
  command.add_option("--unit", options.unit, "Unit of its lengths: mm, cm, m, or metres per pixel");
  command.add_option("--time-unit", options.timeUnit, "Unit of its times: s, ms, us, ns")
      ->check(oneOf({"s", "ms", "us", "ns"}));
  command.add_flag("--degrees", options.degrees, "Its headings are in degrees (csv)");
  command.add_option("--radius", options.radius, "Of everybody in it [m]");
  command.add_option("--dt", options.step, "Step of the samples made of it [s]");
  command.add_option(
      "--robot", options.robot,
      "Of a run: name or number of the only robot to measure; else the id or word of "
      "the person who is the robot");
  command.add_option("--robot-goal", options.robotGoal, "\"X Y\" (m)");
  command.add_option("--topics", options.topics,
                     "Of a bag or a system: people=NAME,robot=NAME,map=NAME");
}

void addLiveOptions(CLI::App& command, EvaluateOptions& options, CLI::Option* source) {
  addRos2Options(command, options.ros2, "Listen to a running system of ROS 2 instead of a source");
  CLI::Option* const ros2 = command.get_option("--ros2");
  source->required();  // else a folder with the name of a command would be taken for the command
  ros2->excludes(source)->each([source](const std::string&) { source->required(false); });
  command.add_option("--namespace", options.space, "With --ros2: of the evaluator's node")
      ->check(namespaceName())
      ->needs(ros2);
  command.add_option("--duration", options.duration, "With --ros2: seconds of a recording")
      ->check(CLI::PositiveNumber)
      ->needs(ros2);
  command
      .add_flag("--by-services", options.byServices,
                "With --ros2: hunav_start_recording and hunav_stop_recording begin and end "
                "recordings, each in a folder of its tag and number")
      ->needs(ros2);
}

}  // namespace

void addEvaluate(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("evaluate", "Metrics of a recorded run, of a file or of a bag", evaluateCommand);
  CLI::Option* const source =
      command.add_option("source", options.source,
                         "Folder of a run, a trajectory file of another program (-: standard "
                         "input), or a bag: an MCAP file, a .db3, a folder of rosbag2");
  addOutputFolder(command, options.output, "Folder for the results").required();
  command.add_option("--map", options.map, "Map instead of the recorded; none = open plane");
  addMetricsOptions(command, options.metrics);
  command.add_option("--tag", options.tag, "Tag in the result files");
  command.add_option("--run-id", options.runId, "Number of the run in the result files");
  command.add_option("--layout", options.layout, "Also the files of HuNavSim's evaluator")
      ->check(oneOf({"hunav2", "hunav1"}));
  command.add_option("--reference", options.reference,
                     "Run to compare the robot's way with: a folder, or a file with one body");
  addForeignOptions(command, options);
  addLiveOptions(command, options, source);
  addForce(command, options.force);
}

}  // namespace app
