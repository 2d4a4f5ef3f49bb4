#include "editor/panels/SideView.h"

#include <algorithm>
#include <utility>

#include <QScrollBar>
#include <QVBoxLayout>

#include "app/run/RecordedRun.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/document/Autosave.h"
#include "editor/look/Form.h"

namespace editor {

SideView::SideView(MapView& canvas, const DocumentSnapshot& document, QWidget* parent)
    : QWidget(parent),
      canvas_(canvas),
      scene_(document_, canvas.mapScene().theme()),
      title_(new QLabel(this)),
      view_(new MapView(scene_, this)) {
  document_.restore(document, true);
  scene_.setOptions(canvas.mapScene().options());
  title_->setContentsMargins(12, 6, 12, 6);
  arranged(new QVBoxLayout(this), {}, 0, {title_, view_});
  view_->setInteractive(false);
  view_->setCanvasState(CanvasState::Past);
  view_->setFocusPolicy(Qt::NoFocus);
  view_->setAcceptDrops(false);
  setMinimumWidth(240);
  setTheme(canvas.mapScene().theme());
  connect(&canvas_, &MapView::zoomChanged, this, &SideView::followCanvas);
  for (QScrollBar* bar : {canvas_.horizontalScrollBar(), canvas_.verticalScrollBar()}) {
    connect(bar, &QScrollBar::valueChanged, this, &SideView::followCanvas);
  }
  connect(&canvas_.mapScene(), &MapScene::optionsChanged, this,
          [this] { scene_.setOptions(canvas_.mapScene().options()); });
}

SideView::~SideView() {
  document_.stopMapWork();
  delete view_;  // before the scene that it shows
}

void SideView::setTheme(const Theme& theme) {
  scene_.setTheme(theme);
  title_->setFont(theme.font(9.5, QFont::DemiBold));
}

void SideView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  followCanvas();
}

/// The middle of the canvas is the middle here, and all that it shows is in sight.
void SideView::followCanvas() {
  const QSizeF theirs = canvas_.viewport()->size();
  const QSizeF ours = view_->viewport()->size();
  const double share = std::min({1.0, ours.width() / std::max(1.0, theirs.width()),
                                 ours.height() / std::max(1.0, theirs.height())});
  view_->setPixelsPerMetre(std::max(0.1, share) * canvas_.pixelsPerMetre());
  view_->centerOn(canvas_.mapToScene(canvas_.viewport()->rect().center()));
}

void SideView::showAt(const std::shared_ptr<const sim2d::Recording>& recording, double time) {
  if (recording == nullptr || recording->size() == 0) {
    return;
  }
  if (auto frame = recording->frameIfKept(recording->indexAtTime(time + 1e-9))) {
    scene_.showFrame(std::move(frame), recording.get());
  }
  followCanvas();
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

}  // namespace editor
