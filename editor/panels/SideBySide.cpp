#include "editor/panels/SideBySide.h"

#include <algorithm>
#include <utility>

#include "editor/document/Autosave.h"
#include "editor/look/Form.h"

namespace editor {

SideBySide::SideBySide(MapView& canvas, const ScenarioDocument& edited, QWidget* parent)
    : QWidget(parent), canvas_(canvas), edited_(edited), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins({});
  grid_->setSpacing(1);
}

void SideBySide::showRuns(const std::vector<Run>& runs) {
  std::vector<std::unique_ptr<SideView>> before = std::exchange(views_, {});
  const std::vector<Run> runsBefore = std::exchange(runs_, {});
  for (const Run& run : runs) {
    if (views_.size() == kMost) {
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
      view = std::make_unique<SideView>(canvas_,
                                        documentOf(*run.recording, edited_, run.isOfEdited), this);
    }
    view->setTitle(run.title);
    views_.push_back(std::move(view));
    runs_.push_back(run);
  }
  before.clear();
  for (std::size_t k = 0; k < views_.size(); ++k) {
    const auto place = static_cast<int>(k);
    const bool isAlone = k + 1 == views_.size() && place % columns() == 0;  // in its row
    grid_->addWidget(views_[k].get(), place / columns(), place % columns(), 1,
                     isAlone ? columns() : 1);
    views_[k]->setVisible(true);
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
}

}  // namespace editor
