#include <algorithm>
#include <cmath>

#include "app/window/export/RunExportDialog.h"

namespace app {

namespace {

constexpr double kTimeStep = 0.1;  // [s]
constexpr int kSliderSteps = 1000;

}  // namespace

SaveFilmDialog::SaveFilmDialog(ExportSource source, AskExportFile askFile,
                               const editor::Theme& theme, QWidget* parent)
    : RunExportDialog(std::move(source), std::move(askFile), theme, parent) {
  const auto format = [](const QString& name, const char* ending) {
    return Format{name, ending, Movie::isAvailable(ending)};
  };
  build(tr("Save film"), {format(tr("GIF"), ".gif"), format(tr("MP4 (H.264)"), ".mp4"),
                          format(tr("WebP"), ".webp"), format(tr("WebM (VP9)"), ".webm")});
  followRange();
}

void SaveFilmDialog::addFormatRows(QFormLayout& form) {
  if (Movie::isAvailable(".mp4")) {
    return;
  }
  auto* missing = editor::secondaryLabel(
      tr("MP4, WebP and WebM require the program ffmpeg, which is not installed: "
         "sudo apt install ffmpeg"),
      this);
  missing->setWordWrap(true);
  missing->setTextInteractionFlags(Qt::TextSelectableByMouse);
  form.addRow(QString(), missing);
}

void SaveFilmDialog::addTimeRows(QFormLayout& form) {
  const double from = source().from;
  const double to = source().to;
  from_ = addNumber(form, tr("From"), {from, to, 2, kTimeStep}, tr("s"), from);
  to_ = addNumber(form, tr("To"), {from, to, 2, kTimeStep}, tr("s"), to);
  auto* links = editor::configuredLayout(new QHBoxLayout, {}, 12);
  links->addWidget(editor::linkButton(tr("Whole run"), tr("From the start to the end of the run"),
                                      this, [this, from, to] { setRange(from, to); }));
  if (const auto loop = source().loop) {
    links->addWidget(editor::linkButton(tr("Loop section"),
                                        tr("Only the section that the timeline repeats"), this,
                                        [this, loop] { setRange(loop->first, loop->second); }));
  }
  links->addStretch(1);
  form.addRow(QString(), links);
  rate_ = addNumber(form, tr("Frame rate"), {1.0, 60.0, 0, 1.0}, tr("fps"),
                    FilmTiming().framesPerSecond);
  speed_ =
      addNumber(form, tr("Speed"), {0.05, 100.0, 2, 0.5}, QStringLiteral("×"), FilmTiming().speed);
  speed_->setToolTip(tr("Simulated seconds per second of the film"));
  length_ = editor::secondaryLabel({}, this);
  length_->setWordWrap(true);  // It is longer in other languages.
  form.addRow(QString(), length_);
  at_ = new QSlider(Qt::Horizontal, this);
  at_->setRange(0, kSliderSteps);
  at_->setAccessibleName(tr("Time of the preview"));
  at_->setToolTip(tr("Show another frame of the film in the preview"));
  const double share = to > from ? (source().shown - from) / (to - from) : 0.0;
  at_->setValue(static_cast<int>(std::lround(share * kSliderSteps)));
  form.addRow(tr("Preview"), at_);
  connect(at_, &QSlider::valueChanged, this, &SaveFilmDialog::updatePreview);
  for (const editor::NumberField* field : {from_, to_, rate_, speed_}) {
    connect(field, &editor::NumberField::edited, this, [this] {
      followRange();
      limitRate();
    });
  }
}

void SaveFilmDialog::setRange(double from, double to) {
  from_->show(from, false);
  to_->show(to, false);
  followRange();
  updatePreview();
}

/// GIF viewers do not show more frames per second.
void SaveFilmDialog::limitRate() {
  const bool isGif = ending() == ".gif";
  rate_->setToolTip(
      isGif ? tr("Frames per second of the film; GIF viewers show at most %1").arg(kMaxGifRate)
            : tr("Frames per second of the film"));
  if (isGif && rate_->value() > kMaxGifRate) {
    rate_->show(kMaxGifRate, false);
    followRange();
  }
}

void SaveFilmDialog::followRange() {
  const FilmTiming film = timing();
  length_->setText(isComplete() ? tr("The film has %1 frames and lasts %2 s")
                                      .arg(film.frameCount())
                                      .arg(film.duration(), 0, 'f', 1)
                                : tr("The end must be after the start"));
  updateSave();
}

FilmTiming SaveFilmDialog::timing() const {
  FilmTiming timing;
  timing.from = from_->value();
  timing.to = to_->value();
  timing.framesPerSecond = rate_->value();
  timing.speed = speed_->value();
  return timing;
}

std::vector<RunExportDialog::SizePreset> SaveFilmDialog::presets() const {
  return {{tr("Map, 1280 px wide"), kFilmWidth},
          {tr("HD, 1280 × 720"), 1280.0, 720.0},
          {tr("Full HD, 1920 × 1080"), 1920.0, 1080.0},
          {tr("Small map, 640 px wide"), 640.0}};
}

std::optional<double> SaveFilmDialog::previewTime() const {
  const double share = static_cast<double>(at_->value()) / kSliderSteps;
  return from_->value() + share * std::max(0.0, to_->value() - from_->value());
}

RunExportDialog::Job SaveFilmDialog::job() const {
  return [layout = layoutOfFields(), film = timing()](
             const sim2d::Trace& trace, const std::string& path, const Progress& progress) {
    RunPicture picture(trace, layout);
    return writeFilm(path, picture, film, progress);
  };
}

}  // namespace app
