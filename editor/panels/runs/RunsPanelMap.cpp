// The part of RunsPanel that shows runs on the map and beside it.
#include <algorithm>
#include <cmath>

#include "editor/panels/runs/Playback.h"
#include "editor/panels/runs/RunsPanel.h"

namespace editor {

namespace {

constexpr double kGhostTrailGap = 0.15;  // [s]

}  // namespace

GhostLayer::Ghost RunsPanel::ghostOf(const Row& row, double time) const {
  const sim2d::Recording& recording = *row.recording;
  GhostLayer::Ghost ghost;
  ghost.style = static_cast<std::size_t>(std::max(0, styleOf(row)));
  ghost.header = recording.header();
  const std::size_t index = recording.indexAtTime(time + 1e-9);
  ghost.frame = recording.frameIfKept(index);
  ghost.hasEnded = endBefore(recording, time).has_value();
  if (ghost.frame == nullptr || !context_.view.mapScene().options().trails) {
    return ghost;
  }
  const double gap = recording.size() > 1 ? recording.timeOf(1) - recording.timeOf(0) : 1.0;
  const auto stride = static_cast<std::size_t>(std::max(1L, std::lround(kGhostTrailGap / gap)));
  const double seconds = context_.view.mapScene().options().trailSeconds;
  std::size_t at = recording.indexAtTime(std::max(0.0, time - seconds)) / stride * stride;
  for (; at <= index; at += stride) {
    const FramePtr frame = recording.frameIfKept(at);
    if (frame == nullptr) {
      continue;
    }
    for (const sim2d::BodyColumns* columns :
         {static_cast<const sim2d::BodyColumns*>(&frame->humans), &frame->robots}) {
      for (std::size_t k = 0; k < columns->size(); ++k) {
        ghost.trails[columns->id[k]].emplace_back(columns->x[k], columns->y[k]);
      }
    }
  }
  return ghost;
}

/// The time at which runs are compared [s].
double RunsPanel::comparedTime() const {
  const FramePtr shown = context_.runner.shownFrame();
  return std::max(shown == nullptr ? 0.0 : shown->time, afterEnd_);
}

/// "B ended at 14.8 s", for each displayed run that is shorter than the displayed time.
QStringList RunsPanel::endedRuns() const {
  QStringList ended;
  for (const Row& row : rows()) {
    const bool isDisplayed = isShown(row) || styleOf(row) >= 0;
    const std::optional<double> end = isDisplayed && row.recording != nullptr
                                          ? endBefore(*row.recording, comparedTime())
                                          : std::nullopt;
    if (end) {
      ended << tr("%1 ended at %2 s").arg(letterOf(row), tenthsText(*end));
    }
  }
  return ended;
}

void RunsPanel::showGhosts() {
  const FramePtr shown = context_.runner.shownFrame();
  std::vector<GhostLayer::Ghost> ghosts;
  if (shown != nullptr && !sideBySideButton_->isChecked()) {
    for (const Row& row : compared()) {
      GhostLayer::Ghost ghost = ghostOf(row, comparedTime());
      if (ghost.frame != nullptr) {
        ghosts.push_back(std::move(ghost));
      }
    }
  }
  ghosts_->show(std::move(ghosts), shown);
  if (side_ != nullptr && shown != nullptr) {
    side_->showAt(comparedTime());
  }
  showCanvasTitle();
  showDivergences();
}

/// Beside other runs the canvas has a title, too.
void RunsPanel::showCanvasTitle() {
  QString title;
  for (const Row& row : rows()) {
    if (side_ == nullptr || !isShown(row)) {
      continue;
    }
    title = titleOf(row);
    const std::optional<double> end =
        row.recording == nullptr ? std::nullopt : endBefore(*row.recording, comparedTime());
    if (end) {
      title += QStringLiteral(" · ") + tr("ended at %1 s").arg(tenthsText(*end));
    }
  }
  if (canvasTitle_ != title) {
    canvasTitle_ = title;
    Q_EMIT context_.canvasTitleChanged(title);
  }
}

QString RunsPanel::letterOf(const Row& row) const {
  const int style = styleOf(row);
  return style < 0 ? QStringLiteral("A")
                   : ghostStyle(static_cast<std::size_t>(style), context_.theme()).letter;
}

/// "B  Branch 1": the title of a view.
QString RunsPanel::titleOf(const Row& row) const {
  return letterOf(row) + QStringLiteral("  ") + row.name;
}

void RunsPanel::showSideBySide() {
  const std::vector<Row> others = compared();
  sideBySideButton_->setEnabled(!others.empty());
  const bool isWanted = sideBySideButton_->isChecked() && !others.empty();
  if (!isWanted && side_ != nullptr) {
    Q_EMIT context_.sideViewRequested(nullptr, 1);
    side_.reset();
  }
  if (isWanted) {
    std::vector<SideBySide::Run> runs;
    runs.reserve(others.size());
    for (const Row& row : others) {
      runs.push_back({titleOf(row), row.recording, row.branch >= 0});
    }
    const int before = side_ == nullptr ? 0 : side_->columns();
    if (side_ == nullptr) {
      side_ = std::make_unique<SideBySide>(context_.view, context_.document);
    }
    side_->showRuns(runs);
    if (before != side_->columns()) {
      Q_EMIT context_.sideViewRequested(side_.get(), side_->columns());
    }
  }
  showGhosts();
}

}  // namespace editor
