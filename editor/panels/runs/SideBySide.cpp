#include "editor/panels/runs/SideBySide.h"

#include <algorithm>
#include <utility>

#include "app/run/RecordedRun.h"
#include "editor/canvas/ComparedRunLayers.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/document/Autosave.h"
#include "editor/document/RunValues.h"
#include "editor/look/Form.h"
#include "editor/panels/runs/Playback.h"

namespace editor {

SideView::SideView(MapView& canvas, const DocumentSnapshot& document, const sim2d::Recording& run,
                   bool isOfEdited, QWidget* parent)
    : QWidget(parent), canvas_(canvas), scene_(document_, canvas.mapScene().theme()) {
  document_.restore(document, true);
  document_.setRun({nullptr, nullptr, customTreesOf(*run.header())});
  scene_.setOptions(canvas.mapScene().options());
  configuredLayout(new QVBoxLayout(this), {}, 0, {title_, view_});
  view_->setInteractive(false);
  view_->setLegendBrief(true);
  view_->setFocusPolicy(Qt::NoFocus);
  view_->setAcceptDrops(false);
  veil_->setAttribute(Qt::WA_TransparentForMouseEvents);
  veil_->setAutoFillBackground(true);
  veil_->hide();
  setMinimumWidth(240);
  setTheme(canvas.mapScene().theme());
  connect(&canvas_, &MapView::zoomChanged, this, &SideView::followCanvas);
  for (QScrollBar* bar : {canvas_.horizontalScrollBar(), canvas_.verticalScrollBar()}) {
    connect(bar, &QScrollBar::valueChanged, this, &SideView::followCanvas);
  }
  connect(&canvas_.mapScene(), &MapScene::optionsChanged, this, [this] {
    scene_.setOptions(canvas_.mapScene().options());
    readOverlays();
  });
  if (isOfEdited) {  // Some overlays are limited to the selected people.
    const ScenarioDocument& edited = canvas_.mapScene().document();
    const auto select = [this, &edited] { document_.setSelection(edited.selection()); };
    connect(&edited, &ScenarioDocument::selectionChanged, this, select);
    select();
  }
}

SideView::~SideView() {
  document_.stopMapTasks();
  delete view_;  // Before the scene that it shows.
}

void SideView::setTheme(const Theme& theme) {
  constexpr double kVeil = 0.5;
  scene_.setTheme(theme);
  stylePaneTitle(*title_, theme);
  QPalette colors = veil_->palette();
  colors.setColor(QPalette::Window, theme.color(Role::Window, kVeil));
  veil_->setPalette(colors);
}

void SideView::setTitle(const QString& title) {
  name_ = title;
  title_->setText(title);
  if (frame_ != nullptr) {
    showEnd(frame_->time);
  }
}

/// Marks a run that no longer has states at this time.
void SideView::showEnd(double time) {
  const std::optional<double> end = endBefore(*recording_, time);
  title_->setText(end ? name_ + QStringLiteral(" · ") + tr("ended at %1 s").arg(tenthsText(*end))
                      : name_);
  veil_->setGeometry(view_->viewport()->geometry());
  veil_->setVisible(end.has_value());
}

void SideView::readOverlays() {
  overlays_.show(recording_, frame_, false);
}

void SideView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  veil_->setGeometry(view_->viewport()->geometry());
  followCanvas();
}

/// Centres the view like the canvas and shows at least the same area.
void SideView::followCanvas() {
  const QSizeF theirs = canvas_.viewport()->size();
  const QSizeF ours = view_->viewport()->size();
  const double share = std::min({1.0, ours.width() / std::max(1.0, theirs.width()),
                                 ours.height() / std::max(1.0, theirs.height())});
  view_->setPixelsPerMetre(std::max(0.1, share) * canvas_.pixelsPerMetre());
  view_->centerOn(canvas_.sceneCentre());
  // centerOn() truncates to whole pixels: to the nearest one.
  const QPointF over = (canvas_.sceneCentre() - view_->sceneCentre()) * view_->pixelsPerMetre();
  QScrollBar& across = *view_->horizontalScrollBar();
  QScrollBar& down = *view_->verticalScrollBar();
  across.setValue(across.value() + qRound(over.x()));
  down.setValue(down.value() + qRound(over.y()));
}

void SideView::showAt(const std::shared_ptr<const sim2d::Recording>& recording, double time) {
  if (recording == nullptr || recording->size() == 0) {
    return;
  }
  recording_ = recording;
  if (auto frame = recording->frameIfKept(recording->indexAtTime(time + 1e-9))) {
    frame_ = std::move(frame);
    scene_.showFrame(frame_, recording.get());
    readOverlays();
  }
  showEnd(time);
  followCanvas();
}

std::optional<double> endBefore(const sim2d::Recording& recording, double time) {
  const std::size_t size = recording.size();
  if (size == 0) {
    return std::nullopt;
  }
  const double end = recording.timeOf(size - 1);
  const double gap = size > 1 ? end - recording.timeOf(size - 2) : 0.0;  // Between two states.
  return time > end + gap ? std::optional(end) : std::nullopt;
}

void stylePaneTitle(QLabel& title, const Theme& theme) {
  title.setContentsMargins(12, 6, 12, 6);
  title.setFont(theme.font(9.5, QFont::DemiBold));
}

DocumentSnapshot documentOf(const sim2d::Recording& recording, const ScenarioDocument& edited,
                            bool isOfEdited) {
  DocumentSnapshot shown = edited.snapshot();
  if (!isOfEdited) {
    shown.scenario = app::scenarioOf(recording);
    shown.trees.clear();
    shown.map = {
        std::make_shared<const sim2d::OccupancyGrid>(recording.header()->map), {}, false, {}};
    shown.mapIsInFile = false;
    shown.path.clear();
  }
  return shown;
}

SideBySide::SideBySide(MapView& canvas, const ScenarioDocument& edited, QWidget* parent)
    : QWidget(parent), canvas_(canvas), edited_(edited) {
  grid_->setContentsMargins({});
  grid_->setSpacing(1);
  showSenses(false);  // The other runs have none.
}

SideBySide::~SideBySide() {
  showSenses(true);
  canvas_.setRunColor({});
}

void SideBySide::showSenses(bool shown) {
  canvas_.mapScene().frameLayer().setSensesHidden(!shown);
  canvas_.mapScene().update();
}

void SideBySide::showRuns(const std::vector<Run>& runs) {
  std::vector<std::unique_ptr<SideView>> before = std::exchange(views_, {});
  const std::vector<Run> runsBefore = std::exchange(runs_, {});
  for (const Run& run : runs) {
    if (views_.size() == kMaxViews) {
      break;
    }
    const auto same = std::find_if(runsBefore.begin(), runsBefore.end(), [&run](const Run& each) {
      return each.recording == run.recording;
    });
    std::unique_ptr<SideView> view;
    if (same != runsBefore.end()) {
      view = std::move(before[static_cast<std::size_t>(same - runsBefore.begin())]);
    }
    if (view == nullptr) {
      view =
          std::make_unique<SideView>(canvas_, documentOf(*run.recording, edited_, run.isOfEdited),
                                     *run.recording, run.isOfEdited, this);
    }
    view->setTitle(run.title);
    views_.push_back(std::move(view));
    runs_.push_back(run);
  }
  before.clear();
  for (std::size_t k = 0; k < views_.size(); ++k) {
    const auto place = static_cast<int>(k);
    const bool isAlone = k + 1 == views_.size() && place % columns() == 0;  // Alone in its row.
    grid_->addWidget(views_[k].get(), place / columns(), place % columns(), 1,
                     isAlone ? columns() : 1);
    views_[k]->setVisible(true);
  }
  showColors(canvas_.mapScene().theme());
}

/// The line above each run has its colour in the list and in plots, not that of the state.
void SideBySide::showColors(const Theme& theme) {
  canvas_.setRunColor(theme.color(Role::Accent));
  for (std::size_t k = 0; k < views_.size(); ++k) {
    views_[k]->view().setRunColor(ghostStyle(k, theme).color);
  }
}

void SideBySide::showAt(double time) {
  for (std::size_t k = 0; k < views_.size(); ++k) {
    views_[k]->showAt(runs_[k].recording, time);
  }
}

void SideBySide::setTheme(const Theme& theme) {
  for (const std::unique_ptr<SideView>& view : views_) {
    view->setTheme(theme);
  }
  showColors(theme);
}

}  // namespace editor
