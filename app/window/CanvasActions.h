#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QMenu>
#include <QToolButton>

#include "app/window/Workspace.h"

namespace app {

/// Commands about the canvas: what is shown in layers, what drawing snaps to, how the selection is
/// arranged.
class CanvasActions : public QObject {
  Q_OBJECT
 public:
  explicit CanvasActions(Workspace& workspace, QObject* parent = nullptr);

  const std::vector<QAction*>& layers() const { return layers_; }
  const std::vector<QAction*>& snapping() const { return snapping_; }
  QAction* snapToPoints() const { return snapping_.front(); }
  void fillArrangeMenu(QMenu& menu) const;
  void setTheme(const editor::Theme& theme);

 private:
  QAction* toggle(const QString& text, const QKeySequence& shortcut, const QString& says,
                  bool editor::CanvasOptions::*option);
  QAction* arrange(const QString& text, const QString& says, const std::function<void()>& work);
  void makeArranging();
  void followSelection();

  Workspace& workspace_;
  std::vector<QAction*> layers_, snapping_;
  std::vector<std::pair<QAction*, std::size_t>> arranging_;  // and how many things it needs
};

/// A button of the tool bar for several tools: shows the one used last, its arrow opens the list.
QToolButton* makeToolGroup(const std::vector<QAction*>& actions, QWidget* parent);

}  // namespace app
