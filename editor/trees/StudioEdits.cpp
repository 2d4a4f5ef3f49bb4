// What the studio does to a tree; how it looks and listens: TreeStudio.cpp.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

#include "editor/document/EditCommands.h"
#include "editor/document/TreeFiles.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/BreakpointMenu.h"
#include "editor/panels/TreeOutline.h"
#include "editor/trees/TreeStudio.h"

namespace editor {

namespace {

/// What the number in a port names; Scenario: nothing on the map.
EntityKind kindOfPort(const std::string& port) {
  if (port == "goal_id") {
    return EntityKind::Goal;
  }
  return port == "target_agent_id" || port == "target_id" ? EntityKind::Human
                                                          : EntityKind::Scenario;
}

QString readOnlyWords() {
  return QObject::tr("The node stands in an included file, which is not edited here");
}

}  // namespace

bool TreeStudio::apply(const QString& text, const QString& ifNot, const Edit& edit) {
  if (human() == nullptr) {
    return false;
  }
  bt::TreeFile file = canvas_->graph().tree().file;
  const MaybePlace place = edit(file);
  if (!place) {
    say(ifNot);
    return false;
  }
  hint_->clear();
  const int before = canvas_->chosen();
  pushTreeFile(document_, edited(), file, text);
  const int now = canvas_->graph().nodeAtPlace(*place, before);
  canvas_->choose(now);
  showChosen();
  Q_EMIT nodeChosen(now);
  return true;
}

bool TreeStudio::applyToChosen(
    const QString& text, const QString& ifNot,
    const std::function<MaybePlace(bt::TreeFile&, const TreePlace&)>& edit) {
  const TreeGraph& graph = canvas_->graph();
  const int node = canvas_->chosen();
  if (!graph.has(node)) {
    say(tr("Choose a node first"));
    return false;
  }
  if (!graph.isEditable(node)) {
    say(readOnlyWords());
    return false;
  }
  const auto named = [&](QString words) {  // not all sentences name it
    return words.replace(QStringLiteral("%1"), label(node));
  };
  return apply(named(text), named(ifNot),
               [&](bt::TreeFile& file) { return edit(file, graph.placeOf(node)); });
}

/// Below the chosen node, else behind it.
void TreeStudio::add(const QString& xml) {
  const TreeGraph& graph = canvas_->graph();
  if (graph.nodes().empty()) {
    return;
  }
  const int node = graph.has(canvas_->chosen()) ? canvas_->chosen() : 0;
  if (!graph.isEditable(node)) {
    say(readOnlyWords());
    return;
  }
  DropPlace place;
  place.node = node;
  place.index = static_cast<int>(graph.childrenOf(node).size());
  const bt::NodeSpec& spec = *graph.node(node).node;
  if (!takesChild(spec) && graph.node(node).parent >= 0 && !graph.placeOf(node).isRoot()) {
    place.node = graph.node(node).parent;
    place.index = graph.placeOf(node).path.back() + 1;
  }
  addAt(xml, place);
}

void TreeStudio::addAt(const QString& xml, const DropPlace& to) {
  const TreeGraph& graph = canvas_->graph();
  if (!graph.has(to.node)) {
    return;
  }
  const TreePlace at = graph.placeOf(to.node);
  bt::TreeFile known = graph.tree().file;
  const base::Result<bt::NodeSpec> node = nodeFromText(xml.toStdString(), known);
  if (!node) {
    say(QString::fromStdString(node.diagnostics().front().message));
    return;
  }
  const QString name = nodeTitle(*node);
  const bool isAround = to.how == DropPlace::How::Around;
  apply(isAround ? tr("Put %1 around %2").arg(name, label(to.node)) : tr("Add %1").arg(name),
        tr("%1 has no place for %2").arg(label(to.node), name), [&](bt::TreeFile& file) {
          file = known;
          return isAround ? wrapNode(file, at, *node) : addNode(file, at, to.index, *node);
        });
}

void TreeStudio::move(int node, const DropPlace& to) {
  const TreeGraph& graph = canvas_->graph();
  if (graph.has(node) && graph.has(to.node)) {
    apply(tr("Move %1").arg(label(node)), {}, [&](bt::TreeFile& file) {
      return moveNode(file, graph.placeOf(node), graph.placeOf(to.node), to.index);
    });
  }
}

void TreeStudio::moveBy(int places) {
  applyToChosen(
      tr("Move %1"), {}, [places](bt::TreeFile& file, const TreePlace& place) -> MaybePlace {
        const bt::NodeSpec* above = place.isRoot() ? nullptr : nodeAt(file, place.parent());
        const int to = place.isRoot() ? -1 : place.path.back() + places;
        if (above == nullptr || to < 0 || to >= static_cast<int>(above->children.size())) {
          return std::nullopt;
        }
        return moveNode(file, place, place.parent(), places > 0 ? to + 1 : to);
      });
}

void TreeStudio::remove() {
  applyToChosen(tr("Remove %1"), tr("A tree needs its root: replace it instead"), removeNode);
}

void TreeStudio::duplicate() {
  applyToChosen(tr("Duplicate %1"), tr("There is no place beside %1 for another"), duplicateNode);
}

void TreeStudio::copy() {
  const int node = canvas_->chosen();
  if (!canvas_->graph().has(node)) {
    say(tr("Choose a node first"));
    return;
  }
  QGuiApplication::clipboard()->setText(
      QString::fromStdString(nodeText(*canvas_->graph().node(node).node)));
  say(tr("%1 is copied as XML").arg(label(node)));
}

void TreeStudio::cut() {
  const int node = canvas_->chosen();
  if (canvas_->graph().has(node)) {
    const QString text = QString::fromStdString(nodeText(*canvas_->graph().node(node).node));
    if (applyToChosen(tr("Cut %1"), tr("A tree needs its root"), removeNode)) {
      QGuiApplication::clipboard()->setText(text);
    }
  }
}

void TreeStudio::paste() {
  const QString text = QGuiApplication::clipboard()->text();
  if (text.trimmed().startsWith(QLatin1Char('<'))) {
    add(text);
  } else {
    say(tr("The clipboard holds no node: copy one here, or its XML elsewhere"));
  }
}

void TreeStudio::wrapIn(const std::string& id) {
  applyToChosen(tr("Put %2 around %1").arg(QStringLiteral("%1"), QString::fromStdString(id)), {},
                [&id](bt::TreeFile& file, const TreePlace& place) {
                  return wrapNode(file, place, freshNode(id));
                });
}

void TreeStudio::replaceBy(const std::string& id) {
  const QString name = QString::fromStdString(id);
  applyToChosen(tr("Replace %1 by %2").arg(QStringLiteral("%1"), name),
                tr("%2 cannot hold what is below %1").arg(QStringLiteral("%1"), name),
                [&id](bt::TreeFile& file, const TreePlace& place) {
                  return replaceNode(file, place, freshNode(id));
                });
}

void TreeStudio::unwrap() {
  applyToChosen(tr("Take %1 away from what it holds"), tr("What %1 holds has no place above it"),
                unwrapNode);
}

void TreeStudio::extract() {
  const int node = canvas_->chosen();
  const std::string name =
      canvas_->graph().has(node) ? canvas_->graph().node(node).node->label() : std::string();
  applyToChosen(tr("Make a subtree of %1"), tr("%1 is a tree already"),
                [&name](bt::TreeFile& file, const TreePlace& place) {
                  return extractTree(file, place, name + "Tree");
                });
}

void TreeStudio::putInPlace() {
  applyToChosen(tr("Put the subtree %1 in its place"),
                tr("%1 has entries of its own, or stands in an included file"), inlineTree);
}

void TreeStudio::beginRename() {
  TreeGraph& graph = canvas_->graph();
  const int node = canvas_->chosen();
  if (!graph.has(node) || !graph.isEditable(node)) {
    return;
  }
  const QRectF box = graph.box(node);
  const QPointF corner = canvas_->fromGraph(box.topLeft());
  nameField_->setGeometry(static_cast<int>(corner.x()), static_cast<int>(corner.y()),
                          std::max(140, static_cast<int>(box.width() * canvas_->zoom())), 24);
  nameField_->setText(QString::fromStdString(graph.node(node).node->name));
  nameField_->setPlaceholderText(QString::fromStdString(graph.node(node).node->id));
  nameField_->selectAll();
  nameField_->show();
  nameField_->setFocus();
}

void TreeStudio::endRename(bool take) {
  if (nameField_->isHidden()) {
    return;
  }
  nameField_->hide();  // first: it loses the keyboard
  if (take) {
    const std::string name = nameField_->text().trimmed().toStdString();
    applyToChosen(tr("Name %1"), {}, [&name](bt::TreeFile& file, const TreePlace& place) {
      return renameNode(file, place, name);
    });
  }
}

void TreeStudio::pick(const std::string& port) {
  pickedPort_ = port;
  say(kindOfPort(port) == EntityKind::Goal
          ? tr("Click the goal on the map, or in the list of the scenario")
          : tr("Click the person on the map, or in the list of the scenario"));
  hintTimer_.stop();  // until it is done
}

/// Whether the selection was meant for the port.
bool TreeStudio::takePicked() {
  if (document_.selection().empty()) {
    return false;
  }
  const EntityId id = document_.selection().back();
  const std::string port = std::exchange(pickedPort_, {});
  const sim2d::GlobalGoal* goal = document_.goal(id);
  const sim2d::Human* other = document_.human(id);
  const bool isGoal = kindOfPort(port) == EntityKind::Goal;
  if ((isGoal && goal == nullptr) || (!isGoal && other == nullptr)) {
    say(tr("Nothing was picked"));
    return false;
  }
  const std::string value = std::to_string(isGoal ? goal->id : other->id);
  document_.setSelection({person_});
  applyToChosen(tr("Change %2 of %1").arg(QStringLiteral("%1"), QString::fromStdString(port)), {},
                [&](bt::TreeFile& file, const TreePlace& place) -> MaybePlace {
                  bt::TreeSpec* tree = file.find(place.tree);
                  bt::NodeSpec* node = tree == nullptr ? nullptr : bt::nodeAt(*tree, place.path);
                  if (node == nullptr) {
                    return std::nullopt;
                  }
                  bt::setText(node->ports, port, value);
                  return place;
                });
  return true;
}

void TreeStudio::giveTo(EntityId other) {
  const std::optional<std::string> own = document_.tree(person_);
  const sim2d::Human* to = document_.human(other);
  if (to == nullptr || human() == nullptr || other == person_) {
    return;
  }
  const QString name = QString::fromStdString(to->name);
  if (own && document_.tree(other) == own) {
    pushTreeText(document_, other, std::nullopt, tr("Make the tree of %1 anew").arg(name));
    return;
  }
  const std::string text = treeText(document_, person_);
  pushTrees(document_, {{person_, text}, {other, text}},
            tr("Give the tree of %1 to %2").arg(QString::fromStdString(human()->name), name));
}

void TreeStudio::offerGiving() {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const std::vector<EntityId> same = peopleWithTreeOf(document_, person_);
  for (const EntityId id : document_.entities(EntityKind::Human)) {
    if (id == person_) {
      continue;
    }
    QAction* action = menu->addAction(QString::fromStdString(document_.human(id)->name), this,
                                      [this, id] { giveTo(id); });
    action->setCheckable(true);
    action->setChecked(std::count(same.begin(), same.end(), id) > 0);
  }
  if (menu->isEmpty()) {
    menu->addAction(tr("There is nobody else"))->setEnabled(false);
  }
  menu->popup(give_->mapToGlobal(QPoint(0, give_->height())));
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
    if (kindOfPort(port.key) != EntityKind::Scenario) {
      menu.addAction(tr("Pick %1 on the map").arg(QString::fromStdString(port.key)), this,
                     [this, key = port.key] { pick(key); });
    }
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
