#include "app/window/PlotExport.h"

#include "app/cli/RunExport.h"
#include "app/report/RunPictures.h"
#include "app/window/RunCommands.h"
#include "editor/look/TableExport.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kDpiScale = 300.0 / 96.0;  // PNG pixels per CSS pixel

report::TimeCurve timeCurveOf(const editor::PlottedFigure& plot,
                              const editor::PlottedCurve& curve) {
  return {plot.name.toStdString(), plot.unit.toStdString(), curve.times, curve.values,
          curve.label.toStdString()};
}

}  // namespace

PlotExport::PlotExport(Workspace& workspace, editor::PanelContext& context, QWidget& window)
    : QObject(&window), workspace_(workspace), window_(window) {
  connect(&context, &editor::PanelContext::plotExportRequested, this,
          [this](const editor::PlottedFigure& plot, bool toFile) {
            if (!plot.curves.empty()) {
              toFile ? save(plot) : copy(plot);
            }
          });
}

report::Figure PlotExport::figureOf(const editor::PlottedFigure& plot) const {
  report::TimeCurve panel = timeCurveOf(plot, plot.curves.front());
  for (std::size_t k = 1; k < plot.curves.size(); ++k) {
    panel.overlaid.push_back(timeCurveOf(plot, plot.curves[k]));
  }
  std::string caption;
  if (const editor::RecordingPtr recording = workspace_.runner().recording()) {
    const sim2d::TraceHeader& header = *recording->header();
    caption = header.scenario + " · seed " + std::to_string(header.seed);
  }
  return report::timePlot({panel}, kVectorWidth * kPixelsPerMm, caption);
}

void PlotExport::copy(const editor::PlottedFigure& plot) {
  const report::Figure figure = figureOf(plot);
  const auto [size, paint] = paintingOf(figure);
  QGuiApplication::clipboard()->setMimeData(
      copiedFigure(size, figure.standalone(), paint).release());
  Q_EMIT message(tr("Copied the plot of “%1” as PNG and SVG").arg(plot.name));
}

void PlotExport::save(const editor::PlottedFigure& plot) {
  const QString file = editor::askFileToSave(
      window_, tr("Save plot"), plot.name,
      {tr("Picture (*.png)"), tr("Vector picture (*.svg)"), tr("PDF (*.pdf)")});
  if (file.isEmpty()) {
    return;
  }
  const QString ending = QFileInfo(file).suffix().toLower();
  const bool isVector = ending == QLatin1String("svg") || ending == QLatin1String("pdf");
  const base::Diagnostics problems = base::writeFileAtomically(
      file.toStdString(),
      figureFile(figureOf(plot), isVector ? "." + ending.toStdString() : ".png", kDpiScale));
  if (base::hasErrors(problems)) {
    QMessageBox::warning(&window_, tr("Save plot"),
                         QString::fromStdString(problems.front().text()));
    return;
  }
  Q_EMIT message(tr("Saved the plot of “%1” to %2").arg(plot.name, QFileInfo(file).fileName()));
}

}  // namespace app
