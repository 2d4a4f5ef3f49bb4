#include <cmath>

#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "tests/app/QuietWindow.h"

/// What is edited during a run counts after a click on Restart.
class RestartRunTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;
  editor::SimulationRunner& runner() { return window_->workspace().runner(); }

  /// Of the robot, in a run that goes on until then [m/s].
  double fastestUntil(double time) {
    runner().setSpeed(1e9);
    const bool isThere = QTest::qWaitFor(
        [&] { return runner().newestFrame() != nullptr && runner().newestFrame()->time >= time; },
        60000);
    runner().pause();
    const editor::RecordingPtr recording = runner().recording();
    double fastest = isThere ? 0.0 : -1.0;
    for (std::size_t k = 0; recording != nullptr && k < recording->size(); ++k) {
      const auto frame = recording->frame(k);
      if (frame->time <= time) {
        fastest = std::max(fastest, std::hypot(frame->robots.vx[0], frame->robots.vy[0]));
      }
    }
    return fastest;
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { window_ = quiet::shownWindow(); }
  void cleanup() { quiet::leave(window_); }

  void parameterOfNav2_isThatOfTheNextRun() {
    QVERIFY(window_->open(QStringLiteral(SOURCE_DIR "/maps/planners/crossing_agents.yaml")));
    editor::ScenarioDocument& document = window_->workspace().document();
    sim2d::Robot robot = document.scenario().robots.front();
    robot.planner = "nav2";
    robot.nav2Params = {SOURCE_DIR "/maps/planners/nav2_rpp.yaml"};
    robot.nav2Tree =
        SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
    editor::pushEdit(document, {robot}, QStringLiteral("Take Nav2"));
    document.setSelection({robot.key});
    auto* restart = window_->findChild<QToolButton*>(QStringLiteral("restart"));
    QVERIFY(restart != nullptr && !restart->isVisible());  // nothing runs
    runner().play();
    const double before = fastestUntil(3.0);
    QVERIFY2(before > 0.8, qPrintable(QString::number(before)));
    QTRY_VERIFY(restart->isVisible());
    robot.nav2Values = {{"FollowPath.desired_linear_vel", "0.3"}};
    editor::pushEdit(document, {robot}, QStringLiteral("Change"));
    QTest::mouseClick(restart, Qt::LeftButton);
    QTRY_VERIFY(runner().newestFrame() == nullptr || runner().newestFrame()->time < 3.0);
    const double after = fastestUntil(3.0);
    QVERIFY2(after > 0.2 && after < 0.31, qPrintable(QString::number(after)));
  }
};

QTEST_MAIN(RestartRunTest)
#include "tst_RestartRun.moc"
