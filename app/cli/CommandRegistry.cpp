#include "app/cli/CommandRegistry.h"

#include <clocale>

#include <CLI/CLI.hpp>

#include <QApplication>
#include <QCoreApplication>
#include <QGuiApplication>

#include "sim2d/base/Text.h"

namespace app {

namespace {

/// Numbers are read without a locale, whatever the user's is.
template <class Application>
int within(Invocation& given, const CommandRegistry::Action& action) {
  Application application(given.argc, given.argv);
  std::setlocale(LC_NUMERIC, "C");
  return action(given);
}

}  // namespace

CLI::App& CommandRegistry::add(const std::string& name, const std::string& help, Action action,
                               std::function<Drawing()> drawing) {
  commands_[name] = {std::move(action), std::move(drawing)};
  return *root_.add_subcommand(name, help);
}

void CommandRegistry::addOutputOptions() {
  for (CLI::App* command : root_.get_subcommands(nullptr)) {
    command->add_flag("--quiet", output_.quiet, "No progress and no table");
    command->add_flag("--json", output_.json, "Machine-readable standard output");
  }
}

int CommandRegistry::start(Invocation given) const {
  given.output = output_;
  const std::vector<CLI::App*> chosen = root_.get_subcommands();
  if (chosen.empty()) {
    return default_(given);
  }
  const Command& command = commands_.at(chosen.front()->get_name());
  const Drawing drawing = command.drawing();
  if (drawing != Drawing::None && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  switch (drawing) {
    case Drawing::Widgets:
      return within<QApplication>(given, command.action);
    case Drawing::Pictures:
      return within<QGuiApplication>(given, command.action);
    case Drawing::None:
      break;
  }
  return within<QCoreApplication>(given, command.action);
}

void addMetricsOptions(CLI::App& command, std::string& metrics, std::string& profile) {
  command.add_option("--metrics", metrics, "Selection: a metrics.yaml, or keys with commas");
  command.add_option("--metrics-profile", profile, "corrected or hunav2")
      ->check(CLI::IsMember({"corrected", "hunav2"}));
}

void addRunOptions(CLI::App& command, RunOptions& options) {
  command.add_option("--map", options.map,
                     "Map to use instead of the scenario's; none = open plane");
  command.add_option("--trees", options.trees, "Folder with the behaviour trees");
  command.add_option("--seed", options.seed, "Seed of all random numbers")
      ->check([](const std::string& text) {
        return base::parseInt(text) ? std::string() : "'" + text + "' is no whole number that fits";
      });
  command.add_option("--duration", options.duration, "Length of the run [s]");
  command.add_option("--dt", options.dt, "Time step [s]");
  command.add_option("--model", options.model, "How people walk: see list models");
  command.add_option("--robot", options.robot, "Type of the robot: see list robots");
  command.add_option("--robot-start", options.robotStart, "\"X Y HEADING\" (m, m, rad)");
  command.add_option("--robot-goal", options.robotGoal, "\"X Y\" (m)");
  command.add_option("--planner", options.planner, "How the robot plans: see list planners");
  command.add_option("--threads", options.threads, "Number of threads; results stay the same");
  addMetricsOptions(command, options.metrics, options.metricsProfile);
  command.add_option("--record-every", options.recordEvery, "Record every N-th step");
  command.add_option("--set", options.set, "PATH=VALUE: any value of the scenario")
      ->allow_extra_args(false);
  command.add_flag("--exact", options.exact, "Full double sum of forces");
  command.add_option("--compat", options.compat, "hunav2, or quirks of the original: Q-13,Q-20");
}

}  // namespace app
