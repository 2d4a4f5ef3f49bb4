#include "app/cli/CommandRegistry.h"

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include <QCoreApplication>
#include <QGuiApplication>
#include <QHash>
#include <QString>

#include "app/cli/Console.h"
#include "app/cli/MemoryReserve.h"
#include "app/run/DataPaths.h"
#include "app/run/ExceptionMessage.h"
#include "sim2d/base/Text.h"

namespace app {

void addAllCommands(CommandRegistry& to);  // written by CMake

namespace {

/// Fontconfig, which Qt asks for fonts when it begins, crashes where memory ends.
constexpr std::size_t kForFonts = std::size_t{16} << 20;  // [bytes]

/// Numbers are read without a locale, whatever the user's is.
template <class Application>
int within(Invocation& given, const CommandRegistry::Action& action) {
  Application application(given.argc, given.argv);
  std::setlocale(LC_NUMERIC, "C");
  return action(given);
}

/// A command line that cannot be followed is told as every error is.
int tellWrongWords(const CommandRegistry& commands, const std::string& said) {
  if (commands.wantsJson()) {
    printJson({base::error("option.wrong", {said})});
  }
  const std::vector<CLI::App*> given = commands.root().get_subcommands();
  printError(said);
  printError("see hunavsim" + (given.empty() ? "" : " " + given.front()->get_name()) + " --help");
  return ExitWrongCommandLine;
}

/// Words that no option takes; the first is a mistyped command, unless it is a scenario.
std::string extrasText(const CommandRegistry& commands, const std::string& firstWord) {
  const CLI::App& root = commands.root();
  const std::optional<std::string> meant = base::nearestName(firstWord, commands.names());
  std::error_code ignored;
  if (root.get_subcommands().empty() && meant && !std::filesystem::exists(firstWord, ignored)) {
    return "unknown command '" + firstWord + "' (did you mean '" + *meant + "'?)";
  }
  return "unexpected arguments: " + base::join(root.remaining(true), " ");
}

/// What image libraries grumble is told by our own messages, with the file's name. A machine where
/// nobody has logged in has no folder for running programs, and we want none. What Qt ends the
/// program for (no display, no memory for its plugin) is an error like others.
void withoutLibraryWords(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (!text.startsWith(QLatin1String("libpng")) &&
      !text.startsWith(QLatin1String("QStandardPaths: XDG_RUNTIME_DIR not set"))) {
    const QString begin = type == QtFatalMsg ? QStringLiteral("error: ") : QString();
    std::fputs(qPrintable(begin + qFormatLogMessage(type, context, text) + QLatin1Char('\n')),
               stderr);
  }
  if (type == QtFatalMsg) {
    ::_exit(ExitRunFailed);
  }
}

}  // namespace

void requireFine(const base::Diagnostics& problems, ExitCode code, base::Severity least) {
  if (!printDiagnostics(problems, least)) {
    throw CommandEnd{code, problems};
  }
}

CLI::App& CommandRegistry::add(const std::string& name, const std::string& help, Action action,
                               std::function<Drawing()> drawing) {
  commands_[name] = {std::move(action), std::move(drawing)};
  return *root_.add_subcommand(name, help);
}

std::vector<std::string> CommandRegistry::names() const {
  std::vector<std::string> names;
  for (const CLI::App* command : root_.get_subcommands(nullptr)) {
    names.push_back(command->get_name());
  }
  return names;
}

void CommandRegistry::addOutputOptions() {
  root_.add_flag("-q,--quiet", quiet_, "Do not print progress or tables");
  for (CLI::App* command : root_.get_subcommands(nullptr)) {
    command->add_flag("-q,--quiet", quiet_, "Do not print progress or tables");
    command->add_flag("--json", json_, "Print machine-readable JSON");
  }
}

namespace {

/// Makes pictures independent of the screen of the user.
void prepareDrawing() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("QT_FONT_DPI", "96");
  for (const char* scale : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS",
                            "QT_AUTO_SCREEN_SCALE_FACTOR", "QT_ENABLE_HIGHDPI_SCALING"}) {
    qunsetenv(scale);
  }
}

}  // namespace

int CommandRegistry::start(Invocation given) const {
  given.quiet = quiet_;
  given.json = json_;
  const std::vector<CLI::App*> chosen = root_.get_subcommands();
  if (chosen.empty()) {  // the window
    requireMemory(kForFonts);
    return default_(given);
  }
  const Command& command = commands_.at(chosen.front()->get_name());
  if (command.drawing() == Drawing::Pictures) {
    prepareDrawing();
    requireMemory(kForFonts);
    return within<QGuiApplication>(given, command.action);
  }
  return within<QCoreApplication>(given, command.action);
}

void CommandRegistry::noteJson(const std::vector<std::string>& words) {
  json_ = std::find(words.begin(), words.end(), "--json") != words.end();
}

CLI::Option& addOutputFolder(CLI::App& command, std::string& folder, const std::string& help) {
  return *command.add_option("-o,--output", folder, help)->check([](const std::string& word) {
    if (word.empty()) {
      return std::string("a folder is required");
    }
    return word == "-" ? std::string("a folder is required (./- for a folder named -)")
                       : std::string();
  });
}

void addForce(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "Overwrite files that hunavsim did not create");
}

void addMetricsOptions(CLI::App& command, MetricsOptions& options) {
  command.add_option("--metrics", options.metrics,
                     "Metrics: a metrics.yaml file, or comma-separated keys");
  command
      .add_option("--metrics-profile", options.metricsProfile,
                  "Metric definitions: corrected or hunav2")
      ->check(oneOf(metricProfiles()));
}

void addAllowCode(CLI::App& command, bool& allowed) {
  command.add_flag("--allow-code", allowed,
                   "Allow the scenario to start external planner programs and libraries");
}

namespace {

int doneBy(int argc, char** argv, void (*addWindow)(CommandRegistry&)) {
  CLI::App root{"HuNavSim Desktop: edit, simulate and evaluate robots among people"};
  root.name("hunavsim");
  root.set_version_flag("-V,--version",
                        "hunavsim " + programVersion() + " (" + programCommit() + ")");
  root.set_help_flag("-h,--help", "Print this help message and exit");
  CommandRegistry commands(root);
  commands.noteJson({argv, argv + argc});
  addWindow(commands);
  addAllCommands(commands);
  commands.addOutputOptions();
  try {
    root.parse(argc, argv);
    return commands.start({argc, argv});
  } catch (const CommandEnd& end) {
    if (commands.wantsJson()) {
      printJson(end.problems);
    }
    return end.code;
  } catch (const CLI::ExtrasError&) {
    return tellWrongWords(commands, extrasText(commands, argv[1]));
  } catch (const CLI::Success& asked) {  // for the help, for the version
    return root.exit(asked);
  } catch (const CLI::ParseError& problem) {
    return tellWrongWords(commands, problem.what());
  } catch (const std::exception& problem) {  // no memory, a file that nobody foresaw
    if (commands.wantsJson()) {
      printJson({base::error("program.failed", {exceptionMessage(problem)})});
    }
    printError("error: " + exceptionMessage(problem));
    return ExitRunFailed;
  }
}

}  // namespace

int runProgram(int argc, char** argv, void (*addWindow)(CommandRegistry&)) {
  reserveMemory();
  qInstallMessageHandler(withoutLibraryWords);
  qSetGlobalQHashSeed(0);  // else Qt puts the fonts of a PDF into another order each time
  ignoreFileSizeSignal();
  const int code = doneBy(argc, argv, addWindow);
  if (wroteAllOutput() || code != ExitFine) {
    return code;
  }
  printError("error: cannot write to standard output");
  return ExitBadInput;
}

}  // namespace app
