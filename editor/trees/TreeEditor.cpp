#include "editor/trees/TreeEditor.h"

// Display and signals of the TreeEditor; its widgets: TreeDock.cpp.

#include <algorithm>
#include <iterator>

#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/PersonTree.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/behavior/TreeOutline.h"
#include "sim2d/base/Text.h"

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
  fields_->setTheme(theme);
  running_->setTheme(theme);
  colorProblem(theme);
  listPeople();  // Updates their marks.
}

void TreeEditor::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) {
    rebuild();
  }
  showStatuses();
  Q_EMIT personShown(person_);
}

void TreeEditor::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  fields_->close(true);
  Q_EMIT personShown({});
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
    fields_->close(true);  // The values and the text are for the previous person.
    text_->commitPendingEdit();
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
  fields_->close(false);
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
  if (isVisible()) {
    Q_EMIT personShown(person_);
  }
}

void TreeEditor::showProblems(const base::Diagnostics& problems, const QString& title) {
  isErrorShown_ = base::hasErrors(problems);
  problem_->setText(QStringLiteral("⚠ ") + title + problemSummary(problems));
  problem_->setVisible(!problems.empty());
  placeProblem();
  colorProblem(context_.theme());
}

void TreeEditor::colorProblem(const Theme& theme) {
  QPalette colors = QWidget::palette();
  colors.setColor(QPalette::WindowText, theme.color(isErrorShown_ ? Role::Error : Role::Warning));
  problem_->setPalette(colors);
}

QString refusedRunText(const base::Diagnostics& problems) {
  const auto errors = std::count_if(problems.begin(), problems.end(), [](const auto& each) {
    return each.severity == base::Severity::Error;
  });
  return QObject::tr("Cannot run: %1")
      .arg(counted(static_cast<std::size_t>(errors), QObject::tr("error"), QObject::tr("errors")));
}

bool TreeEditor::showRefusedRun(const base::Diagnostics& problems) {
  const auto isOfTree = [this](const base::Diagnostic& each) {
    return each.severity == base::Severity::Error && document_.human(each.entity) != nullptr &&
           base::startsWith(each.code, "tree.");
  };
  const auto first = std::find_if(problems.begin(), problems.end(), isOfTree);
  if (first != problems.end()) {
    showIssue(*first);
  }
  base::Diagnostics errors;
  std::copy_if(problems.begin(), problems.end(), std::back_inserter(errors),
               [](const auto& each) { return each.severity == base::Severity::Error; });
  showProblems(errors, refusedRunText(errors) + QStringLiteral(" · "));
  return first != problems.end();
}

void TreeEditor::showIssue(const base::Diagnostic& issue) {
  if (!isVisible()) {
    return;
  }
  if (issue.entity != person_) {
    document_.setSelection({issue.entity});
  }
  const int node = faultyNode(issue);
  canvas_->choose(-1);  // Also if the node is already chosen: it may be out of view.
  choose(node);
}

/// The node with that message, else the first with an error, else the one at that line of the file.
int TreeEditor::faultyNode(const base::Diagnostic& issue) const {
  const TreeGraph& graph = canvas_->graph();
  const QString text = treeProblemText(issue, true);
  int first = -1;
  for (int node = 0; graph.has(node); ++node) {
    for (const TreeGraph::Problem& problem : graph.problemsOf(node)) {
      const bool isSame = problem.text == text && (issue.line == 0 || issue.line == lineOf(node));
      if (isSame) {
        return node;
      }
      first = first < 0 && problem.severity == base::Severity::Error ? node : first;
    }
  }
  return first < 0 || issue.severity != base::Severity::Error ? nodeAtLine(issue.line) : first;
}

void TreeEditor::listPeople() {
  people_->clear();
  const FigurePainter painter(context_.theme());
  for (const EntityId id : document_.entities(EntityKind::Human)) {
    const sim2d::Human& each = *document_.human(id);
    people_->addItem(painter.markIcon(lookOfPerson(document_, each)),
                     QString::fromStdString(each.name), id.key);
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
    running_->show({}, -1);
  } else if (isVisible()) {
    canvas_->showStatuses(statusesByNode(runner_.recording()->treeAt(human()->id, frame->step),
                                         canvas_->graph().names()));
    running_->show(canvas_->shown().statuses, frame->step);
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
  fields_->close(true);
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

/// Unfolds a subtree; the name and the ports of other nodes are edited in place.
void TreeEditor::openNode(int node) {
  TreeGraph& graph = canvas_->graph();
  if (!graph.childrenOf(node).empty() && graph.node(node).node->isSubTree()) {
    graph.setFolded(node, !graph.isFolded(node));
    canvas_->relayout();
    showChosen();
    return;
  }
  editFields();
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
    palette_->startSearch();
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

}  // namespace editor
