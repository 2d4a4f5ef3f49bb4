#include "app/window/runs/FigureCommands.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QMimeData>

#include "app/cli/PictureFiles.h"
#include "app/cli/RunPicture.h"
#include "app/report/TimePlot.h"
#include "editor/look/Images.h"
#include "editor/panels/MetricsDock.h"

namespace app {

namespace {

constexpr double kTwoColumns = 170.0;        // [mm], two columns of a paper
constexpr double kPxPerMm = 96.0 / 25.4;     // as in CSS
constexpr double kSharp = 300.0 / 96.0;      // PNG pixels per CSS pixel
constexpr std::size_t kMostStates = 400000;  // body states per figure

PictureLayout paperLayout(FigureOptions options) {
  PictureLayout layout;
  layout.width = kTwoColumns * kPxPerMm;
  layout.textAsOutlines = true;
  layout.options = std::move(options);
  return layout;
}

/// The figure as pixels for office programs and as vectors for drawing programs.
std::unique_ptr<QMimeData> copiedFigure(const QSizeF& size, const std::string& svg,
                                        const Paint& paint) {
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

}  // namespace

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
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this,
          &FigureCommands::updateEnabled);
  connect(&workspace_.feed(), &editor::MetricsFeed::updated, this, &FigureCommands::updateEnabled);
  connect(&workspace_.feed(), &editor::MetricsFeed::cleared, this, &FigureCommands::updateEnabled);
  updateEnabled();
}

void FigureCommands::updateEnabled() {
  actions_.copyFigure->setEnabled(workspace_.runner().recording() != nullptr);
  actions_.copyPlot->setEnabled(!workspace_.feed().snapshot().curves.empty());
}

FigureOptions FigureCommands::options() const {
  const editor::CanvasOptions& on = workspace_.scene().options();
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
  return options;
}

void FigureCommands::copyMap() {
  const editor::RecordingPtr recording = workspace_.runner().recording();
  const editor::FramePtr frame = workspace_.runner().shownFrame();
  if (recording == nullptr || frame == nullptr) {
    return;
  }
  const sim2d::Trace trace = figureTrace(*recording, frame->time);
  RunPicture picture(trace, paperLayout(options()));
  const Paint paint = [&](QPainter& painter) { picture.paint(painter, frame->time); };
  const std::string svg =
      svgOf(picture.size(), QString::fromStdString(trace.header.scenario), paint);
  QGuiApplication::clipboard()->setMimeData(copiedFigure(picture.size(), svg, paint).release());
  Q_EMIT message(tr("Copied the map at %1 s as PNG and SVG").arg(frame->time, 0, 'f', 1));
}

std::string FigureCommands::selectedMetric() const {
  const QModelIndexList rows =
      docks_.panel<editor::MetricsDock>().table().selectionModel()->selectedRows();
  return rows.isEmpty() ? std::string() : rows.front().data(Qt::UserRole).toString().toStdString();
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
      {{result->info.name, result->info.unit, curve->second.times, curve->second.values}},
      kTwoColumns * kPxPerMm, caption);
  const auto [size, paint] = paintingOf(plot);
  QGuiApplication::clipboard()->setMimeData(copiedFigure(size, plot.standalone(), paint).release());
  Q_EMIT message(
      tr("Copied the plot of “%1” as PNG and SVG").arg(QString::fromStdString(result->info.name)));
}

}  // namespace app
