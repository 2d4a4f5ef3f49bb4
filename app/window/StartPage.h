#pragma once

#include <deque>

#include <QAbstractButton>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/window/FileCommands.h"
#include "app/window/WindowActions.h"

namespace app {

/// A scenario of the collection as a picture with its name.
struct Demo {
  QString name, path;
};

/// What stands in the place of the canvas while nothing is open: three actions, recent files, demo
/// scenarios.
class StartPage : public QScrollArea {
  Q_OBJECT
 public:
  StartPage(Workspace& workspace, WindowActions& actions, Memory& memory,
            const std::vector<Demo>& demos, QWidget* parent = nullptr);
  void setTheme(const editor::Theme& theme);
  void fillRecent();

 Q_SIGNALS:
  void fileWanted(const QString& path);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addActions(WindowActions& actions);
  void addDemos(const std::vector<Demo>& demos);
  void paintThumbnails();
  void paintNextThumbnail();

  Workspace& workspace_;
  Memory& memory_;
  QWidget* page_;
  QVBoxLayout* column_;
  QVBoxLayout* recent_;
  QLabel* title_;
  std::vector<QAbstractButton*> cards_;
  std::vector<std::pair<QAbstractButton*, QString>> thumbnails_;
  std::deque<std::size_t> unpainted_;
};

}  // namespace app
