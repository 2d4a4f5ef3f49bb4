#include "editor/panels/runs/RunOverlayUpdater.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bt/human/ActiveBranch.h"
#include "editor/canvas/RunOverlays.h"
#include "sim2d/trace/ContactMarks.h"

namespace editor {

namespace {

constexpr std::size_t kContactsAtOnce = 64;  // Events; the event loop runs in between.
constexpr qint64 kContactMs = 12;            // Duration of a batch.
constexpr qint64 kThoughtMs = 100;           // Interval between updates during a run.
constexpr std::size_t kMaxThinkers = 120;    // Above that only for selected people.
constexpr double kSpeechMemory = 4.0;        // [s]

QString spoken(const std::string& text) {
  return QStringLiteral("“%1”").arg(QString::fromStdString(text));
}

}  // namespace

RunOverlayUpdater::RunOverlayUpdater(SimulationRunner& runner, const RunEvents& events,
                                     MapView& view)
    : QObject(&view), runner_(runner), events_(events), view_(view) {
  connect(&runner_, &SimulationRunner::frameShown, this, &RunOverlayUpdater::follow);
  connect(&view_.mapScene(), &MapScene::optionsChanged, this, &RunOverlayUpdater::follow);
  connect(&view_.mapScene(), &MapScene::spawnedAgentChanged, this, &RunOverlayUpdater::follow);
  connect(&view_.mapScene().document(), &ScenarioDocument::selectionChanged, this,
          &RunOverlayUpdater::follow);
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &RunOverlayUpdater::follow);
  view_.viewport()->installEventFilter(this);
  follow();
}

void RunOverlayUpdater::follow() {
  if (runner_.recording() != recording_) {
    recording_ = runner_.recording();
    read_ = 0;
    thoughtStep_.reset();
    view_.mapScene().overlays().setContacts({});
    view_.mapScene().overlays().setThoughts({});
  }
  const CanvasOptions& options = view_.mapScene().options();
  runner_.setPlannerDebug(options.localCosts || options.globalCosts || options.masks,
                          options.candidates);
  if (recording_ == nullptr || runner_.shownFrame() == nullptr) {
    return;
  }
  if (options.contacts) {
    readContacts();
  }
  if (options.thoughts) {
    updateThoughts();
  }
}

/// Reads for a limited time; the rest is scheduled.
void RunOverlayUpdater::readContacts() {
  const std::size_t there = recording_->events().size();
  if (read_ >= there) {
    return;
  }
  QElapsedTimer clock;
  clock.start();
  RunOverlays& overlays = view_.mapScene().overlays();
  std::vector<sim2d::ContactMark> contacts = overlays.contacts();
  while (read_ < there && clock.elapsed() < kContactMs) {
    const std::size_t end = std::min(there, read_ + kContactsAtOnce);
    for (sim2d::ContactMark& mark : sim2d::contactMarks(*recording_, read_, end)) {
      contacts.push_back(mark);
    }
    read_ = end;
  }
  overlays.setContacts(std::move(contacts));
  view_.mapScene().update();
  if (read_ < there) {
    soon_.start();
  }
}

QString RunOverlayUpdater::thoughtOf(int id) const {
  const RecordingPtr recording = runner_.recording();
  const FramePtr frame = runner_.shownFrame();
  if (recording == nullptr || frame == nullptr || id < 0) {
    return {};
  }
  return QString::fromStdString(bt::activeBranchOf(recording->treeAt(id, frame->step)).words());
}

void RunOverlayUpdater::updateThoughts() {
  const FramePtr frame = runner_.shownFrame();
  const std::optional<int> spawnedAgent = view_.mapScene().spawnedAgent();
  const bool isEarly = runner_.state() == SimulationRunner::State::Running &&
                       sinceThoughts_.isValid() && sinceThoughts_.elapsed() < kThoughtMs;
  const bool isCrowd = frame->humans.size() > kMaxThinkers;
  const bool isSame = thoughtStep_ == frame->step && thoughtAgent_ == spawnedAgent && !isCrowd;
  if (isEarly || isSame) {
    return;
  }
  sinceThoughts_.start();
  thoughtStep_ = frame->step;
  thoughtAgent_ = spawnedAgent;
  std::map<int, QString> thoughts;
  if (isCrowd) {
    for (const ShownBody& body : view_.mapScene().frameLayer().shownBodies()) {
      if (body.isChosen && body.id >= 0 && thoughts.size() < kMaxThinkers) {
        thoughts[body.id] = thoughtOf(body.id);
      }
    }
  } else {
    for (const auto& [id, tree] : recording_->treesAt(frame->step)) {
      thoughts[id] = QString::fromStdString(bt::activeBranchOf(tree).words());
    }
  }
  view_.mapScene().overlays().setThoughts(std::move(thoughts));
  view_.mapScene().update();
}

/// Recent speech of an agent, said and heard.
QStringList RunOverlayUpdater::speechOf(int id, double time) const {
  const std::vector<RunEvent>& all = events_.events();
  auto at = std::partition_point(all.begin(), all.end(), [&](const RunEvent& event) {
    return event.time <= time - kSpeechMemory;
  });
  QStringList lines;
  for (; at != all.end() && at->time <= time + 1e-9; ++at) {
    const sim2d::Event& event = at->event;
    if (!event.hasId || event.id != id) {
      continue;
    }
    if (event.kind == sim2d::EventKind::Say) {
      lines << tr("says %1").arg(spoken(event.text));
    } else if (event.kind == sim2d::EventKind::Heard) {
      lines << tr("hears %1: %2")
                   .arg(view_.mapScene().frameLayer().nameOf(event.other), spoken(event.text));
    }
  }
  lines.removeDuplicates();
  return lines;
}

QString RunOverlayUpdater::tooltipFor(int id) const {
  const FramePtr frame = runner_.shownFrame();
  const FrameLayer& layer = view_.mapScene().frameLayer();
  if (frame == nullptr || !layer.positionOf(id)) {
    return {};
  }
  const sim2d::BodyColumns& columns =
      id < 0 ? frame->robots : static_cast<const sim2d::BodyColumns&>(frame->humans);
  const auto found = std::find(columns.id.begin(), columns.id.end(), id);
  if (found == columns.id.end()) {
    return {};
  }
  const auto k = static_cast<std::size_t>(found - columns.id.begin());
  const QString name = layer.nameOf(id);
  QStringList lines = {name.isEmpty() ? tr("Person %1").arg(id) : name};
  if (const QString thought = thoughtOf(id); !thought.isEmpty()) {
    lines << thought;
  }
  lines << speechOf(id, frame->time);
  const double speed = std::hypot(columns.vx[k], columns.vy[k]);
  QString last = QStringLiteral("%1 m/s").arg(speed, 0, 'f', 2);
  if (columns.goal[k] != sim2d::kNoGoal) {
    last += tr(" · to %1").arg(goalName(columns.goal[k]));
  }
  lines << last;
  return lines.join(QLatin1Char('\n'));
}

bool RunOverlayUpdater::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip || !view_.mapScene().isRunMode()) {
    return QObject::eventFilter(watched, event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  const std::optional<int> id = view_.mapScene().frameLayer().agentAt(view_.worldAt(help->pos()));
  const QString words = id ? tooltipFor(*id) : QString();
  if (words.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(help->globalPos(), words, view_.viewport());
  }
  event->accept();
  return true;
}

}  // namespace editor
