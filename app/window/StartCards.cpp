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
  painter.setPen(theme_.color(Role::Text));
  painter.setFont(theme_.font(12.0, QFont::DemiBold));
  painter.drawText(QRect(78, 22, width() - 90, 24), Qt::AlignVCenter | Qt::AlignLeft, words_.title);
  painter.setPen(theme_.color(Role::TextSecondary));
  painter.setFont(theme_.font(9.5));
  painter.drawText(QRect(78, 46, width() - 90, 20), Qt::AlignVCenter | Qt::AlignLeft, words_.line);
  painter.setFont(theme_.font(9.0));
  painter.drawText(QRect(0, 10, width() - 14, 18), Qt::AlignVCenter | Qt::AlignRight,
                   words_.shortcut);
}

RecentRow::RecentRow(QString path, const editor::Theme& theme, QWidget* parent)
    : StartCard(theme, parent), path_(std::move(path)), exists_(QFileInfo::exists(path_)) {
  when_ =
      exists_ ? agoText(QFileInfo(path_).lastModified(), QDateTime::currentDateTime()) : QString();
  setToolTip(path_);
  setAccessibleName(QFileInfo(path_).fileName());
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
  painter.setFont(theme_.font(9.5, QFont::DemiBold));
  painter.setPen(theme_.color(exists_ ? Role::Text : Role::TextSecondary));
  painter.drawText(
      QRect(40, 10, width() - 130, 20), Qt::AlignVCenter | Qt::AlignLeft,
      painter.fontMetrics().elidedText(file.fileName(), Qt::ElideMiddle, width() - 130));
  painter.setFont(theme_.font(9.0));
  painter.setPen(theme_.color(exists_ ? Role::TextSecondary : Role::Warning));
  const QString line = exists_ ? homeRelative(file.absolutePath())
                               : tr("File not found · %1").arg(homeRelative(file.absolutePath()));
  painter.drawText(QRect(40, 30, width() - 52, 18), Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(line, Qt::ElideLeft, width() - 52));
  painter.setPen(theme_.color(Role::TextSecondary));
  painter.drawText(QRect(width() - 90, 10, 86, 20), Qt::AlignVCenter | Qt::AlignRight, when_);
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
