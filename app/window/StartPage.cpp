#include "app/window/StartPage.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QTimer>

#include "app/window/StartCards.h"
#include "editor/canvas/RouteModel.h"
#include "editor/look/Form.h"

namespace app {

namespace {

constexpr int kColumnWidth = 1120;
constexpr int kGap = 24;
constexpr double kFiner = 1.75;  // lines are finer than on the canvas

/// The scenario as the canvas draws it, fitted into `size`.
QPixmap thumbnailOf(const QString& path, const editor::Theme& theme, const QSize& size,
                    double ratio, int& people) {
  editor::ScenarioDocument document;
  if (base::hasErrors(document.open(path))) {
    return {};
  }
  people = static_cast<int>(document.scenario().humans.size());
  editor::MapScene scene(document, theme);
  editor::CanvasOptions options;
  options.names = false;
  options.grid = false;
  options.goals = false;  // pins are as large as people here; routes say where they go
  scene.setOptions(options);
  scene.routes().finish();
  const QRectF content = scene.contentRect();
  const QSizeF large = QSizeF(size) * kFiner;  // lines keep their size there
  const double margin = 10.0 * kFiner;
  const double scale = std::min((large.width() - 2.0 * margin) / content.width(),
                                (large.height() - 2.0 * margin) / content.height());
  scene.setPixelsPerMetre(scale);
  QImage picture((large * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(ratio);
  picture.fill(theme.color(editor::Role::CanvasOutside));
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QSizeF drawn = content.size() * scale;
  const QPointF corner((large.width() - drawn.width()) / 2.0,
                       (large.height() - drawn.height()) / 2.0);
  scene.render(&painter, QRectF(corner, drawn), content);
  painter.end();
  QImage small = picture.scaled(size * ratio, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  small.setDevicePixelRatio(ratio);
  return QPixmap::fromImage(small);
}

QLabel* heading(const QString& text, const QFont& font) {
  auto* label = new QLabel(text);
  label->setFont(font);
  return label;
}

}  // namespace

StartPage::StartPage(Workspace& workspace, WindowActions& actions, Memory& memory,
                     const std::vector<Demo>& demos, QWidget* parent)
    : QScrollArea(parent),
      workspace_(workspace),
      memory_(memory),
      page_(new QWidget),
      column_(new QVBoxLayout),
      recent_(new QVBoxLayout) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
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
  column_->setContentsMargins(0, 48, 0, 24);
  column_->setSpacing(0);
  const editor::Theme& theme = workspace.theme();
  title_ = heading(tr("Start"), theme.font(21.0, QFont::DemiBold));
  column_->addWidget(title_);
  column_->addSpacing(8);
  auto* line = editor::secondaryLabel(
      tr("Draw people and a robot on a map, press Space, and watch them live."));
  line->setFont(theme.font(10.5));
  column_->addWidget(line);
  column_->addSpacing(24);
  addActions(actions);
  column_->addSpacing(32);
  addDemos(demos);
  column_->addStretch();
  column_->addWidget(editor::dividerLine());
  column_->addSpacing(12);
  column_->addWidget(
      editor::secondaryLabel(tr("Drop a scenario or a map anywhere on this window to open it.")));
  fillRecent();
}

void StartPage::addActions(WindowActions& actions) {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGap);
  const auto add = [&](QAction* action, const QString& icon, const QString& title,
                       const QString& says) {
    auto* card =
        new ActionCard({icon, title, says, action->shortcut().toString(QKeySequence::NativeText)},
                       workspace_.theme(), page_);
    connect(card, &QAbstractButton::clicked, action, &QAction::trigger);
    row->addWidget(card, 1);
    cards_.push_back(card);
  };
  add(actions.newFromMap, QStringLiteral("start-map"), tr("New from a map"),
      tr("nav2 map or image of a floor plan"));
  add(actions.newWalledRoom, QStringLiteral("start-room"), tr("New empty room"),
      tr("Four walls, or an open plane"));
  add(actions.open, QStringLiteral("file-open"), tr("Open…"), tr("Scenario or map"));
  column_->addLayout(row);
}

void StartPage::addDemos(const std::vector<Demo>& demos) {
  const QFont bold = workspace_.theme().font(12.0, QFont::DemiBold);
  auto* both = new QHBoxLayout;  // thirds, with the gaps of the cards above
  both->setSpacing(0);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  left->setContentsMargins(0, 0, 2 * kGap / 3, 0);
  left->addWidget(heading(tr("Recent"), bold));
  left->addSpacing(8);
  left->addLayout(recent_);
  left->addStretch();
  both->addLayout(left, 1);
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->setContentsMargins(kGap / 3, 0, 0, 0);
  if (!demos.empty()) {
    right->addWidget(heading(tr("Demos"), bold));
    right->addSpacing(12);
  }
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kGap);
  grid->setVerticalSpacing(16);
  for (int i = 0; i < static_cast<int>(demos.size()); ++i) {
    const Demo& demo = demos[static_cast<std::size_t>(i)];
    auto* card = new DemoCard(demo.name, workspace_.theme(), page_);
    card->setToolTip(demo.path);
    connect(card, &QAbstractButton::clicked, this,
            [this, path = demo.path] { Q_EMIT fileWanted(path); });
    grid->addWidget(card, i / 2, i % 2);
    cards_.push_back(card);
    thumbnails_.emplace_back(card, demo.path);
  }
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  right->addLayout(grid);
  right->addStretch();
  both->addLayout(right, 2);
  column_->addLayout(both);
}

void StartPage::fillRecent() {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  for (const QString& path : memory_.recentFiles()) {
    auto* row = new RecentRow(path, memory_.noted(path), workspace_.theme(), page_);
    connect(row, &QAbstractButton::clicked, this, [this, path] { Q_EMIT fileWanted(path); });
    recent_->addWidget(row);
  }
  if (recent_->count() == 0) {
    recent_->addWidget(editor::secondaryLabel(tr("Nothing opened yet. Try a demo.")));
  }
}

void StartPage::setTheme(const editor::Theme& theme) {
  for (QAbstractButton* card : cards_) {
    static_cast<StartCard*>(card)->setTheme(theme);
  }
  fillRecent();
  if (isVisible()) {
    paintThumbnails();
  }
}

void StartPage::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  fillRecent();  // files come and go meanwhile
  paintThumbnails();
}

void StartPage::paintThumbnails() {
  unpainted_.clear();
  for (std::size_t i = 0; i < thumbnails_.size(); ++i) {
    unpainted_.push_back(i);
  }
  QTimer::singleShot(0, this, &StartPage::paintNextThumbnail);
}

/// One at a time, so that the page is there at once.
void StartPage::paintNextThumbnail() {
  if (unpainted_.empty()) {
    return;
  }
  const auto& [card, path] = thumbnails_[unpainted_.front()];
  unpainted_.pop_front();
  auto* demo = static_cast<DemoCard*>(card);
  int people = -1;
  const QPixmap picture =
      thumbnailOf(path, workspace_.theme(), demo->pictureSize(), devicePixelRatioF(), people);
  demo->setPicture(picture, people);
  if (!unpainted_.empty()) {
    QTimer::singleShot(0, this, &StartPage::paintNextThumbnail);
  }
}

}  // namespace app
