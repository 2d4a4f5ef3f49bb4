// Context menus of the TreeEditor. Entries that cannot work are disabled; their tooltip says why.

#include <tuple>

#include "editor/document/PersonTree.h"
#include "editor/look/CoreText.h"
#include "editor/panels/behavior/TreeOutline.h"
#include "editor/trees/TreeEditor.h"
#include "editor/trees/TreeRefusals.h"

namespace editor {

namespace {

void setPossible(QAction& entry, const QString& whyNot) {
  entry.setEnabled(whyNot.isEmpty());
  if (!whyNot.isEmpty()) {
    entry.setToolTip(whyNot);
  }
}

/// Disables a submenu whose entries are all disabled.
void disableIfNothingWorks(QMenu& menu) {
  const QList<QAction*> entries = menu.actions();
  menu.menuAction()->setEnabled(std::any_of(entries.begin(), entries.end(),
                                            [](QAction* entry) { return entry->isEnabled(); }));
}

}  // namespace

void TreeEditor::showAssignMenu() {
  QMenu& menu = menu_.begin(*this);
  const std::vector<EntityId> same = peopleWithTreeOf(document_, person_);
  for (const EntityId id : document_.entities(EntityKind::Human)) {
    if (id == person_) {
      continue;
    }
    QAction* action = menu.addAction(QString::fromStdString(document_.human(id)->name), this,
                                     [this, id] { assignTreeTo(id); });
    action->setCheckable(true);
    action->setChecked(std::count(same.begin(), same.end(), id) > 0);
  }
  if (menu.isEmpty()) {
    menu.addAction(tr("No other person"))->setEnabled(false);
  }
  menu.popup(assignButton_->mapToGlobal(QPoint(0, assignButton_->height())));
}

/// Adds submenus of node kinds, one for each kind; `whyNot` gives the reason why a node type is
/// impossible.
void TreeEditor::addKinds(QMenu& menu, const QString& title, bool areParents,
                          const std::function<QString(const bt::NodeSpec&)>& whyNot,
                          const std::function<void(const std::string&)>& take) {
  QMenu* all = menu.addMenu(title);
  for (const bt::NodeKind kind : {bt::NodeKind::Decorator, bt::NodeKind::Control,
                                  bt::NodeKind::Condition, bt::NodeKind::Action}) {
    const bool isParent = kind == bt::NodeKind::Decorator || kind == bt::NodeKind::Control;
    if (areParents && !isParent) {
      continue;
    }
    QMenu* part = all->addMenu(coreText(bt::nodeKindName(kind)));
    for (const bt::NodeManifest& manifest : treeCatalogue().all()) {
      if (manifest.kind == kind) {
        QAction* action = part->addAction(QString::fromStdString(manifest.id), this,
                                          [take, id = manifest.id] { take(id); });
        action->setToolTip(coreText(manifest.description));
        setPossible(*action, whyNot(defaultNode(manifest.id)));
      }
    }
    part->setToolTipsVisible(true);
    disableIfNothingWorks(*part);
  }
  disableIfNothingWorks(*all);
}

void TreeEditor::addPicks(QMenu& menu, const bt::NodeSpec& node) {
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

void TreeEditor::fillMultiSelectionMenu(QMenu& menu) {
  const OptionalLocations places = selectedLocations();
  const bt::TreeFile& file = canvas_->graph().tree().file;
  const auto why = [&](const QString& reason) { return places ? reason : readOnlyText(); };
  const std::vector<NodeLocation> nodes = places.value_or(std::vector<NodeLocation>());
  addKinds(
      menu, tr("Wrap in"), true,
      [&](const bt::NodeSpec& around) { return why(whyNotWrapped(file, nodes, around)); },
      [this](const std::string& id) { wrapIn(id); });
  menu.addSeparator();
  const std::tuple<QString, QString, void (TreeEditor::*)()> entries[] = {
      {tr("Duplicate\tCtrl+D"), why(whyNotDuplicated(file, nodes)), &TreeEditor::duplicate},
      {tr("Cut\tCtrl+X"), why(whyNotRemoved(file, nodes)), &TreeEditor::cut},
      {tr("Copy as XML\tCtrl+C"), {}, &TreeEditor::copy},
      {tr("Delete\tDel"), why(whyNotRemoved(file, nodes)), &TreeEditor::remove}};
  for (const auto& [text, reason, action] : entries) {
    setPossible(*menu.addAction(text, this, action), reason);
  }
}

void TreeEditor::fillTreeMenu(QMenu& menu) {
  const auto add = [&](const QString& text, bool isOn, auto action) {
    menu.addAction(text, this, action)->setEnabled(isOn);
  };
  const bool hasNodes = !canvas_->graph().nodes().empty();
  add(tr("Paste\tCtrl+V"), hasNodes, [this] { paste(); });
  add(tr("Fit\tF"), true, [this] { canvas_->fit(); });
  menu.addSeparator();
  add(tr("New tree"), human() != nullptr, [this] { startNewTree(); });
  add(tr("Save picture…"), hasNodes, [this] { Q_EMIT pictureRequested(person_); });
}

/// The edits of the structure: wrap, replace, remove, extract or inline.
void TreeEditor::addStructureEntries(QMenu& menu, const NodeLocation& place) {
  const bt::TreeFile& file = canvas_->graph().tree().file;
  addKinds(
      menu, tr("Wrap in"), true,
      [&](const bt::NodeSpec& around) { return whyNotWrapped(file, {place}, around); },
      [this](const std::string& id) { wrapIn(id); });
  addKinds(
      menu, tr("Replace with"), false,
      [&](const bt::NodeSpec& by) { return whyNotReplaced(file, place, by); },
      [this](const std::string& id) { replaceBy(id); });
  const bt::NodeSpec* node = nodeAt(file, place);
  setPossible(*menu.addAction(tr("Remove, keep children"), this, &TreeEditor::unwrap),
              whyNotUnwrapped(file, place));
  if (node != nullptr && node->isSubTree()) {
    setPossible(*menu.addAction(tr("Inline subtree"), this, &TreeEditor::inlineSubtree),
                whyNotInlined(file, place));
  } else {
    setPossible(*menu.addAction(tr("Extract as subtree"), this, &TreeEditor::extract),
                whyNotExtracted(file, place));
  }
}

void TreeEditor::fillMenu(QMenu& menu, int node) {
  menu.setToolTipsVisible(true);
  TreeGraph& graph = canvas_->graph();
  if (!graph.has(node)) {
    fillTreeMenu(menu);
    return;
  }
  if (canvas_->selected().size() > 1) {
    fillMultiSelectionMenu(menu);
    return;
  }
  const bool isCustom = graph.isEditable(node);
  const bt::TreeFile& file = graph.tree().file;
  const NodeLocation place = graph.locationOf(node);
  const auto add = [&](const QString& text, const QString& whyNot, auto action) {
    setPossible(*menu.addAction(text, this, action), isCustom ? whyNot : readOnlyText());
  };
  if (!graph.node(node).node->isSubTree()) {  // Enter unfolds a subtree.
    add(tr("Edit ports\tEnter"), {}, [this] { editFields(); });
  }
  add(tr("Add a node…\tIns"), {}, [this] { palette_->startSearch(); });
  if (isCustom) {
    addPicks(menu, *graph.node(node).node);
    addStructureEntries(menu, place);
  }
  menu.addSeparator();
  add(tr("Rename\tF2"), {}, [this] { beginRename(); });
  add(tr("Earlier\tAlt+Left"), whyNotMovedBy(file, place, -1), [this] { moveBy(-1); });
  add(tr("Later\tAlt+Right"), whyNotMovedBy(file, place, 1), [this] { moveBy(1); });
  add(tr("Duplicate\tCtrl+D"), whyNotDuplicated(file, {place}), [this] { duplicate(); });
  add(tr("Cut\tCtrl+X"), whyNotRemoved(file, {place}), [this] { cut(); });
  menu.addAction(tr("Copy as XML\tCtrl+C"), this, [this] { copy(); });
  add(tr("Paste\tCtrl+V"), {}, [this] { paste(); });
  add(tr("Delete\tDel"), whyNotRemoved(file, {place}), [this] { remove(); });
  addViewEntries(menu, node);
}

/// Folding and breakpoints, also for nodes of included files.
void TreeEditor::addViewEntries(QMenu& menu, int node) {
  TreeGraph& graph = canvas_->graph();
  if (!graph.childrenOf(node).empty()) {
    const bool isFolded = graph.isFolded(node);
    menu.addAction(isFolded ? tr("Expand\t+") : tr("Collapse\t-"), this, [this, node, isFolded] {
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
