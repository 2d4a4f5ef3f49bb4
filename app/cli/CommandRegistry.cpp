#include "app/cli/CommandRegistry.h"

#include <algorithm>
#include <atomic>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <exception>
#include <filesystem>
#include <new>
#include <typeinfo>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include <QCoreApplication>
#include <QGuiApplication>
#include <QHash>
#include <QString>

#include "app/cli/Console.h"
#include "app/cli/help/HelpText.h"
#include "app/cli/help/OptionLayout.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

void addAllCommands(CommandRegistry& to);  // written by CMake

namespace {

constexpr std::size_t kReserve =
    std::size_t{64} * 1024;  // [bytes]; below the mmap threshold of malloc

std::atomic<void*> reserve{nullptr};
std::string outOfMemoryMessage;                       // preallocated: written when allocation fails
std::terminate_handler previousHandler = std::abort;  // for other exceptions

void releaseReserveAndThrow() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

[[noreturn]] void reportOrAbort() {
  const std::type_info* thrown = abi::__cxa_current_exception_type();
  if (thrown != nullptr && *thrown == typeid(std::bad_alloc)) {
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, outOfMemoryMessage.data(), outOfMemoryMessage.size());
    ::_exit(ExitRunFailed);
  }
  previousHandler();
  std::abort();
}

/// Reserves memory for all threads of the program. The first failed allocation releases the reserve
/// before std::bad_alloc is thrown, because destructors may allocate during unwinding
/// (nlohmann::json). If that is not sufficient, the program prints the same message and exits with
/// the same code, without running destructors.
void reserveMemory() {
  std::free(reserve.exchange(std::malloc(kReserve)));
  std::set_new_handler(releaseReserveAndThrow);
  outOfMemoryMessage = "error: " + base::exceptionMessage(std::bad_alloc()) + "\n";
  if (const auto before = std::set_terminate(reportOrAbort); before != reportOrAbort) {
    previousHandler = before;
  }
}

/// Throws std::bad_alloc if this many bytes cannot be allocated now. Call before libraries that do
/// not check the result of malloc.
void requireMemory(std::size_t bytes) {
  void* volatile room = std::malloc(bytes);  // volatile: otherwise both calls may be removed
  if (room == nullptr) {
    throw std::bad_alloc();
  }
  std::free(room);
}

/// Fontconfig, which Qt initialises, crashes if it cannot allocate memory.
constexpr std::size_t kForFonts = std::size_t{16} << 20;  // [bytes]

/// Creates the application and runs the action. Numbers are read and written without a locale.
template <class Application>
int within(Invocation& given, const CommandRegistry::Action& action) {
  Application application(given.argc, given.argv);
  std::setlocale(LC_NUMERIC, "C");
  return action(given);
}

/// Reports a command line that cannot be parsed in the form of other errors.
int reportWrongCommandLine(const CommandRegistry& commands, const std::string& said) {
  if (commands.wantsJson()) {
    printJson({base::error("option.wrong", {said})});
  }
  const std::vector<CLI::App*> given = commands.root().get_subcommands();
  printError(said);
  printError("see hunavsim" + (given.empty() ? "" : " " + given.front()->get_name()) + " --help");
  return ExitWrongCommandLine;
}

/// An unknown option with the most similar one of its command; null: none is similar.
std::optional<std::string> unknownOption(const CLI::App& root) {
  const std::vector<CLI::App*> given = root.get_subcommands();
  const CLI::App& command = given.empty() ? root : *given.front();
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  for (const std::string& word : root.remaining(true)) {
    const std::string name = word.substr(0, word.find('='));
    const auto meant = base::startsWith(name, "--") ? base::nearestName(name, names) : std::nullopt;
    if (meant) {
      return "unknown option '" + name + "' (did you mean '" + *meant + "'?)";
    }
  }
  return std::nullopt;
}

/// Message for arguments that no option accepts; the first one is a mistyped command, unless it is
/// a file.
std::string extrasText(const CommandRegistry& commands, const std::string& firstWord) {
  const CLI::App& root = commands.root();
  const std::optional<std::string> meant = base::nearestName(firstWord, commands.names());
  std::error_code ignored;
  if (root.get_subcommands().empty() && meant && !std::filesystem::exists(firstWord, ignored)) {
    return "unknown command '" + firstWord + "' (did you mean '" + *meant + "'?)";
  }
  const std::optional<std::string> option = unknownOption(root);
  return option.value_or("unexpected arguments: " + base::join(root.remaining(true), " "));
}

/// Prints messages of Qt, except those of libpng, which the program reports with the file name, and
/// the warning about a missing XDG_RUNTIME_DIR. Fatal errors (no display, no memory for a plugin)
/// are reported as errors and end the program.
void filterLibraryMessages(QtMsgType type, const QMessageLogContext& context, const QString& text) {
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

CommandRegistry::CommandRegistry(CLI::App& root) : root_(root) {
  root_.formatter_fn([this](const CLI::App* command, const std::string&, CLI::AppFormatMode) {
    return helpText(infoOf(*command), table());
  });
}

CommandInfo CommandRegistry::infoOf(const CLI::App& command) const {
  const auto found = examples_.find(&command);
  return describeCommand(command, &command == &root_,
                         found == examples_.end() ? std::vector<CommandExample>() : found->second);
}

void CommandRegistry::addExamples(const CLI::App& command, std::vector<CommandExample> examples) {
  std::vector<CommandExample>& all = examples_[&command];
  all.insert(all.end(), examples.begin(), examples.end());
}

CommandTable CommandRegistry::table() const {
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command : root_.get_subcommands(nullptr)) {
    commands.push_back(command);
  }
  std::stable_sort(commands.begin(), commands.end(), [](const auto* a, const auto* b) {
    return rankOfCommand(a->get_name()) < rankOfCommand(b->get_name());
  });
  CommandTable table = {infoOf(root_)};
  for (const CLI::App* command : commands) {
    table.push_back(infoOf(*command));
  }
  return table;
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

std::vector<std::string> Invocation::argumentsForResults() const {
  std::vector<std::string> kept = {"hunavsim"};
  const std::vector<std::string> all = words();
  for (std::size_t k = 1; k < all.size(); ++k) {
    const std::string& word = all[k];
    const bool isJobs = base::startsWith(word, "-j") || base::startsWith(word, "--jobs");
    if (word == "-j" || word == "--jobs") {
      ++k;  // and its value
    } else if (!isJobs && word != "--resume" && word != "--force" && word != "-q" &&
               word != "--quiet" && word != "--json") {
      kept.push_back(word);
    }
  }
  return kept;
}

void addJobs(CLI::App& command, int& jobs) {
  command
      .add_option("-j,--jobs", jobs, "Number of parallel processes (default: number of processors)")
      ->check(CLI::Range(1, 1024));
}

void addTimeLimit(CLI::App& command, double& seconds) {
  command
      .add_option("--time-limit", seconds,
                  "Wall time after which a run counts as failed [s] (default: none)")
      ->check(CLI::PositiveNumber);
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
    return reportWrongCommandLine(commands, extrasText(commands, argv[1]));
  } catch (const CLI::Success& asked) {  // --help, --version
    return root.exit(asked);
  } catch (const CLI::ParseError& problem) {
    return reportWrongCommandLine(commands, problem.what());
  } catch (const std::exception& problem) {  // for example no memory
    if (commands.wantsJson()) {
      printJson({base::error("program.failed", {base::exceptionMessage(problem)})});
    }
    printError("error: " + base::exceptionMessage(problem));
    return ExitRunFailed;
  }
}

}  // namespace

int runProgram(int argc, char** argv, void (*addWindow)(CommandRegistry&)) {
  reserveMemory();
  qInstallMessageHandler(filterLibraryMessages);
  qSetGlobalQHashSeed(0);  // else Qt puts the fonts of a PDF into another order each time
  ignoreFileSizeSignal();
  const int code = doneBy(argc, argv, addWindow);
  if (wroteAllOutput() || code != ExitFine) {
    return code;
  }
  printError("error: cannot write to standard output");
  return ExitBadInput;
}

namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

base::Result<int> domainOf(const Ros2Options& options) {
  if (options.domain) {
    return *options.domain;
  }
  const std::string text = variable("ROS_DOMAIN_ID");
  if (text.empty()) {
    return 0;
  }
  const auto number = base::parseInt(text);
  if (!number || *number < 0 || *number > bridge::kLastDomain) {
    return base::error("ros2.bad-domain", {text});
  }
  return static_cast<int>(*number);
}

}  // namespace

CLI::Validator namespaceName() {
  return {[](const std::string& text) {
            return bridge::isNamespace(text)
                       ? std::string()
                       : "'" + text + "' is not a namespace (for example /lab)";
          },
          ""};
}

void addRos2Options(CLI::App& command, Ros2Options& options, const std::string& help) {
  CLI::Option* const ros2 =
      command.add_flag("--ros2", options.ros2,
                       help +
                           ". Discovers nodes on the loopback interface only, unless --network is "
                           "given, and in one domain only (--domain or ROS_DOMAIN_ID)");
  command
      .add_option("--domain", options.domain, "ROS domain ID (default: ROS_DOMAIN_ID, otherwise 0)")
      ->check(CLI::Range(0, bridge::kLastDomain))
      ->needs(ros2);
  command
      .add_option("--rmw", options.rmw,
                  "Middleware of the other nodes: fastrtps or cyclonedds (default: "
                  "RMW_IMPLEMENTATION)")
      ->check(oneOf({"fastrtps", "cyclonedds"}))
      ->needs(ros2);
  command
      .add_option("--ros-distro", options.distro,
                  "ROS distribution: humble, or jazzy for Iron and later (default: ROS_DISTRO)")
      ->check(oneOf({"humble", "jazzy"}))
      ->needs(ros2);
  command
      .add_flag("--network", options.network,
                "Use all network interfaces to discover other machines (default: loopback only)")
      ->needs(ros2);
}

base::Result<bridge::DomainSettings> domainSettingsOf(const Ros2Options& options) {
#ifndef HUNAV_ROS2
  return base::error("ros2.not-built");
#endif
  const base::Result<int> domain = domainOf(options);
  if (!domain) {
    return domain.diagnostics();
  }
  bridge::DomainSettings settings;
  settings.domain = *domain;
  const bool isCyclone = options.rmw ? *options.rmw == "cyclonedds"
                                     : variable("RMW_IMPLEMENTATION") == "rmw_cyclonedds_cpp";
  settings.rmw = isCyclone ? bridge::Rmw::CycloneDds : bridge::Rmw::FastRtps;
  const std::string distro = options.distro.value_or(variable("ROS_DISTRO"));
  settings.distro =
      distro.empty() || distro == "humble" ? bridge::Distro::Humble : bridge::Distro::Jazzy;
  settings.localhostOnly = !options.network;
  return settings;
}

}  // namespace app
