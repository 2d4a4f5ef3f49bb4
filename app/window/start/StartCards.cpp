#include "app/window/start/StartCards.h"

#include "app/window/settings/Language.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"

namespace app {

using editor::Role;

namespace {

constexpr double kRadius = 8.0;
constexpr int kWordsLeft = 72;
constexpr int kNameLeft = 40;
constexpr int kKeysGap = 16;  // between title and shortcut
constexpr int kCaption = 48;  // [px], the two lines below a picture

QString homeRelative(const QString& folder) {
  const QString home = QDir::homePath();
  return folder.startsWith(home + QLatin1Char('/')) ? QStringLiteral("~") + folder.mid(home.size())
                                                    : folder;
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
  const QLocale words = shownLanguage();
  if (days < 7) {
    return words.toString(then.date(), QStringLiteral("dddd"));
  }
  return words.toString(then.date(), then.date().year() == now.date().year()
                                         ? QObject::tr("d MMM", "format of a date")
                                         : QObject::tr("d MMM yyyy", "format of a date"));
}

void StartCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
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
      .paint(&painter, QRect(22, 22, 32, 32));
  const QRect room = rect().adjusted(kWordsLeft, 8, -14, -8);
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
    painter.drawText(QRect(0, 8, width() - 14, 18), Qt::AlignVCenter | Qt::AlignRight,
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
  const QString folder = file.absolutePath();
  const QString state = exists_                     ? QString()
                        : QFileInfo::exists(folder) ? tr("File not found in ")
                                                    : tr("Folder not found: ");
  const int folderRoom = width() - 52 - painter.fontMetrics().horizontalAdvance(state);
  painter.drawText(
      QRect(kNameLeft, 30, width() - 52, 18), Qt::AlignVCenter | Qt::AlignLeft,
      state + painter.fontMetrics().elidedText(homeRelative(folder), Qt::ElideLeft, folderRoom));
  painter.fillRect(QRect(0, height() - 1, width(), 1), theme_.color(Role::Line));
}

ScenarioCard::ScenarioCard(QString path, const ScenarioInfo& info, const editor::Theme& theme,
                           QWidget* parent)
    : StartCard(theme, parent), path_(std::move(path)) {
  setInfo(info);
}

QSize ScenarioCard::pictureSize() const {
  return {width(), height() - kCaption};
}

void ScenarioCard::setInfo(const ScenarioInfo& info) {
  info_ = info;
  const QStringList spoken = {info.contents(), info.difficulty, info.purpose};
  setAccessibleName(info.title);
  setAccessibleDescription(
      spoken.filter(QRegularExpression(QStringLiteral("."))).join(QStringLiteral(", ")));
  const QStringList tip = {info.title, info.purpose, info.details, path_};
  setToolTip(tip.filter(QRegularExpression(QStringLiteral("."))).join(QLatin1Char('\n')));
  update();
}

void ScenarioCard::paintEvent(QPaintEvent* /*event*/) {
  if (!std::exchange(isRequested_, true)) {
    Q_EMIT pictureNeeded();
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  paintPicture(painter);
  paintCaption(painter);
}

void ScenarioCard::paintPicture(QPainter& painter) const {
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
      QPen(theme_.color(isHighlighted() ? Role::Accent : Role::Line), isHighlighted() ? 2.0 : 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(frame, kRadius, kRadius);
}

/// Title and contents, below them the purpose and the difficulty.
void ScenarioCard::paintCaption(QPainter& painter) const {
  const QRect first(0, pictureSize().height() + 5, width(), 20);
  const QRect second = first.translated(0, 20);
  const auto drawLine = [&](const QRect& line, const QString& left, const QString& right,
                            const QFont& font, Role color) {
    painter.setFont(theme_.font(9.0));
    painter.setPen(theme_.color(Role::TextSecondary));
    painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, right);
    const int used =
        painter.fontMetrics().horizontalAdvance(right) + (right.isEmpty() ? 0 : kKeysGap);
    painter.setFont(font);
    painter.setPen(theme_.color(color));
    painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(left, Qt::ElideRight, line.width() - used));
  };
  drawLine(first, info_.title, info_.contents(), theme_.font(10.0, QFont::DemiBold), Role::Text);
  drawLine(second, info_.purpose.isEmpty() ? info_.family : info_.purpose, info_.difficulty,
           theme_.font(9.0), Role::TextSecondary);
}

}  // namespace app
