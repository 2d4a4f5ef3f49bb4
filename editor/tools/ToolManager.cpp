#include "editor/tools/ToolManager.h"

#include <QAction>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QKeyEvent>

#include "editor/canvas/MapScene.h"
#include "editor/look/ActionText.h"
#include "editor/tools/AreaTool.h"
#include "editor/tools/BoxTool.h"
#include "editor/tools/BrushTool.h"
#include "editor/tools/CircleTool.h"
#include "editor/tools/DoorTool.h"
#include "editor/tools/EraserTool.h"
#include "editor/tools/FillTool.h"
#include "editor/tools/GoalTool.h"
#include "editor/tools/MapPaintTool.h"
#include "editor/tools/MeasureTool.h"
#include "editor/tools/PanTool.h"
#include "editor/tools/PersonTool.h"
#include "editor/tools/PolygonTool.h"
#include "editor/tools/RobotTool.h"
#include "editor/tools/RouteTool.h"
#include "editor/tools/SelectTool.h"
#include "editor/tools/WallTool.h"

namespace editor {

namespace {

/// Escape in a tool that is doing nothing goes back to the first one.
class EscapeKey : public QObject {
 public:
  EscapeKey(ToolManager& tools, MapScene& scene) : QObject(&tools), tools_(tools) {
    scene.installEventFilter(this);
  }
  bool eventFilter(QObject*, QEvent* event) override {
    Tool* const tool = tools_.current();
    if (event->type() != QEvent::KeyPress || tool == tools_.tools().front() ||
        static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) {
      return false;
    }
    const QString before = tool->statusText();  // speaks of what is being drawn
    tool->cancel();
    if (before == tool->statusText() && QGuiApplication::mouseButtons() == Qt::NoButton) {
      tools_.setCurrent(tools_.tools().front());
    }
    event->accept();
    return true;
  }

 private:
  ToolManager& tools_;
};

}  // namespace

ToolManager::ToolManager(ScenarioDocument& document, MapScene& scene, QObject* parent)
    : QObject(parent), scene_(scene), group_(this) {
  add(new SelectTool(document, scene, this));
  add(new PersonTool(document, scene, this));
  add(new BrushTool(document, scene, this));
  add(new FillTool(document, scene, this));
  add(new GoalTool(document, scene, this));
  add(new RouteTool(document, scene, this));
  add(new WallTool(document, scene, this));
  add(new BoxTool(document, scene, this));
  add(new PolygonTool(document, scene, this));
  add(new CircleTool(document, scene, this));
  add(new DoorTool(document, scene, this));
  add(new AreaTool(document, scene, this));
  add(new RobotTool(document, scene, this));
  add(new MapPaintTool(document, scene, this));
  add(new MeasureTool(document, scene, this));
  add(new EraserTool(document, scene, this));
  add(new PanTool(document, scene, this));
  connect(&document, &ScenarioDocument::selectionChanged, this, [this] {
    if (current_ != nullptr) {
      Q_EMIT statusTextChanged(current_->statusText());
    }
  });
  setCurrent(tools_.front());
  new EscapeKey(*this, scene);
}

ToolManager::~ToolManager() {
  scene_.setTool(nullptr);
}

void ToolManager::add(Tool* tool) {
  tool->setParent(this);
  tools_.push_back(tool);
  auto* action = new QAction(tool->name(), &group_);
  action->setCheckable(true);
  action->setShortcut(tool->shortcut());
  describe(*action, tool->statusText());
  action->setData(tool->iconName());
  connect(action, &QAction::triggered, this, [this, tool] { setCurrent(tool); });
  connect(tool, &Tool::statusTextChanged, this, [this, tool] {
    if (tool == current_) {
      Q_EMIT statusTextChanged(tool->statusText());
    }
  });
}

QAction* ToolManager::action(const Tool* tool) const {
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    if (tools_[i] == tool) {
      return group_.actions().at(static_cast<int>(i));
    }
  }
  return nullptr;
}

void ToolManager::setCurrent(Tool* tool) {
  if (tool == current_ || (!editingEnabled_ && tool != tools_.front())) {
    return;
  }
  current_ = tool;
  scene_.setTool(tool);
  action(tool)->setChecked(true);
  Q_EMIT currentChanged(tool);
  Q_EMIT statusTextChanged(tool->statusText());
}

void ToolManager::setEditingEnabled(bool enabled) {
  if (!enabled) {
    setCurrent(tools_.front());
  }
  editingEnabled_ = enabled;
  for (std::size_t i = 1; i < tools_.size(); ++i) {
    group_.actions().at(static_cast<int>(i))->setEnabled(enabled);
  }
  Q_EMIT statusTextChanged(current_->statusText());
}

}  // namespace editor
