#pragma once

#include "app/run/DataPaths.h"
#include "app/window/WindowActions.h"
#include "app/window/files/FileCommands.h"
#include "app/window/start/ScenarioGallery.h"
#include "app/window/start/StartCards.h"
#include "editor/look/Theme.h"

namespace app {

/// The page shown while nothing is open: commands to begin with, recent files, the shipped
/// scenarios.
class StartPage : public QScrollArea {
  Q_OBJECT
 public:
  /// `thumbnailFolder`: for pictures of scenarios; empty: they are not kept.
  StartPage(Workspace& workspace, WindowActions& actions, UserSettings& userSettings,
            const std::vector<ShippedScenario>& scenarios, const QString& thumbnailFolder,
            QWidget* parent = nullptr);
  void showTheme();  // call after a theme change
  void fillRecent();
  ScenarioGallery& gallery() const { return *gallery_; }
  /// Down leads from the search to the scenarios, Ctrl+F to the search; typed text, wherever the
  /// focus is, is searched for. False: none of these.
  bool handleKey(const QKeyEvent& event);
  /// Whether the key enters text, such as a letter without Ctrl or Alt; not Space.
  static bool isTypedText(const QKeyEvent& event);

 Q_SIGNALS:
  void fileRequested(const QString& path);

 protected:
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void startSearch(const QString& text);
  void addActions(const WindowActions& actions);
  void addLists();

  Workspace& workspace_;
  UserSettings& userSettings_;
  QWidget* page_ = new QWidget;
  QVBoxLayout* column_ = new QVBoxLayout;
  QVBoxLayout* recent_ = new QVBoxLayout;
  ScenarioGallery* gallery_;
};

}  // namespace app
