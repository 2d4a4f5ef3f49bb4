#include "editor/panels/behavior/BehaviorPanel.h"

#include <iterator>

#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Form.h"
#include "editor/look/TableExport.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

// Initial heights of outline and form [px of 640].
constexpr int kOutlineShare = 380;
constexpr int kFormShare = 260;
constexpr int kHintHeight = 72;

QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets) {
  auto* row = configuredLayout(new QHBoxLayout, {8, 0, 12, 0}, 8, widgets);
  row->addStretch();
  return row;
}

}  // namespace

BehaviorPanel::BehaviorPanel(ScenarioDocument& document, SimulationRunner& runner,
                             const Theme& theme, std::function<QString()> folder)
    : document_(document),
      theme_(theme),
      runner_(runner),
      folder_(std::move(folder)),
      outline_(new TreeOutline(theme)) {
  setMinimumWidth(300);
  stack_->addWidget(empty_);
  stack_->addWidget(makePage());
  connect(outline_, &QTreeWidget::currentItemChanged, this, &BehaviorPanel::showNode);
  connect(outline_, &TreeOutline::removeRequested, this, [this] { moveBlock(0); });
  connect(blockForm_, &ValueForm::edited, this, &BehaviorPanel::editBlock);
  connect(portForm_, &ValueForm::edited, this,
          [this](const std::string& port, const QString& text) {
            const OutlineNode* node = outline_->current();
            if (node != nullptr && hasPerson()) {
              pushPort(document_, person_, *node, port, text.toStdString());
            }
          });
  outline_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(outline_, &QWidget::customContextMenuRequested, this, &BehaviorPanel::offerBreakpoints);
  connect(&runner, &SimulationRunner::breakpointsChanged, this, &BehaviorPanel::showBreakpoints);
  connect(&runner, &SimulationRunner::entriesChanged, this, &BehaviorPanel::showEntries);
  connect(&runner, &SimulationRunner::lookingBackChanged, this, &BehaviorPanel::showEntries);
  connect(&runner, &SimulationRunner::frameShown, this, [this] {
    showStatus();
    if (runner_.isLookingBack()) {
      showEntries();
    }
  });
  connect(&document_, &ScenarioDocument::selectionChanged, this, &BehaviorPanel::follow);
  connect(&document_, &ScenarioDocument::stepFinished, this,
          [this] { isVisible() ? rebuild() : (void)(stale_ = true); });
  setTheme(theme);
  follow();
}

QWidget* BehaviorPanel::makePage() {
  auto* page = new QWidget(this);
  auto* layout =
      configuredLayout(new QVBoxLayout(page), {0, 12, 0, 0}, 4, {name_, about_, problem_});
  for (QLabel* label : {name_, about_, problem_}) {
    label->setContentsMargins(12, 0, 12, 0);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(label != name_);
  }
  makeLinks(*layout);
  hint_->setMinimumHeight(kHintHeight);
  auto* below = new QWidget;
  entriesTitle_->setContentsMargins(12, 12, 12, 4);
  styleTable(*entries_, tr("Blackboard"));
  makeTableSavable(*entries_, tr("Blackboard"));
  entries_->horizontalHeader()->hide();
  entries_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  entries_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  configuredLayout(new QVBoxLayout(below), {}, 0,
                   {blockLinks_, blockForm_, portForm_, hint_, entriesTitle_, entries_})
      ->addStretch(1);
  auto* splitter = new QSplitter(Qt::Vertical, page);
  splitter->addWidget(new WholeRows(*outline_, splitter));
  splitter->addWidget(scrollArea(below, splitter));
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  splitter->setChildrenCollapsible(false);
  splitter->setSizes({kOutlineShare, kFormShare});
  layout->addWidget(dividerLine(page));
  layout->addWidget(splitter, 1);
  return page;
}

void BehaviorPanel::makeLinks(QVBoxLayout& layout) {
  const auto link = [this](const QString& text, const QString& says, const auto& action) {
    QToolButton* button = linkButton(text, says, this, [this, action] {
      if (hasPerson()) {
        action();
      }
    });
    button->setAccessibleName(says);
    return button;
  };
  add_ = link(tr("+ Block…"), tr("Add a behaviour block"), [this] {
    auto* dialog = new BlockDialog(document_, theme_, window());
    deleteWhenClosed(*dialog);
    dialog->open();
  });
  QToolButton* open =
      link(tr("Open…"), tr("Load a tree from a file"), [this] { chooseTreeToLoad(); });
  QToolButton* save =
      link(tr("Save…"), tr("Save the tree to a file"), [this] { chooseFileToSave(); });
  template_ =
      link(tr("Template…"), tr("Start from the tree of a behaviour"), [this] { offerTemplates(); });
  regenerate_ = link(tr("Regenerate"), tr("Generate the tree from behaviour and goals"),
                     [this] { pushRegeneratedTrees(document_, {person_}); });
  takeRoute_ = link(tr("Copy route to tree"), tr("Copy route to tree"),
                    [this] { pushGoalsOfRoute(document_, person_); });
  earlier_ = link(tr("Earlier"), tr("Move before the block above"), [this] { moveBlock(-1); });
  later_ = link(tr("Later"), tr("Move after the block below"), [this] { moveBlock(1); });
  QToolButton* remove = link(tr("Remove"), tr("Remove the block"), [this] { moveBlock(0); });
  layout.addLayout(rowOf({add_, template_, regenerate_}));
  layout.addLayout(rowOf({open, save, takeRoute_}));
  blockLinks_->setLayout(rowOf({earlier_, later_, remove}));
}

void BehaviorPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  outline_->setTheme(theme);
  colorProblem();
  showEntries();
}

void BehaviorPanel::follow() {
  const EntityId before =
      std::exchange(person_, document_.human(otherPerson_) == nullptr ? EntityId() : otherPerson_);
  for (const EntityId id : document_.selection()) {
    person_ = id.kind == EntityKind::Human ? id : person_;
  }
  if (person_ != before) {
    menu_.close();  // The menu belongs to the previous person.
  }
  const sim2d::Human* human = document_.human(person_);
  if (human != nullptr && runner_.watched() != human->id) {  // Kept for the tree dock.
    runner_.watchBlackboard(human->id);
  }
  rebuild();
  showEntries();
}

void BehaviorPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) {
    rebuild();
  }
  showStatus();
}

void BehaviorPanel::rebuild() {
  stale_ = false;
  const sim2d::Human* human = document_.human(person_);
  empty_->setText(document_.scenario().humans.empty()
                      ? tr("No people yet: press P and click on the map.")
                      : tr("Select a person to see the behaviour tree."));
  stack_->setCurrentIndex(human == nullptr ? 0 : 1);
  if (human == nullptr) {
    return;
  }
  tree_ = personTree(document_, person_);
  blocks_ =
      tree_.mainTree() == nullptr ? std::vector<bt::Block>() : bt::blocksOf(*tree_.mainTree());
  outline_->showTree(tree_);
  showSummary();
  showNode();
  showStatus();
  showBreakpoints();
}

void BehaviorPanel::showSummary() {
  const sim2d::Human& human = *document_.human(person_);
  const QString behavior =
      lookName(lookOf(human.behavior.type.value_or(sim2d::BehaviorType::Regular)));
  name_->setText(QString::fromStdString(human.name));
  about_->setText(
      !tree_.isCustom ? tr("%1 · generated from behaviour and goals").arg(behavior)
      : tree_.isGeneratedWithBlocks
          ? tr("%1 · with %2").arg(behavior, counted(blocks_.size(), tr("block"), tr("blocks")))
          : tr("Custom tree; not affected by changes to the behaviour"));
  regenerate_->setEnabled(tree_.isCustom);
  add_->setEnabled(tree_.mainTree() != nullptr && tree_.mainTree()->root.id == "Fallback");
  takeRoute_->setVisible(tree_.hasDifferentGoals);
  problem_->setVisible(!tree_.problems.empty());
  problem_->setText(problemSummary(tree_.problems));
  colorProblem();
}

void BehaviorPanel::colorProblem() {
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText,
                  theme_.color(base::hasErrors(tree_.problems) ? Role::Error : Role::Warning));
  problem_->setPalette(colors);
}

void BehaviorPanel::showPersonOf(EntityId person) {
  if (std::exchange(otherPerson_, person) != person) {
    follow();
  }
}

int BehaviorPanel::currentBlock() const {
  const OutlineNode* chosen = outline_->current();
  if (chosen == nullptr || tree_.mainTree() == nullptr || chosen->tree != tree_.mainTree()->id ||
      chosen->path.size() != 1 || !bt::readBlock(*chosen->node)) {
    return -1;
  }
  const std::vector<bt::NodeSpec>& children = tree_.mainTree()->root.children;
  return static_cast<int>(
      std::count_if(children.begin(), children.begin() + chosen->path.front(),
                    [](const bt::NodeSpec& each) { return bt::readBlock(each).has_value(); }));
}

void BehaviorPanel::showNode() {
  const OutlineNode* node = outline_->current();
  const int block = currentBlock();
  blockLinks_->setVisible(block >= 0);
  blockForm_->setVisible(block >= 0);
  portForm_->setVisible(node != nullptr && block < 0);
  hint_->setVisible(node == nullptr);
  if (block >= 0) {
    blockForm_->show(blockRows(blocks_[static_cast<std::size_t>(block)], document_));
    earlier_->setEnabled(block > 0);
    later_->setEnabled(block + 1 < static_cast<int>(blocks_.size()));
  } else if (node != nullptr) {
    portForm_->show(portRows(*node->node, node->isEditable));
  }
}

void BehaviorPanel::editBlock(const std::string& key, const QString& text) {
  const int place = currentBlock();
  if (place >= 0 && hasPerson()) {
    std::vector<bt::Block> blocks = blocks_;  // A copy: the edit reads them again.
    bt::Block& block = blocks[static_cast<std::size_t>(place)];
    setValue(block, key, text);
    blockForm_->show(blockRows(block, document_));
    pushBlocks(document_, person_, blocks);
  }
}

void BehaviorPanel::moveBlock(int by) {
  const int place = currentBlock();
  if (place < 0 || !hasPerson()) {
    return;
  }
  std::vector<bt::Block> blocks = blocks_;
  const int to = place + by;
  if (by == 0) {
    blocks.erase(blocks.begin() + place);
  } else if (to >= 0 && to < static_cast<int>(blocks.size())) {
    std::swap(blocks[static_cast<std::size_t>(place)], blocks[static_cast<std::size_t>(to)]);
  }
  const OutlineNode chosen = *outline_->current();
  pushBlocks(document_, person_, blocks);
  for (std::size_t i = 0; i < outline_->nodes().size(); ++i) {
    const OutlineNode& node = outline_->nodes()[i];
    if (node.tree == chosen.tree && node.path.size() == 1 &&
        node.path.front() == chosen.path.front() + by) {
      outline_->selectNode(static_cast<int>(i));
    }
  }
}

void BehaviorPanel::showStatus() {
  const sim2d::Human* human = document_.human(person_);
  const FramePtr frame = runner_.shownFrame();
  if (frame == nullptr || human == nullptr || runner_.recording() == nullptr) {
    outline_->showStatus({});
  } else if (isVisible()) {
    outline_->showStatus(runner_.recording()->treeAt(human->id, frame->step));
  }
}

void BehaviorPanel::offerBreakpoints(const QPoint& at) {
  const sim2d::Human* human = document_.human(person_);
  const std::string path = outline_->nameOf(outline_->nodeAt(at));
  if (human == nullptr || path.empty()) {
    return;
  }
  QMenu& menu = menu_.begin(*this);
  fillBreakpointMenu(menu, runner_, path, human->id, *this);
  menu.popup(outline_->viewport()->mapToGlobal(at));
}

void BehaviorPanel::showBreakpoints() {
  const sim2d::Human* human = document_.human(person_);
  std::vector<sim2d::TreeBreakpoint> own;
  if (human != nullptr) {
    const auto& all = runner_.breakpoints();
    std::copy_if(all.begin(), all.end(), std::back_inserter(own), [human](const auto& each) {
      return each.person.value_or(human->id) == human->id;
    });
  }
  outline_->showBreakpoints(own);
}

/// Shows the blackboard of the shown state, if it is known.
void BehaviorPanel::showEntries() {
  const app::BlackboardEntries* entries = runner_.shownEntries();
  const bool isShown = entries != nullptr && !entries->empty();
  entriesTitle_->setVisible(isShown);
  entries_->setVisible(isShown);
  if (!isShown) {
    return;
  }
  entries_->setRowCount(static_cast<int>(entries->size()));
  int row = 0;
  for (const auto& [key, value] : *entries) {
    const QString words[] = {QString::fromStdString(key), QString::fromStdString(value)};
    for (int column = 0; column < 2; ++column) {
      if (entries_->item(row, column) == nullptr) {
        entries_->setItem(row, column, new QTableWidgetItem);
      }
      entries_->item(row, column)->setText(words[column]);
      entries_->item(row, column)->setToolTip(words[column]);
    }
    entries_->item(row, 0)->setForeground(theme_.color(Role::TextSecondary));
    ++row;
  }
  entries_->setFixedHeight(entries_->verticalHeader()->length() + 2);
}

void addBehaviorPanel(PanelRegistry& to) {
  to.add({40, QObject::tr("Behaviour"), Qt::RightDockWidgetArea}, [](PanelContext& context) {
    auto* panel = new BehaviorPanel(context.document, context.runner, context.theme(),
                                    [&context] { return context.folder(); });
    QObject::connect(&context, &PanelContext::themeChanged, panel, &BehaviorPanel::setTheme);
    QObject::connect(panel, &BehaviorPanel::problemsReported, &context,
                     &PanelContext::problemsFound);
    QObject::connect(&context, &PanelContext::treeShown, panel, &BehaviorPanel::showPersonOf);
    TreeOutline& outline = panel->outline();
    QObject::connect(
        &outline, &QTreeWidget::currentItemChanged, &context,
        [&context, &outline, panel] { Q_EMIT context.nodeChosen(outline.currentNode(), panel); });
    QObject::connect(&context, &PanelContext::nodeChosen, panel,
                     [&outline, panel](int node, const QObject* by) {
                       if (by != panel) {
                         outline.selectNode(node);
                       }
                     });
    return panel;
  });
}

base::Diagnostics BehaviorPanel::loadTreeFrom(const QString& path, EntityId person) {
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  if (!text) {
    return text.diagnostics();
  }
  const base::Result<bt::TreeFile> file = bt::readTreeText(*text, path.toStdString());
  if (file) {
    pushTreeText(document_, person, *text, tr("Load tree %1").arg(QFileInfo(path).fileName()));
  }
  return file.diagnostics();
}

base::Diagnostics BehaviorPanel::saveTreeTo(const QString& path, EntityId person) const {
  base::Diagnostics problems =
      base::writeFileAtomically(path.toStdString(), treeText(document_, person));
  if (auto included = missingIncludedTree(QFileInfo(path).absolutePath().toStdString())) {
    base::append(problems, base::writeFilesAtomically({*std::move(included)}));
  }
  return problems;
}

/// The person is stored because a running simulation may select another one while the dialog is
/// open.
void BehaviorPanel::chooseTreeToLoad() {
  const EntityId person = person_;
  const QString path = QFileDialog::getOpenFileName(
      window(), tr("Load a behaviour tree"), folder_(),
      tr("Behaviour trees (*.xml);;All files (*)"), nullptr, QFileDialog::ReadOnly);
  if (!path.isEmpty() && document_.human(person) != nullptr) {
    Q_EMIT problemsReported(loadTreeFrom(path, person));
  }
}

void BehaviorPanel::chooseFileToSave() {
  const EntityId person = person_;
  const sim2d::Human* human = document_.human(person);
  const QString name = QString::fromStdString(
      bt::treeFileName(document_.scenario().yamlBaseName.value_or("scenario"), human->id));
  QFileDialog dialog(window(), tr("Save the behaviour tree"), folder_(),
                     tr("Behaviour trees (*.xml)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("xml"));
  dialog.selectFile(name);
  const QString path = chosenFiles(dialog, true).value(0);
  if (!path.isEmpty() && document_.human(person) != nullptr) {
    Q_EMIT problemsReported(saveTreeTo(path, person));
  }
}

void BehaviorPanel::applyTemplate(sim2d::BehaviorType type) {
  const QString text = tr("Use the tree of %1").arg(lookName(lookOf(type)));
  document_.undoStack().beginMacro(text);
  pushTreeText(document_, person_, std::nullopt, text);
  pushChange<sim2d::Human>(document_, person_, text, [this, type](sim2d::Human& human) {
    human.behavior.type = type;
    addMissingReactionKeys(document_.scenario(), human);
  });
  document_.undoStack().endMacro();
}

void BehaviorPanel::offerTemplates() {
  QMenu& menu = menu_.begin(*this);
  const FigurePainter painter(theme_);
  for (int i = 1; i <= 6; ++i) {
    const auto type = static_cast<sim2d::BehaviorType>(i);
    menu.addAction(painter.markIcon(lookOf(type)), lookName(lookOf(type)), this,
                   [this, type] { applyTemplate(type); });
  }
  menu.popup(template_->mapToGlobal(QPoint(0, template_->height())));
}

}  // namespace editor
