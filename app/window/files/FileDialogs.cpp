#include "app/window/files/FileDialogs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/document/MapEdit.h"
#include "editor/look/Form.h"

namespace app {

namespace {

constexpr int kRecentFiles = 8;
constexpr const char* kRecentKey = "files/recent";
constexpr const char* kNotedKey = "files/noted";  // time of last use, by file
constexpr const char* kStateKey = "files/dialog";
constexpr const char* kSizeKey = "files/dialog-size";
constexpr QSize kSize(920, 560);
constexpr int kPlaces = 150;                                  // width of the folder column
constexpr std::array<int, 4> kColumns = {330, 90, 100, 160};  // name, size, type, date

/// Restores size and state of Qt's own dialog. Native dialogs do this themselves.
void restoreDialog(QFileDialog& dialog, const UserSettings& userSettings) {
  auto* list = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
  if (list == nullptr) {
    return;
  }
  const QSize size = userSettings.value(kSizeKey).toSize();
  dialog.resize(size.isValid()
                    ? size
                    : QSize(kSize.width(), editor::limitedToScreen(dialog, kSize.height())));
  if (!dialog.restoreState(userSettings.value(kStateKey).toByteArray())) {
    dialog.setViewMode(QFileDialog::Detail);
    if (auto* sides = dialog.findChild<QSplitter*>(QStringLiteral("splitter"))) {
      sides->setSizes({kPlaces, kSize.width() - kPlaces});
    }
    list->header()->setStretchLastSection(true);
    for (int column = 0; column < static_cast<int>(kColumns.size()); ++column) {
      list->header()->resizeSection(column, kColumns.at(static_cast<std::size_t>(column)));
    }
  }
}

}  // namespace

UserSettings::UserSettings(bool storesSettings) {
  if (storesSettings) {
    store_ = std::make_unique<QSettings>(QStringLiteral("hunavsim"), QStringLiteral("desktop"));
  }
}

QVariant UserSettings::value(const char* key) const {
  return store_ ? store_->value(QString::fromLatin1(key)) : QVariant();
}

void UserSettings::setValue(const char* key, const QVariant& value) {
  if (store_) {
    store_->setValue(QString::fromLatin1(key), value);
  }
}

QStringList UserSettings::recentFiles() const {
  return value(kRecentKey).toStringList();
}

void UserSettings::addRecentFile(const QString& path) {
  QStringList files = recentFiles();
  const QString whole = QFileInfo(path).absoluteFilePath();
  files.removeAll(whole);
  files.prepend(whole);
  while (files.size() > kRecentFiles) {
    files.removeLast();
  }
  setValue(kRecentKey, files);
  const QVariantMap before = value(kNotedKey).toMap();
  QVariantMap lastUsed;
  for (const QString& file : files) {
    lastUsed[file] = file == whole ? QDateTime::currentDateTime() : before.value(file);
  }
  setValue(kNotedKey, lastUsed);
}

QDateTime UserSettings::lastUsed(const QString& path) const {
  return value(kNotedKey).toMap().value(path).toDateTime();
}

QString askFile(QFileDialog& dialog, UserSettings& userSettings) {
  const QString folder = dialog.directory().absolutePath();
  restoreDialog(dialog, userSettings);
  editor::restrictFileDialog(dialog, dialog.acceptMode() == QFileDialog::AcceptSave);
  dialog.setDirectory(folder);  // restoreState would set the last folder
  const bool isAccepted = dialog.exec() == QDialog::Accepted;
  userSettings.setValue(kStateKey, dialog.saveState());
  userSettings.setValue(kSizeKey, dialog.size());
  return isAccepted ? dialog.selectedFiles().value(0) : QString();
}

QFormLayout* formRows() {
  auto* form = new QFormLayout;
  form->setLabelAlignment(Qt::AlignRight);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  return form;
}

QPushButton* addButtons(QDialog* dialog, QVBoxLayout& rows, const QString& accept) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, dialog);
  QPushButton* button = buttons->addButton(accept, QDialogButtonBox::AcceptRole);
  button->setDefault(true);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  rows.addWidget(buttons);
  return button;
}

using editor::Role;

namespace {

constexpr int kHintWidth = 272;
constexpr int kLabelWidth = 96;
constexpr double kFinest = 0.001;  // [m] per pixel
constexpr double kCoarsest = 10.0;
constexpr double kReach = 10.0;   // [px], distance for dragging a point
constexpr double kMargin = 12.0;  // [px] around the image, for points on its edge

QDoubleSpinBox* metres(double value, double least, double most, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setRange(least, most);
  box->setDecimals(2);
  box->setAlignment(Qt::AlignRight);
  box->setSuffix(QObject::tr(" m"));
  box->setSingleStep(0.5);
  box->setValue(value);
  return box;
}

}  // namespace

RoomDialog::RoomDialog(const editor::Theme& theme, QWidget* parent)
    : QDialog(parent),
      width_(metres(12.0, 1.0, 500.0, this)),
      height_(metres(9.0, 1.0, 500.0, this)) {
  setWindowTitle(tr("New empty room"));
  setMinimumWidth(300);
  QLabel* title =
      editor::headingLabel(tr("New empty room"), theme.font(12.0, QFont::DemiBold), this);
  auto* rows =
      editor::configuredLayout(new QVBoxLayout(this), {16, 16, 16, 12}, 8, {title, walls_});
  QFormLayout* form = formRows();
  form->setContentsMargins(24, 0, 0, 4);
  form->addRow(tr("Width"), width_);
  form->addRow(tr("Height"), height_);
  rows->addLayout(form);
  rows->addWidget(plane_);
  rows->addSpacing(8);
  addButtons(this, *rows, tr("Create"));
  walls_->setChecked(true);
  connect(walls_, &QRadioButton::toggled, width_, &QWidget::setEnabled);
  connect(walls_, &QRadioButton::toggled, height_, &QWidget::setEnabled);
  width_->setAccessibleName(tr("Width"));
  height_->setAccessibleName(tr("Height"));
  width_->setFocus();
  width_->selectAll();
}

ScaleView::ScaleView(QImage image, const editor::Theme& theme, QWidget* parent)
    : QWidget(parent), image_(std::move(image)), theme_(theme) {
  setMinimumSize(320, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::CrossCursor);
  setAccessibleName(tr("Map image"));
}

void ScaleView::setPoints(std::vector<QPointF> points) {
  points_ = std::move(points);
  update();
  Q_EMIT pointsChanged();
}

QRectF ScaleView::imageRect() const {
  const QSizeF room = QSizeF(this->size()) - QSizeF(2.0 * kMargin, 2.0 * kMargin);
  const QSizeF size = QSizeF(image_.size()).scaled(room, Qt::KeepAspectRatio);
  return {QPointF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0), size};
}

QPointF ScaleView::toImage(const QPointF& widget) const {
  const QRectF rect = imageRect();
  return {(widget.x() - rect.left()) / rect.width() * image_.width(),
          (rect.bottom() - widget.y()) / rect.height() * image_.height()};
}

QPointF ScaleView::toWidget(const QPointF& image) const {
  const QRectF rect = imageRect();
  return {rect.left() + image.x() / image_.width() * rect.width(),
          rect.bottom() - image.y() / image_.height() * rect.height()};
}

void ScaleView::mousePressEvent(QMouseEvent* event) {
  draggedPoint_ = -1;
  if (event->button() != Qt::LeftButton) {
    return;
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF away = toWidget(points_[i]) - event->localPos();
    if (std::hypot(away.x(), away.y()) <= kReach) {
      draggedPoint_ = static_cast<int>(i);
      return;
    }
  }
  if (imageRect().contains(event->localPos())) {
    std::vector<QPointF> points = points_.size() == 2 ? std::vector<QPointF>() : points_;
    points.push_back(toImage(event->localPos()));
    draggedPoint_ = static_cast<int>(points.size()) - 1;
    setPoints(std::move(points));
  }
}

void ScaleView::mouseMoveEvent(QMouseEvent* event) {
  if (draggedPoint_ >= 0 && event->buttons().testFlag(Qt::LeftButton)) {
    const QRectF rect = imageRect();
    const QPointF inside(std::clamp(event->localPos().x(), rect.left(), rect.right()),
                         std::clamp(event->localPos().y(), rect.top(), rect.bottom()));
    std::vector<QPointF> points = points_;
    points[static_cast<std::size_t>(draggedPoint_)] = toImage(inside);
    setPoints(std::move(points));
  }
}

void ScaleView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.color(Role::CanvasOutside));
  painter.setRenderHint(QPainter::SmoothPixmapTransform, imageRect().width() < image_.width());
  painter.drawImage(imageRect(), image_);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = theme_.color(Role::Accent);
  if (points_.size() == 2) {
    painter.setPen(QPen(Qt::white, 4.0));
    painter.drawLine(toWidget(points_[0]), toWidget(points_[1]));
    painter.setPen(QPen(accent, 2.0));
    painter.drawLine(toWidget(points_[0]), toWidget(points_[1]));
  }
  int number = 1;
  for (const QPointF& point : points_) {
    const QPointF at = toWidget(point);
    painter.setPen(QPen(Qt::white, 2.0));
    painter.setBrush(accent);
    painter.drawEllipse(at, 8.0, 8.0);
    painter.setFont(theme_.font(8.0, QFont::Bold));
    painter.drawText(QRectF(at - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter,
                     QString::number(number++));
  }
}

ImageMapDialog::ImageMapDialog(std::shared_ptr<const sim2d::OccupancyGrid> grid, QImage image,
                               const editor::Theme& theme, QWidget* parent)
    : QDialog(parent),
      grid_(std::move(grid)),
      theme_(theme),
      view_(new ScaleView(std::move(image), theme, this)),
      distance_(metres(5.0, 0.01, 10000.0, this)),
      resolution_(metres(grid_->resolution(), kFinest, kCoarsest, this)),
      firstX_(metres(0.0, -100000.0, 100000.0, this)),
      firstY_(metres(0.0, -100000.0, 100000.0, this)) {
  setWindowTitle(tr("Map from an image"));
  resize(900, editor::limitedToScreen(*this, 560));
  resolution_->setDecimals(5);
  resolution_->setSingleStep(0.01);
  resolution_->setSuffix(tr(" m per pixel"));
  byPoints_->setChecked(true);
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {16, 16, 16, 12}, 12);
  auto* columns = editor::configuredLayout(new QHBoxLayout, {}, 16);
  columns->addWidget(view_, 1);
  columns->addLayout(makeSide());
  rows->addLayout(columns, 1);
  create_ = addButtons(this, *rows, tr("Create map"));
  connect(view_, &ScaleView::pointsChanged, this, &ImageMapDialog::measure);
  connect(byPoints_, &QRadioButton::toggled, this, &ImageMapDialog::measure);
  for (QDoubleSpinBox* field : {distance_, resolution_}) {
    connect(field, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &ImageMapDialog::measure);
  }
  measure();
}

QLayout* ImageMapDialog::makeSide() {
  QLabel* title = editor::headingLabel(tr("Map scale"), theme_.font(12.0, QFont::DemiBold), this);
  auto* side = editor::configuredLayout(new QVBoxLayout, {}, 8, {title, byPoints_});
  const auto addFields = [&](const std::vector<std::pair<QString, QDoubleSpinBox*>>& fields) {
    auto* form = new QGridLayout;
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    form->setColumnMinimumWidth(0, kLabelWidth);
    form->setColumnStretch(1, 1);
    for (const auto& [words, field] : fields) {
      auto* label = new QLabel(words, this);
      label->setBuddy(field);
      field->setAccessibleName(words);
      form->addWidget(label, form->rowCount(), 0, Qt::AlignRight | Qt::AlignVCenter);
      form->addWidget(field, form->rowCount() - 1, 1);
    }
    side->addLayout(form);
  };
  hint_->setWordWrap(true);
  hint_->setFixedWidth(kHintWidth);
  hint_->setMinimumHeight(2 * hint_->fontMetrics().lineSpacing());  // constant height for any text
  hint_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  side->addWidget(hint_);
  addFields({{tr("Distance 1 – 2"), distance_}});
  side->addSpacing(4);
  side->addWidget(byNumber_);
  addFields({{tr("Resolution"), resolution_}});
  side->addSpacing(8);
  side->addWidget(place_);
  addFields({{tr("X"), firstX_}, {tr("Y"), firstY_}});
  side->addSpacing(8);
  side->addWidget(size_);
  side->addStretch(1);
  return side;
}

double ImageMapDialog::pixels() const {
  const std::vector<QPointF>& points = view_->points();
  if (points.size() < 2) {
    return 0.0;
  }
  const QPointF way = points[1] - points[0];
  return std::hypot(way.x(), way.y());
}

double ImageMapDialog::resolution() const {
  const bool isByPoints = byPoints_->isChecked() && pixels() >= 1.0;
  return isByPoints ? distance_->value() / pixels() : resolution_->value();
}

bool ImageMapDialog::isInRange() const {
  return resolution() >= kFinest && resolution() <= kCoarsest;
}

bool ImageMapDialog::isMeasured() const {
  return byNumber_->isChecked() || (pixels() >= 1.0 && isInRange());
}

QString ImageMapDialog::hint() const {
  const std::size_t count = view_->points().size();
  if (count < 2) {
    return count == 0 ? tr("Click two points with a known distance, such as the ends of a wall.")
                      : tr("Click the second point.");
  }
  return isInRange() ? tr("Enter the distance between the two points. You can drag them.")
                     : tr("%1 m per pixel is out of range (%2 to %3).")
                           .arg(resolution(), 0, 'g', 3)
                           .arg(kFinest)
                           .arg(kCoarsest);
}

void ImageMapDialog::measure() {
  if (byPoints_->isChecked() && isMeasured()) {
    const QSignalBlocker quiet(resolution_);
    resolution_->setValue(resolution());
  }
  const std::size_t count = view_->points().size();
  const bool points = byPoints_->isChecked();
  distance_->setEnabled(points && count == 2);
  resolution_->setEnabled(!points);
  create_->setEnabled(isMeasured());
  hint_->setText(hint());
  hint_->setEnabled(points);
  place_->setText(count == 0 ? tr("Position of lower left corner") : tr("Position of point 1"));
  size_->setText(isMeasured() ? tr("The map will be %1 × %2 m.")
                                    .arg(grid_->width() * resolution(), 0, 'f', 1)
                                    .arg(grid_->height() * resolution(), 0, 'f', 1)
                              : QString());
}

std::shared_ptr<const sim2d::OccupancyGrid> ImageMapDialog::map() const {
  const double metresPerPixel = resolution();
  const QPointF first = view_->points().empty() ? QPointF(0.0, 0.0) : view_->points().front();
  const base::Vec2 origin(firstX_->value() - first.x() * metresPerPixel,
                          firstY_->value() - first.y() * metresPerPixel);
  return std::make_shared<sim2d::OccupancyGrid>(grid_->width(), grid_->height(), metresPerPixel,
                                                base::Pose2{origin, 0.0}, grid_->cells());
}

}  // namespace app
