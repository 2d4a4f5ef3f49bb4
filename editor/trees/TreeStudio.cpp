#include "editor/trees/TreeStudio.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSplitter>
#include <QVBoxLayout>

#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/document/TreeFiles.h"
#include "editor/look/Fields.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Form.h"
#include "editor/panels/TreeOutline.h"

namespace editor {

namespace {

constexpr int kHeadHeight = 36;
constexpr int kHintMs = 6000;
constexpr int kLowerHigh = 190, kLowerLow = 112;  // below the graph, until it is moved [px]
constexpr int kHighStudio = 560;
constexpr int kPaletteShare = 220, kCanvasShare = 640;  // of the width at first [px]

}  // namespace

TreeStudio::TreeStudio(PanelContext& context)
    : context_(context),
      document_(context.document),
      runner_(context.runner),
      people_(new ChoiceField(this)),
      hint_(new QLabel(this)),
      empty_(emptyState(tr("No people yet: press P and click on the map."), this)),
      canvas_(new TreeCanvas(context.theme())),
      palette_(new NodePalette(context.theme())),
      history_(new TreeHistory(canvas_->graph(), context.runner, context.theme())),
      text_(new TreeText(context.theme())),
      lower_(new QTabWidget(this)),
      halves_(new QSplitter(Qt::Vertical, this)),
      inset_(new MapInset(context.view.mapScene(), context.runner, canvas_)),
      nameField_(new QLineEdit(canvas_)) {
  canvas_->installEventFilter(this);
  context.view.installEventFilter(this);
  nameField_->hide();
  nameField_->setAccessibleName(tr("Name of the node"));
  nameField_->installEventFilter(this);
  makeLayout();
  connectParts();
  hintTimer_.setSingleShot(true);
  connect(&hintTimer_, &QTimer::timeout, hint_, &QLabel::clear);
  setTheme(context.theme());
  follow();
}

QWidget* TreeStudio::makeHead() {
  auto* head = new QWidget(this);
  head->setFixedHeight(kHeadHeight);
  people_->setAccessibleName(tr("Tree of"));
  people_->setToolTip(tr("Whose tree is shown; selecting a person on the map does the same"));
  people_->setMinimumWidth(150);
  const auto link = [this](const QString& text, const QString& says, auto action) {
    return linkButton(text, says, this, action);
  };
  sharing_ = new QToolButton(this);
  sharing_->setCheckable(true);
  sharing_->setChecked(true);
  sharing_->setToolTip(tr("Whether edits change everybody who has this very tree"));
  sharing_->hide();
  give_ = link(tr("Give to…"), tr("Let others have the same tree"), [this] { offerGiving(); });
  turn_ = link(tr("Left to right"), tr("The root at the left, or at the top"), [this] {
    const bool isDown = canvas_->graph().direction() == TreeDirection::Down;
    canvas_->setDirection(isDown ? TreeDirection::Right : TreeDirection::Down);
    turn_->setText(isDown ? tr("Top down") : tr("Left to right"));
  });
  folds_ = link(tr("Unfold all"), tr("Show every node, or the branches alone"), [this] {
    isAnyFolded() ? canvas_->graph().unfoldAll() : canvas_->graph().foldAll();
    canvas_->fit();
    showChosen();
  });
  auto* fit = link(tr("Fit"), tr("The whole tree in the window (F)"), [this] { canvas_->fit(); });
  hint_->setForegroundRole(QPalette::PlaceholderText);
  hint_->setTextFormat(Qt::PlainText);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = arranged(new QHBoxLayout(head), {12, 4, 12, 4}, 12,
                       {secondaryLabel(tr("Tree of"), head), people_, sharing_, give_, hint_});
  row->setStretchFactor(hint_, 1);
  for (QToolButton* each : {folds_, turn_, fit}) {
    row->addWidget(each);
  }
  return head;
}

bool TreeStudio::isAnyFolded() const {
  const TreeGraph& graph = canvas_->graph();
  return std::any_of(graph.shown().begin(), graph.shown().end(),
                     [&graph](int node) { return graph.isFolded(node); });
}

void TreeStudio::makeLayout() {
  auto* upper = new QSplitter(Qt::Horizontal, this);
  upper->addWidget(palette_);
  upper->addWidget(canvas_);
  upper->setStretchFactor(1, 1);
  upper->setSizes({kPaletteShare, kCanvasShare});
  halves_->addWidget(upper);
  lower_->setDocumentMode(true);
  lower_->addTab(history_, tr("Over time"));
  lower_->addTab(text_, tr("XML"));
  lower_->setTabToolTip(0, tr("What each node returned in the run"));
  lower_->setTabToolTip(1, tr("The file of the tree, which can be edited as well"));
  halves_->addWidget(lower_);
  halves_->setStretchFactor(0, 1);
  halves_->setCollapsible(0, false);
  connect(halves_, &QSplitter::splitterMoved, this, [this] { isDivided_ = true; });
  auto* layout = arranged(new QVBoxLayout(this), {}, 0, {makeHead(), dividerLine(this), empty_});
  layout->addWidget(halves_, 1);
}

void TreeStudio::connectParts() {
  connect(people_, qOverload<int>(&QComboBox::activated), this, [this](int row) {
    document_.setSelection({{EntityKind::Human, people_->itemData(row).toInt()}});
  });
  connect(sharing_, &QToolButton::toggled, this, &TreeStudio::showSharing);
  connect(canvas_, &TreeCanvas::chose, this, [this](int node) {
    showChosen();
    Q_EMIT nodeChosen(node);
  });
  connect(text_, &TreeText::edited, this, &TreeStudio::takeText);
  connect(text_, &TreeText::lineChosen, this, [this](int line) { choose(nodeAtLine(line)); });
  connect(history_, &TreeHistory::chose, this, [this](int node) { choose(node); });
  connect(canvas_, &TreeCanvas::openWanted, this, &TreeStudio::openNode);
  connect(canvas_, &TreeCanvas::keyCommand, this, &TreeStudio::doKey);
  connect(canvas_, &TreeCanvas::moved, this, [this] {
    placeInset();
    folds_->setText(isAnyFolded() ? tr("Unfold all") : tr("Fold"));
  });
  connect(canvas_, &TreeCanvas::escaped, this, [this] {
    if (!std::exchange(pickedPort_, {}).empty()) {
      say(tr("Nothing was picked"));
    }
  });
  connect(canvas_, &TreeCanvas::moveWanted, this, &TreeStudio::move);
  connect(canvas_, &TreeCanvas::dropWanted, this, &TreeStudio::addAt);
  connect(canvas_, &TreeCanvas::menuWanted, this, [this](int node, const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu, node);
    menu->popup(at);
  });
  connect(palette_, &NodePalette::wanted, this, &TreeStudio::add);
  connect(&runner_, &SimulationRunner::frameShown, this, &TreeStudio::showStatuses);
  connect(&runner_, &SimulationRunner::breakpointsChanged, this, &TreeStudio::showBreakpoints);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &TreeStudio::follow);
  connect(&document_, &ScenarioDocument::settled, this, [this] {
    stale_ = true;
    if (isVisible()) {
      rebuild();
    }
  });
}

void TreeStudio::setTheme(const Theme& theme) {
  canvas_->setTheme(theme);
  palette_->setTheme(theme);
  history_->setTheme(theme);
  text_->setTheme(theme);
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

/// As long as nobody has chosen otherwise, a low studio leaves the room to the graph.
void TreeStudio::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!isDivided_) {
    const int lower = height() < kHighStudio ? kLowerLow : kLowerHigh;
    halves_->setSizes({std::max(0, height() - kHeadHeight - lower), lower});
  }
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
  const bool isBroken = human() != nullptr && canvas_->graph().nodes().empty();
  if (isBroken && !tree.problems.empty()) {
    say(QString::fromStdString(tree.problems.front().message));
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

/// In a corner where nothing of the tree lies, while the map is not seen itself.
void TreeStudio::placeInset() {
  constexpr int kInsetMargin = 12;
  inset_->follow(person_);
  const QRect room =
      canvas_->rect().adjusted(kInsetMargin, kInsetMargin, -kInsetMargin, -kInsetMargin);
  const bool isWanted = isVisible() && !context_.view.isVisible() && human() != nullptr &&
                        room.width() > 2 * inset_->width() &&
                        room.height() > 3 * inset_->height() / 2;
  for (const Qt::Corner corner :
       {Qt::BottomLeftCorner, Qt::BottomRightCorner, Qt::TopLeftCorner, Qt::TopRightCorner}) {
    QRect place = inset_->rect();
    const bool isLeft = corner == Qt::BottomLeftCorner || corner == Qt::TopLeftCorner;
    const bool isTop = corner == Qt::TopLeftCorner || corner == Qt::TopRightCorner;
    place.moveTo(isLeft ? room.left() : room.right() - place.width(),
                 isTop ? room.top() : room.bottom() - place.height());
    if (isWanted && canvas_->isFree(place)) {
      inset_->move(place.topLeft());
      inset_->show();
      return;
    }
  }
  inset_->hide();
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
