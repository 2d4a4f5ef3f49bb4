#include "editor/panels/BehaviorPanel.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "editor/document/PersonLook.h"
#include "editor/panels/BlockDialog.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/WholeRows.h"

namespace editor {

namespace {

// How outline and form share the height at first [px of 640].
constexpr int kOutlineShare = 380;
constexpr int kFormShare = 260;
constexpr int kRowHeight = 24;
constexpr int kHintHeight = 72;

QWidget* scrolled(QWidget* widget, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(widget);
  area->viewport()->setAutoFillBackground(false);
  widget->setAutoFillBackground(false);
  return area;
}

QToolButton* link(const QString& text, const QString& says, QWidget* parent) {
  QToolButton* button = linkButton(text, parent);
  button->setToolTip(says);
  button->setAccessibleName(says);
  return button;
}

QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 0, 12, 0);
  row->setSpacing(8);
  for (QWidget* widget : widgets) {
    row->addWidget(widget);
  }
  row->addStretch();
  return row;
}

QWidget* columnOf(std::initializer_list<QWidget*> widgets) {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (QWidget* widget : widgets) {
    layout->addWidget(widget);
  }
  layout->addStretch(1);
  return column;
}

}  // namespace

BehaviorPanel::BehaviorPanel(ScenarioDocument& document, SimulationRunner& runner,
                             const Theme& theme, QWidget* parent)
    : QWidget(parent),
      document_(document),
      theme_(theme),
      runner_(runner),
      stack_(new QStackedLayout(this)),
      name_(new QLabel),
      about_(secondaryLabel({})),
      problem_(new QLabel),
      outline_(new TreeOutline(theme)),
      blockLinks_(new QWidget),
      blockForm_(new BlockForm(document)),
      portForm_(new PortForm),
      hint_(emptyState(tr("Select a node above to see what it takes."), this)) {
  setMinimumWidth(300);
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 12, 0, 0);
  layout->setSpacing(4);
  name_->setFont(theme.font(12.0, QFont::DemiBold));
  for (QLabel* label : {name_, about_, problem_}) {
    label->setContentsMargins(12, 0, 12, 0);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(label != name_);
    layout->addWidget(label);
  }
  makeLinks(*layout);
  hint_->setMinimumHeight(kHintHeight);
  QWidget* below = columnOf({blockLinks_, blockForm_, portForm_, hint_});
  auto* splitter = new QSplitter(Qt::Vertical, page);
  splitter->addWidget(new WholeRows(*outline_, kRowHeight, splitter));
  splitter->addWidget(scrolled(below, splitter));
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  splitter->setChildrenCollapsible(false);
  splitter->setSizes({kOutlineShare, kFormShare});
  layout->addWidget(dividerLine(page));
  layout->addWidget(splitter, 1);
  stack_->addWidget(emptyState(tr("Select a person to see the behaviour tree."), this));
  stack_->addWidget(page);
  connect(outline_, &QTreeWidget::currentItemChanged, this, &BehaviorPanel::showNode);
  connect(blockForm_, &BlockForm::edited, this, &BehaviorPanel::editBlock);
  connect(portForm_, &PortForm::edited, this, [this](const QString& port, const QString& text) {
    const int node = outline_->currentNode();
    if (node >= 0) {
      pushPort(document_, person_, outline_->nodes()[static_cast<std::size_t>(node)],
               port.toStdString(), text.toStdString());
    }
  });
  connect(&document_, &ScenarioDocument::selectionChanged, this, &BehaviorPanel::follow);
  connect(&document_, &ScenarioDocument::settled, this,
          [this] { isVisible() ? rebuild() : (void)(stale_ = true); });
  setTheme(theme);
  follow();
}

void BehaviorPanel::makeLinks(QVBoxLayout& layout) {
  add_ = link(tr("+ Block…"), tr("Add a block of behaviour"), this);
  open_ = link(tr("Open…"), tr("Take a tree from a file"), this);
  save_ = link(tr("Save…"), tr("Write the tree into a file"), this);
  template_ = link(tr("Template…"), tr("Begin from the tree of a behaviour"), this);
  anew_ = link(tr("Make anew"), tr("Back to the tree that behaviour and goals make"), this);
  takeRoute_ = link(tr("Put the route into the tree"), tr("Put the route into the tree"), this);
  earlier_ = link(tr("Earlier"), tr("Before the block above"), this);
  later_ = link(tr("Later"), tr("Behind the block below"), this);
  remove_ = link(tr("Remove"), tr("Remove the block"), this);
  layout.addLayout(rowOf({add_, template_, anew_}));
  layout.addLayout(rowOf({open_, save_, takeRoute_}));
  blockLinks_->setLayout(rowOf({earlier_, later_, remove_}));
  connect(add_, &QToolButton::clicked, this, [this] {
    auto* dialog = new BlockDialog(document_, theme_, window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
  });
  connect(template_, &QToolButton::clicked, this, &BehaviorPanel::offerTemplates);
  connect(open_, &QToolButton::clicked, this, &BehaviorPanel::askForTree);
  connect(save_, &QToolButton::clicked, this, &BehaviorPanel::askForFile);
  connect(anew_, &QToolButton::clicked, this,
          [this] { pushTreeText(document_, person_, std::nullopt, tr("Make the tree anew")); });
  connect(takeRoute_, &QToolButton::clicked, this,
          [this] { pushGoalsOfRoute(document_, person_); });
  connect(earlier_, &QToolButton::clicked, this, [this] { moveBlock(-1); });
  connect(later_, &QToolButton::clicked, this, [this] { moveBlock(1); });
  connect(remove_, &QToolButton::clicked, this, [this] { moveBlock(0); });
}

void BehaviorPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  outline_->setTheme(theme);
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, theme.color(Role::Warning));
  problem_->setPalette(colors);
}

void BehaviorPanel::follow() {
  EntityId wanted;
  for (const EntityId id : document_.selection()) {
    wanted = id.kind == EntityKind::Human ? id : wanted;
  }
  person_ = wanted;
  rebuild();
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
  stack_->setCurrentIndex(human == nullptr ? 0 : 1);
  if (human == nullptr) {
    return;
  }
  tree_ = personTree(document_, person_);
  outline_->showTree(tree_);
  showWords();
  showNode();
  showStatus();
}

void BehaviorPanel::showWords() {
  const sim2d::Human& human = *document_.human(person_);
  const QString behavior =
      lookName(lookOf(human.behavior.type.value_or(sim2d::BehaviorType::Regular)));
  const std::size_t blocks =
      tree_.mainTree() == nullptr ? 0 : bt::blocksOf(*tree_.mainTree()).size();
  name_->setText(QString::fromStdString(human.name));
  about_->setText(!tree_.isOwn ? tr("%1 · made from behaviour and goals").arg(behavior)
                  : tree_.isMadeWithBlocks
                      ? tr("%1 · with %2").arg(behavior, counted(blocks, tr("block"), tr("blocks")))
                      : tr("A tree of their own · changes of the behaviour do not reach it"));
  anew_->setEnabled(tree_.isOwn);
  add_->setEnabled(tree_.mainTree() != nullptr && tree_.mainTree()->root.id == "Fallback");
  takeRoute_->setVisible(tree_.hasOtherGoals);
  problem_->setVisible(!tree_.problems.empty());
  if (!tree_.problems.empty()) {
    const QString more =
        tree_.problems.size() > 1 ? tr(" (and %1 more)").arg(tree_.problems.size() - 1) : QString();
    problem_->setText(QString::fromStdString(tree_.problems.front().message) + more);
  }
}

int BehaviorPanel::currentBlock() const {
  const int node = outline_->currentNode();
  if (node < 0 || tree_.mainTree() == nullptr) {
    return -1;
  }
  const OutlineNode& chosen = outline_->nodes()[static_cast<std::size_t>(node)];
  if (chosen.tree != tree_.mainTree()->id || chosen.path.size() != 1 ||
      !bt::readBlock(*chosen.node)) {
    return -1;
  }
  const std::vector<bt::NodeSpec>& children = tree_.mainTree()->root.children;
  return static_cast<int>(
      std::count_if(children.begin(), children.begin() + chosen.path.front(),
                    [](const bt::NodeSpec& each) { return bt::readBlock(each).has_value(); }));
}

void BehaviorPanel::showNode() {
  const int node = outline_->currentNode();
  const int block = currentBlock();
  blockLinks_->setVisible(block >= 0);
  blockForm_->setVisible(block >= 0);
  portForm_->setVisible(node >= 0 && block < 0);
  hint_->setVisible(node < 0);
  if (block >= 0) {
    const std::vector<bt::Block> blocks = bt::blocksOf(*tree_.mainTree());
    blockForm_->show(blocks[static_cast<std::size_t>(block)]);
    earlier_->setEnabled(block > 0);
    later_->setEnabled(block + 1 < static_cast<int>(blocks.size()));
  } else if (node >= 0) {
    const OutlineNode& chosen = outline_->nodes()[static_cast<std::size_t>(node)];
    portForm_->show(*chosen.node, chosen.isEditable);
  }
}

void BehaviorPanel::editBlock(const bt::Block& block) {
  const int place = currentBlock();
  if (place >= 0) {
    std::vector<bt::Block> blocks = bt::blocksOf(*tree_.mainTree());
    blocks[static_cast<std::size_t>(place)] = block;
    pushBlocks(document_, person_, blocks);
  }
}

void BehaviorPanel::moveBlock(int by) {
  const int place = currentBlock();
  if (place < 0) {
    return;
  }
  std::vector<bt::Block> blocks = bt::blocksOf(*tree_.mainTree());
  const int to = place + by;
  if (by == 0) {
    blocks.erase(blocks.begin() + place);
  } else if (to >= 0 && to < static_cast<int>(blocks.size())) {
    std::swap(blocks[static_cast<std::size_t>(place)], blocks[static_cast<std::size_t>(to)]);
  }
  const OutlineNode chosen = outline_->nodes()[static_cast<std::size_t>(outline_->currentNode())];
  pushBlocks(document_, person_, blocks);
  for (std::size_t i = 0; i < outline_->nodes().size(); ++i) {
    const OutlineNode& node = outline_->nodes()[i];
    if (node.tree == chosen.tree && node.path.size() == 1 &&
        node.path.front() == chosen.path.front() + by) {
      outline_->selectNode(static_cast<int>(i));
    }
  }
}

void BehaviorPanel::showFrame(const FramePtr& frame) {
  frame_ = frame;
  showStatus();
}

void BehaviorPanel::showStatus() {
  const sim2d::Human* human = document_.human(person_);
  if (frame_ == nullptr || human == nullptr || runner_.recording() == nullptr) {
    outline_->showStatus({});
  } else if (isVisible()) {
    outline_->showStatus(runner_.recording()->treeAt(human->id, frame_->step));
  }
}

void addBehaviorPanel(PanelRegistry& to) {
  to.add({40, QObject::tr("Behaviour"), Qt::RightDockWidgetArea}, [](PanelContext& context) {
    auto* panel = new BehaviorPanel(context.document, context.runner, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &BehaviorPanel::setTheme);
    QObject::connect(&context.runner, &SimulationRunner::frameShown, panel,
                     &BehaviorPanel::showFrame);
    QObject::connect(panel, &BehaviorPanel::told, &context, &PanelContext::problemsFound);
    return panel;
  });
}

}  // namespace editor
