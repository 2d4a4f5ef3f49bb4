// What can be done with a tree, as menus; how it is done: StudioEdits.cpp.
#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "editor/document/TreeFiles.h"
#include "editor/panels/BreakpointMenu.h"
#include "editor/trees/TreeStudio.h"

namespace editor {

void TreeStudio::offerGiving() {
  QMenu& menu = menu_.begin(*this);
  const std::vector<EntityId> same = peopleWithTreeOf(document_, person_);
  for (const EntityId id : document_.entities(EntityKind::Human)) {
    if (id == person_) {
      continue;
    }
    QAction* action = menu.addAction(QString::fromStdString(document_.human(id)->name), this,
                                     [this, id] { giveTo(id); });
    action->setCheckable(true);
    action->setChecked(std::count(same.begin(), same.end(), id) > 0);
  }
  if (menu.isEmpty()) {
    menu.addAction(tr("No other person"))->setEnabled(false);
  }
  menu.popup(give_->mapToGlobal(QPoint(0, give_->height())));
}

/// Kinds of nodes that hold others, or of leaves, in menus of their own.
void TreeStudio::addKinds(QMenu& menu, const QString& title, bool areParents,
                          const std::function<void(const std::string&)>& take) {
  QMenu* all = menu.addMenu(title);
  for (const bt::NodeKind kind : {bt::NodeKind::Decorator, bt::NodeKind::Control,
                                  bt::NodeKind::Condition, bt::NodeKind::Action}) {
    const bool isParent = kind == bt::NodeKind::Decorator || kind == bt::NodeKind::Control;
    if (areParents && !isParent) {
      continue;
    }
    QMenu* part = all->addMenu(QString::fromLatin1(bt::nodeKindName(kind)));
    for (const bt::NodeManifest& manifest : treeCatalogue().all()) {
      if (manifest.kind == kind) {
        QAction* action = part->addAction(QString::fromStdString(manifest.id), this,
                                          [take, id = manifest.id] { take(id); });
        action->setToolTip(QString::fromStdString(manifest.description));
      }
    }
    part->setToolTipsVisible(true);
  }
}

void TreeStudio::addPicks(QMenu& menu, const bt::NodeSpec& node) {
  const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
  if (manifest == nullptr) {
    return;
  }
  for (const bt::PortSpec& port : manifest->ports) {
    if (isPickable(port.key)) {
      menu.addAction(tr("Pick %1 on the map").arg(QString::fromStdString(port.key)), this,
                     [this, key = port.key] { pick(key); });
    }
  }
}

void TreeStudio::fillMenuOfSeveral(QMenu& menu) {
  const bool isOwn = selectedPlaces().has_value();
  addKinds(menu, tr("Put around them"), true, [this](const std::string& id) { wrapIn(id); });
  menu.actions().back()->setEnabled(isOwn);
  menu.addSeparator();
  const std::tuple<QString, bool, void (TreeStudio::*)()> entries[] = {
      {tr("Duplicate\tCtrl+D"), isOwn, &TreeStudio::duplicate},
      {tr("Cut\tCtrl+X"), isOwn, &TreeStudio::cut},
      {tr("Copy as XML\tCtrl+C"), true, &TreeStudio::copy},
      {tr("Delete\tDel"), isOwn, &TreeStudio::remove}};
  for (const auto& [text, isOn, action] : entries) {
    menu.addAction(text, this, action)->setEnabled(isOn);
  }
}

void TreeStudio::fillMenu(QMenu& menu, int node) {
  TreeGraph& graph = canvas_->graph();
  const auto add = [&](const QString& text, const QString& key, bool isOn, auto action) {
    QAction* entry =
        menu.addAction(key.isEmpty() ? text : text + QLatin1Char('\t') + key, this, action);
    entry->setEnabled(isOn);
  };
  if (!graph.has(node)) {
    add(tr("Paste"), tr("Ctrl+V"), !graph.nodes().empty(), [this] { paste(); });
    add(tr("Fit"), tr("F"), true, [this] { canvas_->fit(); });
    return;
  }
  if (canvas_->selected().size() > 1) {
    fillMenuOfSeveral(menu);
    return;
  }
  const bt::NodeSpec& spec = *graph.node(node).node;
  const bool isOwn = graph.isEditable(node);
  const bool isInner = isOwn && !graph.placeOf(node).isRoot();
  add(tr("Add a node…"), tr("Ins"), isOwn, [this] { palette_->search().setFocus(); });
  addPicks(menu, spec);
  if (isOwn) {
    addKinds(menu, tr("Put around it"), true, [this](const std::string& id) { wrapIn(id); });
    addKinds(menu, tr("Replace it by"), false, [this](const std::string& id) { replaceBy(id); });
  }
  add(tr("Take it away from what it holds"), {}, isOwn && !spec.children.empty(),
      [this] { unwrap(); });
  if (spec.isSubTree()) {
    add(tr("Put the subtree in its place"), {}, isOwn, [this] { putInPlace(); });
  } else {
    add(tr("Make a subtree of it"), {}, isInner, [this] { extract(); });
  }
  menu.addSeparator();
  add(tr("Rename"), tr("F2"), isOwn, [this] { beginRename(); });
  add(tr("Earlier"), tr("Alt+Left"), isInner, [this] { moveBy(-1); });
  add(tr("Later"), tr("Alt+Right"), isInner, [this] { moveBy(1); });
  add(tr("Duplicate"), tr("Ctrl+D"), isInner, [this] { duplicate(); });
  add(tr("Cut"), tr("Ctrl+X"), isInner, [this] { cut(); });
  add(tr("Copy as XML"), tr("Ctrl+C"), true, [this] { copy(); });
  add(tr("Paste"), tr("Ctrl+V"), isOwn, [this] { paste(); });
  add(tr("Delete"), tr("Del"), isInner, [this] { remove(); });
  if (!graph.childrenOf(node).empty()) {
    const bool isFolded = graph.isFolded(node);
    add(isFolded ? tr("Unfold") : tr("Fold"), isFolded ? tr("+") : tr("-"), true,
        [this, node, isFolded] {
          canvas_->graph().setFolded(node, !isFolded);
          canvas_->relayout();
        });
  }
  menu.addSeparator();
  if (human() != nullptr) {
    fillBreakpointMenu(menu, runner_, graph.names()[static_cast<std::size_t>(node)], human()->id,
                       *this);
  }
}

}  // namespace editor
