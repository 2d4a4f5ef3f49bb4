#include <cmath>

#include "CanvasTester.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/runs/RunInteraction.h"
#include "sim2d/trace/Recording.h"

using sim2d::InputKind;

/// People of a run pushed by the mouse, stopped and dropped in from the menu, step by step, so that
/// no clock counts.
class PeopleInteractionTest : public QObject, private CanvasTester {
  Q_OBJECT

 private:
  std::unique_ptr<editor::SimulationRunner> runner_;
  std::unique_ptr<editor::PeopleInteraction> hands_;

  editor::SimulationRunner& runner() { return *runner_; }
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
  void pushBy(const Vec2& from, const Vec2& arrow) {
    press(from, Qt::ShiftModifier);
    move(from + 0.5 * arrow);
    move(from + arrow);
    QVERIFY(scene_.push());
    release(from + arrow, Qt::ShiftModifier);
  }
  void choose(std::optional<int> person, const Vec2& place, const QString& words) {
    QMenu menu;
    hands_->fillMenu(menu, person, place);
    QAction* action = entryOf(menu, words);
    QVERIFY2(action != nullptr, qPrintable(words));
    action->trigger();
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    start(small::scenario());
    runner_ = std::make_unique<editor::SimulationRunner>();
    runner_->setRequest([this] { return editor::runRequestOf(document_); });
    hands_ = std::make_unique<editor::PeopleInteraction>(*runner_, scene_);
    QObject::connect(runner_.get(), &editor::SimulationRunner::frameShown, &scene_,
                     [this](const editor::FramePtr& frame) {
                       scene_.showFrame(frame, runner_->recording().get());
                       scene_.setPullable(runner_->isLive());
                     });
  }
  void cleanup() {
    runner_->reset();
    hands_.reset();
    runner_.reset();
  }

  /// A metre of the arrow is a metre per second, in the step after it.
  void shiftDrag_fromAPerson_isAPush() {
    step(5);
    const Vec2 from = placeOf(0);
    pushBy(from, Vec2(0.0, 1.0));
    QVERIFY(!scene_.push());
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
    choose(people().id[1], placeOf(1), QStringLiteral("Push "));
    QCOMPARE(scene_.armedPush(), std::optional<int>(person));
    const Vec2 ground = placeOf(1) + Vec2(0.3, 0.8);
    drag(ground, ground + Vec2(-1.0, 4.5));
    QVERIFY(!scene_.armedPush());
    step(1);
    const sim2d::StepInputs inputs = inputsOf(6);
    QCOMPARE(inputs.size(), std::size_t{1});
    QCOMPARE(inputs[0].id, person);
    QVERIFY(std::abs(inputs[0].velocity.norm() - 4.0) < 1e-9);  // no longer arrow counts
    choose(people().id[1], placeOf(1), QStringLiteral("Push "));
    key(Qt::Key_Escape);
    QVERIFY(!scene_.armedPush());
  }

  void stop_andGoOn_fromTheMenu() {
    step(20);
    const auto count = people().size();
    std::size_t walker = 0;
    for (std::size_t k = 0; k < count; ++k) {
      walker = speedOf(k) > speedOf(walker) ? k : walker;
    }
    QVERIFY(speedOf(walker) > 0.3);
    choose(people().id[walker], placeOf(walker), QStringLiteral("Stop "));
    step(60);  // others may still press a little
    QVERIFY2(speedOf(walker) < 0.15, qPrintable(QString::number(speedOf(walker))));
    QCOMPARE(inputsOf(21).at(0).kind, InputKind::Stop);
    QVERIFY((*hands_).isStopped(people().id[walker]));
    choose(people().id[walker], placeOf(walker), QStringLiteral("Resume "));
    step(1);
    QCOMPARE(inputsOf(81).at(0).kind, InputKind::Resume);
    QVERIFY(!hands_->isStopped(people().id[walker]));
  }

  void dropIn_onTheGround_addsAPersonThere() {
    step(3);
    const std::size_t before = people().size();
    const Vec2 place(1.5, 4.5);
    choose({}, place, QStringLiteral("Ana"));
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
    pushBy(from, Vec2(0.4, 1.2));
    step(5);
    choose(people().id[1], placeOf(1), QStringLiteral("Stop "));
    step(5);
    choose({}, {1.5, 4.5}, QStringLiteral("Ana"));
    step(15);
    const editor::RecordingPtr first = runner().recording();
    const std::int64_t end = runner().newestFrame()->step;
    QCOMPARE(first->inputs().size(), std::size_t{3});
    runner().seek(end - 2);
    QVERIFY(runner().branchFromShown());
    QTRY_VERIFY_WITH_TIMEOUT(
        runner().newestFrame() != nullptr && runner().newestFrame()->step == end - 2, 60000);
    step(2);
    const editor::RecordingPtr again = runner().recording();
    QVERIFY(again != first);
    sim2d::Trace was = first->trace(), is = again->trace();
    for (sim2d::Trace* trace : {&was, &is}) {  // leaving the first one ended it
      while (!trace->events.empty() && trace->events.back().second.kind == sim2d::EventKind::Stop) {
        trace->events.pop_back();
      }
    }
    QVERIFY(sim2d::trajectoryCsv(is) == sim2d::trajectoryCsv(was));
    QVERIFY(sim2d::eventsCsv(is) == sim2d::eventsCsv(was));
    QVERIFY(first->treesCsv() == again->treesCsv());
  }

  void menu_ofThePast_offersNothing() {
    step(3);
    runner().seek(1);
    QMenu menu;
    hands_->fillMenu(menu, people().id[0], placeOf(0));
    QVERIFY(menu.isEmpty());
  }

  /// With HUNAV_PICTURES, for people to look at.
  void pictures_ofAPush_areTaken() {
    const QByteArray folder = qgetenv("HUNAV_PICTURES");
    step(20);
    for (const bool isDark : {false, true}) {
      scene_.setTheme(isDark ? editor::Theme::dark() : editor::Theme::light());
      scene_.setPush(editor::MapScene::Push{people().id[0], {1.2, 0.9}});
      QVERIFY(scene_.push());
      QCoreApplication::processEvents();
      const QString name = QString::fromUtf8(isDark ? "/push_dark.png" : "/push_light.png");
      QVERIFY(folder.isEmpty() || view_.grab().save(QString::fromLocal8Bit(folder) + name));
    }
  }
};

QTEST_MAIN(PeopleInteractionTest)
#include "tst_PeopleInteraction.moc"
