#pragma once

#include "editor/canvas/MapScene.h"

namespace editor {

/// A layer of the map: the action that shows or hides it and the option that the action sets.
struct MapLayer {
  QAction* action = nullptr;
  bool CanvasOptions::*option = nullptr;
};

/// What the map shows, in groups: an eye that shows or hides each layer, and its opacity. The eye
/// of a group hides all its layers, and restores those that were visible.
class LayersPanel : public QWidget {
  Q_OBJECT
 public:
  LayersPanel(MapScene& scene, const Theme& theme);
  /// Adds a group below the others. The actions must outlive the panel.
  void addGroup(const QString& title, const std::vector<MapLayer>& layers);
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  void opacityChanged();  // By the user.

 private:
  struct Row {
    MapLayer layer;
    QToolButton* eye;
    QSlider* slider;
    QLabel* percent;
  };
  struct Group {
    QString title;
    QToolButton* eye;
    std::vector<Row> rows;
    std::vector<QAction*> hidden;  // Layers that the eye of the group has hidden.
  };
  void addRow(Group& group, const MapLayer& layer, int line);
  void switchGroup(Group& group);
  void setOpacity(const Row& row, int percent);
  void refresh();
  void showEye(QToolButton& eye, const QString& name, bool isVisible);

  MapScene& scene_;
  Theme theme_;
  QVBoxLayout* column_;
  QGridLayout* grid_;
  std::vector<std::unique_ptr<Group>> groups_;
};

}  // namespace editor
