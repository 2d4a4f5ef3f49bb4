// The dock of the TreeEditor, and its widgets with their layout; their contents: TreeEditor.cpp.

#include <tuple>

#include "editor/trees/TreeEditor.h"

namespace editor {

/// Below the canvas, so that map and tree are visible together; closed by default.
void addTreeDock(PanelRegistry& to) {
  PanelInfo info = closedBottomPanel(90, QObject::tr("Tree"));
  info.initialHeight = 400;
  to.add(info, [](PanelContext& context) {
    auto* studio = new TreeEditor(context);
    QObject::connect(&context, &PanelContext::themeChanged, studio, &TreeEditor::setTheme);
    QObject::connect(studio, &TreeEditor::nodeChosen, &context,
                     [&context, studio](int node) { Q_EMIT context.nodeChosen(node, studio); });
    QObject::connect(studio, &TreeEditor::personShown, &context, &PanelContext::treeShown);
    QObject::connect(&context, &PanelContext::treeIssueRequested, studio, &TreeEditor::showIssue);
    QObject::connect(studio, &TreeEditor::pictureRequested, &context,
                     &PanelContext::treePictureRequested);
    QObject::connect(&context, &PanelContext::nodeChosen, studio,
                     [studio](int node, const QObject* by) {
                       if (by != studio) {
                         studio->choose(node);
                       }
                     });
    return studio;
  });
}

namespace {

constexpr int kHeadHeight = 36;
constexpr int kLowerHigh = 190, kLowerLow = 112;  // Initial heights below the graph [px].
constexpr int kHighStudio = 560;
constexpr int kPaletteShare = 220, kCanvasShare = 640;  // Initial widths [px].

}  // namespace

TreeEditor::TreeEditor(PanelContext& context)
    : context_(context),
      document_(context.document),
      runner_(context.runner),
      canvas_(new TreeCanvas(context.theme())),
      palette_(new NodePalette(context.theme())),
      history_(new TreeHistory(canvas_->graph(), context.runner, context.theme())),
      text_(new TreeText(context.theme())),
      entries_(new BlackboardView(context.runner, context.theme())),
      inset_(new MapInset(context.view.mapScene(), context.runner, canvas_)),
      fields_(new NodeFields(*canvas_, context.theme())),
      running_(new RunningNodes(canvas_->graph(), *history_, context.runner, context.theme())) {
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

QWidget* TreeEditor::makeHead() {
  auto* head = new QWidget(this);
  head->setFixedHeight(kHeadHeight);
  people_->setAccessibleName(tr("Tree of"));
  people_->setToolTip(tr("Person whose tree is shown; you can also select a person on the map"));
  people_->setMinimumWidth(150);
  const auto link = [this](const QString& text, const QString& says, auto action) {
    return linkButton(text, says, this, action);
  };
  sharing_ = new QToolButton(this);
  sharing_->setCheckable(true);
  sharing_->setChecked(true);
  sharing_->setToolTip(tr("Apply edits to all people with the same tree"));
  sharing_->hide();
  assignButton_ = link(tr("Assign to…"), tr("Assign the same tree to other people"),
                       [this] { showAssignMenu(); });
  newTree_ = link(tr("New tree"), tr("Start a new tree with an empty Sequence as its root"),
                  [this] { startNewTree(); });
  turn_ = link(tr("Left to right"), tr("Place the root on the left or at the top"), [this] {
    const bool isDown = canvas_->graph().direction() == TreeDirection::Down;
    canvas_->setDirection(isDown ? TreeDirection::Right : TreeDirection::Down);
    updateLayoutButtons();
  });
  positionSource_ = link({}, tr("Use node positions of the file or automatic layout"), [this] {
    using PositionSource = TreeGraph::PositionSource;
    const bool isAutomatic = canvas_->graph().positionSource() == PositionSource::Automatic;
    canvas_->setPositionSource(isAutomatic ? PositionSource::File : PositionSource::Automatic);
    updateLayoutButtons();
  });
  positionSource_->hide();
  folds_ = link(tr("Expand all"), tr("Show all nodes or only the branches"), [this] {
    isAnyFolded() ? canvas_->graph().unfoldAll() : canvas_->graph().foldAll();
    canvas_->fit();
    showChosen();
  });
  auto* fit =
      link(tr("Fit"), tr("Fit the whole tree in the window (F)"), [this] { canvas_->fit(); });
  hint_->setForegroundRole(QPalette::PlaceholderText);
  hint_->setTextFormat(Qt::PlainText);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = configuredLayout(
      new QHBoxLayout(head), {12, 4, 12, 4}, 12,
      {secondaryLabel(tr("Tree of"), head), people_, sharing_, assignButton_, newTree_, hint_});
  row->setStretchFactor(hint_, 1);
  for (QToolButton* each : {positionSource_, folds_, turn_, fit}) {
    row->addWidget(each);
  }
  return head;
}

/// Updates the texts of the layout buttons.
void TreeEditor::updateLayoutButtons() {
  const TreeGraph& graph = canvas_->graph();
  positionSource_->setVisible(graph.hasStoredPositions());
  positionSource_->setText(graph.positionSource() == TreeGraph::PositionSource::Automatic
                               ? tr("Layout: automatic")
                               : tr("Layout: from file"));
  turn_->setText(graph.direction() == TreeDirection::Down ? tr("Left to right") : tr("Top down"));
}

bool TreeEditor::isAnyFolded() const {
  const TreeGraph& graph = canvas_->graph();
  return std::any_of(graph.shown().begin(), graph.shown().end(),
                     [&graph](int node) { return graph.isFolded(node); });
}

void TreeEditor::makeLayout() {
  problem_->setObjectName(QStringLiteral("problem"));
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  problem_->setContentsMargins(12, 6, 12, 6);
  problem_->setParent(canvas_);  // Above the tree, which stays where it is.
  problem_->setAttribute(Qt::WA_TransparentForMouseEvents);
  problem_->setAutoFillBackground(true);
  problem_->setBackgroundRole(QPalette::Light);
  problem_->hide();
  auto* upper = new QSplitter(Qt::Horizontal, this);
  upper->addWidget(palette_);
  upper->addWidget(canvas_);
  upper->setStretchFactor(1, 1);
  upper->setSizes({kPaletteShare, kCanvasShare});
  splitter_->addWidget(upper);
  lower_->setDocumentMode(true);
  const std::tuple<QWidget*, QString, QString> tabs[] = {
      {history_, tr("Over time"), tr("What each node returned in the run")},
      {running_, tr("Running"), tr("The nodes that are running at the displayed step")},
      {text_, tr("XML"), tr("Edit the XML file of the tree")},
      {entries_, tr("Blackboard"), tr("Blackboard of the person's tree at the displayed step")}};
  for (const auto& [page, title, tip] : tabs) {
    lower_->setTabToolTip(lower_->addTab(page, title), tip);
  }
  splitter_->addWidget(lower_);
  splitter_->setStretchFactor(0, 1);
  splitter_->setCollapsible(0, false);
  connect(splitter_, &QSplitter::splitterMoved, this, [this] { isSplitByUser_ = true; });
  auto* layout =
      configuredLayout(new QVBoxLayout(this), {}, 0, {makeHead(), dividerLine(this), empty_});
  layout->addWidget(splitter_, 1);
}

void TreeEditor::connectParts() {
  connect(people_, qOverload<int>(&QComboBox::activated), this, [this](int row) {
    document_.setSelection({{EntityKind::Human, people_->itemData(row).toInt()}});
  });
  connect(sharing_, &QToolButton::toggled, this, &TreeEditor::showSharing);
  connect(canvas_, &TreeCanvas::choiceChanged, this, [this](int node) {
    showChosen();
    Q_EMIT nodeChosen(node);
  });
  connect(entries_, &BlackboardView::messageChanged, this, &TreeEditor::showHint);
  connect(text_, &TreeText::edited, this, &TreeEditor::applyText);
  connect(text_, &TreeText::lineChosen, this, [this](int line) { choose(nodeAtLine(line)); });
  connect(history_, &TreeHistory::choiceChanged, this, [this](int node) { choose(node); });
  connect(running_, &RunningNodes::choiceChanged, this, [this](int node) { choose(node); });
  connect(fields_, &NodeFields::applied, this, &TreeEditor::applyFields);
  connect(palette_, &NodePalette::escaped, canvas_, [this] { canvas_->setFocus(); });
  connect(canvas_, &TreeCanvas::openRequested, this, &TreeEditor::openNode);
  connect(canvas_, &TreeCanvas::keyCommand, this, &TreeEditor::handleKey);
  connect(canvas_, &TreeCanvas::moved, this, [this] {
    placeProblem();
    placeInset();
    if (fields_->isOpen() && canvas_->graph().isShown(canvas_->chosen())) {
      fields_->moveTo(canvas_->placeOf(canvas_->chosen()));
    }
    folds_->setText(isAnyFolded() ? tr("Expand all") : tr("Collapse"));
  });
  connect(canvas_, &TreeCanvas::escaped, this, [this] {
    if (!std::exchange(pickedPort_, {}).empty()) {
      showHint(tr("Nothing was picked"));
    }
  });
  connect(canvas_, &TreeCanvas::moveRequested, this, &TreeEditor::move);
  connect(canvas_, &TreeCanvas::dropRequested, this, &TreeEditor::addAt);
  connect(canvas_, &TreeCanvas::menuRequested, this, [this](int node, const QPoint& at) {
    QMenu& menu = menu_.begin(*this);
    fillMenu(menu, node);
    menu.popup(at);
  });
  connect(palette_, &NodePalette::addRequested, this, &TreeEditor::add);
  connect(&runner_, &SimulationRunner::frameShown, this, &TreeEditor::showStatuses);
  connect(&runner_, &SimulationRunner::stateChanged, this, [this] {
    if (runner_.state() != SimulationRunner::State::Editing) {  // No longer refused.
      showProblems(canvas_->graph().tree().problems);
    }
  });
  connect(&runner_, &SimulationRunner::breakpointsChanged, this, &TreeEditor::showBreakpoints);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &TreeEditor::follow);
  connect(&document_, &ScenarioDocument::stepFinished, this, [this] {
    stale_ = true;
    if (isVisible()) {
      rebuild();
    }
  });
}

/// In a low window the graph gets the space, unless the user has moved the splitter.
void TreeEditor::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!isSplitByUser_) {
    const int lower = height() < kHighStudio ? kLowerLow : kLowerHigh;
    splitter_->setSizes({std::max(0, height() - kHeadHeight - lower), lower});
  }
}

/// Places the problem at the lower edge of the tree.
void TreeEditor::placeProblem() {
  const int height = problem_->heightForWidth(canvas_->width());
  problem_->setGeometry(0, canvas_->height() - height, canvas_->width(), height);
  problem_->raise();
}

/// Places the inset in a free corner while the main map is hidden.
void TreeEditor::placeInset() {
  constexpr int kInsetMargin = 12;
  inset_->follow(person_);
  const int below = problem_->isHidden() ? 0 : problem_->height();
  const QRect room =
      canvas_->rect().adjusted(kInsetMargin, kInsetMargin, -kInsetMargin, -kInsetMargin - below);
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
