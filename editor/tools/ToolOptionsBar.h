#pragma once

#include <map>

#include <QWidget>

#include "editor/canvas/MapView.h"
#include "editor/tools/ToolManager.h"

namespace editor {

/// Floats over the upper left corner of the canvas and holds the options of the current tool; away
/// when it has none.
class ToolOptionsBar : public QWidget {
  Q_OBJECT
 public:
  ToolOptionsBar(ToolManager& tools, MapView& view);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void showFor(Tool* tool);
  void place();

  MapView& view_;
  std::map<Tool*, QWidget*> rows_;  // made when first needed; null: the tool has none
  QWidget* row_ = nullptr;
};

}  // namespace editor
