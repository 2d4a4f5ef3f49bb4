#include "app/window/WindowCommand.h"

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <exception>

#include <CLI/CLI.hpp>

#include "app/cli/Console.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/window/KeyRules.h"
#include "app/window/MainWindow.h"
#include "app/window/TerminationSignals.h"
#include "app/window/files/FileCommands.h"
#include "app/window/files/MapFiles.h"
#include "app/window/settings/Language.h"
#include "editor/canvas/RouteModel.h"
#include "editor/look/AppStyle.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using editor::SimulationRunner;

constexpr int kTimeoutMs = 10 * 60 * 1000;
constexpr double kDefaultStep = 0.05;  // [s]
constexpr int kSettleMs = 250;         // for animations and routes

/// Call before the application is created. Pictures do not depend on the screen: 96 dpi, with the
/// requested scale.
void prepareScreen(const WindowOptions& options) {
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  if (options.screenshot.empty()) {
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(
        Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    return;
  }
  qputenv("QT_FONT_DPI", "96");
  if (options.scale != 1.0) {
    qputenv("QT_SCALE_FACTOR", QByteArray::number(options.scale));
  }
  const bool screen = qEnvironmentVariableIsSet("DISPLAY") ||
                      qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
                      qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
  if (!screen) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
}

base::Diagnostics checkOptions(const WindowOptions& options) {
  base::Diagnostics problems;
  const auto want = [&problems](bool isFine, const char* code) {
    if (!isFine) {
      problems.push_back(base::error(code));
    }
  };
  const QString picture = QString::fromStdString(options.screenshot);
  want(options.size.empty() || sizeFromText(options.size), "option.size");
  want(options.scale >= 0.5 && options.scale <= 8.0, "option.scale");
  want(options.at >= 0.0 && options.at <= 86400.0, "option.at");
  want(picture.isEmpty() || picture.endsWith(QLatin1String(".png")), "option.screenshot");
  want(options.theme.empty() || options.theme == "light" || options.theme == "dark",
       "option.theme");
  return problems;
}

editor::Theme themeOf(const WindowOptions& options) {
  return options.theme.empty()     ? editor::Theme::fromSystem(QApplication::palette())
         : options.theme == "dark" ? editor::Theme::dark()
                                   : editor::Theme::light();
}

base::Diagnostics checkDocks(const QStringList& known, const std::vector<std::string>& wanted) {
  base::Diagnostics problems;
  for (const std::string& name : wanted) {
    if (!known.contains(QString::fromStdString(name).toLower())) {
      problems.push_back(base::error("option.unknown-dock",
                                     {name, known.join(QStringLiteral(", ")).toStdString()}));
    }
  }
  return problems;
}

/// The problems of a file that could not be opened completely, as `run` reports them.
base::Diagnostics openProblems(MainWindow& window) {
  const editor::ScenarioDocument& document = window.workspace().document();
  base::Diagnostics problems =
      document.path().isEmpty() ? base::Diagnostics() : check(document.bundle()).problems;
  return base::hasErrors(problems) ? problems : window.files().problems();
}

void processEvents(int milliseconds) {
  QEventLoop loop;
  editor::later(
      loop, [&loop] { loop.quit(); }, milliseconds);
  loop.exec();
}

/// Processes events until `done`. False: timeout.
bool waitFor(const std::function<bool()>& done) {
  QElapsedTimer clock;
  clock.start();
  while (!done()) {
    if (clock.elapsed() > kTimeoutMs) {
      return false;
    }
    processEvents(10);
  }
  return true;
}

/// Shows frames, because trails consist of displayed frames.
void replayFrames(Workspace& workspace, const sim2d::Recording& recording, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    workspace.scene().showFrame(recording.frame(k), &recording);
  }
}

base::Diagnostics playTo(Workspace& workspace, double time) {
  SimulationRunner& runner = workspace.runner();
  const sim2d::Recording& recording = *runner.recording();
  const std::size_t index = recording.indexAtTime(time);
  replayFrames(workspace, recording, index);
  runner.seek(recording.stepOf(index));
  const bool isMeasured = waitFor([&] { return workspace.feed().isCurrent(); });
  return isMeasured ? base::Diagnostics() : base::Diagnostics{base::error("run.not-measured")};
}

/// Runs exactly to `time` as fast as possible and pauses.
base::Diagnostics runTo(Workspace& workspace, double time) {
  SimulationRunner& runner = workspace.runner();
  if (runner.isRecorded()) {
    return playTo(workspace, time);
  }
  const std::vector<ExternalCode> code = workspace.unapprovedCode();
  if (!code.empty()) {
    return externalCodeProblems(code, base::Severity::Error,
                                workspace.document().path().toStdString());
  }
  base::Diagnostics problems;
  QObject listener;
  QObject::connect(&runner, &SimulationRunner::notStarted, &listener,
                   [&](const base::Diagnostics& found) { base::append(problems, found); });
  QObject::connect(&runner, &SimulationRunner::failed, &listener, [&](const QString& reason) {
    problems.push_back(base::error("run.failed", {reason.toStdString()}));
  });
  const double dt = workspace.document().scenario().desktop.dt.value_or(kDefaultStep);
  const long long steps = std::llround(time / dt);
  for (long long i = 0; i < steps; ++i) {
    runner.stepOnce();  // the first step creates the world
  }
  const bool there = waitFor([&] {
    const editor::FramePtr newest = runner.newestFrame();
    return base::hasErrors(problems) || runner.isFinished() || (newest && newest->step >= steps);
  });
  if (base::hasErrors(problems)) {
    return problems;
  }
  if (!there || !waitFor([&] { return workspace.feed().isCurrent(); })) {
    return {base::error("run.too-slow")};
  }
  if (const editor::RecordingPtr recording = runner.recording()) {
    replayFrames(workspace, *recording, recording->size());
  }
  return {};
}

/// Shows the newest frame for overlays that are not recorded: paths of people, sensor data and
/// candidates.
void showNewest(Workspace& workspace, const WindowOptions& options) {
  const SimulationRunner& runner = workspace.runner();
  if (!options.overlays.empty() && !runner.isRecorded() && runner.newestFrame() != nullptr) {
    workspace.scene().showFrame(runner.newestFrame(), runner.recording().get());
  }
}

base::Diagnostics showTreeOf(MainWindow& window, const std::string& person) {
  editor::ScenarioDocument& document = window.workspace().document();
  for (const sim2d::Human& human : document.scenario().humans) {
    if (human.name == person) {
      document.setSelection({human.key});
      window.docks().treeMaximized()->setChecked(true);
      return {};
    }
  }
  std::vector<std::string> names;
  for (const sim2d::Human& human : document.scenario().humans) {
    names.push_back(human.name);
  }
  return {base::error("option.unknown-name", {"--tree", person, base::nearestName(person, names),
                                              base::join(names, ", ")})};
}

base::Diagnostics save(const QPixmap& picture, const std::string& file) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG")) {
    return {base::error("option.picture-not-made", {}, file)};
  }
  return base::writeFileAtomically(file,
                                   {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

/// Selects a person or robot; empty name: none.
base::Diagnostics selectNamed(editor::ScenarioDocument& document, const std::string& name) {
  const auto select = [&](const auto& bodies) {
    const auto* found =
        base::findIf(bodies, [&name](const auto& body) { return body.name == name; });
    if (found != nullptr) {
      document.setSelection({found->key});
    }
    return found != nullptr;
  };
  const bool isFine =
      name.empty() || select(document.scenario().humans) || select(document.scenario().robots);
  return isFine ? base::Diagnostics()
                : base::Diagnostics{base::error("option.unknown-body", {name})};
}

}  // namespace

base::Diagnostics takeScreenshot(MainWindow& window, const WindowOptions& options) {
  window.workspace().document().checkNow();  // the issues belong to the file
  processEvents(kSettleMs);
  window.actions().showOverlays(options.overlays);  // some overlays collect data only while enabled
  if (!window.isOnStartPage() && options.at > 0.0) {
    if (base::Diagnostics problems = runTo(window.workspace(), options.at); !problems.empty()) {
      return problems;
    }
    showNewest(window.workspace(), options);
  }
  if (base::Diagnostics problems = selectNamed(window.workspace().document(), options.select);
      !problems.empty()) {
    return problems;
  }
  if (!options.docks.empty()) {
    QStringList names;
    for (const std::string& name : options.docks) {
      names.push_back(QString::fromStdString(name).toLower());
    }
    window.docks().show(names);
  }
  window.workspace().scene().routes().finish();  // may take longer on a busy machine
  processEvents(kSettleMs);
  return save(window.grab(), options.screenshot);
}

namespace {

/// Handles an unexpected exception: saves unsaved work for the next start and exits.
[[noreturn]] void exitAfterException(MainWindow& window, const std::string& why) {
  bool isKept = false;
  try {
    if (editor::Autosave* const autosave = window.guard().autosave()) {
      autosave->writeNow();
      isKept = !autosave->folder().isEmpty() &&
               QFileInfo::exists(autosave->folder() + QStringLiteral("/recovery.json"));
    }
  } catch (const std::exception&) {
    isKept = false;  // recovery failed
  }
  printError("error: " + why);
  if (isKept) {
    printError(
        "note: unsaved changes are kept; the window offers to restore them at the next "
        "start");
  }
  std::_Exit(ExitRunFailed);  // a normal exit would delete the copy
}

void requireScenario(const std::string& name, bool isForPicture,
                     const std::vector<std::string>& commands) {
  const QString scenario = QString::fromStdString(name);
  if (name == "-") {
    requireFine({base::error("option.window-input")}, ExitWrongCommandLine);
  }
  if (!scenario.isEmpty() && !QFileInfo::exists(scenario)) {
    requireFine(
        {unknownScenario(name, commands).value_or(base::error("file.not-there", {}, name))});
  }
  if (isForPicture && isMapImage(scenario) && mapYamlOf(scenario).isEmpty()) {
    requireFine({base::error("option.picture-of-image", {}, name)});
  }
}

/// Call after the application name is set.
WindowSetup setupOf(const WindowOptions& options, const RunSpec& run) {
  WindowSetup setup;
  setup.theme = themeOf(options);
  setup.followsSystem = options.theme.empty();
  setup.storesSettings = options.screenshot.empty();
  setup.shippedMaps = QString::fromStdString(shippedMapsFolder());
  setup.demos = galleryScenarios(shippedScenarios());
  setup.options = run;
  setup.manual = installedManual();
  if (setup.storesSettings) {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    setup.recoveryFolder = data + QStringLiteral("/recovery");
    setup.openFilesFolder = data + QStringLiteral("/open-files");
    setup.thumbnailFolder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
                            QStringLiteral("/thumbnails");
  }
  return setup;
}

int windowCommand(const Invocation& given, const RunSpec& run, const WindowOptions& options,
                  const std::vector<std::string>& commands) {
  base::Diagnostics wrongOptions = checkOptions(options);
  const base::Result<RunSettings> settings = runSettingsOf(run);
  base::append(wrongOptions, settings.diagnostics());
  requireFine(wrongOptions, ExitWrongCommandLine, base::Severity::Warning);
  const bool picture = !options.screenshot.empty();
  requireScenario(run.scenario, picture, commands);
  const QString scenario = QString::fromStdString(run.scenario);
  prepareScreen(options);
  int argc = given.argc;
  GuardedApplication application(argc, given.argv);
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale::c());  // numbers as in files, in every language
  QApplication::setApplicationName(QStringLiteral("HuNavSim Desktop"));
  QApplication::setApplicationVersion(QString::fromStdString(programVersion()));
  const Translation translation(languageFor(UserSettings(!picture).value(kLanguageKey).toString()));
  WindowSetup setup = setupOf(options, run);
  setup.compatibility = settings->compatibility;
  editor::applyTheme(setup.theme);
  MainWindow window(setup);
  requireFine(checkDocks(window.docks().names(), options.docks), ExitWrongCommandLine);
  if (picture || !options.size.empty()) {  // independent of the screen
    window.resize(sizeFromText(options.size).value_or(MainWindow::defaultSize()));
  }
  application.setExceptionHandler(
      [&window](const std::string& why) { exitAfterException(window, why); });
  window.show();
  const bool isOpened = scenario.isEmpty() || window.open(scenario);
  if (!isOpened && (picture || QFileInfo(scenario).isDir())) {  // the window shows damaged files
    requireFine(openProblems(window), ExitBadInput, base::Severity::Warning);
    return ExitFine;
  }
  if (!options.tree.empty()) {
    requireFine(showTreeOf(window, options.tree), ExitWrongCommandLine);
  }
  if (!picture) {
    TerminationSignals termination;
    QObject::connect(&termination, &TerminationSignals::received, &window, &MainWindow::endSession);
    const int code = QApplication::exec();
    application.setExceptionHandler({});  // the window is destroyed first
    return code;
  }
  if (const std::optional<base::Diagnostic>& cut = window.files().truncationOfRun()) {
    printDiagnostics({*cut});
  }
  requireFine(takeScreenshot(window, options), ExitBadInput, base::Severity::Warning);
  return ExitFine;
}

/// For `--dock issues events FILE`: all arguments after the option are parsed as dock names. The
/// last one is the scenario if none was given and the file exists.
void takeScenarioFromDocks(std::vector<std::string>& docks, std::string& scenario) {
  if (docks.size() < 2 || !scenario.empty()) {
    return;
  }
  const std::string file = scenarioFile(docks.back());
  if (QFileInfo(QString::fromStdString(file)).isFile()) {
    docks.pop_back();
    scenario = file;
  }
}

}  // namespace

std::optional<QSize> sizeFromText(const std::string& text) {
  const std::vector<std::string> parts = base::split(text, 'x');
  if (parts.size() != 2) {
    return std::nullopt;
  }
  const std::optional<long long> width = base::parseInt(parts[0]);
  const std::optional<long long> height = base::parseInt(parts[1]);
  const auto fits = [](const std::optional<long long>& side) {
    return side && *side >= 200 && *side <= 10000;
  };
  return fits(width) && fits(height)
             ? std::make_optional<QSize>(static_cast<int>(*width), static_cast<int>(*height))
             : std::nullopt;
}

void addWindow(CommandRegistry& commands) {
  const auto run = std::make_shared<RunSpec>();
  const auto window = std::make_shared<WindowOptions>();
  commands.setDefault([run, window, &commands](const Invocation& given) {
    takeScenarioFromDocks(window->docks, run->scenario);
    return windowCommand(given, *run, *window, commands.names());
  });
  CLI::App& root = commands.root();
  root.add_option("scenario", run->scenario, "Scenario to open in the window")
      ->transform(scenarioFile);
  addRunOptions(root, *run);
  root.add_option("--screenshot", window->screenshot, "Save a screenshot of the window and exit");
  root.add_option("--at", window->at, "Simulated time of the screenshot [s]");
  root.add_option("--size", window->size, "Window size, WxH");
  root.add_option("--scale", window->scale, "Scale factor of the window");
  root.add_option("--theme", window->theme, "light or dark")->check(oneOf({"light", "dark"}));
  root.add_option(
          "--overlay", window->overlays,
          "Run overlays in the screenshot: density, sight, gaussian, velocities, plans, contacts, "
          "thoughts, zones, forces, ways, local-costs, global-costs, masks; separate several with "
          "commas")
      ->delimiter(',')
      ->check(oneOf(WindowActions::overlayNames()));
  root.add_option("--select", window->select,
                  "Person or robot to select in the screenshot, by "
                  "name");
  root.add_option("--tree", window->tree,
                  "Person whose behaviour tree is shown instead of the "
                  "map");
  root.add_option("--dock", window->docks, "Panels to show, by their names in the View menu");
  commands.addExamples(root,
                       {{"hunavsim corner_cafe_agents", "Open the café in the window", "a display"},
                        {"hunavsim out", "Play a recorded run", "a display"},
                        {"hunavsim corner_cafe_agents --at 2 --theme dark --screenshot cafe.png",
                         "Save a picture of the window after 2 s of simulation"}});
}

}  // namespace app
