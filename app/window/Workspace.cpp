#include "app/window/Workspace.h"

#include <iterator>

#include "editor/canvas/FrameLayer.h"
#include "editor/panels/runs/RunInteraction.h"

namespace app {

using editor::CanvasState;
using editor::SimulationRunner;

namespace {

constexpr int kSmoothMs = 16;         // about the display rate
constexpr double kLongestStep = 0.5;  // [s], wall clock; longer steps are not interpolated

/// Where people and robots are in a recording: in a sample of its states.
QRectF areaOf(const sim2d::Recording& recording) {
  constexpr std::size_t kSamples = 300;
  constexpr double kMargin = 1.0;  // [m]
  QPolygonF places;
  const std::size_t first = recording.first();
  const std::size_t stride = std::max<std::size_t>(1, (recording.size() - first) / kSamples);
  for (std::size_t k = first; k < recording.size(); k += stride) {
    if (const sim2d::FramePtr frame = recording.frameIfKept(k)) {
      editor::forEachBody(*frame, [&places](const sim2d::BodyColumns& bodies, std::size_t i) {
        places << editor::toScene(base::Vec2(bodies.x[i], bodies.y[i]));
      });
    }
  }
  return places.isEmpty() ? QRectF()
                          : places.boundingRect().adjusted(-kMargin, -kMargin, kMargin, kMargin);
}

}  // namespace

Workspace::Workspace(const editor::Theme& theme, const editor::ToolRegistry& tools, QObject* parent)
    : QObject(parent),
      theme_(theme),
      scene_(document_, theme),
      tools_(document_, scene_, tools),
      events_(document_, runner_),
      feed_(document_, runner_),
      playback_(runner_, theme),
      scrub_(runner_, events_, scene_),
      interaction_(runner_, scene_),
      branching_(runner_, *view_, *playback_.branchHere) {
  new editor::ToolOptionsBar(tools_, *view_);  // owned by the view
  new editor::RunOverlayUpdater(runner_, events_, *view_);
  // Gives keyboard focus to the map when a tool is chosen.
  connect(&tools_.actions(), &QActionGroup::triggered, view_, [this] { view_->setFocus(); });
  runner_.setStartCondition([this](bool paused) {
    const bool mayRun = unapprovedCode().empty();
    if (!mayRun) {
      Q_EMIT codePermissionNeeded(paused);
    }
    return mayRun;
  });
  runner_.setRequest([this] {
    editor::RunSettings settings = runSettings_;
    settings.code = unapprovedCode().empty() ? sim2d::ExternalCodePolicy::Allowed
                                             : sim2d::ExternalCodePolicy::Refused;
    return editor::runRequestOf(document_, settings);
  });
  connect(&runner_, &SimulationRunner::scenariosChanged, this,
          [this] { document_.setRun(runner_.scenarios()); });
  connect(&runner_, &SimulationRunner::frameShown, this, &Workspace::showFrame);
  interpolationTimer_.setInterval(kSmoothMs);
  interpolationTimer_.setTimerType(Qt::PreciseTimer);
  connect(&interpolationTimer_, &QTimer::timeout, this, &Workspace::interpolate);
  connect(&runner_, &SimulationRunner::stateChanged, this, &Workspace::showState);
  connect(&runner_, &SimulationRunner::lookingBackChanged, this, &Workspace::showState);
  connect(&events_, &editor::RunEvents::added, this, &Workspace::showSpeech);
  connect(&runner_, &SimulationRunner::stateChanged, this, &Workspace::handleRunClosed);
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &Workspace::revertEdits,
          Qt::QueuedConnection);
  connect(view_, &editor::MapView::spaceTapped, playback_.playPause, &QAction::trigger);
  connect(&document_, &editor::ScenarioDocument::changed, this,
          [this](const editor::Change& change) {
            if (change.what == editor::Change::What::Everything) {
              isReplaced_ = true;
              runner_.reset();  // run of another file
              isReplaced_ = false;
              clearUnsavedPermissions();
            }
          });
  drive_ = std::make_unique<editor::ManualDriveController>(document_, runner_, scene_, *view_);
}

std::vector<ExternalCode> Workspace::unapprovedCode() const {
  const QString file = QFileInfo(document_.path()).canonicalFilePath();
  if (trustedFile_ && (trustedFile_->isEmpty() || *trustedFile_ == file)) {
    return {};
  }
  std::vector<ExternalCode> code = externalCodeOf(document_.scenario());
  code.erase(std::remove_if(code.begin(), code.end(),
                            [&](const ExternalCode& each) {
                              return allowedCode_.count({file, each.words}) != 0;
                            }),
             code.end());
  return code;
}

void Workspace::allowCode(const std::vector<ExternalCode>& code) {
  const QString file = QFileInfo(document_.path()).canonicalFilePath();
  for (const ExternalCode& each : code) {
    allowedCode_.emplace(file, each.words);
  }
}

/// Called for another unsaved document, to which the permissions do not apply.
void Workspace::clearUnsavedPermissions() {
  for (auto at = allowedCode_.begin(); at != allowedCode_.end();) {
    at = at->first.isEmpty() ? allowedCode_.erase(at) : std::next(at);
  }
}

void Workspace::openRecorded(editor::RecordingPtr recording, const QString& name,
                             std::function<editor::RunRequest()> again) {
  recordedName_ = name;
  if (scene_.isOpenPlane()) {  // otherwise the map is shown
    scene_.setRunArea(areaOf(*recording));
    view_->fitAll(false);
  }
  runner_.openRecorded(std::move(recording), std::move(again));
}

void Workspace::handleRunClosed() {
  if (!recordedName_.isEmpty() && runner_.state() == SimulationRunner::State::Editing) {
    recordedName_.clear();
    scene_.setRunArea({});
    if (!isReplaced_) {
      Q_EMIT recordedRunClosed();
    }
  }
}

/// Forms and lists remain enabled for inspection; their changes are undone.
void Workspace::revertEdits() {
  if (isRecordedRun() && document_.undoStack().canUndo()) {
    document_.undoStack().undo();
    Q_EMIT editReverted();
  }
}

/// Shows a frame as the end of a step that starts at the previous frame, so that people move at the
/// display rate.
void Workspace::showFrame(const editor::FramePtr& frame) {
  scene_.showFrame(frame, runner_.recording().get());
  const double step = frame ? frame->time - shownTime_ : 0.0;
  shownTime_ = frame ? frame->time : 0.0;
  period_ = step / runner_.speed();
  const bool isSmooth = runner_.state() == SimulationRunner::State::Running &&
                        period_ > 1e-3 * kSmoothMs && period_ < kLongestStep;
  if (isSmooth) {
    sinceFrame_.start();
    scene_.setFrameInterpolation(0.0);
    interpolationTimer_.start();
  } else {
    interpolationTimer_.stop();
  }
}

void Workspace::interpolate() {
  const double share = 1e-9 * static_cast<double>(sinceFrame_.nsecsElapsed()) / period_;
  scene_.setFrameInterpolation(std::min(share, 1.0));
  if (share >= 1.0) {
    interpolationTimer_.stop();
  }
}

Workspace::~Workspace() {
  document_.stopMapTasks();
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
    interpolationTimer_.stop();
    scene_.setFrameInterpolation(1.0);
  }
  view_->setCanvasState(state == SimulationRunner::State::Editing         ? CanvasState::Editing
                        : runner_.isLookingBack() || runner_.isRecorded() ? CanvasState::Past
                        : state == SimulationRunner::State::Running       ? CanvasState::Running
                                                                          : CanvasState::Paused);
  tools_.setEditingEnabled(state == SimulationRunner::State::Editing);
}

void Workspace::showSpeech(int first, int last) {
  for (int i = first; i <= last; ++i) {
    const editor::RunEvent& event = events_.events()[static_cast<std::size_t>(i)];
    const sim2d::EventKind kind = event.event.kind;
    if (kind == sim2d::EventKind::Say || kind == sim2d::EventKind::Heard) {
      scene_.frameLayer().addSpeech({event.event}, event.time);
    }
  }
}

}  // namespace app
