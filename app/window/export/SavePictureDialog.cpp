#include <cmath>

#include "app/window/export/RunExportDialog.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kPrintScale = 300.0 / 96.0;  // pixels of a PNG for print per pixel of the figure
constexpr double kPrintDots = 300.0 / 25.4;   // pixels per mm
constexpr double kOneColumn = 85.0;           // [mm]
constexpr double kSlideWidth = 338.7, kSlideHeight = 190.5;  // [mm], 16 : 9

}  // namespace

SavePictureDialog::SavePictureDialog(ExportSource source, AskExportFile askFile,
                                     const editor::Theme& theme, QWidget* parent)
    : RunExportDialog(std::move(source), std::move(askFile), theme, parent) {
  build(tr("Save picture"), {{tr("PNG – pixel graphics"), ".png"},
                             {tr("SVG – vector graphics"), ".svg"},
                             {tr("PDF – vector graphics"), ".pdf"}});
}

void SavePictureDialog::addTimeRows(QFormLayout& form) {
  if (!this->source().isRun) {
    return;
  }
  time_ =
      addNumber(form, tr("Time"), {source().from, source().to, 2, 0.1}, tr("s"), source().shown);
  auto* slider = new editor::LinkedSlider(*time_, source().to, this);
  slider->setAccessibleName(tr("Time of the picture"));
  form.addRow(QString(), slider);
}

std::vector<RunExportDialog::SizePreset> SavePictureDialog::presets() const {
  if (isInMillimetres()) {
    return {{tr("Paper, two columns: 170 mm"), kVectorWidth},
            {tr("Paper, one column: 85 mm"), kOneColumn},
            {tr("Slide, 16 : 9"), kSlideWidth, kSlideHeight}};
  }
  return {{tr("Screen, 1600 × 1000"), PictureLayout().width, kPictureHeight},
          {tr("Slide, 1920 × 1080"), 1920.0, 1080.0},
          {tr("Paper, two columns: 170 mm, 300 dpi"), kVectorWidth * kPrintDots, 0.0, kPrintScale},
          {tr("Paper, one column: 85 mm, 300 dpi"), kOneColumn * kPrintDots, 0.0, kPrintScale}};
}

QString SavePictureDialog::suggestedName() const {
  return time_ == nullptr ? source().name
                          : QStringLiteral("%1_%2s").arg(source().name).arg(time_->value());
}

std::optional<double> SavePictureDialog::previewTime() const {
  return time_ == nullptr ? source().from : time_->value();
}

RunExportDialog::Job SavePictureDialog::job() const {
  return [layout = layoutOfFields(), time = previewTime(), ending = ending(), scale = scale()](
             const sim2d::Trace& trace, const std::string& path,
             const Progress& progress) -> base::Result<bool> {
    RunPicture picture(trace, layout);
    const std::string bytes = runFigureFile(
        picture, [&](QPainter& painter) { picture.paint(painter, time); }, ending,
        trace.header.scenario, scale);
    if (!progress(1, 1)) {
      return false;
    }
    const base::Diagnostics problems = base::writeFileAtomically(path, bytes);
    return base::hasErrors(problems) ? base::Result<bool>(problems) : base::Result<bool>(true);
  };
}

}  // namespace app
