#include "editor/panels/PeopleHands.h"

#include <utility>

#include "editor/canvas/FrameLayer.h"

namespace editor {

PeopleHands::PeopleHands(SimulationRunner& runner, MapScene& scene, QObject* parent)
    : QObject(parent), runner_(runner), scene_(scene) {
  connect(&scene_, &MapScene::pushed, this, &PeopleHands::push);
  connect(&runner_, &SimulationRunner::frameShown, this, [this] { waiting_.clear(); });
}

void PeopleHands::push(int person, const Vec2& velocity) {
  sim2d::Input input;
  input.kind = sim2d::InputKind::Push;
  input.id = person;
  input.velocity = velocity;
  runner_.give(std::move(input));
}

void PeopleHands::give(sim2d::InputKind kind, int person) {
  sim2d::Input input;
  input.kind = kind;
  input.id = person;
  runner_.give(std::move(input));
}

void PeopleHands::stop(int person) {
  give(sim2d::InputKind::Stop, person);
  waiting_[person] = true;
}

void PeopleHands::letGo(int person) {
  give(sim2d::InputKind::Resume, person);
  waiting_[person] = false;
}

bool PeopleHands::isStopped(int person) const {
  if (const auto waits = waiting_.find(person); waits != waiting_.end()) {
    return waits->second;
  }
  bool isStopped = false;
  const FramePtr shown = runner_.shownFrame();
  if (runner_.recording() == nullptr || shown == nullptr) {
    return false;
  }
  for (const auto& [step, input] : runner_.recording()->inputsUntil(shown->step)) {
    if (input.id == person && input.kind == sim2d::InputKind::Stop) {
      isStopped = true;
    } else if (input.id == person && input.kind == sim2d::InputKind::Resume) {
      isStopped = false;
    }
  }
  return isStopped;
}

void PeopleHands::dropIn(const std::string& like, const Vec2& place) {
  sim2d::Input input;
  input.kind = sim2d::InputKind::Add;
  input.name = like;
  input.pose.position = place;
  runner_.give(std::move(input));
}

void PeopleHands::addDropIn(QMenu& menu, std::optional<int> person, const Vec2& place) {
  const auto add = [&](QMenu& to, const QString& text, const std::string& like) {
    QAction* action = to.addAction(text, this, [this, like, place] { dropIn(like, place); });
    action->setToolTip(
        tr("Somebody with the same tree and goals comes in here, as an input of "
           "the run"));
  };
  if (person) {
    return;  // somebody stands there
  }
  QMenu* people = menu.addMenu(tr("Drop in a person like"));
  people->setToolTipsVisible(true);
  for (const sim2d::Human& human : scene_.document().scenario().humans) {
    if (human.listed) {
      add(*people, QString::fromStdString(human.name), human.name);
    }
  }
  people->setEnabled(!people->isEmpty());
}

void PeopleHands::fillMenu(QMenu& menu, std::optional<int> person, const Vec2& place) {
  menu.setToolTipsVisible(true);
  if (!runner_.isLive()) {
    return;
  }
  if (person && *person >= 0) {
    const QString name = scene_.frameLayer().nameOf(*person);
    QAction* push = menu.addAction(tr("Push %1…\tShift+drag").arg(name), this,
                                   [this, id = *person] { scene_.armPush(id); });
    push->setToolTip(tr("Then drag an arrow: a metre of it is a metre per second"));
    const bool stopped = isStopped(*person);
    QAction* stop = menu.addAction(
        stopped ? tr("Let %1 go on").arg(name) : tr("Stop %1").arg(name), this,
        [this, stopped, id = *person] { stopped ? letGo(id) : PeopleHands::stop(id); });
    stop->setToolTip(tr("They brake and stay until they are let go on"));
  }
  addDropIn(menu, person, place);
}

}  // namespace editor
