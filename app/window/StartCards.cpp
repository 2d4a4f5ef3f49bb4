#include "app/window/StartCards.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include "editor/look/Icons.h"

namespace app {

using editor::Role;

namespace {

constexpr double kRadius = 8.0;
constexpr int kWordsLeft = 78;
constexpr int kNameLeft = 40;
constexpr int kKeysGap = 16;  // between the title and the shortcut

QString homeRelative(const QString& folder) {
  const QString home = QDir::homePath();
  return folder.startsWith(home + QLatin1Char('/')) ? QStringLiteral("~") + folder.mid(home.size())
                                                    : folder;
}

}  // namespace

QString agoText(const QDateTime& then, const QDateTime& now) {
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

ActionCard::ActionCard(Words words, const editor::Theme& theme, QWidget* parent)
    : StartCard(theme, parent), words_(std::move(words)) {
  setAccessibleName(words_.title);
  setToolTip(words_.shortcut);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ActionCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme_.color(isLit() ? Role::Accent : Role::FieldEdge), 1.0));
  painter.setBrush(theme_.color(isLit() ? Role::RowSelected : Role::Panel));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
  editor::tintedIcon(words_.icon, theme_.color(Role::Accent))
      .paint(&painter, QRect(24, 28, 32, 32));
  const QRect room = rect().adjusted(kWordsLeft, 10, -14, -10);
  painter.setPen(theme_.color(Role::Text));
  painter.setFont(theme_.font(12.0, QFont::DemiBold));
  const QFontMetrics titleMetrics = painter.fontMetrics();
  painter.setFont(theme_.font(9.5));
  const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  const int lines = painter.fontMetrics().boundingRect(room, flags, words_.line).height();
  const int titleHeight = titleMetrics.height() + 4;
  QRect words(room.left(), room.center().y() - (titleHeight + lines) / 2, room.width(),
              titleHeight + lines);
  painter.setPen(theme_.color(Role::TextSecondary));
  painter.drawText(words.adjusted(0, titleHeight, 0, 0), flags, words_.line);
  painter.setFont(theme_.font(9.0));
  const int keys = painter.fontMetrics().horizontalAdvance(words_.shortcut) + kKeysGap;
  if (titleMetrics.horizontalAdvance(words_.title) + keys <= words.width()) {  // else the tip says
    painter.drawText(QRect(0, 10, width() - 14, 18), Qt::AlignVCenter | Qt::AlignRight,
                     words_.shortcut);
  }
  painter.setPen(theme_.color(Role::Text));
  painter.setFont(theme_.font(12.0, QFont::DemiBold));
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop,
                   titleMetrics.elidedText(words_.title, Qt::ElideRight, words.width()));
}

RecentRow::RecentRow(QString path, const QDateTime& used, const editor::Theme& theme,
                     QWidget* parent)
    : StartCard(theme, parent), path_(std::move(path)), exists_(QFileInfo::exists(path_)) {
  when_ = exists_ && used.isValid() ? agoText(used, QDateTime::currentDateTime()) : QString();
  setToolTip(path_);
  setAccessibleName(QFileInfo(path_).fileName());
  setAccessibleDescription(exists_ ? when_ : tr("File not found"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setEnabled(exists_);
}

void RecentRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (isLit() && exists_) {
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
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
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
  painter.setPen(QPen(theme_.color(isLit() ? Role::Accent : Role::Line), isLit() ? 1.5 : 1.0));
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

}  // namespace app
