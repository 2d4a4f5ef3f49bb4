#pragma once

#include "app/run/DataPaths.h"
#include "app/window/WindowActions.h"
#include "app/window/files/FileCommands.h"
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
  QSize sizeHint() const override { return {357, 88}; }
  QSize minimumSizeHint() const override { return {240, 88}; }

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

/// A demo scenario: thumbnail, name and number of people.
class DemoCard : public StartCard {
  Q_OBJECT
 public:
  DemoCard(QString name, const editor::Theme& theme, QWidget* parent);
  void setPicture(const QPixmap& picture, int people);
  QSize sizeHint() const override { return {357, 208}; }
  QSize minimumSizeHint() const override { return {240, 208}; }
  QSize pictureSize() const { return {width(), 172}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString name_;
  QPixmap picture_;
  int people_ = -1;
};

/// The time of last use as text: "2 min ago", "Yesterday", "12 Nov".
QString relativeTimeText(const QDateTime& then, const QDateTime& now);

/// The page shown while nothing is open: three actions, recent files, demo scenarios.
class StartPage : public QScrollArea {
  Q_OBJECT
 public:
  StartPage(Workspace& workspace, WindowActions& actions, UserSettings& userSettings,
            const std::vector<ShippedScenario>& demos, QWidget* parent = nullptr);
  void showTheme();  // call after a theme change
  void fillRecent();

 Q_SIGNALS:
  void fileRequested(const QString& path);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addActions(WindowActions& actions);
  void addDemos(const std::vector<ShippedScenario>& demos);
  void paintThumbnails();
  void paintNextThumbnail();

  Workspace& workspace_;
  UserSettings& userSettings_;
  QWidget* page_ = new QWidget;
  QVBoxLayout* column_ = new QVBoxLayout;
  QVBoxLayout* recent_ = new QVBoxLayout;
  std::vector<std::pair<DemoCard*, QString>> thumbnails_;
  std::size_t painted_ = 0;  // number of painted thumbnails
};

}  // namespace app
