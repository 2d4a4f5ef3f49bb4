#include <cmath>

#include <QMenu>

#include "editor/canvas/FrameLayer.h"
#include "editor/look/HouseStyle.h"
#include "sim2d/trace/Recording.h"
#include "tests/app/Hands.h"

using base::Vec2;
using sim2d::InputKind;

/// People of a run pushed, stopped and dropped in by mouse and menu, step by step, so that no clock
/// counts.
class PeopleHandsTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  std::unique_ptr<Hands> hands_;

  app::Workspace& workspace() { return window_->workspace(); }
  editor::SimulationRunner& runner() { return workspace().runner(); }

  void step(int count) {
    for (int i = 0; i < count; ++i) {
      const auto before = runner().newestFrame();
      const std::int64_t wanted = before != nullptr ? before->step + 1 : 1;
      runner().stepOnce();
      QTRY_VERIFY_WITH_TIMEOUT(
          runner().newestFrame() != nullptr && runner().newestFrame()->step == wanted, 60000);
      QCoreApplication::processEvents();
    }
  }
  const sim2d::HumanColumns& people() { return runner().newestFrame()->humans; }
  Vec2 placeOf(std::size_t person) { return {people().x[person], people().y[person]}; }
  double speedOf(std::size_t person) {
    return std::hypot(people().vx[person], people().vy[person]);
  }
  sim2d::StepInputs inputsOf(std::int64_t step) {
    return sim2d::inputsOf(runner().recording()->inputsUntil(step), step);
  }
  QMenu* menuAt(const Vec2& world) {
    editor::MapView& view = workspace().view();
    const QPoint at = view.viewportFrom(world);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, view.viewport()->mapToGlobal(at));
    QCoreApplication::sendEvent(view.viewport(), &event);
    const QList<QMenu*> menus = view.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly);
    return menus.isEmpty() ? nullptr : menus.back();
  }
  /// By its first words, also in menus of the menu.
  static QAction* entryOf(const QMenu& menu, const QString& words) {
    for (QAction* action : menu.actions()) {
      if (action->text().startsWith(words)) {
        return action;
      }
      QAction* inner = action->menu() == nullptr ? nullptr : entryOf(*action->menu(), words);
      if (inner != nullptr) {
        return inner;
      }
    }
    return nullptr;
  }
  void choose(const Vec2& place, const QString& words) {
    QMenu* menu = menuAt(place);
    QVERIFY(menu != nullptr);
    QAction* action = entryOf(*menu, words);
    QVERIFY2(action != nullptr, qPrintable(words));
    action->trigger();
    menu->close();
    QTRY_VERIFY(menuAtRest());
  }
  bool menuAtRest() {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return workspace().view().findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly).isEmpty();
  }

 private Q_SLOTS:
  void initTestCase() { editor::dressApplication(editor::Theme::light()); }
  void init() {
    InFolder::begin();
    QVERIFY(window_->open(copyOfDemo()));
    hands_ = std::make_unique<Hands>(*window_);
  }
  void cleanup() {
    runner().reset();
    hands_.reset();
    end();
  }

  /// A metre of the arrow is a metre per second, in the step after it.
  void shiftDrag_fromAPerson_isAPush() {
    step(5);
    const Vec2 from = placeOf(0);
    hands_->dragMap(from, from + Vec2(0.0, 1.0), Qt::ShiftModifier);
    QVERIFY(!workspace().scene().push());
    step(1);
    const sim2d::StepInputs inputs = inputsOf(6);
    QCOMPARE(inputs.size(), std::size_t{1});
    QCOMPARE(inputs[0].kind, InputKind::Push);
    QCOMPARE(inputs[0].id, people().id[0]);
    QVERIFY(std::abs(inputs[0].velocity.x()) < 0.03 &&
            std::abs(inputs[0].velocity.y() - 1.0) < 0.03);  // to a pixel
    step(1);
    QVERIFY(inputsOf(7).empty());
  }

  void push_fromTheMenu_isDrawnFromAnywhere() {
    step(5);
    const int person = people().id[1];
    choose(placeOf(1), QStringLiteral("Push "));
    QCOMPARE(workspace().scene().armedPush(), std::optional<int>(person));
    const Vec2 ground = placeOf(1) + Vec2(0.3, 0.8);
    hands_->dragMap(ground, ground + Vec2(-8.0, 0.0));
    QVERIFY(!workspace().scene().armedPush());
    step(1);
    const sim2d::StepInputs inputs = inputsOf(6);
    QCOMPARE(inputs.size(), std::size_t{1});
    QCOMPARE(inputs[0].id, person);
    QVERIFY(std::abs(inputs[0].velocity.norm() - 4.0) < 1e-9);  // no longer arrow counts
    choose(placeOf(1), QStringLiteral("Push "));
    hands_->press(Qt::Key_Escape);
    QVERIFY(!workspace().scene().armedPush());
  }

  void stop_andGoOn_fromTheMenu() {
    step(20);
    const auto count = people().size();
    std::size_t walker = 0;
    for (std::size_t k = 0; k < count; ++k) {
      walker = speedOf(k) > speedOf(walker) ? k : walker;
    }
    QVERIFY(speedOf(walker) > 0.3);
    choose(placeOf(walker), QStringLiteral("Stop "));
    step(60);
    QVERIFY2(speedOf(walker) < 0.05, qPrintable(QString::number(speedOf(walker))));
    QCOMPARE(inputsOf(21).at(0).kind, InputKind::Stop);
    QVERIFY(workspace().hands().isStopped(people().id[walker]));
    choose(placeOf(walker), QStringLiteral("Let "));
    step(20);
    QCOMPARE(inputsOf(81).at(0).kind, InputKind::Resume);
    QVERIFY(speedOf(walker) > 0.2);
  }

  void dropIn_onTheGround_addsAPersonThere() {
    step(3);
    const std::size_t before = people().size();
    const Vec2 place(-1.0, -1.0);
    const QString like = QString::fromStdString(document().scenario().humans.front().name);
    choose(place, like);
    step(1);
    QCOMPARE(people().size(), before + 1);
    QCOMPARE(inputsOf(4).at(0).kind, InputKind::Add);
    const std::size_t last = people().size() - 1;
    QVERIFY2((placeOf(last) - place).norm() < 0.2,
             qPrintable(QString::number((placeOf(last) - place).norm())));
    QCOMPARE(people().id[last], inputsOf(4).at(0).id);
  }

  /// All of it once more: a branch from the end has the bytes of the run that it left.
  void everything_isRepeated() {
    step(5);
    const Vec2 from = placeOf(0);
    hands_->dragMap(from, from + Vec2(0.4, 1.2), Qt::ShiftModifier);
    step(5);
    choose(placeOf(1), QStringLiteral("Stop "));
    step(5);
    choose({-1.0, -1.0}, QString::fromStdString(document().scenario().humans.front().name));
    step(15);
    const editor::RecordingPtr first = runner().recording();
    const std::int64_t end = runner().newestFrame()->step;
    QCOMPARE(first->inputs().size(), std::size_t{3});
    runner().seek(end - 2);
    QVERIFY(runner().goOnFromShown());
    QTRY_VERIFY_WITH_TIMEOUT(
        runner().newestFrame() != nullptr && runner().newestFrame()->step == end - 2, 60000);
    step(2);
    const editor::RecordingPtr again = runner().recording();
    QVERIFY(again != first);
    const sim2d::Trace was = first->trace(), is = again->trace();
    QVERIFY(sim2d::trajectoryCsv(is) == sim2d::trajectoryCsv(was));
    QVERIFY(sim2d::eventsCsv(is) == sim2d::eventsCsv(was));
    QVERIFY(first->treesCsv() == again->treesCsv());
  }

  void menu_ofARunThatIsOver_offersNothing() {
    step(3);
    runner().seek(1);
    QVERIFY(menuAt({-1.0, -1.0}) == nullptr);
  }

  /// With HUNAV_PICTURES, for people to look at.
  void pictures_ofAPush_areTaken() {
    step(20);
    workspace().scene().setPush(editor::MapScene::Push{people().id[0], {1.2, 0.9}});
    quiet::shoot(*window_, "push_light");
    window_->setTheme(editor::Theme::dark());
    quiet::shoot(*window_, "push_dark");
    window_->setTheme(editor::Theme::light());
    workspace().scene().setPush({});
  }
};

QTEST_MAIN(PeopleHandsTest)
#include "tst_PeopleHands.moc"
