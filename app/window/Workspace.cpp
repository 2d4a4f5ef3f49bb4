#include "app/window/Workspace.h"

#include <algorithm>
#include <iterator>

#include <QActionGroup>

#include "editor/canvas/FrameLayer.h"
#include "editor/panels/RunLayers.h"
#include "editor/tools/ToolOptionsBar.h"

namespace app {

using editor::CanvasState;
using editor::SimulationRunner;

namespace {

constexpr int kSmoothMs = 16;         // as often as screens show
constexpr double kLongestStep = 0.5;  // [s] on the wall; a longer one is not walked smoothly

}  // namespace

Workspace::Workspace(const editor::Theme& theme, const editor::ToolRegistry& tools, QObject* parent)
    : QObject(parent),
      theme_(theme),
      scene_(document_, theme),
      view_(new editor::MapView(scene_)),
      tools_(document_, scene_, tools),
      events_(document_, runner_),
      feed_(document_, runner_),
      playback_(runner_, theme),
      scrub_(runner_, events_, scene_),
      hands_(runner_, scene_) {
  new editor::ToolOptionsBar(tools_, *view_);  // the view owns it
  new editor::RunLayers(runner_, events_, *view_);
  // The tool just chosen hears its keys, wherever the choice was made.
  connect(&tools_.actions(), &QActionGroup::triggered, view_, [this] { view_->setFocus(); });
  runner_.setGate([this](bool paused) {
    const bool mayRun = codeToAllow().empty();
    if (!mayRun) {
      Q_EMIT codeWanted(paused);
    }
    return mayRun;
  });
  runner_.setRequest([this] {
    editor::RunSettings settings = runSettings_;
    settings.code = codeToAllow().empty() ? sim2d::CodeUse::Allowed : sim2d::CodeUse::Refused;
    return editor::runRequestOf(document_, settings);
  });
  connect(&runner_, &SimulationRunner::frameShown, this, &Workspace::showFrame);
  smooth_.setInterval(kSmoothMs);
  smooth_.setTimerType(Qt::PreciseTimer);
  connect(&smooth_, &QTimer::timeout, this, &Workspace::showBetween);
  connect(&runner_, &SimulationRunner::stateChanged, this, &Workspace::showState);
  connect(&runner_, &SimulationRunner::lookingBackChanged, this, &Workspace::showState);
  connect(&events_, &editor::RunEvents::added, this, &Workspace::hearEvents);
  connect(&runner_, &SimulationRunner::stateChanged, this, &Workspace::followRecorded);
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &Workspace::refuseEdits,
          Qt::QueuedConnection);
  connect(view_, &editor::MapView::spaceTapped, playback_.playPause, &QAction::trigger);
  connect(&document_, &editor::ScenarioDocument::changed, this,
          [this](const editor::Change& change) {
            if (change.what == editor::Change::What::Everything) {
              isReplaced_ = true;
              runner_.reset();  // a run of another file
              isReplaced_ = false;
              forgetUnsavedCode();
            }
          });
  drive_ = std::make_unique<editor::HandDrive>(document_, runner_, scene_, *view_);
}

std::vector<ForeignCode> Workspace::codeToAllow() const {
  const QString file = QFileInfo(document_.path()).canonicalFilePath();
  if (freeFile_ && (freeFile_->isEmpty() || *freeFile_ == file)) {
    return {};
  }
  std::vector<ForeignCode> code = foreignCodeOf(document_.scenario());
  code.erase(std::remove_if(code.begin(), code.end(),
                            [&](const ForeignCode& each) {
                              return allowedCode_.count({file, each.words}) != 0;
                            }),
             code.end());
  return code;
}

void Workspace::allowCode(const std::vector<ForeignCode>& code) {
  const QString file = QFileInfo(document_.path()).canonicalFilePath();
  for (const ForeignCode& each : code) {
    allowedCode_.emplace(file, each.words);
  }
}

/// Another document without a file is not the one that was meant.
void Workspace::forgetUnsavedCode() {
  for (auto at = allowedCode_.begin(); at != allowedCode_.end();) {
    at = at->first.isEmpty() ? allowedCode_.erase(at) : std::next(at);
  }
}

void Workspace::openRecorded(editor::RecordingPtr recording, const QString& name,
                             std::function<editor::RunRequest()> again) {
  recordedName_ = name;
  runner_.openRecorded(std::move(recording), std::move(again));
}

void Workspace::followRecorded() {
  if (!recordedName_.isEmpty() && runner_.state() == SimulationRunner::State::Editing) {
    recordedName_.clear();
    if (!isReplaced_) {
      Q_EMIT recordedRunLeft();
    }
  }
}

/// Forms and lists stay in use, to look at people and trees; what they change is taken back.
void Workspace::refuseEdits() {
  if (isOfRecord() && document_.undoStack().canUndo()) {
    document_.undoStack().undo();
    Q_EMIT editRefused();
  }
}

/// A frame is shown as the end of a step that begins at the frame before, so that people move as
/// often as the screen shows them.
void Workspace::showFrame(const editor::FramePtr& frame) {
  scene_.showFrame(frame, runner_.recording().get());
  const double step = frame ? frame->time - shownTime_ : 0.0;
  shownTime_ = frame ? frame->time : 0.0;
  period_ = step / runner_.speed();
  const bool isSmooth = runner_.state() == SimulationRunner::State::Running &&
                        period_ > 1e-3 * kSmoothMs && period_ < kLongestStep;
  if (isSmooth) {
    sinceFrame_.start();
    scene_.setFrameShare(0.0);
    smooth_.start();
  } else {
    smooth_.stop();
  }
}

void Workspace::showBetween() {
  const double share = 1e-9 * static_cast<double>(sinceFrame_.nsecsElapsed()) / period_;
  scene_.setFrameShare(std::min(share, 1.0));
  if (share >= 1.0) {
    smooth_.stop();
  }
}

Workspace::~Workspace() {
  document_.stopMapWork();
}

void Workspace::setTheme(const editor::Theme& theme) {
  theme_ = theme;
  scene_.setTheme(theme);
  playback_.setTheme(theme);
  scrub_.setTheme(theme);
  Q_EMIT themeChanged();
}

void Workspace::showState() {
  const SimulationRunner::State state = runner_.state();
  if (state != SimulationRunner::State::Running) {
    smooth_.stop();
    scene_.setFrameShare(1.0);
  }
  view_->setCanvasState(state == SimulationRunner::State::Editing         ? CanvasState::Editing
                        : runner_.isLookingBack() || runner_.isRecorded() ? CanvasState::Past
                        : state == SimulationRunner::State::Running       ? CanvasState::Running
                                                                          : CanvasState::Paused);
  tools_.setEditingEnabled(state == SimulationRunner::State::Editing);
}

void Workspace::hearEvents(int first, int last) {
  for (int i = first; i <= last; ++i) {
    const editor::RunEvent& event = events_.events()[static_cast<std::size_t>(i)];
    const sim2d::EventKind kind = event.event.kind;
    if (kind == sim2d::EventKind::Say || kind == sim2d::EventKind::Heard) {
      scene_.frameLayer().hear({event.event}, event.time);
    }
  }
}

}  // namespace app
