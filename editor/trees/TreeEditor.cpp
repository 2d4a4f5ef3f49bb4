#include "editor/trees/TreeEditor.h"

// Display and signals of the TreeEditor; its widgets: TreeDock.cpp.

#include <iterator>
#include <tuple>

#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/behavior/TreeOutline.h"

namespace editor {

namespace {

constexpr int kHintMs = 6000;

}  // namespace

void TreeEditor::setTheme(const Theme& theme) {
  canvas_->setTheme(theme);
  palette_->setTheme(theme);
  history_->setTheme(theme);
  text_->setTheme(theme);
  entries_->setTheme(theme);
  QPalette colors = QWidget::palette();
  colors.setColor(QPalette::WindowText, theme.color(Role::Warning));
  problem_->setPalette(colors);
  if (isVisible()) {
    listPeople();  // Updates their marks.
  }
}

void TreeEditor::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) {
    rebuild();
  }
  showStatuses();
}

/// Keeps the person selected last while goals or nothing are selected.
void TreeEditor::follow() {
  if (isPicking() && finishPick()) {
    return;
  }
  EntityId wanted = human() == nullptr ? EntityId() : person_;
  for (const EntityId id : document_.selection()) {
    wanted = id.kind == EntityKind::Human ? id : wanted;
  }
  if (wanted != person_ || !wanted) {
    text_->commitPendingEdit();  // The text is for the previous person.
    person_ = wanted;
    stale_ = true;
    canvas_->choose(-1);
  }
  if (stale_ && isVisible()) {
    rebuild();
  }
}

void TreeEditor::rebuild() {
  stale_ = false;
  menu_.close();  // The menu belongs to the previous tree or person.
  endRename(false);
  const std::vector<EntityId> all = document_.entities(EntityKind::Human);
  if (human() == nullptr) {
    person_ = all.empty() ? EntityId() : all.front();
  }
  empty_->setVisible(all.empty());
  const PersonTree tree = human() == nullptr ? PersonTree() : personTree(document_, person_);
  canvas_->showTree(tree);
  history_->showPerson(human() == nullptr ? 0 : human()->id);
  const std::string xml = human() == nullptr ? std::string() : treeText(document_, person_);
  text_->showText(xml);
  lines_.assign(canvas_->graph().nodes().size(), 0);
  if (const base::Result<bt::TreeFile> file = bt::readTreeText(xml)) {
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const bt::NodeSpec* node = nodeAt(*file, canvas_->graph().locationOf(static_cast<int>(k)));
      lines_[k] = node == nullptr ? 0 : node->line;
    }
  }
  showChosen();
  QStringList ids;
  for (const auto& [id, entry] : tree.table.entries) {
    if (id != tree.table.mainTree) {
      ids << QString::fromStdString(id);
    }
  }
  palette_->showTrees(ids);
  listPeople();
  showSharing();
  showStatuses();
  showBreakpoints();
  placeInset();
  showProblems(tree.problems);
  updateLayoutButtons();
  entries_->showPerson(human() == nullptr ? std::nullopt : std::optional<int>(human()->id));
}

void TreeEditor::showProblems(const base::Diagnostics& problems) {
  problem_->setVisible(!problems.empty());
  if (!problems.empty()) {
    const std::size_t more = problems.size() - 1;
    problem_->setText(QStringLiteral("⚠ ") + QString::fromStdString(problems.front().message) +
                      (more > 0 ? tr(" (and %1 more)").arg(more) : QString()));
  }
}

void TreeEditor::listPeople() {
  people_->clear();
  const FigurePainter painter(context_.theme());
  for (const EntityId id : document_.entities(EntityKind::Human)) {
    const sim2d::Human& each = *document_.human(id);
    const Look look = document_.tree(id)
                          ? Look::CustomTree
                          : lookOf(each.behavior.type.value_or(sim2d::BehaviorType::Regular));
    people_->addItem(painter.markIcon(look), QString::fromStdString(each.name), id.key);
  }
  people_->setCurrentIndex(people_->findData(person_.key));
}

std::vector<EntityId> TreeEditor::edited() const {
  return sharing_->isChecked() ? peopleWithTreeOf(document_, person_)
                               : std::vector<EntityId>{person_};
}

void TreeEditor::showSharing() {
  const std::size_t count = human() == nullptr ? 0 : peopleWithTreeOf(document_, person_).size();
  sharing_->setVisible(count > 1);
  sharing_->setText(sharing_->isChecked() ? tr("Edits change %1 people").arg(count)
                                          : tr("Edits change only this person"));
  sharing_->setAccessibleName(sharing_->text());
}

void TreeEditor::showStatuses() {
  const FramePtr frame = runner_.shownFrame();
  if (frame == nullptr || human() == nullptr || runner_.recording() == nullptr) {
    canvas_->showStatuses({});
  } else if (isVisible()) {
    canvas_->showStatuses(statusesByNode(runner_.recording()->treeAt(human()->id, frame->step),
                                         canvas_->graph().names()));
  }
}

void TreeEditor::showBreakpoints() {
  std::vector<sim2d::TreeBreakpoint> own;
  if (human() != nullptr) {
    const auto& all = runner_.breakpoints();
    std::copy_if(all.begin(), all.end(), std::back_inserter(own), [this](const auto& each) {
      return each.person.value_or(human()->id) == human()->id;
    });
  }
  canvas_->showBreakpoints(std::move(own));
}

void TreeEditor::choose(int node) {
  if (choosing_ || (stale_ && !isVisible()) || node == canvas_->chosen()) {
    return;
  }
  choosing_ = true;
  canvas_->choose(node);
  showChosen();
  Q_EMIT nodeChosen(canvas_->chosen());
  choosing_ = false;
}

void TreeEditor::showChosen() {
  history_->choose(canvas_->chosen());
  text_->showLine(lineOf(canvas_->chosen()));
}

int TreeEditor::lineOf(int node) const {
  const auto place = static_cast<std::size_t>(node);
  return node >= 0 && place < lines_.size() ? lines_[place] : 0;
}

int TreeEditor::nodeAtLine(int line) const {
  int best = -1;
  for (int node = 0; node < static_cast<int>(lines_.size()); ++node) {
    const bool isAbove = lineOf(node) > 0 && lineOf(node) <= line;
    if (isAbove && (best < 0 || lineOf(node) > lineOf(best))) {
      best = node;
    }
  }
  return best;
}

void TreeEditor::applyText(const std::string& xml) {
  std::vector<TreeEdit> edits;
  for (const EntityId each : edited()) {
    edits.push_back({each, xml});
  }
  if (human() != nullptr) {
    pushTrees(document_, std::move(edits),
              tr("Edit the XML of %1").arg(QString::fromStdString(human()->name)));
  }
}

void TreeEditor::showHint(const QString& text) {
  hint_->setText(text);
  hint_->setToolTip(text);
  hintTimer_.start(kHintMs);
}

QString TreeEditor::label(int node) const {
  const TreeGraph& graph = canvas_->graph();
  return graph.has(node) ? nodeTitle(*graph.node(node).node) : QString();
}

/// Unfolds a subtree; blocks and nodes are edited in the form beside the graph.
void TreeEditor::openNode(int node) {
  TreeGraph& graph = canvas_->graph();
  if (!graph.childrenOf(node).empty() && graph.node(node).node->isSubTree()) {
    graph.setFolded(node, !graph.isFolded(node));
    canvas_->relayout();
    showChosen();
    return;
  }
  beginRename();
}

void TreeEditor::handleKey(int key, Qt::KeyboardModifiers modifiers) {
  const bool isAlt = (modifiers & Qt::AltModifier) != 0;
  const bool isCtrl = (modifiers & Qt::ControlModifier) != 0;
  const bool isShift = (modifiers & Qt::ShiftModifier) != 0;
  const std::pair<bool, void (TreeEditor::*)()> commands[] = {
      {isCtrl && key == Qt::Key_D, &TreeEditor::duplicate},
      {(isCtrl && key == Qt::Key_X) || (isShift && key == Qt::Key_Delete), &TreeEditor::cut},
      {isCtrl && (key == Qt::Key_C || key == Qt::Key_Insert), &TreeEditor::copy},
      {(isCtrl && key == Qt::Key_V) || (isShift && key == Qt::Key_Insert), &TreeEditor::paste},
      {key == Qt::Key_Delete || key == Qt::Key_Backspace, &TreeEditor::remove},
      {key == Qt::Key_F2, &TreeEditor::beginRename}};
  for (const auto& [isMeant, command] : commands) {
    if (isMeant) {
      (this->*command)();
      return;
    }
  }
  if (key == Qt::Key_Insert) {
    palette_->search().setFocus();
  } else if (isAlt) {
    moveBy(key == Qt::Key_Left || key == Qt::Key_Up ? -1 : 1);
  } else if (canvas_->chosen() >= 0) {  // Enter.
    openNode(canvas_->chosen());
  }
}

bool TreeEditor::eventFilter(QObject* watched, QEvent* event) {
  const bool isPlace = event->type() == QEvent::Resize || event->type() == QEvent::Show ||
                       event->type() == QEvent::Hide;
  if (isPlace && (watched == canvas_ || watched == &context_.view)) {
    placeInset();
  }
  if (watched != nameField_ || nameField_->isHidden()) {
    return QWidget::eventFilter(watched, event);
  }
  if (event->type() == QEvent::FocusOut) {
    endRename(true);
  } else if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<const QKeyEvent&>(*event).key();
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (isEnter || key == Qt::Key_Escape) {
      endRename(isEnter);
      canvas_->setFocus();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

// Menus; their edits: TreeEditorEdits.cpp.

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

/// Adds separate submenus of node kinds, either with or without children.
void TreeEditor::addKinds(QMenu& menu, const QString& title, bool areParents,
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
  const bool isCustom = selectedLocations().has_value();
  addKinds(menu, tr("Wrap in"), true, [this](const std::string& id) { wrapIn(id); });
  menu.actions().back()->setEnabled(isCustom);
  menu.addSeparator();
  const std::tuple<QString, bool, void (TreeEditor::*)()> entries[] = {
      {tr("Duplicate\tCtrl+D"), isCustom, &TreeEditor::duplicate},
      {tr("Cut\tCtrl+X"), isCustom, &TreeEditor::cut},
      {tr("Copy as XML\tCtrl+C"), true, &TreeEditor::copy},
      {tr("Delete\tDel"), isCustom, &TreeEditor::remove}};
  for (const auto& [text, isOn, action] : entries) {
    menu.addAction(text, this, action)->setEnabled(isOn);
  }
}

void TreeEditor::fillMenu(QMenu& menu, int node) {
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
    fillMultiSelectionMenu(menu);
    return;
  }
  const bt::NodeSpec& spec = *graph.node(node).node;
  const bool isCustom = graph.isEditable(node);
  const bool isInner = isCustom && !graph.locationOf(node).isRoot();
  add(tr("Add a node…"), tr("Ins"), isCustom, [this] { palette_->search().setFocus(); });
  addPicks(menu, spec);
  if (isCustom) {
    addKinds(menu, tr("Wrap in"), true, [this](const std::string& id) { wrapIn(id); });
    addKinds(menu, tr("Replace with"), false, [this](const std::string& id) { replaceBy(id); });
  }
  add(tr("Remove, keep children"), {}, isCustom && !spec.children.empty(), [this] { unwrap(); });
  if (spec.isSubTree()) {
    add(tr("Inline subtree"), {}, isCustom, [this] { inlineSubtree(); });
  } else {
    add(tr("Extract as subtree"), {}, isInner, [this] { extract(); });
  }
  menu.addSeparator();
  add(tr("Rename"), tr("F2"), isCustom, [this] { beginRename(); });
  add(tr("Earlier"), tr("Alt+Left"), isInner, [this] { moveBy(-1); });
  add(tr("Later"), tr("Alt+Right"), isInner, [this] { moveBy(1); });
  add(tr("Duplicate"), tr("Ctrl+D"), isInner, [this] { duplicate(); });
  add(tr("Cut"), tr("Ctrl+X"), isInner, [this] { cut(); });
  add(tr("Copy as XML"), tr("Ctrl+C"), true, [this] { copy(); });
  add(tr("Paste"), tr("Ctrl+V"), isCustom, [this] { paste(); });
  add(tr("Delete"), tr("Del"), isInner, [this] { remove(); });
  if (!graph.childrenOf(node).empty()) {
    const bool isFolded = graph.isFolded(node);
    add(isFolded ? tr("Expand") : tr("Collapse"), isFolded ? tr("+") : tr("-"), true,
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
