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

/// One edited node among those that are looked at afterwards.
MaybePlaces only(const MaybePlace& place) {
  return place ? MaybePlaces({*place}) : std::nullopt;
}

}  // namespace

bool TreeStudio::isPickable(const std::string& port) {
  return kindOfPort(port) != EntityKind::Scenario;
}

bool TreeStudio::apply(const QString& text, const QString& ifNot, const Edit& edit) {
  if (human() == nullptr) {
    return false;
  }
  bt::TreeFile file = canvas_->graph().tree().file;
  const MaybePlaces places = edit(file);
  if (!places || places->empty()) {
    say(ifNot);
    return false;
  }
  hint_->clear();
  const int before = canvas_->chosen();
  pushTreeFile(document_, edited(), file, text);
  std::vector<int> nodes;
  for (const TreePlace& place : *places) {
    nodes.push_back(canvas_->graph().nodeAtPlace(place, before));
  }
  canvas_->select(nodes, nodes.front());
  showChosen();
  Q_EMIT nodeChosen(canvas_->chosen());
  return true;
}

std::optional<std::vector<TreePlace>> TreeStudio::selectedPlaces() const {
  const TreeGraph& graph = canvas_->graph();
  std::vector<TreePlace> places;
  for (const int node : canvas_->selected()) {
    if (!graph.isEditable(node)) {
      return std::nullopt;
    }
    places.push_back(graph.placeOf(node));
  }
  return withoutInner(std::move(places));
}

bool TreeStudio::applyToSelected(
    const QString& text, const QString& ifNot,
    const std::function<MaybePlaces(bt::TreeFile&, const std::vector<TreePlace>&)>& edit) {
  const TreeGraph& graph = canvas_->graph();
  if (!graph.has(canvas_->chosen())) {
    say(tr("Choose a node first"));
    return false;
  }
  const auto places = selectedPlaces();
  if (!places) {
    say(readOnlyWords());
    return false;
  }
  const auto named = [&](QString words) {  // not all sentences name them
    return words.replace(QStringLiteral("%1"), selectedWords());
  };
  return apply(named(text), named(ifNot), [&](bt::TreeFile& file) { return edit(file, *places); });
}

QString TreeStudio::selectedWords() const {
  const std::size_t count = canvas_->selected().size();
  return count == 1 ? label(canvas_->chosen()) : tr("%1 nodes").arg(count);
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
               [&](bt::TreeFile& file) { return only(edit(file, graph.placeOf(node))); });
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
  const base::Result<std::vector<bt::NodeSpec>> nodes = nodesFromText(xml.toStdString(), known);
  if (!nodes) {
    say(QString::fromStdString(nodes.diagnostics().front().message));
    return;
  }
  const QString name =
      nodes->size() == 1 ? nodeTitle(nodes->front()) : tr("%1 nodes").arg(nodes->size());
  const bool isAround = to.how == DropPlace::How::Around;
  apply(isAround ? tr("Put %1 around %2").arg(name, label(to.node)) : tr("Add %1").arg(name),
        tr("%1 has no place for %2").arg(label(to.node), name), [&](bt::TreeFile& file) {
          file = known;
          return isAround ? only(wrapNode(file, at, nodes->front()))
                          : addNodes(file, at, to.index, *nodes);
        });
}

void TreeStudio::move(int node, const DropPlace& to) {
  const TreeGraph& graph = canvas_->graph();
  const auto places = selectedPlaces();
  if (!graph.has(node) || !graph.has(to.node)) {
    return;
  }
  const bool isOfSeveral = canvas_->shown().isSelected(node) && places && places->size() > 1;
  apply(tr("Move %1").arg(isOfSeveral ? selectedWords() : label(node)), {},
        [&](bt::TreeFile& file) {
          const TreePlace parent = graph.placeOf(to.node);
          return isOfSeveral ? moveNodes(file, *places, parent, to.index)
                             : only(moveNode(file, graph.placeOf(node), parent, to.index));
        });
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
  applyToSelected(tr("Remove %1"), tr("A tree needs its root: replace it instead"), removeNodes);
}

void TreeStudio::duplicate() {
  applyToSelected(tr("Duplicate %1"), tr("There is no place beside %1 for another"),
                  duplicateNodes);
}

QString TreeStudio::selectedText() const {
  const TreeGraph& graph = canvas_->graph();
  std::vector<const bt::NodeSpec*> nodes;
  for (const int node : canvas_->selected()) {
    int above = graph.node(node).parent;
    while (above >= 0 && !canvas_->shown().isSelected(above)) {
      above = graph.node(above).parent;
    }
    if (above < 0) {  // else it is within another one
      nodes.push_back(graph.node(node).node);
    }
  }
  return QString::fromStdString(nodesText(nodes));
}

void TreeStudio::copy() {
  if (canvas_->selected().empty()) {
    say(tr("Choose a node first"));
    return;
  }
  QGuiApplication::clipboard()->setText(selectedText());
  const bool isOne = canvas_->selected().size() == 1;
  say((isOne ? tr("%1 is copied as XML") : tr("%1 are copied as XML")).arg(selectedWords()));
}

void TreeStudio::cut() {
  const QString text = selectedText();
  if (applyToSelected(tr("Cut %1"), tr("A tree needs its root"), removeNodes)) {
    QGuiApplication::clipboard()->setText(text);
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
  const QString name = QString::fromStdString(id);
  applyToSelected(tr("Put %2 around %1").arg(QStringLiteral("%1"), name),
                  tr("%2 cannot hold %1: it takes one, or they have different parents")
                      .arg(QStringLiteral("%1"), name),
                  [&id](bt::TreeFile& file, const std::vector<TreePlace>& places) {
                    return wrapNodes(file, places, freshNode(id));
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

}  // namespace editor
