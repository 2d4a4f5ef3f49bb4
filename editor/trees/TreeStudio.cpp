// What the studio shows and how it listens; of what it is made: StudioParts.cpp.
#include "editor/trees/TreeStudio.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QKeyEvent>

#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/document/TreeFiles.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/TreeOutline.h"

namespace editor {

namespace {

constexpr int kHintMs = 6000;

}  // namespace

void TreeStudio::setTheme(const Theme& theme) {
  canvas_->setTheme(theme);
  palette_->setTheme(theme);
  history_->setTheme(theme);
  text_->setTheme(theme);
  entries_->setTheme(theme);
  QPalette colors = QWidget::palette();
  colors.setColor(QPalette::WindowText, theme.color(Role::Warning));
  problem_->setPalette(colors);
  if (isVisible()) {
    listPeople();  // their marks
  }
}

void TreeStudio::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) {
    rebuild();
  }
  showStatuses();
}

/// The person who was selected last stays while goals or nothing are selected.
void TreeStudio::follow() {
  if (isPicking() && takePicked()) {
    return;
  }
  EntityId wanted = human() == nullptr ? EntityId() : person_;
  for (const EntityId id : document_.selection()) {
    wanted = id.kind == EntityKind::Human ? id : wanted;
  }
  if (wanted != person_ || !wanted) {
    text_->finishTyping();  // it is for the previous person
    person_ = wanted;
    stale_ = true;
    canvas_->choose(-1);
  }
  if (stale_ && isVisible()) {
    rebuild();
  }
}

void TreeStudio::rebuild() {
  stale_ = false;
  menu_.close();  // it is about the previous tree or person
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
      const bt::NodeSpec* node = nodeAt(*file, canvas_->graph().placeOf(static_cast<int>(k)));
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
  showPlacing();
  entries_->showPerson(human() == nullptr ? std::nullopt : std::optional<int>(human()->id));
}

void TreeStudio::showProblems(const base::Diagnostics& problems) {
  problem_->setVisible(!problems.empty());
  if (!problems.empty()) {
    const std::size_t more = problems.size() - 1;
    problem_->setText(QStringLiteral("⚠ ") + QString::fromStdString(problems.front().message) +
                      (more > 0 ? tr(" (and %1 more)").arg(more) : QString()));
  }
}

void TreeStudio::listPeople() {
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

std::vector<EntityId> TreeStudio::edited() const {
  return sharing_->isChecked() ? peopleWithTreeOf(document_, person_)
                               : std::vector<EntityId>{person_};
}

void TreeStudio::showSharing() {
  const std::size_t count = human() == nullptr ? 0 : peopleWithTreeOf(document_, person_).size();
  sharing_->setVisible(count > 1);
  sharing_->setText(sharing_->isChecked() ? tr("Edits change %1 people").arg(count)
                                          : tr("Edits change this person alone"));
  sharing_->setAccessibleName(sharing_->text());
}

void TreeStudio::showStatuses() {
  const FramePtr frame = runner_.shownFrame();
  if (frame == nullptr || human() == nullptr || runner_.recording() == nullptr) {
    canvas_->showStatuses({});
  } else if (isVisible()) {
    canvas_->showStatuses(statusesByNode(runner_.recording()->treeAt(human()->id, frame->step),
                                         canvas_->graph().names()));
  }
}

void TreeStudio::showBreakpoints() {
  std::vector<sim2d::TreeBreakpoint> own;
  if (human() != nullptr) {
    const auto& all = runner_.breakpoints();
    std::copy_if(all.begin(), all.end(), std::back_inserter(own), [this](const auto& each) {
      return each.person.value_or(human()->id) == human()->id;
    });
  }
  canvas_->showBreakpoints(std::move(own));
}

void TreeStudio::choose(int node) {
  if (choosing_ || (stale_ && !isVisible()) || node == canvas_->chosen()) {
    return;
  }
  choosing_ = true;
  canvas_->choose(node);
  showChosen();
  Q_EMIT nodeChosen(canvas_->chosen());
  choosing_ = false;
}

void TreeStudio::showChosen() {
  history_->choose(canvas_->chosen());
  text_->showLine(lineOf(canvas_->chosen()));
}

int TreeStudio::lineOf(int node) const {
  const auto place = static_cast<std::size_t>(node);
  return node >= 0 && place < lines_.size() ? lines_[place] : 0;
}

int TreeStudio::nodeAtLine(int line) const {
  int best = -1;
  for (int node = 0; node < static_cast<int>(lines_.size()); ++node) {
    const bool isAbove = lineOf(node) > 0 && lineOf(node) <= line;
    if (isAbove && (best < 0 || lineOf(node) > lineOf(best))) {
      best = node;
    }
  }
  return best;
}

void TreeStudio::takeText(const std::string& xml) {
  std::vector<TreeEdit> edits;
  for (const EntityId each : edited()) {
    edits.push_back({each, xml});
  }
  if (human() != nullptr) {
    pushTrees(document_, std::move(edits),
              tr("Edit the XML of %1").arg(QString::fromStdString(human()->name)));
  }
}

void TreeStudio::say(const QString& text) {
  hint_->setText(text);
  hint_->setToolTip(text);
  hintTimer_.start(kHintMs);
}

QString TreeStudio::label(int node) const {
  return nodeTitle(*canvas_->graph().node(node).node);
}

/// A subtree opens in place; a block or node is edited in the form beside.
void TreeStudio::openNode(int node) {
  TreeGraph& graph = canvas_->graph();
  if (!graph.childrenOf(node).empty() && graph.node(node).node->isSubTree()) {
    graph.setFolded(node, !graph.isFolded(node));
    canvas_->relayout();
    showChosen();
    return;
  }
  beginRename();
}

void TreeStudio::doKey(int key, Qt::KeyboardModifiers modifiers) {
  const bool isAlt = (modifiers & Qt::AltModifier) != 0;
  const bool isCtrl = (modifiers & Qt::ControlModifier) != 0;
  const bool isShift = (modifiers & Qt::ShiftModifier) != 0;
  const std::pair<bool, void (TreeStudio::*)()> commands[] = {
      {isCtrl && key == Qt::Key_D, &TreeStudio::duplicate},
      {(isCtrl && key == Qt::Key_X) || (isShift && key == Qt::Key_Delete), &TreeStudio::cut},
      {isCtrl && (key == Qt::Key_C || key == Qt::Key_Insert), &TreeStudio::copy},
      {(isCtrl && key == Qt::Key_V) || (isShift && key == Qt::Key_Insert), &TreeStudio::paste},
      {key == Qt::Key_Delete || key == Qt::Key_Backspace, &TreeStudio::remove},
      {key == Qt::Key_F2, &TreeStudio::beginRename}};
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
  } else if (canvas_->chosen() >= 0) {  // Enter
    openNode(canvas_->chosen());
  }
}

bool TreeStudio::eventFilter(QObject* watched, QEvent* event) {
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
