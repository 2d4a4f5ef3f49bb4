#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateLive.h"
#include "app/cli/EvaluateOptions.h"
#include "app/cli/EvaluateSource.h"

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
                  "Format of the trajectory file (default: detected from its content)")
      ->check(oneOf(sim2d::trackFormatNames()));
  command.add_option("--columns", options.columns,
                     "Columns of the file, for example time=t,id=ped,x=px; column numbers from 1 "
                     "for formats without names (petrack, trajnet, socnavbench)");
  command.add_option("--fps", options.framesPerSecond,
                     "Frames per second, if the file has frame numbers and states no rate");
  command.add_option("--unit", options.unit,
                     "Length unit of the file: mm, cm, m, or metres per pixel");
  command.add_option("--time-unit", options.timeUnit, "Time unit of the file: s, ms, us or ns")
      ->check(oneOf({"s", "ms", "us", "ns"}));
  command.add_flag("--degrees", options.degrees, "Headings in the file are in degrees (csv)");
  command.add_option("--radius", options.radius, "Radius of all bodies in the file [m]");
  command.add_option("--dt", options.step, "Time step for resampling the file [s]");
  command.add_option(
      "--robot", options.robot,
      "For a run: name or number of the only robot to evaluate; for a file: id or label of the "
      "body that is the robot");
  command.add_option("--robot-goal", options.robotGoal, "Goal of the robot: \"X Y\" (m)");
  command.add_option("--topics", options.topics,
                     "Topics of a bag or a running system: people=NAME,robot=NAME,map=NAME");
}

void addLiveOptions(CLI::App& command, EvaluateOptions& options, CLI::Option* source) {
  addRos2Options(command, options.ros2,
                 "Record a running ROS 2 system instead of reading a source");
  CLI::Option* const ros2 = command.get_option("--ros2");
  source->required();  // otherwise a folder named like a command is parsed as that command
  ros2->excludes(source)->each([source](const std::string&) { source->required(false); });
  command.add_option("--namespace", options.space, "With --ros2: namespace of the evaluator node")
      ->check(namespaceName())
      ->needs(ros2);
  command.add_option("--duration", options.duration, "With --ros2: duration of a recording [s]")
      ->check(CLI::PositiveNumber)
      ->needs(ros2);
  command
      .add_flag("--by-services", options.byServices,
                "With --ros2: the services hunav_start_recording and hunav_stop_recording start "
                "and stop recordings, each in its own folder TAG_RUN")
      ->needs(ros2);
}

}  // namespace

void addEvaluate(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "evaluate", "Compute metrics of a recorded run, a trajectory file or a bag", evaluateCommand);
  CLI::Option* const source =
      command.add_option("source", options.source,
                         "Folder of a run, trajectory file of an external program (-: standard "
                         "input), or bag: MCAP file, .db3 file or rosbag2 folder");
  addOutputFolder(command, options.output, "Output folder").required();
  command.add_option("--map", options.map,
                     "Map to use instead of the recorded one; none = open plane");
  addMetricsOptions(command, options.metrics);
  command.add_option("--tag", options.tag, "Tag in the result files");
  command.add_option("--run-id", options.runId, "Run number in the result files");
  command
      .add_option("--layout", options.layout,
                  "Also write the files of HuNavSim's evaluator in this layout")
      ->check(oneOf({"hunav2", "hunav1"}));
  command.add_option("--reference", options.reference,
                     "Reference for the path of the robot: folder of a run, or a file with one "
                     "body");
  addForeignOptions(command, options);
  addLiveOptions(command, options, source);
  addForce(command, options.force);
}

}  // namespace app
