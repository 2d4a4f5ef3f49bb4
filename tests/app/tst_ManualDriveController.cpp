#include <cmath>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapLegend.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/ScenarioPanel.h"
#include "tests/app/Hands.h"

using base::Vec2;

/// A robot driven by keys and by the mouse in a run in the whole window, step by step, so that no
/// clock counts. The robot of the café is of the general type: 1 m/s, 1 m/s², 1.5 rad/s, 3 rad/s².
class ManualDriveControllerTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  std::unique_ptr<Hands> hands_;

  app::Workspace& workspace() { return window_->workspace(); }
  editor::SimulationRunner& runner() { return workspace().runner(); }
  editor::EntityId robot() { return document().entities(base::EntityKind::Robot).front(); }
  QAction& toggle() { return *workspace().drive().toggle(); }
  QWindow* handle() { return window_->windowHandle(); }

  void step(int count) {
    for (int i = 0; i < count; ++i) {
      const auto before = runner().newestFrame();
      const std::int64_t wanted = before != nullptr ? before->step + 1 : 1;
      const auto isThere = [this, wanted] {
        return runner().newestFrame() != nullptr && runner().newestFrame()->step == wanted;
      };
      runner().stepOnce();
      QTRY_VERIFY_WITH_TIMEOUT(isThere(), 60000);
      QCoreApplication::processEvents();
    }
  }
  /// A run after its first step, with the robot selected.
  void begin() {
    document().setSelection({robot()});
    step(1);
    QCOMPARE(runner().newestFrame()->step, std::int64_t{1});
  }
  double speed() {
    const sim2d::RobotColumns& robots = runner().newestFrame()->robots;
    return std::hypot(robots.vx[0], robots.vy[0]);
  }
  Vec2 place() {
    const sim2d::RobotColumns& robots = runner().newestFrame()->robots;
    return {robots.x[0], robots.y[0]};
  }
  sim2d::StepInputs inputsOf(std::int64_t step) {
    sim2d::StepInputs inputs;
    const auto& all = runner().recording()->inputs();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].first == step) {
        inputs.push_back(all[i].second);
      }
    }
    return inputs;
  }
  QPoint inWindow(const Vec2& world) {
    editor::MapView& view = workspace().view();
    return view.viewport()->mapTo(window_.get(), view.viewportFrom(world));
  }
  void moveHeld(const Vec2& world) {
    editor::MapView& view = workspace().view();
    const QPoint at = view.viewportFrom(world);
    QMouseEvent event(QEvent::MouseMove, at, inWindow(world), view.viewport()->mapToGlobal(at),
                      Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(view.viewport(), &event);
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
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

  void toggle_withoutARunOrARobot_isOff() {
    QVERIFY(!toggle().isEnabled());
    begin();
    QVERIFY(toggle().isEnabled());
    document().setSelection({document().entities(base::EntityKind::Human).front()});
    QVERIFY(!toggle().isEnabled());
    document().setSelection({robot()});
    QVERIFY(toggle().isEnabled());
    runner().reset();
    QVERIFY(!toggle().isEnabled());
  }

  /// After k steps of 0.05 s at 1 m/s²: 0.05 k m/s; the same way back to nothing.
  void keyUp_held_drivesAndReleasedBrakes() {
    begin();
    hands_->press(Qt::Key_J);
    QVERIFY(toggle().isChecked());
    QTest::keyPress(handle(), Qt::Key_Up);
    const double before = speed();
    step(10);
    QVERIFY2(std::abs(speed() - before - 0.5) < 1e-6, qPrintable(QString::number(speed())));
    const sim2d::StepInputs held = inputsOf(11);
    QCOMPARE(held.size(), std::size_t{1});
    QCOMPARE(held[0].kind, sim2d::InputKind::Robot);
    QCOMPARE(held[0].id, -1);
    QCOMPARE(held[0].velocity.x(), 1.0);
    QCOMPARE(held[0].omega, 0.0);
    QTest::keyRelease(handle(), Qt::Key_Up);
    step(12);
    QVERIFY(speed() < 1e-9);
    QCOMPARE(inputsOf(23).at(0).velocity.x(), 0.0);
    hands_->press(Qt::Key_Escape);
    QVERIFY(!toggle().isChecked());
    step(4);
    QVERIFY(inputsOf(27).empty());
    QVERIFY(speed() > 0.1);  // its planner goes on
  }

  void letters_whileDriving_areNoCommands() {
    begin();
    hands_->press(Qt::Key_J);
    const bool snaps = workspace().scene().options().snapToPoints;
    QTest::keyPress(handle(), Qt::Key_S);
    QTest::keyPress(handle(), Qt::Key_A);
    step(1);
    QCOMPARE(workspace().scene().options().snapToPoints, snaps);
    QCOMPARE(inputsOf(2).at(0).velocity.x(), -1.0);
    QCOMPARE(inputsOf(2).at(0).omega, 1.5);
    QTest::keyRelease(handle(), Qt::Key_S);
    QTest::keyRelease(handle(), Qt::Key_A);
    hands_->press(Qt::Key_J);
    QVERIFY(!toggle().isChecked());
    hands_->press(Qt::Key_S);
    QCOMPARE(workspace().scene().options().snapToPoints, !snaps);
  }

  void text_typedWhileDriving_hasItsLetters() {
    begin();
    hands_->press(Qt::Key_J);
    QTest::keyPress(handle(), Qt::Key_W);
    auto* filter = window_->docks().panel<editor::ScenarioPanel>().findChild<QLineEdit*>();
    hands_->clickOn(*filter, filter->rect().center());
    QTest::keyClicks(filter, QStringLiteral("wasd"));
    QCOMPARE(filter->text(), QStringLiteral("wasd"));
    step(1);
    const sim2d::StepInputs inputs = inputsOf(2);  // who looks elsewhere does not drive on
    QVERIFY(inputs.empty() || inputs[0].velocity.x() == 0.0);
  }

  void drag_ofTheRobot_pullsItToThePointer() {
    begin();
    workspace().view().setFocus();
    const Vec2 from = place();
    const Vec2 to = from + Vec2(-3.0, 0.0);  // ahead
    QTest::mouseMove(handle(), inWindow(from));
    QTest::mousePress(handle(), Qt::LeftButton, {}, inWindow(from));
    moveHeld(from + Vec2(-1.0, 0.0));
    moveHeld(to);
    const auto& pull = workspace().scene().pull();
    QVERIFY(pull && pull->robot == -1 && (pull->to - to).norm() < 0.05);
    step(10);
    QCOMPARE(inputsOf(11).size(), std::size_t{1});
    QVERIFY(place().x() < from.x() - 0.1);
    QVERIFY(std::abs(place().y() - from.y()) < 0.05);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, inWindow(to));
    QVERIFY(!workspace().scene().pull());
    step(1);
    QVERIFY(inputsOf(12).empty());
  }

  void drag_ofAPerson_pullsNobody() {
    begin();
    const sim2d::HumanColumns& people = runner().newestFrame()->humans;
    const Vec2 at(people.x[0], people.y[0]);
    QTest::mouseMove(handle(), inWindow(at));
    QTest::mousePress(handle(), Qt::LeftButton, {}, inWindow(at));
    moveHeld(at + Vec2(1.0, 0.0));
    QVERIFY(!workspace().scene().pull());
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, inWindow(at + Vec2(1.0, 0.0)));
  }

  void teleop_untilItIsDriven_stands() {
    editor::pushChange<sim2d::Robot>(document(), robot(), QStringLiteral("Planner"),
                                     [](sim2d::Robot& each) { each.planner = "teleop"; });
    begin();
    step(5);
    QVERIFY(speed() < 1e-9);
    hands_->press(Qt::Key_J);
    QTest::keyPress(handle(), Qt::Key_Up);
    step(5);
    QVERIFY(std::abs(speed() - 0.25) < 1e-6);
    QTest::keyRelease(handle(), Qt::Key_Up);
    hands_->press(Qt::Key_J);
    step(30);  // the command grows old in 0.5 s, then the robot brakes
    QVERIFY2(speed() < 1e-9, qPrintable(QString::number(speed())));
  }

  /// The recorded inputs lead to the same states without a window.
  void recording_ofADrive_isRepeated() {
    begin();
    hands_->press(Qt::Key_J);
    QTest::keyPress(handle(), Qt::Key_Up);
    step(6);
    QTest::keyPress(handle(), Qt::Key_Left);
    step(6);
    QTest::keyRelease(handle(), Qt::Key_Up);
    QTest::keyRelease(handle(), Qt::Key_Left);
    step(3);
    hands_->press(Qt::Key_J);
    step(5);
    const auto made = editor::runRequestOf(document()).makeWorld();
    QVERIFY(bool(made));
    for (std::int64_t k = 1; k <= 21; ++k) {
      QVERIFY((*made)->step(inputsOf(k)));
      const sim2d::FramePtr shown = runner().recording()->frame(static_cast<std::size_t>(k));
      QCOMPARE(shown->step, k);
      QVERIFY((*made)->frame().robots == shown->robots);
      QVERIFY((*made)->frame().humans == shown->humans);
    }
  }

  /// With HUNAV_PICTURES, for people to look at: light and dark, editing and driven.
  void pictures_ofTheRobot_areTaken() {
    editor::pushChange<sim2d::Robot>(document(), robot(), QStringLiteral("Robot"),
                                     [](sim2d::Robot& each) {
                                       each.type = "nova_carter";
                                       each.planner = "dwa";
                                       each.plannerParameters = {{"horizon", "2.5"}};
                                     });
    document().setSelection({robot()});
    quiet::shoot(*window_, "robot-light");
    window_->setTheme(editor::Theme::dark());
    quiet::shoot(*window_, "robot-dark");
    for (QAction* layer : {window_->actions().detections, window_->actions().candidates}) {
      layer->setChecked(true);
    }
    step(20);
    toggle().setChecked(true);
    step(1);
    auto frame = std::make_shared<sim2d::Frame>(*runner().newestFrame());
    sim2d::RobotTelemetry senses = (*runner().newestFrame()->senses)[0];
    sim2d::RobotTelemetry::Scan scan;  // of a made up room, as no sensor is asked here
    scan.sensor = {{frame->robots.x[0], frame->robots.y[0]}, frame->robots.heading[0]};
    scan.angleMin = -base::kPi;
    scan.angleIncrement = base::kPi / 180.0;
    scan.range = 6.0;
    for (int i = 0; i < 360; ++i) {
      scan.distances.push_back(i % 90 < 50 ? 2.0 + 0.02 * (i % 90) : 6.0);
    }
    senses.scan = scan;
    senses.believed = {{frame->robots.x[0] - 0.6, frame->robots.y[0] + 0.5}, 2.6};
    frame->senses = std::make_shared<const std::vector<sim2d::RobotTelemetry>>(1, senses);
    workspace().scene().showFrame(frame);
    quiet::shoot(*window_, "driven-dark");
    window_->setTheme(editor::Theme::light());
    quiet::shoot(*window_, "driven-light");
    QVERIFY(toggle().isChecked());
    QVERIFY(!editor::senseRows(workspace().scene()).empty());
  }

  void recordedRun_isNotDriven() {
    begin();
    step(3);
    const editor::RecordingPtr recording = runner().recording();
    runner().reset();
    workspace().openRecorded(recording, QStringLiteral("run"));
    document().setSelection({robot()});
    QVERIFY(!toggle().isEnabled());
    QVERIFY(!workspace().scene().isPullable());
  }
};

QTEST_MAIN(ManualDriveControllerTest)
#include "tst_ManualDriveController.moc"
