#include "app/window/WindowCommand.h"

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>

#include <CLI/CLI.hpp>

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTimer>

#include "app/cli/Console.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/window/MainWindow.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using editor::SimulationRunner;

constexpr int kPatienceMs = 10 * 60 * 1000;
constexpr double kDefaultStep = 0.05;  // [s]
constexpr int kSettleMs = 250;         // animations and routes

int report(const base::Diagnostics& problems, int code) {
  printDiagnostics(problems, base::Severity::Warning);
  return base::hasErrors(problems) ? code : 0;
}

/// Before the application exists. Pictures depend on no screen: 96 dots per inch, and as many
/// pixels per point as wanted.
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

base::Diagnostics checkWords(const WindowOptions& options) {
  base::Diagnostics problems;
  if (!options.size.empty() && !sizeFromText(options.size)) {
    problems.push_back(base::error("option.size"));
  }
  if (!(options.scale >= 0.5 && options.scale <= 8.0)) {
    problems.push_back(base::error("option.scale"));
  }
  if (!(options.at >= 0.0 && options.at <= 86400.0)) {
    problems.push_back(base::error("option.at"));
  }
  const bool isPicture = !options.screenshot.empty();
  if (isPicture && !QString::fromStdString(options.screenshot).endsWith(QLatin1String(".png"))) {
    problems.push_back(base::error("option.screenshot"));
  }
  if (!options.theme.empty() && options.theme != "light" && options.theme != "dark") {
    problems.push_back(base::error("option.theme"));
  }
  return problems;
}

editor::Theme themeOf(const WindowOptions& options, bool& followsSystem) {
  followsSystem = options.theme.empty();
  if (options.theme == "dark") {
    return editor::Theme::dark();
  }
  return followsSystem ? editor::Theme::fromSystem(QApplication::palette())
                       : editor::Theme::light();
}

QString titleOf(std::string name) {
  QString title = QString::fromStdString(name);
  title.remove(QStringLiteral("_agents"));
  title.replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!title.isEmpty()) {
    title[0] = title[0].toUpper();
  }
  return title;
}

/// For the start page: whole scenes first, then one per reaction; none of the many of the realism
/// tests.
std::vector<Demo> demos() {
  std::vector<ShippedScenario> scenarios = shippedScenarios();
  const auto begins = [](const char* with) {
    return [with](const ShippedScenario& one) { return one.name.rfind(with, 0) == 0; };
  };
  scenarios.erase(std::remove_if(scenarios.begin(), scenarios.end(), begins("realism_")),
                  scenarios.end());
  std::stable_partition(scenarios.begin(), scenarios.end(), std::not_fn(begins("reaction_")));
  std::vector<Demo> result;
  for (const ShippedScenario& scenario : scenarios) {
    result.push_back({titleOf(scenario.name), QString::fromStdString(scenario.path)});
  }
  return result;
}

base::Diagnostics checkDocks(const MainWindow& window, const std::vector<std::string>& wanted) {
  base::Diagnostics problems;
  const QStringList known = const_cast<MainWindow&>(window).docks().names();
  for (const std::string& name : wanted) {
    if (!known.contains(QString::fromStdString(name).toLower())) {
      problems.push_back(base::error("option.unknown-dock",
                                     {name, known.join(QStringLiteral(", ")).toStdString()}));
    }
  }
  return problems;
}

/// What a run of the file would say, when the window shows it in part.
base::Diagnostics whyNotOpened(MainWindow& window) {
  const editor::ScenarioDocument& document = window.workspace().document();
  base::Diagnostics problems =
      document.path().isEmpty() ? base::Diagnostics() : check(document.bundle()).problems;
  return base::hasErrors(problems) ? problems : window.files().problems();
}

void pass(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
}

/// Lets the program work until `done`; false when that takes too long.
bool waitFor(const std::function<bool()>& done) {
  QElapsedTimer clock;
  clock.start();
  while (!done()) {
    if (clock.elapsed() > kPatienceMs) {
      return false;
    }
    pass(10);
  }
  return true;
}

/// Trails grow by what is shown.
void showStates(Workspace& workspace, const sim2d::Recording& recording, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    workspace.scene().showFrame(recording.frame(k));
  }
}

base::Diagnostics playTo(Workspace& workspace, double time) {
  SimulationRunner& runner = workspace.runner();
  const sim2d::Recording& recording = *runner.recording();
  const std::size_t index = recording.indexAtTime(time);
  showStates(workspace, recording, index);
  runner.seek(recording.stepOf(index));
  if (!waitFor([&] { return workspace.feed().isCurrent(); })) {
    return {base::error("run.not-measured")};
  }
  return {};
}

/// Exactly so many steps, as fast as possible; then paused at that moment.
base::Diagnostics runTo(Workspace& workspace, double time) {
  SimulationRunner& runner = workspace.runner();
  if (runner.isRecorded()) {
    return playTo(workspace, time);
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
    runner.stepOnce();  // the first one makes the world
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
    showStates(workspace, *recording, recording->size());
  }
  return {};
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

}  // namespace

base::Diagnostics takeScreenshot(MainWindow& window, const WindowOptions& options) {
  window.workspace().document().checkNow();  // the issues are those of the file
  pass(kSettleMs);
  if (!window.isOnStartPage() && options.at > 0.0) {
    if (const base::Diagnostics problems = runTo(window.workspace(), options.at);
        !problems.empty()) {
      return problems;
    }
  }
  if (!options.docks.empty()) {
    QStringList names;
    for (const std::string& name : options.docks) {
      names.push_back(QString::fromStdString(name).toLower());
    }
    window.docks().show(names);
  }
  pass(kSettleMs);
  return save(window.grab(), options.screenshot);
}

namespace {

int windowCommand(int argc, char** argv, const RunOptions& run, const WindowOptions& options) {
  base::Diagnostics wrongWords = checkWords(options);
  const base::Result<RunSettings> settings = runSettingsOf(run);
  base::append(wrongWords, settings.diagnostics());
  if (const int code = report(wrongWords, kWrongCommandLine)) {
    return code;
  }
  if (!run.scenario.empty() && !QFileInfo::exists(QString::fromStdString(run.scenario))) {
    return report({base::error("file.not-there", {}, run.scenario)}, kBadInput);
  }
  const bool picture = !options.screenshot.empty();
  if (picture && FileCommands::isImage(QString::fromStdString(run.scenario))) {
    return report({base::error("option.picture-of-image", {}, run.scenario)}, kBadInput);
  }
  prepareScreen(options);
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName(QStringLiteral("HuNavSim Desktop"));
  QApplication::setApplicationVersion(QString::fromStdString(programVersion()));
  WindowSetup setup;
  setup.theme = themeOf(options, setup.followsSystem);
  setup.remembers = !picture;
  setup.shippedMaps = QString::fromStdString(shippedMapsFolder());
  setup.demos = demos();
  setup.options = run;
  setup.compatibility = settings->compatibility;
  if (!picture) {
    setup.recoveryFolder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                           QStringLiteral("/recovery");
  }
  dressApplication(setup.theme);
  MainWindow window(setup);
  if (const int code = report(checkDocks(window, options.docks), kWrongCommandLine)) {
    return code;
  }
  if (const std::optional<QSize> size = sizeFromText(options.size)) {
    window.resize(*size);
  } else if (picture) {
    window.resize(MainWindow::usualSize());  // whatever the screen
  }
  window.show();
  bool opened = true;
  if (!run.scenario.empty()) {
    opened = window.open(QString::fromStdString(run.scenario));
  }
  const bool isFolder = QFileInfo(QString::fromStdString(run.scenario)).isDir();
  if (!opened && (picture || isFolder)) {  // broken scenarios are for the window
    return report(whyNotOpened(window), kBadInput);
  }
  if (!picture) {
    return QApplication::exec();
  }
  return report(takeScreenshot(window, options), kBadInput);
}

/// All words of the window.
struct WindowWords {
  RunOptions run;
  WindowOptions window;
};

/// `--dock issues events FILE`: all words behind the option are names of docks to it. The last is
/// the scenario when there is none yet, and it names one.
void takeScenarioFromDocks(WindowWords& words) {
  std::vector<std::string>& docks = words.window.docks;
  if (docks.size() < 2 || !words.run.scenario.empty()) {
    return;
  }
  const std::string file = scenarioFile(docks.back());
  if (QFileInfo(QString::fromStdString(file)).isFile()) {
    docks.pop_back();
    words.run.scenario = file;
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
  if (!fits(width) || !fits(height)) {
    return std::nullopt;
  }
  return QSize(static_cast<int>(*width), static_cast<int>(*height));
}

void addWindow(CommandRegistry& commands) {
  const auto words = std::make_shared<WindowWords>();
  commands.setDefault([words](const Invocation& given) {
    takeScenarioFromDocks(*words);
    return windowCommand(given.argc, given.argv, words->run, words->window);
  });
  CLI::App& root = commands.root();
  root.add_option("scenario", words->run.scenario, "Scenario to open in the window")
      ->transform(scenarioFile);
  addRunOptions(root, words->run);
  WindowOptions& window = words->window;
  root.add_option("--screenshot", window.screenshot, "Save a picture of the window and leave");
  root.add_option("--at", window.at, "Simulated time of the picture [s]");
  root.add_option("--size", window.size, "Size of the window, WxH");
  root.add_option("--scale", window.scale, "Pixels per point");
  root.add_option("--theme", window.theme, "light or dark")
      ->check(CLI::IsMember({"light", "dark"}));
  root.add_option("--dock", window.docks, "Docks to show, by their names in the View menu");
}

}  // namespace app
