// Edits of the TreeEditor; display and signals: TreeEditor.cpp.

#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/panels/behavior/TreeOutline.h"
#include "editor/trees/TreeEditor.h"
#include "editor/trees/TreeRefusals.h"

namespace editor {

namespace {

/// The kind of entity to which the number in a port refers; Scenario: none.
EntityKind kindOfPort(const std::string& port) {
  if (port == "goal_id") {
    return EntityKind::Goal;
  }
  return port == "target_agent_id" || port == "target_id" ? EntityKind::Human
                                                          : EntityKind::Scenario;
}

/// A single node as a list.
OptionalLocations only(const OptionalLocation& place) {
  return place ? OptionalLocations({*place}) : std::nullopt;
}

}  // namespace

QString TreeEditor::readOnlyText() {
  return tr("The node is in an included file, which cannot be edited here");
}

bool TreeEditor::isPickable(const std::string& port) {
  return kindOfPort(port) != EntityKind::Scenario;
}

bool TreeEditor::apply(const QString& text, const QString& whyNot, const Edit& edit) {
  if (human() == nullptr) {
    return false;
  }
  bt::TreeFile file = canvas_->graph().tree().file;
  const OptionalLocations places = whyNot.isEmpty() ? edit(file) : std::nullopt;
  if (!places || places->empty()) {
    showHint(whyNot);
    return false;
  }
  hint_->clear();
  const int before = canvas_->chosen();
  pushTreeFile(document_, edited(), file, text);
  std::vector<int> nodes;
  for (const NodeLocation& place : *places) {
    nodes.push_back(canvas_->graph().nodeAtLocation(place, before));
  }
  canvas_->select(nodes, nodes.front());
  showChosen();
  Q_EMIT nodeChosen(canvas_->chosen());
  return true;
}

OptionalLocations TreeEditor::selectedLocations() const {
  const TreeGraph& graph = canvas_->graph();
  std::vector<NodeLocation> places;
  for (const int node : canvas_->selected()) {
    if (!graph.isEditable(node)) {
      return std::nullopt;
    }
    places.push_back(graph.locationOf(node));
  }
  return withoutDescendants(std::move(places));
}

bool TreeEditor::applyTo(const OptionalLocations& places, const QString& text, const WhyNot& whyNot,
                         const EditOfNodes& edit) {
  if (!canvas_->graph().has(canvas_->chosen())) {
    showHint(tr("Select a node first"));
    return false;
  }
  if (!places) {
    showHint(readOnlyText());
    return false;
  }
  const QString why = whyNot ? whyNot(canvas_->graph().tree().file, *places) : QString();
  return apply(text, why, [&](bt::TreeFile& file) { return edit(file, *places); });
}

bool TreeEditor::applyToSelected(const QString& text, const WhyNot& whyNot,
                                 const EditOfNodes& edit) {
  return applyTo(selectedLocations(), text.arg(selectedNodesText()), whyNot, edit);
}

QString TreeEditor::selectedNodesText() const {
  const std::size_t count = canvas_->selected().size();
  return count == 1 ? label(canvas_->chosen()) : tr("%1 nodes").arg(count);
}

bool TreeEditor::applyToChosen(const QString& text, const WhyNotOne& whyNot,
                               const EditOfNode& edit) {
  const TreeGraph& graph = canvas_->graph();
  const int node = canvas_->chosen();
  const bool isEditable = graph.has(node) && graph.isEditable(node);
  const auto why = [&whyNot](const bt::TreeFile& file, const std::vector<NodeLocation>& places) {
    return whyNot ? whyNot(file, places.front()) : QString();
  };
  return applyTo(isEditable ? only(graph.locationOf(node)) : std::nullopt, text.arg(label(node)),
                 why, [&edit](bt::TreeFile& file, const std::vector<NodeLocation>& places) {
                   return only(edit(file, places.front()));
                 });
}

/// Adds a node below the chosen node, else after it.
void TreeEditor::add(const QString& xml) {
  const TreeGraph& graph = canvas_->graph();
  if (graph.nodes().empty()) {
    return;
  }
  const int node = graph.has(canvas_->chosen()) ? canvas_->chosen() : 0;
  if (!graph.isEditable(node)) {
    showHint(readOnlyText());
    return;
  }
  DropTarget place;
  place.node = node;
  place.index = static_cast<int>(graph.childrenOf(node).size());
  const bt::NodeSpec& spec = *graph.node(node).node;
  if (!canHaveChildren(spec) && graph.node(node).parent >= 0 && !graph.locationOf(node).isRoot()) {
    place.node = graph.node(node).parent;
    place.index = graph.locationOf(node).path.back() + 1;
  }
  addAt(xml, place);
}

void TreeEditor::addAt(const QString& xml, const DropTarget& to) {
  const TreeGraph& graph = canvas_->graph();
  if (!graph.has(to.node)) {
    return;
  }
  const NodeLocation at = graph.locationOf(to.node);
  bt::TreeFile known = graph.tree().file;
  const base::Result<std::vector<bt::NodeSpec>> nodes = nodesFromText(xml.toStdString(), known);
  if (!nodes) {
    showHint(QString::fromStdString(nodes.diagnostics().front().message));
    return;
  }
  const QString name =
      nodes->size() == 1 ? nodeTitle(nodes->front()) : tr("%1 nodes").arg(nodes->size());
  const bool isAround = to.how == DropTarget::How::Around;
  apply(
      isAround ? tr("Wrap %2 in %1").arg(name, label(to.node)) : tr("Add %1").arg(name),
      isAround ? whyNotWrapped(known, {at}, nodes->front()) : whyNotAdded(known, at, nodes->size()),
      [&](bt::TreeFile& file) {
        file = known;
        return isAround ? wrapNodes(file, {at}, nodes->front())
                        : addNodes(file, at, to.index, *nodes);
      });
}

void TreeEditor::move(int node, const DropTarget& to) {
  const TreeGraph& graph = canvas_->graph();
  const auto places = selectedLocations();
  if (!graph.has(node) || !graph.has(to.node)) {
    return;
  }
  const bool isOfSeveral = canvas_->shown().isSelected(node) && places && places->size() > 1;
  apply(tr("Move %1").arg(isOfSeveral ? selectedNodesText() : label(node)), {},
        [&](bt::TreeFile& file) {
          return moveNodes(file, isOfSeveral ? *places : std::vector{graph.locationOf(node)},
                           graph.locationOf(to.node), to.index);
        });
}

void TreeEditor::moveBy(int places) {
  applyToChosen(
      tr("Move %1"),
      [places](const bt::TreeFile& file, const NodeLocation& place) {
        return whyNotMovedBy(file, place, places);
      },
      [places](bt::TreeFile& file, const NodeLocation& place) -> OptionalLocation {
        const int to = place.path.back() + places;
        const auto moved = moveNodes(file, {place}, place.parent(), places > 0 ? to + 1 : to);
        return moved ? OptionalLocation(moved->front()) : std::nullopt;
      });
}

void TreeEditor::remove() {
  applyToSelected(tr("Remove %1"), whyNotRemoved, removeNodes);
}

void TreeEditor::duplicate() {
  applyToSelected(tr("Duplicate %1"), whyNotDuplicated, duplicateNodes);
}

QString TreeEditor::selectedText() const {
  const TreeGraph& graph = canvas_->graph();
  std::vector<const bt::NodeSpec*> nodes;
  for (const int node : canvas_->selected()) {
    int above = graph.node(node).parent;
    while (above >= 0 && !canvas_->shown().isSelected(above)) {
      above = graph.node(above).parent;
    }
    if (above < 0) {  // Otherwise it is inside another selected node.
      nodes.push_back(graph.node(node).node);
    }
  }
  return QString::fromStdString(nodesText(nodes));
}

void TreeEditor::copy() {
  if (canvas_->selected().empty()) {
    showHint(tr("Select a node first"));
    return;
  }
  QGuiApplication::clipboard()->setText(selectedText());
  const bool isOne = canvas_->selected().size() == 1;
  showHint(
      (isOne ? tr("%1 is copied as XML") : tr("%1 are copied as XML")).arg(selectedNodesText()));
}

void TreeEditor::cut() {
  const QString text = selectedText();
  if (applyToSelected(tr("Cut %1"), whyNotRemoved, removeNodes)) {
    QGuiApplication::clipboard()->setText(text);
  }
}

void TreeEditor::paste() {
  const QString text = QGuiApplication::clipboard()->text();
  if (text.trimmed().startsWith(QLatin1Char('<'))) {
    add(text);
  } else {
    showHint(tr("The clipboard contains no node: copy a node or its XML first"));
  }
}

void TreeEditor::wrapIn(const std::string& id) {
  applyToSelected(
      tr("Wrap %1 in %2").arg(QStringLiteral("%1"), QString::fromStdString(id)),
      [&id](const bt::TreeFile& file, const std::vector<NodeLocation>& places) {
        return whyNotWrapped(file, places, defaultNode(id));
      },
      [&id](bt::TreeFile& file, const std::vector<NodeLocation>& places) {
        return wrapNodes(file, places, defaultNode(id));
      });
}

void TreeEditor::replaceBy(const std::string& id) {
  applyToChosen(
      tr("Replace %1 with %2").arg(QStringLiteral("%1"), QString::fromStdString(id)),
      [&id](const bt::TreeFile& file, const NodeLocation& place) {
        return whyNotReplaced(file, place, defaultNode(id));
      },
      [&id](bt::TreeFile& file, const NodeLocation& place) {
        return replaceNode(file, place, defaultNode(id));
      });
}

void TreeEditor::unwrap() {
  applyToChosen(tr("Remove %1, keep children"), whyNotUnwrapped, unwrapNode);
}

void TreeEditor::extract() {
  const int node = canvas_->chosen();
  const std::string name =
      canvas_->graph().has(node) ? canvas_->graph().node(node).node->label() : std::string();
  applyToChosen(tr("Extract %1 as subtree"), whyNotExtracted,
                [&name](bt::TreeFile& file, const NodeLocation& place) {
                  return extractTree(file, place, name + "Tree");
                });
}

void TreeEditor::inlineSubtree() {
  applyToChosen(tr("Inline subtree %1"), whyNotInlined, inlineTree);
}

void TreeEditor::beginRename() {
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

void TreeEditor::endRename(bool take) {
  if (nameField_->isHidden()) {
    return;
  }
  nameField_->hide();  // First, because hiding removes the focus.
  if (take) {
    const std::string name = nameField_->text().trimmed().toStdString();
    applyToChosen(tr("Rename %1"), {}, [&name](bt::TreeFile& file, const NodeLocation& place) {
      return renameNode(file, place, name);
    });
  }
}

void TreeEditor::editFields() {
  const TreeGraph& graph = canvas_->graph();
  const int node = canvas_->chosen();
  if (!graph.has(node)) {
    return;
  }
  if (!graph.isEditable(node)) {
    showHint(readOnlyText());
    return;
  }
  endRename(true);
  fields_->open(*graph.node(node).node, canvas_->placeOf(node));
}

void TreeEditor::applyFields(const bt::NodeSpec& edited) {
  applyToChosen(tr("Edit %1"), {},
                [&edited](bt::TreeFile& file, const NodeLocation& place) -> OptionalLocation {
                  bt::TreeSpec* tree = file.find(place.tree);
                  bt::NodeSpec* node = tree == nullptr ? nullptr : bt::nodeAt(*tree, place.path);
                  if (node == nullptr) {
                    return std::nullopt;
                  }
                  node->name = edited.name;
                  node->ports = edited.ports;
                  return place;
                });
}

void TreeEditor::startNewTree() {
  if (human() == nullptr) {
    return;
  }
  bt::TreeSpec tree;
  tree.id = "MainTree";
  tree.root = defaultNode("Sequence");
  bt::TreeFile file;
  file.mainTree = tree.id;
  file.trees.push_back(std::move(tree));
  file.order = {bt::FilePart::Tree};
  pushTreeFile(document_, edited(), file, tr("New tree"));
  choose(0);
  palette_->startSearch();
  showHint(tr("Type the name of a node: Enter adds it below the selected one"));
}

void TreeEditor::pick(const std::string& port) {
  pickedPort_ = port;
  showHint(kindOfPort(port) == EntityKind::Goal
               ? tr("Click the goal on the map, or in the scenario list")
               : tr("Click the person on the map, or in the scenario list"));
  hintTimer_.stop();  // The hint stays until the pick is complete.
}

/// Returns true if the selection was used for the port.
bool TreeEditor::finishPick() {
  if (document_.selection().empty()) {
    return false;
  }
  const EntityId id = document_.selection().back();
  const std::string port = std::exchange(pickedPort_, {});
  const sim2d::GlobalGoal* goal = document_.goal(id);
  const sim2d::Human* other = document_.human(id);
  const bool isGoal = kindOfPort(port) == EntityKind::Goal;
  if ((isGoal && goal == nullptr) || (!isGoal && other == nullptr)) {
    showHint(tr("Nothing was picked"));
    return false;
  }
  const std::string value = std::to_string(isGoal ? goal->id : other->id);
  document_.setSelection({person_});
  applyToChosen(tr("Change %2 of %1").arg(QStringLiteral("%1"), QString::fromStdString(port)), {},
                [&](bt::TreeFile& file, const NodeLocation& place) -> OptionalLocation {
                  bt::TreeSpec* tree = file.find(place.tree);
                  bt::NodeSpec* node = tree == nullptr ? nullptr : bt::nodeAt(*tree, place.path);
                  if (node == nullptr) {
                    return std::nullopt;
                  }
                  bt::setAttribute(node->ports, port, value);
                  return place;
                });
  return true;
}

void TreeEditor::assignTreeTo(EntityId other) {
  const std::optional<std::string> own = document_.tree(person_);
  const sim2d::Human* to = document_.human(other);
  if (to == nullptr || human() == nullptr || other == person_) {
    return;
  }
  const QString name = QString::fromStdString(to->name);
  if (own && document_.tree(other) == own) {
    pushTreeText(document_, other, std::nullopt, tr("Regenerate the tree of %1").arg(name));
    return;
  }
  const std::string text = treeText(document_, person_);
  pushTrees(document_, {{person_, text}, {other, text}},
            tr("Assign the tree of %1 to %2").arg(QString::fromStdString(human()->name), name));
}

}  // namespace editor
