#include "app/window/RunCommands.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QMimeData>
#include <QStringList>

#include "app/cli/PictureFiles.h"
#include "app/cli/RunExport.h"
#include "app/cli/RunObservers.h"
#include "app/cli/RunPicture.h"
#include "app/report/RunPictures.h"
#include "editor/document/RunValues.h"
#include "editor/look/CoreText.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Form.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/runs/Playback.h"

namespace app {

using editor::SimulationRunner;

namespace {

constexpr const char* kWatched = "live-view";
constexpr const char* kWarning = "run-guests";

}  // namespace

RunSharing::RunSharing(Workspace& workspace, QAction& foxglove, QAction& ros2, NoticeBar& notices,
                       QObject* parent)
    : QObject(parent), workspace_(workspace), foxglove_(foxglove), ros2_(ros2), notices_(notices) {
  ros2_.setVisible(hasRos2Support());
  for (QAction* const action : {&foxglove_, &ros2_}) {
    connect(action, &QAction::toggled, this, &RunSharing::choose);
  }
  const SimulationRunner* runner = &workspace_.runner();
  connect(runner, &SimulationRunner::stateChanged, this, &RunSharing::updateNotices);
  connect(runner, &SimulationRunner::finished, this, &RunSharing::updateNotices);
  connect(runner, &SimulationRunner::branchesChanged, this, &RunSharing::updateNotices);
}

/// Guests call back in other threads; their messages are queued to this thread.
void RunSharing::choose() {
  if (!foxglove_.isChecked() && !ros2_.isChecked()) {
    workspace_.runner().setObserverFactory({});
    return;
  }
  RunObservers guests;
  if (foxglove_.isChecked()) {
    guests.foxglove = static_cast<std::uint16_t>(kUsualPort);
  }
  guests.ros2 = ros2_.isChecked();
  const QPointer<RunSharing> here(this);
  const auto later = [here](auto act) {
    const auto report = [here, act] {
      if (here) {
        act(*here);
      }
    };
    if (QCoreApplication* const application = QCoreApplication::instance()) {
      const QObject sender;  // its destruction is the signal; avoids a clang-tidy warning
      connect(&sender, &QObject::destroyed, application, report, Qt::QueuedConnection);
    }
  };
  guests.liveViewOpened = [later](const std::string& url) {
    later([url](RunSharing& sharing) { sharing.reportUrl(QString::fromStdString(url)); });
  };
  guests.report = [later](const base::Diagnostics& diagnostics) {
    later([diagnostics](RunSharing& sharing) { sharing.reportWarning(diagnostics); });
  };
  workspace_.runner().setObserverFactory(
      [guests](Session& session, sim2d::World& world, const std::shared_ptr<const Bundle>& bundle) {
        return attachObservers(guests, session, world, bundle);
      });
}

bool RunSharing::isLive() const {
  const SimulationRunner& runner = workspace_.runner();
  return runner.state() != SimulationRunner::State::Editing && !runner.isFinished();
}

void RunSharing::reportUrl(const QString& url) {
  if (!isLive()) {
    return;  // the run was closed meanwhile
  }
  notices_.inform(QString::fromLatin1(kWatched),
                  tr("Watch this run at %1 (Foxglove: Open connection)").arg(url),
                  {{tr("Copy address"), [url] { QGuiApplication::clipboard()->setText(url); }}});
}

/// Shows the newest warning, or the first of several.
void RunSharing::reportWarning(const base::Diagnostics& diagnostics) {
  notices_.warn(QString::fromLatin1(kWarning), QString::fromStdString(diagnostics.front().message));
}

void RunSharing::updateNotices() {
  const int branch = workspace_.runner().branch();
  const bool isAnother = branch != branch_;
  branch_ = branch;
  if (!isLive() || isAnother) {
    notices_.drop(QString::fromLatin1(kWatched));
    notices_.drop(QString::fromLatin1(kWarning));
  }
}

using editor::SimulationRunner;

namespace {

constexpr const char* kTrails = "run/trailSeconds";
constexpr const char* kLoops = "run/loops";                    // rows: folder, A, B
constexpr double kShortestTrail = 1.0, kLongestTrail = 600.0;  // [s]

QString rowOf(const QString& folder, const SimulationRunner::LoopRange& part) {
  return QStringLiteral("%1\t%2\t%3")
      .arg(folder)
      .arg(part.from, 0, 'g', 17)
      .arg(part.to, 0, 'g', 17);
}

}  // namespace

PlaybackSettings::PlaybackSettings(Workspace& workspace, UserSettings& userSettings,
                                   QObject* parent)
    : QObject(parent), workspace_(workspace), userSettings_(userSettings) {
  editor::MapScene& scene = workspace_.scene();
  const double seconds = userSettings_.value(kTrails).toDouble();
  if (seconds >= kShortestTrail && seconds <= kLongestTrail) {
    editor::CanvasOptions options = scene.options();
    options.trailSeconds = seconds;
    scene.setOptions(options);
  }
  connect(&scene, &editor::MapScene::optionsChanged, this,
          [this] { userSettings_.setValue(kTrails, workspace_.scene().options().trailSeconds); });
  connect(&workspace_.runner(), &SimulationRunner::loopChanged, this, &PlaybackSettings::storeLoop);
}

void PlaybackSettings::restoreLoop(const QString& folder) {
  folder_ = folder;
  SimulationRunner& runner = workspace_.runner();
  const double end = runner.recording()->timeOf(runner.recording()->size() - 1);
  for (const QString& row : userSettings_.value(kLoops).toStringList()) {
    const QStringList parts = row.split(QLatin1Char('\t'));
    const SimulationRunner::LoopRange part{parts.value(1).toDouble(), parts.value(2).toDouble()};
    const bool isInside = part.from >= 0.0 && part.from < part.to && part.from < end;
    if (parts.size() == 3 && parts.front() == folder && isInside) {
      runner.setLoop(part);
      return;
    }
  }
}

/// Closing a run clears its loop; this is not stored as a change by the user.
void PlaybackSettings::storeLoop() {
  const SimulationRunner& runner = workspace_.runner();
  if (!workspace_.isRecordedRun() || runner.recording() == nullptr || folder_.isEmpty()) {
    return;
  }
  QStringList rows = userSettings_.value(kLoops).toStringList();
  for (int k = rows.size() - 1; k >= 0; --k) {
    if (rows[k].startsWith(folder_ + QLatin1Char('\t'))) {
      rows.removeAt(k);
    }
  }
  if (runner.loop()) {
    rows.prepend(rowOf(folder_, *runner.loop()));
  }
  userSettings_.setValue(kLoops, QStringList(rows.mid(0, kMostLoops)));
}

namespace {

constexpr const char* kMemoryKey = "run/history-megabytes";
constexpr std::size_t kMega = std::size_t{1} << 20;
constexpr int kTextWidth = 380;  // [px]

QString megabytesText(std::size_t bytes) {
  return QObject::tr("%1 MB").arg(double(bytes) / double(kMega), 0, 'f', 1);
}

/// The usage of the displayed run: "12.0 MB in memory, 3.1 MB on the disk".
QString useText(const sim2d::Recording& run) {
  const sim2d::FrameHistory& history = run.history();
  QString text = QObject::tr("The displayed run uses %1 of memory and %2 of disk space.")
                     .arg(megabytesText(history.memory()), megabytesText(history.disk()));
  if (run.first() > 0) {
    text += QObject::tr(" The disk is full: the timeline starts at %1.")
                .arg(editor::clockText(run.timeOf(run.first())));
  }
  return text;
}

}  // namespace

std::size_t historyMemory(const UserSettings& memory) {
  const int chosen = memory.value(kMemoryKey).toInt();  // 0: never chosen
  return chosen == 0
             ? sim2d::Recording::kDefaultMemory
             : static_cast<std::size_t>(std::clamp(chosen, kLeastHistory, kMostHistory)) * kMega;
}

int usualHistoryMegabytes() {
  return static_cast<int>(sim2d::Recording::kDefaultMemory / kMega);
}

void setHistoryMemory(UserSettings& memory, SimulationRunner& runner, int megabytes) {
  const int valid = std::clamp(megabytes, kLeastHistory, kMostHistory);
  memory.setValue(kMemoryKey, valid);
  runner.setHistory(static_cast<std::size_t>(valid) * kMega);
}

HistoryDialog::HistoryDialog(std::size_t memory, const editor::RecordingPtr& shown,
                             const editor::Theme& theme, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Memory for runs"));
  megabytes_->setRange(kLeastHistory, kMostHistory);
  megabytes_->setSingleStep(kHistoryStep);
  megabytes_->setSuffix(tr(" MB"));
  megabytes_->setAlignment(Qt::AlignRight);
  megabytes_->setValue(static_cast<int>(memory / kMega));
  megabytes_->setAccessibleName(tr("Memory per run"));
  megabytes_->setToolTip(
      tr("Memory per run\nMemory for the steps of a run that the timeline can show. 200 people "
         "need about 12 MB per minute."));
  QLabel* title =
      editor::headingLabel(tr("Memory for runs"), theme.font(12.0, QFont::DemiBold), this);
  QLabel* explanation = editor::secondaryLabel(
      tr("Older steps are stored in a temporary file until the run is closed. When the disk is "
         "full, the oldest are deleted and the timeline starts later."),
      this);
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {16, 16, 16, 12}, 8, {title});
  QFormLayout* form = formRows();
  form->addRow(tr("Memory per run"), megabytes_);
  rows->addLayout(form);
  rows->addWidget(explanation);
  if (shown != nullptr && shown->size() > 0) {
    explanation->setText(explanation->text() + QStringLiteral("\n\n") + useText(*shown));
  }
  QLabel* when = editor::secondaryLabel(tr("Applies to runs started from now on."), this);
  for (QLabel* label : {explanation, when}) {
    label->setWordWrap(true);
    label->setMinimumWidth(kTextWidth);
  }
  rows->addWidget(when);
  rows->addSpacing(8);
  addButtons(this, *rows, tr("Set"));
  megabytes_->setFocus();
  megabytes_->selectAll();
}

std::size_t HistoryDialog::memory() const {
  return static_cast<std::size_t>(megabytes_->value()) * kMega;
}

void showHistoryDialog(UserSettings& memory, editor::SimulationRunner& runner,
                       const editor::Theme& theme, QWidget* parent) {
  HistoryDialog dialog(runner.historyMemory(), runner.recording(), theme, parent);
  if (dialog.exec() == QDialog::Accepted) {
    setHistoryMemory(memory, runner, static_cast<int>(dialog.memory() / kMega));
  }
}

namespace {

constexpr double kSharp = 300.0 / 96.0;      // PNG pixels per CSS pixel
constexpr std::size_t kMostStates = 400000;  // body states per figure

PictureLayout paperLayout(FigureOptions options) {
  PictureLayout layout;
  layout.width = kVectorWidth * kPixelsPerMm;
  layout.textAsOutlines = true;
  layout.options = std::move(options);
  return layout;
}

}  // namespace

std::unique_ptr<QMimeData> copiedFigure(const QSizeF& size, const std::string& svg,
                                        const std::function<void(QPainter&)>& paint) {
  QImage image = editor::blankImage((size * kSharp).toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.scale(kSharp, kSharp);
  paint(painter);
  painter.end();
  image.setDotsPerMeterX(11811);  // 300 dpi
  image.setDotsPerMeterY(11811);
  auto data = std::make_unique<QMimeData>();
  data->setImageData(image);
  data->setData(QStringLiteral("image/svg+xml"), QByteArray::fromStdString(svg));
  return data;
}

sim2d::Trace figureTrace(const sim2d::Recording& recording, double time) {
  sim2d::Trace trace;
  trace.header = *recording.header();
  if (recording.size() == 0) {
    return trace;
  }
  const std::size_t last = recording.indexAtTime(time);
  const std::size_t first = recording.first();
  const sim2d::FramePtr shown = recording.frameIfKept(last);
  const std::size_t bodies = shown != nullptr ? shown->humans.size() + shown->robots.size() : 1;
  const std::size_t stride =
      1 + (last - std::min(first, last)) * std::max<std::size_t>(1, bodies) / kMostStates;
  for (std::size_t k = first; k < last; k += stride) {
    if (const sim2d::FramePtr frame = recording.frameIfKept(k)) {
      trace.frames.push_back(*frame);
    }
  }
  if (shown != nullptr) {
    trace.frames.push_back(*shown);
  }
  for (std::size_t k = 0; k < recording.events().size(); ++k) {
    trace.events.push_back(recording.events()[k]);
  }
  return trace;
}

FigureCommands::FigureCommands(Workspace& workspace, Docks& docks, const WindowActions& actions,
                               QObject* parent)
    : QObject(parent), workspace_(workspace), docks_(docks), actions_(actions) {
  connect(actions_.copyFigure, &QAction::triggered, this, &FigureCommands::copyMap);
  connect(actions_.copyPlot, &QAction::triggered, this, &FigureCommands::copyPlot);
  connect(actions_.savePlot, &QAction::triggered, this, [this] {
    const editor::MetricPlot& plot = docks_.panel<editor::MetricsDock>().plot();
    Q_EMIT docks_.context().plotExportRequested(plot.figure(), true);
  });
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this,
          &FigureCommands::updateEnabled);
  connect(&workspace_.feed(), &editor::MetricsFeed::updated, this, &FigureCommands::updateEnabled);
  connect(&workspace_.feed(), &editor::MetricsFeed::cleared, this, &FigureCommands::updateEnabled);
  updateEnabled();
}

void FigureCommands::updateEnabled() {
  const QString noRun = tr("Start a run first: Space");
  editor::setEnabled(*actions_.copyFigure, workspace_.runner().recording() != nullptr, noRun);
  for (QAction* action : {actions_.copyPlot, actions_.savePlot}) {
    editor::setEnabled(*action, !workspace_.feed().snapshot().curves.empty(), noRun);
  }
}

FigureOptions figureOptionsOf(const editor::MapScene& scene) {
  const editor::CanvasOptions& on = scene.options();
  FigureOptions options;
  const std::pair<bool, FigureOverlay> overlays[] = {
      {on.density, FigureOverlay::Density},   {on.proxemics, FigureOverlay::Zones},
      {on.gaussian, FigureOverlay::Gaussian}, {on.velocities, FigureOverlay::Velocities},
      {on.forces, FigureOverlay::Forces},     {on.contacts, FigureOverlay::Contacts}};
  for (const auto& [isOn, overlay] : overlays) {
    if (isOn) {
      options.overlays.insert(overlay);
    }
  }
  options.names = on.names;
  const editor::ScenarioDocument& document = scene.document();
  for (const sim2d::Human& human : document.scenario().humans) {
    if (editor::shownLookOf(document, human) == editor::Look::CustomTree) {
      options.customTrees.insert(human.id);
    }
  }
  return options;
}

void FigureCommands::copyMap() {
  const editor::RecordingPtr recording = workspace_.runner().recording();
  const editor::FramePtr frame = workspace_.runner().shownFrame();
  if (recording == nullptr || frame == nullptr) {
    return;
  }
  const sim2d::Trace trace = figureTrace(*recording, frame->time);
  RunPicture picture(trace, paperLayout(figureOptionsOf(workspace_.scene())));
  const Paint paint = [&](QPainter& painter) { picture.paint(painter, frame->time); };
  const std::string svg =
      svgOf(picture.size(), QString::fromStdString(trace.header.scenario), paint);
  QGuiApplication::clipboard()->setMimeData(copiedFigure(picture.size(), svg, paint).release());
  Q_EMIT message(tr("Copied the map at %1 s as PNG and SVG").arg(frame->time, 0, 'f', 1));
}

std::string FigureCommands::selectedMetric() const {
  return docks_.panel<editor::MetricsDock>().shownKey();
}

/// Plots the selected metric, or the first one with a curve.
void FigureCommands::copyPlot() {
  const editor::MetricSnapshot& now = workspace_.feed().snapshot();
  const auto chosen = now.curves.find(selectedMetric());
  const auto curve = chosen != now.curves.end() ? chosen : now.curves.begin();
  const metrics::MetricResult* const result =
      curve == now.curves.end() ? nullptr : metrics::findResult(now.results, curve->first);
  const editor::RecordingPtr recording = workspace_.runner().recording();
  if (result == nullptr || recording == nullptr) {
    return;
  }
  const std::string caption =
      recording->header()->scenario + " · seed " + std::to_string(recording->header()->seed);
  const report::Figure plot = report::timePlot(
      {{result->info.name, curve->second.axisUnit(), curve->second.times, curve->second.values}},
      kVectorWidth * kPixelsPerMm, caption);
  const auto [size, paint] = paintingOf(plot);
  QGuiApplication::clipboard()->setMimeData(copiedFigure(size, plot.standalone(), paint).release());
  Q_EMIT message(
      tr("Copied the plot of “%1” as PNG and SVG").arg(editor::coreText(result->info.name)));
}

}  // namespace app
