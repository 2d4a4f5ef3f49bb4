#include "app/window/StartPage.h"

#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"

namespace app {

namespace {

constexpr int kColumnWidth = 1120;
constexpr int kTopSpace = 44;  // [px], for a notice
constexpr int kCardsGap = 24;
constexpr int kCardGap = 12;
constexpr int kCardsPerRow = 3;

}  // namespace

StartPage::StartPage(Workspace& workspace, WindowActions& actions, UserSettings& userSettings,
                     const std::vector<ShippedScenario>& scenarios, const QString& thumbnailFolder,
                     QWidget* parent)
    : QScrollArea(parent),
      workspace_(workspace),
      userSettings_(userSettings),
      gallery_(new ScenarioGallery(scenarios, thumbnailFolder, workspace.theme(), page_)) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // the page does not move while searching
  setAccessibleName(tr("Start page"));
  setWidget(page_);
  page_->setAutoFillBackground(true);
  page_->setBackgroundRole(QPalette::Light);
  auto* sides = new QHBoxLayout(page_);
  sides->setContentsMargins(32, 0, 32, 0);
  auto* middle = new QWidget;
  middle->setMaximumWidth(kColumnWidth);
  middle->setLayout(column_);
  sides->addStretch(1);
  sides->addWidget(middle, 1000);
  sides->addStretch(1);
  const editor::Theme& theme = workspace.theme();
  editor::configuredLayout(column_, {0, kTopSpace, 0, 24}, 0,
                           {editor::headingLabel(tr("Start"), theme.font(21.0, QFont::DemiBold))});
  column_->addSpacing(4);
  auto* line = editor::secondaryLabel(
      tr("Place people and a robot on a map, then press Space to simulate them."));
  line->setFont(theme.font(10.5));
  column_->addWidget(line);
  column_->addSpacing(20);
  addActions(actions);
  column_->addSpacing(28);
  addLists();
  column_->addStretch();
  column_->addSpacing(12);
  column_->addWidget(editor::dividerLine());
  column_->addSpacing(12);
  column_->addWidget(
      editor::secondaryLabel(tr("Drop a scenario or a map anywhere on this window to open it.")));
  connect(gallery_, &ScenarioGallery::fileRequested, this, &StartPage::fileRequested);
  fillRecent();
}

void StartPage::addActions(const WindowActions& actions) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kCardsGap);
  grid->setVerticalSpacing(kCardGap);
  int count = 0;
  const auto add = [&](QAction* action, const char* icon, const QString& title,
                       const QString& description) {
    auto* card = new ActionCard({QString::fromLatin1(icon), title, description,
                                 action->shortcut().toString(QKeySequence::NativeText)},
                                workspace_.theme(), page_);
    connect(card, &QAbstractButton::clicked, action, &QAction::trigger);
    grid->addWidget(card, count / kCardsPerRow, count % kCardsPerRow);
    ++count;
  };
  add(actions.newFromMap, "start-map", tr("New from a map"), tr("Nav2 map or floor plan image"));
  add(actions.newEmptyRoom, "start-room", tr("New empty room"), tr("Four walls, or an open plane"));
  add(actions.open, "file-open", tr("Open…"), tr("Scenario or map"));
  add(actions.tour, "start-tour", tr("Guided tour"), tr("Your first run in two minutes"));
  add(actions.openRun, "file-run", tr("Watch a recording…"), tr("Output folder of a run"));
  add(actions.importTracks, "start-import", tr("Import trajectories…"),
      tr("CSV, JuPedSim, TrajNet++ and others"));
  for (int column = 0; column < kCardsPerRow; ++column) {
    grid->setColumnStretch(column, 1);
  }
  column_->addLayout(grid);
}

/// Recent files and scenarios, in three columns aligned with the cards above.
void StartPage::addLists() {
  const QFont bold = workspace_.theme().font(12.0, QFont::DemiBold);
  auto* both = editor::configuredLayout(new QHBoxLayout, {}, 0);
  auto* left = editor::configuredLayout(new QVBoxLayout, {0, 0, 2 * kCardsGap / 3, 0}, 0,
                                        {editor::headingLabel(tr("Recent"), bold)});
  left->addSpacing(8);
  left->addLayout(recent_);
  left->addStretch();
  both->addLayout(left, 1);
  auto* right = editor::configuredLayout(new QVBoxLayout, {kCardsGap / 3, 0, 0, 0}, 0, {gallery_});
  both->addLayout(right, 2);
  column_->addLayout(both);
}

void StartPage::fillRecent() {
  editor::clearLater(*recent_);
  for (const QString& path : userSettings_.recentFiles()) {
    auto* row = new RecentRow(path, userSettings_.lastUsed(path), workspace_.theme(), page_);
    connect(row, &QAbstractButton::clicked, this, [this, path] { Q_EMIT fileRequested(path); });
    recent_->addWidget(row);
  }
  if (recent_->count() == 0) {
    QLabel* none = editor::secondaryLabel(
        tr("No recent files. Open a scenario on the right, or take the guided tour."));
    none->setWordWrap(true);
    recent_->addWidget(none);
  }
}

bool StartPage::handleKey(const QKeyEvent& event) {
  QLineEdit& search = gallery_->search();
  const std::vector<ScenarioCard*> shown = gallery_->shownCards();
  if (search.hasFocus() && event.key() == Qt::Key_Down && !shown.empty()) {
    shown.front()->setFocus(Qt::TabFocusReason);
    ensureWidgetVisible(shown.front());
    return true;
  }
  if (event.matches(QKeySequence::Find)) {
    startSearch({});
    return true;
  }
  if (isTypedText(event) && !search.hasFocus()) {
    startSearch(event.text());
    return true;
  }
  return false;
}

void StartPage::keyPressEvent(QKeyEvent* event) {
  if (!handleKey(*event)) {
    QScrollArea::keyPressEvent(event);
  }
}

void StartPage::startSearch(const QString& text) {
  QLineEdit& search = gallery_->search();
  search.setFocus(Qt::ShortcutFocusReason);
  search.selectAll();
  if (!text.isEmpty()) {
    search.insert(text);
  }
  ensureWidgetVisible(&search);
}

bool StartPage::isTypedText(const QKeyEvent& event) {
  const Qt::KeyboardModifiers commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
  return !(event.modifiers() & commands) && !event.text().trimmed().isEmpty() &&
         event.text().front().isPrint();
}

void StartPage::showTheme() {
  page_->update();
  fillRecent();
  gallery_->showTheme();
}

void StartPage::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  fillRecent();  // files may have changed
}

}  // namespace app
