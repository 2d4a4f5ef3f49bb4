// The parts of the studio and where they lie; what they show: TreeStudio.cpp.
#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/trees/TreeStudio.h"

namespace editor {

namespace {

constexpr int kHeadHeight = 36;
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
      problem_(new QLabel(this)),
      empty_(emptyState(tr("No people yet: press P and click on the map."), this)),
      canvas_(new TreeCanvas(context.theme())),
      palette_(new NodePalette(context.theme())),
      history_(new TreeHistory(canvas_->graph(), context.runner, context.theme())),
      text_(new TreeText(context.theme())),
      entries_(new TreeEntries(context.runner, context.theme())),
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
    showPlacing();
  });
  placing_ = link({}, tr("Where the file puts its nodes, or our own layout"), [this] {
    using Placing = TreeGraph::Placing;
    const bool isOurs = canvas_->graph().placing() == Placing::Ours;
    canvas_->setPlacing(isOurs ? Placing::File : Placing::Ours);
    showPlacing();
  });
  placing_->hide();
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
  for (QToolButton* each : {placing_, folds_, turn_, fit}) {
    row->addWidget(each);
  }
  return head;
}

/// Texts of the buttons for the layout say what they would do, or what is shown.
void TreeStudio::showPlacing() {
  const TreeGraph& graph = canvas_->graph();
  placing_->setVisible(graph.hasFilePlaces());
  placing_->setText(graph.placing() == TreeGraph::Placing::Ours ? tr("Layout: ours")
                                                                : tr("Layout: as in the file"));
  turn_->setText(graph.direction() == TreeDirection::Down ? tr("Left to right") : tr("Top down"));
}

bool TreeStudio::isAnyFolded() const {
  const TreeGraph& graph = canvas_->graph();
  return std::any_of(graph.shown().begin(), graph.shown().end(),
                     [&graph](int node) { return graph.isFolded(node); });
}

void TreeStudio::makeLayout() {
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  problem_->setContentsMargins(12, 6, 12, 6);
  problem_->hide();
  auto* upper = new QSplitter(Qt::Horizontal, this);
  upper->addWidget(palette_);
  upper->addWidget(canvas_);
  upper->setStretchFactor(1, 1);
  upper->setSizes({kPaletteShare, kCanvasShare});
  halves_->addWidget(upper);
  lower_->setDocumentMode(true);
  lower_->addTab(history_, tr("Over time"));
  lower_->addTab(text_, tr("XML"));
  lower_->addTab(entries_, tr("Blackboard"));
  lower_->setTabToolTip(0, tr("What each node returned in the run"));
  lower_->setTabToolTip(1, tr("The file of the tree, which can be edited as well"));
  lower_->setTabToolTip(2, tr("What the person's tree knows at the moment that is shown"));
  halves_->addWidget(lower_);
  halves_->setStretchFactor(0, 1);
  halves_->setCollapsible(0, false);
  connect(halves_, &QSplitter::splitterMoved, this, [this] { isDivided_ = true; });
  auto* layout =
      arranged(new QVBoxLayout(this), {}, 0, {makeHead(), dividerLine(this), problem_, empty_});
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
  connect(entries_, &TreeEntries::said, this, &TreeStudio::say);
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
    QMenu& menu = menu_.begin(*this);
    fillMenu(menu, node);
    menu.popup(at);
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

/// As long as nobody has chosen otherwise, a low studio leaves the room to the graph.
void TreeStudio::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!isDivided_) {
    const int lower = height() < kHighStudio ? kLowerLow : kLowerHigh;
    halves_->setSizes({std::max(0, height() - kHeadHeight - lower), lower});
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

}  // namespace editor
