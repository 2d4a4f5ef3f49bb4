#include "app/window/export/RunExportDialog.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/files/FileDialogs.h"
#include "editor/look/FigurePainter.h"

namespace app {

namespace {

constexpr int kOptionsWidth = 316;
constexpr int kPollMs = 40;
constexpr int kLeastField = 64;  // [px]
constexpr double kLeastFigureHeight =
    300.0;                          // [px] of the figure; smaller ones have no room for the map
constexpr double kAutomatic = 0.0;  // height that the map requires
constexpr double kLeastPx = 200.0, kMostPx = 8000.0;
constexpr double kLeastMm = 50.0, kMostMm = 2000.0;

struct OverlayLabel {
  FigureOverlay overlay;
  const char* text;
  const char* tip;
};
constexpr OverlayLabel kOverlayLabels[] = {
    {FigureOverlay::Density, QT_TRANSLATE_NOOP("app::RunExportDialog", "Density"),
     QT_TRANSLATE_NOOP("app::RunExportDialog", "People per m² as colours")},
    {FigureOverlay::Zones, QT_TRANSLATE_NOOP("app::RunExportDialog", "Hall zones"),
     QT_TRANSLATE_NOOP("app::RunExportDialog",
                       "Intimate, personal and social zone around each person, "
                       "after E. T. Hall: 0.45, 1.2 and 3.6 m")},
    {FigureOverlay::Gaussian, QT_TRANSLATE_NOOP("app::RunExportDialog", "Gaussian spaces"),
     QT_TRANSLATE_NOOP("app::RunExportDialog",
                       "Personal space of each person as a Gaussian function, "
                       "longer in the walking direction")},
    {FigureOverlay::Velocities, QT_TRANSLATE_NOOP("app::RunExportDialog", "Velocities"),
     QT_TRANSLATE_NOOP("app::RunExportDialog", "Velocity of each person and robot as an arrow")},
    {FigureOverlay::Forces, QT_TRANSLATE_NOOP("app::RunExportDialog", "Forces"),
     QT_TRANSLATE_NOOP("app::RunExportDialog", "Forces on each person as arrows")},
    {FigureOverlay::Contacts, QT_TRANSLATE_NOOP("app::RunExportDialog", "Contacts"),
     QT_TRANSLATE_NOOP("app::RunExportDialog", "Places where people or robots touched")}};

/// The image of the figure in a rectangle of this size [px], with its proportions.
QImage imageOf(const sim2d::Trace& trace, const PictureLayout& layout, std::optional<double> time,
               const QSizeF& room) {
  RunPicture picture(trace, layout);
  const double scale =
      std::min(room.width() / picture.size().width(), room.height() / picture.size().height());
  const QSize pixels = (scale * picture.size()).toSize().expandedTo(QSize(1, 1));
  QImage image = editor::blankImage(pixels, QImage::Format_RGB32);
  image.fill(picture.ground());
  QPainter painter(&image);
  painter.scale(scale, scale);
  picture.paint(painter, time);
  return image;
}

}  // namespace

ExportPreview::ExportPreview(const editor::Theme& theme, QWidget* parent)
    : QWidget(parent), theme_(theme), task_([this](QImage image) {
        image_ = std::move(image);
        text_.clear();
        update();
      }) {
  setMinimumSize(320, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Preview"));
}

ExportPreview::~ExportPreview() {
  task_.abandon();
}

void ExportPreview::show(std::shared_ptr<const sim2d::Trace> trace, const PictureLayout& layout,
                         std::optional<double> time) {
  trace_ = std::move(trace);
  layout_ = layout;
  time_ = time;
  render();
}

void ExportPreview::showText(const QString& text) {
  text_ = text;
  update();
}

void ExportPreview::render() {
  if (trace_ == nullptr) {
    return;
  }
  const double ratio = devicePixelRatioF();
  const QSizeF room = QSizeF(size() - QSize(2, 2)) * ratio;
  task_.start([trace = trace_, layout = layout_, time = time_, room, ratio] {
    QImage image = imageOf(*trace, layout, time, room);
    image.setDevicePixelRatio(ratio);
    return image;
  });
}

void ExportPreview::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.color(editor::Role::CanvasOutside));
  if (!text_.isEmpty() || image_.isNull()) {
    painter.setPen(theme_.color(editor::Role::TextSecondary));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     text_.isEmpty() ? tr("Preparing the preview…") : text_);
    return;
  }
  const QSizeF shown = QSizeF(image_.size()) / image_.devicePixelRatio();
  QRectF place(QPointF(), shown.scaled(QSizeF(size() - QSize(2, 2)), Qt::KeepAspectRatio));
  place.moveCenter(QRectF(rect()).center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place.toAlignedRect(), image_);
  painter.setPen(theme_.color(editor::Role::Line));
  painter.drawRect(place.toAlignedRect().adjusted(-1, -1, 0, 0));
}

void ExportPreview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  render();
}

RunExportDialog::RunExportDialog(ExportSource source, AskExportFile askFile,
                                 const editor::Theme& theme, QWidget* parent)
    : QDialog(parent),
      source_(std::move(source)),
      askFile_(std::move(askFile)),
      theme_(theme),
      preview_(new ExportPreview(theme, this)),
      reading_(
          [this](const std::shared_ptr<base::Result<sim2d::Trace>>& trace) { takeTrace(trace); }),
      writing_([this](const std::shared_ptr<Outcome>& outcome) { finishWriting(*outcome); }) {
  poll_.setInterval(kPollMs);
  connect(&poll_, &QTimer::timeout, this, &RunExportDialog::showProgress);
}

RunExportDialog::~RunExportDialog() {
  if (shared_ != nullptr) {
    shared_->isStopped = true;
  }
  writing_.abandon();
  reading_.abandon();
}

void RunExportDialog::build(const QString& title, const std::vector<Format>& formats) {
  setWindowTitle(title);
  resize(980, editor::limitedToScreen(*this, 620));
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {16, 16, 16, 12}, 12);
  auto* columns = editor::configuredLayout(new QHBoxLayout, {}, 16, {preview_});
  columns->setStretch(0, 1);
  side_->setLayout(makeForm(formats));
  QScrollArea* scrolled = editor::scrollArea(side_, this);
  scrolled->setFixedWidth(kOptionsWidth);
  columns->addWidget(scrolled);
  rows->addLayout(columns, 1);
  rows->addLayout(makeFoot());
  fillPresets();
  followFormat();
  reading_.start(
      [read = source_.trace] { return std::make_shared<base::Result<sim2d::Trace>>(read()); });
}

QLayout* RunExportDialog::makeForm(const std::vector<Format>& formats) {
  auto* rows = editor::configuredLayout(new QVBoxLayout, {}, 12);
  QFormLayout* form = formRows();
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* model = qobject_cast<QStandardItemModel*>(format_->model());
  for (const Format& format : formats) {
    format_->addItem(format.isAvailable ? format.name : tr("%1 – requires ffmpeg").arg(format.name),
                     QString::fromStdString(format.ending));
    model->item(format_->count() - 1)->setEnabled(format.isAvailable);
  }
  format_->setAccessibleName(tr("Format"));
  connect(format_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    fillPresets();
    followFormat();
    updatePreview();
  });
  form->addRow(tr("Format"), format_);
  addFormatRows(*form);
  addSizeRows(*form);
  addTimeRows(*form);
  colours_->addItems({tr("Light"), tr("Dark")});
  colours_->setAccessibleName(tr("Theme"));
  colours_->setCurrentIndex(source_.options.isDark ? 1 : 0);
  connect(colours_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          &RunExportDialog::updatePreview);
  form->addRow(tr("Theme"), colours_);
  timeMarks_ =
      addNumber(*form, tr("Time marks"), {0.0, 600.0, 1, 1.0}, tr("s"), source_.options.timeMarks);
  timeMarks_->setToolTip(tr("Marks each trajectory with the time at this interval; 0: no marks"));
  timeMarks_->setEnabled(source_.isRun);
  for (QWidget* field : side_->findChildren<QWidget*>()) {
    if (qobject_cast<QComboBox*>(field) != nullptr ||
        qobject_cast<QAbstractSpinBox*>(field) != nullptr) {
      field->setMinimumWidth(kLeastField);  // Long texts do not widen the column.
      field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
  }
  rows->addLayout(form);
  rows->addWidget(makeOverlays());
  rows->addStretch(1);
  return rows;
}

void RunExportDialog::addSizeRows(QFormLayout& form) {
  size_->setAccessibleName(tr("Size"));
  size_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(size_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          &RunExportDialog::choosePreset);
  form.addRow(tr("Size"), size_);
  for (QDoubleSpinBox* box : {width_, height_}) {
    box->setLocale(QLocale::c());
    box->setDecimals(0);
    box->setAlignment(Qt::AlignRight);
    box->setKeyboardTracking(false);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &RunExportDialog::customizeSize);
  }
  width_->setAccessibleName(tr("Width"));
  height_->setAccessibleName(tr("Height"));
  height_->setSpecialValueText(tr("automatic"));
  height_->setToolTip(
      tr("Height\nThe lowest value, “automatic”, is the height that the map needs "
         "at this width"));
  auto* both = editor::configuredLayout(new QHBoxLayout, {}, 4, {width_});
  both->addWidget(new QLabel(QStringLiteral("×"), side_));
  both->addWidget(height_, 1);
  both->setStretch(0, 1);
  form.addRow(QString(), both);
}

QWidget* RunExportDialog::makeOverlays() {
  auto* box = new QWidget(side_);
  auto* rows = editor::configuredLayout(new QVBoxLayout(box), {}, 4);
  rows->addWidget(editor::headingLabel(tr("Overlays"), theme_.font(9.5, QFont::DemiBold), box));
  auto* grid = editor::configuredLayout(new QGridLayout, {}, 4);
  int place = 0;
  const auto add = [&](QCheckBox* check, bool isOn, const QString& tip) {
    check->setChecked(isOn);
    check->setToolTip(tip);
    connect(check, &QCheckBox::toggled, this, &RunExportDialog::updatePreview);
    grid->addWidget(check, place / 2, place % 2);
    ++place;
  };
  add(names_, source_.options.names, tr("Names of people and robots"));
  for (const OverlayLabel& label : kOverlayLabels) {
    const bool isForces = label.overlay == FigureOverlay::Forces;
    const bool isOfRun =
        label.overlay == FigureOverlay::Velocities || label.overlay == FigureOverlay::Contacts;
    const bool isThere = isForces ? source_.hasForces : source_.isRun || !isOfRun;
    auto* check = new QCheckBox(tr(label.text), box);
    add(check, isThere && source_.options.overlays.count(label.overlay) > 0,
        isThere    ? tr(label.tip)
        : isForces ? tr("Recorded runs contain no forces: run the scenario to show them")
                   : tr("Only a run has this: run the scenario first"));
    check->setEnabled(isThere);
    overlays_.emplace_back(check, label.overlay);
  }
  rows->addLayout(grid);
  return box;
}

editor::NumberField* RunExportDialog::addNumber(QFormLayout& form, const QString& label,
                                                const editor::NumberField::Range& range,
                                                const QString& unit, double value) {
  auto* field = new editor::NumberField(range, unit, side_);
  field->show(value, false);
  field->setAccessibleName(label);
  connect(field, &editor::NumberField::edited, this, &RunExportDialog::updatePreview);
  form.addRow(label, field);
  return field;
}

QLayout* RunExportDialog::makeFoot() {
  auto* foot = editor::configuredLayout(new QHBoxLayout, {}, 8);
  note_->setWordWrap(true);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(220);
  bar_->setAccessibleName(tr("Progress"));
  QSizePolicy kept = bar_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(kept);
  bar_->hide();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  cancel_ = buttons->button(QDialogButtonBox::Cancel);
  save_ = buttons->addButton(tr("Save…"), QDialogButtonBox::ActionRole);
  save_->setDefault(true);
  save_->setEnabled(false);
  connect(save_, &QPushButton::clicked, this, &RunExportDialog::chooseFile);
  connect(cancel_, &QPushButton::clicked, this, &RunExportDialog::reject);
  foot->addWidget(bar_);
  foot->addWidget(note_, 1);
  foot->addWidget(buttons);
  return foot;
}

std::string RunExportDialog::ending() const {
  return format_->currentData().toString().toStdString();
}

void RunExportDialog::fillPresets() {
  const QScopedValueRollback<bool> filling(isFilling_, true);
  const bool isMm = isInMillimetres();
  const bool isSameUnit = size_->property("millimetres") == QVariant(isMm) && size_->count() > 0;
  if (isSameUnit) {
    return;
  }
  size_->setProperty("millimetres", isMm);
  presets_ = presets();
  size_->clear();
  for (const SizePreset& preset : presets_) {
    size_->addItem(preset.name);
  }
  size_->addItem(tr("Custom"));
  const QString unit = isMm ? tr(" mm") : tr(" px");
  width_->setSuffix(unit);
  height_->setSuffix(unit);
  width_->setRange(isMm ? kLeastMm : kLeastPx, isMm ? kMostMm : kMostPx);
  // The lowest value stands for the automatic height.
  height_->setRange(std::ceil(isMm ? kLeastFigureHeight / kPixelsPerMm : kLeastFigureHeight) - 1.0,
                    isMm ? kMostMm : kMostPx);
  size_->setCurrentIndex(0);
  choosePreset(0);
}

void RunExportDialog::choosePreset(int index) {
  if (index < 0 || index >= static_cast<int>(presets_.size())) {
    return;
  }
  const SizePreset& preset = presets_[static_cast<std::size_t>(index)];
  {
    const QScopedValueRollback<bool> filling(isFilling_, true);
    scale_ = preset.scale;
    width_->setValue(preset.width);
    height_->setValue(preset.height == kAutomatic ? height_->minimum() : preset.height);
  }
  updatePreview();
}

void RunExportDialog::customizeSize() {
  if (isFilling_) {
    return;
  }
  const QSignalBlocker blocked(size_);
  size_->setCurrentIndex(size_->count() - 1);
  scale_ = 1.0;
  updatePreview();
}

PictureLayout RunExportDialog::layoutOfFields() const {
  const double pixels = isInMillimetres() ? kPixelsPerMm : 1.0 / scale_;
  const int index = size_->currentIndex();
  const bool isPreset = index >= 0 && index < static_cast<int>(presets_.size());
  // The fields round the sizes of presets.
  const double width = isPreset ? presets_[static_cast<std::size_t>(index)].width : width_->value();
  PictureLayout layout;
  layout.width = width * pixels;
  if (height_->value() > height_->minimum()) {
    layout.height = height_->value() * pixels;
  }
  layout.textAsOutlines = ending() == ".svg";
  for (const auto& [check, overlay] : overlays_) {
    if (check->isChecked()) {
      layout.options.overlays.insert(overlay);
    }
  }
  layout.options.names = names_->isChecked();
  layout.options.timeMarks = timeMarks_->value();
  layout.options.isDark = colours_->currentIndex() == 1;
  layout.options.customTrees = source_.options.customTrees;
  return layout;
}

void RunExportDialog::updatePreview() {
  if (!isFilling_ && trace_ != nullptr) {
    preview_->show(trace_, layoutOfFields(), previewTime());
  }
}

void RunExportDialog::updateSave() {
  save_->setEnabled(trace_ != nullptr && !isWriting_ && isComplete());
}

void RunExportDialog::takeTrace(const std::shared_ptr<base::Result<sim2d::Trace>>& trace) {
  if (!*trace) {
    preview_->showText(tr("The picture cannot be drawn: %1")
                           .arg(QString::fromStdString(trace->diagnostics().front().message)));
    return;
  }
  trace_ = std::make_shared<const sim2d::Trace>(std::move(**trace));
  updateSave();
  updatePreview();
}

void RunExportDialog::chooseFile() {
  editor::commitPendingEdit(*this);
  const QString path = askFile_(suggestedName() + QString::fromStdString(ending()),
                                QString::fromStdString(ending()));
  if (!path.isEmpty()) {
    write(path);
  }
}

void RunExportDialog::write(const QString& path) {
  shared_ = std::make_shared<Shared>();
  setWriting(true);
  writing_.start([shared = shared_, trace = trace_, path, run = job()] {
    const Progress progress = [&shared](long long frame, long long count) {
      shared->frame = frame;
      shared->count = count;
      return !shared->isStopped;
    };
    return std::make_shared<Outcome>(Outcome{run(*trace, path.toStdString(), progress), path});
  });
}

void RunExportDialog::setWriting(bool on) {
  isWriting_ = on;
  side_->setEnabled(!on);
  updateSave();
  cancel_->setText(on ? tr("Stop") : tr("Cancel"));
  bar_->setVisible(on);
  bar_->setRange(0, 0);
  note_->clear();
  if (on) {
    cancel_->setFocus();
    poll_.start();
  } else {
    poll_.stop();
    save_->setFocus();
  }
}

void RunExportDialog::showProgress() {
  const long long count = shared_->count;
  if (count > 1 && !shared_->isStopped) {
    bar_->setRange(0, static_cast<int>(count));
    bar_->setValue(static_cast<int>(shared_->frame));
    note_->setText(tr("Frame %1 of %2").arg(shared_->frame).arg(count));
  }
}

void RunExportDialog::finishWriting(const Outcome& outcome) {
  setWriting(false);
  if (!outcome.isComplete) {
    note_->setText(
        tr("Not saved: %1")
            .arg(QString::fromStdString(outcome.isComplete.diagnostics().front().message)));
  } else if (!*outcome.isComplete) {
    note_->setText(tr("Stopped. No file was written."));
  } else {
    savedFile_ = outcome.path;
    accept();
  }
}

/// The tab order is that of the form, from top to bottom.
void RunExportDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  QList<QWidget*> fields;
  for (QWidget* field : side_->findChildren<QWidget*>()) {
    if ((field->focusPolicy() & Qt::TabFocus) != 0 && field->focusProxy() == nullptr) {
      fields << field;
    }
  }
  const auto place = [this](const QWidget* field) { return field->mapTo(side_, QPoint()); };
  std::stable_sort(fields.begin(), fields.end(), [&](const QWidget* a, const QWidget* b) {
    return std::pair(place(a).y(), place(a).x()) < std::pair(place(b).y(), place(b).x());
  });
  for (int k = 1; k < fields.size(); ++k) {
    setTabOrder(fields[k - 1], fields[k]);
  }
}

void RunExportDialog::reject() {
  if (!isWriting_) {
    QDialog::reject();
    return;
  }
  shared_->isStopped = true;
  bar_->setRange(0, 0);
  note_->setText(tr("Stopping…"));
}

}  // namespace app
