#include "app/window/WindowCommand.h"

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <functional>
#include <memory>

#include <CLI/CLI.hpp>

#include <QApplication>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/cli/Console.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/window/MainWindow.h"
#include "app/window/Screenshot.h"

namespace app {

namespace {

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
