#include "editor/panels/PlaybackActions.h"

#include <cmath>
#include <limits>

#include "editor/look/Form.h"
#include "editor/look/Icons.h"

namespace editor {

namespace {

struct Speed {
  const char* text;
  double factor;
};
constexpr Speed kSpeeds[] = {{"0.25 ×", 0.25}, {"0.5 ×", 0.5},
                             {"1.0 ×", 1.0},   {"2.0 ×", 2.0},
                             {"4.0 ×", 4.0},   {"8.0 ×", 8.0},
                             {"16 ×", 16.0},   {"max", std::numeric_limits<double>::infinity()}};

QAction* makeAction(const QString& text, const QKeySequence& shortcut, const QString& says,
                    QObject* parent) {
  auto* action = new QAction(text, parent);
  action->setShortcut(shortcut);
  describe(*action, says);
  return action;
}

}  // namespace

QString clockText(double seconds) {
  const auto tenths = static_cast<long long>(std::floor(seconds * 10.0 + 1e-6));
  return QStringLiteral("%1:%2.%3")
      .arg(tenths / 600)
      .arg((tenths / 10) % 60, 2, 10, QLatin1Char('0'))
      .arg(tenths % 10);
}

PlaybackActions::PlaybackActions(SimulationRunner& runner, const Theme& theme, QObject* parent)
    : QObject(parent),
      runner_(runner),
      theme_(theme),
      reset_(makeAction(tr("Reset"), QKeySequence(Qt::CTRL | Qt::Key_R),
                        tr("End the run and go back to editing"), this)),
      stepBack_(makeAction(tr("Step back"), QKeySequence(Qt::Key_Comma),
                           tr("Look one recorded step back"), this)),
      playPause_(makeAction(tr("Play"), QKeySequence(Qt::CTRL | Qt::Key_Space),
                            tr("Run or pause the simulation; Space on the map does the same"),
                            this)),
      step_(makeAction(tr("Step"), QKeySequence(Qt::Key_Period), tr("One step forward, then pause"),
                       this)),
      newest_(makeAction(tr("Back to now"), QKeySequence(Qt::Key_End),
                         tr("Leave the past and show the newest step"), this)) {
  connect(reset_, &QAction::triggered, &runner_, &SimulationRunner::reset);
  connect(stepBack_, &QAction::triggered, &runner_, &SimulationRunner::stepBack);
  connect(step_, &QAction::triggered, &runner_, &SimulationRunner::stepOnce);
  connect(newest_, &QAction::triggered, &runner_, &SimulationRunner::seekNewest);
  connect(playPause_, &QAction::triggered, this, [this] {
    if (runner_.state() == SimulationRunner::State::Running) {
      runner_.pause();
    } else {
      runner_.play();
    }
  });
  connect(&runner_, &SimulationRunner::stateChanged, this, &PlaybackActions::follow);
  connect(&runner_, &SimulationRunner::lookingBackChanged, this, &PlaybackActions::follow);
  setTheme(theme);
}

void PlaybackActions::setTheme(const Theme& theme) {
  theme_ = theme;
  reset_->setIcon(themedIcon(QStringLiteral("run-reset"), theme));
  stepBack_->setIcon(themedIcon(QStringLiteral("run-step-back"), theme));
  step_->setIcon(themedIcon(QStringLiteral("run-step"), theme));
  follow();
}

void PlaybackActions::follow() {
  const auto state = runner_.state();
  const bool running = state == SimulationRunner::State::Running;
  const bool editing = state == SimulationRunner::State::Editing;
  playPause_->setText(running ? tr("Pause") : tr("Play"));
  describe(*playPause_, tr("Run or pause the simulation; Space on the map does the same"));
  playPause_->setCheckable(true);
  playPause_->setChecked(running);
  playPause_->setIcon(
      themedIcon(running ? QStringLiteral("run-pause") : QStringLiteral("run-play"), theme_));
  reset_->setEnabled(!editing);
  stepBack_->setEnabled(!editing);
  newest_->setEnabled(runner_.isLookingBack());
}

QComboBox* PlaybackActions::makeSpeedBox(QWidget* parent) {
  auto* box = new QComboBox(parent);
  for (const Speed& speed : kSpeeds) {
    box->addItem(QString::fromUtf8(speed.text), speed.factor);
  }
  box->setCurrentIndex(box->findText(QStringLiteral("1.0 ×")));
  box->setFixedWidth(76);
  box->setFocusPolicy(Qt::TabFocus);
  box->setToolTip(tr("Speed\nSimulated seconds per second of the clock"));
  box->setAccessibleName(tr("Speed"));
  connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this, box](int index) { runner_.setSpeed(box->itemData(index).toDouble()); });
  return box;
}

}  // namespace editor
