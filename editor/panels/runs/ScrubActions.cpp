#include "editor/panels/runs/ScrubActions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "editor/look/Form.h"
#include "editor/look/Icons.h"

namespace editor {

namespace {

constexpr double kLoopReach = 2.5;  // Half length of a new loop around the shown time [s].
constexpr double kMinLoop = 0.2;    // [s]

}  // namespace

ScrubActions::ScrubActions(SimulationRunner& runner, RunEvents& events, MapScene& scene)
    : previousContact(makeAction(tr("&Previous contact"), QKeySequence(int{Qt::ALT} | Qt::Key_Left),
                                 tr("Show the previous contact"), this)),
      nextContact(makeAction(tr("Ne&xt contact"), QKeySequence(int{Qt::ALT} | Qt::Key_Right),
                             tr("Show the next contact"), this)),
      loop(makeAction(tr("Loop a section"), QKeySequence(int{Qt::CTRL} | Qt::Key_L),
                      tr("Repeat from A to B; drag the marks on the timeline, or Shift+drag a new "
                         "section"),
                      this)),
      onionSkin(makeAction(tr("&Onion skin"), QKeySequence(int{Qt::SHIFT} | Qt::Key_O),
                           tr("Positions of all people 1, 2 and 3 s before and after"), this)),
      runner_(runner),
      events_(events),
      scene_(scene) {
  auto onion = std::make_unique<OnionLayer>(scene_);
  onion_ = onion.get();
  scene_.addRunLayer(std::move(onion));
  loop->setCheckable(true);
  onionSkin->setCheckable(true);
  makeLengths();
  connect(previousContact, &QAction::triggered, this, [this] { goTo(false); });
  connect(nextContact, &QAction::triggered, this, [this] { goTo(true); });
  connect(loop, &QAction::triggered, this, &ScrubActions::setLoopEnabled);
  connect(onionSkin, &QAction::toggled, this, &ScrubActions::showOnionSkin);
  connect(&runner_, &SimulationRunner::loopChanged, this, &ScrubActions::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &ScrubActions::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, [this] {
    follow();
    showOnionSkin();
  });
  connect(&events_, &RunEvents::cleared, this, [this] {
    contacts_.clear();
    follow();
  });
  connect(&events_, &RunEvents::added, this, &ScrubActions::addContacts);
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
    describe(*action, tr("Set the time span of trails in a run"));
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
        scene_.showFrame(shown, runner_.recording().get());  // Reads past frames.
      }
    });
  }
}

void ScrubActions::addContacts(int first, int last) {
  for (int k = first; k <= last; ++k) {
    const RunEvent& event = events_.events()[static_cast<std::size_t>(k)];
    if (event.event.kind == sim2d::EventKind::Contact &&
        (contacts_.empty() || contacts_.back() != event.step)) {
      contacts_.push_back(event.step);
    }
  }
  follow();
}

std::int64_t ScrubActions::neighbouringContact(bool later) const {
  const RecordingPtr recording = runner_.recording();
  const FramePtr shown = runner_.shownFrame();
  if (recording == nullptr || recording->size() == 0 || shown == nullptr) {
    return -1;
  }
  // By recorded states, because not every step is recorded.
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
  const std::int64_t step = neighbouringContact(later);
  if (step >= 0) {
    runner_.seek(step);
  }
}

/// Loops a section around the shown time; the timeline can change it.
void ScrubActions::setLoopEnabled(bool on) {
  const FramePtr shown = runner_.shownFrame(), newest = runner_.newestFrame();
  if (!on || shown == nullptr || newest == nullptr || newest->time < kMinLoop) {
    runner_.setLoop({});
    follow();
    return;
  }
  SimulationRunner::LoopRange part;
  part.to = std::min(std::max(shown->time + kLoopReach, kMinLoop), newest->time);
  part.from = std::max(std::min(shown->time, part.to) - kLoopReach, 0.0);
  runner_.setLoop(part);
}

void ScrubActions::follow() {
  const bool isRun = runner_.state() != SimulationRunner::State::Editing;
  const QString noRun = tr("Start a run first: Space");
  setEnabled(*previousContact, isRun && neighbouringContact(false) >= 0,
             isRun ? tr("No contact before the displayed step") : noRun);
  setEnabled(*nextContact, isRun && neighbouringContact(true) >= 0,
             isRun ? tr("No contact after the displayed step") : noRun);
  setEnabled(*loop, isRun, noRun);
  loop->setChecked(runner_.loop().has_value());
}

void ScrubActions::showOnionSkin() {
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

namespace {

constexpr double kMarkTop = 20.0;     // Distance below the groove [px].
constexpr double kMarkHeight = 15.0;  // Height of a flag.
constexpr double kMarkWidth = 13.0;
constexpr double kShortest = 0.1;  // Minimum length of a loop [s].

}  // namespace

void LoopMarks::paint(QPainter& painter, const Theme& theme) const {
  const auto& loop = runner_.loop();
  if (!loop) {
    return;
  }
  const double a = scale_.xOf(loop->from), b = scale_.xOf(loop->to);
  painter.fillRect(QRectF(a, 9.0, b - a, 16.0), theme.color(Role::Accent, 0.16));
  painter.setFont(theme.font(8.0, QFont::DemiBold));
  for (const bool isFirst : {true, false}) {
    const double x = isFirst ? a : b;
    const double side = isFirst ? -1.0 : 1.0;  // Flags are outside of the loop.
    painter.setPen(QPen(theme.color(Role::Accent), 2.0));
    painter.drawLine(QPointF(x, 8.0), QPointF(x, kMarkTop + kMarkHeight));
    QRectF flag(x, kMarkTop, side * kMarkWidth, kMarkHeight);
    flag = flag.normalized();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.color(Role::Accent));
    painter.drawRoundedRect(flag, 2.0, 2.0);
    painter.setPen(theme.color(Role::Panel));
    painter.drawText(flag, Qt::AlignCenter, isFirst ? QStringLiteral("A") : QStringLiteral("B"));
  }
}

LoopMarks::Held LoopMarks::markAt(const QPointF& at) const {
  const auto& loop = runner_.loop();
  if (!loop || at.y() < kMarkTop) {
    return Held::Nothing;
  }
  constexpr double kReach = 4.0;
  const double a = scale_.xOf(loop->from), b = scale_.xOf(loop->to);
  if (at.x() >= a - kMarkWidth - kReach && at.x() <= a + kReach) {
    return Held::From;
  }
  return at.x() >= b - kReach && at.x() <= b + kMarkWidth + kReach ? Held::To : Held::Nothing;
}

bool LoopMarks::press(const QPointF& at, bool fresh) {
  held_ = fresh ? Held::To : markAt(at);
  if (held_ == Held::Nothing) {
    return false;
  }
  anchor_ = fresh                 ? scale_.timeAt(at.x())
            : held_ == Held::From ? runner_.loop()->to
                                  : runner_.loop()->from;
  return true;
}

bool LoopMarks::drag(double x) {
  if (held_ == Held::Nothing) {
    return false;
  }
  const double time = scale_.timeAt(x);
  const SimulationRunner::LoopRange part{std::min(time, anchor_), std::max(time, anchor_)};
  if (part.to - part.from >= kShortest) {
    runner_.setLoop(part);
  }
  return true;
}

}  // namespace editor
