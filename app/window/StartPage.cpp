#include "app/window/StartPage.h"

#include "editor/canvas/RouteModel.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"

namespace app {

using editor::Role;

namespace {

constexpr int kColumnWidth = 1120;
constexpr int kGap = 24;
constexpr double kThumbnailScale = 1.75;  // lines are thinner than on the canvas
constexpr double kRadius = 8.0;
constexpr int kWordsLeft = 78;
constexpr int kNameLeft = 40;
constexpr int kKeysGap = 16;  // between title and shortcut

/// Renders the scenario as on the canvas, fitted to `size`.
QPixmap thumbnailOf(const QString& path, const editor::Theme& theme, const QSize& size,
                    double ratio, int& people) {
  editor::ScenarioDocument document;
  if (base::hasErrors(document.open(path))) {
    return {};
  }
  people = static_cast<int>(document.scenario().humans.size());
  editor::MapScene scene(document, theme);
  editor::CanvasOptions options;
  options.names = false;
  options.grid = false;
  options.goals = false;  // pins are as large as people; routes show the goals
  scene.setOptions(options);
  scene.routes().finish();
  const QRectF content = scene.contentRect();
  const QSizeF large = QSizeF(size) * kThumbnailScale;  // line widths are constant
  const double margin = 10.0 * kThumbnailScale;
  const double scale = std::min((large.width() - 2.0 * margin) / content.width(),
                                (large.height() - 2.0 * margin) / content.height());
  scene.setPixelsPerMetre(scale);
  QImage picture((large * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(ratio);
  picture.fill(theme.color(Role::CanvasOutside));
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QSizeF drawn = content.size() * scale;
  const QPointF corner((large.width() - drawn.width()) / 2.0,
                       (large.height() - drawn.height()) / 2.0);
  scene.render(&painter, QRectF(corner, drawn), content);
  painter.end();
  QImage small = picture.scaled(size * ratio, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  small.setDevicePixelRatio(ratio);
  return QPixmap::fromImage(small);
}

QString homeRelative(const QString& folder) {
  const QString home = QDir::homePath();
  return folder.startsWith(home + QLatin1Char('/')) ? QStringLiteral("~") + folder.mid(home.size())
                                                    : folder;
}

/// The title of a shipped scenario, from its file name.
QString titleOf(const std::string& name) {
  QString title = QString::fromStdString(name).remove(QStringLiteral("_agents"));
  return editor::capitalized(title.replace(QLatin1Char('_'), QLatin1Char(' ')));
}

}  // namespace

QString relativeTimeText(const QDateTime& then, const QDateTime& now) {
  const qint64 minutes = then.secsTo(now) / 60;
  if (minutes < 1) {
    return QObject::tr("just now");
  }
  if (minutes < 60) {
    return QObject::tr("%1 min ago").arg(minutes);
  }
  const qint64 days = then.date().daysTo(now.date());
  if (days == 0) {
    return QObject::tr("%1 h ago").arg(minutes / 60);
  }
  if (days == 1) {
    return QObject::tr("Yesterday");
  }
  const QLocale english(QLocale::English);
  if (days < 7) {
    return english.toString(then.date(), QStringLiteral("dddd"));
  }
  return english.toString(then.date(), then.date().year() == now.date().year()
                                           ? QStringLiteral("d MMM")
                                           : QStringLiteral("d MMM yyyy"));
}

ActionCard::ActionCard(Labels words, const editor::Theme& theme, QWidget* parent)
    : StartCard(theme, parent), labels_(std::move(words)) {
  setAccessibleName(labels_.title);
  setToolTip(labels_.shortcut);
}

void ActionCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme_.color(isHighlighted() ? Role::Accent : Role::FieldEdge), 1.0));
  painter.setBrush(theme_.color(isHighlighted() ? Role::RowSelected : Role::Panel));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
  editor::tintedIcon(labels_.icon, theme_.color(Role::Accent))
      .paint(&painter, QRect(24, 28, 32, 32));
  const QRect room = rect().adjusted(kWordsLeft, 10, -14, -10);
  painter.setPen(theme_.color(Role::Text));
  painter.setFont(theme_.font(12.0, QFont::DemiBold));
  const QFontMetrics titleMetrics = painter.fontMetrics();
  painter.setFont(theme_.font(9.5));
  const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  const int lines = painter.fontMetrics().boundingRect(room, flags, labels_.line).height();
  const int titleHeight = titleMetrics.height() + 4;
  QRect words(room.left(), room.center().y() - (titleHeight + lines) / 2, room.width(),
              titleHeight + lines);
  painter.setPen(theme_.color(Role::TextSecondary));
  painter.drawText(words.adjusted(0, titleHeight, 0, 0), flags, labels_.line);
  painter.setFont(theme_.font(9.0));
  const int keys = painter.fontMetrics().horizontalAdvance(labels_.shortcut) + kKeysGap;
  if (titleMetrics.horizontalAdvance(labels_.title) + keys <= words.width()) {  // else in tooltip
    painter.drawText(QRect(0, 10, width() - 14, 18), Qt::AlignVCenter | Qt::AlignRight,
                     labels_.shortcut);
  }
  painter.setPen(theme_.color(Role::Text));
  painter.setFont(theme_.font(12.0, QFont::DemiBold));
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop,
                   titleMetrics.elidedText(labels_.title, Qt::ElideRight, words.width()));
}

RecentRow::RecentRow(QString path, const QDateTime& used, const editor::Theme& theme,
                     QWidget* parent)
    : StartCard(theme, parent), path_(std::move(path)), exists_(QFileInfo::exists(path_)) {
  when_ =
      exists_ && used.isValid() ? relativeTimeText(used, QDateTime::currentDateTime()) : QString();
  setToolTip(path_);
  setAccessibleName(QFileInfo(path_).fileName());
  setAccessibleDescription(exists_ ? when_ : tr("File not found"));
  setEnabled(exists_);
}

void RecentRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (isHighlighted() && exists_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.color(Role::RowHover));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0, 0, 0, -1), 4.0, 4.0);
  }
  const QIcon icon =
      exists_ ? editor::tintedIcon(QStringLiteral("file"), theme_.color(Role::TextSecondary))
              : editor::tintedIcon(QStringLiteral("warning"), theme_.color(Role::WarningMark));
  icon.paint(&painter, QRect(4, 18, 24, 24));
  const QFileInfo file(path_);
  painter.setFont(theme_.font(9.0));
  const int whenWidth = painter.fontMetrics().horizontalAdvance(when_);
  painter.setPen(theme_.color(Role::TextSecondary));
  painter.drawText(QRect(width() - whenWidth - 4, 10, whenWidth, 20),
                   Qt::AlignVCenter | Qt::AlignRight, when_);
  const int room = width() - kNameLeft - whenWidth - 12;
  painter.setFont(theme_.font(9.5, QFont::DemiBold));
  painter.setPen(theme_.color(exists_ ? Role::Text : Role::TextSecondary));
  painter.drawText(QRect(kNameLeft, 10, room, 20), Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(file.fileName(), Qt::ElideMiddle, room));
  painter.setFont(theme_.font(9.0));
  painter.setPen(theme_.color(exists_ ? Role::TextSecondary : Role::Warning));
  const QString line = exists_ ? homeRelative(file.absolutePath())
                               : tr("File not found · %1").arg(homeRelative(file.absolutePath()));
  painter.drawText(QRect(kNameLeft, 30, width() - 52, 18), Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(line, Qt::ElideLeft, width() - 52));
  painter.fillRect(QRect(0, height() - 1, width(), 1), theme_.color(Role::Line));
}

DemoCard::DemoCard(QString name, const editor::Theme& theme, QWidget* parent)
    : StartCard(theme, parent), name_(std::move(name)) {
  setAccessibleName(name_);
}

void DemoCard::setPicture(const QPixmap& picture, int people) {
  picture_ = picture;
  people_ = people;
  update();
}

void DemoCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF frame = QRectF(QPointF(), QSizeF(pictureSize())).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.color(Role::CanvasOutside));
  painter.drawRoundedRect(frame, kRadius, kRadius);
  if (!picture_.isNull()) {
    QPainterPath clip;
    clip.addRoundedRect(frame, kRadius, kRadius);
    painter.setClipPath(clip);
    painter.drawPixmap(QRect(QPoint(), pictureSize()), picture_);
    painter.setClipping(false);
  }
  painter.setPen(
      QPen(theme_.color(isHighlighted() ? Role::Accent : Role::Line), isHighlighted() ? 1.5 : 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(frame, kRadius, kRadius);
  const QRect words(0, pictureSize().height() + 6, width(), 22);
  painter.setFont(theme_.font(10.0, QFont::DemiBold));
  painter.setPen(theme_.color(Role::Text));
  painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, name_);
  if (people_ >= 0) {
    painter.setFont(theme_.font(9.0));
    painter.setPen(theme_.color(Role::TextSecondary));
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignRight,
                     people_ == 1 ? tr("1 person") : tr("%1 people").arg(people_));
  }
}

StartPage::StartPage(Workspace& workspace, WindowActions& actions, UserSettings& userSettings,
                     const std::vector<ShippedScenario>& demos, QWidget* parent)
    : QScrollArea(parent), workspace_(workspace), userSettings_(userSettings) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidget(page_);
  page_->setAutoFillBackground(true);
  page_->setBackgroundRole(QPalette::Light);
  auto* sides = new QHBoxLayout(page_);
  sides->setContentsMargins(32, 0, 32, 0);
  auto* middle = new QWidget;
  middle->setMaximumWidth(kColumnWidth);
  middle->setLayout(column_);
  sides->addStretch(1);
  sides->addWidget(middle, 1000);
  sides->addStretch(1);
  const editor::Theme& theme = workspace.theme();
  editor::configuredLayout(column_, {0, 48, 0, 24}, 0,
                           {editor::headingLabel(tr("Start"), theme.font(21.0, QFont::DemiBold))});
  column_->addSpacing(8);
  auto* line = editor::secondaryLabel(
      tr("Place people and a robot on a map, then press Space to simulate them."));
  line->setFont(theme.font(10.5));
  column_->addWidget(line);
  column_->addSpacing(24);
  addActions(actions);
  column_->addSpacing(32);
  addDemos(demos);
  column_->addStretch();
  column_->addWidget(editor::dividerLine());
  column_->addSpacing(12);
  column_->addWidget(
      editor::secondaryLabel(tr("Drop a scenario or a map anywhere on this window to open it.")));
  fillRecent();
}

void StartPage::addActions(WindowActions& actions) {
  auto* row = editor::configuredLayout(new QHBoxLayout, {}, kGap);
  const auto add = [&](QAction* action, const QString& icon, const QString& title,
                       const QString& description) {
    auto* card = new ActionCard(
        {icon, title, description, action->shortcut().toString(QKeySequence::NativeText)},
        workspace_.theme(), page_);
    connect(card, &QAbstractButton::clicked, action, &QAction::trigger);
    row->addWidget(card, 1);
  };
  add(actions.newFromMap, QStringLiteral("start-map"), tr("New from a map"),
      tr("Nav2 map or floor plan image"));
  add(actions.newEmptyRoom, QStringLiteral("start-room"), tr("New empty room"),
      tr("Four walls, or an open plane"));
  add(actions.open, QStringLiteral("file-open"), tr("Open…"), tr("Scenario or map"));
  column_->addLayout(row);
}

void StartPage::addDemos(const std::vector<ShippedScenario>& demos) {
  const QFont bold = workspace_.theme().font(12.0, QFont::DemiBold);
  // Three columns aligned with the cards above.
  auto* both = editor::configuredLayout(new QHBoxLayout, {}, 0);
  auto* left = editor::configuredLayout(new QVBoxLayout, {0, 0, 2 * kGap / 3, 0}, 0,
                                        {editor::headingLabel(tr("Recent"), bold)});
  left->addSpacing(8);
  left->addLayout(recent_);
  left->addStretch();
  both->addLayout(left, 1);
  auto* right = editor::configuredLayout(new QVBoxLayout, {kGap / 3, 0, 0, 0}, 0);
  if (!demos.empty()) {
    right->addWidget(editor::headingLabel(tr("Demos"), bold));
    right->addSpacing(12);
  }
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kGap);
  grid->setVerticalSpacing(16);
  for (int i = 0; i < static_cast<int>(demos.size()); ++i) {
    const ShippedScenario& demo = demos[static_cast<std::size_t>(i)];
    const QString path = QString::fromStdString(demo.path);
    auto* card = new DemoCard(titleOf(demo.name), workspace_.theme(), page_);
    card->setToolTip(path);
    connect(card, &QAbstractButton::clicked, this, [this, path] { Q_EMIT fileRequested(path); });
    grid->addWidget(card, i / 2, i % 2);
    thumbnails_.emplace_back(card, path);
  }
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  right->addLayout(grid);
  right->addStretch();
  both->addLayout(right, 2);
  column_->addLayout(both);
}

void StartPage::fillRecent() {
  editor::clearLater(*recent_);
  for (const QString& path : userSettings_.recentFiles()) {
    auto* row = new RecentRow(path, userSettings_.lastUsed(path), workspace_.theme(), page_);
    connect(row, &QAbstractButton::clicked, this, [this, path] { Q_EMIT fileRequested(path); });
    recent_->addWidget(row);
  }
  if (recent_->count() == 0) {
    recent_->addWidget(editor::secondaryLabel(tr("No recent files. Try a demo.")));
  }
}

void StartPage::showTheme() {
  page_->update();
  fillRecent();
  if (isVisible()) {
    paintThumbnails();
  }
}

void StartPage::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  fillRecent();  // files may have changed
  paintThumbnails();
}

void StartPage::paintThumbnails() {
  painted_ = 0;
  editor::later(*this, [this] { paintNextThumbnail(); });
}

/// One thumbnail at a time, so that the page appears immediately.
void StartPage::paintNextThumbnail() {
  if (painted_ == thumbnails_.size()) {
    return;
  }
  const auto& [demo, path] = thumbnails_[painted_++];
  int people = -1;
  const QPixmap picture =
      thumbnailOf(path, workspace_.theme(), demo->pictureSize(), devicePixelRatioF(), people);
  demo->setPicture(picture, people);
  editor::later(*this, [this] { paintNextThumbnail(); });
}

}  // namespace app
