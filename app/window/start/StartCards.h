#pragma once

#include "app/window/start/ScenarioInfo.h"
#include "editor/look/Theme.h"

namespace app {

/// A large button of the start page in the colours of the theme.
class StartCard : public QAbstractButton {
  Q_OBJECT
 public:
  StartCard(const editor::Theme& theme, QWidget* parent) : QAbstractButton(parent), theme_(theme) {
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }

 protected:
  void keyPressEvent(QKeyEvent* event) override;  // Enter clicks
  bool isHighlighted() const { return underMouse() || hasFocus(); }
  const editor::Theme& theme_;  // owned and changed by the workspace
};

/// A card with icon, title, description and shortcut.
class ActionCard : public StartCard {
  Q_OBJECT
 public:
  struct Labels {
    QString icon, title, line, shortcut;
  };
  ActionCard(Labels words, const editor::Theme& theme, QWidget* parent);
  QSize sizeHint() const override { return {357, 76}; }
  QSize minimumSizeHint() const override { return {240, 76}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Labels labels_;
};

/// A recent file: name, folder, time of last use; greyed with a warning if it is missing.
class RecentRow : public StartCard {
  Q_OBJECT
 public:
  RecentRow(QString path, const QDateTime& used, const editor::Theme& theme, QWidget* parent);
  QSize sizeHint() const override { return {357, 60}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString path_, when_;
  bool exists_;
};

/// A scenario of the gallery: picture, title, contents and purpose.
class ScenarioCard : public StartCard {
  Q_OBJECT
 public:
  ScenarioCard(QString path, const ScenarioInfo& info, const editor::Theme& theme, QWidget* parent);
  void setInfo(const ScenarioInfo& info);
  void setPicture(const QPixmap& picture) {
    picture_ = picture;
    update();
  }
  /// The next time that the card is painted, it requests its picture again.
  void forgetPicture() {
    isRequested_ = false;
    update();
  }
  QString path() const { return path_; }
  const ScenarioInfo& info() const { return info_; }
  bool hasPicture() const { return !picture_.isNull(); }
  QSize sizeHint() const override { return {357, 220}; }
  QSize minimumSizeHint() const override { return {240, 220}; }
  QSize pictureSize() const;

 Q_SIGNALS:
  void pictureNeeded();  // the card is visible for the first time

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintPicture(QPainter& painter) const;
  void paintCaption(QPainter& painter) const;

  QString path_;
  ScenarioInfo info_;
  QPixmap picture_;
  bool isRequested_ = false;
};

/// The time of last use as text: "2 min ago", "Yesterday", "12 Nov".
QString relativeTimeText(const QDateTime& then, const QDateTime& now);

}  // namespace app
