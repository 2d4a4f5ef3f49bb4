#include "app/window/Screenshot.h"

#include <cmath>
#include <functional>

#include <QBuffer>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>

#include "sim2d/base/Text.h"

namespace app {

namespace {

using editor::SimulationRunner;

constexpr int kPatienceMs = 10 * 60 * 1000;
constexpr double kDefaultStep = 0.05;  // [s]
constexpr int kSettleMs = 250;         // animations and routes

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

}  // namespace app
