#include "editor/panels/Scrubbing.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "editor/look/Form.h"
#include "editor/look/Icons.h"

namespace editor {

namespace {

constexpr double kLoopReach = 2.5;  // [s] of a new loop, before and after the moment that is shown
constexpr double kLeastLoop = 0.2;  // [s]

QAction* scrubAction(const QString& text, const QKeySequence& shortcut, const QString& says,
                     QObject* parent) {
  auto* action = new QAction(text, parent);
  action->setShortcut(shortcut);
  describe(*action, says);
  return action;
}

}  // namespace

ScrubActions::ScrubActions(SimulationRunner& runner, RunEvents& events, MapScene& scene)
    : previousContact(scrubAction(tr("&Previous contact"),
                                  QKeySequence(int{Qt::ALT} | Qt::Key_Left),
                                  tr("Show the moment of the contact before"), this)),
      nextContact(scrubAction(tr("Ne&xt contact"), QKeySequence(int{Qt::ALT} | Qt::Key_Right),
                              tr("Show the moment of the contact that comes next"), this)),
      loop(scrubAction(tr("Loop a part"), QKeySequence(int{Qt::CTRL} | Qt::Key_L),
                       tr("Play from A to B again and again; drag the marks on the timeline, or "
                          "Shift and drag a new part"),
                       this)),
      onionSkin(scrubAction(tr("&Onion skin"), QKeySequence(int{Qt::SHIFT} | Qt::Key_O),
                            tr("Where everybody was 1, 2 and 3 s before, and will be then"), this)),
      runner_(runner),
      events_(events),
      scene_(scene),
      lengths_(new QActionGroup(this)) {
  auto onion = std::make_unique<OnionLayer>(scene_);
  onion_ = onion.get();
  scene_.addRunLayer(std::move(onion));
  loop->setCheckable(true);
  onionSkin->setCheckable(true);
  makeLengths();
  connect(previousContact, &QAction::triggered, this, [this] { goTo(false); });
  connect(nextContact, &QAction::triggered, this, [this] { goTo(true); });
  connect(loop, &QAction::triggered, this, &ScrubActions::switchLoop);
  connect(onionSkin, &QAction::toggled, this, &ScrubActions::showSkins);
  connect(&runner_, &SimulationRunner::loopChanged, this, &ScrubActions::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &ScrubActions::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, [this] {
    follow();
    showSkins();
  });
  connect(&events_, &RunEvents::cleared, this, [this] {
    contacts_.clear();
    follow();
  });
  connect(&events_, &RunEvents::added, this, &ScrubActions::takeContacts);
  setTheme(scene_.theme());
  follow();
}

void ScrubActions::setTheme(const Theme& theme) {
  previousContact->setIcon(themedIcon(QStringLiteral("run-contact-back"), theme));
  nextContact->setIcon(themedIcon(QStringLiteral("run-contact-next"), theme));
  loop->setIcon(themedIcon(QStringLiteral("run-loop"), theme));
  onionSkin->setIcon(themedIcon(QStringLiteral("view-onion"), theme));
}

void ScrubActions::makeLengths() {
  for (const int seconds : {3, 6, 15, 30, 60}) {
    auto* action = new QAction(tr("%1 s").arg(seconds), lengths_);
    describe(*action, tr("Trails of a run show so much of the past"));
    action->setCheckable(true);
    action->setChecked(scene_.options().trailSeconds == seconds);
    connect(&scene_, &MapScene::optionsChanged, action, [this, action, seconds] {
      action->setChecked(scene_.options().trailSeconds == seconds);
    });
    connect(action, &QAction::triggered, this, [this, seconds] {
      CanvasOptions options = scene_.options();
      options.trailSeconds = seconds;
      options.trails = true;
      scene_.setOptions(options);
      if (const FramePtr shown = runner_.shownFrame()) {
        scene_.showFrame(shown, runner_.recording().get());  // what it reads of the past
      }
    });
  }
}

void ScrubActions::takeContacts(int first, int last) {
  for (int k = first; k <= last; ++k) {
    const RunEvent& event = events_.events()[static_cast<std::size_t>(k)];
    if (event.event.kind == sim2d::EventKind::Contact &&
        (contacts_.empty() || contacts_.back() != event.step)) {
      contacts_.push_back(event.step);
    }
  }
  follow();
}

std::int64_t ScrubActions::contactBeside(bool later) const {
  const RecordingPtr recording = runner_.recording();
  const FramePtr shown = runner_.shownFrame();
  if (recording == nullptr || recording->size() == 0 || shown == nullptr) {
    return -1;
  }
  // By recorded states: not every step need be one.
  const std::size_t here = recording->indexAt(shown->step);
  const auto isBefore = [&](std::int64_t step, std::size_t index) {
    return recording->indexAt(step) < index;
  };
  if (later) {
    const auto next = std::lower_bound(contacts_.begin(), contacts_.end(), here + 1, isBefore);
    return next == contacts_.end() ? -1 : *next;
  }
  const auto last = std::lower_bound(contacts_.begin(), contacts_.end(), here, isBefore);
  return last == contacts_.begin() ? -1 : *(last - 1);
}

void ScrubActions::goTo(bool later) {
  const std::int64_t step = contactBeside(later);
  if (step >= 0) {
    runner_.seek(step);
  }
}

/// A part around the moment that is shown; the timeline changes it.
void ScrubActions::switchLoop(bool on) {
  const FramePtr shown = runner_.shownFrame(), newest = runner_.newestFrame();
  if (!on || shown == nullptr || newest == nullptr || newest->time < kLeastLoop) {
    runner_.setLoop({});
    follow();
    return;
  }
  SimulationRunner::Part part;
  part.to = std::min(std::max(shown->time + kLoopReach, kLeastLoop), newest->time);
  part.from = std::max(std::min(shown->time, part.to) - kLoopReach, 0.0);
  runner_.setLoop(part);
}

void ScrubActions::follow() {
  const bool isRun = runner_.state() != SimulationRunner::State::Editing;
  previousContact->setEnabled(isRun && contactBeside(false) >= 0);
  nextContact->setEnabled(isRun && contactBeside(true) >= 0);
  loop->setEnabled(isRun);
  loop->setChecked(runner_.loop().has_value());
}

void ScrubActions::showSkins() {
  const FramePtr shown = runner_.shownFrame();
  const RecordingPtr recording = runner_.recording();
  std::vector<OnionLayer::Skin> skins;
  const bool isWanted =
      onionSkin->isChecked() && shown != nullptr && recording != nullptr && recording->size() > 0;
  if (!isWanted) {
    onion_->show({}, nullptr);
    return;
  }
  const double end = recording->timeOf(recording->size() - 1);
  for (int place = -OnionLayer::kSkins; place <= OnionLayer::kSkins; ++place) {
    const double time = shown->time + place * kSkinGap;
    if (place == 0 || time < 0.0 || time > end + 1e-9) {
      continue;
    }
    if (FramePtr frame = recording->frameIfKept(recording->indexAtTime(time + 1e-9))) {
      skins.push_back({std::move(frame), place});
    }
  }
  onion_->show(std::move(skins), recording->header());
}

}  // namespace editor
