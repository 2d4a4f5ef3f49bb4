#include "editor/tools/ToolManager.h"

#include <algorithm>

#include <QAction>
#include <QGuiApplication>
#include <QKeyEvent>

#include "editor/look/Form.h"

namespace editor {

void addAllTools(ToolRegistry& to);  // written by CMake

ToolRegistry standardTools() {
  ToolRegistry registry;
  addAllTools(registry);
  return registry;
}

ToolManager::ToolManager(ScenarioDocument& document, MapScene& scene, const ToolRegistry& registry,
                         QObject* parent)
    : QObject(parent), scene_(scene), group_(this) {
  std::vector<ToolRegistry::Entry> inOrder = registry.entries();
  std::stable_sort(inOrder.begin(), inOrder.end(),
                   [](const auto& a, const auto& b) { return a.info.order < b.info.order; });
  entries_.reserve(inOrder.size());  // actions hold references
  for (const ToolRegistry::Entry& entry : inOrder) {
    add(entry, document);
  }
  connect(&document, &ScenarioDocument::selectionChanged, this, [this] {
    if (current_ != nullptr) {
      Q_EMIT statusTextChanged(current_->statusText());
    }
  });
  connect(&document, &ScenarioDocument::aboutToBeReplaced, this, [this] {
    if (current_ != nullptr) {
      current_->cancel();  // the ids that a gesture holds will refer to other entities
    }
  });
  setCurrent(entries_.front());
  scene.installEventFilter(this);
}

ToolManager::~ToolManager() {
  scene_.setTool(nullptr);
}

void ToolManager::add(const ToolRegistry::Entry& entry, ScenarioDocument& document) {
  Tool* const tool = entry.make(document, scene_, this);
  auto* action = new QAction(entry.info.name, &group_);
  action->setCheckable(true);
  action->setShortcut(entry.info.shortcut);
  describe(*action, tool->statusText());
  action->setData(entry.info.icon);
  entries_.push_back({entry.info, tool, action});
  connect(action, &QAction::triggered, this,
          [this, &added = entries_.back()] { setCurrent(added); });
  connect(tool, &Tool::statusTextChanged, this, [this, tool] {
    if (tool == current_) {
      Q_EMIT statusTextChanged(tool->statusText());
    }
  });
}

void ToolManager::setCurrent(const Entry& entry) {
  if (entry.tool == current_ || (!editingEnabled_ && &entry != &entries_.front())) {
    return;
  }
  current_ = entry.tool;
  scene_.setTool(current_);
  entry.action->setChecked(true);
  Q_EMIT currentChanged(current_);
  Q_EMIT statusTextChanged(current_->statusText());
}

void ToolManager::setEditingEnabled(bool enabled) {
  if (!enabled) {
    setCurrent(entries_.front());
  }
  editingEnabled_ = enabled;
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    entries_[i].action->setEnabled(enabled);
  }
  Q_EMIT statusTextChanged(current_->statusText());
}

bool ToolManager::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::KeyPress || isSelecting() ||
      static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) {
    return false;
  }
  const QString before = current_->statusText();  // speaks of what is being drawn
  current_->cancel();
  if (before == current_->statusText() && QGuiApplication::mouseButtons() == Qt::NoButton) {
    setCurrent(entries_.front());
  }
  event->accept();
  return true;
}

}  // namespace editor
